#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The rviz panel DrillersConsole under a virtual X server: the program test_console, whose tests lie in test/rviz, and rviz itself with panel and display, ended in
either order. Pictures to be looked at stay in the build folder as console_*.png and rviz_console_*.png."""
import os
import signal
import subprocess
import tempfile

import rosgraph
from qt_program import FOLDER, environment_of, find, must_pass
from rig_test import PACKAGE_DIR, PATIENCE, rospy, run, time, unittest, wait_until

README_PICTURE = os.path.join(PACKAGE_DIR, "test", "rviz", "pictures", "console.png")
LONGEST = 1200.0  # wall seconds for test_console on a loaded machine
SETTLED = 6.0     # wall seconds from when rviz listens until it has drawn
TOPICS = ("/rig/rig_state", "/rig/drillstring_state")  # of panel and display

# inside xvfb-run: rviz with the panel, two pictures, and its end by a signal
SCRIPT = """
rviz -d "$1" >"$2/rviz_console.log" 2>&1 &
rviz=$!
trap 'kill -INT $rviz' TERM
while kill -0 $rviz && ! [ -e "$4" ]; do sleep 0.2; done
import -window root "$2/rviz_console_$3.png"
[ -z "$5" ] || sh -c "$5"
sleep 3
kill -INT $rviz
wait $rviz
"""


def subscribers(topic):
    return dict(rosgraph.Master(rospy.get_name()).getSystemState()[1]).get(topic, [])


class Console(unittest.TestCase):
    def setUp(self):
        self.environment = environment_of(self, "rviz", "import", "convert")

    def rig(self, *settings):
        """A rig in the namespace rig, as the config of rviz wants it."""
        node = subprocess.Popen([find("rig_simulator"), "__ns:=rig"] + ["_" + s for s in settings], env=self.environment)
        self.addCleanup(node.wait)
        self.addCleanup(node.kill)
        return node

    def rviz(self, width, height, meanwhile=""):
        """Exit status of an rviz with config/rviz/rig.rviz on a screen of this size; `meanwhile` runs after the picture."""
        config, drawn = self.config(width, height), os.path.join(FOLDER, "rviz_console_drawn")
        if os.path.exists(drawn):
            os.unlink(drawn)
        before = {name for topic in TOPICS for name in subscribers(topic)}
        window = subprocess.Popen(["xvfb-run", "-a", "-s", "-screen 0 %dx%dx24" % (width, height), "sh", "-c", SCRIPT, "sh", config, FOLDER,
                                   "%dx%d" % (width, height), drawn, meanwhile], env=self.environment)
        self.addCleanup(window.wait)
        self.addCleanup(window.terminate)
        wait_until(lambda: all(set(subscribers(topic)) - before for topic in TOPICS), "rviz listens")
        time.sleep(SETTLED)
        with open(drawn, "w", encoding="utf-8"):
            pass
        return window.wait(300)

    @staticmethod
    def config(width, height):
        """The package's config with a window that fills the screen."""
        with open(os.path.join(PACKAGE_DIR, "config", "rviz", "rig.rviz"), encoding="utf-8") as f:
            text, geometry = f.read().split("Window Geometry:")
        lines = ["  Width: %d" % width if line.startswith("  Width:") else "  Height: %d" % height if line.startswith("  Height:") else line
                 for line in geometry.split("\n")]
        file = os.path.join(FOLDER, "rviz_console.rviz")
        with open(file, "w", encoding="utf-8") as f:
            f.write(text + "Window Geometry:" + "\n".join(lines))
        return file

    def test_the_panel_by_itself(self):
        must_pass(self, "test_console", self.environment, LONGEST)
        if os.environ.get("UPDATE_README") == "1":
            pages = [os.path.join(FOLDER, "console_1280x800_drilling_%s.png" % page) for page in ("gauges", "chart", "drill")]
            subprocess.run(["convert"] + pages + ["+append", README_PICTURE], check=True)

    def test_it_loads_from_an_install_space(self):
        with tempfile.TemporaryDirectory() as place:
            subprocess.run(["cmake", "--install", FOLDER, "--prefix", place], check=True, stdout=subprocess.DEVNULL)
            environment = dict(self.environment, CMAKE_PREFIX_PATH=place, ROS_PACKAGE_PATH=os.path.join(place, "share"),
                               LD_LIBRARY_PATH=os.path.join(place, "lib"))
            done = subprocess.run(["xvfb-run", "-a", "-s", "-screen 0 1280x800x24", find("test_console"), "--gtest_filter=Life.SaysWhoIs*"],
                                  env=environment, timeout=300, check=False)
        self.assertEqual(0, done.returncode)

    def test_rviz_ends_before_the_node(self):
        node = self.rig("scene:=bohai.yaml", "play_program:=true")
        self.assertEqual(0, self.rviz(1280, 800))
        self.assertIsNone(node.poll())

    def test_the_node_ends_before_rviz(self):
        node = self.rig("scene:=bohai.yaml", "play_program:=true")
        self.assertEqual(0, self.rviz(1920, 1080, "kill -%d %d" % (signal.SIGKILL, node.pid)))
        deadline = time.monotonic() + 10.0
        while node.poll() is None and time.monotonic() < deadline:
            time.sleep(0.1)
        self.assertIsNotNone(node.poll())
        # the killed one's name is still with the master, where the next test would find two rigs: one that ends cleanly takes it away
        heir = self.rig("scene:=quick.yaml")
        rospy.wait_for_service("/rig/pause", PATIENCE)
        time.sleep(2.0)
        heir.send_signal(signal.SIGINT)
        heir.wait(PATIENCE)


if __name__ == "__main__":
    run(Console)
