#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""`drill run --errors` and the bag of a run with a companion, and what `drill score` and `drill plot` make of them.
Usage: test_drill_errors.py PATH_TO_DRILL, from an environment that finds drill_rig_sim."""
import csv
import json
import os
import shutil
import sys
import tempfile
import unittest

import numpy
import rosbag
from drill_rig_sim.score import score
from drill_rig_sim.score_runs import BIT, STATE, read_run

sys.dont_write_bytecode = True
import test_drill  # noqa: E402 (leaves nothing behind)
from test_drill_bag import PROGRAM, SCENE  # noqa: E402

ALONE, BESIDE = ('--set', 'numerics.companion=none'), ('--set', 'numerics.companion=finer')
OUTPUTS = ['hook_load', 'torque', 'wob', 'rop', 'bit_speed', 'stand_pipe_pressure']
TOPICS = {'/rig/companion/truth/rig_state': 'drill_rig_sim/RigTruth', '/rig/companion/truth/bit': 'drill_rig_sim/BitTruth'}


class Errors(test_drill.Drill):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.played = folder.name

    def play(self, *words):
        """r.csv and r.bag of a run with these words, which is played once for all tests."""
        place = os.path.join(self.played, ' '.join(words))
        if not os.path.exists(place):
            self.succeed('run', SCENE, '--set', PROGRAM, '--duration', '12', '--csv', self.file('r.csv'), '--bag', self.file('r.bag'), *words)
            os.mkdir(place)
            for name in ('r.csv', 'r.bag'):
                shutil.move(self.file(name), place)
        for name in ('r.csv', 'r.bag'):
            shutil.copy(os.path.join(place, name), self.folder)

    def rows(self):
        with open(self.file('r.csv')) as text:
            return list(csv.reader(text))

    def test_columns_are_written_where_they_are_asked_for(self):
        self.play(*BESIDE)
        alone = self.rows()
        self.assertEqual(test_drill.COLUMNS, alone[0])
        self.play(*BESIDE, '--errors')
        rows = self.rows()
        added = ['error_' + name for name in OUTPUTS] + ['companion_' + name for name in test_drill.COLUMNS[1:]]
        self.assertEqual(test_drill.COLUMNS + added, rows[0])
        self.assertEqual(alone, [row[:len(test_drill.COLUMNS)] for row in rows])
        self.assertTrue(all(all(row) for row in rows))
        row = dict(zip(rows[0], map(float, rows[-1])))
        self.assertNotEqual(row['hook_load'], row['companion_hook_load'])
        self.assertAlmostEqual(row['hook_load'], row['companion_hook_load'], delta=0.05 * row['hook_load'])
        self.assertTrue(0.0 < row['error_hook_load'] < 1.0, row)

    def test_what_is_refused(self):
        csv_file = ('--csv', self.file('no.csv'))
        self.assertEqual('drill run: --errors: needs --csv or --bag\n', self.refuse('run', SCENE, '--errors', *BESIDE))
        self.assertEqual('drill run: --errors: the run has no companion, needed: one, as by --set numerics.companion=finer\n',
                         self.refuse('run', SCENE, '--errors', *csv_file, *ALONE))
        self.assertFalse(os.path.exists(self.file('no.csv')))

    def test_the_bag_holds_the_companion_of_the_series(self):
        self.play(*BESIDE, '--errors')
        of_series, of_bag = read_run(self.file('r.csv')), read_run(self.file('r.bag'))
        for name in set(STATE) - {'wob', 'differential_pressure'} | set(BIT):
            expected = of_series.companion[name][1:]  # what is at 0 is in no bag
            numpy.testing.assert_allclose(expected, of_bag.companion[name], rtol=1e-8, atol=1e-9, err_msg=name)
        with rosbag.Bag(self.file('r.bag')) as bag:
            found = bag.get_type_and_topic_info().topics
            self.assertEqual(TOPICS, {topic: found[topic].msg_type for topic in found if 'companion' in topic})
            read = [list(bag.read_messages([topic])) for topic in (*TOPICS, '/rig/truth/bit')]
        stamps = [[stamp.to_nsec() for _, message, stamp in messages if stamp == message.header.stamp] for messages in read]
        self.assertEqual([120] * 3, list(map(len, stamps)))
        self.assertTrue(stamps[0] == stamps[1] == stamps[2])

    def test_the_bag_has_the_companion_only_where_it_is_asked_for(self):
        self.play(*BESIDE)
        with rosbag.Bag(self.file('r.bag')) as bag:
            self.assertFalse([topic for topic in bag.get_type_and_topic_info().topics if 'companion' in topic])
        self.assertEqual({}, read_run(self.file('r.bag')).companion)

    def test_scores_and_pictures(self):
        self.play(*BESIDE, '--errors')
        for run in ('r.csv', 'r.bag'):
            table = self.succeed('score', self.file(run), '--wob', '10e3', '--json', self.file('s.json'), '--plots', self.file('s.png'))
            self.assertRegex(table, r'weight on bit, mean +[0-9.]+ \+- [0-9.]+ kN\n')
            with open(self.file('s.json')) as text:
                found = json.load(text)
            self.assertEqual(score(self.file(run), wob=10e3), found)
            self.assertAlmostEqual(found['wob']['mean'], found['companion']['wob']['mean'], delta=0.05 * found['wob']['mean'])
            self.assertNotEqual(found['wob']['mean'], found['companion']['wob']['mean'])
            self.succeed('plot', self.file(run), '--out', self.file('plots'))

    def test_a_bag_whose_companion_ends(self):
        self.play(*BESIDE, '--errors')
        with rosbag.Bag(self.file('r.bag')) as whole, rosbag.Bag(self.file('ended.bag'), 'w') as ended:
            for topic, message, stamp in whole.read_messages():
                if 'companion' not in topic or stamp.to_sec() < 8.05:
                    ended.write(topic, message, stamp)
        run = read_run(self.file('ended.bag'))
        self.assertEqual(80, numpy.isfinite(run.companion['hook_load']).sum())
        scores = score(run)
        self.assertIsNone(scores['companion'])
        self.assertIn('companion: it ended before the run, it is missing from 8.1 s on', scores['left_out'])


if __name__ == '__main__':
    test_drill.drill_program = os.path.abspath(sys.argv.pop(1))
    unittest.main()
