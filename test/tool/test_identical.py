#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""What test/identical/run holds for different, and how it ends. Needs no program."""
import importlib.machinery
import importlib.util
import math
import os
import subprocess
import sys
import unittest

sys.dont_write_bytecode = True
COMMAND = os.path.join(os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__)))), 'test/identical/run')
loader = importlib.machinery.SourceFileLoader('identical', COMMAND)
identical = importlib.util.module_from_spec(importlib.util.spec_from_loader('identical', loader))
loader.exec_module(identical)


def run_of(load=('1000', '1010'), raw='east\n0\n1\n', names=('time', 'load')):
    """Columns, rows, raw path and counts, as of a run of two rows."""
    return list(names), [[str(k), value][:len(names)] for k, value in enumerate(load)], raw, [1]


class Distance(unittest.TestCase):
    def test_it_is_of_the_columns_range(self):
        apart, column = identical.farthest_apart(run_of(), run_of(('1000', '1009')))
        self.assertAlmostEqual(apart, 0.1)
        self.assertEqual(column, 'load')

    def test_what_hardly_moves_is_held_to_its_size(self):
        self.assertAlmostEqual(identical.distance([1e6, 1e6], [1e6, 1e6 + 1.0]), 0.01, 6)
        self.assertLess(identical.distance([1e-17, -3e-17], [0.0, 2e-17]), 1e-12)

    def test_what_cannot_be_compared_is_infinitely_far(self):
        for other in (run_of(('1000', 'nan')), run_of(('inf', '1010')), run_of(('1000',)), run_of(names=('time',)), run_of(raw='east\n0\n'),
                      run_of(raw='')):
            self.assertEqual(identical.farthest_apart(run_of(), other)[0], math.inf, other)
        broken = run_of(('1000', 'nan'))
        self.assertEqual(identical.farthest_apart(broken, broken)[0], math.inf)

    def test_the_raw_path_counts(self):
        self.assertEqual(identical.farthest_apart(run_of(), run_of(raw='east\n0\n1.5\n')), (0.5 / 1.5, "raw path's east"))

    def test_columns_of_one_program_only_are_left_out(self):
        more = (['new', 'time', 'load'], [['7', '0', '1000'], ['8', '1', '1010']], *run_of()[2:])
        self.assertEqual([tuple(run_of())] * 2, identical.with_common_columns([run_of(), more]))

    def test_equal_runs_are_not_apart(self):
        self.assertEqual(identical.farthest_apart(run_of(), run_of()), (0.0, ''))


class Usage(unittest.TestCase):
    def test_wrong_usage_is_one_line_and_status_2(self):
        for words in (['--drill', '/bin/true', '--only', 'typo'], ['--drill', '/no/such/program']):
            done = subprocess.run([sys.executable, COMMAND, *words], stdout=subprocess.PIPE, stderr=subprocess.PIPE, universal_newlines=True, check=False)
            self.assertEqual((done.returncode, done.stdout), (2, ''))
            self.assertRegex(done.stderr.splitlines()[-1], '^identical: (--only typo|no program)')


if __name__ == '__main__':
    unittest.main()
