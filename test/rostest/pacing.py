#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Time in the hands of its services: pause, resume, set_speed; what a newcomer sees while it stands."""
import math
import subprocess
import sys

from drill_rig_sim.msg import DrillstringState, RigDescription, RigState, RigTruth
from nav_msgs.msg import Path
from rig_test import PATIENCE, Rig, rospy, run, time, unittest
from rosgraph_msgs.msg import Clock
from tf2_msgs.msg import TFMessage
from visualization_msgs.msg import MarkerArray

# another node, for subscribers of one node share a connection: says the stamp of what it hears first
NEWCOMER = """
import rospy
from drill_rig_sim.msg import DrillstringState
rospy.init_node("newcomer", anonymous=True, disable_rostime=True)
print(rospy.wait_for_message("/rig/drillstring_state", DrillstringState, %g).header.stamp.to_nsec())
""" % PATIENCE


class Pacing(unittest.TestCase):
    def setUp(self):
        self.rig = Rig()
        self.assertTrue(self.rig.resume().success)
        self.assertTrue(self.rig.set_speed(1.0).success)
        self.clock = self.rig.collect("/clock", Clock)  # of each test: after a free run a subscriber has thousands of old messages to read
        self.addCleanup(self.clock.subscriber.unregister)

    def speed(self, wall):
        """Simulated seconds per wall second."""
        self.clock.clear()
        first = self.clock.wait(1)[0].clock
        started = time.monotonic()
        time.sleep(wall)
        last = self.clock.messages[-1].clock
        return (last - first).to_sec() / (time.monotonic() - started)

    def test_real_time_is_kept(self):
        self.assertAlmostEqual(1.0, self.speed(2.0), delta=0.1)

    def test_half_and_double_speed(self):
        self.assertTrue(self.rig.set_speed(0.5).success)
        self.assertAlmostEqual(0.5, self.speed(2.0), delta=0.08)
        self.assertTrue(self.rig.set_speed(2.0).success)
        self.assertAlmostEqual(2.0, self.speed(2.0), delta=0.3)

    def test_as_fast_as_it_goes(self):
        self.assertTrue(self.rig.set_speed(0.0).success)
        self.assertGreater(self.speed(2.0), 3.0)

    def test_speeds_that_are_none(self):
        for speed in (-1.0, math.nan, math.inf):
            self.assertFalse(self.rig.set_speed(speed).success)
        self.assertAlmostEqual(1.0, self.speed(2.0), delta=0.1)

    def test_time_stands_while_paused_and_goes_on_without_a_jump(self):
        self.assertTrue(self.rig.pause().success)
        self.clock.quiet()
        time.sleep(1.0)
        self.assertEqual([], self.clock.messages)
        self.assertTrue(self.rig.resume().success)
        stamps = [m.clock.to_nsec() for m in self.clock.wait(5)]
        self.assertTrue(all(b - a <= 20000000 for a, b in zip(stamps, stamps[1:])))

    def test_pause_and_resume_are_said_once_with_the_last_stamp(self):
        topics = [self.rig.collect(name, kind) for name, kind in (("rig_state", RigState), ("truth/rig_state", RigTruth))]
        for topic in topics:
            topic.wait(5)
        self.assertTrue(self.rig.pause().success)
        for topic in topics:
            self.addCleanup(topic.subscriber.unregister)
            messages = topic.wait_until(lambda m: m[-1].run_state == RigState.PAUSED)
            self.assertEqual([RigState.RUNNING] * (len(messages) - 1) + [RigState.PAUSED], [m.run_state for m in messages])
            self.assertEqual(messages[-2].header.stamp, messages[-1].header.stamp)
        self.assertTrue(self.rig.pause().success)
        self.assertTrue(self.rig.resume().success)
        for topic in topics:
            messages = topic.wait_until(lambda m: m[-1].run_state == RigState.RUNNING and m[-1].header.stamp > m[0].header.stamp + rospy.Duration(1))
            said = [m for m in messages if m.run_state == RigState.PAUSED]
            self.assertEqual(1, len(said))
            after = messages[messages.index(said[0]) + 1:]
            self.assertEqual(said[0].header.stamp, after[0].header.stamp)
            self.assertEqual(1, sum(m.header.stamp == after[0].header.stamp for m in after))

    def test_a_newcomer_sees_frames_and_markers_while_paused_and_nothing_repeats(self):
        self.assertTrue(self.rig.pause().success)
        time.sleep(1.0)
        frames, markers = self.rig.collect("/tf", TFMessage), self.rig.collect("markers", MarkerArray)
        self.assertGreater(len(frames.wait(1)[0].transforms), 3)
        names = {m.ns for m in markers.wait(1)[0].markers}
        self.assertTrue({"string", "bit", "wellbore", "stations"} <= names, names)
        time.sleep(1.0)
        self.assertEqual(1, len(markers.messages))
        self.assertEqual(1, len(frames.messages))

    def test_a_newcomer_sees_the_string_while_paused_and_it_alone(self):
        self.assertTrue(self.rig.pause().success)
        self.clock.quiet()
        strings = self.rig.collect("drillstring_state", DrillstringState)
        self.addCleanup(strings.subscriber.unregister)
        present = strings.wait(1)[0]
        self.rig.must(self.rig.save_state("standing", ""))
        self.assertEqual(self.rig.list_states().stamps[0], present.header.stamp)
        for name, kind in (("rig_description", RigDescription), ("trajectory", Path)):
            self.assertEqual(1, len(self.rig.collect(name, kind).wait(1)), name)
        second = subprocess.run([sys.executable, "-c", NEWCOMER], stdout=subprocess.PIPE, text=True, timeout=2 * PATIENCE, check=True)
        self.assertEqual(present.header.stamp.to_nsec(), int(second.stdout))
        time.sleep(1.0)
        self.assertEqual([present.header.stamp], [m.header.stamp for m in strings.messages])
        self.rig.must(self.rig.restore_state("standing", ""))
        restored = strings.wait(2)[1]
        self.assertGreater(restored.header.stamp, present.header.stamp)
        self.assertEqual(present.tension, restored.tension)

    def test_a_pause_shows_the_string_as_it_stands(self):
        strings, states = self.rig.collect("drillstring_state", DrillstringState), self.rig.collect("rig_state", RigState)
        for topic in (strings, states):
            self.addCleanup(topic.subscriber.unregister)
            topic.wait(3)
        self.assertTrue(self.rig.pause().success)
        stands = states.wait_until(lambda m: m[-1].run_state == RigState.PAUSED)[-1].header.stamp
        self.assertEqual(stands, strings.wait_until(lambda m: m[-1].header.stamp >= stands)[-1].header.stamp)

    def test_reset_while_paused_stays_paused_and_the_stamp_grows(self):
        self.assertTrue(self.rig.pause().success)
        states = self.rig.collect("rig_state", RigState)
        states.quiet()  # what was said before it stood may be on its way
        self.assertTrue(self.rig.reset_well("", 0.0).success)
        first = states.wait(1)[-1]
        time.sleep(0.5)
        self.assertTrue(self.rig.reset_well("", 0.0).success)
        second = states.wait(2)[-1]
        self.assertGreater(second.header.stamp, first.header.stamp)
        time.sleep(0.5)
        self.assertEqual(2, len(states.messages))

    def test_step_belongs_to_lockstep(self):
        self.assertFalse(self.rig.step(frames=1).success)


if __name__ == "__main__":
    run(Pacing)
