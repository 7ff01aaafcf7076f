#!/usr/bin/env python3
"""What rviz shows with config/rviz/rig.rviz, opened by hand: string, wellbore and bit are to be seen. Under a virtual X server.
The screenshot stays in the build folder as rviz_seen.png; with UPDATE_README=1 it also becomes the front page's picture."""
import os
import shutil

from rig_test import PACKAGE_DIR, Rig, run, unittest
from rviz_window import FOLDER, Window

WIDTH, HEIGHT = 1280, 900
VIEW = (20, 66, 826, 866)  # of the window, where rviz draws: left, top, right, bottom
BACKGROUND = (30, 32, 38)  # as in rig.rviz
README_PICTURE = os.path.join(PACKAGE_DIR, "test", "accuracy", "pictures", "rviz.png")


def is_string(r, g, b):
    """Lime through yellow to orange, saturated, seen through the hole's wall; an axis is pure red or green."""
    return max(r, g) > 85 and b < 0.35 * max(r, g) and r > 0.3 * g and g > 0.2 * r


def is_bit(r, g, b):
    """Blue with half as much green, shaded."""
    return b > 90 and b > 1.5 * g and g > 2 * r and g > 30


def is_wellbore(r, g, b):
    """Tan seen through on the dark background."""
    return 45 < r < 160 and r > 1.1 * g and g > 1.1 * b and b > 0.4 * r


def differs_from_background(r, g, b):
    return max(abs(r - BACKGROUND[0]), abs(g - BACKGROUND[1]), abs(b - BACKGROUND[2])) > 8


class Rviz(unittest.TestCase):
    def setUp(self):
        Rig()
        self.window = Window(self, "rviz", "rig.rviz", WIDTH, HEIGHT, VIEW)

    def test_string_wellbore_and_bit_are_to_be_seen(self):
        self.window.wait_until(
            lambda picture: {"string": picture.count(is_string), "bit": picture.count(is_bit), "wellbore": picture.count(is_wellbore),
                             "drawn": picture.count(differs_from_background) / len(picture.pixels)},
            lambda seen: seen["string"] > 300 and seen["bit"] > 20 and seen["wellbore"] > 1000 and seen["drawn"] > 0.02)
        if os.environ.get("UPDATE_README") == "1":
            shutil.copy(os.path.join(FOLDER, "rviz_seen.png"), README_PICTURE)


if __name__ == "__main__":
    run(Rviz)
