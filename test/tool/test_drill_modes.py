#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""`drill modes` from outside: its table, its file, what it refuses. Usage: test_drill_modes.py PATH_TO_DRILL"""
import json
import os
import shutil
import sys

sys.dont_write_bytecode = True
import skips  # noqa: E402 (leaves nothing behind)
import test_drill  # noqa: E402
from test_drill import QUICK  # noqa: E402


class Modes(test_drill.Drill):
    def test_lists_each_family_and_writes_shapes(self):
        table = self.succeed('modes', QUICK, '--modes', '3', '--json', self.file('m.json')).splitlines()
        self.assertEqual([line.split()[:2] for line in table[2:]],
                         [[family, str(k)] for family in ('axial', 'torsional', 'lateral') for k in (1, 2, 3)])
        with open(self.file('m.json')) as text:
            found = json.load(text)
        for family, modes in found['modes'].items():
            frequencies = [mode['frequency_hz'] for mode in modes]
            self.assertEqual(frequencies, sorted(frequencies))
            for mode in modes:
                self.assertAlmostEqual(mode[family + '_share'], 1.0, places=9)
                self.assertAlmostEqual(mode['critical_speed_rpm'], 60.0 * mode['frequency_hz'], places=6)
                self.assertEqual({key: len(shape) for key, shape in mode['shape'].items()},
                                 dict.fromkeys(('axial', 'high_side', 'right', 'spin'), len(found['from_bit_m'])))

    def test_an_assembly_is_stiffer_than_the_string(self):
        def first(*words):
            self.succeed('modes', QUICK, '--family', 'torsional', '--modes', '1', '--json', self.file('m.json'), *words)
            with open(self.file('m.json')) as text:
                return json.load(text)['modes']['torsional'][0]['frequency_hz']
        self.assertGreater(first('--assembly', '50'), 1.5 * first())

    def test_wrong_usage_is_one_line_and_status_2(self):
        self.assertIn('--family', self.refuse('modes', QUICK, '--family', 'radial'))
        self.assertIn('--modes', self.refuse('modes', QUICK, '--modes', '0'))
        self.assertIn('--assembly', self.refuse('modes', QUICK, '--assembly', '-5'))
        scene = self.file('scene.yaml')
        shutil.copy(QUICK, scene)
        self.assertIn('is the scene', self.refuse('modes', scene, '--json', scene))


if __name__ == '__main__':
    test_drill.drill_program = os.path.abspath(sys.argv.pop(1))
    skips.main()
