#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""What the programs print of the scenes on the manual's pages, against hand formulas.

Usage: test_numbers.py DRILL
"""
import math
import os
import re
import subprocess
import sys
import tempfile
import unittest

SOURCE = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.dont_write_bytecode = True
sys.path[:0] = [os.path.join(SOURCE, 'src', 'manual'), os.path.dirname(os.path.abspath(__file__))]
import pages  # noqa: E402
import test_texts  # noqa: E402

FOOT, INCH, POUND, GRAVITY, PSI = 0.3048, 0.0254, 0.45359237, 9.80665, 6894.757
KLBF = 1e3 * POUND * GRAVITY
GALLON = 231.0 * INCH**3
drill = 'drill'


class Page(unittest.TestCase):
    """The files of a page, in a folder of their own."""

    def open(self, name):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.place = pages.Workplace(folder.name)
        for block in pages.blocks(test_texts.read(name)):
            if block.kind == 'file':
                self.place.write(block.argument, block.content)

    def printed(self, *words):
        done = subprocess.run([drill, *words], cwd=self.place.folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, check=False)
        self.assertEqual(0, done.returncode, done.stderr)
        return done.stdout


class WellReport(Page):
    """The string of the page from the bit up, [ft, lb/ft, bore and outside in]; build from 2000 to 3200 ft to 30 deg."""
    BIT, TABLE, SHOE, DENSITY = 8390.0, 60.0, 6000.0, 10.2 * POUND / GALLON
    ASSEMBLY = ((0.9, 100.0 / 0.9, 8.5, 8.5), (5.3, 98.0, 2.8125, 6.75), (31.5, 92.0, 3.25, 6.75), (276.3, 100.5, 2.8125, 6.75), (457.5, 49.7, 3.0, 5.0))
    PIPE, FLOW, VISCOSITY, YIELD = 22.6, 520.0 * GALLON / 60.0, 0.018, 14.0 * POUND * GRAVITY / (100.0 * FOOT**2)

    def setUp(self):
        self.open('how_to/well_report.md')

    def linear_mass(self, from_bit):
        for length, mass, _, _ in self.ASSEMBLY:
            if from_bit < length:
                return mass
            from_bit -= length
        return self.PIPE

    def soft_string(self, way):
        """Hook load without block [N], of a string that slides up (1), down (-1) or turns (0): Johancsik, Friesen and Dawson (1984)."""
        def inclination(md):
            return math.radians(min(max((md - 2000.0) * 0.025, 0.0), 30.0))
        tension, buoyancy = 0.0, 1.0 - self.DENSITY / 7850.0
        for k in range(int(self.BIT)):
            md = self.BIT - k - 0.5
            weight = self.linear_mass(k + 0.5) * POUND * GRAVITY * buoyancy
            across = (tension + 0.5 * weight) * (inclination(md + 0.5) - inclination(md - 0.5)) - weight * math.sin(inclination(md))
            tension += weight * math.cos(inclination(md)) + way * (0.2 if md < self.SHOE else 0.3) * abs(across)
        return tension + self.TABLE * self.PIPE * POUND * GRAVITY

    def test_hook_loads(self):
        # sliding: the soft string leaves out how bit and stabilizer push each other off the wall, 25 kN
        for motion, way, share in (('rotate', 0, 0.003), ('up', 1, 0.012), ('down', -1, 0.012)):
            text = self.printed('static', 'report.yaml', '--motion', motion)
            load = float(re.search(r'of the string +([0-9.]+) N', text).group(1))
            self.assertAlmostEqual(1.0, load / self.soft_string(way), delta=share, msg=motion)

    def slot(self, length, hole, pipe):
        """Pressure loss of laminar flow of a Bingham mud in a slot [Pa], by bisection of the stress at its walls."""
        gap, speed = 0.5 * (hole - pipe) * INCH, self.FLOW / (0.25 * math.pi * (hole**2 - pipe**2) * INCH**2)
        low, high = self.YIELD, 1e3
        for _ in range(100):
            stress = 0.5 * (low + high)
            core = self.YIELD / stress
            fast = gap * stress / (6.0 * self.VISCOSITY) * (1.0 - 1.5 * core + 0.5 * core**3) > speed
            low, high = (low, stress) if fast else (stress, high)
        return 2.0 * high / gap * length * FOOT

    def bore(self, length, diameter):
        """Of turbulent flow [Pa]: Blasius."""
        speed = self.FLOW / (0.25 * math.pi * (diameter * INCH)**2)
        friction = 0.0791 / (self.DENSITY * speed * diameter * INCH / self.VISCOSITY)**0.25
        return 2.0 * friction * self.DENSITY * speed**2 / (diameter * INCH) * length * FOOT

    def test_pressures(self):
        text = self.printed('check', 'report.yaml', '--units', 'oilfield')
        bore, bit, annulus = [float(part) for part in re.search(r'bore (\d+) psi, bit (\d+) psi, annulus (\d+) psi', text).groups()]
        area = 6.0 * 0.25 * math.pi * (12.0 / 32.0 * INCH)**2
        self.assertAlmostEqual(self.DENSITY * (self.FLOW / (0.95 * area))**2 / 2.0 / PSI, bit, delta=1.0)
        self.assertAlmostEqual(578.0, 10.2 * 520.0**2 / (12042.0 * 0.95**2 * 0.663**2), delta=1.0)
        tubes = self.ASSEMBLY[1:]
        pipe = self.BIT - sum(part[0] for part in self.ASSEMBLY)
        by_hand = sum(self.bore(part[0], part[2]) for part in tubes) + self.bore(pipe + self.TABLE, 4.276)
        self.assertAlmostEqual(1.0, bore / (by_hand / PSI), delta=0.01)
        laminar = sum(self.slot(part[0], 8.5, part[3]) for part in tubes) + self.slot(pipe - self.SHOE, 8.5, 5.0) + self.slot(self.SHOE, 8.681, 5.0)
        self.assertGreater(annulus, laminar / PSI)
        self.assertLess(annulus, 1.07 * laminar / PSI)  # around the collars the flow is turbulent

    def test_strokes_of_two_pumps(self):
        gallons = 2.0 * 3.0 * 0.25 * math.pi * 6.0**2 * 12.0 * 0.97 / 231.0
        self.assertAlmostEqual(8.55, gallons, delta=0.005)
        self.assertIn('stroke_volume: 8.55 galUS', test_texts.read('how_to/well_report.md'))


class WeightLaw(Page):
    """The law of the page holds its weight, and the figures below it are right."""

    def setUp(self):
        self.open('how_to/controller_python.md')

    def weight(self, change=lambda text: text):
        for name in ('weight_law.py', 'run_weight_law.py'):
            with open(os.path.join(self.place.folder, name), encoding='utf-8') as file:
                self.place.write(name, change(file.read()))
        return float(re.match(r'([0-9.]+) kN', self.place.run('python3 run_weight_law.py')).group(1))

    def test_weight_is_held(self):
        self.assertAlmostEqual(60.0, self.weight(), delta=1.2)

    def test_a_wrong_zero_is_found(self):
        self.assertNotAlmostEqual(60.0, self.weight(lambda text: text.replace('15.0 <= readings.t < 25.0', '0.2 <= readings.t < 1.0')), delta=1.2)

    def test_figures(self):
        lines, efficiency = 10, 0.98
        self.assertAlmostEqual(1.093, lines / sum(efficiency**i for i in range(lines)), delta=0.001)
        self.assertAlmostEqual(7.0e8, 206e9 * 0.25 * math.pi * (0.127**2 - 0.1086**2), delta=0.03e8)
        # error after a step with gain 1/(kT) and reset time 2T, rock that does not give way: exp(-x) (cos x - sin x), x = t/(2T)
        self.assertAlmostEqual(0.21, -min(math.exp(-x) * (math.cos(x) - math.sin(x)) for x in [0.01 * i for i in range(500)]), delta=0.005)


if __name__ == '__main__':
    if len(sys.argv) > 1:
        drill = os.path.abspath(sys.argv.pop(1))
    unittest.main()
