#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""A first test of a controller: frame by frame, the same to the last bit however busy the machine is."""
import unittest

import rostest
from drill_rig_sim.rig import Rig, series


class HoldsWeight(unittest.TestCase):
    def test_weight_is_held(self):
        rig = Rig("rig")
        rig.rotate(rpm=90)
        rig.winch(-0.01)
        rig.step(3.0)
        speed, state, states = 0.01, rig.tare(), []  # on the way down, as it drills: at rest the block's rail carries another share
        for _ in range(4000):
            speed = min(max(speed + 5e-9 * (10e3 - state.surface_wob), 0.0), 0.015)
            rig.winch(-speed)
            state = rig.step()
            states.append(state)
        self.assertAlmostEqual(10e3, series(states, "bit.wob")[-500:].mean(), delta=200.0)
        self.assertGreater(state.truth.hole_depth, 100.2)


rostest.rosrun("drill_rig_sim", "first_lockstep_test", HoldsWeight)
