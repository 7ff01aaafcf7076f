#!/usr/bin/env python3
"""A first test of a controller: frame by frame, the same to the last bit however busy the machine is."""
import unittest

import rospy
import rostest
from drill_rig_sim.msg import TopDriveCommand, WinchCommand
from drill_rig_sim.srv import ResetWell, StepSimulation
from std_srvs.srv import Trigger


class HoldsWeight(unittest.TestCase):
    def drill(self):
        """Weight on bit [N] in each frame of 40 s under the controller."""
        reset()
        lower = WinchCommand(block_velocity=-0.01)
        state = step(frames=300, winch=[lower], top_drive=[TopDriveCommand(mode=TopDriveCommand.SPEED, speed=9.4)]).state
        tare()  # on the way down, as it drills: at rest the block's rail carries another share
        speed, weights = 0.01, []
        for _ in range(4000):
            speed = min(max(speed + 5e-9 * (10e3 - state.surface_wob), 0.0), 0.015)
            state = step(frames=1, winch=[WinchCommand(block_velocity=-speed)]).state
            weights.append(state.surface_wob)
        return weights

    def test_weight_is_held_and_the_run_repeats(self):
        weights = self.drill()
        self.assertAlmostEqual(10e3, sum(weights[-500:]) / 500, delta=200.0)
        self.assertEqual(weights, self.drill())


def service(name, kind):
    rospy.wait_for_service(name)
    return rospy.ServiceProxy(name, kind, persistent=True)


rospy.init_node("first_lockstep_test")
reset, tare, step = service("reset_well", ResetWell), service("tare", Trigger), service("step", StepSimulation)
rostest.rosrun("drill_rig_sim", "first_lockstep_test", HoldsWeight)
