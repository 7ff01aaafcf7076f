#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""package.xml: what a robot without a screen (DRILL_RIG_SIM_HEADLESS=1) does not need, and everybody else does."""
import os
import unittest

from catkin_pkg.package import parse_package

FILE = os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', '..', 'package.xml')
OF_SCREENS = {'rviz', 'pluginlib', 'libqwt-qt5-dev', 'python3-matplotlib'}


def needed(environment):
    """Names of all packages to build and run."""
    package = parse_package(FILE)
    package.evaluate_conditions(environment)
    return {dependency.name for dependency in package.build_depends + package.exec_depends if dependency.evaluated_condition}


class Package(unittest.TestCase):
    def test_a_headless_robot_needs_neither_rviz_nor_matplotlib(self):
        everything = needed({})
        self.assertLessEqual(OF_SCREENS, everything)
        self.assertEqual(everything - OF_SCREENS, needed({'DRILL_RIG_SIM_HEADLESS': '1'}))
        self.assertEqual(everything, needed({'DRILL_RIG_SIM_HEADLESS': '0'}))


if __name__ == '__main__':
    unittest.main()
