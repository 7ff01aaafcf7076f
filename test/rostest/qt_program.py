# SPDX-License-Identifier: BSD-3-Clause
"""Programs of gtest that open windows, under a virtual X server of their own."""
import os
import subprocess

import roslib.packages
from rig_test import needs

# where ROS_HOME is build/ros_home; elsewhere it is the user's own choice
FOLDER = os.path.dirname(os.environ.get("ROS_HOME", os.path.expanduser("~/.ros/x")))


def find(name):
    found = roslib.packages.find_node("drill_rig_sim", name)
    return found[0] if found else None


def environment_of(case, *programs):
    """For windows drawn in software. Skips the case where a program is missing."""
    needs(case, "xvfb-run", *programs)
    environment = dict(os.environ, LIBGL_ALWAYS_SOFTWARE="1", RIG_SIMULATOR=find("rig_simulator"))
    for name in ("DISPLAY", "ROS_NAMESPACE"):
        environment.pop(name, None)
    return environment


def what_failed(output):
    """Of what a program of gtest printed: its failed tests whole, and its last lines, which tell of a crash."""
    tests = output.split("[ RUN      ]")
    return "\n".join([t for t in tests[1:] if "[  FAILED  ]" in t] + tests[-1].splitlines()[-20:])


def must_pass(case, name, environment, longest, *words):
    """All of a program's tests pass, within this number of wall seconds."""
    program = find(name)
    case.assertIsNotNone(program, name + " is not built")
    done = subprocess.run(["xvfb-run", "-a", "-s", "-screen 0 1920x1080x24", program] + list(words), env=environment, timeout=longest, check=False,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    case.assertEqual(0, done.returncode, what_failed(done.stdout))
