#!/usr/bin/env python3
"""A wrong parameter stops the node at start with one line that names it, its value and what is allowed."""
import os
import subprocess

import roslib.packages
from rig_test import PACKAGE_DIR, PATIENCE, run, unittest


def start(*settings):
    """Exit status and what is said on stderr."""
    node = roslib.packages.find_node("drill_rig_sim", "rig_simulator")[0]
    command = [node, "__name:=wrong_" + str(abs(hash(settings)))] + ["_" + s for s in settings]
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, timeout=PATIENCE)
    return done.returncode, done.stderr


class Parameters(unittest.TestCase):
    def refused(self, setting, *words):
        status, said = start("scene:=quick.yaml", setting)
        self.assertEqual(2, status, said)
        self.assertEqual(1, said.count("\n"), said)
        for word in (setting.split(":=")[0],) + words:
            self.assertIn(word, said)

    def test_out_of_range(self):
        self.refused("rate:=-1", "-1", "from 0.1 to 10000")
        self.refused("state_rate:=1000", "1000", "~rate")
        self.refused("tf_rate:=0", "0")
        self.refused("trajectory_rate:=5", "5")
        self.refused("command_timeout:=-0.5", "-0.5", ">= 0")
        self.refused("lateral_exaggeration:=0.1", "0.1")

    def test_not_a_number(self):
        self.refused("rate:=fast", "fast", "number")
        self.refused("rate:=.nan")
        self.refused("seed:=many", "many", "whole number")
        self.refused("rig_pose:=[1,2]", "six")

    def test_unknown_words(self):
        self.refused("clock:=sometimes", "sometimes", "realtime, lockstep, free_run")
        self.refused("color_by:=mood", "mood", "contact_force")
        self.refused("play_program:=perhaps", "perhaps", "true or false")

    def test_a_misspelt_name(self):
        self.refused("rat:=100", "unknown", "rate")

    def test_a_frame_is_a_whole_number_of_steps(self):
        self.refused("rate:=130", "130", "step")

    def test_scenes_that_are_not_there_or_broken(self):
        status, said = start("scene:=no_such.yaml")
        self.assertEqual(2, status)
        self.assertIn("no_such.yaml", said)
        status, said = start("scene:=" + os.path.join(PACKAGE_DIR, "test", "bad_scenes", "nan.yaml"))
        self.assertEqual(2, status)
        self.assertIn("nan.yaml:", said)

    def test_without_its_own_clock_it_cannot_run_free(self):
        status, said = start("scene:=quick.yaml", "publish_clock:=false", "clock:=free_run")
        self.assertEqual(2, status, said)
        self.assertIn("publish_clock", said)


if __name__ == "__main__":
    run(Parameters)
