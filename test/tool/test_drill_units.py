#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The runner's units: settings that carry one, and `--units` of the commands that print.

Usage: test_drill_units.py PATH_TO_DRILL
"""
import json
import math
import os
import re
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import test_drill  # noqa: E402 (leaves nothing behind)

QUICK, OILFIELD = test_drill.QUICK, os.path.join(test_drill.SOURCE, 'config/scenes/oilfield.yaml')
WITH_CUTTINGS = """name: cuttings
well: {stations: [[0, 0, 0], [300, 0, 0], [1000, 70, 0], [1500, 70, 0]], hole_depth: 1500, sections: [{to: 1500, diameter: 0.2159, friction: 0.2}]}
formation: [{to_tvd: 5000, drillability: 6.0e-8}]
mud: {density: 1200, rheology: {law: bingham, plastic_viscosity: 15 cP, yield_point: 10 lb/100ft2}, cuttings: {}}
string:
  - {name: bit, type: bit, length: 0.3, mass: 50, diameter: 0.2159, nozzles: [14, 14, 14, 14]}
  - {name: pipe, type: pipe, joints: fill, joint_length: 9.5, outer_diameter: 0.127, inner_diameter: 0.1086, linear_mass: 32}
rig: {mud_pump: {max_flow: 0.04}}
start: {bit_depth: 1499}
"""


class Units(test_drill.Drill):
    def test_settings_carry_units(self):
        self.assertEqual(self.succeed('check', QUICK, '--set', 'mud.density=1198.2642731689663'), self.succeed('check', QUICK, '--set', 'mud.density=10 ppg'))
        self.assertEqual('setting: mud.density: psi is a pressure; allowed: kg/m3, g/cm3, ppg, lbm/ft3\n', self.refuse('check', QUICK, '--set', 'mud.density=10 psi'))

    def test_ambiguous_units_are_refused_with_the_choices(self):
        for setting, allowed in (('start.weight_on_bit=1 tonf', 'tonfUS (2000 lbf), tonfUK (2240 lbf) or 1000 kgf (tf)'), ('start.weight_on_bit=1 mN', 'MN or N'),
                                 ('rig.mud_pump.relief_pressure=35 mPa', 'MPa or Pa'), ('rig.top_drive.max_torque=9 tonf-ft', 'tonfUS.ft'), ('formation[0].dip_deg=1 grad', 'gon or deg')):
            key, unit = setting.split('=')[0], setting.split(' ')[1].replace('-', '.')
            self.assertEqual('setting: %s: %s is ambiguous; allowed: %s\n' % (key, unit, allowed), self.refuse('check', QUICK, '--set', setting))

    def test_check(self):
        in_si, shown = self.succeed('check', OILFIELD), self.succeed('check', OILFIELD, '--units', 'oilfield')
        self.assertEqual(in_si, self.succeed('check', OILFIELD, '--units=si'))
        for line in ('4 stations to 1500.00 ft, hole 1500.00 ft deep', 'dogleg      at most 2.00 deg/100 ft, from 500.00 to 1100.00 ft', 'part             type       from bit ft      to ft     mass lbm',
                     'bit at 1498.00 ft, block at 80.00 ft, hook load ', ' klbf, of which the string ', 'mud         9.50 ppg, ', ' bbl in the annulus\n', 'losses      at 800 gpm: bore ', ' psi by pressure_coefficient', ' ft.lbf.s/rad, I ',
                     'mesh        elements of 15.58 ft up to ', ' ft above the bit by numerics.tolerance (0.02), of 31.17 ft above that'):
            self.assertIn(line, shown)
        kilonewton, klbf = (float(re.search(r'hook load ([\d.]+) k', text).group(1)) for text in (in_si, shown))
        self.assertAlmostEqual(kilonewton, 4.4482216 * klbf, delta=0.3)
        for text in (in_si, shown):
            total = re.search(r'\nstring +([\d.]+) +(\d+)\n', text)
            self.assertAlmostEqual(1578.0, float(total.group(1)) / (0.3048 if text is in_si else 1.0), delta=0.05)
        self.assertIn("'imperial' is not known, allowed: si or oilfield", self.refuse('check', OILFIELD, '--units', 'imperial'))

    def test_check_prints_the_flow_curve_in_its_units(self):
        scene = self.file('mud.yaml')
        with open(scene, 'w', encoding='utf-8') as out:
            out.write(WITH_CUTTINGS)
        self.assertIn('yield stress 4.79 Pa, consistency 0.015 Pa s^n, index 1; plastic viscosity 15 mPa s\n', self.succeed('check', scene))
        self.assertIn('yield stress 10.0 lbf/100ft2, consistency 0.015 Pa s^n, index 1; plastic viscosity 15.0 cP\n', self.succeed('check', scene, '--units', 'oilfield'))

    def test_zero_has_no_sign(self):
        for motion in ('none', 'up', 'down'):
            for units in ('si', 'oilfield'):
                self.assertNotRegex(self.succeed('static', OILFIELD, '--motion', motion, '--units', units), r'-0\.0+ k?(N m|ft\.lbf)')

    def test_check_prints_the_flow_that_carries_cuttings(self):
        scene = self.file('cuttings.yaml')
        with open(scene, 'w', encoding='utf-8') as out:
            out.write(WITH_CUTTINGS)
        pattern = r'^cuttings    gather at (\S+) \S+ below a flow of (\S+) \S+ at 0 rpm \(.*, 70 deg\), (\S+) \S+ at 60 rpm .*, (\S+) \S+ at 120 rpm .*$'
        in_si, shown = (re.search(pattern, self.succeed('check', scene, *units), re.M).groups() for units in ((), ('--units', 'oilfield')))
        self.assertEqual('20', in_si[0])
        self.assertAlmostEqual(20.0 / 0.3048, float(shown[0]), delta=0.1)
        flows = [float(flow) for flow in in_si[1:]]
        self.assertGreater(flows[0], flows[1])
        self.assertGreater(flows[1], flows[2])
        for flow, gallons in zip(flows, shown[1:]):
            self.assertAlmostEqual(flow, 6.30902e-5 * float(gallons), delta=1e-4)
        self.assertNotIn('is less', self.succeed('check', scene))
        self.assertIn("            the pump's largest flow, 0.01 m3/s, is less: keep the rate of penetration lower\n", self.succeed('check', scene, '--set', 'rig.mud_pump.max_flow=0.01'))

    def test_check_prints_what_temperature_makes_of_the_mud(self):
        scene = self.file('warm.yaml')
        with open(scene, 'w', encoding='utf-8') as out:
            out.write(WITH_CUTTINGS.replace('cuttings: {}', 'temperature: {}'))
        pattern = (r'^temperature (\S+) degC in the rock at the bit; after 6 h at 0.04 m3/s: (\S+) degC at the bit, (\S+) degC in the flow line\n'
                   r'            then plastic viscosity (\S+) mPa s at the bit \(15 mPa s at 49 degC\), stand pipe (\S+) MPa, ecd (\S+) kg/m3; '
                   r'at rest at the start (\S+) kg/m3$')
        rock, bit, flow_line, viscosity, stand_pipe, ecd, rest = map(float, re.search(pattern, self.succeed('check', scene), re.M).groups())
        depth = 300.0 + 700.0 / math.radians(70.0) * math.sin(math.radians(70.0)) + 499.0 * math.cos(math.radians(70.0))
        self.assertAlmostEqual(15.0 + 0.03 * depth, rock, delta=0.06)
        self.assertTrue(30.0 < bit < rock and 30.0 < flow_line < rock)
        self.assertAlmostEqual(15.0 * math.exp(1735.0 * (1.0 / (bit + 273.15) - 1.0 / 322.15)), viscosity, delta=0.06)
        self.assertTrue(rest < ecd and 3.0 < stand_pipe < 30.0)
        # expansion by the mean of the rock's temperature, compression by half the pressure at the bit
        self.assertAlmostEqual(1200.0 * math.exp(-4e-4 * (15.0 + 0.015 * depth - 30.0) + 2.2e-10 * 1200.0 * 9.80665 * depth), rest, delta=1.0)

    def test_survey(self):
        file = self.file('survey.csv')
        with open(file, 'w', encoding='utf-8') as out:
            out.write('MD (ft),Inc (deg),Azi (deg)\n0,0,0\n1000,0,0\n1100,2.5,90\n')
        shown = self.succeed('survey', file, '--units', 'oilfield').splitlines()
        self.assertIn('MD ft', shown[0])
        self.assertIn('deg/100 ft', shown[0])
        # an arc of 2.5 deg over 100 ft: 100 (1 - cos a)/a to the east, 100 sin(a)/a down
        self.assertEqual(['1100.00', '2.50', '90.00', '0.00', '2.18', '1099.97', '2.50'], shown[-1].split())
        in_si = self.succeed('survey', file).splitlines()
        self.assertEqual(['335.28', '2.50', '90.00', '0.000', '0.665', '335.270', '2.461'], in_si[-1].split())
        self.assertEqual('0.000', in_si[1].split()[5])

    def test_static(self):
        in_si, shown = self.succeed('static', OILFIELD), self.succeed('static', OILFIELD, '--units', 'oilfield')
        for name, unit, shown_unit, factor in (('hook load', 'N', 'klbf', 4448.2216), ('of the string', 'N', 'klbf', 4448.2216), ('bit side force', 'N', 'klbf', 4448.2216)):
            found = [re.search(r'^%s +([-\d.]+) (\S+?),?(?: |$)' % name, text, re.MULTILINE) for text in (in_si, shown)]
            self.assertEqual([unit, shown_unit], [one.group(2) for one in found])
            self.assertAlmostEqual(float(found[0].group(1)), factor * float(found[1].group(1)), delta=0.06 * factor, msg=name)
        self.assertIn(' kft.lbf\n', shown)
        self.assertEqual(self.succeed('static', OILFIELD, '--units', 'si'), in_si)

    def test_run(self):
        words = ('run', QUICK, '--duration', '20', *test_drill.ALONE, '--set', 'start.bit_depth=327.9 ft')
        in_si, shown = self.succeed(*words, '--json', self.file('si.json')), self.succeed(*words, '--units', 'oilfield', '--json', self.file('oilfield.json'))
        found = [re.search(r', hole ([\d.]+) (m|ft)\n', text) for text in (in_si, shown)]
        self.assertEqual(['m', 'ft'], [one.group(2) for one in found])
        self.assertAlmostEqual(float(found[0].group(1)), 0.3048 * float(found[1].group(1)), delta=0.002)
        found = [re.search(r'hook load ([\d.]+) (kN|klbf), torque ([-\d.]+) (kN m|kft\.lbf)', text) for text in (in_si, shown)]
        self.assertEqual([('kN', 'kN m'), ('klbf', 'kft.lbf')], [one.group(2, 4) for one in found])
        self.assertAlmostEqual(float(found[0].group(1)), 4.4482216 * float(found[1].group(1)), delta=0.3)
        finals = []
        for name in ('si.json', 'oilfield.json'):
            with open(self.file(name), encoding='utf-8') as text:
                finals.append(json.load(text)['final'])
        self.assertEqual(*finals)

    def test_commands_of_python_take_them(self):
        test_drill.skips.without_module(self, test_drill.drill_program)
        series = self.file('run.csv')
        self.succeed('run', QUICK, '--duration', '20', '--csv', series, *test_drill.ALONE, '--set', 'start.bit_depth=327.9 ft')
        self.assertRegex(self.succeed('score', series, '--units', 'oilfield'), r'weight on bit, mean +[\d.]+ klbf')
        self.assertRegex(self.succeed('score', series), r'weight on bit, mean +[\d.]+ kN')
        for command in ('score', 'plot', 'replay'):
            words = [command, series] + ([QUICK] if command == 'replay' else [])
            self.assertIn("'furlong' is not known, allowed: si or oilfield", self.refuse(*words, '--units', 'furlong'))
            self.assertIn('stay in SI', self.succeed(command, '--help'))


if __name__ == '__main__':
    test_drill.drill_program = os.path.abspath(sys.argv.pop(1))
    test_drill.skips.main()
