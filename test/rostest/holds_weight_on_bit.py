#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The front page's first controllers hold their weight on bit and drill as fast as the rock allows; after a reset in the middle of that they do so again,
and put no more on the bit than before."""
from drill_rig_sim.msg import BitTruth, RigTruth
from drill_rig_sim.srv import ResetWell, SetSpeed
from rig_test import Collector, rospy, run, unittest

WEIGHT = 10e3  # what launch/autodriller.py asks for [N]
ROP = 1.3e-7 * 9.4 * WEIGHT  # of quick.yaml's rock: drillability, bit speed, weight [m/s]
SETTLING, SECONDS = 15.0, 15.0  # after the tag, then averaged [simulated s]
PATIENCE = 150.0  # [wall s]


class HoldsWeightOnBit(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rospy.wait_for_service("/rig/set_speed", 60)
        assert rospy.ServiceProxy("/rig/set_speed", SetSpeed)(3.0).success
        cls.states, cls.bits = Collector("/rig/truth/rig_state", RigTruth), Collector("/rig/truth/bit", BitTruth)

    def drilled(self, epoch):
        """The states of the run with this number from the tag on, as long as they are wanted."""
        def of_run(states):
            states = [state for state in states if state.epoch == epoch]
            first = next((i for i, state in enumerate(states) if state.on_bottom), len(states))
            return states[first:]

        def enough(states):
            if not states or states[-1].epoch != epoch or not states[-1].on_bottom:
                return False
            drilling = of_run(states)
            return (drilling[-1].header.stamp - drilling[0].header.stamp).to_sec() > SETTLING + SECONDS
        drilling = of_run(self.states.wait_until(enough, PATIENCE))
        self.assertTrue(drilling, "the bit did not drill")
        self.assertGreater((drilling[-1].header.stamp - drilling[0].header.stamp).to_sec(), SETTLING + SECONDS)
        return drilling

    def holds(self, states):
        start = states[0].header.stamp.to_sec() + SETTLING
        settled = [state for state in states if state.header.stamp.to_sec() > start]
        self.assertTrue(all(state.tared and state.on_bottom for state in settled))
        weight = sum(state.surface_wob for state in settled) / len(settled)
        rop = (settled[-1].hole_depth - settled[0].hole_depth) / (settled[-1].header.stamp - settled[0].header.stamp).to_sec()
        print("weight on bit %.1f N, rate of penetration %.5f m/s (%.5f by the rock)" % (weight, rop, ROP))
        self.assertAlmostEqual(weight / WEIGHT, 1.0, delta=0.02)
        self.assertAlmostEqual(rop / ROP, 1.0, delta=0.03)  # the winch's feed, the bit's speed and the weight all swing a little

    def test_weight_and_rate_of_penetration_also_after_a_reset(self):
        self.holds(self.drilled(0))
        first = max(bit.wob for bit in self.bits.messages)
        self.bits.clear()
        self.assertTrue(rospy.ServiceProxy("/rig/reset_well", ResetWell)().success)
        self.holds(self.drilled(1))
        self.assertLess(max(bit.wob for bit in self.bits.messages), 1.2 * first + 1e3)


if __name__ == "__main__":
    run(HoldsWeightOnBit)
