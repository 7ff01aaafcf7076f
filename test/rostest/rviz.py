#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What rviz shows with the configs of config/rviz, opened by hand while a rig drills: rig.rviz the string in its well beside the driller's console,
markers.rviz the markers. Under a virtual X server. The screenshots stay in the build folder as rviz_*seen.png; with UPDATE_README=1 that of rig.rviz also
becomes the front page's picture."""
import os
import shutil

from drill_rig_sim.msg import RigTruth
from rig_test import PACKAGE_DIR, PATIENCE, Rig, rospy, run, time, unittest, wait_until
from rviz_window import FOLDER, Window
from string_picture import all_seen, is_writing, measured

WIDTH, HEIGHT = 1280, 800
VIEW = (20, 66, 590, 766)       # of the window, where rviz draws the string: left, top, right, bottom; the legend is to its right
CONSOLE = (852, 66, 1280, 770)
MARKERS = (370, 66, 1260, 760)  # beside the list of displays
BACKGROUND = (30, 32, 38)       # as in markers.rviz
TARED = 20.0    # the bit goes to bottom from 30 to 50 [simulated s]
DRILLS = 110.0  # it has done so for a minute
SURVEY = 40.0   # the MWD's period and latency, and more
SETTLED = 8.0   # until the console no longer says that it was faster [wall s]
SPEED = 20.0    # where nothing is looked at [simulated s per s]
SLOWER = 4.0    # until the zero is set
README_PICTURE = os.path.join(PACKAGE_DIR, "test", "accuracy", "pictures", "rviz.png")


def is_marked_string(r, g, b):
    """Teal through green to yellow, seen through the hole's brown wall; an axis is pure red, green or blue."""
    coloured = max(r, g, b) > 85 and max(r, g, b) - min(r, g, b) > 30
    return coloured and (g > r and 0.2 * g < b < 1.1 * g or r > g > 0.7 * r and b < 0.4 * g)


def is_marked_bit(r, g, b):
    """Blue with half as much green, shaded."""
    return b > 90 and b > 1.5 * g and g > 2 * r and g > 30


def is_wellbore(r, g, b):
    """Tan seen through on the dark background."""
    return 45 < r < 160 and r > 1.1 * g and g > 1.1 * b and b > 0.4 * r


def differs_from_background(r, g, b):
    return max(abs(r - BACKGROUND[0]), abs(g - BACKGROUND[1]), abs(b - BACKGROUND[2])) > 8


def is_bar(r, g, b):
    """A gauge's bar, of a value within its limits."""
    return max(abs(r - 0x4c), abs(g - 0xaf), abs(b - 0x7a)) < 4


class Rviz(unittest.TestCase):
    def setUp(self):
        rig = Rig()
        rig.must(rig.set_speed(SLOWER))  # on a loaded machine the look at the time comes seconds late
        self.wait_for_time(rig, TARED)
        if self.truth(rig).tared == 0:
            rig.must(rig.tare())
        rig.must(rig.set_speed(SPEED))
        self.wait_for_time(rig, DRILLS)
        rig.must(rig.set_speed(1.0))

    @staticmethod
    def truth(rig):
        return rospy.wait_for_message(rig.topic("truth/rig_state"), RigTruth, PATIENCE)

    def wait_for_time(self, rig, simulated):
        wait_until(lambda: self.truth(rig).header.stamp.to_sec() >= simulated, "the rig is at %g s" % simulated, 4 * PATIENCE)

    def test_string_and_console_are_to_be_seen(self):
        rig = Rig()
        window = Window(self, "rviz", "rig.rviz", WIDTH, HEIGHT, VIEW)
        window.wait_until(measured, all_seen)
        rig.must(rig.set_speed(SPEED))  # until a survey has come up
        self.wait_for_time(rig, self.truth(rig).header.stamp.to_sec() + SURVEY)
        rig.must(rig.set_speed(1.0))
        time.sleep(SETTLED)
        window.view = CONSOLE
        window.wait_until(lambda picture: {"writing": picture.count(is_writing), "bars": picture.count(is_bar)},
                          lambda seen: seen["writing"] > 3000 and seen["bars"] > 3000)
        if os.environ.get("UPDATE_README") == "1":
            shutil.copy(os.path.join(FOLDER, "rviz_seen.png"), README_PICTURE)

    def test_markers_are_to_be_seen(self):
        window = Window(self, "rviz_markers", "markers.rviz", WIDTH, HEIGHT, MARKERS)
        window.wait_until(
            lambda picture: {"string": picture.count(is_marked_string), "bit": picture.count(is_marked_bit), "wellbore": picture.count(is_wellbore),
                             "drawn": picture.count(differs_from_background) / len(picture.pixels)},
            lambda seen: seen["string"] > 300 and seen["bit"] > 20 and seen["wellbore"] > 1000 and seen["drawn"] > 0.02)


if __name__ == "__main__":
    run(Rviz)
