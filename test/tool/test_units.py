#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Units: those of a scene's numbers as Python sees them, and those that commands show numbers in, against C++'s and each other."""
import math
import os
import re
import tempfile
import unittest

import numpy
from drill_rig_sim import _sim, plot_logs, plot_well, replay_command, score_command, score_plots
from drill_rig_sim.field import units as of_records
from drill_rig_sim.field.columns import read_map
from drill_rig_sim.field.record import RecordError
from drill_rig_sim.field.replay import MeasuredErrors
from drill_rig_sim.field.signals import SIGNALS
from drill_rig_sim.field.table import unit_in
from drill_rig_sim.lockstep import Refused
from drill_rig_sim.score import score
from drill_rig_sim.score_runs import Run
from drill_rig_sim.sim import Simulator, units
from drill_rig_sim.survey import read_survey
from drill_rig_sim.units import SHOWN, SI, Units
from in_folder import InFolder

SOURCE = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
OILFIELD_SCENE = os.path.join(SOURCE, "config/scenes/oilfield.yaml")
OILFIELD = Units("oilfield")
FOOT, POUND = 0.3048, 4.4482216152605  # [m], [N]


def drilled():
    """100 s in which the bit makes 10 ft of hole to the east, at 10000 ft, with 20 klbf on it."""
    time = numpy.arange(0.0, 100.05, 0.1)
    depth = FOOT * (10000.0 + 10.0 * time / 100.0)
    way = depth - depth[0]
    columns = {"time": time, "hole_depth": depth, "bit_depth": depth, "wob": numpy.full_like(time, 20e3 * POUND), "torque": numpy.full_like(time, 5e3 * POUND * FOOT),
               "top_drive_speed": numpy.full_like(time, 4.0 * math.pi), "bit_speed": numpy.full_like(time, 4.0 * math.pi), "hook_load": numpy.full_like(time, 250e3 * POUND),
               "stand_pipe_pressure": numpy.full_like(time, 3000.0 * POUND / 0.0254**2), "flow": numpy.full_like(time, 500.0 * 231.0 * 0.0254**3 / 60.0),
               "rop": numpy.full_like(time, 360.0 * FOOT / 3600.0), "bit_east": 0.5 * way, "bit_north": 0.0 * way, "bit_up": -math.sqrt(0.75) * way}
    return Run(columns, name="made up")


def curves(figure):
    """The data of every curve by the label of its scale."""
    return {panel.get_xlabel(): panel.lines[0].get_xdata() for panel in figure.axes if panel.lines and panel.get_xlabel()}


class Tables(unittest.TestCase):
    def test_scenes_have_the_units_of_definition(self):
        self.assertAlmostEqual(6894.757293168361, units()["pressure"]["psi"], places=9)
        self.assertEqual(0.0254, units()["length"]["in"])
        self.assertNotIn("tonf", units()["force"])

    def test_python_and_the_runner_show_the_same_units(self):
        for quantity, (_, oilfield) in SHOWN.items():
            if quantity not in ("time", "number", "count"):
                self.assertAlmostEqual(1.0, oilfield.per_si / _sim.oilfield_units()[oilfield.name], places=14, msg=quantity)

    def test_what_python_shows_is_of_the_table(self):
        for unit in (unit for both in SHOWN.values() for unit in both if unit.name not in ("", "%") and not unit.name.startswith("deg/")):
            factors = [factor for factor, _ in (_sim.find_unit(quantity, unit.name) for quantity in units()) if factor]
            self.assertTrue(any(abs(factor * unit.per_si - 1.0) < 1e-14 for factor in factors), unit.name)


class Doors(InFolder):
    """Every unit of the one table at each door of Python, by each spelling; test_scene_units.cpp does so with every number of a scene."""
    AMBIGUOUS = (("force", "tonf", "tonfUS"), ("force", "TON", "1000 kgf (tf)"), ("force", "Mlbf", "klbf"), ("force", "mN", "MN or N"), ("pressure", "mPa", "MPa or Pa"),
                 ("torque", "tonf.ft", "tonfUS.ft"), ("angle", "grad", "gon or deg"))

    def map_of(self, signal, unit):
        """The unit of a signal in the file of a map."""
        return read_map(self.file("map.yaml", "%s: {column: X, unit: %r}\n" % (signal, unit))).columns[signal].unit

    def test_records_and_maps(self):
        for signal, (quantity, _, _) in SIGNALS.items():
            for spelling, factor in units()[quantity].items():
                self.assertEqual(factor, of_records.factor_of(quantity, spelling), spelling)
                self.assertEqual(factor, of_records.factor_of(quantity, self.map_of(signal, spelling)), spelling)
                name = "x [%s]" % spelling
                self.assertEqual(factor, of_records.factor_of(quantity, unit_in(name)), name)

    def test_surveys(self):
        for spelling, factor in units()["length"].items():
            for text, columns in (("MD (%s),Inc (deg),Azi (deg)\n0,0,0\n%.17g,0,0\n" % (spelling, 100.0 / factor), ""),
                                  ("MD,Inc (deg),Azi (deg)\n0,0,0\n%.17g,0,0\n" % (100.0 / factor), "columns: {md: {unit: %r}}\n" % spelling)):
                if '"' not in spelling or columns:
                    self.assertAlmostEqual(100.0, self.survey(text, columns).md[-1], places=10, msg=spelling)
        for spelling, factor in units()["angle"].items():
            text = "MD (m),Inc (%s),Azi (%s)\n0,0,0\n100,%.17g,0\n" % (spelling, spelling, 0.5 / factor)
            self.assertAlmostEqual(-math.cos(0.5), self.survey(text).tangents[-1][2], places=10, msg=spelling)

    def survey(self, text, columns=""):
        return read_survey(self.file("survey.csv", text), self.file("columns.yaml", columns) if columns else "")

    def test_ambiguous_units_are_refused_with_the_choices(self):
        for quantity, spelling, said in self.AMBIGUOUS:
            self.assertNotIn(spelling, units()[quantity])
            self.assertIn("ambiguous; allowed: ", _sim.find_unit(quantity, spelling)[1])
            self.assertIn(said, _sim.find_unit(quantity, spelling)[1])
            signal = next((signal for signal, (known, _, _) in SIGNALS.items() if known == quantity), None)
            if signal:
                self.assertRaisesRegex(RecordError, "map.yaml:1: .*is ambiguous; allowed: ", self.map_of, signal, spelling)


