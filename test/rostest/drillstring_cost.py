#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What the display Drillstring costs with a string of 1300 elements under software GL: its own work at most a quarter of a processor core at the default
rates, as it tells in its log; how many frames a second are drawn is told, not judged, for that is the machine's."""
import os
import re

from rig_test import run, unittest
from rviz_window import FOLDER, Window

LINE = re.compile(r"own work ([\d.]+) % of a processor core, ([\d.]+) frames a second, 1301 nodes")
WARM_UP = 2  # lines, of five seconds each


class DrillstringCost(unittest.TestCase):
    def test_own_work_is_at_most_a_quarter_of_a_core(self):
        config = os.path.join(FOLDER, "debug.config")
        with open(config, "w") as f:
            f.write("log4j.logger.ros=INFO\nlog4j.logger.ros.drill_rig_sim=DEBUG\n")
        os.environ["ROSCONSOLE_CONFIG_FILE"] = config
        os.environ["ROSCONSOLE_STDOUT_LINE_BUFFERED"] = "1"
        window = Window(self, "display_long", "rig.rviz", 1280, 800, (20, 66, 826, 766))
        found = window.wait_until(lambda _: self.figures(window), lambda seen: len(seen) >= WARM_UP + 3)[WARM_UP:]
        print("own work [% of a core], frames a second:", found)
        self.assertLess(sorted(work for work, _ in found)[len(found) // 2], 25.0)
        self.assertGreater(sorted(frames for _, frames in found)[len(found) // 2], 2.0)

    @staticmethod
    def figures(window):
        with open(window.files + ".log", errors="replace") as f:
            return [(float(work), float(frames)) for work, frames in LINE.findall(f.read())]


if __name__ == "__main__":
    run(DrillstringCost)
