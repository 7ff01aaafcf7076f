#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""What ./test/stability/run says of jobs that break off, are not there or are left out. A small program takes the cases' place."""
import os
import subprocess
import sys
import tempfile
import unittest

HERE = os.path.dirname(os.path.abspath(__file__))
PROGRAM = '''#!/bin/sh
[ "$1" = --fast ] && shift
[ "$1" = --list ] && echo wells index3 && exit
echo group,case,value,method,element,promise,verdict,kept,figure,unit,text
[ -e %s ] && [ "$1" = index3 ] && exit 3
echo "wells,$1,,bdf2,corotational,passes,passes,yes,0,,"
'''


class Run(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        self.breaks = os.path.join(self.folder, 'breaks')
        with open(self.place('program'), 'w') as out:
            out.write(PROGRAM % self.breaks)
        os.chmod(self.place('program'), 0o755)

    def place(self, *names):
        return os.path.join(self.folder, *names)

    def run_it(self, *words):
        """Exit status, what it printed and what it said of errors."""
        done = subprocess.run([sys.executable, os.path.join(HERE, 'run'), '--program', self.place('program'), '--out', self.place('out'), *words],
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE, universal_newlines=True, check=False)
        return done.returncode, done.stdout, done.stderr

    def test_all_jobs_that_pass(self):
        status, said, _ = self.run_it('--fast')
        self.assertEqual(status, 0)
        self.assertIn('2 rows, 2 promised, 0 broken', said)

    def test_wrong_usage_is_one_line_and_status_2(self):
        for words in (['--only', 'impct'], ['--fast', '--update-readme'], ['--program', '/no/such/program']):
            status, said, errors = self.run_it(*words)
            self.assertEqual((status, said, errors.count('\n')), (2, '', 1), errors)

    def test_a_job_that_breaks_off_leaves_no_rows_and_is_missed_later(self):
        self.run_it('--fast')
        open(self.breaks, 'w').close()
        status, said, _ = self.run_it('--fast')
        self.assertEqual(status, 3)
        self.assertIn('index3 broke off with status 3', said)
        self.assertEqual(os.listdir(self.place('out', 'rows')), ['wells.csv'])
        for words in (['--reuse'], ['--only', 'wells', '--update-readme']):
            status, _, errors = self.run_it(*words)
            self.assertEqual((status, errors), (3, 'run: no rows of index3\n'))
        self.assertEqual(self.run_it('--fast', '--only', 'wells')[0], 0)

    def test_nothing_to_reuse(self):
        self.assertEqual(self.run_it('--fast', '--reuse')[0], 3)


if __name__ == '__main__':
    unittest.main()
