#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The numbers that the offline runner prints, against sums by hand. Usage: test_drill_values.py PATH_TO_DRILL"""
import csv
import math
import os
import pty
import re
import subprocess
import sys
import unittest

import test_drill
from test_drill import BOHAI, QUICK, SOURCE

GRAVITY, STEEL = 9.80665, 7850.0


class Check(test_drill.Drill):
    def test_the_string_is_listed_part_by_part(self):
        rows = [line.split() for line in self.succeed('check', QUICK).splitlines()]
        # two collars of 9.4 m at 136 kg/m on a bit of 0.3 m; pipe at 31.9 kg/m up to the drive, 99.7 m of hole and 20 m of air above the bit
        self.assertIn(['bit', 'bit', '0.00', '0.30', '40'], rows)
        self.assertIn(['collar', 'collar', '0.30', '19.10', '%.0f' % (136.0 * 18.8)], rows)
        self.assertIn(['drill_pipe', 'pipe', '19.10', '119.70', '%.0f' % (31.9 * 100.6)], rows)
        self.assertIn(['string', '119.70', '%.0f' % (40.0 + 136.0 * 18.8 + 31.9 * 100.6)], rows)

    def test_static_reports_a_bent_motor_that_does_not_fit(self):
        tight = ('--set', 'string[1].sleeve_diameter=0.309', '--set', 'string[1].bit_to_sleeve=0.9')
        self.assertIn('assembly warning: the bent motor does not fit into its hole', self.succeed('static', BOHAI, *tight))
        self.assertNotIn('assembly warning', self.succeed('static', BOHAI))

    def test_check_names_the_key_that_decides_the_mesh(self):
        def mesh(*words):
            return [line for line in self.succeed('check', BOHAI, *words).splitlines() if line.startswith('mesh ')][0]
        self.assertRegex(mesh(), r'elements of 4.75 m up to \d+ m above the bit by numerics.tolerance \(0.02\), of 9.5 m above that')
        self.assertIn('of 3.17 m up to', mesh('--set', 'numerics.tolerance=0.01'))
        self.assertIn('of 4 m by numerics.element_length, whatever the tolerance', mesh('--set', 'numerics.element_length=4'))
        self.assertIn('of 4 m by numerics.element_length', mesh('--set', 'numerics.element_length=4', '--set', 'numerics.tolerance=0.01'))

    def test_friction_of_new_hole_is_told_from_the_bottom_down(self):
        self.assertNotIn('new hole', self.succeed('check', QUICK))
        rock = ', '.join('{to_tvd: %d, drillability: 1e-8%s}' % layer for layer in ((50, ', friction: 0.2'), (120, ', friction: 0.25'), (300, ''), (999, ', friction: 0.35')))
        text = self.succeed('check', QUICK, '--set', 'formation=[%s]' % rock)
        self.assertIn("new hole    friction 0.25 to 120 m TVD, that of its section to 300 m TVD, 0.35\n", text)

    def test_what_a_scene_leaves_out_is_told(self):
        text = self.succeed('check', QUICK)
        self.assertNotIn('regenerative', text)
        self.assertNotIn('deep in the wall', text)
        self.assertIn('face does not rub', self.succeed('check', QUICK, '--set', 'string[0].torque={model: regenerative}'))
        motor = ('{name: motor, type: mud_motor, length: 8.3, outer_diameter: 0.2032, inner_diameter: 0.12, linear_mass: 190, bend_deg: 1.25, '
                 'bit_to_bend: 2, displacement_per_rev: 0.024, stall_torque: 12000}')
        pipe = ('{name: pipe, type: pipe, joints: fill, joint_length: 9.5, outer_diameter: 0.127, inner_diameter: 0.1086, linear_mass: 31.9, '
                'tool_joint_diameter: 0.168}')
        bit = '{name: bit, type: bit, length: 0.3, mass: 40, diameter: 0.2159}'
        words = ('--set', 'string=[%s, %s, %s]' % (bit, motor, pipe))
        self.assertRegex(self.succeed('check', QUICK, *words), 
                         r'wall +motor is [0-9.]+ mm deep in the wall 2 m above the bit: side forces are too small; use contact: \{stiffness: 2e\+10\} in')
        self.assertNotIn('deep in the wall', self.succeed('check', QUICK, *words, '--set', 'contact.stiffness=2e10'))
        for stiffness in ('1e4', '5e6'):
            text = self.succeed('check', QUICK, *words, '--set', 'numerics.level=beam3d', '--set', 'contact.stiffness=' + stiffness)
            would_do = re.search('use contact.stiffness: (.*) or more', text).group(1)
            text = self.succeed('check', QUICK, *words, '--set', 'numerics.level=beam3d', '--set', 'contact.stiffness=' + would_do)
            self.assertNotIn('deep in the wall', text)
        pads = words + ('--set', 'string[1].outer_diameter=0.1715', '--set', 'string[1].linear_mass=95', '--set', 'string[0].gauge_length=0.15')
        self.assertIn('pads are wedged in the hole', self.succeed('check', QUICK, *pads))
        self.assertNotIn('wedged', self.succeed('check', QUICK, *pads, '--set', 'string[0].gauge_clearance=2e-3'))

    def test_a_hole_that_leaves_the_upright_rig_inclined_is_told(self):
        self.assertNotIn('accuracy', self.succeed('check', QUICK))
        self.assertIn('accuracy    the hole is inclined by 12 deg at the rotary table',
                      self.succeed('check', QUICK, '--set', 'well.stations=[[0, 12, 0], [100, 12, 0]]'))

    def test_what_leaves_the_bit_some_pressure_is_told(self):
        def coefficient(value):
            return self.succeed('check', QUICK, '--set', 'rig.mud_pump.pressure_coefficient=%.3g' % value)
        told = re.search('is too small for any pressure drop at the bit; use more than ([0-9.e+]+)', coefficient(1e4))
        self.assertIn('is too small for any', coefficient(0.99 * float(told.group(1))))
        self.assertNotIn('is too small for any', coefficient(1.01 * float(told.group(1))))
        short = ('run', QUICK, '--duration', '3', '--set', 'rig.mud_pump.pressure_coefficient=1e4', '--set')
        self.assertIn('pressures: at the pump', self.succeed(*short, 'program=[{at: 0, flow: 0.03}]'))
        self.assertNotIn('pressures:', self.succeed(*short, 'program=[]'))

    def test_losses_above_the_relief_valve_are_reported(self):
        def check(relief):
            return self.succeed('check', QUICK, '--set', 'rig.mud_pump.relief_pressure=%g' % relief)
        stand_pipe = 1e6 * float(re.search(r'stand pipe ([\d.]+) MPa', check(35e6)).group(1))
        self.assertIn('the relief valve opens below that flow', check(0.95 * stand_pipe))
        self.assertNotIn('relief valve', check(1.05 * stand_pipe))

    def test_the_annulus_by_the_viscosity_is_told_beside_the_rule_of_thumb(self):
        """8 1/2 by 5 in, 50 l/s of 10 mPa s: the friction of a rough wall, 0.0133, is 1.87 times API RP 13D's. A difference below 0.2 MPa is left out."""
        def check(length, *more):
            return self.succeed('check', QUICK, '--set', 'well.stations=[[0, 0, 0], [%g, 0, 0]]' % length, '--set', 'well.hole_depth=%g' % length,
                                '--set', 'well.sections[0].to=%g' % length, '--set', 'start.bit_depth=%g' % length, '--set', 'rig.mud_pump.max_flow=0.05',
                                '--set', 'mud.viscosity=0.01', '--set', 'mud.density=1200', *more)
        losses = re.search(r'annulus ([\d.]+) MPa.*\n *the annulus\'s loss is a rule of thumb, ([\d.]+) MPa by mud.viscosity', check(2000))
        self.assertAlmostEqual(1.87, float(losses.group(1)) / float(losses.group(2)), delta=0.05)
        self.assertNotIn('rule of thumb', check(100))
        self.assertNotIn('rule of thumb', check(2000, '--set', 'mud.rheology={law: newtonian}', '--set', 'string[0].nozzle_area=4e-4'))

    def test_a_speed_that_limits_the_weight_is_told(self):
        """1 mm/s of the block on rock that gives way at 12 mm/s under 10 kN: 0.8 kN."""
        drill = 'operations=[{do: flow, flow: 0.02}, {do: rotate, speed_rpm: 90}, {do: tag, weight: 2 kN}, {do: drill, weight: 10 kN, distance: 5 m, speed: %g}]'
        run = ('run', QUICK, '--duration', '150', '--set', 'program=[]', '--set')
        said = re.search(r'operations: number 4, drill: its speed of 0.001 m/s limited the weight on bit to ([\d.]+) kN for ([\d.]+) s \(weight: 10.0 kN\); '
                         'needed for more: a larger speed\n', self.succeed(*run, drill % 0.001))
        self.assertAlmostEqual(0.83, float(said.group(1)), delta=0.15)
        self.assertGreater(float(said.group(2)), 60.0)
        self.assertNotIn('limited the weight', self.succeed(*run, drill % 0.05))
        check = ('check', QUICK, '--set', 'program=[]', '--set')
        known = re.search(r'operations: number 4, drill: its speed of 0.001 m/s limits the weight on bit to ([\d.]+) kN \(weight: 10.0 kN\); needed for more: a larger speed\n',
                          self.succeed(*check, drill % 0.001))
        self.assertAlmostEqual(1e-3 / (1.3e-7 * 90.0 * math.pi / 30.0) / 1e3, float(known.group(1)), delta=0.06)
        for words in ((drill % 0.05,), (drill.replace('distance: 5 m', 'distance: 0.05 m') % 0.001,), (drill.replace('speed_rpm: 90', 'speed_rpm: 0') % 0.001,)):
            self.assertNotIn('the weight on bit to', self.succeed(*check, *words))

    def test_every_kind_of_part_has_its_word(self):
        string = ('[{name: a, type: bit, length: 0.3, mass: 40, diameter: 0.2159}, '
                  '{name: b, type: mud_motor, length: 8, outer_diameter: 0.165, inner_diameter: 0.0714, linear_mass: 120, '
                  'bend_deg: 1.0, bit_to_bend: 2.0, displacement_per_rev: 0.02, stall_torque: 9000}, '
                  '{name: c, type: stabilizer, length: 2, outer_diameter: 0.165, inner_diameter: 0.0714, linear_mass: 130, '
                  'blade_diameter: 0.21}, '
                  '{name: d, type: mwd, length: 9, outer_diameter: 0.165, inner_diameter: 0.0714, linear_mass: 130, sensor_offset: 4}, '
                  '{name: e, type: collar, joints: 1, joint_length: 9, outer_diameter: 0.165, inner_diameter: 0.0714, linear_mass: 136}, '
                  '{name: f, type: pipe, joints: fill, joint_length: 9.5, outer_diameter: 0.127, inner_diameter: 0.1086, linear_mass: 31.9, '
                  'tool_joint_diameter: 0.168}]')
        text = self.succeed('check', QUICK, '--set', 'string=' + string)
        for name, word in (('a', 'bit'), ('b', 'mud motor'), ('c', 'stabilizer'), ('d', 'mwd'), ('e', 'collar'), ('f', 'pipe')):
            self.assertRegex(text, r'\n%s +%s +\d' % (name, word))
        self.assertNotIn('no part is of type mwd', text)

    def test_well_start_model_and_program(self):
        text = self.succeed('check', QUICK)
        self.assertIn('2 stations to 100 m, hole 100 m deep, at its bottom 0.00 deg inclination, 0.00 deg azimuth\n', text)
        start = re.search(r'bit at 99.700 m, block at 20.00 m, hook load ([\d.]+) kN, of which the string ([\d.]+) kN\n', text)
        in_mud = 1.0 - 1100.0 / STEEL
        weight = GRAVITY * ((40.0 + 136.0 * 18.8 + 31.9 * 80.6) * in_mud + 31.9 * 20.0)  # what is above the table hangs in air
        self.assertAlmostEqual(float(start.group(2)), weight / 1e3, delta=0.06)
        self.assertAlmostEqual(float(start.group(1)), (weight + GRAVITY * 17500.0) / 1e3, delta=0.06)
        self.assertIn('level hybrid, integrator bdf2, variable steps by a tolerance of 0.02, 19 nodes', text)
        self.assertIn('no part is of type mwd', text)
        self.assertIn('3 lines to 35 s\n', text)
        self.assertIn('at its bottom 51.00 deg inclination, 297.00 deg azimuth\n', self.succeed('check', BOHAI))
        self.assertIn('0 lines to 0 s, 1 operations\n', self.succeed('check', QUICK, '--set', 'program=[]', '--set', 'operations=[{do: wait, time: 1}]'))
        self.assertIn('0 lines to 0 s\n', self.succeed('check', QUICK, '--set', 'program=[]'))


