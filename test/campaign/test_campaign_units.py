#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Units in campaigns: factors whose values carry one, and the page in oilfield units."""
import unittest

import test_campaign_parts as parts  # ends where Dask is not installed
import yaml
from drill_rig_sim.campaign import measures, report
from drill_rig_sim.campaign.outputs import shown_as
from drill_rig_sim.campaign.plan import read_plan
from drill_rig_sim.campaign.plan_text import PlanError
from drill_rig_sim.campaign.results import Results
from drill_rig_sim.campaign.scene_text import SceneText, Times


class Units(parts.Folder):
    FRICTION = 'friction, key: "well.sections[*].friction", from: 0.1, to: 0.4'

    def density(self, values):
        """A plan whose second factor is the mud's density."""
        return self.plan(parts.PLAN.replace(self.FRICTION, "density, key: mud.density, " + values))

    def test_values_and_ranges_may_carry_their_unit(self):
        for said, wanted in (("values: [9 ppg, 10.5 ppg]", [9.0, 10.5]), ("from: 9 ppg, to: 12 ppg", [9.0, 10.5, 12.0]),
                             ("from: 1 ppg, to: 100 ppg, log: true", [1.0, 10.0, 100.0])):
            plan = read_plan(self.density(said))
            rows = plan.rows[:len(wanted)]
            self.assertEqual([(number, "ppg") for number in wanted], [(round(number, 9), unit) for number, unit in (measures.split(row[1]) for row in rows)])
            self.assertEqual([row[1] for row in rows], [yaml.safe_load(plan.blueprint.scene_of(row))["mud"]["density"] for row in rows])

    def test_a_range_is_in_one_unit_and_multiplies_nothing(self):
        for said, refused in (("from: 9 ppg, to: 1400", "is 1400, needed: a number in ppg"), ("from: 900, to: 12 ppg", "is 12 ppg, needed: a number without a unit"),
                              ("from: 9 ppg, to: 8 ppg", "is 8 ppg, needed: a number above 9 ppg"), ("from: -1 ppg, to: 8 ppg, log: true", "is -1 ppg, needed: a number above 0 ppg"),
                              ("values: [9 ppg], times: true", "needed: numbers without units"), ("from: 9 ppg, to: 10 ppg, times: true", "needed: numbers without units")):
            with self.assertRaises(PlanError, msg=said) as told:
                read_plan(self.density(said))
            self.assertTrue(str(told.exception).startswith("%s:7: " % self.place("plan.yaml")), told.exception)
            self.assertIn(refused, str(told.exception))

    def test_a_factor_multiplies_a_number_with_its_unit(self):
        self.assertEqual({"a": '4.25 "'}, yaml.safe_load(SceneText('a: 8.5"\n', ["a"]).with_values({"a": Times(0.5)})))
        for there in ("10 ppg", '"10 ppg"', "10.0 ppg"):
            self.assertEqual({"a": "5.0 ppg"}, yaml.safe_load(SceneText("a: %s\n" % there, ["a"]).with_values({"a": Times(0.5)})))

    def test_what_is_a_number_with_a_unit(self):
        for text, parts_of in (("9.5 ppg", (9.5, "ppg")), ("5in", (5.0, "in")), ("-1e3 N", (-1e3, "N")), ("2 1/s", (2.0, "1/s")), ('8.5"', (8.5, '"')), ("12 '", (12.0, "'")), ("800 gal/min", (800.0, "gal/min")), ("3e-9", (None, "")), ("9.5", (None, "")),
                               ("3E5", (None, "")), ("ppg", (None, "")), ("stribeck", (None, "")), (9.5, (None, "")), (True, (None, ""))):
            self.assertEqual(parts_of, measures.split(text), text)

    def test_a_unit_of_another_quantity_is_refused_by_the_plans_line(self):
        status, _, told = parts.drill_campaign(self.density("from: 9 psi, to: 12 psi"), "--check")
        self.assertEqual(2, status)
        self.assertIn("plan.yaml:7: ", told)
        self.assertIn("mud.density: psi is a pressure; allowed: kg/m3, g/cm3, ppg, lbm/ft3", told)

    def test_the_page(self):
        status, _, told = parts.drill_campaign(self.density("values: [9 ppg, 10 ppg]"), "--results", self.place("r.sqlite"), "--workers", "1")
        self.assertEqual(0, status, told)
        parts.drill_campaign("report", self.place("r.sqlite"))
        parts.drill_campaign("report", self.place("r.sqlite"), "--units", "oilfield", "--out", self.place("oilfield.html"))
        for page, label in (("r.html", "torque"), ("oilfield.html", "torque [kft.lbf]")):
            with open(self.place(page), encoding="utf-8") as text:
                self.assertIn("<td>%s</td>" % label, text.read())
        results = Results(self.place("r.sqlite"), write=False)
        in_si, oilfield = report.Rows(results), report.Rows(results, "oilfield")
        self.assertEqual(([9.0, 10.0] * 2, "density [ppg]"), (in_si.factor("density"), in_si.label("density")))
        for newton_metres, shown in zip(in_si.output("torque"), oilfield.output("torque")):
            self.assertAlmostEqual(newton_metres, 1355.8179483314004 * shown, places=9)

    def test_quantities_of_outputs(self):
        self.assertEqual(("force", 1.0), shown_as("mean.truth.hook_load"))
        self.assertEqual(("force", 1.0), shown_as("wob.deviation"))
        self.assertEqual("penetration", shown_as("drilling.rop_on_bottom_m_h")[0])
        self.assertIsNone(shown_as("mean.truth.no_such"))


if __name__ == "__main__":
    unittest.main()
