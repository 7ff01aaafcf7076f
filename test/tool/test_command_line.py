#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The offline runner's command line: what is refused and in which words, and what is taken. Usage: test_command_line.py PATH_TO_DRILL"""
import json
import os
import subprocess
import sys
import unittest

import test_drill
from test_drill import QUICK


class CommandLine(test_drill.Drill):
    def assert_told(self, words, *parts):
        """Refused in one line that holds each of the parts."""
        line = self.refuse(*words)
        for part in parts:
            self.assertIn(part, line)

    def test_every_command_has_help(self):
        for command in ('run', 'check', 'static', 'modes', 'survey', 'score', 'plot', 'replay', 'weights', 'calibrate', 'reference', 'web'):
            self.assertIn('drill ' + command, self.succeed(command, '--help').splitlines()[1])
        self.assertIn('--motion', self.succeed('static', '--help'))
        # whatever else is there
        self.assertIn('--every', self.succeed('run', 'no_such.yaml', '--duration', '1', '--help'))

    def test_no_command_shows_the_usage_where_errors_go(self):
        done = test_drill.drill()
        self.assertEqual((done.returncode, done.stdout), (2, ''))
        self.assertIn('\n  check', done.stderr)

    def test_unknown_commands_and_options_are_told_with_what_is_allowed(self):
        self.assert_told(['dig', QUICK], "drill: 'dig' is not a command, allowed: run, check, static, modes, survey, score, plot, replay, weights, calibrate, verify, reference, web, fmu or live")
        self.assert_told(['--fast'], 'drill: --fast: unknown option; see drill --help')
        self.assert_told(['check', QUICK, '--fast=3'], 'drill check: --fast: unknown option; see drill check --help')
        self.assert_told(['run', QUICK, '-x'], 'drill run: -x: unknown option')
        self.assert_told(['check', '--csv', 'a.csv', QUICK], '--csv: unknown option')  # another command's
        self.assert_told(['run', QUICK, '--', '-x', QUICK], 'drill run: -x')
        self.assert_told(['reference', QUICK], 'drill reference: ', 'one argument too many')

    def test_options_are_not_abbreviated(self):
        self.assert_told(['run', QUICK, '--dur', '1'], '--dur: unknown option')
        self.assert_told(['run', QUICK, '--raw', self.file('r.csv')], '--raw: unknown option')
        self.assertFalse(os.path.exists(self.file('r.csv')))

    def test_a_missing_value_is_told_with_its_kind(self):
        self.assert_told(['run', QUICK, '--duration'], 'drill run: --duration: needs a value, S')
        self.assert_told(['run', QUICK, '--csv='], '--csv: ')
        self.assert_told(['run', QUICK, '--csv', ''], "--csv: '' is not allowed")
        self.assert_told(['check', QUICK, '--set'], 'drill check: --set: needs a value, KEY=VALUE')
        self.assert_told(['run', '--duration', '1'], 'drill run: needs a SCENE; see drill run --help')
        self.assert_told(['survey'], 'drill survey: needs a FILE')
        # the next option is no value
        self.assert_told(['run', QUICK, '--csv', '--energy'], "--csv: '--energy' is not allowed")
        self.assert_told(['run', QUICK, '--duration', '--energy'], "--duration: '--energy' is not allowed, needed: a number")
        self.assert_told(['run', QUICK, '--energy=no'], '--energy: takes no value')

    def test_numbers_out_of_range_are_told_with_the_range(self):
        everything = {'--duration': ('0.001', '2.592e+06'), '--every': ('0.0001', '1e+06'), '--until-depth': ('0', '20000')}
        for option, (low, high) in everything.items():
            for value in ('-1', '1e9', 'nan', 'inf', '1e400', '3 s', 'long', '1,5'):
                self.assert_told(['run', QUICK, option, value], 'drill run: ' + option, repr(value), 'from %s to %s' % (low, high))
        self.assert_told(['run', QUICK, '--until-depth=99'], "--until-depth: '99' is not allowed", "from the hole's depth, 100, to 20000")
        for value in ('-1', '1.5', '1e16', '18446744073709551616', '0x1', 'seven'):
            self.assert_told(['run', QUICK, '--seed', value], '--seed', repr(value), 'a whole number from 0 to 9e15')

    def test_a_value_may_start_with_a_dash(self):
        os.mkdir(self.file('there'))
        done = subprocess.run([test_drill.drill_program, 'static', QUICK, '--csv', '-s.csv'], cwd=self.file('there'),
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE, universal_newlines=True, timeout=300)
        self.assertEqual((done.returncode, done.stderr), (0, ''))
        self.assertEqual(os.listdir(self.file('there')), ['-s.csv'])

    def test_both_spellings_and_any_order(self):
        self.succeed('run', '--duration=0.1', '--every', '0.05', '--csv=' + self.file('a.csv'), QUICK)
        self.succeed('run', QUICK, '--csv', self.file('b.csv'), '--every=0.05', '--duration', '0.1')
        with open(self.file('a.csv')) as a, open(self.file('b.csv')) as b:
            rows = a.read()
            self.assertEqual(rows, b.read())
        self.assertEqual(len(rows.splitlines()), 4)

    def test_of_an_option_given_twice_the_last_counts(self):
        self.succeed('run', QUICK, '--duration', '500', '--duration', '0.1', '--json', self.file('a.json'), '--json', self.file('b.json'))
        self.assertEqual(os.listdir(self.folder), ['b.json'])
        with open(self.file('b.json')) as text:
            self.assertAlmostEqual(json.load(text)['simulated_s'], 0.1, delta=1e-9)

    def test_settings_are_all_taken_a_word_each(self):
        program = 'program=[{at: 0, flow: 0}, {at: 1, flow: 0.01}]'
        text = self.succeed('check', '--set', program, '--set', 'numerics.step=0.005', QUICK, '--set=numerics.element_length=4')
        self.assertIn('step 0.005 s', text)
        self.assertIn('2 lines to 1 s', text)
        self.assertIn("'numerics.step=7' is one argument", self.refuse('check', QUICK, '--set', 'numerics.step=0.005', 'numerics.step=7'))

    def test_a_scene_may_be_called_like_a_command(self):
        done = subprocess.run([test_drill.drill_program, 'check', 'run'], cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                              universal_newlines=True, timeout=300)
        self.assertEqual((done.returncode, len(done.stderr.splitlines())), (2, 1))
        self.assertIn('run: cannot be read', done.stderr)


if __name__ == '__main__':
    test_drill.drill_program = os.path.abspath(sys.argv.pop(1))
    unittest.main()
