#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""A campaign's run once more: in this process, and on a node by the files and commands that a user is told; and the law that the texts show."""
import glob
import json
import os
import shlex
import socket
import sqlite3
import subprocess
import unittest
import xml.etree.ElementTree

import test_campaign_parts  # skips where there is no Dask
import yaml
from drill_rig_sim.campaign.blueprint import Blueprint
from drill_rig_sim.campaign.plan import read_plan
from drill_rig_sim.campaign.results import Results
from drill_rig_sim.campaign.runner import outcome
from drill_rig_sim.score_runs import read_series
from drill_rig_sim.sim import build
from test_campaign_parts import HERE, QUICK, SOURCE, drill_campaign

NOISY = "instruments.surface.hook_load.noise"
PLAN = """scene: %s
duration: 1.0
from: 0.4
controller: {class: "%s/laws.py:Law", parameters: {rpm: 60.0}}
factors:
  - {name: rpm, key: controller.rpm, values: [30.0, 60.0, 90.0]}
  - {name: seed, key: seed, values: [1, 2, 7]}
  - {name: noise, key: %s, values: [500.0, 500.0, 500.0]}
sample: {kind: list}
judge: {wob: 10.0e+3}
outputs: {turned: "%s/laws.py:turned", torque: largest.truth.torque, load: mean.readings.hook_load}
""" % (QUICK, HERE, NOISY, HERE)
PATIENCE = 240.0  # [s]


