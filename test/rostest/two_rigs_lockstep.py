#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Two rigs in lockstep: a step of the first answers when the second has computed its frames too, and leaves none of them out."""
import threading

from drill_rig_sim.msg import RigState, WinchCommand
from rig_test import PATIENCE, Rig, run, unittest, winch


class TwoRigsLockstep(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.a, cls.b = Rig("rig_a"), Rig("rig_b")
        cls.states = cls.b.collect("rig_state", RigState)
        cls.a.advance(1)

    def stands_at(self):
        """Stamp of the last frame of the second rig, by a request of its own [ns]: messages may still be on their way."""
        return self.b.step(frames=0).state.header.stamp.to_nsec()

    def test_a_step_answers_when_the_follower_has_come_as_far(self):
        for frames in (1, 1, 7, 150, 1):
            stamp = self.a.advance(frames).header.stamp.to_nsec()
            self.assertEqual(stamp, self.stands_at())

    def test_the_follower_leaves_no_frame_out_of_a_long_step(self):
        self.a.advance(1)
        start = self.a.advance(1).header.stamp
        self.states.wait_until(lambda m: m and m[-1].header.stamp >= start)
        end = self.a.advance(2500).header.stamp  # more than a follower makes up for at once
        self.assertEqual(end.to_nsec(), self.stands_at())
        received = [m.header.stamp.to_nsec() for m in self.states.after(start, 2500)]
        self.assertEqual([start.to_nsec() + 10000000 * i for i in range(1, 2501)], received)

    def test_a_command_to_the_follower_acts_within_the_next_step(self):
        height = self.b.step(frames=0).state.block_height
        self.b.publisher("winch/command", WinchCommand).publish(winch(0.3))
        moved = False
        for _ in range(50):  # the command comes by a topic: some frame takes it
            self.a.advance(10)
            moved = moved or self.b.step(frames=0).state.block_height > height + 0.1
        self.assertTrue(moved)
        self.b.publisher("winch/command", WinchCommand).publish(winch(0.0, True))

    def test_pause_still_ends_a_step(self):
        answers = []
        stepping = threading.Thread(target=lambda: answers.append(self.a.step(frames=100000)))
        self.states.clear()
        stepping.start()
        self.states.wait(50)
        self.assertTrue(self.a.pause().success)
        stepping.join(PATIENCE)
        self.assertFalse(answers[0].success)
        self.assertIn("ended by pause", answers[0].message)
        stamp = self.a.advance(1).header.stamp.to_nsec()
        self.assertEqual(stamp, self.stands_at())


if __name__ == "__main__":
    run(TwoRigsLockstep)
