#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What is done at the surface reaches the bit as waves: signs, travel times and wind-up in a vertical frictionless hole."""
import math

from geometry_msgs.msg import TwistStamped
from rig_test import Rig, run, turn, unittest, winch

# vertical_frictionless.yaml: 1010 m of 5 in pipe, 31.9 kg/m with its tool joints
LENGTH = 1010.0
AREA = math.pi / 4 * (0.127**2 - 0.1086**2)
POLAR = math.pi / 32 * (0.127**4 - 0.1086**4)
AXIAL_SPEED = math.sqrt(206e9 * AREA / 31.9)
SHEAR_SPEED = math.sqrt(206e9 / 2.6 / 7850.0)  # the fastest that torsion can be: pipe without tool joints
FRAME = 0.005


def crossing(times, values, level):
    """When the values first reach the level, linear between samples."""
    for i in range(1, len(values)):
        if values[i] >= level:
            share = (level - values[i - 1]) / (values[i] - values[i - 1])
            return times[i - 1] + share * (times[i] - times[i - 1])
    return math.inf


class Waves(unittest.TestCase):
    def setUp(self):
        self.rig = Rig()
        self.assertTrue(self.rig.reset_well("", 0.0).success)
        self.twists = self.rig.collect("bit/twist", TwistStamped)
        self.still = self.rig.advance(1)

    def record(self, frames, **commands):
        """Times, rig states and bit twists of this number of frames; the commands come with the first."""
        states = []
        for i in range(frames):
            states.append(self.rig.advance(1, **(commands if i == 0 else {})))
        twists = self.twists.after(self.still.header.stamp, frames)
        self.assertEqual([s.header.stamp for s in states], [t.header.stamp for t in twists])
        return [FRAME * (i + 1) for i in range(frames)], states, [t.twist for t in twists]

    def test_hoisting_raises_and_lowering_reduces_the_hook_load(self):
        up = [self.rig.advance(10, winch=winch(0.3)).hook_load for _ in range(20)]
        self.assertGreater(max(up), 1.01 * self.still.hook_load)
        self.assertTrue(self.rig.reset_well("", 0.0).success)
        down = [self.rig.advance(10, winch=winch(-0.3)).hook_load for _ in range(20)]
        self.assertLess(min(down), 0.99 * self.still.hook_load)

    def test_the_bit_follows_the_block_after_the_axial_waves_travel_time(self):
        times, states, twists = self.record(100, winch=winch(0.5))
        block = [s.block_velocity for s in states]
        bit = [t.linear.z for t in twists]
        # a free end doubles the velocity; before the echo comes back from above it is the block's, twice, one travel later
        travel = crossing(times, bit, 0.06) - crossing(times, block, 0.03)
        self.assertAlmostEqual(LENGTH / AXIAL_SPEED, travel, delta=0.05 * LENGTH / AXIAL_SPEED)
        # nothing arrives before
        early = [abs(v) for t, v in zip(times, bit) if t < 0.8 * LENGTH / AXIAL_SPEED]
        self.assertLess(max(early), 1e-3)

    def test_torque_winds_the_string_up_before_the_bit_turns(self):
        times, states, twists = self.record(200, top_drive=turn(2.0))
        arrival = LENGTH / SHEAR_SPEED
        before = [i for i, t in enumerate(times) if t < 0.8 * arrival]
        self.assertLess(max(abs(twists[i].angular.z) for i in before), 0.01)
        self.assertGreater(states[before[-1]].top_drive_angle, 0.02)
        self.assertGreater(states[before[-1]].torque, 500.0)
        # then it turns, clockwise looking downhole: negative about the upward axis
        self.assertLess(min(t.angular.z for t in twists), -1.0)


if __name__ == "__main__":
    run(Waves)
