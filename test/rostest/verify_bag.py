#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""A run of the node, recorded in a bag: `drill verify` plays it again by its set points, and refuses it where a service has changed the rig."""
import json
import os
import subprocess
import tempfile

import rosbag
from drill_rig_sim.msg import RigDescription
from drill_rig_sim.rig import Rig
from rig_test import PATIENCE, rospy, run, runner, unittest
from std_msgs.msg import String

SECONDS = 6.0


class VerifyBag(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.rig = Rig("rig")

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.file = os.path.join(folder.name, "run.bag")
        self.rig.reset(bit_depth=99.98)

    def record(self, at_half_time=lambda rig: None):
        """Turns, goes down in two steps and drills; a bag as rosbag record would make it. The hook loads."""
        states = [self.rig.state.truth]
        self.rig.rotate(rpm=60)
        self.rig.winch(-0.01)
        states += [s.truth for s in self.rig.frames(0.5 * SECONDS)]
        at_half_time(self.rig)
        self.rig.winch(-0.02)
        states += [s.truth for s in self.rig.frames(0.5 * SECONDS)]
        with rosbag.Bag(self.file, "w") as bag:
            for name, kind in (("scene", String), ("rig_description", RigDescription)):
                bag.write("/rig/" + name, rospy.wait_for_message("/rig/" + name, kind, PATIENCE), states[0].header.stamp)
            for state in states:
                bag.write("/rig/truth/rig_state", state, state.header.stamp)
        return [state.hook_load for state in states[1:]]

    def verify(self):
        done = subprocess.run([runner(self), "verify", self.file, "--times", "1.2", "--json", self.file + ".json"], capture_output=True, text=True, check=False)
        return done.returncode, done.stderr

    def test_its_set_points_are_played_again(self):
        loads = self.record()
        status, told = self.verify()
        self.assertIn(status, (0, 1), told)
        with open(self.file + ".json", encoding="utf-8") as text:
            found = json.load(text)
        self.assertAlmostEqual(SECONDS, found["simulated_s"], places=6)
        self.assertAlmostEqual(1.0, found["outputs"]["hook_load"]["mean"] * len(loads) / sum(loads), places=12)

    def test_what_a_service_did_is_not_in_it(self):
        self.record(lambda rig: rig.fault("STUCK_PIPE", depth=50.0))
        status, told = self.verify()
        self.assertEqual(2, status)
        self.assertIn("cannot be replayed: at ", told)


if __name__ == "__main__":
    run(VerifyBag)
