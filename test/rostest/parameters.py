#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""A wrong parameter stops the node at start with one line that names it, its value and what is allowed."""
import os
import re
import subprocess
import tempfile
from xml.etree import ElementTree

import roslib.packages
from rig_test import PACKAGE_DIR, PATIENCE, needs, run, unittest


def start(*settings):
    """Exit status and what is said on stderr."""
    node = roslib.packages.find_node("drill_rig_sim", "rig_simulator")[0]
    command = [node, "__name:=wrong_" + str(abs(hash(settings)))] + ["_" + s for s in settings]
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, timeout=PATIENCE)
    return done.returncode, done.stderr


class Parameters(unittest.TestCase):
    def refused(self, setting, *words, scene="quick.yaml"):
        status, said = start("scene:=" + scene, setting)
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

    def test_each_range_ends_where_it_says(self):
        """Just outside is refused; with all at their ends something that is read later is complained of instead."""
        ranges = {"rate": (0.1, 0.0625, 10000, 10001), "drillstring_rate": (0.01, 0.0078125, 10000, 100.5),
                  "state_rate": (0.01, 0.0078125, 10000, 100.5), "tf_rate": (0.01, 0.0078125, 1000, 1001),
                  "marker_rate": (0.01, 0.0078125, 1000, 1001), "trajectory_rate": (0.01, 0.0078125, 1, 1.25),
                  "command_timeout": (0, -0.5, 1e9, None), "seed": (0, -1, 9e15, None),
                  "lateral_exaggeration": (1, 0.75, 10000, 10001), "force_scale": (0, -0.5, 1000, 1001)}
        for name, (_, below, _, above) in ranges.items():
            for value in (below, above):
                if value is not None:
                    self.refused("%s:=%s" % (name, value), "~%s is %s;" % (name, value))
        for end in (0, 2):
            status, said = start("scene:=quick.yaml", "color_by:=mood", *("%s:=%s" % (name, r[end]) for name, r in ranges.items()))
            self.assertEqual(2, status)
            self.assertIn("~color_by is \"mood\"", said)

    def test_not_a_number(self):
        self.refused("rate:=fast", "fast", "number")
        self.refused("rate:=.nan")
        self.refused("seed:=many", "many", "whole number")
        self.refused("seed:=1.5", "1.5", "whole number")
        self.refused("rig_pose:=[1,2]", "~rig_pose is ", "six")
        self.refused("rig_pose:=[0,0,0,0,0,x]", "~rig_pose is ", "six")

    def test_priorities_and_cores(self):
        self.refused("realtime/fifo_priority:=99", "~realtime/fifo_priority is 99", "0 to 98")
        self.refused("realtime/fifo_priority:=1.5", "1.5", "whole number")
        self.refused("realtime/core:=-2", "~realtime/core is -2", "-1 = any")
        self.refused("realtime/core:=4000", "~realtime/core", "a core that this process may run on")
        self.refused("realtime/lock_memory:=maybe", "maybe", "true or false")

    def test_unknown_words(self):
        self.refused("clock:=sometimes", "sometimes", "realtime, lockstep, free_run")
        self.refused("color_by:=mood", "mood", "contact_force")
        self.refused("play_program:=perhaps", "perhaps", "true or false")
        self.refused("step_on_commands:=brake", '"brake"', "winch, top_drive, mud_pump and steering")
        self.refused("step_on_commands:=winch", "only with ~clock lockstep")

    def test_a_frame_prefix_that_tf2_takes(self):
        for wrong in ("/a", "a b/"):
            self.refused("frame_prefix:=" + wrong, '"%s"' % wrong, "does not begin with /")

    def test_a_misspelt_name(self):
        self.refused("rat:=100", "unknown", "rate")

    def test_the_launch_file_has_every_parameter_with_its_meaning(self):
        _, said = start("scene:=quick.yaml", "bogus:=1")
        there_are = set(said.split("allowed are ")[1].strip().split(", "))
        root = ElementTree.parse(os.path.join(PACKAGE_DIR, "launch", "rig.launch")).getroot()
        node = next(n for n in root.iter("node") if n.get("type") == "rig_simulator")
        given = {p.get("name") for p in node.iter("param")} | {p.get("param") for p in node.iter("rosparam")}
        self.assertEqual(there_are, given)
        documented = {a.get("name") for a in root.findall("arg") if a.get("doc")}
        self.assertEqual(set(), {name.split("/")[-1] for name in given} - documented)
        self.assertEqual(len(root.findall("arg")), len(documented))

    def test_rviz_shows_the_rig_of_its_own_namespace(self):
        needs(self, "rviz")
        launch = os.path.join(PACKAGE_DIR, "launch", "rig.launch")
        done = subprocess.run(["roslaunch", "--args", "/rig_b/rviz", launch, "ns:=rig_b", "rviz:=true"], stdout=subprocess.PIPE,
                              text=True, timeout=PATIENCE, check=True)
        topics = ["/rig/rig_description"]  # which the display hears beside the string
        for name in ("rig", "markers"):
            with open(os.path.join(PACKAGE_DIR, "config", "rviz", name + ".rviz")) as file:
                topics += re.findall(r"^ +(?:Marker )?Topic: (/\S+)$", file.read(), re.MULTILINE)
        self.assertEqual({"/rig/" + name for name in ("drillstring_state", "rig_description", "markers", "trajectory")}, set(topics))
        for topic in topics:
            self.assertIn(" %s:=%s " % (topic, topic.replace("/rig/", "")), done.stdout)

    def test_a_frame_is_a_whole_number_of_fixed_steps(self):
        self.refused("rate:=130", "130", "step", scene=os.path.join(PACKAGE_DIR, "test", "operations", "scenes", "hard_layer_then_pick_up.yaml"))

    def test_scenes_that_are_not_there_or_broken(self):
        status, said = start("scene:=no_such.yaml")
        self.assertEqual(2, status)
        self.assertIn("no_such.yaml", said)
        status, said = start("scene:=" + os.path.join(PACKAGE_DIR, "test", "bad_scenes", "nan.yaml"))
        self.assertEqual(2, status)
        self.assertIn("nan.yaml:", said)

    def test_settings_of_the_scene(self):
        status, said = start("scene:=quick.yaml", "settings:=numerics.companion=none; well.hole_depth=-5")
        self.assertEqual(2, status)
        self.assertIn("setting: well.hole_depth: ", said)
        self.assertNotIn("companion", said)
        self.assertIn("setting: numerics.companion: has no value, needed: KEY=VALUE", start("scene:=quick.yaml", "settings:=numerics.companion")[1])

    def test_a_scene_is_a_regular_file(self):
        with tempfile.TemporaryDirectory() as folder:
            pipe = os.path.join(folder, "pipe.yaml")
            os.mkfifo(pipe)
            for name in (pipe, folder, "/dev/zero"):
                status, said = start("scene:=" + name)
                self.assertEqual(2, status, said)
                self.assertIn("regular file", said)

    def test_without_its_own_clock_it_cannot_run_free(self):
        status, said = start("scene:=quick.yaml", "publish_clock:=false", "clock:=free_run")
        self.assertEqual(2, status, said)
        self.assertIn("publish_clock", said)


if __name__ == "__main__":
    run(Parameters)