class Shown(unittest.TestCase):
    def tearDown(self):
        plot_logs.plt.close("all")

    def test_logs(self):
        for figure in (plot_logs.time_log(drilled(), OILFIELD), plot_logs.depth_log(drilled(), OILFIELD)):
            drawn = curves(figure)
            for label, value in (("WOB [klbf]", 20.0), ("hook load [klbf]", 250.0), ("ROP [ft/h]", 360.0), ("torque [kft.lbf]", 5.0), ("stand pipe [psi]", 3000.0),
                                 ("flow [gpm]", 500.0), ("top drive [rpm]", 120.0)):
                self.assertAlmostEqual(value, numpy.median(drawn[label]), places=6, msg=label)
        self.assertEqual("measured depth [ft]", figure.axes[0].get_ylabel())
        self.assertAlmostEqual(10000.0, figure.axes[0].get_ylim()[1], delta=0.5)

    def test_well(self):
        above, section = plot_well.path(drilled(), None, OILFIELD).axes
        self.assertEqual(("east [ft]", "true vertical depth [ft]"), (above.get_xlabel(), section.get_ylabel()))
        self.assertAlmostEqual(5.0, numpy.ptp(above.lines[0].get_xdata()), delta=0.5)

    def test_string(self):
        columns = {name: numpy.array([0.0, 1e3 * POUND]) for name in ("tension", "true_axial_force", "contact_force")}
        columns.update({name: numpy.array([0.0, 1e3 * POUND * FOOT]) for name in ("torque", "bending_moment")}, md=numpy.array([0.0, 1000.0 * FOOT]))
        figure = plot_well.string_log(columns, "made up", OILFIELD)
        for panel in figure.axes:
            self.assertAlmostEqual(1.0, panel.lines[0].get_xdata()[-1], places=9)
        self.assertEqual(["tension [klbf]", "torque [kft.lbf]", "bending [kft.lbf]", "contact [klbf]"], [panel.get_xlabel() for panel in figure.axes])
        self.assertAlmostEqual(1000.0, figure.axes[0].get_ylim()[0])

    def test_scores(self):
        lines = "\n".join(score_command.table(score(drilled(), bit_diameter=8.5 * 0.0254), OILFIELD))
        for line in (r"drilled +10\.00 ft", r"rate of penetration on bottom +360\.\d ft/h", r"weight on bit, mean +20\.00 klbf", r"mechanical specific energy +[\d.]+ ksi"):
            self.assertRegex(lines, line)
        in_si = "\n".join(score_command.table(score(drilled(), bit_diameter=8.5 * 0.0254)))
        self.assertRegex(in_si, r"drilled +3\.048 m\n")
        # Teale: F/A + T w/(A ROP) = 20 klbf/(56.745 in2) + 12 x 5000 lbf in x 2 pi 120/min / (56.745 in2 x 72 in/min) = 352.5 + 11072.6 psi
        self.assertAlmostEqual(11.425, float(re.search(r"energy +([\d.]+) ksi", lines).group(1)), delta=0.06)

    def test_page_of_scores(self):
        with tempfile.TemporaryDirectory() as folder:
            run = drilled()
            score_plots.draw(run, score(run), None, 8.5 * 0.0254, os.path.join(folder, "page.svg"), OILFIELD)
            with open(os.path.join(folder, "page.svg"), encoding="utf-8") as page:
                text = page.read()
        for label in ("measured depth [ft]", "weight on bit [klbf]", "rate of penetration, 10 s [ft/h]", "specific energy, 10 s [ksi]"):
            self.assertIn(label, text)

    def test_replay(self):
        class Made:  # pylint: disable=too-few-public-methods
            errors, recorded = MeasuredErrors(), {}

            @staticmethod
            def table():
                return {"hook_load": dict.fromkeys(("mean", "rms", "largest", "range", "unresolved_rms", "unresolved_largest"), 1e3 * POUND)}
        self.assertRegex(replay_command.table(Made, OILFIELD)[1], r"hook load +1\.000 +1\.000 +1\.000 +1\.000 klbf")
        self.assertRegex(replay_command.table(Made, SI)[1], r"hook load +4\.448 +4\.448 +4\.448 +4\.448 kN")


class Scenes(unittest.TestCase):
    def test_a_simulator_reads_them(self):
        self.assertAlmostEqual(1498.0 * FOOT, Simulator(OILFIELD_SCENE).step().truth.bit_depth, delta=1e-3)

    def test_a_wrong_one_is_refused_in_one_line(self):
        with open(OILFIELD_SCENE, encoding="utf-8") as text, tempfile.NamedTemporaryFile("w", suffix=".yaml") as wrong:
            wrong.write(text.read().replace("9.5 ppg", "9.5 psi"))
            wrong.flush()
            with self.assertRaisesRegex(Refused, r"^[^\n]*: mud\.density: psi is a pressure; allowed: kg/m3, g/cm3, ppg, lbm/ft3$"):
                Simulator(wrong.name)


if __name__ == "__main__":
    unittest.main()
