#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Audits of campaigns: which runs they are, that they are verified once, and what the page says of them."""
import contextlib
import io
import json
import os
import unittest
from unittest import mock

import test_campaign_parts as parts  # ends where Dask is not installed
from drill_rig_sim.campaign import audits, command, report, report_audits
from drill_rig_sim.campaign.plan import read_plan
from drill_rig_sim.campaign.plan_text import PlanError
from drill_rig_sim.campaign.results import AUDITS, AUDITS_TABLE, Results
from drill_rig_sim.campaign.runner import Runner, outcome
from drill_rig_sim.lockstep import Refused
from drill_rig_sim.sim import Simulator

ABOUT = {"outputs": ["load", "torque"], "report": {"worst": "torque"}, "sample": {"seed": 3}}


def rows(number, status="good"):
    """The load grows with the number, the torque falls."""
    return [{"number": k, "key": "k%d" % k, "status": status, "outputs": {"load": float(k), "torque": -float(k)}} for k in range(number)]


class Chosen(unittest.TestCase):
    def test_small_campaigns_have_none_unless_their_plan_asks(self):
        self.assertEqual({}, audits.chosen(rows(19), ABOUT))
        self.assertEqual(3, len(audits.chosen(rows(20), ABOUT)))
        self.assertEqual({}, audits.chosen(rows(20), {**ABOUT, "audit": 0.0}))
        self.assertIn(audits.DRAWN, " ".join(audits.chosen(rows(3), {**ABOUT, "audit": 0.5}).values()))

    def test_a_share_is_drawn_by_the_seed(self):
        drawn = lambda seed: [n for n, why in audits.chosen(rows(500), {**ABOUT, "sample": {"seed": seed}}).items() if why.startswith(audits.DRAWN)]  # noqa: E731
        self.assertEqual((10, drawn(3)), (len(drawn(3)), drawn(3)))
        self.assertNotEqual(drawn(3), drawn(4))
        self.assertEqual(500, len(audits.chosen(rows(500), {**ABOUT, "audit": 1.0})))

    def test_runs_that_did_not_end_well_are_none(self):
        some = rows(100)
        for row in some[50:]:
            row.update(status="cpu", outputs={})
        self.assertLess(max(audits.chosen(some, ABOUT)), 50)
        self.assertEqual({}, audits.chosen(rows(100, "cpu"), ABOUT))

    def test_the_extremes_of_each_result_the_pages_worst_first(self):
        found = {n: why for n, why in audits.chosen(rows(100), ABOUT).items() if "torque" in why or "load" in why}
        self.assertEqual({0, 99}, set(found))
        self.assertRegex(found[99], "least torque, largest load$")
        many = [{**row, "outputs": {str(k): (row["number"] + 7 * k) % 100 for k in range(50)}} for row in rows(100)]
        names = {**ABOUT, "outputs": [str(k) for k in range(50)], "report": {"worst": "0"}}
        self.assertEqual(audits.EXTREMES, len(set(row["number"] for _, row in audits.extremes(many, audits.ordered(names), 10))))
        self.assertEqual(2, len(set(row["number"] for _, row in audits.extremes(many, audits.ordered(names), 2))))

    def test_the_same_run_twice_counts_once(self):
        twice = rows(30) + [{**row, "number": row["number"] + 30} for row in rows(30)]
        self.assertLess(max(audits.chosen(twice, {**ABOUT, "audit": 1.0})), 30)

    def test_a_histogram_has_an_edge_at_the_tolerance(self):
        for worst in ([0.001, 0.3], [0.0], [5.0], [0.02]):
            edges = audits.bins(worst, 0.02)
            self.assertLess(min(abs(edges - 0.02)), 1e-12)
            self.assertLessEqual(edges[0], max(max(worst), 0.02))
            self.assertGreaterEqual(edges[-1], max(worst))


