#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""reset_well goes back to the start exactly, the clock apart, and a refusal changes nothing."""
import math
import os
import tempfile

from drill_rig_sim.msg import DrillstringState
from rig_test import Rig, flow, numbers, run, turn, unittest, winch


class Reset(unittest.TestCase):
    def setUp(self):
        self.rig = Rig()
        self.assertTrue(self.rig.reset_well("quick.yaml", 0.0).success)

    def drill(self):
        state = self.rig.advance(200, winch=winch(-0.2), top_drive=turn(9.0), mud_pump=flow(0.02))
        for _ in range(20):
            state = self.rig.advance(100, winch=winch(-0.01), top_drive=turn(9.0))
        return state

    def test_reset_in_the_middle_of_drilling_gives_the_very_start(self):
        strings = self.rig.collect("drillstring_state", DrillstringState)
        start = self.rig.advance(0)
        first = strings.at(self.rig.advance(10).header.stamp)
        drilled = self.drill()
        self.assertGreater(drilled.hole_depth, start.hole_depth + 0.01)
        for resets in (1, 2):
            answer = self.rig.reset_well("", 0.0)
            self.assertTrue(answer.success, answer.message)
            after = self.rig.advance(0)
            self.assertEqual(numbers(start), numbers(after))
            self.assertEqual(start.epoch + resets, after.epoch)
            self.assertGreater(after.header.stamp, drilled.header.stamp)
            self.assertTrue(after.brake_set)
            self.assertEqual(0, after.last_command.to_nsec())
            self.assertEqual(numbers(first), numbers(strings.at(self.rig.advance(10).header.stamp)))

    def test_a_snapshot_of_another_bit_depth_is_refused_by_the_depths(self):
        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(folder, "snapshot")
            self.rig.must(self.rig.save_state("", file))
            self.rig.must(self.rig.reset_well("", 80.0))
            answer = self.rig.restore_state("", file)
            self.assertFalse(answer.success)
            self.assertIn("is a snapshot of this scene with start.bit_depth 99.7 m; allowed is that of this rig, 80 m", answer.message)
            self.rig.must(self.rig.reset_well("", 99.7))
            before = self.rig.advance(0).epoch
            self.rig.must(self.rig.restore_state("", file))
            self.assertEqual(before + 1, self.rig.advance(0).epoch)
            self.rig.must(self.rig.load_survey(md=[0.0, 90.0], inclination=[0.0, 0.0], azimuth=[0.0, 0.0]))
            self.assertIn("another scene", self.rig.restore_state("", file).message)

    def test_another_bit_depth(self):
        start = self.rig.advance(0)
        self.assertTrue(self.rig.reset_well("", 80.0).success)
        state = self.rig.advance(0)
        self.assertAlmostEqual(80.0, state.bit_depth, places=6)
        self.assertAlmostEqual(start.block_height, state.block_height, places=6)
        self.assertLess(state.hook_load, start.hook_load)
        self.assertTrue(self.rig.reset_well("", 0.0).success)
        self.assertEqual(numbers(start), numbers(self.rig.advance(0)))

    def test_another_scene(self):
        self.assertTrue(self.rig.reset_well("package://drill_rig_sim/config/scenes/bohai.yaml", 0.0).success)
        self.assertAlmostEqual(730.0, self.rig.advance(1).hole_depth, places=6)
        self.assertTrue(self.rig.reset_well("", 0.0).success)  # the present one now
        self.assertAlmostEqual(730.0, self.rig.advance(0).hole_depth, places=6)

    def test_states_of_another_rig_are_forgotten_and_that_is_said(self):
        for name in ("one", "two"):
            self.rig.must(self.rig.save_state(name, ""))
        for scene in ("", "quick.yaml"):
            self.assertNotIn("forgotten", self.rig.reset_well(scene, 0.0).message)
            self.assertEqual(["one", "two"], self.rig.list_states().names)
        self.assertIn("; saved states of the previous rig that were deleted: 2", self.rig.reset_well("", 80.0).message)
        self.assertEqual([], self.rig.list_states().names)
        self.assertNotIn("forgotten", self.rig.reset_well("", 0.0).message)

    def test_a_refusal_changes_nothing(self):
        self.rig.advance(20, winch=winch(0.1))
        for scene, depth in (("", -1.0), ("", math.nan), ("", 100.5), ("no_such_scene.yaml", 0.0), ("package://nowhere/a.yaml", 0.0),
                             ("../../test/bad_scenes/nan.yaml", 0.0)):
            answer, expected, after = self.rig.next_frame_after(lambda: self.rig.reset_well(scene, depth))
            self.assertFalse(answer.success, (scene, depth))
            self.assertNotEqual("", answer.message)
            self.assertEqual(expected, after)
        self.assertTrue(self.rig.reset_well("", 0.0).success)
        self.assertAlmostEqual(100.0, self.rig.advance(0).hole_depth, places=6)  # the scene is the present one still


if __name__ == "__main__":
    run(Reset)
