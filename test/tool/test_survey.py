#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Surveys and texts from outside, by the runner and by Python: the same answer everywhere. Usage: test_survey.py PATH_TO_DRILL"""
import logging
import os
import subprocess
import sys
import unittest

import numpy
from drill_rig_sim.campaign.blueprint import Blueprint
from drill_rig_sim.campaign.plan_text import PlanError, plan_of
from drill_rig_sim.campaign.scene_text import survey_file
from drill_rig_sim.field.models import ModelError, scene_and_survey
from drill_rig_sim.lockstep import Refused
from drill_rig_sim.sim import Simulator
from drill_rig_sim.survey import SurveyError, read_survey
from drill_rig_sim.text_file import TextError, read_text
from in_folder import InFolder

TABLE = "md_m,inclination_deg,azimuth_deg\n0,0,297\n200,0,297\n800,51,297\n# 51°, Tromsø\n"
SCENE = """name: well # Tromsø
well:
  survey: %s
  hole_depth: %g
  sections: [{to: 800, diameter: 0.2159, friction: 0.25}]
%sformation: [{to_tvd: 10000, drillability: 1.0e-8}]
string:
  - {name: bit, type: bit, length: 0.3, mass: 40, diameter: 0.2159}
  - {name: collar, type: collar, joints: 6, joint_length: 9.4, outer_diameter: 0.165, inner_diameter: 0.0714, linear_mass: 136.0}
  - {name: pipe, type: pipe, joints: fill, joint_length: 9.5, outer_diameter: 0.127, inner_diameter: 0.1086, linear_mass: 31.9}
start: {block_height: 20}
"""
ENCODINGS = {"utf-8": False, "utf-8-sig": False, "utf-16": False, "latin-1": True, "cp1252": True}  # and whether that is reported
drill_program = None


def drill(*words):
    return subprocess.run([drill_program, *words], stdout=subprocess.PIPE, stderr=subprocess.PIPE, universal_newlines=True, timeout=300, check=False)


class Files(InFolder):
    def scene(self, survey, hole_depth=700.0, more="", encoding="utf-8"):
        return self.file("scene.yaml", SCENE % (survey, hole_depth, more), encoding)

    def refused(self, *words):
        done = drill(*words)
        self.assertEqual((2, "", 1), (done.returncode, done.stdout, len(done.stderr.splitlines())), done.stderr)
        return done.stderr


class Encodings(Files):
    def test_the_runner_reads_each(self):
        expected = drill("survey", self.file("plain.csv", TABLE)).stdout
        for encoding, is_reported in ENCODINGS.items():
            file = self.file("survey.csv", TABLE, encoding)
            done = drill("survey", file)
            self.assertEqual((0, expected), (done.returncode, done.stdout), encoding)
            self.assertEqual("%s: is not UTF-8; read as latin-1\n" % file if is_reported else "", done.stderr)
        scene = self.scene("survey.csv", encoding="latin-1")
        done = drill("check", scene)
        self.assertEqual(0, done.returncode, done.stderr)
        self.assertEqual(2, done.stderr.count("is not UTF-8; read as latin-1"), "scene and survey")

    def test_python_reads_each(self):
        expected = read_survey(self.file("plain.csv", TABLE)).positions
        for encoding, is_reported in ENCODINGS.items():
            survey, scene = self.file("%s.csv" % encoding, TABLE, encoding), self.scene("%s.csv" % encoding, encoding=encoding)
            logging.disable(logging.WARNING)
            try:
                numpy.testing.assert_array_equal(expected, read_survey(survey).positions)
                self.assertEqual(TABLE, read_text(survey))
                self.assertEqual((SCENE % (encoding + ".csv", 700.0, ""), TABLE), scene_and_survey(scene))
                self.assertIn("name", plan_of(scene).mapping())
            finally:
                logging.disable(logging.NOTSET)
            with self.subTest(encoding):
                from drill_rig_sim import _sim  # pylint: disable=import-outside-toplevel
                self.assertEqual(survey + ": is not UTF-8; read as latin-1" if is_reported else "", _sim.read_text(survey)[1])

    def test_what_is_no_text_is_refused_by_all(self):
        file = self.file("nul.csv", "md_m\n\0")
        self.assertIn("nul.csv:2: contains a NUL byte", self.refused("survey", file))
        for error, read in ((TextError, read_text), (SurveyError, read_survey), (PlanError, plan_of), (ModelError, scene_and_survey)):
            for name in (file, self.folder, os.path.join(self.folder, "none.csv")):
                with self.assertRaises(error):
                    read(name)


