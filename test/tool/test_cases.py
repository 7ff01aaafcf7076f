#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Inputs from outside that went wrong once (test/cases), by kind, each with the command of its README and the value that is right.
Variants of each kind stand in the tests of its reader. Usage: test_cases.py PATH_TO_DRILL"""
import csv
import importlib.util
import json
import math
import os
import re
import subprocess
import sys
import tempfile
import unittest

CASES = os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(__file__))), 'cases')
drill_program = None
fits = unittest.skipUnless(importlib.util.find_spec('scipy'), 'python3-scipy is not installed')


def drill(case, *words):
    return subprocess.run([drill_program, *words], cwd=os.path.join(CASES, case), stdout=subprocess.PIPE, stderr=subprocess.PIPE, universal_newlines=True,
                          timeout=600)


class Case(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def file(self, name):
        return os.path.join(self.folder, name)

    def good(self, case, *words):
        done = drill(case, *words)
        self.assertEqual(0, done.returncode, done.stderr)
        return done

    def refused(self, said, case, *words, status=2):
        """One line, with no traceback, that holds these words."""
        done = drill(case, *words)
        self.assertEqual(status, done.returncode, done.stdout + done.stderr)
        lines = done.stderr.strip().splitlines()
        self.assertEqual(1, len(lines), done.stderr)
        self.assertIn(said, lines[0])

    def replayed(self, case, *words):
        """The table of a replay as numbers, and what was reported."""
        table = self.file('t.json')
        done = self.good(case, 'replay', *words, '--json', table)
        with open(table, encoding='utf-8') as text:
            return json.load(text), done.stderr


class Plans(Case):
    def test_01_a_plan_is_read_by_the_rules_of_surveys(self):
        for plan in ('dec_comma.csv', 'nan.csv', 'dupcol.csv'):
            survey = drill('01_plan_read_by_other_rules', 'survey', plan)
            self.assertEqual(2, survey.returncode)
            self.refused(survey.stderr.strip().splitlines()[0].split(': ', 1)[1], '01_plan_read_by_other_rules', 'score', 'run.csv', '--plan', plan)
            self.refused(plan + ':', '01_plan_read_by_other_rules', 'score', 'run.csv', '--plan', plan, '--json', self.file('s.json'))
        said = self.good('01_plan_read_by_other_rules', 'score', 'run.csv', '--plan', 'good.csv').stdout
        self.assertEqual(0.0, float(re.search(r'distance to plan, largest +(\S+) m', said).group(1)))

    def test_18_encodings_are_read_alike_everywhere(self):
        case = '18_encodings_differ_by_tool'
        for words in (('check', 'w_latin.yaml'), ('survey', 'latin.csv')):
            self.assertIn('latin-1', self.good(case, *words).stderr, words)
        run = os.path.join(CASES, '01_plan_read_by_other_rules/run.csv')
        self.assertIn('latin-1', self.good(case, 'score', run, '--plan', 'latin.csv').stderr)


    @fits
    def test_18_encodings_of_a_fit(self):
        self.assertIn('latin-1', self.good('18_encodings_differ_by_tool', 'calibrate', 'fw_latin.yaml').stderr)


class Records(Case):
    def test_02_a_log_by_depth_is_not_played_as_time(self):
        self.refused('its index is measured depth', '02_depth_log_taken_for_time', 'replay', 'depth_log.xml', 'q.yaml')

    def test_03_all_log_data_is_read(self):
        whole, _ = self.replayed('08_witsml_shapes', 'decreasing.xml', 'q.yaml')
        self.assertEqual(whole, self.replayed('03_later_logdata_dropped', 'two_logdata.xml', 'q.yaml')[0])
        self.assertEqual(whole, self.replayed('08_witsml_shapes', 'v1311.xml', 'q.yaml')[0])

    def test_03_several_files_are_joined_by_time(self):
        with open(os.path.join(CASES, '07_dates/pason.csv'), encoding='utf-8') as text:
            rows = [line.rstrip('\n').split(',') for line in text]
        for name, columns in (('one.csv', (0, 1, 3, 4)), ('two.csv', (0, 1, 5, 6, 7, 8, 9))):
            with open(self.file(name), 'w', encoding='utf-8') as out:
                out.writelines(','.join(row[k] for k in columns) + '\n' for row in rows)
        whole, _ = self.replayed('07_dates', 'pason.csv', 'q.yaml')
        self.assertEqual(whole, self.replayed('07_dates', self.file('one.csv'), 'q.yaml', '--with', self.file('two.csv'))[0])

    def test_04_nulls_are_no_numbers(self):
        for words in (('hk_null_curve.xml', 'q.yaml'), ('null_9999_25.csv', 'q.yaml', '--columns', 'map.yaml')):
            table, said = self.replayed('04_nulls_taken_for_numbers', *words)
            self.assertLess(table['hook_load']['largest'], 30e3)
            self.assertIn('hook_load: 1 of 121 rows hold no measurement', said)

    def test_05_a_map_holds_for_xml(self):
        case = '05_columns_ignored_for_xml'
        table, _ = self.replayed(case, 'wits_names.xml', 'q.yaml', '--columns', 'map_wits.yaml')
        self.assertLess(table['hook_load']['largest'], 30e3)
        with open(self.file('m.yaml'), 'w', encoding='utf-8') as out:
            out.write('time: {column: TIME}\nhook_load: {column: NOT_THERE}\n')
        self.refused('columns: TIME, DBTM, DMEA, BPOS, HKLA', case, 'replay', 'wits_names.xml', 'q.yaml', '--columns', self.file('m.yaml'))

    def test_06_units_of_the_dictionary_and_ambiguous_ones(self):
        table, _ = self.replayed('06_units', 'volve_kkgf.xml', 'q.yaml')
        self.assertLess(table['hook_load']['largest'], 30e3)
        table, _ = self.replayed('06_units', 'unit_HKLD_daN.xml', 'q.yaml')
        self.assertAlmostEqual(2214.5 - 2052.0, table['hook_load']['range'], delta=20.0)  # the file says daN of what was kN
        self.refused('tonfUS (2000 lbf), tonfUK (2240 lbf) or 1000 kgf', '06_units', 'replay', 'ustons.csv', 'q.yaml', '--columns', 'map_tonf.yaml')

    def test_07_the_first_cell_that_is_no_date_is_shown(self):
        for record, columns, cell in (('us.csv', 'map.yaml', 'us.csv:2: Time: 07/31/2017 11:59:00 PM'), ('pason.csv', 'mapP.yaml', 'pason.csv:2: HH:MM:SS: 23:59:00')):
            self.refused(cell, '07_dates', 'replay', record, 'q.yaml', '--columns', columns)
        self.replayed('07_dates', 'pason.csv', 'q.yaml')
        with open(os.path.join(CASES, '07_dates/map.yaml'), encoding='utf-8') as text, open(self.file('m.yaml'), 'w', encoding='utf-8') as out:
            out.write(text.read().replace('unit: date', 'unit: date, format: "%m/%d/%Y %I:%M:%S %p"'))
        self.replayed('07_dates', 'us.csv', 'q.yaml', '--columns', self.file('m.yaml'))

    def test_09_ragged_rows(self):
        self.refused('ragged.csv:2: has 10 cells, the header 9', '09_ragged_rows', 'replay', 'ragged.csv', 'q.yaml', '--columns', 'map.yaml')

    @fits
    def test_09_ragged_rows_of_a_table(self):
        self.refused('t_short.csv:4: has 2 cells, the header 4', '09_ragged_rows', 'calibrate', 'fit_t_short.yaml')
        self.refused('37_ragged_table.csv:3: has 2 cells, the header 3', '23_units_and_tables', 'calibrate', '37_ragged_fit.yaml')

    def test_21_a_record_of_its_own(self):
        table, said = self.replayed('21_replay_of_own_record', 'hoist.csv', 'hoist_replay.yaml')
        self.assertLess(table['hook_load']['rms'], 2e3, said)

    def test_23_units_dates_and_tables(self):
        scene, case = '../02_depth_log_taken_for_time/q.yaml', '23_units_and_tables'
        self.refused('SURF_RPM', case, 'replay', '01_rpm_c_per_s.xml', scene)
        self.refused('data row 61: its time is', case, 'replay', '17c_far_time.xml', scene)
        self.refused('25_date_only.csv:2: Time: 2020-11-02Z', case, 'replay', '25_date_only.csv', scene, '--columns', 'map.yaml')


class Surveys(Case):
    def test_10_names_units_and_delimiters(self):
        case = '10_survey_import'
        feet = self.good(case, 'survey', 'names_units.csv').stdout
        self.assertIn('304.80', feet)
        self.assertIn('500.00', self.good(case, 'survey', 'tabs.csv').stdout)
        self.assertIn('1524.00', self.good(case, 'survey', 'traj.xml').stdout)
        self.refused('euro_names.csv:1:', case, 'survey', 'euro_names.csv')
        with open(self.file('m.yaml'), 'w', encoding='utf-8') as out:
            out.write('columns: {md: {column: MD, unit: m}}\n')
        self.assertIn('2000.00', self.good(case, 'survey', 'euro_names.csv', '--columns', self.file('m.yaml')).stdout)

    def test_11_a_hole_above_the_table(self):
        self.refused('above the rotary table', '11_hole_above_ground', 'survey', 'uphole.csv')
        self.refused('above the rotary table', '11_hole_above_ground', 'check', 'uphole.yaml')

    def test_19_harmless_stations(self):
        for name in ('dup_same.csv', 'missing_azi_vertical.csv', 'nulls.csv'):
            self.refused('--pass-over', '19_harmless_stations_refused', 'survey', name)
            self.assertTrue(self.good('19_harmless_stations_refused', 'survey', name, '--pass-over').stderr)

    def test_20_the_bit_below_the_last_station(self):
        case = '20_bit_below_last_survey'
        self.refused('well.project', case, 'check', 'swd_td.yaml')
        for how in ('straight', 'curvature'):
            self.assertIn('projected', self.good(case, 'check', 'swd_td.yaml', '--set', 'well.project=' + how).stderr)


class Statics(Case):
    def test_12_slack_off_of_pipe_that_buckles(self):
        """Other frictions: slackOffOfBuckledPipe in test_sim_static_report."""
        said = self.good('12_slack_off_finds_no_equilibrium', 'static', 'ers.yaml', '--motion', 'down', '--set', 'well.sections[0].friction=0.1').stdout
        self.assertAlmostEqual(102.7, 1e-3 * float(re.search(r'of the string +(\S+) N', said).group(1)), delta=4.0)

    def test_13_no_stick_slip_where_nothing_rubs(self):
        done = self.good('13_stick_slip_told_without_friction', 'run', 'react.yaml', '--duration', '70')
        self.assertNotIn('stick', done.stdout + done.stderr)

    def test_13_the_reactive_twist_is_that_of_the_torque_on_bit(self):
        """At 70 s the bit is 0.2 m above bottom. Drilling, 236 N m twist 1.4 km of pipe with G J of 0.94 MN m2 by 20.6 deg, about which nothing damps the swing."""
        rows = self.file('react.csv')
        self.good('13_stick_slip_told_without_friction', 'run', 'react.yaml', '--duration', '330', '--set', 'numerics.companion=none', '--csv', rows, '--every', '0.5')
        with open(rows, encoding='utf-8') as table:
            late = [row for row in csv.DictReader(table) if float(row['time']) > 150.0]
        toolface = [math.degrees(float(row['toolface'])) for row in late]
        self.assertAlmostEqual(-20.61, sum(toolface) / len(toolface), delta=0.7)

    def test_24_starts_are_found(self):
        for scene in ('refused_51.yaml', 'refused_69.yaml'):
            self.good('24_wrong_without_a_warning', 'run', scene, '--duration', '0.5')


class Instruments(Case):
    def test_17_what_is_not_zeroed_is_empty(self):
        log = self.file('rec.xml')
        self.good('17_witsml_weight_zero_untared', 'run', 'q.yaml', '--duration', '120', '--witsml', log)
        with open(log, encoding='utf-8') as text:
            document = text.read()
        names = re.search('<mnemonicList>(.*?)<', document).group(1).split(',')
        for row in re.findall('<data>(.*?)<', document):
            cells = row.split(',')
            self.assertEqual('', cells[names.index('WOB')])
            self.assertEqual('', cells[names.index('DIFP')])


if __name__ == '__main__':
    drill_program = os.path.abspath(sys.argv.pop(1))
    unittest.main()
