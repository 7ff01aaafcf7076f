#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""`drill run --witsml`: a log of WITSML 1.4.1.1 that holds what the time series' readings hold; against the standard's schema where that and lxml are there.
Usage: test_drill_witsml.py PATH_TO_DRILL"""
import csv
import math
import os
import sys
import unittest
import xml.etree.ElementTree as xml
from datetime import datetime

sys.dont_write_bytecode = True
import skips  # noqa: E402 (leaves nothing behind)
import test_drill  # noqa: E402

SCHEMA = os.path.join(os.path.dirname(test_drill.SOURCE), 'shared/data/witsml_1411/xsd/obj_log.xsd')
SPACE = '{http://www.witsml.org/schemas/1series}'
# mnemonic: unit, column of the time series, factor
CURVES = {'BITDEP': ('m', 'reading_bit_depth', 1.0), 'DMEA': ('m', 'reading_hole_depth', 1.0), 'BLOCKCOMP': ('m', 'reading_block_height', 1.0),
          'ROP': ('m/h', 'reading_rop', 3600.0), 'HKLD': ('kN', 'reading_hook_load', 1e-3), 'WOB': ('kN', 'reading_surface_wob', 1e-3), 'TORQUE': ('kN.m', 'reading_torque', 1e-3),
          'SURF_RPM': ('rpm', 'reading_top_drive_speed', 30.0 / math.pi), 'SPP': ('kPa', 'reading_stand_pipe_pressure', 1e-3),
          'FLOWIN': ('L/min', 'reading_flow', 6e4), 'DIFP': ('kPa', 'reading_differential_pressure', 1e-3)}


ZEROED = ('reading_surface_wob', 'reading_differential_pressure')  # empty until they have been zeroed, which a program does not do
TAGS = ('operations=[{do: flow, flow: 0.02}, {do: rotate, speed_rpm: 90}, {do: tag, speed: 0.02, weight: 2000}, {do: drill, weight: 5000, speed: 0.02, distance: 1}]')


class Witsml(test_drill.Drill):
    def log(self, *words):
        self.succeed('run', test_drill.QUICK, *test_drill.ALONE, '--duration', '60', '--readings', '--csv', self.file('r.csv'), '--witsml', self.file('r.xml'),
                     '--every', '0.5', *words)
        return xml.parse(self.file('r.xml')).getroot()

    def test_rows_are_the_readings_in_the_fields_units(self):
        log = self.log()[0]
        names, units = (log.find('%slogData/%s%s' % (SPACE, SPACE, part)).text.split(',') for part in ('mnemonicList', 'unitList'))
        self.assertEqual(['TIME', *CURVES], names)
        self.assertEqual(['s', *(unit for unit, _, _ in CURVES.values())], units)
        self.assertEqual(list(zip(names, units)), [(info.find(SPACE + 'mnemonic').text, info.find(SPACE + 'unit').text) for info in log.iter(SPACE + 'logCurveInfo')])
        with open(self.file('r.csv'), encoding='utf-8') as text:
            rows = list(csv.DictReader(text))
        data = [row.text.split(',') for row in log.iter(SPACE + 'data')]
        self.assertEqual(121, len(data))
        self.assertEqual(len(rows), len(data))
        for row, cells in zip(rows, data):
            self.assertAlmostEqual(float(row['time']), (when(cells[0]) - when('2000-01-01T00:00:00.000Z')).total_seconds(), places=3)
            for (_, column, factor), cell in zip(CURVES.values(), cells[1:]):
                if column and column in ZEROED:
                    self.assertEqual(('', ''), (row[column], cell))
                elif column:
                    self.assertAlmostEqual(1.0, (float(cell) + 1.0) / (factor * float(row[column]) + 1.0), places=5)
        self.assertAlmostEqual(90.0, float(data[-1][names.index('SURF_RPM')]), delta=3.0)
        self.assertEqual([data[0][0], data[-1][0]], [log.find(SPACE + name).text for name in ('startDateTimeIndex', 'endDateTimeIndex')])

    def test_time_0_has_the_date_that_is_asked_for(self):
        for date, first, last in (('2024-02-29', '2024-02-29T00:00:00.000Z', '2024-02-29T00:01:00.000Z'),
                                  ('1999-12-31T23:59:30Z', '1999-12-31T23:59:30.000Z', '2000-01-01T00:00:30.000Z')):
            log = self.log('--start-date', date)[0]
            data = [row.text.split(',')[0] for row in log.iter(SPACE + 'data')]
            self.assertEqual((first, last), (data[0], data[-1]))
            self.assertEqual([first, last], [log.find(SPACE + name).text for name in ('startDateTimeIndex', 'endDateTimeIndex')])
        for bad in ('2023-02-29', '1969-12-31', '2200-01-01', '2024-05-17T06:30:00+02:00', '2024-05-17 06:30:00Z', '17.05.2024', '2024-05-17T24:00:00Z', '1e9'):
            self.assertIn("--start-date: '%s' is not allowed, needed: a UTC date from 1970 to 2199, such as 2024-05-17" % bad,
                          self.refuse('run', test_drill.QUICK, '--witsml', self.file('r.xml'), '--start-date', bad))

    def test_weight_and_pressure_are_empty_until_they_have_been_zeroed(self):
        log = self.log('--set', 'program=[]', '--set', TAGS)[0]
        names = log.find('%slogData/%smnemonicList' % (SPACE, SPACE)).text.split(',')
        with open(self.file('r.csv'), encoding='utf-8') as text:
            rows = list(csv.DictReader(text))
        data = [dict(zip(names, row.text.split(','))) for row in log.iter(SPACE + 'data')]
        for column, mnemonic in zip(ZEROED, ('WOB', 'DIFP')):
            empty = [row[column] == '' for row in rows]
            self.assertEqual(empty, [cells[mnemonic] == '' for cells in data])
            self.assertEqual((True, False), (empty[0], empty[-1]))
            self.assertEqual(1, sum(one != other for one, other in zip(empty, empty[1:])))
        self.assertAlmostEqual(5.0, float(data[-1]['WOB']), delta=1.0)

    def test_it_is_valid_by_the_standards_schema(self):
        try:
            from lxml import etree
        except ImportError:
            self.skipTest('python3-lxml is not installed')
        if not os.path.exists(SCHEMA):
            self.skipTest('the schema is not there: ' + SCHEMA)
        self.log()
        etree.XMLSchema(etree.parse(SCHEMA)).assertValid(etree.parse(self.file('r.xml')))

    def test_a_file_of_its_own(self):
        told = self.refuse('run', test_drill.QUICK, '--csv', self.file('x'), '--witsml', self.file('x'))
        self.assertIn('--witsml: ' + self.file('x') + ' is the file of --csv', told)


def when(text):
    return datetime.strptime(text, '%Y-%m-%dT%H:%M:%S.%fZ')


if __name__ == '__main__':
    test_drill.drill_program = sys.argv.pop(1)
    skips.main()
