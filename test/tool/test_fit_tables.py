#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Tables of weights for drill calibrate, as people keep them: read with the right numbers, or refused in one line by file, row and column."""
import importlib.util
import io
import sys
import unittest
from contextlib import redirect_stderr, redirect_stdout
from unittest import mock

import numpy
from record_folder import FEET, KLBF, Folder

if importlib.util.find_spec("scipy") is None:
    print("skipped: python3-scipy is not installed")
    sys.exit(77)
from drill_rig_sim import calibrate_command
from drill_rig_sim.campaign.plan_text import PlanError, plan_of
from drill_rig_sim.field import progress
from drill_rig_sim.field.fit_plan import RecordError, weights_of
from drill_rig_sim.field.models import places_of
from drill_rig_sim.sim import static

ROWS = ((600.0, 87.5, 83.0), (900.0, 104.25, 94.5), (1200.0, 122.0, 104.0))
PLAIN = "MD,PU,SO\n" + "".join("%g,%g,%g\n" % row for row in ROWS)
FIT = "{file: t.csv, depth: {column: MD, unit: m}, pick_up: {column: PU, unit: klbf}, slack_off: {column: SO, unit: klbf}}"
NO_UNITS = FIT.replace(", unit: m", "").replace(", unit: klbf", "")


class Weights(Folder):
    def weights(self, text, fit=FIT, encoding="utf-8"):
        self.file("t.csv", text, encoding)
        return weights_of(plan_of(self.file("f.yaml", fit)), self.folder)[:3]

    def test_what_is_read(self):
        comma = PLAIN.replace(",", ";").replace(".", ",")
        quoted = "\n".join(",".join('"%s"' % cell.replace(".", ",") for cell in line.split(",")) for line in PLAIN.splitlines())
        for what, text, fit, encoding in (
                ("plain", PLAIN, FIT, "utf-8"), ("units after the names", PLAIN.replace("SO\n", "SO\nm,klbf,klbf\n"), NO_UNITS, "utf-8"), ("decimal commas", comma, FIT, "utf-8"),
                ("units in the names", PLAIN.replace("MD,PU,SO", "MD (m),PU (klbf),SO (klbf)"), NO_UNITS.replace("MD", "MD (m)").replace("PU", "PU (klbf)").replace("SO", "SO (klbf)"), "utf-8"),
                ("commas in quotes", quoted, FIT[:-1] + ", decimal: comma}", "utf-8"), ("title", "Weights of A-1\n\n" + PLAIN, FIT, "utf-8"), ("blanks", PLAIN.replace(",", "   "), FIT, "utf-8"),
                ("UTF-16", PLAIN, FIT, "utf-16"), ("mark", PLAIN, FIT, "utf-8-sig"), ("latin-1", "# °\n" + PLAIN, FIT, "latin-1"), ("small letters", PLAIN, FIT.replace("MD", "md"), "utf-8")):
            with self.subTest(what):
                depths, found, _ = self.weights(text, fit, encoding)
                numpy.testing.assert_allclose(depths, [row[0] for row in ROWS])
                numpy.testing.assert_allclose(found["pick_up"], [KLBF * row[1] for row in ROWS])
                numpy.testing.assert_allclose(found["slack_off"], [KLBF * row[2] for row in ROWS])
        self.assertAlmostEqual(600.0 * FEET, self.weights(PLAIN, FIT.replace("unit: m", "unit: ft"))[0][0])
        self.assertEqual(1, len(self.weights("".join(PLAIN.splitlines(True)[:2]))[0]))
        self.assertEqual(4, len(self.weights(PLAIN + "600,87.5,83\n")[0]))

    def test_names_of_the_trade(self):
        rows = "".join("%g,%g,%g,%g\n" % (*row, 0.5 * (row[1] + row[2])) for row in ROWS)
        for names in ("MD (m),PU (klbf),SO (klbf),ROT (klbf)", "Depth (m),Pick Up (klbf),Slack Off (klbf),Rotating (klbf)", "Bit Depth (m),PU Wt (klbs),SO Wt (klbs),Rot Wt (klbs)",
                      "Depth,Pick-up Weight,Slack-off Weight,Rotating Weight\nm,klbs,klbs,klbs", "Measured Depth [m],PICKUP [klbf],SLACKOFF [klbf],FREE ROTATING [klbf]"):
            with self.subTest(names):
                depths, found, _ = self.weights(names + "\n" + rows, "{file: t.csv}")
                numpy.testing.assert_allclose(depths, [row[0] for row in ROWS])
                self.assertEqual(["pick_up", "slack_off", "rotating"], list(found))
                for place, name in enumerate(("pick_up", "slack_off")):
                    numpy.testing.assert_allclose(found[name], [KLBF * row[1 + place] for row in ROWS])
        for names in ("Depth (m),PU (klbf),Pick Up (klbf),ROT (klbf)", "TVD (m),PU (klbf),SO (klbf),ROT (klbf)"):
            with self.subTest(names), self.assertRaises((RecordError, PlanError)):
                self.weights(names + "\n" + rows, "{file: t.csv}")

    def test_weights_that_are_not_recognised(self):
        """Up and Down are; other columns of forces are reported where the pick-up or slack-off weight is missing."""
        depths, found, remarks = self.weights(PLAIN.replace("MD,PU,SO\n", "Depth,Up,Down\nm,klbf,klbf\n"), "{file: t.csv}")
        self.assertEqual((len(ROWS), ["pick_up", "slack_off"]), (len(depths), list(found)))
        self.assertNotIn("no column is recognised", "\n".join(remarks))
        rows = "".join("%g,%g,%g,%g\n" % (*row, 0.5 * (row[1] + row[2])) for row in ROWS)
        for names, said in (("MD (m),Hoist (klbf),Lower (klbf),ROT (klbf)", "no column is recognised as pick_up and slack_off; pick_up: {column: NAME} in the fit's file can name it: Hoist (klbf), Lower (klbf)"),
                            ("MD (m),PU (klbf),Lower (klbf),ROT (klbf)", "no column is recognised as slack_off; slack_off: {column: NAME} in the fit's file can name it: Lower (klbf)"),
                            ("MD (m),PU (klbf),SO (klbf),WOB (klbf)", ""), ("MD (m),PU (klbf),SO model (klbf),ROT (klbf)", "")):
            with self.subTest(names):
                remarks = [line.partition(".csv: ")[2] for line in self.weights(names + "\n" + rows, "{file: t.csv}")[2] if "recognised" in line]
                self.assertEqual([said] if said else [], remarks)

    def test_errors_of_weights_that_drill_weights_has_found(self):
        self.file("t.csv", "motion,rows,deviation (N),depth (m),pick_up (N),slack_off (N)\npick_up,8,1000,900,400e3,\nslack_off,2,3000,890,,350e3\n")
        fit = plan_of(self.file("f.yaml", "{file: t.csv}"))
        numpy.testing.assert_allclose(weights_of(fit, self.folder)[3], [500.0, 3000.0])  # 1000/sqrt(8/2), 3000/sqrt(2/2)
        self.file("t.csv", PLAIN.replace("MD,PU,SO", "depth (m),pick_up (klbf),slack_off (klbf)"))
        numpy.testing.assert_array_equal(weights_of(fit, self.folder)[3], numpy.zeros(3))

    def test_each_weight_holds_out_its_own_deepest_rows(self):
        depths, nothing = numpy.array([400.0, 100.0, 300.0, 200.0]), numpy.nan
        for weights, places in (([4.0, 1.0, 3.0, 2.0], [0.875, 0.0, 0.625, 0.375]), ([4.0, nothing, nothing, 2.0], [0.75, nothing, nothing, 0.0]),
                                ([4.0, nothing, nothing, nothing], [0.0, nothing, nothing, nothing]), ([nothing] * 4, [nothing] * 4)):
            numpy.testing.assert_equal(places_of(depths, numpy.array(weights)), places)

    def test_what_is_reported(self):
        for cell, fit in (("", FIT), ("-999.25", FIT), ("N/A", FIT), ("0", FIT[:-1] + ", null: 0}")):
            _, found, remarks = self.weights(PLAIN.replace("104.25", cell), fit)
            self.assertTrue(numpy.isnan(found["pick_up"][1]))
            self.assertIn("t.csv: pick_up: 1 of 3 rows hold no measurement", "\n".join(remarks))
        self.assertIn("1 cells of PU hold text, not a number (first: ", "\n".join(self.weights(PLAIN.replace("104.25", "stuck"))[2]))
        self.assertIn("3 of 3 rows have a pick-up weight below the slack-off weight", "\n".join(self.weights(PLAIN.replace("PU,SO", "SO,PU"))[2]))
        self.assertEqual([], self.weights(PLAIN)[2])

    def test_what_no_string_has(self):
        """Zeros are left out; another unit, a slip of the pen and a rotating weight beyond the others are reported."""
        for cell in ("0", "0.00", "-104.25"):
            _, found, remarks = self.weights(PLAIN.replace("104.25", cell))
            self.assertEqual([False, True, False], list(numpy.isnan(found["pick_up"])))
            self.assertIn("t.csv: pick_up: 1 weights of 0 or below are left out (first: %s/t.csv:3)" % self.folder, "\n".join(remarks))
        tared = self.weights("depth (m),slips_up (kN),pick_up (kN)\n900,0,400\n", "{file: t.csv}")
        self.assertEqual(([0.0], []), (list(tared[1]["slips_up"]), tared[2]))
        _, _, remarks = self.weights(PLAIN, FIT.replace("klbf", "lbf"))
        self.assertEqual(2, sum("less than a block weighs; is its unit right?" in line for line in remarks), remarks)
        for wrong in ("1042.5", "10.425"):
            far = [line for line in self.weights(PLAIN.replace("104.25", wrong))[2] if "is far from" in line]
            self.assertEqual(1, len(far))
            self.assertIn("kN at 900 m is far from those at similar depths, about 466 kN (%s/t.csv:3); check it" % self.folder, far[0])
        self.assertEqual([], self.weights("MD,PU,SO\n0,30,30\n1000,100,95\n3000,250,200\n")[2])
        table = "depth (m),pick_up (kN),slack_off (kN),rotating (kN)\n600,400,380,%g\n900,470,430,450\n"
        for rotating, odd in ((390, 0), (350, 0), (435, 0), (330, 1), (450, 1)):  # the sheaves' friction and the gauge count
            self.assertEqual(odd, len([line for line in self.weights(table % rotating, "{file: t.csv}")[2] if "1 of 2 rows have a rotating weight" in line]), rotating)

    def test_depths_that_are_repeated(self):
        """With another weight they are reported, in a table of drill weights each is a move of its own."""
        again = [line for line in self.weights(PLAIN + "900,110,94.5\n1200,125,105\n")[2] if "again" in line]
        self.assertEqual(2, len(again), again)
        self.assertIn("pick_up: 2 rows hold a depth again with another weight, and each is used (first: %s/t.csv:5: 489.3 kN at 900 m, %s/t.csv:3: 463.7 kN)" % (self.folder, self.folder), again[0])
        self.assertIn("slack_off: 1 rows hold", again[1])
        self.assertEqual([], self.weights(PLAIN + "900,104.25,94.5\n")[2])
        self.assertEqual([], self.weights("motion,depth (m),pick_up (kN)\nup,600,400\nup,600,410\n", "{file: t.csv}")[2])

    def test_weights_of_another_unit(self):
        """190 tf at 3000 m are a string, 190 kgf and 1.9 kN are none."""
        table = "depth (m),pick_up (%s)\n1000,120\n2000,150\n3000,190\n"
        for unit, lines in (("tf", 0), ("klbf", 0), ("kgf", 1), ("kN", 0), ("daN", 1)):
            with self.subTest(unit):
                self.assertEqual(lines, sum("is its unit right?" in line for line in self.weights(table % unit, "{file: t.csv}")[2]))

    def test_columns_that_are_known_by_their_names(self):
        """Rows with several weights, of which a missing one is reported; and rows with one each, as drill weights writes them, of which none is missing. The torque must be named."""
        names = PLAIN.replace("MD,PU,SO", "depth (m),pick_up (klbf),slack_off (klbf)")
        depths, found, remarks = self.weights(names, "{file: t.csv}")
        self.assertEqual(["pick_up", "slack_off"], list(found))
        numpy.testing.assert_allclose(depths, [row[0] for row in ROWS])
        numpy.testing.assert_allclose(found["pick_up"], [KLBF * row[1] for row in ROWS])
        self.assertEqual([], remarks)
        self.assertEqual(1, len(self.weights(names.replace("104.25", ""), "{file: t.csv}")[2]))
        numpy.testing.assert_allclose(found["slack_off"], self.weights(names.replace(",", ";").replace(".", ","), "{file: t.csv, delimiter: semicolon, decimal: comma}")[1]["slack_off"])
        moves = "motion,depth (m),pick_up (kN),rotating_after_up (kN),torque (kN.m)\nup,600,400,,\nturn,590,,370,8\n"
        _, found, remarks = self.weights(moves, "{file: t.csv}")
        self.assertEqual((["pick_up", "rotating_after_up"], []), (list(found), remarks))
        numpy.testing.assert_array_equal(found["rotating_after_up"], [numpy.nan, 370e3])
        with_torque = "{file: t.csv, depth: {column: depth (m)}, rotating_after_up: {column: rotating_after_up (kN)}, torque: {column: torque (kN.m), unit: kN.m}}"
        numpy.testing.assert_array_equal(self.weights(moves, with_torque)[1]["torque"], [numpy.nan, 8e3])

    def test_names_of_other_languages(self):
        for names in ("Teufe (m),Hakenlast aufwärts (kN),Hakenlast abwärts (kN),Hakenlast drehend (kN)", "Profundidad (m),Subiendo (kN),Bajando (kN),Rotando (kN)",
                      "Глубина (м),Вес при подъеме (кН),Вес при спуске (кН),Вес при вращении (кН)"):
            depths, weights = self.weights(names + "\n600,400,380,390\n900,470,420,445\n", "{file: t.csv}")[:2]
            numpy.testing.assert_allclose(depths, [600, 900], err_msg=names)
            for name, there in (("pick_up", [400e3, 470e3]), ("slack_off", [380e3, 420e3]), ("rotating", [390e3, 445e3])):
                numpy.testing.assert_allclose(weights[name], there, err_msg=names)

    def test_units_in_the_cells(self):
        text = "Depth,Pick up,Slack off\n" + "".join("%g m,%g kN,%g kN\n" % row for row in ((600, 400, 380), (900, 470, 420), (1200, 540, 470)))
        depths, weights = self.weights(text, "{file: t.csv}")[:2]
        numpy.testing.assert_allclose(depths, [600, 900, 1200])
        numpy.testing.assert_allclose(weights["pick_up"], [400e3, 470e3, 540e3])
        with self.assertRaisesRegex(RecordError, "t.csv:3: Pick up: 105 klbf is in another unit than the cells before .kN.; needed: one unit in a column"):
            self.weights(text.replace("470 kN,420", "105 klbf,420"), "{file: t.csv}")

    def test_what_is_refused(self):
        for text, fit, said in (
                (PLAIN.replace("SO", "S0"), FIT, "t.csv: there is no column SO; columns: MD, PU, S0"), (PLAIN.replace("SO", "PU"), FIT, "there are 2 columns PU"), ("MD,PU,SO\n", FIT, "t.csv: has no rows"),
                (PLAIN, NO_UNITS, "MD has no unit in the file"), (PLAIN.replace("SO\n", "SO\nft,klbf,klbf\n"), FIT, "the map says m, the file ft"),
                (PLAIN, FIT.replace("klbf}, s", "stone}, s"), "f.yaml:1: pick_up.unit: unit stone is not known for a force"), (PLAIN, FIT.replace("klbf}, s", "ton}, s"), "f.yaml:1: pick_up.unit: unit ton is ambiguous"),
                (PLAIN.replace("900", "nan"), FIT, "t.csv:3: MD: nan is not a depth of a well"), (PLAIN.replace("900", ""), FIT, "t.csv:3: MD: an empty cell is not a depth"),
                (PLAIN.replace("900", "-900"), FIT, "t.csv:3: MD: -900 is not a depth"), (PLAIN.replace("900", "-1"), FIT, "t.csv:3: MD: -1 is not a depth of a well"), (PLAIN.replace("104.25", '"104,25"'), FIT, "t.csv:3: PU: 104,25 is not a number with a decimal point"),
                (PLAIN.replace("104.25,", ""), FIT, "t.csv:3: has 2 cells, the header 3"), (PLAIN, "{file: t.csv, depth: {column: MD, unit: m}}", "needs depth and one or more of pick_up"),
                (PLAIN, "{file: t.csv}", "t.csv: bit_depth: MD has no unit in the file"), (PLAIN.replace("MD", "X"), "{file: t.csv}", "f.yaml:1: needs depth and one or more of pick_up")):
            with self.assertRaises((PlanError, RecordError), msg=said) as caught:
                self.weights(text, fit)
            self.assertIn(said, str(caught.exception))
            self.assertNotIn("\n", str(caught.exception))


