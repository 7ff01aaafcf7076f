#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""What ./test/packaging/run refuses, and how its things are counted; the chroot itself is no part of these tests."""
import contextlib
import io
import os
import re
import shutil
import subprocess
import sys
import tempfile
import time
import unittest

sys.dont_write_bytecode = True
FOLDER = os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(__file__))), 'packaging')
sys.path.insert(0, FOLDER)
import workspace  # noqa: E402


def refused(*options):
    """Status and the first line of the refusal."""
    done = subprocess.run([os.path.join(FOLDER, 'run'), *options], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, universal_newlines=True, check=False)
    return done.returncode, done.stdout.split('\n')[0]


class Run(unittest.TestCase):
    def test_wrong_options(self):
        self.assertEqual((2, 'run: --suite must be bullseye, bookworm, trixie or sid (got buster)'), refused('--suite', 'buster'))
        self.assertEqual((2, 'run: --keep needs a value'), refused('--keep'))
        self.assertEqual((2, 'run: unknown option: --fast'), refused('--fast'))


class Sources(unittest.TestCase):
    """What the chroot gets of a checkout."""

    def setUp(self):
        if not shutil.which('git'):
            self.skipTest('git is not installed')
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.folder = holder.name
        with open(os.path.join(FOLDER, 'run'), encoding='utf-8') as text:
            self.functions = re.search(r'^contents\(\)$.*?^copy_sources\(\)$.*?^}$', text.read(), re.M | re.S).group(0)

    def checkout(self, name, age, **files):
        """A repository with these files, so old [s]."""
        place = os.path.join(self.folder, name)
        os.makedirs(place)
        subprocess.run(['git', 'init', '-q', place], check=True)
        for file, text in files.items():
            with open(os.path.join(place, file), 'w', encoding='utf-8') as out:
                out.write(text)
            os.utime(os.path.join(place, file), (time.time() - age,) * 2)
        return place

    def copied(self, place):
        """Text and time of the files in the chroot, after a copy from there."""
        subprocess.run(['bash', '-eu', '-c', self.functions + '\ncopy_sources "$1" "$2"', 'bash', place, self.folder + '/src'], check=True)
        found = {}
        for entry in os.scandir(self.folder + '/src/drill_rig_sim'):
            with open(entry.path, encoding='utf-8') as text:
                found[entry.name] = text.read(), entry.stat().st_mtime
        return found

    def test_they_are_those_of_the_checkout_however_old(self):
        first = self.copied(self.checkout('newer', 100.0, same='a', other='b', gone='c'))
        self.assertEqual({'same': 'a', 'other': 'b', 'gone': 'c'}, {name: text for name, (text, _) in first.items()})
        time.sleep(0.02)
        second = self.copied(self.checkout('older', 10000.0, same='a', other='d'))
        self.assertEqual({'same': 'a', 'other': 'd'}, {name: text for name, (text, _) in second.items()})
        self.assertEqual(first['same'], second['same'], 'make would build it again')
        self.assertGreater(second['other'][1], first['other'][1], 'make would not build it')


class Things(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.addCleanup(setattr, workspace, 'LOGS', workspace.LOGS)
        workspace.LOGS = self.folder = folder.name

    def line(self, thing, *given):
        """What is printed of a thing, its columns apart, and its result."""
        printed = io.StringIO()
        with contextlib.redirect_stdout(printed):
            result = workspace.tried('a thing, devel', thing, *given)
        return result, printed.getvalue().strip()

    def test_a_line_each(self):
        result, line = self.line(lambda log: log.bash('echo 3', folder=self.folder).strip() + ' programs')
        self.assertEqual('ok', result)
        self.assertRegex(line, r'^ok +a thing, devel +0 s  3 programs$')

    def test_a_command_that_fails(self):
        result, line = self.line(lambda log: log.bash('echo before; false; echo after', folder=self.folder))
        self.assertEqual('failed', result)
        self.assertRegex(line, r'^failed +a thing, devel +0 s  status 1; all it said is in %s/a_thing_devel.log$' % self.folder)
        with open(self.folder + '/a_thing_devel.log', encoding='utf-8') as log:
            self.assertTrue(log.read().endswith('before\n'))
        self.assertEqual('failed', self.line(lambda log: log.bash('false | cat', folder=self.folder))[0])

    def test_what_is_skipped_says_why(self):
        self.addCleanup(setattr, workspace.shutil, 'which', workspace.shutil.which)
        workspace.shutil.which = lambda program: None
        self.assertRegex(self.line(workspace.catkin_build)[1], '^skipped .* this release has no catkin-tools$')
        self.assertRegex(self.line(workspace.rviz, self.folder)[1], '^skipped .* no plug-ins in this build$')

    def test_what_ctest_prints(self):
        self.assertEqual('43 programs passed', workspace.passed('100% tests passed, 0 tests failed out of 43\n'))
        text = """98% tests passed, 2 tests failed out of 90

The following tests FAILED:
\t 12 - _ctest_drill_rig_sim_gtest_test_well_survey (Failed)
\t 43 - _ctest_drill_rig_sim_rostest_test_rostest_rviz.test (Timeout)
"""
        with self.assertRaisesRegex(workspace.Failed, r'^98% tests passed, 2 tests failed out of 90: test_well_survey rviz\.test$'):
            workspace.passed(text)
        with self.assertRaisesRegex(workspace.Failed, '^ctest ended early: $'):
            workspace.passed('Internal ctest changing into directory\n')

    def test_hook_loads(self):
        self.assertEqual('hook load 234.6 kN', workspace.check_hook_load('time: 1\nhook_load: 234567.0\n'))
        for printed in ('', 'hook_load: 0.0', 'hook_load: 2e5\nhook_load: 2e5', 'hook_load: 2e6'):
            with self.assertRaises(workspace.Failed):
                workspace.check_hook_load(printed)


if __name__ == '__main__':
    unittest.main()
