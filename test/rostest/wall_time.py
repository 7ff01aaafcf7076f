#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Without /clock and without simulated time stamps are wall time."""
import rosgraph
from drill_rig_sim.msg import RigState
from rig_test import Rig, rospy, run, time, unittest


class WallTime(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.rig = Rig()

    def test_stamps_are_near_the_wall_clock_and_keep_pace_with_it(self):
        states = self.rig.collect("rig_state", RigState)
        stamps = [m.header.stamp for m in states.wait(200)]
        self.assertAlmostEqual(time.time(), stamps[-1].to_sec(), delta=5.0)
        self.assertEqual({10000000}, {(b - a).to_nsec() for a, b in zip(stamps, stamps[1:])})

    def test_nobody_publishes_a_clock(self):
        self.assertNotIn("/clock", dict(rosgraph.Master(rospy.get_name()).getSystemState()[0]))

    def test_no_other_speed_than_the_walls(self):
        self.assertFalse(self.rig.set_speed(2.0).success)
        self.assertFalse(self.rig.set_speed(0.0).success)
        self.assertTrue(self.rig.set_speed(1.0).success)


if __name__ == "__main__":
    run(WallTime)
