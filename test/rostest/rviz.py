#!/usr/bin/env python3
"""What rviz shows with config/rviz/rig.rviz, opened by hand: string, wellbore and bit are to be seen. Under a virtual X server.
The screenshot stays in the build folder as rviz.png; with UPDATE_README=1 it also becomes the front page's picture."""
import os
import shutil
import subprocess

from rig_test import PACKAGE_DIR, PATIENCE, Rig, run, time, unittest

WIDTH, HEIGHT = 1280, 900
VIEW = (20, 66, 826, 866)  # of the window, where rviz draws: left, top, right, bottom
BACKGROUND = (30, 32, 38)  # as in rig.rviz
# where ROS_HOME is build/ros_home; elsewhere it is the user's own choice
FOLDER = os.path.dirname(os.environ.get("ROS_HOME", os.path.expanduser("~/.ros/x")))

README_PICTURE = os.path.join(PACKAGE_DIR, "test", "accuracy", "pictures", "rviz.png")

# inside xvfb-run: rviz, and a picture every other second
SCRIPT = """
rviz -d "$1/config/rviz/rig.rviz" >"$2/rviz.log" 2>&1 &
rviz=$!
trap 'kill $rviz' TERM
while kill -0 $rviz 2>/dev/null; do
  sleep 2
  import -window root "$2/rviz_new.png" && convert "$2/rviz_new.png" -depth 8 "ppm:$2/rviz_new.ppm" &&
    mv "$2/rviz_new.png" "$2/rviz.png" && mv "$2/rviz_new.ppm" "$2/rviz.ppm"
done
"""


def is_string(r, g, b):
    """Lime through yellow to orange, saturated, seen through the hole's wall; an axis is pure red or green."""
    return max(r, g) > 85 and b < 0.35 * max(r, g) and r > 0.3 * g and g > 0.2 * r


def is_bit(r, g, b):
    """Blue with half as much green, shaded."""
    return b > 90 and b > 1.5 * g and g > 2 * r and g > 30


def is_wellbore(r, g, b):
    """Tan seen through on the dark background."""
    return 45 < r < 160 and r > 1.1 * g and g > 1.1 * b and b > 0.4 * r


class Picture:
    def __init__(self, file):
        with open(file, "rb") as f:
            kind, size, depth = f.readline(), f.readline(), f.readline()
            assert kind.strip() == b"P6" and depth.strip() == b"255"
            self.width, self.height = map(int, size.split())
            data = f.read()
        left, top, right, bottom = VIEW
        rows = (data[3 * (y * self.width + left):3 * (y * self.width + right)] for y in range(top, bottom))
        self.pixels = [pixel for row in rows for pixel in zip(row[0::3], row[1::3], row[2::3])]

    def count(self, wanted):
        return sum(1 for p in self.pixels if wanted(*p))


def differs_from_background(r, g, b):
    return max(abs(r - BACKGROUND[0]), abs(g - BACKGROUND[1]), abs(b - BACKGROUND[2])) > 8


class Rviz(unittest.TestCase):
    def setUp(self):
        for program in ("rviz", "xvfb-run", "import", "convert"):
            if shutil.which(program) is None:
                self.skipTest(program + " is not installed")
        Rig()
        for name in ("rviz.ppm", "rviz.png"):
            if os.path.exists(os.path.join(FOLDER, name)):
                os.unlink(os.path.join(FOLDER, name))
        environment = dict(os.environ, LIBGL_ALWAYS_SOFTWARE="1")
        for name in ("DISPLAY", "ROS_NAMESPACE"):
            environment.pop(name, None)
        self.server = subprocess.Popen(["xvfb-run", "-a", "-s", "-screen 0 %dx%dx24" % (WIDTH, HEIGHT),
                                        "sh", "-c", SCRIPT, "sh", PACKAGE_DIR, FOLDER], env=environment)
        self.addCleanup(self.end)

    def end(self):
        subprocess.run(["pkill", "-TERM", "-P", str(self.server.pid)], check=False)
        self.server.wait(PATIENCE)

    def test_string_wellbore_and_bit_are_to_be_seen(self):
        file = os.path.join(FOLDER, "rviz.ppm")
        deadline = time.monotonic() + 2 * PATIENCE
        seen = {}
        while time.monotonic() < deadline:
            time.sleep(2)
            if not os.path.exists(file):
                continue
            picture = Picture(file)
            self.assertEqual((WIDTH, HEIGHT), (picture.width, picture.height))
            seen = {"string": picture.count(is_string), "bit": picture.count(is_bit), "wellbore": picture.count(is_wellbore),
                    "drawn": picture.count(differs_from_background) / len(picture.pixels)}
            if seen["string"] > 300 and seen["bit"] > 20 and seen["wellbore"] > 1000 and seen["drawn"] > 0.02:
                if os.environ.get("UPDATE_README") == "1":
                    shutil.copy(os.path.join(FOLDER, "rviz.png"), README_PICTURE)
                return
        self.fail("seen in the last picture: %s" % seen)


if __name__ == "__main__":
    run(Rviz)
