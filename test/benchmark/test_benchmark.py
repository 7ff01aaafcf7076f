#!/usr/bin/python3
"""Error measures and verdict of the benchmark on made-up data."""
import math
import os
import sys
import unittest

import numpy

sys.dont_write_bytecode = True
sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import measure  # noqa: E402
import scenes  # noqa: E402
import verdict  # noqa: E402


def series(**columns):
    time = numpy.arange(0.0, 10.0 + 1e-9, 0.02)
    out = {name: numpy.zeros_like(time) for name in measure.COLUMNS}
    out['time'] = time
    for name, function in columns.items():
        out[name] = function(time)
    return out


class Errors(unittest.TestCase):
    def test_a_run_equal_to_the_reference_has_none(self):
        a = series(hook_load=lambda t: 1e5 * numpy.sin(t))
        self.assertEqual(measure.errors(a, a, scenes.Scene('s', '', 10.0))['all'], 0.0)

    def test_a_constant_offset_is_its_share_of_the_range(self):
        reference = series(wob=lambda t: 1e4 * t)
        run = series(wob=lambda t: 1e4 * t + 2e3)
        errors = measure.errors(run, reference, scenes.Scene('s', '', 10.0))
        self.assertAlmostEqual(errors['wob'], 2e3 / 1e5, 12)
        self.assertAlmostEqual(errors['all'], 2e3 / 1e5 / math.sqrt(6), 12)

    def test_position_is_one_output_of_three_columns(self):
        reference = series(bit_east=lambda t: 0.3 * t, bit_up=lambda t: 0.4 * t)  # range 5 m
        run = series(bit_east=lambda t: 0.3 * t, bit_up=lambda t: 0.4 * t, bit_north=lambda t: 0.05 + 0.0 * t)
        self.assertAlmostEqual(measure.errors(run, reference, scenes.Scene('s', '', 10.0))['bit_position'], 0.01, 12)

    def test_outputs_at_rest_are_measured_by_their_floor(self):
        run = series(torque=lambda t: 1.0 + 0.0 * t)
        self.assertAlmostEqual(measure.errors(run, series(), scenes.Scene('s', '', 10.0))['torque'], 0.01, 12)

    def test_phase_does_not_count_after_the_bifurcation(self):
        reference = series(bit_speed=lambda t: 5.0 + 5.0 * numpy.sin(2.0 * math.pi * t))
        late = series(bit_speed=lambda t: 5.0 + 5.0 * numpy.sin(2.0 * math.pi * t - 2.0 * (t > 5.0)))
        trace = measure.errors(late, reference, scenes.Scene('s', '', 10.0))
        statistics = measure.errors(late, reference, scenes.Scene('s', '', 10.0, trace_until=5.0))
        self.assertGreater(trace['bit_speed'], 0.3)
        self.assertLess(statistics['bit_speed'], 0.01)

    def test_period(self):
        time = numpy.arange(0.0, 20.0, 0.02)
        y = numpy.maximum(0.0, numpy.sin(2.0 * math.pi * time / 3.7))
        self.assertAlmostEqual(measure.period(time, y), 3.7, 3)
        self.assertTrue(math.isnan(measure.period(time, time)))
        reference = series(bit_speed=lambda t: numpy.sin(2.0 * math.pi * t))
        slower = series(bit_speed=lambda t: numpy.sin(2.0 * math.pi * t / 1.1))
        scene = scenes.Scene('s', '', 10.0, trace_until=0.0, period_of='bit_speed')
        self.assertAlmostEqual(measure.errors(slower, reference, scene)['period'], 0.1, 3)
        self.assertEqual(measure.errors(series(), reference, scene)['period'], 1.0)

    def test_times_that_differ_are_refused(self):
        short = {name: column[:-1] for name, column in series().items()}
        with self.assertRaises(ValueError):
            measure.errors(short, series(), scenes.Scene('s', '', 10.0))


class Front(unittest.TestCase):
    POINTS = [(1e-1, 1.0), (1e-2, 10.0), (1e-3, 100.0), (1e-2, 30.0), (5e-2, 20.0)]

    def test_beaten_points_are_not_on_it(self):
        self.assertEqual(verdict.front(self.POINTS), [(1e-3, 100.0), (1e-2, 10.0), (1e-1, 1.0)])

    def test_cost_between_points_is_log_log(self):
        self.assertAlmostEqual(verdict.cost_at(self.POINTS, math.sqrt(1e-1 * 1e-2)), math.sqrt(10.0))
        self.assertAlmostEqual(verdict.cost_at(self.POINTS, 1e-2), 10.0)

    def test_cost_beyond_the_ends(self):
        self.assertEqual(verdict.cost_at(self.POINTS, 1.0), 1.0)
        self.assertTrue(math.isnan(verdict.cost_at(self.POINTS, 1e-4)))


class Judgement(unittest.TestCase):
    def scene(self, ratio, reason=None):
        return verdict.SceneVerdict('s', [(1e-2, 1.0), (1e-3, 10.0)], (1e-2, ratio), reason=reason)

    def test_a_default_on_the_front_passes(self):
        self.assertEqual(self.scene(1.0).ratio, 1.0)
        self.assertTrue(verdict.Verdict([self.scene(1.0), self.scene(1.0)]).holds)

    def test_the_geometric_mean_decides(self):
        self.assertTrue(verdict.Verdict([self.scene(2.0), self.scene(1.1)]).holds)
        self.assertFalse(verdict.Verdict([self.scene(2.0), self.scene(1.2)]).holds)

    def test_one_scene_may_not_cost_more_than_four_times_without_a_reason(self):
        good = [self.scene(1.0)] * 5
        self.assertFalse(verdict.Verdict(good + [self.scene(4.1)]).holds)
        self.assertTrue(verdict.Verdict(good + [self.scene(4.1, 'why')]).holds)

    def test_a_default_that_fails_fails_the_verdict(self):
        self.assertFalse(verdict.Verdict([self.scene(1.0)], ['other']).holds)
        self.assertFalse(verdict.Verdict([]).holds)

    def test_errors_below_the_references_own_count_as_that(self):
        judged = verdict.SceneVerdict('s', [(1e-6, 1.0), (1e-2, 0.5)], (1e-5, 3.0), floor=1e-4)
        self.assertEqual(judged.error, 1e-4)
        self.assertAlmostEqual(judged.ratio, 3.0)


class Scenes(unittest.TestCase):
    def test_every_scene_has_its_file_and_times_that_fit(self):
        for scene in scenes.ALL + scenes.FAST:
            self.assertTrue(os.path.exists(scene.path), scene.path)
            self.assertLessEqual(scene.trace_until, scene.duration)
            for step in scene.steps + scenes.SHORT_STEPS:
                self.assertAlmostEqual(scene.every / step, round(scene.every / step), 6)
            self.assertAlmostEqual(scene.duration / scene.every, round(scene.duration / scene.every), 6)


if __name__ == '__main__':
    unittest.main()