class Survey(test_drill.Drill):
    def test_an_arc_and_its_tangent(self):
        """3 deg in 30 m towards 30 deg, from vertical to 60 deg at 600 m, and 30 m straight on."""
        with open(self.file('arc.csv'), 'w') as out:
            out.write('md_m,inclination_deg,azimuth_deg\n0,0,30\n300,30,30\n600,60,30\n630,60,30\n')
        rows = [[float(cell) for cell in line.split()] for line in self.succeed('survey', self.file('arc.csv')).splitlines()[1:]]
        radius = 300.0 / math.radians(30.0)
        for row, (md, inclination, straight) in zip(rows, ((0, 0, 0), (300, 30, 0), (600, 60, 0), (630, 60, 30)), strict=True):
            angle = math.radians(inclination)
            out = radius * (1.0 - math.cos(angle)) + straight * math.sin(angle)
            down = radius * math.sin(angle) + straight * math.cos(angle)
            severity = 0.0 if md == 0 or straight else 3.0
            expected = [md, inclination, 30.0, out * math.cos(math.radians(30.0)), out * math.sin(math.radians(30.0)), down, severity]
            for told, value in zip(row, expected, strict=True):
                self.assertAlmostEqual(told, value, delta=6e-4, msg=row)


class Static(test_drill.Drill):
    def test_static_in_moving_mud(self):
        """A named motion leaves the mud at rest; at a speed it drags on the string, and the pump lifts it."""
        def found(*words):
            lines = {line[:17].strip(): float(line[17:].split()[0]) for line in self.succeed('static', BOHAI, *words).splitlines() if line.startswith(('hook load', 'annulus'))}
            return lines['hook load'], lines.get('annulus')
        up, still = found('--motion', 'up')
        self.assertIsNone(still)
        load, pressure = found('--speed', '0.3')
        self.assertGreater(load, up)
        self.assertLess(pressure, 0.0)
        pumped, pressure = found('--speed', '0.3', '--flow', '0.03')
        self.assertLess(pumped, load)
        self.assertGreater(pressure, 0.0)
        self.assertIn('--flow', self.refuse('static', BOHAI, '--flow', '-1'))
        rule = ': a rule of thumb, whatever the viscosity; set mud.rheology\n'
        self.assertIn(rule, self.succeed('static', QUICK, '--speed', '0.3'))
        rheology = ('--set', 'mud.rheology={law: newtonian}', '--set', 'string[0].nozzle_area=4e-4')
        self.assertNotIn(rule, self.succeed('static', QUICK, '--speed', '0.3', *rheology))

    def test_profiles_at_rest_are_those_of_statics(self):
        self.succeed('static', BOHAI, '--csv', self.file('s.csv'))
        self.succeed('run', BOHAI, '--set', 'program=[]', '--duration', '2', '--profile', self.file('p.csv'), '--profile-every', '0.5')
        with open(self.file('s.csv')) as text:
            static = list(csv.reader(text))
        with open(self.file('p.csv')) as text:
            rows = list(csv.reader(text))
        self.assertEqual(rows[0], ['time'] + static[0])
        nodes = len(static) - 1
        self.assertEqual([float(row[0]) for row in rows[1::nodes]], [0.0, 0.5, 1.0, 1.5, 2.0])
        self.assertEqual([row[1:] for row in rows[1:nodes + 1]], static[1:], 'the start is the equilibrium')
        for column, name in enumerate(static[0]):
            at_rest = [float(row[column]) for row in static[1:]]
            after = [float(row[column + 1]) for row in rows[-nodes:]]
            largest = max(abs(value) for value in at_rest)
            for was, now in zip(at_rest, after, strict=True):
                if name == 'contact_side_deg':
                    now += 360.0 * round((was - now) / 360.0)
                self.assertAlmostEqual(was, now, delta=1e-6 * largest + 1e-3, msg=name)  # what Newton's method leaves

    def test_what_is_printed_is_the_strings_two_ends(self):
        text = self.succeed('static', os.path.join(SOURCE, 'test/scenes/curved_well.yaml'), '--motion', 'rotate', '--csv', self.file('s.csv'))
        told = {line[:16].strip(): line[16:] for line in text.splitlines()}
        number = {name: float(value.split()[0]) for name, value in told.items()}
        with open(self.file('s.csv')) as rows:
            bit, *_, top = [{name: float(cell) for name, cell in row.items()} for row in csv.DictReader(rows)]
        self.assertAlmostEqual(number['hook load'] - number['of the string'], 17500.0 * GRAVITY, delta=0.2)
        self.assertAlmostEqual(number['torque'], top['torque'], delta=0.06)
        self.assertAlmostEqual(number['bit side force'], bit['contact_force'], delta=0.06)
        self.assertIn('at %.1f deg clockwise from the high side' % bit['contact_side_deg'], told['bit side force'])


