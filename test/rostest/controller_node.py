#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""launch/autodriller.launch by topics: the law that test/laws/test_autodriller.py tries in lockstep keeps the weight as a node of its own too."""
import threading
import unittest

import rospy
import rostest
from drill_rig_sim.msg import BitTruth, ControllerStatus
from drill_rig_sim.srv import SetSpeed

WEIGHT = 60e3        # what the launch file asks for [N]
SETTLING, SECONDS = 40.0, 30.0  # after the tag, then averaged [simulated s]


class ControllerNode(unittest.TestCase):
    def test_weight_is_held(self):
        weights, tag, done = [], [], threading.Event()

        def take(bit):
            now = bit.header.stamp.to_sec()
            if bit.wob > 0.0 and not tag:
                tag.append(now)
            if tag and now > tag[0] + SETTLING:
                weights.append(bit.wob)
            if tag and now > tag[0] + SETTLING + SECONDS:
                done.set()
        rospy.wait_for_service("/rig/set_speed", 60)
        self.assertTrue(rospy.ServiceProxy("/rig/set_speed", SetSpeed)(8.0).success)
        statuses = []
        rospy.Subscriber("/rig/controller/status", ControllerStatus, statuses.append, queue_size=None)
        rospy.Subscriber("/rig/truth/bit", BitTruth, take, queue_size=None)
        self.assertTrue(done.wait(250), "the bit did not drill for %g s" % (SETTLING + SECONDS))
        self.assertAlmostEqual(1.0, sum(weights) / len(weights) / WEIGHT, delta=0.05)
        self.assertEqual({"autodriller"}, {status.law for status in statuses})
        self.assertTrue(all(status.running and status.given_up == "" for status in statuses))
        phases = [status.phase for status in statuses]
        self.assertEqual(["spinning up", "zeroing", "tagging", "drilling"], sorted(set(phases), key=phases.index))
        last = statuses[-1]
        self.assertEqual("weight", last.leads)
        self.assertEqual(WEIGHT, dict(zip(last.set_point, last.value))["weight"])
        self.assertEqual("rig_floor", last.header.frame_id)


if __name__ == "__main__":
    rospy.init_node("test_controller_node")
    rostest.rosrun("drill_rig_sim", "controller_node", ControllerNode)
