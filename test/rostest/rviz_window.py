# SPDX-License-Identifier: BSD-3-Clause
"""rviz in a virtual X server: what the tests of displays share."""
import os
import shutil
import signal
import subprocess

from rig_test import PACKAGE_DIR, PATIENCE, needs, time, wait_until

# where ROS_HOME is build/ros_home; elsewhere it is the user's own choice
FOLDER = os.path.dirname(os.environ.get("ROS_HOME", os.path.expanduser("~/.ros/x")))

# inside xvfb-run: rviz, and a picture a second; last its exit status
SCRIPT = """
rviz -d "$1" >"$2.log" 2>&1 &
rviz=$!
echo $rviz >"$2.pid"
trap 'kill $rviz' TERM
while kill -0 $rviz 2>/dev/null; do
  sleep 1
  kill -0 $rviz 2>/dev/null || break
  import -window root "$2_new.png" && convert "$2_new.png" -depth 8 "ppm:$2_new.ppm" && mv "$2_new.png" "$2.png" && mv "$2_new.ppm" "$2.ppm"
done
wait $rviz
echo $? >"$2.status"
"""


def plugins_are_built():
    places = os.environ.get("CMAKE_PREFIX_PATH", "").split(":")
    return any(os.path.exists(os.path.join(place, "lib", "libdrill_rig_sim_rviz.so")) for place in places)


class Picture:
    """The pixels of a part of the screen, row by row from its left upper corner."""

    def __init__(self, file, view):
        with open(file, "rb") as f:
            kind, size, depth = f.readline(), f.readline(), f.readline()
            assert kind.strip() == b"P6" and depth.strip() == b"255"
            self.width, self.height = map(int, size.split())
            data = f.read()
        left, top, right, bottom = view
        self.row_length = right - left
        rows = (data[3 * (y * self.width + left):3 * (y * self.width + right)] for y in range(top, bottom))
        self.pixels = [pixel for row in rows for pixel in zip(row[0::3], row[1::3], row[2::3])]

    def count(self, wanted):
        return sum(1 for p in self.pixels if wanted(*p))

    def places(self, wanted):
        """(x, y) of the pixels that are wanted."""
        return [(i % self.row_length, i // self.row_length) for i, p in enumerate(self.pixels) if wanted(*p)]


class Window:
    """rviz with a configuration, whose pictures stay in the build folder as `name`.png, the one that was right as `name`_seen.png. `case` is skipped where a program is missing, and closes
    it in the end."""

    def __init__(self, case, name, config, width, height, view):
        needs(case, "rviz", "xvfb-run", "import", "convert")
        if config != "markers.rviz" and not plugins_are_built():
            case.skipTest("the plug-ins for rviz are not built")
        self.case, self.size, self.view = case, (width, height), view
        self.files = os.path.join(FOLDER, name)
        for end in (".ppm", ".png", ".pid", ".status"):
            if os.path.exists(self.files + end):
                os.unlink(self.files + end)
        environment = dict(os.environ, LIBGL_ALWAYS_SOFTWARE="1")
        for variable in ("DISPLAY", "ROS_NAMESPACE"):
            environment.pop(variable, None)
        file = config if os.path.isabs(config) else os.path.join(PACKAGE_DIR, "config", "rviz", config)
        self.server = subprocess.Popen(["xvfb-run", "-a", "-s", "-screen 0 %dx%dx24" % (width, height), "sh", "-c", SCRIPT, "sh", file, self.files],
                                       env=environment)
        case.addCleanup(self.end)

    def end(self):
        """Closes it, however far it has got."""
        deadline = time.monotonic() + PATIENCE
        while self.server.poll() is None and time.monotonic() < deadline:
            if os.path.exists(self.files + ".pid") and not os.path.exists(self.files + ".status"):
                self.kill()
            time.sleep(0.1)
        if self.server.poll() is None:
            subprocess.run(["pkill", "-TERM", "-P", str(self.server.pid)], check=False)
            self.server.wait(PATIENCE)

    def kill(self):
        """Ends rviz as a desktop does."""
        with open(self.files + ".pid") as f:
            number = f.read().strip()
        try:
            os.kill(int(number), signal.SIGTERM)
        except (ProcessLookupError, ValueError):  # it has ended, or the file is not written yet
            pass

    def runs(self):
        return self.server.poll() is None and not os.path.exists(self.files + ".status")

    def close(self):
        """Ends rviz; its exit status, 128 and more: killed by a signal."""
        self.kill()
        wait_until(lambda: self.status() != "", "rviz ends")
        return int(self.status())

    def status(self):
        """What its starter has written of its end; "" before: the file is there a moment before its content."""
        if not os.path.exists(self.files + ".status"):
            return ""
        with open(self.files + ".status") as f:
            return f.read().strip()

    def wait_until(self, measure, enough, patience=2 * PATIENCE):
        """Waits for a picture newer than now of which `enough(measure(picture))` holds, and returns what was measured."""
        file, begun, seen = self.files + ".ppm", time.time(), {}
        deadline = time.monotonic() + patience
        while time.monotonic() < deadline:
            time.sleep(0.2)
            self.case.assertTrue(self.runs(), "rviz has ended: see " + self.files + ".log")
            if not os.path.exists(file) or os.path.getmtime(file) < begun:
                continue
            picture = Picture(file, self.view)
            self.case.assertEqual(self.size, (picture.width, picture.height))
            seen = measure(picture)
            if enough(seen):
                shutil.copy(self.files + ".png", self.files + "_seen.png")
                return seen
        return self.case.fail("seen in the last picture: %s" % seen)
