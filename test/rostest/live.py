#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""drill live beside a rig that sends WITS: it follows the block, its residuals are topics, and Ctrl-C ends it with their table."""
import os
import signal
import subprocess
import tempfile

from rig_test import PACKAGE_DIR, PATIENCE, Rig, rospy, run, runner, unittest, wait_until, winch
from std_msgs.msg import Float64

SIGNALS = ("hook_load", "torque", "stand_pipe_pressure", "bit_depth")
SCENE = os.path.join(PACKAGE_DIR, "config/scenes/quick.yaml")


class Live(unittest.TestCase):
    def setUp(self):
        self.rig = Rig()
        self.residuals = {name: [] for name in SIGNALS}  # they come from a node that is started later
        for name, values in self.residuals.items():
            rospy.Subscriber("/live/residual/" + name, Float64, lambda message, values=values: values.append(message.data), queue_size=1000)
        self.port = wait_until(lambda: rospy.get_param("/rig/wits0_server/port", 0), "the server listens")
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.csv = os.path.join(folder.name, "live.csv")
        self.log = os.path.join(folder.name, "live.log")

    def rows(self):
        """Of the CSV file, without its header."""
        if not os.path.exists(self.csv):
            return 0
        with open(self.csv, encoding="utf-8") as file:
            return max(file.read().count("\n") - 1, 0)

    def test_a_block_that_moves(self):
        with open(self.log, "w", encoding="utf-8") as log:
            command = [runner(self), "live", "127.0.0.1:%d" % self.port, SCENE, "--start", "record", "--topics", "/live", "--csv", self.csv]
            live = subprocess.Popen(command, stdout=log, stderr=subprocess.STDOUT)
            self.addCleanup(live.kill)

            def begun():
                self.rig.advance(100)
                return self.rows() > 0 or live.poll() is not None
            wait_until(begun, "the first rows are played")
            before = self.rows()
            for velocity, seconds in ((0.05, 20), (0.0, 5), (-0.05, 20), (0.0, 10)):
                for second in range(seconds):
                    self.rig.advance(100, winch=winch(velocity) if second == 0 else None)
            wait_until(lambda: self.rows() >= before + 45 or live.poll() is not None, "these rows are played too")
            live.send_signal(signal.SIGINT)
            status = live.wait(PATIENCE)
        with open(self.log, encoding="utf-8") as log:
            said = log.read()
        self.assertEqual(0, status, said)
        self.assertRegex(said, r"(?m)^bit depth +-?[\d.]+ +[\d.]+ +[\d.]+ +\d+ m$")
        for name, most in (("hook_load", 5e3), ("bit_depth", 0.1)):
            wait_until(lambda values=self.residuals[name]: len(values) >= 45, "residuals of %s" % name)
            off = self.residuals[name]
            self.assertLess((sum(number**2 for number in off) / len(off))**0.5, most, name)


run(Live)
