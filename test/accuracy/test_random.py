#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Scenes drawn at random: by their seed alone, such as the runner takes; and how their trials are counted. How the shipped examples are found and counted."""
import os
import subprocess
import sys
import tempfile
import unittest

import yaml

sys.dont_write_bytecode = True
sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import examples  # noqa: E402
import random_scenes  # noqa: E402
import random_trial  # noqa: E402

DRILL = sys.argv.pop(1)


class Found(random_trial.Trial):
    """A trial whose verification is given."""

    def __init__(self, verdict, warned_from=None, off=(), measured=(), speed=100.0, free_speed=50.0):  # pylint: disable=super-init-not-called
        self.number, self.what, self.speed, self.free_speed = 0, 'a well', speed, free_speed
        self.found = {'verdict': verdict, 'warned_from': warned_from,
                      'outputs': {'torque': {'needed': True, 'worst': max(off, default=0.0), 'off': list(off), 'measured': list(measured)},
                                  'rop': {'needed': False, 'worst': 9.0, 'off': [9.0], 'measured': [1.0]}}}


class Scenes(unittest.TestCase):
    def test_follow_from_their_seed(self):
        self.assertEqual(random_scenes.drawn(3, 4), random_scenes.drawn(3, 4))
        self.assertNotEqual(random_scenes.drawn(3, 4), random_scenes.drawn(3, 5))

    def test_the_runner_takes_them(self):
        for number in range(8):
            line, scene = random_scenes.drawn('taken', number)
            self.assertRegex(line, '^# .*; for [0-9]+ s$')
            with tempfile.NamedTemporaryFile('w', suffix='.yaml') as file:
                file.write(line + '\n' + yaml.safe_dump(scene))
                file.flush()
                done = subprocess.run([DRILL, 'check', file.name], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, universal_newlines=True, check=False)
            self.assertEqual(done.returncode, 0, line + done.stdout)


class Trials(unittest.TestCase):
    def test_are_counted_with_warnings_and_ratios(self):
        trials = [Found('right'), Found('right', warned_from=3.0, speed=25.0), Found('missed', off=[0.01, 0.03, 0.001], measured=[0.01, 0.015, 0.2])]
        told = random_trial.summary(trials, 0.02)
        self.assertEqual(told[0], '3 scenes: 2 right, 1 missed; of the right ones under a warning: 1.')
        self.assertEqual(told[1], 'Simulated over processor time, geometric mean: 63; not below that of free nodes by 10 ms without a companion in 2.')
        self.assertEqual(told[2], 'Measured over true error, 2 windows: 5 % below 0.50, half below 1.00, 5 % above 1.00.')
        self.assertIn('| missed | 3.0 | torque | - | 100 |', trials[2].row())


class Played(examples.Example):
    """An example whose run is given."""

    def __init__(self, warned):  # pylint: disable=super-init-not-called
        self.name, self.seconds, self.coarse, self.measured, self.speed = 'quick', 200.0, 150.0, '', 40.0
        self.warned = examples.collections.Counter(warned)


class Examples(unittest.TestCase):
    def test_are_all_that_are_shipped(self):
        shipped = {name[:-len('.yaml')] for name in os.listdir(os.path.join(examples.SOURCE, 'config/scenes')) if name != 'template.yaml'}
        self.assertEqual(shipped, {*examples.PROGRAMS, *examples.CONTROLLERS})

    def test_are_counted_by_the_words_of_their_warnings(self):
        self.assertEqual(examples.reason('torque: measured error 2.5 % of its range over 3 s; over 30 s'), 'measured error of the torque')
        self.assertEqual(examples.reason('guided pipe 310.5 m above the bit carries 1.2 times its critical buckling load; use numerics.level: beam3d'),
                         'guided pipe N m above the bit carries N times its critical buckling load')
        played = Played({'measured error of the torque': 15.0, 'slant': 5.0})
        self.assertEqual(played.share(), 0.1)
        self.assertEqual(played.row(), '| quick | 200 | 10.0 | measured error of the torque (15 s); slant (5 s) | yes | 40 |')
        self.assertEqual(played.coarse_row(), '| quick | 200 | 75 | 40 |')


if __name__ == '__main__':
    unittest.main()
