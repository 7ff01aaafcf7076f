#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""`drill run --bag`: topics, types and stamps are the node's, the numbers those of the time series. Usage: test_drill_bag.py PATH_TO_DRILL, from
an environment that finds drill_rig_sim."""
import csv
import math
import operator
import os
import subprocess
import sys
import unittest

import rosbag
import yaml
from drill_rig_sim.tables import SIGNALS

sys.dont_write_bytecode = True
import test_drill  # noqa: E402 (leaves nothing behind)

SOURCE = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
SCENE = os.path.join(SOURCE, 'test/scenes/drilling_noisy.yaml')
PROGRAM = 'program=[{at: 0, flow: 0.02, top_drive_speed_rpm: 40, block_velocity: -0.004}]'
ALONE = ('--set', 'numerics.companion=none')
ALL_INSTRUMENTS = (*ALONE, '--every', '0.05', '--set', 'instruments.mwd.inclination_period=5', '--set', 'instruments.dynamics={period: 5, latency: 1}')
NOT_MEASURED = {'drillstring_state', 'markers', 'rig_description', 'trajectory'}  # and what begins with a slash, and actions
# of the time series: field of a message
TRUTH = {row.name: row.field for row in SIGNALS if row.of in ('both', 'truth')}
BIT = {row.name: row.field for row in SIGNALS if row.of == 'bit' and row.field}
READINGS = {'reading_' + row.name: row.field for row in SIGNALS if row.of in ('both', 'reading')}


class Bag(test_drill.Drill):
    played = {}  # by words; two tests look at each

    def run_scene(self, *words):
        """Messages by topic without the namespace, and the rows of the time series but the first, which is at 0 and has no stamp."""
        if words not in self.played:
            self.played[words] = self.play(*words)
        return self.played[words]

    def play(self, *words):
        self.succeed('run', SCENE, '--set', PROGRAM, '--duration', '20', '--readings', '--csv', self.file('r.csv'), '--bag', self.file('r.bag'), *words)
        messages = {}
        with rosbag.Bag(self.file('r.bag')) as bag:
            for topic, message, stamp in bag.read_messages():
                messages.setdefault(topic.replace('/rig/', '', 1), []).append((stamp, message))
        with open(self.file('r.csv')) as text:
            return messages, [{name: float(cell or 0.0) for name, cell in row.items()} for row in csv.DictReader(text)][1:]  # empty: not zeroed, 0 in a message

    def compare(self, rows, messages, table):
        self.assertEqual(len(rows), len(messages))
        for row, (_, message) in zip(rows, messages):
            for column, field in table.items():
                expected, found = row[column], float(operator.attrgetter(field)(message))
                self.assertAlmostEqual(expected, found, delta=1e-8 * max(1e-3, abs(expected)), msg=column)

    def test_the_numbers_are_those_of_the_time_series(self):
        messages, rows = self.run_scene(*ALONE)
        self.assertEqual(200, len(rows))
        self.compare(rows, messages['truth/rig_state'], TRUTH)
        self.compare(rows, messages['truth/bit'], BIT)
        self.compare(rows, messages['rig_state'], READINGS)
        self.assertGreater(rows[-1]['hole_depth'], rows[0]['hole_depth'])
        self.assertNotEqual(rows[-1]['hook_load'], rows[-1]['reading_hook_load'])

    def test_topics_and_types_are_the_nodes(self):
        messages, _ = self.run_scene(*ALL_INSTRUMENTS)
        with open(os.path.join(SOURCE, 'test/interface_contract.yaml')) as text:
            published = yaml.safe_load(text)['publishes']
        expected = {topic: kind for topic, kind in published.items() if not topic.startswith(('/', 'run_operations/')) and topic not in NOT_MEASURED}
        self.assertEqual(expected, {topic: found[0][1]._type for topic, found in messages.items() if not topic.startswith('companion/')})

    def test_stamps_are_simulated_time(self):
        messages, rows = self.run_scene(*ALL_INSTRUMENTS)
        self.assertEqual(400, len(rows))
        times = [round(1e9 * row['time']) for row in rows]
        for topic in ('rig_state', 'truth/rig_state', 'truth/bit', 'joint_states', 'bit/pose', 'bit/twist', 'bit/wrench'):
            self.assertEqual(times, [message.header.stamp.to_nsec() for _, message in messages[topic]], topic)
            self.assertEqual(times, [stamp.to_nsec() for stamp, _ in messages[topic]], topic)
        self.assertEqual(times, [stamp.to_nsec() for stamp, _ in messages['hook_load']])
        self.assertEqual([10000000], [stamp.to_nsec() for stamp, _ in messages['rig_limits']])

    def test_telemetry_arrives_late(self):
        messages, _ = self.run_scene(*ALONE)
        for topic, latency, least in (('downhole/mwd', 2.0, 2), ('downhole/toolface', 1.0, 5)):
            self.assertGreaterEqual(len(messages[topic]), least, topic)
            for stamp, message in messages[topic]:
                self.assertAlmostEqual(latency, (stamp - message.header.stamp).to_sec(), delta=0.011)

    def test_the_accuracy_once_a_second(self):
        messages, _ = self.run_scene('--set', 'numerics.companion=finer')
        self.assertEqual([10000000 + 1000000000 * n for n in range(20)], [m.header.stamp.to_nsec() for _, m in messages['accuracy']])
        last = messages['accuracy'][-1][1]
        self.assertTrue(last.measured, last.why_not_measured)
        self.assertEqual(['hook_load', 'torque', 'wob', 'rop', 'bit_speed', 'stand_pipe_pressure'], last.outputs)
        for numbers in (last.error, last.absolute):
            self.assertTrue(all(number >= 0.0 for number in numbers), numbers)
            self.assertGreater(max(numbers), 0.0)
        self.assertEqual('beam3d', last.companion)
        self.assertTrue(math.isnan(last.cost_share), 'it differs from machine to machine')

    def test_without_a_companion_no_error_is_measured(self):
        messages, _ = self.run_scene(*ALONE)
        for _, message in messages['accuracy']:
            self.assertFalse(message.measured)
            self.assertEqual('numerics.companion is none', message.why_not_measured)
            self.assertTrue(all(map(math.isnan, message.error + message.absolute)))

    def test_a_full_disk_is_told(self):
        done = subprocess.run([test_drill.drill_program, 'run', test_drill.QUICK, '--duration', '1', '--bag', '/dev/full'], stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE, universal_newlines=True, check=False)
        self.assertEqual(3, done.returncode)
        self.assertEqual('drill run: /dev/full could not be written completely; is the disk full?\n', done.stderr)

    def test_the_same_twice(self):
        whole = []
        for name in ('a.bag', 'b.bag'):
            self.succeed('run', SCENE, '--set', PROGRAM, '--duration', '3', '--bag', self.file(name))
            with open(self.file(name), 'rb') as file:
                whole.append(file.read())
        self.assertEqual(*whole)


if __name__ == '__main__':
    test_drill.drill_program = os.path.abspath(sys.argv.pop(1))
    unittest.main()
