#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""How a foreign scene is judged: right, warned in time, missed, undecided."""
import csv
import json
import os
import sys
import tempfile
import unittest

import numpy

sys.dont_write_bytecode = True
sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), 'foreign'))
import trial  # noqa: E402


class Judging(unittest.TestCase):
    TIME = numpy.arange(0.0, 30.0, 0.02)

    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        path = os.path.join(self.folder.name, 'swing.yaml')
        with open(path, 'w') as file:
            file.write('# a swing; for 30 s\nname: swing\n')
        self.scene = trial.Scene(path)

    def put(self, kind, torque, warned=None, text='x'):
        """A run whose torque is so far from a swing of 1 kN m [N m], its other outputs still."""
        name = os.path.join(self.folder.name, 'swing.' + kind)
        with open(name + '.csv', 'w', newline='') as file:
            table = csv.writer(file)
            table.writerow(['time'] + list(trial.RESOLVED))
            for t, wrong in zip(self.TIME, torque):
                table.writerow([t] + [500.0 * numpy.sin(t) + wrong if output == 'torque' else 1.0 for output in trial.RESOLVED])
        with open(name + '.json', 'w') as file:
            json.dump({'accuracy_warnings': [] if warned is None else [{'since': warned, 'until': 30.0, 'text': text}]}, file)

    def verdict(self, ours, coarse, warned=None, tolerance=0.02, text='x'):
        for kind, torque in (('default', ours), ('fine', 0.0 * self.TIME), ('coarse', coarse)):
            self.put(kind, torque, warned, text)
        return trial.Verdict(self.scene, self.folder.name, tolerance)

    def after(self, start, size):
        return numpy.where(self.TIME >= start, size, 0.0)

    def test_reads_what_and_how_long(self):
        self.assertEqual((self.scene.name, self.scene.what, self.scene.seconds), ('swing', 'a swing', '30'))

    def test_right_within_two_percent_of_the_range(self):
        verdict = self.verdict(self.after(12.0, 19.0), self.after(0.0, 1.0))
        self.assertEqual((verdict.kind, verdict.output), ('right', 'torque'))
        self.assertAlmostEqual(verdict.worst, 0.019, delta=1e-4)

    def test_missed_beyond_unless_warned_in_time(self):
        ours, coarse = self.after(12.0, 21.0), self.after(0.0, 1.0)
        missed = self.verdict(ours, coarse)
        self.assertEqual((missed.kind, missed.wrong_from), ('missed', 12.0))
        self.assertEqual(self.verdict(ours, coarse, warned=14.9).kind, 'warned')
        self.assertEqual(self.verdict(ours, coarse, warned=15.1).kind, 'missed')

    def test_warnings_of_a_limit_of_the_model_are_counted_apart(self):
        ours, coarse = self.after(12.0, 1.0), self.after(0.0, 1.0)
        texts = ('torque: measured error 3 % of its range so far', 'guided pipe carries too much')
        verdicts = [self.verdict(ours, coarse, warned=3.0, text=text) for text in texts] + [self.verdict(ours, coarse)]
        self.assertEqual(trial.under_a_warning(verdicts), 'of the right ones under a warning: 2, of which 1 only of a limit of the model')

    def test_by_another_tolerance(self):
        ours, coarse = self.after(12.0, 21.0), self.after(0.0, 1.0)
        self.assertEqual(self.verdict(ours, coarse, tolerance=0.05).kind, 'right')
        self.assertEqual(self.verdict(ours, self.after(12.0, 21.0), tolerance=0.01).kind, 'undecided')
        self.assertEqual(self.verdict(ours, coarse, tolerance=0.01).kind, 'missed')

    def test_undecided_where_the_references_differ(self):
        self.assertEqual(self.verdict(self.after(12.0, 21.0), self.after(12.0, 21.0)).kind, 'undecided')
        self.assertEqual(self.verdict(self.after(12.0, 21.0), self.after(18.0, 21.0)).kind, 'missed')


if __name__ == '__main__':
    unittest.main()
