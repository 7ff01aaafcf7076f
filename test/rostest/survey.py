#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""load_survey takes a sound survey and refuses a broken one, says which station and why, and changes nothing."""
import math
import os
import tempfile

from drill_rig_sim.srv import LoadSurveyRequest
from nav_msgs.msg import Path
from rig_test import PACKAGE_DIR, Rig, run, unittest, winch


def stations(*rows):
    md, inclination, azimuth = zip(*rows)
    return LoadSurveyRequest(md=list(md), inclination=list(inclination), azimuth=list(azimuth))


class Survey(unittest.TestCase):
    def setUp(self):
        self.rig = Rig()
        self.assertTrue(self.rig.reset_well("quick.yaml", 0.0).success)

    def test_stations_make_a_new_well(self):
        paths = self.rig.collect("trajectory", Path)
        before = self.rig.advance(0).header.stamp
        answer = self.rig.load_survey(stations((0.0, 0.0, 0.0), (60.0, 0.0, 0.0), (120.0, 0.2, math.pi / 2)))
        self.assertTrue(answer.success, answer.message)
        state = self.rig.advance(1)
        self.assertAlmostEqual(120.0, state.hole_depth, places=6)
        self.assertAlmostEqual(119.7, state.bit_depth, places=6)  # as far off bottom as before
        end = paths.after(before)[-1].poses[-1].pose.position
        self.assertAlmostEqual(60.0 / 0.2 * (1.0 - math.cos(0.2)), end.x, delta=1e-3)  # an arc to the east
        self.assertAlmostEqual(0.0, end.y, delta=1e-3)
        self.assertAlmostEqual(-60.0 - 60.0 / 0.2 * math.sin(0.2), end.z, delta=1e-3)

    def test_a_real_survey_from_its_file(self):
        answer = self.rig.load_survey(LoadSurveyRequest(file="bohai.csv"))
        self.assertTrue(answer.success, answer.message)
        self.assertAlmostEqual(730.0, self.rig.advance(1).hole_depth, places=6)
        self.assertTrue(self.rig.reset_well("", 0.0).success)
        self.assertAlmostEqual(730.0, self.rig.advance(0).hole_depth, places=6)  # the new well stays

    def test_a_first_station_below_the_table_is_tied_in(self):
        paths = self.rig.collect("trajectory", Path)
        request = stations((100.0, 0.0, 0.0), (150.0, 0.0, 0.0))
        self.refused(request, "station 0", "needed: 0")
        request.tie_in_tvd = 100.0
        before = self.rig.advance(0).header.stamp  # a restored state publishes the old well again
        answer = self.rig.load_survey(request)
        self.assertTrue(answer.success, answer.message)
        self.assertAlmostEqual(150.0, self.rig.advance(1).hole_depth, places=6)
        end = paths.after(before)[-1].poses[-1].pose.position
        self.assertAlmostEqual(-150.0, end.z, delta=1e-3)

    def test_a_tie_in_that_leads_nowhere(self):
        request = stations((100.0, 0.0, 0.0), (150.0, 0.0, 0.0))
        request.tie_in_north, request.tie_in_tvd = 50.0, 100.0
        self.refused(request, "tie_in: ", "111.803 m")

    def test_depths_of_hole_and_bit_may_be_set(self):
        request = stations((0.0, 0.0, 0.0), (200.0, 0.0, 0.0))
        request.hole_depth, request.bit_depth = 150.0, 140.0
        answer = self.rig.load_survey(request)
        self.assertTrue(answer.success, answer.message)
        state = self.rig.advance(0)
        self.assertAlmostEqual(150.0, state.hole_depth, places=6)
        self.assertAlmostEqual(140.0, state.bit_depth, places=6)

    def test_a_bit_depth_asked_for_is_not_the_scenes(self):
        request = stations((0.0, 0.0, 0.0), (200.0, 0.0, 0.0))
        request.bit_depth = 150.0
        self.assertTrue(self.rig.load_survey(request).success)
        self.assertTrue(self.rig.reset_well("", 0.0).success)
        self.assertAlmostEqual(150.0, self.rig.advance(0).bit_depth, places=6)  # where that well began
        request.bit_depth = 0.0
        self.assertTrue(self.rig.load_survey(request).success)
        self.assertAlmostEqual(199.7, self.rig.advance(0).bit_depth, places=6)  # as far off bottom as quick.yaml has it

    def refused(self, request, *words):
        self.rig.advance(5, winch=winch(0.05))
        answer, expected, after = self.rig.next_frame_after(lambda: self.rig.load_survey(request))
        self.assertFalse(answer.success)
        for word in words:
            self.assertIn(word, answer.message)
        self.assertNotIn("\n", answer.message)
        self.assertEqual(expected, after)

    def test_md_that_does_not_grow(self):
        self.refused(stations((0.0, 0.0, 0.0), (60.0, 0.0, 0.0), (50.0, 0.1, 0.0)), "station 2", "50")

    def test_inclination_of_200_deg(self):
        self.refused(stations((0.0, 0.0, 0.0), (60.0, math.radians(200.0), 0.0)), "station 1", "inclination")

    def test_a_number_that_is_none(self):
        self.refused(stations((0.0, 0.0, 0.0), (60.0, 0.1, math.nan)), "station 1")

    def test_one_station(self):
        self.refused(stations((0.0, 0.0, 0.0)), "two")

    def test_text_in_the_file(self):
        with tempfile.NamedTemporaryFile("w", suffix=".csv", delete=False) as file:
            file.write("md_m,inclination_deg,azimuth_deg\n0,0,0\n60,three,0\n")
        self.addCleanup(os.unlink, file.name)
        self.refused(LoadSurveyRequest(file=file.name), os.path.basename(file.name) + ":3", "inclination_deg")

    def test_a_map_of_the_files_columns(self):
        with tempfile.TemporaryDirectory() as folder:
            file, columns = os.path.join(folder, "plan.csv"), os.path.join(folder, "map.yaml")
            with open(file, "w", encoding="utf-8") as out:
                out.write("Tiefe;Neigung;Azi\n0;0;0\n1000;0;0\n1000;0;0\n")
            with open(columns, "w", encoding="utf-8") as out:
                out.write("columns: {md: {column: Tiefe, unit: ft}, inclination: {column: Neigung, unit: deg}, azimuth: {unit: deg}}\n")
            self.refused(LoadSurveyRequest(file=file), "plan.csv:1", "Tiefe")
            self.refused(LoadSurveyRequest(file=file, columns=columns), "plan.csv:4", "is not deeper than")
            self.refused(LoadSurveyRequest(file=file, columns=columns + "x"), "map.yamlx")
            answer = self.rig.load_survey(LoadSurveyRequest(file=file, columns=columns, pass_over=True))
        self.assertTrue(answer.success, answer.message)
        self.assertIn("skipped: line 4", answer.message)
        self.assertAlmostEqual(304.8, self.rig.advance(1).hole_depth, places=6)

    def test_no_file_no_stations_both_and_lists_of_different_length(self):
        self.refused(LoadSurveyRequest(file="/no/such/file.csv"), "/no/such/file.csv")
        self.refused(LoadSurveyRequest())
        self.refused(LoadSurveyRequest(file="a.csv", md=[0.0, 1.0], inclination=[0.0, 0.0], azimuth=[0.0, 0.0]))
        self.refused(LoadSurveyRequest(md=[0.0, 100.0], inclination=[0.0], azimuth=[0.0, 0.0]), "2, 1 and 2")

    def test_depths_outside_the_well(self):
        for hole, bit in ((300.0, 0.0), (-1.0, 0.0), (math.nan, 0.0), (100.0, 120.0), (100.0, math.nan)):
            request = stations((0.0, 0.0, 0.0), (200.0, 0.0, 0.0))
            request.hole_depth, request.bit_depth = hole, bit
            self.refused(request, "depth")


if __name__ == "__main__":
    run(Survey)
