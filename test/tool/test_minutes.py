#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""test/minutes/run: phases and tests by what the commands print, of this version and of 0.2.0."""
import importlib.machinery
import importlib.util
import os
import re
import subprocess
import sys
import unittest

sys.dont_write_bytecode = True
PLACE = os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(__file__))), 'minutes/run')
loader = importlib.machinery.SourceFileLoader('minutes', PLACE)
minutes = importlib.util.module_from_spec(importlib.util.spec_from_loader('minutes', loader))
loader.exec_module(minutes)


class Phases(unittest.TestCase):
    def test_of_the_demo(self):
        lines = [(0.0, 'I: Retrieving InRelease'), (50.0, 'demo: installing 60 packages: g++ make'), (52.0, 'demo: apt: 300 packages'),
                 (140.0, 'demo: building in /src/package/build (2 jobs)'), (155.0, 'demo: compiling: file 3 of 40'),
                 (260.0, 'demo: starting a ROS master of its own'), (261.0, 'demo: starting rig_simulator with bohai.yaml'),
                 (262.5, 't     0.44 s  rtf 41.43  hook  410.0 kN'), (300.0, 'simulated 30.00 s in 30.01 s: real-time factor 1.000'), (301.0, 'demo: logs')]
        self.assertEqual({'packages': 90.0, 'compiling': 120.0, 'starting': 2.5, 'running': 37.5, 'first_number': 212.5, 'total': 251.0,
                          'without_packages': 161.0}, minutes.phases_of(lines))

    def test_of_tests_that_are_built_in_two_parts(self):
        lines = [(10.0, 'run: all that the tests print is in'), (11.0, 'run: building in /b (2 jobs)'), (100.0, 'run: built in 2 min'), (100.0, 'Test project /b'),
                 (150.0, '100% tests passed'), (150.0, 'run: building in /b (2 jobs)'), (200.0, 'Test project /b'), (500.0, 'run: took 490 s'), (501.0, '9 passed')]
        found = minutes.phases_of(lines)
        self.assertEqual((1.0, 139.0, 350.0, 491.0), tuple(found[name] for name in ('packages', 'compiling', 'tests', 'total')))

    def test_of_version_0_2_0(self):
        lines = [(0.0, 'run: building in /b (2 jobs)'), (900.0, 'run: testing; all the tests say is in /b/test.log'), (901.0, 'Test project /b'), (2000.0, 'run: took 2000 s')]
        found = minutes.phases_of(lines)
        self.assertEqual((0.0, 900.0, 1100.0), tuple(found[name] for name in ('packages', 'compiling', 'tests')))

    def test_tests_are_found_whether_they_passed_or_not(self):
        for line, name in (('  7/91 Test #166: stability ........   Passed  110.66 sec', 'stability'), (' 1/2 Test  #13: a_b ....***Failed    0.04 sec', 'a_b'),
                           ('1/2 Test #1: c ...***Not Run (Disabled)   0.00 sec', None)):
            match = minutes.TEST.search(line)
            self.assertEqual(name, match and match.group(1), line)

    def test_names_are_those_that_the_command_takes(self):
        self.assertEqual(['test_sim_crew', 'rostest_faults', 'stability'],
                         [minutes.plain(name) for name in ('_ctest_drill_rig_sim_gtest_test_sim_crew', '_ctest_drill_rig_sim_rostest_test_rostest_faults.test', 'stability')])


class Fault(unittest.TestCase):
    def test_the_line_that_it_changes_is_there(self):
        wanted, path = re.match(r"sed -i 's/([^/]*)/[^/]*/' (\S+) ", minutes.FAULT).groups()
        with open(os.path.join(minutes.SOURCE, path)) as file:
            self.assertEqual(1, file.read().count(wanted), wanted)


class Tables(unittest.TestCase):
    def test_they_are_what_the_command_prints(self):
        for name, words in (('times.md', []), ('slowest.md', ['--slowest'])):
            printed = subprocess.run([PLACE, *words], stdout=subprocess.PIPE, universal_newlines=True, check=True).stdout
            with open(os.path.join(os.path.dirname(PLACE), name)) as file:
                self.assertEqual(printed, file.read(), './test/minutes/run %s > test/minutes/%s' % (' '.join(words), name))


if __name__ == '__main__':
    unittest.main(verbosity=2)