class Again(test_campaign_parts.Folder):
    def setUp(self):
        super().setUp()
        self.addCleanup(os.chdir, os.getcwd())
        os.chdir(self.folder)

    def done(self, text=PLAN):
        """The results' file of a plan, without Dask."""
        plan = read_plan(self.plan(text))
        rows = [(str(k), row, *outcome(plan.blueprint, row)[:3], 0.1, "w") for k, row in enumerate(plan.rows)]
        results = Results(self.place("r.sqlite"))
        results.describe([row[0] for row in rows], name=plan.blueprint.name, plan=plan.text, factors=plan.names, outputs=list(plan.blueprint.outputs), sample=plan.sample,
                         report=plan.report, identity=[build(), "any"], blueprint=plan.blueprint.parts())
        results.add(rows)
        results.close()
        return rows

    def scene(self, number):
        """What the command says, by lines."""
        status, out, told = drill_campaign("scene", "r.sqlite", "--run", str(number), "--out", "run.yaml")
        self.assertEqual((0, ""), (status, told))
        return out.splitlines()

    # --- in this process

    def test_a_blueprint_comes_back_from_its_parts(self):
        blueprint = read_plan(self.plan(PLAN)).blueprint
        again = Blueprint.of_parts(json.loads(json.dumps(blueprint.parts())))
        self.assertEqual(blueprint.key_of([30.0, 1, 500.0], []), again.key_of([30.0, 1, 500.0], []))

    def test_a_run_is_played_to_the_last_bit(self):
        rows = self.done()
        self.assertEqual(3, len({row[4]["load"] for row in rows}))
        for number, row in enumerate(rows):
            status, out, told = drill_campaign("play", "r.sqlite", "--run", str(number), "--csv", "run.csv")
            self.assertEqual((0, ""), (status, told), out)
            for name, value in row[4].items():
                self.assertRegex(out, r"(?m)^%s +%s$" % (name, repr(value)))
            self.assertIn("as in r.sqlite, to the last bit", out)
            series = read_series("run.csv")
            self.assertEqual((0.1, 1.0), (series["time"][0], series["time"][-1]))
            self.assertEqual(row[4]["torque"], series["torque"][series["time"] > 0.4].max())

    def test_a_run_without_a_controller_too(self):
        text = "\n".join(line for line in PLAN.splitlines() if "controller" not in line)
        rows = self.done(text)
        status, out, _ = drill_campaign("play", "r.sqlite", "--run", "1", "--csv", "run.csv")
        self.assertEqual(0, status, out)
        self.assertEqual(rows[1][4]["torque"], read_series("run.csv")["torque"][4:].max())

    def test_a_run_that_fails_fails_again(self):
        self.done(PLAN.replace("rpm: 60.0", "fault: error"))
        status, out, _ = drill_campaign("play", "r.sqlite", "--run", "0", "--csv", "run.csv")
        self.assertEqual(1, status)
        self.assertRegex(out, r"^run 0: controller: laws.py, line \d+: KeyError: 'no such gauge'\nrun.csv is not written: .*\nas in r.sqlite, to the last bit\n$")

    def test_what_is_otherwise_is_told(self):
        self.done()
        data = sqlite3.connect(self.place("r.sqlite"))
        data.execute("update runs set outputs = ? where key = '1'", (json.dumps({"turned": 1.5}),))
        data.commit()
        data.close()
        status, out, _ = drill_campaign("play", "r.sqlite", "--run", "1")
        self.assertEqual(1, status)
        self.assertIn("not as in r.sqlite: good turned 1.5; build and kernel there: %s any" % build()[:8], out)
        for words in (["--run", "99"], ["--run", "1", "--csv", "/nowhere/run.csv"]):
            status, _, told = drill_campaign("play", "r.sqlite", *words)
            self.assertEqual((2, 1), (status, told.count("\n")))

    # --- for a node

    def test_the_scene_of_a_plan_without_a_controller_and_its_seed(self):
        self.done("\n".join(line for line in PLAN.splitlines() if "controller" not in line))
        lines = self.scene(2)
        self.assertEqual(["run.yaml", "shown by: roslaunch drill_rig_sim rig.launch scene:=%s play_program:=true seed:=7 rviz:=true" % self.place("run.yaml"),
                          "its numbers again: rosrun drill_rig_sim drill_campaign play r.sqlite --run 2"], lines)
        with open("run.yaml", encoding="utf-8") as text:
            self.assertEqual(500.0, yaml.safe_load(text)["instruments"]["surface"]["hook_load"]["noise"])
        self.assertEqual(2, drill_campaign("scene", "r.sqlite", "--run", "99")[0])

    def test_the_scene_of_a_plan_with_a_controller_comes_with_it(self):
        self.done(PLAN.replace("rpm: 60.0", "fault: \"<&>\""))
        self.assertEqual(["run.yaml", "run.law.py", "run.launch", "shown by: roslaunch %s rviz:=true    # headless:=true: in lockstep, as in the campaign" % self.place("run.launch"),
                          "its numbers again: rosrun drill_rig_sim drill_campaign play r.sqlite --run 2"], self.scene(2))
        launch = xml.etree.ElementTree.parse("run.launch").getroot()
        told = {one.get("name"): one.get("value") for one in launch.iter() if one.get("value") is not None}
        self.assertEqual(("$(dirname)", "$(arg folder)/run.yaml", "7", "$(dirname)/run.law.py:Law", "1.0"), tuple(told[name] for name in ("folder", "scene", "seed", "law", "timeout")))
        given = yaml.safe_load(launch.find("node/rosparam").text)
        self.assertEqual({"settings": {"fault": "<&>", "rpm": 90.0}, "score": {"wob": 10e3}}, given)
        with open("run.law.py", encoding="utf-8") as copy, open(os.path.join(HERE, "laws.py"), encoding="utf-8") as law:
            self.assertEqual(law.read(), copy.read())

    def test_the_command_that_is_told_runs_on_a_node(self):
        """In lockstep, the same to the last bit but for the clock: a node's starts with its first frame."""
        self.done()
        lines = self.scene(1)
        command = shlex.split(lines[3][len("shown by: "):].replace("rviz:=true", "rviz:=false"), comments=True)
        with socket.socket() as free:
            free.bind(("127.0.0.1", 0))
            port = free.getsockname()[1]
        done = subprocess.run([command[0], "-p", str(port), *command[1:], "headless:=true", "csv:=" + self.place("node.csv")], capture_output=True, text=True,
                              env=dict(os.environ, ROS_MASTER_URI="http://localhost:%d" % port), timeout=PATIENCE, check=False)
        self.assertTrue(os.path.exists("node.csv"), done.stdout + done.stderr)
        self.assertEqual(0, drill_campaign("play", "r.sqlite", "--run", "1", "--csv", "run.csv")[0])
        node, here = read_series("node.csv"), read_series("run.csv")
        self.assertEqual(list(here.columns), list(node.columns))
        for name in set(here.columns) - {"time"}:
            self.assertEqual(list(here[name]), list(node[name]), name)


class Shown(test_campaign_parts.Folder):
    def test_the_law_that_the_texts_show_holds_its_weight(self):
        text = "scene: %s\nduration: 120.0\nfrom: 90.0\ncontroller: {class: \"%s/config/campaigns/first_law.py:FirstLaw\", parameters: {rpm: 90.0}}\n" % (QUICK, SOURCE)
        plan = read_plan(self.plan(text + "factors: [{name: weight, key: controller.weight, values: [5.0e+3, 10.0e+3]}]\nsample: {kind: list}\noutputs: {weight: mean.bit.wob}\n"))
        for row in plan.rows:
            status, reason, outputs, _ = outcome(plan.blueprint, row)
            self.assertEqual(("good", ""), (status, reason))
            self.assertAlmostEqual(1.0, outputs["weight"] / row[0], delta=0.02)

    def test_ready_plans_are_read(self):
        """Scenes lie beside them."""
        texts = {}
        for name in glob.glob(os.path.join(SOURCE, "config/campaigns/*.yaml")):
            with open(name, encoding="utf-8") as text:
                texts[name] = text.read()
        plans = [name for name, text in texts.items() if "\nfactors:" in text]
        self.assertGreater(len(plans), 2)
        for plan in plans:
            read_plan(plan)


if __name__ == "__main__":
    unittest.main()