class Fits(Folder):
    WELL = """name: well
well: {stations: [[0, 0, 0], [300, 0, 0], [900, 40, 0], [1500, 40, 0]], sections: [{to: 1500, diameter: 0.2159, friction: 0.25}]}
formation: [{to_tvd: 10000, drillability: 1.0e-8}]
mud: {density: 1200}
string:
  - {name: bit, type: bit, length: 0.3, mass: 40, diameter: 0.2159}
  - {name: collar, type: collar, joints: 6, joint_length: 9.4, outer_diameter: 0.165, inner_diameter: 0.0714, linear_mass: 136.0}
  - {name: pipe, type: pipe, joints: fill, joint_length: 9.5, outer_diameter: 0.127, inner_diameter: 0.1086, linear_mass: 31.9, tool_joint_diameter: 0.168}
start: {bit_depth: 1400, block_height: 20}
instruments: {surface: {hook_load: {place: block}}}
"""
    PLAN = """scene: well.yaml
table: {file: t.csv}
held_out: 0.0
parameters: [{name: friction, key: "well.sections[0].friction", start: 0.2, from: 0.0, to: 0.8}]
"""

    def fitted(self, mass, below=""):
        """What a fit says to weights of pipe of 31.9 kg/m in a scene with pipe of another mass."""
        file = self.file("well.yaml", self.WELL)
        weights = [static(file, motion)["hook_load_gauge"] for motion in ("up", "down", "rotate")]
        self.file("well.yaml", self.WELL.replace("31.9", mass))
        self.file("t.csv", "depth (m),pick_up (N),slack_off (N),rotating (N)\n1400,%.6g,%.6g,%.6g\n" % tuple(weights) + below)
        out, told = io.StringIO(), io.StringIO()
        with mock.patch.object(progress, "EVERY", float("inf")), redirect_stdout(out), redirect_stderr(told):  # however slow the machine is
            self.assertEqual(0, calibrate_command.main([self.file("fit.yaml", self.PLAN)]), told)
        return out.getvalue(), told.getvalue()

    def test_a_string_that_is_too_light(self):
        """2.88 kg/m less over 1343.3 m of pipe, in mud of 1200 kg/m3: 32.1 kN along the hole, 27 kN of its vertical part."""
        out, told = self.fitted("29.02")
        self.assertRegex(out, r"all 3 weights of the string are larger than predicted, by 2\d\.\d kN in the mean: no friction explains that")
        self.assertIn("string[2].linear_mass: 29.02 kg/m is 1.09 times the mass of its body", told)
        out, told = self.fitted("31.9")
        self.assertNotIn("all 3 weights", out)
        self.assertEqual("", told)

    def test_a_depth_below_the_hole(self):
        out, _ = self.fitted("31.9", "1600,900000,,\n")
        self.assertRegex(out, r"1 numbers could not be predicted \(first: pick_up at 1600.00 m\): .*start.bit_depth: 1600 m is below the hole's bottom, allowed: up to 1500 m")
        self.assertIn("1600.00 m): %s/well.yaml:9: start.bit_depth" % self.folder, out)


if __name__ == "__main__":
    unittest.main()