class OfTheTrade(Files):
    def test_a_map_of_columns(self):
        file = self.file("euro.csv", "MD;Inc;Azi\n0,0;0,0;0,0\n500,0;2,1;45,3\n")
        self.assertIn("euro.csv:1: MD: the header gives no unit", self.refused("survey", file))
        done = drill("survey", file, "--columns", self.file("map.yaml", "columns: {md: {unit: ft}, inclination: {unit: deg}, azimuth: {unit: deg}}\n"))
        self.assertEqual((0, ""), (done.returncode, done.stderr))
        self.assertEqual([152.4, 2.1, 45.3], [float(cell) for cell in done.stdout.splitlines()[-1].split()[:3]])
        self.assertIn('map.yaml:1: columns.md.unit: "fathom" is not known', self.refused("survey", file, "--columns", self.file("map.yaml", "columns: {md: {unit: fathom}}\n")))
        self.assertIn("--columns: needs a value", self.refused("survey", file, "--columns"))

    def test_passed_over(self):
        file = self.file("nulls.csv", "md_m,inclination_deg,azimuth_deg\n0,0,\n100,-999.25,-999.25\n200,1.5,40\n200,1.5,40\n300,3,41\n")
        self.assertIn("--pass-over", self.refused("survey", file))
        done = drill("survey", file, "--pass-over")
        self.assertEqual(0, done.returncode, done.stderr)
        self.assertEqual(4, len(done.stdout.splitlines()))
        self.assertEqual(3, len(done.stderr.splitlines()), done.stderr)
        for text in ("given 0 deg: line 2", "without a value were skipped: line 3", "equal to the one before were skipped: line 5"):
            self.assertIn(text, done.stderr)

    def test_a_block_in_a_scene(self):
        self.file("ft.csv", "Depth RKB;Inc;Azi\n0;0;0\n1000,5;2,5;45\n1000,5;2,5;45\n2500;10;50\n")
        scene = self.scene("{file: ft.csv, columns: {md: {column: Depth RKB, unit: ft}, inclination: {unit: deg}, azimuth: {unit: deg}}, pass_over: true}")
        done = drill("check", scene)
        self.assertEqual(0, done.returncode, done.stderr)
        self.assertIn("3 stations to 762 m", done.stdout)
        self.assertIn("skipped: line 4", done.stderr)
        # a campaign's runs have the survey beside them, in a folder of their own
        text = read_text(scene)
        self.assertEqual(os.path.join(self.folder, "ft.csv"), survey_file(text, scene))
        written = Blueprint("x", text, read_text(os.path.join(self.folder, "ft.csv")), []).written([])
        self.assertEqual(0, drill("check", written).returncode)
        self.assertIn("scene.yaml:3: well.survey.file: is missing", self.refused("check", self.scene("{pass_over: true}")))
        self.assertIn("well.survey.nulls: unknown key", self.refused("check", self.scene("{file: ft.csv, nulls: true}")))


PLAN = "Tiefe;Neigung;Azi\n0;0;297\n656,168;0;297\n656,168;0;297\n2624,672;51;297\n"  # that of TABLE in feet
MAP = "columns: {md: {column: Tiefe, unit: ft}, inclination: {column: Neigung, unit: deg}, azimuth: {unit: deg}}\n"


