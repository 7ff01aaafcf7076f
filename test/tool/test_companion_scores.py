#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Scores and pictures beside a companion, of made-up runs whose difference to it is known. From an environment that finds drill_rig_sim."""
import math
import sys
import unittest

import numpy
from drill_rig_sim import plot_logs, score_plots
from drill_rig_sim.companion import WINDOW, difference
from drill_rig_sim.score import score
from drill_rig_sim.score_command import table
from drill_rig_sim.score_runs import Run, RunError, read_run
from drill_rig_sim.units import SI, Units

sys.dont_write_bytecode = True
from in_folder import InFolder  # noqa: E402 (leaves nothing behind)
from test_score import columns  # noqa: E402


def with_companion(change=lambda beside: None, ends=math.inf):
    """The run of test_score.py beside a companion that is the same but for `change(its columns)`, and ends at this time [s]."""
    made, beside = columns(), columns()
    change(beside)
    del beside["time"]
    gone = made["time"] > ends
    return Run(made, name="made up", companion={name: numpy.where(gone, numpy.nan, values) for name, values in beside.items()})


def more_weight(beside):
    beside["wob"] = beside["wob"] + 500.0


class Scores(unittest.TestCase):
    def test_every_score_is_also_the_companions(self):
        scores = score(with_companion(more_weight), bit_diameter=0.2, wob=10e3, wob_band=400.0)
        companion = scores.pop("companion")
        self.assertAlmostEqual(10e3, scores["wob"]["mean"], places=6)
        self.assertAlmostEqual(10.5e3, companion["wob"]["mean"], places=6)
        self.assertEqual((1.0, 0.0), (scores["wob"]["share_in_band"], companion["wob"]["share_in_band"]))
        self.assertEqual(list(scores), list(companion))
        self.assertEqual(scores["drilling"], companion["drilling"])

    def test_the_table_has_the_difference(self):
        run = with_companion(more_weight)
        lines = "\n".join(table(score(run, wob=10e3)))
        self.assertIn("made up, by its truth, +- the difference to its companion", lines)
        self.assertRegex(lines, r"weight on bit, mean +10\.00 \+- 0\.50 kN\n")
        self.assertRegex(lines, r"weight on bit within its band +100\.0 \+- 0\.0 %\n")
        self.assertRegex("\n".join(table(score(run), Units("oilfield"))), r"weight on bit, mean +2\.25 \+- 0\.11 klbf\n")

    def test_directions_differ_the_short_way_round(self):
        def turn(beside):
            beside["toolface"] = beside["toolface"] - math.radians(205.0)  # -185 deg is 175 deg
        run = with_companion(turn)
        run.columns["toolface"] = run["toolface"] - math.radians(195.0)  # 20 - 195 = -175 deg
        self.assertIn("-175.0 +- 10.0 deg", "\n".join(table(score(run))))

    def test_flags_have_the_companions_times(self):
        run = with_companion(lambda beside: beside.update(buckled=1.0 * (beside["time"] > 20.05)))
        run.columns.update(buckled=1.0 * (run["time"] > 90.05), accuracy_warning=1.0 * (run["time"] > 90.05))
        lines = "\n".join(table(score(run))) + "\n"
        self.assertRegex(lines, r"buckled +1 times, 10\.0 s \(companion: 1 times, 80\.0 s\)\n")
        self.assertRegex(lines, r"accuracy_warning +1 times, 10\.0 s\n")  # the companion's are of its own numerics

    def test_a_companion_that_has_ended_has_no_scores(self):
        scores = score(with_companion(more_weight, ends=34.55))
        self.assertIsNone(scores["companion"])
        self.assertIn("companion: it ended before the run, it is missing from 34.6 s on", scores["left_out"])
        self.assertNotIn("+-", "\n".join(table(scores)))

    def test_without_one_there_is_none(self):
        scores = score(Run(columns()))
        self.assertIsNone(scores["companion"])
        self.assertFalse(any("companion" in line for line in table(scores)))

    def test_one_without_the_columns_of_a_run_is_refused(self):
        run = with_companion()
        del run.companion["wob"]
        with self.assertRaisesRegex(RunError, "made up, its companion: has no wob"):
            score(run)


class Files(InFolder):
    def series(self, run, error=lambda time: "0.01"):
        names = [*run.columns, "error_wob", *("companion_" + name for name in run.companion)]
        rows = zip(*(map(repr, map(float, values)) for values in run.columns.values()), map(error, run["time"]),
                   *(["" if math.isnan(value) else repr(float(value)) for value in values] for values in run.companion.values()))
        return self.file("run.csv", "".join(",".join(cells) + "\n" for cells in [names, *rows]))

    def test_a_series_comes_back(self):
        run = with_companion(more_weight, ends=50.0)
        found = read_run(self.series(run, lambda time: "0.01" if time <= 50.0 else ""))
        self.assertEqual([*run.columns, "error_wob"], list(found.columns))
        for name, values in run.companion.items():
            numpy.testing.assert_array_equal(values, found.companion[name])
        self.assertEqual(501, numpy.isfinite(found["error_wob"]).sum())

    def test_what_is_no_number_is_refused(self):
        with self.assertRaisesRegex(RunError, "run.csv:2: error_wob: much is not a finite number"):
            read_run(self.series(with_companion(), lambda time: "much"))


class Bands(unittest.TestCase):
    def tearDown(self):
        plot_logs.plt.close("all")

    def test_are_the_difference_over_the_last_three_seconds(self):
        run = with_companion(lambda beside: beside.update(hook_load=beside["torque"] - 200.0), ends=60.0)
        self.assertIsNone(difference(run, "hook_load"))  # the run itself has none
        run.columns["hook_load"] = run["torque"]
        off = difference(run, "hook_load")
        begun = numpy.minimum(run["time"] / WINDOW, 1.0)  # there was none before the start
        good = run["time"] <= 60.0
        numpy.testing.assert_allclose(off[good], 200.0 * numpy.sqrt(begun[good]), rtol=1e-9)
        self.assertTrue(numpy.isnan(off[~good]).all())
        self.assertIsNone(difference(run, "rop"))
        self.assertIsNone(difference(Run(columns()), "wob"))

    def band(self, figure, label):
        """Least and largest of the horizontal places of a scale's band."""
        panel = next(panel for panel in figure.axes if panel.get_xlabel() == label)
        places = numpy.concatenate([path.vertices[:, 0] for collection in panel.collections for path in collection.get_paths()])
        return places.min(), places.max()

    def test_logs_have_them(self):
        run = with_companion(lambda beside: beside.update(torque=beside["torque"] - 200.0))
        for log in (plot_logs.time_log(run), plot_logs.depth_log(run)):
            numpy.testing.assert_allclose((0.4, 0.8), self.band(log, "torque [kN m]"), rtol=1e-6)  # 0.6 kN m in the run
        alone = plot_logs.time_log(Run(columns()))
        self.assertFalse(any(panel.collections for panel in alone.axes))

    def test_the_page_of_scores_has_them(self):
        for run, count in ((with_companion(more_weight), 1), (Run(columns()), 0)):
            panel = plot_logs.plt.figure().add_subplot()
            score_plots.weight(panel, run, score(run), SI)
            self.assertEqual(count, len(panel.collections))


if __name__ == "__main__":
    unittest.main()