class Verified(parts.Folder):
    PLAN = parts.PLAN.replace("duration: 0.3", "duration: 6.0").replace("steps: 3", "steps: 1") + "audit: 1.0\n"
    BY_PROGRAM = """scene: %s
duration: 6.0
factors: [{name: friction, key: "well.sections[*].friction", values: [0.2, 0.3]}]
sample: {kind: list}
outputs: {load: mean.truth.hook_load}
audit: 1.0
""" % parts.QUICK

    def test_a_run_with_a_controller_is_verified_beside_finer_models_that_get_its_commands(self):
        blueprint = read_plan(self.plan(self.PLAN)).blueprint
        status, reason, found, over = outcome(blueprint, [60.0, 0.2], verified=True)
        self.assertIn(status, audits.VERDICTS)
        self.assertEqual(("", status), (reason, found["verdict"]))
        json.dumps(found, allow_nan=False)
        self.assertEqual({"hook_load", "torque", "wob", "rop", "bit_speed", "stand_pipe_pressure"}, set(found["outputs"]))
        turning = found["outputs"]["bit_speed"]
        self.assertAlmostEqual(1.0, turning["mean"] / turning["finest_mean"], delta=0.1)
        self.assertEqual(2, len(turning["off"]))  # windows of 3 s
        alone = outcome(blueprint, [60.0, 0.2])[3]
        self.assertEqual(list(alone.truth("torque")), list(over.truth("torque")))

    def test_a_simulator_is_verified_from_its_start_on(self):
        rig = Simulator(parts.QUICK)
        with self.assertRaisesRegex(Refused, "nothing is verified: call verify"):
            rig.verified()
        with self.assertRaisesRegex(Refused, "times must be between 1.2 and 8"):
            rig.verify(0.5)
        rig.save("begin")
        rig.verify(1.5)
        rig.step(0.1)
        self.assertEqual([1.5, 2.25], list(rig.verified()["refined"]))
        with self.assertRaisesRegex(Refused, "cannot be reset or restored"):
            rig.restore("begin")
        rig.reset()
        rig.step(0.1)
        with self.assertRaisesRegex(Refused, "before the first"):
            rig.verify()

    def test_bounds_are_wider_and_hold(self):
        blueprint = read_plan(self.plan(self.PLAN + "bounds: {cpu: 1.0e-4}\n")).blueprint
        runner = Runner(blueprint)
        self.addCleanup(runner.end)
        status, reason, found, _ = runner.run([60.0, 0.2], None, True)
        self.assertEqual(("cpu", "took more than 0.005 s of processor time", {}), (status, reason, found))

    def test_a_share_is_a_number_up_to_1(self):
        for said in ("-0.1", "1.5", "all"):
            with self.assertRaisesRegex(PlanError, r"plan.yaml:\d+: audit: .*needed: a number from 0 up to 1"):
                read_plan(self.plan(parts.PLAN + "audit: %s\n" % said))

    def test_a_campaign_is_audited_once_and_its_page_says_what_was_found(self):
        words = self.plan(self.BY_PROGRAM), "--results", self.place("r.sqlite"), "--workers", "1"
        status, out, told = parts.drill_campaign(*words)
        self.assertEqual(0, status, told)
        self.assertIn("r.sqlite: 2 runs are audited with two finer models each, 2 to do\n", out)
        self.assertRegex(out, r"\n2 runs were audited: 2 [a-z ,]+\n$")
        status, again, _ = parts.drill_campaign(*words)
        self.assertNotIn("are audited", again)
        self.assertEqual(out.splitlines()[-1], again.splitlines()[-1])
        parts.drill_campaign("report", self.place("r.sqlite"))
        with open(self.place("r.html"), encoding="utf-8") as text:
            text = text.read()
        for said in ("2 of 2 runs were played once more", "<td>hook_load</td>", "<th>wrong without a warning</th>", "Errors of audited runs", "audited because", "drawn, largest"):
            self.assertIn(said, text)

    def test_audits_that_did_not_end_are_not_known_and_done_again_when_asked(self):
        results = Results(self.place("r.sqlite"))
        self.addCleanup(results.close)
        results.describe(["a", "b"], name="n")
        found = {"verdict": "right", "tolerance": 0.02, "outputs": {}}
        results.add([("a", [1.0], "right", "", found, 1.0, "w"), ("b", [2.0], "failed", "a finer model failed", {}, 1.0, "w")], table=AUDITS)
        self.assertEqual("1 right, 1 not known", audits.summary(row["status"] for row in results.audits()))
        results.forget_bad(["a", "b"])
        self.assertEqual({"a"}, results.done(AUDITS))

    def test_runs_whose_error_was_not_measured_are_reported(self):
        why = "numerics.level is set by hand and numerics.companion is not"
        audited = [{"outputs": {"not_measured": why}}, {"outputs": {"not_measured": ""}}, {"outputs": {}}]
        self.assertEqual("1 of them did not measure their error, so that no warning could come: " + why, audits.unmeasured(audited))
        self.assertEqual("", audits.unmeasured(audited[1:]))
        self.assertEqual("", outcome(read_plan(self.plan(self.PLAN)).blueprint, [60.0, 0.2], verified=True)[2]["not_measured"])

    def test_files_of_an_older_version_have_no_audits(self):
        with mock.patch("drill_rig_sim.campaign.results.AUDITS_TABLE", "select 1"):
            Results(self.place("old.sqlite")).close()
        self.assertIn(AUDITS, AUDITS_TABLE)
        read = Results(self.place("old.sqlite"), write=False)
        self.assertEqual([], list(read.audits()))
        read.close()
        results = Results(self.place("old.sqlite"))
        self.addCleanup(results.close)
        self.assertEqual(set(), results.done(AUDITS))