class Plans(Files):
    def setUp(self):
        super().setUp()
        self.plan, self.map = self.file("plan.csv", PLAN), self.file("map.yaml", MAP)

    def test_python_takes_the_map(self):
        logging.disable(logging.WARNING)
        self.addCleanup(logging.disable, logging.NOTSET)
        expected = read_survey(self.file("plain.csv", TABLE)).positions
        numpy.testing.assert_allclose(expected, read_survey(self.plan, self.map, True).positions, atol=1e-9)
        for words, problem in (((self.plan,), "plan.csv:1: "), ((self.plan, self.map), "plan.csv:4: .*--pass-over"), ((self.plan, self.plan), "plan.csv:1: text is given, allowed: a block"),
                               ((self.plan, self.file("none.yaml", "columns: {md: {unit: fathom}}\n")), 'none.yaml:1: columns.md.unit: "fathom" is not known')):
            with self.assertRaisesRegex(SurveyError, problem):
                read_survey(*words)

    def test_score_and_plot_take_the_map(self):
        run = os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(__file__))), "cases/01_plan_read_by_other_rules/run.csv")
        far = drill("score", run, "--plan", self.file("plain.csv", TABLE))
        words = ("--plan", self.plan, "--columns", self.map)
        done = drill("score", run, *words, "--pass-over")
        self.assertEqual((0, far.stdout), (done.returncode, done.stdout), done.stderr)
        self.assertIn("equal to the one before were skipped: line 4", done.stderr)
        self.assertIn("plan.csv:4: station 3: md 656.168 ft is not deeper than", self.refused("score", run, *words))
        self.assertIn("plan.csv:4: station 3", self.refused("plot", run, *words, "--out", self.folder))
        for command in ("score", "plot"):
            self.assertIn("--columns: needs --plan", self.refused(command, run, "--columns", self.map))
            self.assertIn("--pass-over: needs --plan", self.refused(command, run, "--pass-over"))

    def test_a_new_well_takes_the_map(self):
        self.file("survey.csv", TABLE)
        logging.disable(logging.WARNING)
        self.addCleanup(logging.disable, logging.NOTSET)
        rig = Simulator(self.scene("survey.csv"))
        self.assertAlmostEqual(800.0, rig.load_survey(self.plan, columns=self.map, pass_over=True).truth.hole_depth, delta=1e-3)
        with self.assertRaisesRegex(Refused, "plan.csv:1: "):
            rig.load_survey(self.plan)


class ToTheBit(Files):
    def test_projected_on_request(self):
        self.file("survey.csv", TABLE)
        self.assertIn("well.project: straight or curvature", self.refused("check", self.scene("survey.csv", 810.0)))
        for project, inclination in (("straight", 51.0), ("curvature", 51.85)):  # 51 deg over 600 m, 10 m further
            scene = self.scene("survey.csv", 810.0, "  project: %s\n" % project)
            text = read_text(scene).replace("to: 800", "to: 810")
            done = drill("check", self.file("scene.yaml", text))
            self.assertEqual(0, done.returncode, done.stderr)
            self.assertIn("projected 10 m (32.81 ft) from its last station, 800 m (2624.67 ft)", done.stderr)
            self.assertIn("at its bottom %.2f deg inclination" % inclination, done.stdout)
        self.assertIn("30.5 m", self.refused("check", self.scene("survey.csv", 831.0, "  project: straight\n")))
        for depth in (805.0, 830.0, 860.0):
            self.assertRegex(self.refused("check", self.scene("survey.csv", depth)), r"scene.yaml:4: well.hole_depth: %g m is deeper than the survey" % depth)

    def test_another_well_is_projected_too(self):
        self.file("survey.csv", TABLE)
        logging.disable(logging.WARNING)
        self.addCleanup(logging.disable, logging.NOTSET)
        rig = Simulator(self.scene("survey.csv", 700.0, "  project: straight\n"))
        state = rig.load_survey(md=[0.0, 600.0], inclination=[0.0, 0.1], azimuth=[0.0, 0.0], hole_depth=620.0)
        self.assertAlmostEqual(620.0, state.truth.hole_depth, delta=1e-6)


if __name__ == "__main__":
    drill_program = sys.argv.pop(1)
    unittest.main()
