#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Campaigns, the parts: scenes with other values, designs, indices, plans, runs that fail. Their results: test_campaign_results.py."""
import importlib.util
import io
import math
import os
import re
import subprocess
import sys
import tempfile
import time
import unittest
from contextlib import redirect_stderr, redirect_stdout
from types import SimpleNamespace
from unittest import mock

if not all(map(importlib.util.find_spec, ("distributed", "scipy"))):
    print("skipped: Dask is not installed (python3-distributed, python3-scipy: ./test/run --campaigns)")
    sys.exit(77)
import numpy
import yaml
from drill_rig_sim.campaign import command, engine, played, report_pictures, sensitivity
from drill_rig_sim.campaign.designs import DesignError, Factor, rows_of
from drill_rig_sim.campaign.plan import read_plan
from drill_rig_sim.campaign.plan_text import PlanError
from drill_rig_sim.campaign.runner import Runner
from drill_rig_sim.campaign.scene_text import SceneText, SceneTextError, Times
from drill_rig_sim.sim import build

HERE = os.path.dirname(os.path.abspath(__file__))
SOURCE = os.path.dirname(os.path.dirname(HERE))
QUICK = os.path.join(SOURCE, "config/scenes/quick.yaml")
PLAN = """name: made up
scene: %s
duration: 0.3
controller: {class: "%s/laws.py:Law", parameters: {rpm: 60.0}}
factors:
  - {name: rpm, key: controller.rpm, values: [30.0, 60.0]}
  - {name: friction, key: "well.sections[*].friction", from: 0.1, to: 0.4}
sample: {kind: grid, steps: 3}
outputs: {turned: "%s/laws.py:turned", torque: largest.truth.torque}
""" % (QUICK, HERE, HERE)


