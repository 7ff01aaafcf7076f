#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The action run_operations: goal, feedback, result, cancel, and what takes the rig away from it."""
import os

import actionlib
from actionlib_msgs.msg import GoalStatus
from drill_rig_sim.msg import RunOperationsAction, RunOperationsGoal
from drill_rig_sim.srv import RestoreStateRequest, SaveStateRequest
from rig_test import PACKAGE_DIR, Rig, flow, run, unittest, wait_until, winch

SCENE = os.path.join(PACKAGE_DIR, "test/scenes/operations.yaml")
ENDS = (GoalStatus.SUCCEEDED, GoalStatus.ABORTED, GoalStatus.PREEMPTED, GoalStatus.REJECTED, GoalStatus.RECALLED)
UP = "{do: pick_up, distance: 5, speed: 0.2}"


class OperationsAction(unittest.TestCase):
    def setUp(self):
        self.rig = Rig()
        self.rig.must(self.rig.reset_well(SCENE, 0.0))
        self.client = actionlib.SimpleActionClient(self.rig.topic("run_operations"), RunOperationsAction)
        self.client.wait_for_server()  # while time stands
        self.feedback = []

    def begin(self, operations):
        """Sends a goal; it is under way."""
        self.feedback = []
        self.client.send_goal(RunOperationsGoal(operations=operations), feedback_cb=self.feedback.append)
        wait_until(lambda: self.client.get_state() == GoalStatus.ACTIVE, "the goal is active")
        wait_until(lambda: self.rig.advance(0).operation_number == 1, "the operations begin")

    def end(self):
        """State and result, once the goal has ended. Its state may come before its result: they are two topics."""
        wait_until(lambda: self.client.get_state() in ENDS and self.client.get_result() is not None, "the goal ends")
        return self.client.get_state(), self.client.get_result()

    def play_to_the_end(self, most=2000):
        for _ in range(most):
            if self.rig.advance(10).operation_number == 0:
                return self.end()
        raise AssertionError("the operations go on")

    def test_operations_are_done_one_after_the_other(self):
        before = self.rig.advance(1)
        self.begin("[%s, {do: flow, flow: 600 L/min, ramp: 2}]" % UP)
        state, result = self.play_to_the_end()
        after = self.rig.advance(100)
        self.assertEqual((GoalStatus.SUCCEEDED, True, "2 operations are finished"), (state, result.success, result.message))
        self.assertAlmostEqual(5.0, after.block_height - before.block_height, delta=0.01)
        self.assertAlmostEqual(0.01, after.mud_pump.flow, delta=1e-9)
        self.assertTrue(after.winch.brake)
        self.assertAlmostEqual(27.0, result.duration, delta=1.0)
        self.assertEqual([1, 2], sorted({f.operation_number for f in self.feedback}))
        self.assertEqual({(1, "pick_up", 2), (2, "flow", 2)}, {(f.operation_number, f.current_operation, f.operation_count) for f in self.feedback})
        shares = [f.operation_progress for f in self.feedback if f.operation_number == 1]
        self.assertEqual(sorted(shares), shares)

    def test_what_is_refused_changes_nothing(self):
        for operations, words in (("{do: trip, to_depth: 400 ft}", ("operations[0].to_depth", "400 ft", "328")), ("[]", ("is empty",)), ("", ("is empty",)),
                                  ("{do: fly}", ("operations[0].do", "allowed: flow, rotate")), ("{do: drill, weight: 1000}", ("end condition",)),
                                  ("do: [", ("goal:1: YAML",)), ("just text", ("a list",))):
            def ask(goal=RunOperationsGoal(operations=operations)):
                self.client.send_goal(goal)
                return self.end()
            (state, result), expected, after = self.rig.next_frame_after(ask)
            self.assertEqual((GoalStatus.ABORTED, False), (state, result.success), operations)
            for word in words:
                self.assertIn(word, result.message, operations)
            self.assertNotIn("\n", result.message)
            self.assertEqual(expected, after)

    def test_a_cancelled_goal_leaves_a_braked_block(self):
        self.begin(UP)
        self.assertGreater(self.rig.advance(500).block_velocity, 0.1)
        self.client.cancel_goal()
        state, result = self.end()
        self.assertEqual((GoalStatus.PREEMPTED, False, "cancelled"), (state, result.success, result.message))
        self.assertAlmostEqual(5.0, result.duration, delta=0.1)
        last = self.rig.advance(300)
        self.assertTrue(last.winch.brake)
        self.assertEqual((0, ""), (last.operation_number, last.current_operation))

    def test_another_command_takes_over_and_the_block_is_braked(self):
        self.begin(UP)
        self.rig.advance(500)
        last = self.rig.advance(10, mud_pump=flow(0.01))
        state, result = self.end()
        self.assertEqual((GoalStatus.ABORTED, "a command on a topic has taken over the rig"), (state, result.message))
        self.assertTrue(last.winch.brake)
        self.assertEqual(0.01, last.mud_pump.flow)
        self.begin(UP)
        self.assertEqual(-0.1, self.rig.advance(10, winch=winch(-0.1)).winch.block_velocity)
        self.assertEqual(GoalStatus.ABORTED, self.end()[0])

    def test_a_new_goal_takes_the_place_of_the_one_under_way(self):
        self.begin(UP)
        self.rig.advance(500)
        other = actionlib.SimpleActionClient(self.rig.topic("run_operations"), RunOperationsAction)
        other.wait_for_server()
        other.send_goal(RunOperationsGoal(operations="{do: wait, time: 1}"))
        self.assertEqual(GoalStatus.PREEMPTED, self.end()[0])
        wait_until(lambda: self.rig.advance(0).current_operation == "wait", "the other goal begins")
        self.assertTrue(self.rig.advance(150).winch.brake)
        wait_until(lambda: other.get_result() is not None, "the other goal ends")
        self.assertTrue(other.get_result().success)
        self.assertEqual("1 operation is finished", other.get_result().message)

    def test_a_reset_ends_it(self):
        self.begin(UP)
        self.rig.advance(500)
        self.rig.must(self.rig.reset_well(SCENE, 0.0))
        state, result = self.end()
        self.assertEqual(GoalStatus.ABORTED, state)
        self.assertIn("taken the place", result.message)
        self.assertAlmostEqual(5.0, result.duration, delta=0.1, msg="until the reset, which sets the rig's time to 0")
        self.assertEqual(0, self.rig.advance(1).operation_number)

    def test_an_operation_that_cannot_go_on_is_given_up(self):
        self.begin("{do: connection}")
        state, result = self.play_until_given_up()
        self.assertEqual((GoalStatus.ABORTED, False), (state, result.success))
        self.assertIn("operation 1 of 1, connection, was given up, the block is braked: the bit reaches bottom before", result.message)

    def play_until_given_up(self):
        for _ in range(500):
            self.rig.advance(100)
            if self.client.get_state() in ENDS:
                return self.end()
        raise AssertionError("the operation goes on")

    def test_a_saved_state_goes_on_with_them(self):
        self.begin("[%s, {do: slack_off, distance: 1}]" % UP)
        self.rig.advance(500)
        self.rig.must(self.rig.save_state(SaveStateRequest(name="midway")))
        state, _ = self.play_to_the_end()
        self.assertEqual(GoalStatus.SUCCEEDED, state)
        expected = self.rig.advance(1).block_height
        self.rig.must(self.rig.reset_well(SCENE, 0.0))
        self.begin("{do: wait, time: 100}")
        self.rig.must(self.rig.restore_state(RestoreStateRequest(name="midway")))
        self.assertEqual(GoalStatus.ABORTED, self.end()[0])
        for _ in range(2000):
            if self.rig.advance(10).operation_number == 0:
                break
        self.assertEqual(expected, self.rig.advance(1).block_height)


if __name__ == "__main__":
    run("operations_action", OperationsAction)
