#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The program test_display, whose tests lie in test/rviz/display: tool Probe and every colouring of the display Drillstring, with a string whose numbers
are known. Pictures to be looked at stay in the build folder as display_values_*.png."""
from qt_program import environment_of, must_pass
from rig_test import run, unittest

LONGEST = 500.0  # wall seconds on a loaded machine


class DisplayValues(unittest.TestCase):
    def test_the_display_by_itself(self):
        must_pass(self, "test_display", environment_of(self), LONGEST)


if __name__ == "__main__":
    run(DisplayValues)
