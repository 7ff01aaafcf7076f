#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""A scene's operations in the node: told as they go, and bit for bit what the runner makes of the same file."""
import json
import math
import os
import subprocess
import tempfile

import yaml
from drill_rig_sim.msg import RigTruth
from rig_test import PACKAGE_DIR, Rig, run, runner, unittest, winch

SCENE = os.path.join(PACKAGE_DIR, "test/scenes/operations.yaml")
SIGNALS = ("hook_load", "torque", "rop", "hole_depth")


def by(program):
    """The runner's summary at the end of the operations."""
    with tempfile.TemporaryDirectory() as folder:
        summary = os.path.join(folder, "summary.json")
        subprocess.run([program, "run", SCENE, "--json", summary], check=True, stdout=subprocess.DEVNULL)
        with open(summary) as file:
            return json.load(file)


class Operations(unittest.TestCase):
    def setUp(self):
        self.rig = Rig()
        self.assertTrue(self.rig.reset_well(SCENE, 0.0).success)

    def test_node_and_runner_agree_bit_for_bit(self):
        expected = by(runner(self))
        truth = self.rig.collect("truth/rig_state", RigTruth)
        frames = round(expected["simulated_s"] / 0.01)
        last = truth.at(self.rig.advance(frames).header.stamp)
        for signal in SIGNALS:
            self.assertEqual(expected["final"][signal], getattr(last, signal), signal)

    def test_what_is_under_way_is_told(self):
        told = []
        for _ in range(1000):
            state = self.rig.advance(20)
            self.assertTrue(0.0 <= state.operation_progress <= 1.0)
            if not told or told[-1] != (state.operation_number, state.current_operation):
                told.append((state.operation_number, state.current_operation))
            if state.operation_number == 0:
                break
        names = ["flow", "rotate", "tag", "drill", "pick_up", "ream", "wait"]
        self.assertEqual([(i + 1, name) for i, name in enumerate(names)] + [(0, "")], told)
        self.assertTrue(state.brake_set)

    def test_a_slide_that_stalls_its_motor_is_given_up_and_stops_the_block(self):
        with open(os.path.join(PACKAGE_DIR, "config/scenes/slide_steering.yaml"), encoding="utf-8") as text:
            scene = yaml.safe_load(text)
        next(part for part in scene["string"] if part["type"] == "mud_motor")["stall_torque"] = 900.0
        scene["operations"] = [{"do": "flow", "flow": 0.03, "ramp": 5.0}, {"do": "tag"},
                               {"do": "slide", "toolface_deg": 0.0, "weight": 60e3, "distance": 5.0}]
        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(folder, "stalls.yaml")
            with open(file, "w", encoding="utf-8") as out:
                yaml.safe_dump(scene, out)
            self.assertTrue(self.rig.reset_well(file, 0.0).success)
        told = []
        for _ in range(200):
            state = self.rig.advance(100)
            told.append(state.current_operation)
            if state.current_operation == "slide" and state.brake_set:
                break
        self.assertEqual(["flow", "tag", "slide"], [name for i, name in enumerate(told) if i == 0 or name != told[i - 1]])
        self.assertTrue(state.brake_set)
        self.assertAlmostEqual(state.block_height, self.rig.advance(1000).block_height, delta=0.01)
        self.assertGreater(state.differential_pressure, 0.7 * 2.0 * math.pi * 900.0 / 0.01)

    def test_a_command_takes_over(self):
        self.assertEqual("flow", self.rig.advance(10).current_operation)
        state = self.rig.advance(10, winch=winch(0.0))
        self.assertEqual(("", 0), (state.current_operation, state.operation_number))


if __name__ == "__main__":
    run(Operations)
