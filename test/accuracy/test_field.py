#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The field case's soft string against closed forms, its calibration on made-up weights, and the runner beside the soft string at three of
the field's depths. Usage: test_field.py PATH_TO_DRILL"""
import math
import os
import sys
import tempfile
import unittest

import numpy

HERE = os.path.dirname(os.path.abspath(__file__))
sys.dont_write_bytecode = True
sys.path[:0] = [HERE, os.path.join(os.path.dirname(HERE), 'tool')]
import field  # noqa: E402
import skips  # noqa: E402
from soft_string import GRAVITY, Hole, SoftString  # noqa: E402

WEIGHT = 300.0  # of pipe in mud [N/m]
PIPE = WEIGHT / GRAVITY / 0.85  # [kg/m]
drill_program = None


def hook_load(stations, parts, friction, sense):
    """With the string's lower end at the last station."""
    return SoftString(Hole(stations), parts, stations[-1][0], 0.85).hook_load(lambda md: friction, sense)


class ClosedForms(unittest.TestCase):
    def test_straight_inclined_hole(self):
        for sense in (1, -1, 0):
            by_hand = WEIGHT * 1000.0 * (math.cos(math.radians(50.0)) + sense * 0.3 * math.sin(math.radians(50.0)))
            self.assertAlmostEqual(hook_load([[0.0, 50.0, 120.0], [400.0, 50.0, 120.0], [1000.0, 50.0, 120.0]], [(9.0, PIPE)], 0.3, sense) / by_hand,
                                   1.0, 12)

    def test_parts_lie_from_the_bit_up_and_the_last_reaches_the_surface(self):
        load = hook_load([[0.0, 0.0, 0.0], [500.0, 0.0, 0.0]], [(20.0, 5.0 * PIPE), (100.0, 2.0 * PIPE), (9.0, PIPE)], 0.3, 1)
        self.assertAlmostEqual(load / (WEIGHT * (20.0 * 5.0 + 100.0 * 2.0 + 380.0)), 1.0, 12)

    def test_friction_is_that_of_the_depth(self):
        string = SoftString(Hole([[0.0, 90.0, 0.0], [1000.0, 90.0, 0.0]]), [(9.0, PIPE)], 800.0, 0.85)
        self.assertAlmostEqual(string.hook_load(lambda md: 0.2 if md < 300.0 else 0.5, 1) / (WEIGHT * (0.2 * 300.0 + 0.5 * 500.0)), 1.0, 12)

    def test_capstan(self):
        # 2 m of great weight hang below three bends of 90 deg, one of them sideways, and a string without weight: Euler and Eytelwein
        bends = [[0.0, 0.0, 0.0], [300.0, 90.0, 0.0], [700.0, 90.0, 90.0], [1000.0, 0.0, 90.0], [1002.0, 0.0, 90.0]]
        for sense in (1, -1, 0):
            by_hand = 2.0 * WEIGHT * 1e4 * math.exp(sense * 0.25 * 1.5 * math.pi)
            self.assertAlmostEqual(hook_load(bends, [(2.0, 1e4 * PIPE), (9.0, 1e-9 * PIPE)], 0.25, sense) / by_hand, 1.0, 3)

    def test_arc_under_its_own_weight(self):
        # dT/dI = -w R cos I - s mu (w R sin I - T), the string on the low side throughout; I falls from 90 to 60 deg on the way up
        radius, lower, upper = 800.0 / (math.pi / 6.0), math.radians(90.0), math.radians(60.0)
        for m in (0.3, -0.3, 0.0):
            a, b = WEIGHT * radius * (m * m - 1.0) / (1.0 + m * m), 2.0 * m * WEIGHT * radius / (1.0 + m * m)
            c = -(a * math.sin(lower) + b * math.cos(lower)) * math.exp(-m * lower)
            by_hand = a * math.sin(upper) + b * math.cos(upper) + c * math.exp(m * upper)
            if m == 0.0:
                self.assertAlmostEqual(by_hand, WEIGHT * radius * (math.sin(lower) - math.sin(upper)), 6)  # w times vertical depth
            mu, sense = (abs(m), 1 if m > 0.0 else -1) if m else (0.3, 0)
            self.assertAlmostEqual(hook_load([[0.0, 60.0, 30.0], [800.0, 90.0, 30.0]], [(9.0, PIPE)], mu, sense) / by_hand, 1.0, 3)


class Calibration(unittest.TestCase):
    def loads(self, friction):
        """Two depths: the shallow one feels casing alone."""
        drag = numpy.array([[20.0 * friction[0]], [30.0 * friction[0] + 80.0 * friction[1] ** 1.2]]) * field.KLBF
        return numpy.array([[50.0], [90.0]]) * field.KLBF + drag * numpy.array([[1.0, -0.8, 0.0]])

    def test_what_was_put_in_comes_out(self):
        tare, friction, errors = field.calibrate(self.loads, self.loads(numpy.array([0.1, 0.4])) + 39.0 * field.KLBF)
        self.assertAlmostEqual(tare / field.KLBF, 39.0, 6)
        numpy.testing.assert_allclose(friction, [0.1, 0.4], atol=1e-6)
        self.assertLess(max(errors), 1e-3)

    def test_weights_without_an_answer_are_left_out(self):
        measured = self.loads(numpy.array([0.1, 0.4])) + 39.0 * field.KLBF
        measured[1, 2] = numpy.nan
        numpy.testing.assert_allclose(field.calibrate(self.loads, measured)[1], [0.1, 0.4], atol=1e-6)

    def test_friction_is_never_negative(self):
        measured = self.loads(numpy.array([0.0, 0.4])) + numpy.array([[-3.0, 3.0, 0.0], [0.0, 0.0, 0.0]]) * field.KLBF
        self.assertEqual(field.calibrate(self.loads, measured)[1][0], 0.0)


@unittest.skipUnless(os.path.isdir(field.DATA), '../shared/data is absent')
class Depths(unittest.TestCase):
    def test_the_runner_stands_beside_the_soft_string(self):
        # a stiff string with clearance takes short cuts through the hole's small bends: up to 0.6 % less drag
        data = field.Field()
        depths = [data.depths[k] for k in (0, 12, 25)]
        with tempfile.TemporaryDirectory() as folder:
            ours = field.Ours(drill_program, data.scene(19.5), os.path.join(folder, 'scene.yaml'))
            loads = ours.loads(depths, numpy.array([0.14, 0.4]))
        self.assertEqual(ours.failed, [])
        numpy.testing.assert_allclose(loads, field.Soft(data, 19.5).loads(depths, numpy.array([0.14, 0.4])), rtol=0.01)


if __name__ == '__main__':
    if len(sys.argv) < 2 or not os.access(sys.argv[1], os.X_OK):
        print(__doc__, file=sys.stderr)
        sys.exit(2)
    drill_program = os.path.abspath(sys.argv.pop(1))
    skips.main()
