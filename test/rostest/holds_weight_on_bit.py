#!/usr/bin/env python3
"""The front page's first controller holds its weight on bit and drills as fast as the rock allows."""
import threading
import unittest

import rospy
import rostest
from drill_rig_sim.msg import RigTruth
from drill_rig_sim.srv import SetSpeed

WEIGHT = 10e3  # what launch/autodriller.py asks for [N]
ROP = 1.3e-7 * 9.4 * WEIGHT  # of quick.yaml's rock: drillability, bit speed, weight [m/s]
SETTLING, SECONDS = 15.0, 15.0  # after the tag, then averaged [simulated s]


class HoldsWeightOnBit(unittest.TestCase):
    def test_weight_and_rate_of_penetration(self):
        states, done = [], threading.Event()

        def take(state):
            if done.is_set() or not (states or state.on_bottom):
                return
            states.append(state)
            if (state.header.stamp - states[0].header.stamp).to_sec() > SETTLING + SECONDS:
                done.set()
        rospy.wait_for_service('/rig/set_speed', 60)
        self.assertTrue(rospy.ServiceProxy('/rig/set_speed', SetSpeed)(3.0).success)
        rospy.Subscriber('/rig/truth/rig_state', RigTruth, take, queue_size=None)
        self.assertTrue(done.wait(150), 'the bit did not drill for %g s' % (SETTLING + SECONDS))

        start = states[0].header.stamp.to_sec() + SETTLING
        settled = [state for state in states if state.header.stamp.to_sec() > start]
        self.assertTrue(all(state.tared and state.on_bottom for state in settled))
        weight = sum(state.surface_wob for state in settled) / len(settled)
        rop = (settled[-1].hole_depth - settled[0].hole_depth) / (settled[-1].header.stamp - settled[0].header.stamp).to_sec()
        print("on bottom %.3f of the time" % (sum(state.on_bottom for state in settled) / len(settled)))
        print("weight on bit %.1f N, rate of penetration %.5f m/s (%.5f by the rock)" % (weight, rop, ROP))
        self.assertAlmostEqual(weight / WEIGHT, 1.0, delta=0.02)
        self.assertAlmostEqual(rop / ROP, 1.0, delta=0.03)  # the winch's feed, the bit's speed and the weight all swing a little


if __name__ == '__main__':
    rospy.init_node('test_holds_weight_on_bit')
    rostest.rosrun('drill_rig_sim', 'holds_weight_on_bit', HoldsWeightOnBit)
