#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Weights of the string and the margin to yield, as `drill web` finds them. No master, no browser."""
import types
import unittest

import numpy
import skips
from diagnostic_msgs.msg import DiagnosticArray, DiagnosticStatus, KeyValue
from drill_rig_sim.web.feed import Feed
from drill_rig_sim.web.news import News, margin_of
from drill_rig_sim.web.weights import Weights


class WeightsOfARun(unittest.TestCase):
    """A string that is reamed up and down for hours."""

    @staticmethod
    def columns(hours):
        """Rows of 4 Hz: 60 s up at 0.2 m/s, 20 s still, 60 s down, 20 s still, and so on, 10 m above bottom at least."""
        times = numpy.arange(0.0, 3600.0 * hours, 0.25)
        phase = times % 160.0
        height = 5.0 + numpy.interp(phase, [0.0, 60.0, 80.0, 140.0, 160.0], [0.0, 12.0, 12.0, 0.0, 0.0])
        load = numpy.select([phase < 60.0, (phase >= 80.0) & (phase < 140.0)], [9e5, 7e5], 8e5)
        known = {"hook_load": load, "block_height": height, "bit_depth": 2000.0 - height, "hole_depth": 2005.0, "rpm": 0.0, "torque": 0.0, "flow": 0.0}
        return times, {name: numpy.broadcast_to(values, times.shape) for name, values in known.items()}

    def found(self, hours, every):
        """By looking once in this number of rows; how much of the log is kept [s]."""
        weights, (times, columns) = Weights(), self.columns(hours)
        for begin in range(0, len(times), every):
            rows = slice(begin, begin + every)
            weights.add(times[rows], {name: values[rows] for name, values in columns.items()})
            found = weights.find()
        return found, len(weights.log.low)

    def test_a_long_run_has_all_of_its_weights(self):
        found, kept = self.found(3.0, 400)
        self.assertEqual(round(3.0 * 3600 / 160) * ["up", "down"], [one["motion"] for one in found] + ["down"] * (len(found) % 2))
        self.assertLess(kept, 3000.0)
        for one in found:
            self.assertAlmostEqual({"up": 9e5, "down": 7e5}[one["motion"]], one["load"], delta=1.0)
            self.assertAlmostEqual({"up": 0.0, "down": 80.0}[one["motion"]], one["time"] % 160.0, delta=16.0)

    def test_it_makes_no_difference_how_often_they_are_looked_for(self):
        often, once = self.found(2.0, 450)[0], self.found(2.0, 10**6)[0]
        self.assertEqual([(one["motion"], round(one["load"], -2)) for one in once], [(one["motion"], round(one["load"], -2)) for one in often])

    def test_none(self):
        self.assertEqual([], Weights().find())
        self.assertEqual([], self.found(0.001, 10**6)[0])


class Margin(unittest.TestCase):
    def message(self, **values):
        values = [KeyValue(key=key, value=value) for key, value in values.items()]
        return DiagnosticArray(status=[DiagnosticStatus(name="rig/rig_simulator: time", hardware_id="rig/rig_simulator"),
                                       DiagnosticStatus(name="rig/rig_simulator: physics", hardware_id="rig/rig_simulator", values=values)])

    def test_of_the_rig_in_this_namespace(self):
        self.assertEqual(930000.0, margin_of(self.message(errors="3", pull_to_yield="930000"), "/rig/"))
        self.assertIsNone(margin_of(self.message(pull_to_yield="930000"), "/other/"))
        self.assertIsNone(margin_of(self.message(pull_to_yield="nan"), "/rig/"))
        self.assertIsNone(margin_of(self.message(errors="3"), "/rig/"))

    def test_pages_are_sent_it(self):
        feed = Feed(types.SimpleNamespace(name="rig", live=True, status=lambda: {}, poll=lambda: News([], [], None, {"margin": 5e5})), False, "si")
        self.assertIn({"type": "margin", "pull_to_yield": 5e5}, feed.take())
        self.assertIn({"type": "margin", "pull_to_yield": 5e5}, feed.whole())


if __name__ == "__main__":
    skips.main()
