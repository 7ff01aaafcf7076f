#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The modes of the top drive as a controller sees them: an angle that is held, rocking, speed by a drive that gives way to the string."""
import math

from drill_rig_sim.msg import TopDriveCommand
from rig_test import Rig, run, unittest


class DriveModes(unittest.TestCase):
    def setUp(self):
        self.rig = Rig()
        self.assertTrue(self.rig.reset_well("", 0.0).success)

    def test_an_angle_is_held_by_the_brake(self):
        for angle in (5.0, -2.0):
            turns = self.rig.advance(1, top_drive=TopDriveCommand(mode=TopDriveCommand.ANGLE, angle=angle))
            self.assertFalse(turns.top_drive_brake_set)
            self.rig.advance(2500)
            for _ in range(100):
                state = self.rig.advance(1)
                self.assertTrue(state.top_drive_brake_set)
                self.assertAlmostEqual(angle, state.top_drive_angle, delta=math.radians(0.5))
            self.assertEqual(TopDriveCommand.ANGLE, state.top_drive.mode)
            self.assertEqual(angle, state.top_drive.angle)

    def test_rocks_about_its_middle(self):
        command = TopDriveCommand(mode=TopDriveCommand.OSCILLATE, angle=2.0, amplitude_right=1.0, amplitude_left=0.5, speed=1.0)
        state = self.rig.advance(1000, top_drive=command)
        self.assertEqual((1.0, 0.5), (state.top_drive.amplitude_right, state.top_drive.amplitude_left))
        angles = [self.rig.advance(1).top_drive_angle for _ in range(1000)]
        self.assertAlmostEqual(3.0, max(angles), delta=0.1)
        self.assertAlmostEqual(1.5, min(angles), delta=0.1)

    def test_each_keeps_its_speed(self):
        for mode in (TopDriveCommand.Z_TORQUE, TopDriveCommand.SPEED, TopDriveCommand.SOFT_TORQUE):
            state = self.rig.advance(6000, top_drive=TopDriveCommand(mode=mode, speed=5.0))
            self.assertEqual(mode, state.top_drive.mode)
            self.assertAlmostEqual(5.0, state.top_drive_speed, delta=0.1)


if __name__ == "__main__":
    run(DriveModes)
