#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The height of a recorded block as a course in time."""
import unittest

import numpy
from drill_rig_sim.field.course import Course, half_band, resolution


class Courses(unittest.TestCase):
    def test_a_course_through_a_coarse_gauge(self):
        """Slow drilling in steps of 3 cm is a constant speed, a stop is a stop, and a gauge without steps has no resolution."""
        times, fine = numpy.arange(600.0), numpy.concatenate((20.0 - 2e-3 * numpy.arange(400.0), numpy.full(200, 19.2)))
        coarse = 0.03 * numpy.round(fine / 0.03)
        self.assertAlmostEqual(0.03, resolution(coarse), places=6)
        self.assertEqual(0.0, resolution(fine + 1e-3 * numpy.random.default_rng(1).normal(size=600)))
        course = Course(times, coarse, half_band(coarse, coarse))
        speed = numpy.diff(course(times))
        self.assertLess(abs(speed[50:350] / -2e-3 - 1.0).max(), 0.3)
        self.assertEqual(0.0, abs(speed[450:]).max())
        self.assertLess(abs(course(times) - fine).max(), 0.031)

    def test_a_move_between_rows_of_a_coarse_gauge(self):
        """Rows of 5 s in steps of 3 cm: the move starts and ends between rows, with the acceleration of the rig, and the block stands before and after it."""
        fine = numpy.arange(0.0, 120.0, 0.01)
        speed = 0.35 * numpy.clip(numpy.minimum((fine - 31.2) / 0.7, (82.5 - fine) / 0.7), 0.0, 1.0)
        height = 5.0 + numpy.concatenate(([0.0], numpy.cumsum(0.5 * (speed[1:] + speed[:-1]) * 0.01)))
        times, coarse = fine[::500], 0.03048 * numpy.round(height[::500] / 0.03048)
        course = Course(times, coarse, half_band(coarse, coarse), 0.5)
        self.assertLess(abs(course(fine) - height).max(), 0.04)
        self.assertTrue((numpy.diff(course(fine)) >= -1e-9).all())
        for stands in (fine < 31.0, fine > 82.8):
            self.assertLess(numpy.ptp(course(fine[stands])), 1e-9)
        self.assertLess(abs(numpy.diff(course(fine)) / 0.01 - speed[1:])[(fine[1:] > 32.0) & (fine[1:] < 81.5)].max(), 0.005)

    def test_a_course_knows_when_a_speed_changed(self):
        """Of exact rows: a ramp of a second and a stop of a second, between rows of a second."""
        times = numpy.arange(60.0)
        speed = lambda t: 0.3 * numpy.clip(t - 10.0, 0.0, 1.0) - 0.3 * numpy.clip(t - 40.0, 0.0, 1.0)
        fine = numpy.linspace(0.0, 59.0, 5901)
        height = 5.0 + numpy.concatenate(([0.0], numpy.cumsum(0.5 * (speed(fine[1:]) + speed(fine[:-1])) * 0.01)))
        course = Course(times, height[::100], 0.0)
        self.assertLess(abs(course(fine) - height).max(), 1e-6)
        late = Course(times + 0.2, numpy.interp(times + 0.2, fine, height), 0.0)  # both are between rows
        self.assertLess(abs(late(fine) - height)[50:-150].max(), 1e-9)
        self.assertLess(abs(numpy.diff(late(fine)) / 0.01 - 0.3)[1300:3950].max(), 0.01)


if __name__ == "__main__":
    unittest.main()
