#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""A rotary steerable tool as a controller sees it: by command on the topic and in a step, and by a downlink of the pump's flow."""
import math

from drill_rig_sim.msg import SteeringCommand
from rig_test import Rig, flow, run, unittest

BIT_TIME = 6.0  # of the scene [s]
HIGH, LOW = 0.03, 0.021  # [m3/s]


def downlink(toolface, ratio):
    """The bits, 1: the flow is lowered; include/drill_rig_sim/instruments/downlink.h."""
    data = (round(toolface / math.radians(22.5)) % 16) << 4 | round(10.0 * ratio)
    return [1] + [data >> k & 1 for k in range(7, -1, -1)] + [bin(data).count("1") % 2, 0]


class Steering(unittest.TestCase):
    def setUp(self):
        self.rig = Rig()
        self.assertTrue(self.rig.reset_well("", 0.0).success)

    def seconds(self, time, **commands):
        return self.rig.advance_truth(round(100 * time), **commands)

    def test_a_command_is_obeyed(self):
        state = self.rig.advance_truth(1, steering=SteeringCommand(toolface=1.5, ratio=0.6))
        self.assertEqual((1.5, 0.6), (state.steering.toolface, state.steering.ratio))
        self.assertEqual(0.0, self.rig.advance_truth(1).steering.header.stamp.to_sec() - state.steering.header.stamp.to_sec())
        self.assertTrue(state.magnetic_steering, "the hole is vertical")

    def test_a_ratio_beyond_one_is_clamped(self):
        state = self.rig.advance_truth(1, steering=SteeringCommand(toolface=0.0, ratio=2.0))
        self.assertTrue(state.command_clamped)
        self.assertEqual(1.0, state.steering.ratio)

    def test_a_downlink_is_obeyed(self):
        self.seconds(20.0, mud_pump=flow(HIGH))
        for bit in downlink(math.radians(135.0), 0.8):
            self.seconds(BIT_TIME, mud_pump=flow(LOW if bit else HIGH))
        state = self.seconds(5.0, mud_pump=flow(HIGH))
        self.assertAlmostEqual(math.radians(135.0), state.steering.toolface, 9)
        self.assertAlmostEqual(0.8, state.steering.ratio, 9)


if __name__ == "__main__":
    run(Steering)
