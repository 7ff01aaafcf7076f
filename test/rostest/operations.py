#!/usr/bin/env python3
"""A scene's operations in the node: told as they go, and bit for bit what the runner makes of the same file."""
import json
import os
import subprocess
import tempfile

from drill_rig_sim.msg import RigTruth
from rig_test import PACKAGE_DIR, Rig, run, unittest, winch

SCENE = os.path.join(PACKAGE_DIR, "test/scenes/operations.yaml")
RUNNER = os.path.join(os.environ["CMAKE_PREFIX_PATH"].split(":")[0], "lib/drill_rig_sim/drill")
SIGNALS = ("hook_load", "torque", "rop", "hole_depth")


def by_the_runner():
    """Its summary at the end of the operations."""
    with tempfile.TemporaryDirectory() as folder:
        summary = os.path.join(folder, "summary.json")
        subprocess.run([RUNNER, "run", SCENE, "--json", summary], check=True, stdout=subprocess.DEVNULL)
        with open(summary) as file:
            return json.load(file)


class Operations(unittest.TestCase):
    def setUp(self):
        self.rig = Rig()
        self.assertTrue(self.rig.reset_well("", 0.0).success)

    def test_node_and_runner_agree_bit_for_bit(self):
        expected = by_the_runner()
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

    def test_a_command_takes_over(self):
        self.assertEqual("flow", self.rig.advance(10).current_operation)
        state = self.rig.advance(10, winch=winch(0.0))
        self.assertEqual(("", 0), (state.current_operation, state.operation_number))


if __name__ == "__main__":
    run(Operations)
