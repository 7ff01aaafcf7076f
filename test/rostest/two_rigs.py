#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Two rigs side by side: one clock, own topics and frames, and the second follows the first's time."""
import rosgraph
from drill_rig_sim.msg import RigState, WinchCommand
from rig_test import Rig, rospy, run, time, unittest, winch
from tf2_msgs.msg import TFMessage


class TwoRigs(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.a, cls.b = Rig("rig_a"), Rig("rig_b")

    def test_one_clock_and_both_have_its_stamps(self):
        publishers = dict(rosgraph.Master(rospy.get_name()).getSystemState()[0])["/clock"]
        self.assertEqual(["/rig_a/rig_simulator"], publishers)
        first, second = self.a.collect("rig_state", RigState), self.b.collect("rig_state", RigState)
        second.wait(200)
        stamps = {m.header.stamp.to_nsec() for m in first.messages}
        followed = [m.header.stamp.to_nsec() for m in second.messages]
        self.assertEqual({10000000}, {q - p for p, q in zip(followed, followed[1:])})
        self.assertGreater(len(stamps.intersection(followed)), 0.8 * len(followed))

    def test_the_follower_has_no_time_of_its_own(self):
        for answer in (self.b.pause(), self.b.step(frames=1), self.b.set_speed(2.0)):
            self.assertFalse(answer.success)
            self.assertNotEqual("", answer.message)

    def test_pausing_the_first_holds_both(self):
        states = self.b.collect("rig_state", RigState)
        self.assertTrue(self.a.pause().success)
        states.quiet()  # until it has caught up with the clock
        time.sleep(1.0)
        self.assertEqual([], states.messages)
        self.assertTrue(self.a.resume().success)
        self.assertTrue(states.wait(10))

    def test_a_command_moves_its_own_rig(self):
        height = self.a.state().block_height
        self.b.publisher("winch/command", WinchCommand).publish(winch(0.3))
        states = self.b.collect("rig_state", RigState)
        moved = states.wait_until(lambda m: m and m[-1].block_height > height + 0.1)
        self.assertGreater(moved[-1].block_height, height + 0.1)
        self.assertAlmostEqual(height, self.a.state().block_height, places=3)

    def test_frames_carry_their_rigs_prefix_and_meet_in_the_world(self):
        static = self.a.collect("/tf_static", TFMessage)
        moving = self.a.collect("/tf", TFMessage)
        static.wait(2)
        moving.wait_until(lambda m: {t.header.frame_id for x in m for t in x.transforms} >= {"rig_a/rig_floor", "rig_b/rig_floor"})
        floors = {t.child_frame_id: t for m in static.messages for t in m.transforms}
        self.assertEqual({"rig_a/rig_floor", "rig_b/rig_floor"}, set(floors))
        self.assertEqual({"world"}, {t.header.frame_id for t in floors.values()})
        self.assertEqual(40.0, floors["rig_b/rig_floor"].transform.translation.x)
        for message in moving.messages:
            for t in message.transforms:
                self.assertEqual(t.header.frame_id.split("/")[0], t.child_frame_id.split("/")[0])


if __name__ == "__main__":
    run(TwoRigs)