class Page(unittest.TestCase):
    FINDING = {"needed": True, "verdict": "right", "worst": 0.004, "worst_until": 6.0}

    def page(self, *found, **about):
        rows_there = rows(2)
        rows_there[0].update(values=[1.0])
        return mock.Mock(rows=rows_there, factors=["f"], about={**ABOUT, **about},
                         audits=[{"number": k, "values": [1.0], "status": status, "reason": "", "outputs": {"tolerance": 0.02, "outputs": outputs}} for k, (status, outputs) in enumerate(found)])

    def test_why_there_are_none(self):
        self.assertIn("fewer than 20", report_audits.intro(self.page()))
        self.assertIn("is 0 in the plan", report_audits.intro(self.page(audit=0.0)))
        self.assertIn("not done yet", report_audits.intro(self.page(audit=0.1)))

    def test_outputs_are_counted_by_verdict_with_the_worst_run(self):
        page = self.page(("right", {"torque": self.FINDING}), ("missed", {"torque": {**self.FINDING, "verdict": "missed", "worst": 0.05}}))
        self.assertEqual([[2, 1, 0, 1, 0, "2.7 %", "5 %", 1, "torque"]], report_audits.table_by_output(page)[1])
        self.assertEqual(["wrong without a warning", "torque", "5 %", "6 s"], report_audits.table_of_runs(page)[1][1][1:5])
        self.assertEqual(1, len(report_audits.histograms(page).axes))
        report.report_pictures.plt.close("all")

    def test_an_audit_without_findings_is_listed_with_its_reason(self):
        page = self.page(("cpu", {}))
        page.audits[0].update(reason="took long", outputs={})
        self.assertEqual([], report_audits.table_by_output(page)[1])
        self.assertEqual([0, "not known", "", "", "", 1.0, "chosen before", "took long"], report_audits.table_of_runs(page)[1][0])
        self.assertIsNone(report_audits.histograms(page))

    def test_a_campaigns_end_tells_its_verdicts(self):
        out = io.StringIO()
        results = mock.Mock(rows=lambda: iter([]), audits=lambda: iter([{"status": "missed"}, {"status": "right"}]))
        with contextlib.redirect_stdout(out):
            command.print_outcome(results, 0)
        self.assertTrue(out.getvalue().endswith("2 runs were audited: 1 right, 1 wrong without a warning\n"), out.getvalue())


if __name__ == "__main__":
    os.environ.setdefault("MPLBACKEND", "Agg")
    unittest.main()