class Folder(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def place(self, name):
        return os.path.join(self.folder, name)

    def plan(self, text=PLAN):
        with open(self.place("plan.yaml"), "w", encoding="utf-8") as out:
            out.write(text)
        return self.place("plan.yaml")


class Pages(unittest.TestCase):
    def test_dasks_own_page_is_told_where_it_can_be_shown(self):
        client = SimpleNamespace(dashboard_link="http://127.0.0.1:8787/status")
        for there, page in ((None, None), (True, client.dashboard_link)):
            with mock.patch("importlib.util.find_spec", lambda name, there=there: {"bokeh": there}[name]):
                self.assertEqual(page, engine.page(client))


class Scenes(unittest.TestCase):
    TEXT = "a: 1.0  # kept\nlist:\n  - {name: x, v: 2}\n  - {name: y, v: 4}\nblock:\n  in: {c: 3e-9}\n"

    def with_values(self, values):
        return yaml.safe_load(SceneText(self.TEXT, list(values)).with_values(values))

    def test_values_are_replaced_where_they_stand(self):
        text = SceneText(self.TEXT, ["a", "list[1].v"]).with_values({"a": 1e-9, "list[1].v": 5})
        self.assertEqual(self.TEXT.replace("1.0 ", "1.0e-09 ").replace("v: 4", "v: 5"), text)

    def test_a_number_is_written_as_a_number_whatever_shows_it(self):
        class OfNumpy2(float):
            def __repr__(self):
                return "np.float64(%s)" % float(self)
        self.assertEqual({"a": 1492.5, "list": [{"name": "x", "v": 2}, {"name": "y", "v": 1e-9}]},
                         {name: value for name, value in self.with_values({"a": OfNumpy2(1492.5), "list[1].v": OfNumpy2(1e-9)}).items() if name != "block"})

    def test_by_name_and_all_of_a_list_and_times(self):
        self.assertEqual([7, 4], [item["v"] for item in self.with_values({"list[x].v": 7})["list"]])
        self.assertEqual([1.0, 2.0], [item["v"] for item in self.with_values({"list[*].v": Times(0.5)})["list"]])
        self.assertEqual(6e-9, self.with_values({"block.in.c": Times(2.0)})["block"]["in"]["c"])

    def test_what_the_file_leaves_out_is_put_in(self):
        found = self.with_values({"block.in.d": 1.5, "block.new.deep.e": True, "block.new.deep.f": "text", "g.h": [1, 2.5]})
        self.assertEqual({"in": {"c": "3e-9", "d": 1.5}, "new": {"deep": {"e": True, "f": "text"}}}, found["block"])
        self.assertEqual({"h": [1, 2.5]}, found["g"])
        self.assertEqual(1.0, found["a"])

    def test_lines_of_the_users_text(self):
        values = {"a": 2.0, "block.new.e": 1, "block.new.f": 2, "block.z": 3, "list[y].v": 5, "list[x].w": 6, "g": 7}
        text = SceneText(self.TEXT, list(values))
        lines = [text.line_of(number, values) for number in range(1, text.with_values(values).count("\n") + 1)]
        self.assertEqual([None, 1, 2, 3, 4, 5, None, None, 6], lines)  # g before a, new and z before in
        multiple = SceneText("a: [1,\n  2]\nb: 3\n", ["a"])
        self.assertEqual([1, 3], [multiple.line_of(number, {"a": [4.0]}) for number in (1, 2)])

    def test_what_is_no_place_is_told(self):
        for key, said in (("list[2].v", r"no \[2\]"), ("list[z].v", r"no \[z\]"), ("a.b", "is not a section"), ("a[0]", "not a list"), ("x..y", "is not a key"),
                          ("list", "is a section"), ("m[0].n", "has no m")):
            with self.assertRaisesRegex(SceneTextError, said, msg=key):
                SceneText(self.TEXT, [key])
        with self.assertRaisesRegex(SceneTextError, "are the same key"):
            SceneText(self.TEXT, ["list[0].v", "list[x].v"])
        with self.assertRaisesRegex(SceneTextError, "it cannot be multiplied"):
            self.with_values({"block.q": Times(2.0)})
        with self.assertRaisesRegex(SceneTextError, "is not a number"):
            self.with_values({"list[x].name": Times(2.0)})


class Designs(unittest.TestCase):
    A, B = Factor("a", values=[1, 2, 3]), Factor("b", low=1e-3, high=1e1, log=True)

    def test_grid_and_list(self):
        self.assertEqual([[1, 1e-3], [1, 0.1], [1, 10.0]], [[a, round(b, 9)] for a, b in rows_of([self.A, self.B], "grid", steps=3)[:3]])
        self.assertEqual([1e-3, 0.1, 10.0], [round(row[1], 9) for row in rows_of([self.A, self.B], "list", steps=3)])
        with self.assertRaisesRegex(DesignError, "3 of a, 2 of b"):
            rows_of([self.A, self.B], "list", steps=2)

    def test_samples_fill_the_range_and_repeat(self):
        for kind in ("latin_hypercube", "sobol"):
            rows = rows_of([self.A, self.B], kind, runs=64, seed=4)
            self.assertEqual(rows, rows_of([self.A, self.B], kind, runs=64, seed=4))
            self.assertNotEqual(rows, rows_of([self.A, self.B], kind, runs=64, seed=5))
            self.assertEqual(64, len(rows))
            logs = numpy.log10([row[1] for row in rows])
            self.assertEqual([16] * 4, list(numpy.histogram(logs, 4, (-3.0, 1.0))[0]))

    def test_indices_of_ishigamis_function(self):
        """Closed form: a = 7, b = 0.1: first order 0.3139, 0.4424, 0; total 0.5576, 0.4424, 0.2437."""
        rows = numpy.array(rows_of([Factor(str(k), low=-math.pi, high=math.pi) for k in range(3)], "saltelli", runs=2048, seed=1))
        outputs = numpy.sin(rows[:, 0]) + 7.0 * numpy.sin(rows[:, 1])**2 + 0.1 * rows[:, 2]**4 * numpy.sin(rows[:, 0])
        for found, first, total in zip(sensitivity.indices(outputs, 3), (0.3139, 0.4424, 0.0), (0.5576, 0.4424, 0.2437)):
            self.assertLess(abs(found[0] - first), max(found[1], 0.02))
            self.assertLess(abs(found[2] - total), max(found[3], 0.02))
            self.assertLess(found[1], 0.08)

    def test_no_indices_of_what_is_not_there(self):
        self.assertIsNone(sensitivity.indices([1.0] * 50, 3))
        self.assertIsNone(sensitivity.indices([None] * 50, 3))
        self.assertEqual([1.0, None, None], sensitivity.rank_correlations([[1, 2, 3], ["a", "b", "c"], [2, 2, 2]], [1.0, 4.0, 9.0]))

    def test_correlations_say_what_the_map_shows(self):
        """A factor that acts one way in one mode and the other way in another: pooled it would seem to do nothing."""
        columns = {"mode": ["a"] * 4 + ["b"] * 4, "x": [1, 2, 3, 4] * 2}
        rows = SimpleNamespace(about={"report": {"each": "mode"}}, factors=["mode", "x"], good=[None] * 8, factor=columns.get,
                                     output=lambda name: numpy.array([1.0, 2.0, 3.0, 4.0, 4.0, 3.0, 2.0, 1.0]))
        self.assertEqual({"mode a": [None, 1.0], "mode b": [None, -1.0]}, report_pictures.correlations_of(rows, "y"))
        rows.about["report"]["each"] = None
        self.assertEqual([0.0], [round(value, 9) for value in report_pictures.correlations_of(rows, "y")[""][1:]])


class Plans(Folder):
    def test_a_plan(self):
        plan = read_plan(self.plan())
        self.assertEqual(["rpm", "friction"], plan.names)
        self.assertEqual([[30.0, 0.1], [30.0, 0.25], [30.0, 0.4], [60.0, 0.1]], [[rpm, round(friction, 9)] for rpm, friction in plan.rows[:4]])
        self.assertEqual({"map": ["rpm", "friction", "turned"], "each": None, "worst": "turned", "least": False}, plan.report)
        self.assertEqual({"rpm": 30.0}, plan.blueprint.parameters_of(plan.rows[0]))
        self.assertIn("friction: 0.4", plan.blueprint.scene_of(plan.rows[2]))

    def test_a_runs_key_is_all_that_makes_it(self):
        blueprint = read_plan(self.plan()).blueprint
        keys = {blueprint.key_of(row, identity) for row in ([30.0, 0.1], [60.0, 0.1], [30.0, 0.2]) for identity in (["b", "avx2"], ["b", "avx512"], ["c", "avx2"])}
        self.assertEqual(9, len(keys))
        for other in (PLAN.replace("0.3\n", "0.4\n"), PLAN.replace("torque: largest", "torque: mean"), PLAN + "seed: 3\n", PLAN + "judge: {wob: 1e4}\n"):
            keys.add(read_plan(self.plan(other)).blueprint.key_of([30.0, 0.1], ["b", "avx2"]))
        self.assertEqual(13, len(keys))
        self.assertIn(read_plan(self.plan(PLAN.replace("made up", "else"))).blueprint.key_of([30.0, 0.1], ["b", "avx2"]), keys)

    def test_bad_plans_are_refused_with_their_line(self):
        for old, new, line, said in (
                ("name: made up", "nam: x", 1, "nam: unknown key, allowed: name, scene"), ("duration: 0.3", "duration: fast", 3, "duration: needed: a number above 0"),
                ("duration: 0.3", "duration: -1", 3, "is -1"), ("values: [30.0, 60.0]", "values: []", 6, "needed: a list"),
                ("key: controller.rpm", "key: controller.rpm, keys: [a]", 6, "key or keys"), ("from: 0.1", "from: 0.5", 7, "factors[1].to: is 0.4, needed: a number above 0.5"),
                ("from: 0.1,", "", 7, "needs values, or from and to"), ("friction, key", "rpm, key", 7, "there is one of this name"),
                ("sections[*].friction", "sections[9].friction", 7, "the list has no [9]"), ("sections[*].friction\"", "sections[*].friction\", log: true, values: [1]", 7, "is given together with values"),
                ("kind: grid", "kind: random", 8, "allowed: grid, list, latin_hypercube, sobol, saltelli"), ("grid, steps: 3", "sobol", 8, "sobol needs runs"),
                ("steps: 3", "steps: 3, runs: 4", 8, "grid has steps"), ("steps: 3", "steps: 3.5", 8, "a whole number"),
                ("laws.py:turned", "laws.py:no_such", 9, "laws.py has no no_such"), ("laws.py:Law", "other.py:Law", 4, "No such file"), ("duration: 0.3", "duration: 0.3\nduration: 0.4", 4, "twice"),
                ("sample:", "report: {map: [rpm, friction, rop]}\nsample:", 8, "is rop, allowed: turned, torque")):
            self.assertIn(old, PLAN)
            with self.assertRaises(PlanError, msg=new) as told:
                read_plan(self.plan(PLAN.replace(old, new, 1)))
            self.assertTrue(str(told.exception).startswith("%s:%d: " % (self.place("plan.yaml"), line)), told.exception)
            self.assertIn(said, str(told.exception))
            self.assertNotIn("\n", str(told.exception))
    def test_keys_times_and_parameters_are_refused_with_their_line(self):
        friction = "\"well.sections[*].friction\""
        for old, new, line, said in (
                ("controller.rpm", friction, 7, "sections[*].friction are the same key"), (friction, "controller.rpm", 7, "controller.rpm and controller.rpm are the same key"),
                ("key: controller.rpm", "keys: [numerics.tolerance, numerics.tolerance]", 6, "are the same key"), (friction, "seed, times: true", 7, "a seed needs values"),
                ("key: controller.rpm", "keys: [numerics.new, numerics.new.more]", 6, "numerics.new and numerics.new.more are the same key"),
                ("controller.rpm, values: [30.0, 60.0]", "seed, values: [1, 1.5]", 6, "factors[0].values[1]: is 1.5, needed: a whole number"), (friction, "seed", 7, "whole numbers"),
                ("duration: 0.3", "duration: 0.3\nfrom: 0.3", 4, "from: is 0.3, needed: a number below the duration, 0.3"), ("duration: 0.3", "duration: 0.305", 3, "not a whole number of frames"),
                ("duration: 0.3", "duration: 0.3\nevery: 0.015", 4, "0.015 s, is not a whole number of frames of 0.01 s"), ("duration: 0.3", "duration: 0.3\nseed: 1.5", 4, "a whole number"),
                ("laws.py:Law", "laws.py:Nobody", 4, "laws.py has no Nobody"), ("laws.py:Law", "laws.py:time", 4, "is no class"),
                ("controller.rpm", "controller.rmp", 6, "laws.py:Law has no parameter rmp, allowed: rpm, fault, slow"), ("{rpm: 60.0}", "{rmp: 60.0}", 4, "has no parameter rmp"),
                ("key: controller.rpm", "key: controller.slow, times: true", 6, "gives no number for it"), ("controller.rpm", "controller.rpm.deep", 6, "the parameter rpm has no keys")):
            self.refused_at(line, said, PLAN.replace(old, new, 1))

    def refused_at(self, line, said, text):
        self.assertNotEqual(PLAN, text)
        with self.assertRaises(PlanError, msg=said) as told:
            read_plan(self.plan(text))
        self.assertTrue(str(told.exception).startswith("%s:%d: " % (self.place("plan.yaml"), line)), told.exception)
        self.assertIn(said, str(told.exception))

    def test_what_is_no_law_is_refused_before_anything_runs(self):
        laws = {"NoPeriod": ("done = False", "has no period; a law needs period [s], done and step(readings)"), "NoDone": ("period = 0.1", "has no done"),
                "NoStep": ("period, done, step = 0.1, False, 3", "has no step(readings)"), "Odd": ("period, done = 0.015, False", "not a whole number of frames of 0.01 s"),
                "Worded": ("period, done = 'long', False", "its period is 'long', needed: a number"), "Broken": ("period, done, more = 0.1, False, 1", "law.py, line"),
                "Greedy": ("period, done = 0.1, False", "needs the parameter weight")}
        with open(self.place("law.py"), "w", encoding="utf-8") as out:
            for name, (body, _) in laws.items():
                out.write("class %s:\n    %s\n    def __init__(self, rpm%s):\n        %s\n" % (name, body, ", weight" if name == "Greedy" else "", "1 / 0" if name == "Broken" else "pass"))
                out.write("" if name == "NoStep" else "    def step(self, readings):\n        pass\n")
        for name, (_, said) in laws.items():
            for words in (["--check"], []):
                status, out, told = drill_campaign(self.plan(PLAN.replace("%s/laws.py:Law" % HERE, "law.py:" + name)), "--results", self.place("r.sqlite"), *words)
                self.assertEqual((2, ""), (status, out), name)
                self.assertTrue(told.startswith("drill_campaign: %s:4: controller.class: " % self.place("plan.yaml")), told)
                self.assertIn(said, told)
                self.assertEqual(1, told.count("\n"))

    def test_a_key_that_no_scene_has_is_refused_with_both_lines(self):
        for key, said in (("mud.densty", r"plan.yaml:7: factors\[1\].key: .*scene.yaml:13: mud.densty: unknown key"), ("numerics.tolerence", "plan.yaml:7: .*tolerence")):
            status, _, told = drill_campaign(self.plan(PLAN.replace("well.sections[*].friction", key)), "--check")
            self.assertEqual(2, status)
            self.assertRegex(told, said)

    def test_what_is_no_plan_at_all(self):
        for text in ("", "[1, 2", "a: b: c", "- 1\n"):
            self.assertRaises(PlanError, read_plan, self.plan(text))
        self.assertRaises(PlanError, read_plan, "/nowhere.yaml")

    def test_what_only_a_rig_can_tell(self):
        for old, new, said in (("largest.truth.torque", "largest.truth.talk", "truth has no number talk"), ("largest.truth.torque", "wob.middle", "of drill score: "),
                               ("from: 0.1, to: 0.4", "from: -0.5, to: -0.1", "each of the first 6 runs is refused")):
            status, _, told = drill_campaign(self.plan(PLAN.replace(old, new)), "--check")
            self.assertEqual(2, status)
            self.assertIn(said, told)
            self.assertEqual(1, told.strip().count("\n") + 1)


def alive(pid):
    try:
        with open("/proc/%d/stat" % pid, encoding="ascii") as stat:
            return " Z " not in stat.read()
    except (FileNotFoundError, ProcessLookupError):  # it ended before the file was opened, or read
        return False


def drill_campaign(*words):
    """Status and what was said, in this process."""
    out, told = io.StringIO(), io.StringIO()
    with redirect_stdout(out), redirect_stderr(told):
        status = command.main(list(words))
    return status, out.getvalue(), told.getvalue()


class Runs(Folder):
    def runner(self, fault="", bounds="cpu: 2.0, wall: 20.0, memory: 3.0e+8"):
        text = PLAN.replace("rpm: 60.0", "fault: %s" % (fault or '""')) + "bounds: {%s}\n" % bounds
        plan = read_plan(self.plan(text))
        runner = Runner(plan.blueprint)
        self.addCleanup(runner.end)
        rig = played.simulator(plan.blueprint, plan.rows[0])
        return runner, plan.rows[0], [build(), rig.kernel]

    def test_outputs_of_a_good_run(self):
        runner, row, identity = self.runner("chat")
        status, reason, outputs, cpu = runner.run(row, identity)
        self.assertEqual(("good", ""), (status, reason))
        self.assertEqual(["torque", "turned"], sorted(outputs))
        self.assertGreater(outputs["turned"], 0.0)
        self.assertGreater(cpu, 0.0)
        self.assertEqual(outputs, runner.run(row, identity)[2])

    def test_runs_that_fail_have_their_reason_and_the_next_one_runs(self):
        for fault, bounds, wanted, said in (("error", "cpu: 9.0", "controller", r"laws.py, line \d+: KeyError: 'no such gauge'"), ("spin", "cpu: 0.7", "cpu", "0.7 s"),
                                            ("sleep", "wall: 1.5", "wall", "1.5 s"), ("hoard", "memory: 2.0e+8", "memory", "200 MB"), ("crash", "cpu: 9.0", "died", "signal 11"),
                                            ("leave", "cpu: 9.0", "controller", r"laws.py, line \d+: SystemExit: no more of this"), ("vanish", "cpu: 9.0", "died", "status 5"),
                                            ("kill", "cpu: 9.0", "died", "signal 9")):
            runner, row, identity = self.runner(fault, bounds)
            for _ in range(2):
                status, reason, outputs, _ = runner.run(row, identity)
                self.assertEqual((wanted, {}), (status, outputs), reason)
                self.assertRegex(reason, said)

    def test_an_output_that_cannot_be_told_has_its_own_status(self):
        for asked, more, said in (("laws.py:broken", "", r"^turned: laws.py, line \d+: ZeroDivisionError: "), ("laws.py:wordy", "", "^turned: returns 'well', needed: a number"),
                                  ("laws.py:turned", "from: 0.25\n", "ended at 0.3 s, with fewer than two rows after `from`, 0.25 s")):
            plan = read_plan(self.plan(PLAN.replace("laws.py:turned", asked) + more))
            rig = played.simulator(plan.blueprint, plan.rows[0])
            runner = Runner(plan.blueprint)
            self.addCleanup(runner.end)
            status, reason, outputs, _ = runner.run(plan.rows[0], [build(), rig.kernel])
            self.assertEqual(("judge", {}), (status, outputs), reason)
            self.assertRegex(reason, said)

    def test_a_reading_that_was_not_zeroed_is_no_output(self):
        asked = "{weight: mean.readings.surface_wob, pressure: largest.readings.differential_pressure, last: last.readings.surface_wob, load: mean.readings.hook_load, " \
            "truth: mean.truth.surface_wob, motor: last.truth.differential_pressure, warm: mean.readings.flow_line_temperature, bottom: mean.truth.bottom_hole_temperature}"
        zeroed = "operations: [{do: tag, speed: 0.1, weight: 1000}]\n"
        with open(QUICK, encoding="utf-8") as text:
            scene = text.read()
        for by_law, operations in ((True, ""), (False, ""), (False, zeroed)):
            with open(self.place("scene.yaml"), "w", encoding="utf-8") as out:
                out.write(scene[:scene.index("program:")] + operations if operations else scene)
            text = PLAN.replace(QUICK, self.place("scene.yaml")) if by_law else re.sub(r"controller: .*\n|.*controller\.rpm.*\n", "", PLAN.replace(QUICK, self.place("scene.yaml")))
            plan = read_plan(self.plan(re.sub(r"outputs: .*", "outputs: " + asked, text)))
            outputs = played.outputs_of(plan.blueprint, played.play(plan.blueprint, plan.rows[0]))
            known = bool(operations)
            self.assertEqual([known] * 4 + [True] * 2, [outputs[name] is not None for name in ("weight", "pressure", "last", "truth", "motor", "load")])
            self.assertEqual([None] * 2, [outputs[name] for name in ("warm", "bottom")])  # the scene's mud has no temperature

    def test_another_build_or_kernel_is_refused(self):
        runner, row, identity = self.runner()
        status, reason, _, _ = runner.run(row, ["other", identity[1]])
        self.assertEqual("refused", status)
        self.assertIn("the campaign's are other", reason)

    def test_a_scene_out_of_range_is_refused_by_its_line(self):
        runner, _, identity = self.runner()
        status, reason, _, _ = runner.run([30.0, -1.0], identity)
        self.assertEqual("refused", status)
        self.assertRegex(reason, r"scene.yaml:\d+: .*friction")

    def test_a_runner_ends_with_its_worker(self):
        asked = "from drill_rig_sim.campaign.plan import read_plan; from drill_rig_sim.campaign.runner import Runner; import os, pickle, threading; p = read_plan(%r); " \
            "r = Runner(p.blueprint); threading.Thread(target=r.run, args=(p.rows[0], ['x', 'y']), daemon=True).start()\n" \
            "while r.process is None: pass\nprint(r.process.pid, flush=True); os.kill(os.getpid(), 9)"
        done = subprocess.run([sys.executable, "-c", asked % self.plan()], capture_output=True, text=True, check=False)
        pid = int(done.stdout)
        deadline = time.monotonic() + 60.0
        while alive(pid):
            self.assertLess(time.monotonic(), deadline, "it lives on")
            time.sleep(0.1)


if __name__ == "__main__":
    unittest.main()
