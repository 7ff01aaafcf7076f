#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""What was skipped is not taken for passed: by skips.main(), and by test/summary.py."""
import os
import subprocess
import sys
import tempfile
import unittest

HERE = os.path.dirname(os.path.abspath(__file__))
SUMMARY = os.path.join(os.path.dirname(HERE), 'summary.py')
PROGRAM = """
import sys, unittest
sys.dont_write_bytecode = True
sys.path.insert(0, %r)
import skips
class T(unittest.TestCase):
    def test_one(self):
        pass
    def test_other(self):
        %s
skips.main()
"""


class Skips(unittest.TestCase):
    def ending(self, line):
        done = subprocess.run([sys.executable, '-c', PROGRAM % (HERE, line)], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
        return done.returncode, done.stdout

    def test_a_program_with_a_skipped_test_ends_with_77_and_says_why(self):
        status, said = self.ending('self.skipTest("no wood")')
        self.assertEqual(status, 77)
        self.assertRegex(said, 'skipped .*test_other.*: no wood')

    def test_failures_come_before_skips(self):
        self.assertEqual(self.ending('pass')[0], 0)
        self.assertEqual(self.ending('self.fail()')[0], 1)


class Summary(unittest.TestCase):
    def summary(self, *cases):
        with tempfile.TemporaryDirectory() as folder:
            with open(os.path.join(folder, 'ctest.xml'), 'w') as out:
                out.write('<testsuite>%s</testsuite>' % ''.join(cases))
            done = subprocess.run([sys.executable, SUMMARY, folder], stdout=subprocess.PIPE, text=True)
        return done.returncode, done.stdout.splitlines()

    def test_what_ctest_skipped_is_counted_and_named_with_its_reason(self):
        status, said = self.summary('<testcase name="a" classname="a" status="run"/>', '<testcase name="b" classname="b" status="notrun">'
                                    '<skipped message="SKIP_RETURN_CODE=77"/><system-out>case, skipped: no data</system-out></testcase>')
        self.assertEqual((status, said), (0, ['SKIPPED b.b: case, skipped: no data', '1 passed, 0 failed, 1 skipped']))

    def test_a_skipped_gtest_is_counted(self):
        said = self.summary('<testcase name="a" status="run" result="skipped" classname="S"/>', '<testcase name="b" classname="S"/>')[1]
        self.assertEqual(said[-1], '1 passed, 0 failed, 1 skipped')

    def test_nothing_but_skips_is_no_success(self):
        self.assertEqual(self.summary('<testcase name="a" status="notrun"/>')[0], 1)

    def test_a_failure_fails(self):
        status, said = self.summary('<testcase name="a" classname="S"><failure/></testcase>', '<testcase name="b" classname="S"/>')
        self.assertEqual((status, said[-1]), (1, '1 passed, 1 failed, 0 skipped'))


if __name__ == '__main__':
    unittest.main()
