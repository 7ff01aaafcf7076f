#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Slips and connections: by the services, and by the crew of a scene that says connections: auto."""
from drill_rig_sim.msg import MwdSurvey
from drill_rig_sim.srv import MakeConnectionRequest
from rig_test import PACKAGE_DIR, Rig, flow, numbers, run, turn, unittest, winch

JOINT = 9.5
STAND = 3 * JOINT
BLOCK_AND_STUMP = 9.80665 * (17500.0 + 6.3 * 31.9)
AUTO = PACKAGE_DIR + "/test/scenes/connections.yaml"


class Connection(unittest.TestCase):
    def setUp(self):
        self.rig = Rig()
        self.rig.must(self.rig.reset_well("quick.yaml", 0.0))

    def refused(self, ask, *words):
        answer, expected, after = self.rig.next_frame_after(ask)
        self.assertFalse(answer.success)
        for word in words:
            self.assertIn(word, answer.message)
        self.assertEqual(expected, after)

    def bring_hook_to(self, load):
        """Slack off or pick up until the hook carries so much."""
        for _ in range(4000):
            more = load - self.rig.advance(0).hook_load
            if abs(more) < 1e3:
                break
            self.rig.advance(1, winch=winch(max(min(5e-7 * more, 0.01), -0.01)))
        self.rig.advance(100, winch=winch(0.0, brake=True))

    def lay_into_slips(self):
        self.rig.advance(300, winch=winch(0.0, brake=True))
        answer = self.rig.set_slips(True)
        self.assertTrue(answer.success, answer.message)
        self.assertEqual("the slips are set", answer.message)

    def test_what_is_refused_changes_nothing(self):
        self.refused(lambda: self.rig.set_slips(False), "not set")
        self.refused(lambda: self.rig.make_connection(MakeConnectionRequest(joints=3)), "slips are not set")
        self.refused(lambda: self.rig.make_connection(MakeConnectionRequest(joints=4000000000)), "joints is 4000000000", "12")
        self.rig.advance(100, winch=winch(-0.1))
        self.refused(lambda: self.rig.set_slips(True), "block moves")
        self.lay_into_slips()
        with self.assertRaisesRegex(AssertionError, "top drive is locked"):
            self.rig.advance(1, top_drive=turn(5.0))

    def test_a_joint_by_hand(self):
        self.rig.must(self.rig.reset_well(AUTO, 0.0))
        before = self.rig.advance(300)
        self.lay_into_slips()
        self.bring_hook_to(BLOCK_AND_STUMP)
        state = self.rig.advance(1)
        self.assertTrue(state.in_slips)
        depth, height = state.bit_depth, state.block_height
        answer = self.rig.make_connection(MakeConnectionRequest(joints=1))
        self.assertTrue(answer.success, answer.message)
        self.assertEqual("adding 1 joints; current_operation shows when it is finished", answer.message)
        self.assertEqual("connecting", self.rig.advance(1).current_operation)
        state = self.rig.advance(2500)
        self.assertEqual("", state.current_operation)
        self.assertAlmostEqual(depth, state.bit_depth, delta=1e-9)
        self.assertAlmostEqual(height + JOINT, state.block_height, delta=1e-3)
        self.refused(lambda: self.rig.set_slips(False), "pick up first")
        for _ in range(2000):
            self.rig.advance(1, winch=winch(0.01))
            if self.rig.set_slips(False).success:
                break
        self.rig.advance(1, winch=winch(0.0, brake=True))
        state = self.rig.advance(1000)
        self.assertFalse(state.in_slips)
        self.assertAlmostEqual(before.bit_depth, state.bit_depth, delta=0.01)
        self.assertAlmostEqual(before.hook_load + JOINT * 31.9 * 9.80665, state.hook_load, delta=6e3)  # the block's rail carries some of it

    def test_the_crew_adds_stands_and_the_survey_comes_with_them(self):
        self.rig.must(self.rig.reset_well(AUTO, 0.0))
        surveys = self.rig.collect("downhole/mwd", MwdSurvey)
        state = self.rig.advance(1, winch=winch(-0.05), top_drive=turn(10.0), mud_pump=flow(0.02))
        stands, operations = state.stand_count, []
        for _ in range(3000):
            state = self.rig.advance(50)
            if not operations or operations[-1] != state.current_operation:
                operations.append(state.current_operation)
            if state.stand_count == stands + 2 and not state.current_operation:
                break
        self.assertEqual(stands + 2, state.stand_count)
        self.assertIn("connecting", operations)
        self.assertGreater(state.hole_depth, 205.0 + STAND)
        self.rig.advance(500)
        depths = sorted({m.md for m in surveys.wait_until(lambda m: m and m[-1].md > state.hole_depth - STAND)})
        self.assertAlmostEqual(STAND, depths[-1] - depths[-2], delta=0.5)

    def test_the_crew_repeats_itself_to_the_last_bit(self):
        self.rig.must(self.rig.reset_well(AUTO, 0.0))
        self.rig.advance(1, winch=winch(-0.05), top_drive=turn(10.0), mud_pump=flow(0.02))
        while self.rig.advance(50).current_operation != "connecting":
            pass
        self.rig.must(self.rig.save_state("connecting", ""))
        end = numbers(self.rig.advance(8000))
        self.rig.must(self.rig.restore_state("connecting", ""))
        self.assertEqual(end, numbers(self.rig.advance(8000)))


if __name__ == "__main__":
    run(Connection)
