#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""drill calibrate, but for the runner in front of it: least squares with confidence, parameters of a record that the simulator made, what is refused.
`test_calibrate.py --trials N [SEED]`: how often the truth lies within the stated confidence in N records, by the model itself."""
import importlib.util
import io
import json
import math
import os
import re
import sys
import tempfile
import unittest
from contextlib import redirect_stderr

if not importlib.util.find_spec("scipy"):
    print("skipped: SciPy is not installed (python3-scipy: ./test/run --campaigns)")
    sys.exit(77)
import made_record
import numpy
from called import called
from drill_rig_sim import calibrate_command
from drill_rig_sim.field.fit import FitError, Parameter, Problem, fit, hang_together

INFINITE = float("inf")


def calibrate(*words):
    return called(calibrate_command.main, *words)


class Least(unittest.TestCase):
    """y = a exp(-b t) and a b t, with an offset of the first."""
    TIME, TRUTH = numpy.linspace(0.0, 10.0, 200), (2.0, 0.3, 0.5)

    def model(self, points):
        return [numpy.concatenate([a * numpy.exp(-b * self.TIME), a * b * self.TIME]) for a, b in points]

    def problem(self, noise, model=None):
        parameters = [Parameter("a", 1.0, 0.0, 5.0, ["x"]), Parameter("b", 0.5, 0.0, 2.0, ["y"]), Parameter("offset", 0.0, -INFINITE, INFINITE, signal="u")]
        observed = self.model([self.TRUTH[:2]])[0] + noise * numpy.repeat([0.1, 0.3], 200)
        observed[:200] += self.TRUTH[2]
        return Problem(parameters, model or self.model, observed, ["u"] * 200 + ["v"] * 200, numpy.ones(400, bool))

    def test_without_noise_it_is_exact(self):
        found = fit(self.problem(numpy.zeros(400)))
        self.assertLess(abs(found.values - self.TRUTH).max(), 1e-6)

    def test_slopes_are_not_taken_again_where_they_are_no_better(self):
        chance = numpy.random.default_rng(4)
        problem = self.problem(chance.normal(size=400))
        found = fit(problem)
        self.assertLessEqual(problem.runs, 16)  # 19 with slopes at each point
        beyond = problem.slopes(found.values + (1.5 * problem.steps[0], 0.0, 0.0))
        self.assertFalse(numpy.array_equal(beyond, problem.slopes(found.values)))

    def test_the_truth_lies_within_the_stated_confidence(self):
        chance, within, scatter = numpy.random.default_rng(1), numpy.zeros(3), []
        for _ in range(200):
            found = fit(self.problem(chance.normal(size=400)))
            within += abs(found.values - self.TRUTH) < found.half_widths
            scatter.append([found.scatter["u"], found.scatter["v"]])
        self.assertTrue((within >= 182).all() and (within <= 198).all(), within)  # of 190, within 2.6 deviations
        self.assertLess(abs(numpy.mean(scatter, axis=0) / (0.1, 0.3) - 1.0).max(), 0.02)

    def test_numbers_of_known_error_count_for_less(self):
        chance, within, off, scatter = numpy.random.default_rng(5), numpy.zeros(3), [], []
        errors = numpy.where(numpy.arange(400) % 3 == 0, 1.0, 0.0)
        for _ in range(100):
            problem = self.problem(chance.normal(size=400))
            problem.observed += errors * chance.normal(size=400)
            plain = fit(problem)
            known = fit(Problem(problem.parameters, self.model, problem.observed, problem.signals, numpy.ones(400, bool), errors=errors))
            within += abs(known.values - self.TRUTH) < known.half_widths
            off.append([abs(found.values - self.TRUTH) for found in (known, plain)])
            scatter.append([known.scatter["u"], known.scatter["v"]])
        self.assertTrue((within >= 89).all(), within)  # of 95, within 2.7 deviations
        better, worse = numpy.sqrt(numpy.mean(numpy.square(off), axis=0))
        self.assertTrue((better < 0.6 * worse).all(), (better, worse))
        self.assertLess(abs(numpy.mean(scatter, axis=0) / (0.1, 0.3) - 1.0).max(), 0.05)

    def test_residuals_that_hang_together_count_for_fewer(self):
        chance = numpy.random.default_rng(2)
        series = chance.normal(size=20000)
        self.assertLess(hang_together(series), 1.2)
        for k in range(1, len(series)):
            series[k] += 0.8 * series[k - 1]
        self.assertAlmostEqual(9.0, hang_together(series), delta=1.5)  # (1 + 0.8)/(1 - 0.8)

    def test_a_single_number_of_a_signal_is_no_certainty(self):
        """It can be fitted exactly; its scatter is taken from the share that is left of the other signal."""
        chance = numpy.random.default_rng(3)
        problem = self.problem(chance.normal(size=400))
        problem.rows = problem.rows & (numpy.arange(400) < 201 + 150) & ((numpy.arange(400) < 200) | (numpy.arange(400) == 350))
        found = fit(problem)
        size = abs(problem.observed[350])
        share = found.scatter["u"] / numpy.sqrt(numpy.mean(problem.observed[:200]**2))
        self.assertAlmostEqual(share * size, found.scatter["v"], delta=1e-9)
        self.assertTrue((found.half_widths > 1e-3).all(), found.half_widths)

    def test_where_nothing_can_be_predicted(self):
        def holes(points):
            return [self.model([point])[0] if point[1] < 0.45 else numpy.full(400, numpy.nan) for point in points]
        problem = self.problem(numpy.zeros(400), holes)
        with self.assertRaises(FitError):
            fit(problem)
        problem.parameters[1].start = 0.1
        self.assertLess(abs(fit(problem).values - self.TRUTH).max(), 1e-5)


    def test_a_parameter_without_effect_is_not_moved(self):
        asked = []

        def model(points):
            asked.extend(points)
            return self.model([point[:2] for point in points])
        problem = self.problem(numpy.zeros(400), model)
        idle = Problem(problem.parameters[:2] + [Parameter("idle", 3.0, 0.0, 9.0, ["z"])] + problem.parameters[2:], model, problem.observed, problem.signals, numpy.ones(400, bool))
        found = fit(idle)
        self.assertEqual(["idle"], found.without_effect)
        self.assertLess(abs(found.values[[0, 1, 3]] - self.TRUTH).max(), 1e-6)
        self.assertEqual(1, len([point for point in asked if point[2] != 3.0]))

    def test_progress_counts_down(self):
        told, expected = io.StringIO(), []
        progress = calibrate_command.Progress()
        progress.expect(0, 40)
        progress.printed = progress.began = progress.began - 30.0
        with redirect_stderr(told):
            progress(10.0)
            progress(11.0)
        self.assertIn("10 of about 40 points tried, 30 s, about 90 s left", told.getvalue())
        self.assertEqual(1, told.getvalue().count("\n"))
        problem = self.problem(numpy.zeros(400))
        problem.tell = lambda points, in_all: expected.append((points, in_all))
        fit(problem)
        self.assertTrue(all(points <= in_all for points, in_all in expected) and expected[0][1] >= 10, expected)


class Records(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = folder.name
        cls.rows = made_record.rows_of(made_record.write_scene(cls.folder))

    def test_parameters_of_noisy_records_come_back(self):
        """Of three records; a truth lies beyond its confidence once in twenty, so two of twelve may."""
        beyond = []
        for seed in range(3):
            found = self.fitted(seed)
            for parameter, truth in zip(found["parameters"], made_record.TRUTH):
                off = abs(parameter["value"] - truth) / parameter["half_width_95"]
                self.assertLess(off, 2.0, parameter)
                self.assertLess(parameter["half_width_95"], 0.1 * truth, parameter)
                beyond += [parameter] if off > 1.0 else []
            for signal, noise in zip(("hook_load", "torque", "stand_pipe_pressure"), made_record.NOISE):
                for part in ("fitted", "held_out"):
                    self.assertLess(abs(found["rms"][signal][part] / noise - 1.0), 0.25, signal)
        self.assertLessEqual(len(beyond), 2, beyond)

    def fitted(self, seed):
        """What drill calibrate writes of a record with this noise."""
        made_record.write_record(self.folder, self.rows, seed)
        file = os.path.join(self.folder, "out.json")
        status, out, told = calibrate(made_record.write_fit(self.folder), "--json", file)
        self.assertEqual((0, []), (status, [line for line in told.splitlines() if "points tried" not in line]))
        self.assertIn("held out", out)
        self.assertRegex(out, r"tare \[N\] +\S+ +\+- \d+(\.\d)?\n")
        noise = float(re.search(r"hook_load \[kN\] +\S+ +\S+ +(\S+)\n", out).group(1))
        self.assertAlmostEqual(1.0, noise / (1e-3 * made_record.NOISE[0]), delta=0.2)  # what is left of a model that is right is no more
        with open(file, encoding="utf-8") as text:
            return json.load(text)

    def test_a_record_that_goes_against_the_scene_is_reported(self):
        rows = self.rows[:150].copy()
        rows[:, 4] = 6.0 * rows[:, 4].mean() - 5.0 * rows[:, 4]
        made_record.write_record(self.folder, rows, 0)
        fit_file = made_record.write_fit(self.folder, signals=["hook_load"], parameters=[made_record.FIT["parameters"][0]])
        self.assertRegex(calibrate(fit_file)[1], r"hook_load: the error of the fit is larger than the variation in the record \(\S+ kN\): the scene does not reproduce the record")
        made_record.write_record(self.folder, self.rows[:150], 0)
        self.assertNotIn("varies in the record", calibrate(fit_file)[1])

    def test_what_the_data_do_not_tell_is_said(self):
        made_record.write_record(self.folder, self.rows[:150], 0)
        hidden = {"name": "deep rock", "key": "rig.hoisting.trip_hook_load", "start": 3.0e6, "from": 2.0e6, "to": 4.0e6}
        file = os.path.join(self.folder, "idle.json")
        status, out, _ = calibrate(made_record.write_fit(self.folder, parameters=[made_record.FIT["parameters"][0], hidden]), "--json", file)
        self.assertEqual(0, status)
        self.assertIn("deep rock: has no effect on these data at its start value: not changed", out)
        self.assertIn("2 points of the parameters were tried", out)
        self.assertNotIn("tare: these", out)
        found = self.strict(file)
        self.assertEqual([None, True], [found["parameters"][1][key] for key in ("half_width_95", "without_effect")])
        part = found["residuals"]["hook_load"]
        self.assertEqual({"time", "recorded", "residual", "fitted"}, set(part))
        self.assertEqual({len(part["time"])}, {len(values) for values in part.values()})
        rms = math.sqrt(numpy.mean((numpy.array(part["residual"])[part["fitted"]])**2))
        self.assertAlmostEqual(found["rms"]["hook_load"]["fitted"], rms, delta=1e-6 * rms)

    def strict(self, file):
        """A file of JSON, without NaN and Infinity, which JSON does not have."""
        def refuse(word):
            raise AssertionError(word)
        with open(file, encoding="utf-8") as text:
            return json.load(text, parse_constant=refuse)

    def test_processes_find_the_same(self):
        made_record.write_record(self.folder, self.rows[:150], 0)
        names = [os.path.join(self.folder, "%d.json" % workers) for workers in (1, 2)]
        for workers, name in zip((1, 2), names):
            self.assertEqual(0, calibrate(made_record.write_fit(self.folder, parameters=made_record.FIT["parameters"][:2]), "--workers", str(workers), "--json", name)[0])
        self.assertEqual(*[self.strict(name)["parameters"] for name in names])

    def test_what_is_refused(self):
        made_record.write_record(self.folder, self.rows[:50], 0)
        first = made_record.FIT["parameters"][0]
        for more, said in (({"parameters": [{**first, "start": "x"}]}, "parameters[0].start: needed: a number"), ({"parameters": [{"name": "a", "start": 1}]}, "one of key"),
                           ({"parameters": [{"name": "a", "start": 1, "key": "well.nothing[3]"}]}, "the scene has no"), ({"record": "no.csv"}, "No such file"),
                           ({"parameters": [{"name": "a", "start": 5, "key": "mud.density", "to": 1}]}, "outside"), ({"scene": "no.yaml"}, "No such file"),
                           ({"table": {"file": "x"}}, "record or table"), ({"held_out": 2}, "up to 0.9"), ({"signals": ["rop"]}, "allowed: hook_load"),
                           ({"parameters": [{"name": "a", "start": -1, "key": "mud.density"}]}, "nothing can be predicted at the parameters"),
                           ({"parameters": [{"name": "a", "start": 1, "key": "formation[0].drilability", "times": True}]}, "parameters[0]: formation[0].drilability: the scene does not"),
                           ({"parameters": [{"name": "a", "start": 1, "key": "mud.density"}] * 2}, "are the same key"), ({"from": 1000.0}, "has 0 rows"), ({"leave_out": "0:1000"}, "leave no number to compare"),
                           ({"signals": ["torque"]}, "hook_load: is not fitted")):
            status, _, told = calibrate(made_record.write_fit(self.folder, **more))
            self.assertEqual((2, 1), (status, told.count("\n")), told)
            self.assertIn(said, told)


def trials(count, first=0):
    """How often each parameter's truth lay within its confidence, and the mean of that over its value."""
    with tempfile.TemporaryDirectory() as folder:
        rows = made_record.rows_of(made_record.write_scene(folder))
        off, widths = [], []
        for seed in range(first, first + count):
            made_record.write_record(folder, rows, seed)
            answer = os.path.join(folder, "out.json")
            calibrate(made_record.write_fit(folder), "--json", answer)
            with open(answer, encoding="utf-8") as text:
                parameters = json.load(text)["parameters"]
            off.append([parameter["value"] - truth for parameter, truth in zip(parameters, made_record.TRUTH)])
            widths.append([parameter["half_width_95"] for parameter in parameters])
    off, widths = numpy.array(off), numpy.array(widths)
    within = (abs(off) < widths).sum(axis=0)
    for parameter, good, width, error, truth in zip(parameters, within, widths.mean(axis=0), numpy.sqrt((off**2).mean(axis=0)), made_record.TRUTH):
        print("%-16s within its confidence in %d of %d, +- %.2g %% of it; off by %.2g %% rms" % (parameter["name"], good, count, 100.0 * width / truth, 100.0 * error / truth))
    print("%d of %d truths within their confidence" % (within.sum(), widths.size))


if __name__ == "__main__":
    if "--trials" in sys.argv:
        trials(*map(int, sys.argv[sys.argv.index("--trials") + 1:]))
    else:
        unittest.main()