class Progress(test_drill.Drill):
    def test_the_bar_follows_the_run(self):
        master, slave = pty.openpty()
        run = subprocess.Popen([test_drill.drill_program, 'run', QUICK, '--duration', '200'], stdout=subprocess.DEVNULL, stderr=slave)
        os.close(slave)
        shown = b''
        try:
            while True:
                shown += os.read(master, 65536)
        except OSError:  # the other end is closed
            pass
        os.close(master)
        self.assertEqual(run.wait(300), 0)
        bars = re.findall(r'\r\[(#*)(\.*)\] +([\d.]+) s  hole +([\d.]+) m +([\d.]+)x real time\x1b\[K', shown.decode())
        self.assertGreater(len(bars), 1)
        for done, left, time, hole, _ in bars:
            self.assertEqual(len(done) + len(left), 30)
            self.assertAlmostEqual(len(done), 30.0 * float(time) / 200.0, delta=1.01)  # whole signs only
            drilled = max(0.0, float(time) - 35.0) * 0.012
            self.assertAlmostEqual(float(hole), 100.0 + drilled, delta=0.05)
        self.assertLess(float(bars[0][2]), float(bars[-1][2]))
        self.assertGreater(float(bars[-1][4]), 1.0)
        self.assertTrue(shown.endswith(b'\r\x1b[K'), 'a clean line is left')


if __name__ == '__main__':
    test_drill.drill_program = os.path.abspath(sys.argv.pop(1))
    test_drill.skips.main()
