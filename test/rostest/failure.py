#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""A frame that cannot be solved, in lockstep: the step reports it, rig_state shows it once with the last good stamp, nothing goes on but a
reset or a snapshot; and what run_state is before, meanwhile and after."""
from diagnostic_msgs.msg import DiagnosticArray, DiagnosticStatus
from drill_rig_sim.msg import RigState, RigTruth
from rig_test import Rig, rospy, run, turn, unittest, winch
from rosgraph_msgs.msg import Clock

STRIDE = 5  # frames


class Failure(unittest.TestCase):
    def setUp(self):
        self.rig = Rig()
        self.rig.must(self.rig.reset_well("", 0.0))

    def until_failure(self):
        """The answer of the step that fails, and the stamp of the last one before it."""
        last = self.rig.advance(1, winch=winch(-1.5), top_drive=turn(23.0)).header.stamp
        for _ in range(400):
            answer = self.rig.step(frames=STRIDE)
            if not answer.success:
                return answer, last
            last = answer.state.header.stamp
        self.fail("it was solved")

    def test_a_step_answers_as_waiting_and_its_frames_run(self):
        states = self.rig.collect("rig_state", RigState)
        self.addCleanup(states.subscriber.unregister)
        start = self.rig.advance(0)
        self.assertEqual(RigState.WAITING, start.run_state)
        self.assertEqual(RigState.WAITING, self.rig.advance(10).run_state)
        said = states.after(start.header.stamp)
        self.assertEqual(RigState.WAITING, said[-1].run_state)
        state = self.rig.advance(15)  # state_rate: every tenth frame, so the last is none of them
        said = states.after(said[-1].header.stamp)
        self.assertEqual([RigState.RUNNING], [m.run_state for m in said])
        self.assertEqual(state.header.stamp - rospy.Duration(0, 250000000), said[0].header.stamp)

    def test_the_failure_is_said_once_with_the_last_good_stamp(self):
        topics = [self.rig.collect(name, kind) for name, kind in (("rig_state", RigState), ("truth/rig_state", RigTruth))]
        clock, diagnostics = self.rig.collect("/clock", Clock), self.rig.collect("/diagnostics", DiagnosticArray)
        for topic in topics + [clock, diagnostics]:
            self.addCleanup(topic.subscriber.unregister)
        answer, before = self.until_failure()
        self.assertIn("a frame failed", answer.message)
        self.assertIn("of %d frames" % STRIDE, answer.message)
        self.assertEqual(RigState.FAILED, answer.state.run_state)
        good = answer.state.header.stamp
        self.assertTrue(before <= good < before + rospy.Duration(0, STRIDE * 50000000))
        done = int(answer.message.split("(")[-1].split()[0])
        self.assertEqual(before + rospy.Duration(0, (done - 1) * 50000000), good, "the failed frame has no stamp")
        for topic in topics:
            messages = topic.wait_until(lambda m: m and m[-1].run_state == RigState.FAILED)
            self.assertEqual([good], [m.header.stamp for m in messages if m.run_state == RigState.FAILED])
            self.assertEqual(RigState.FAILED, messages[-1].run_state)
        self.assertEqual(good, clock.wait_until(lambda m: m and m[-1].clock >= good)[-1].clock)
        physics = self.physics(diagnostics)
        self.assertIn("stopped at the last good state", physics.message)

    @staticmethod
    def physics(diagnostics):
        """The status of physics once it is an error."""
        def found(messages):
            return [s for m in messages for s in m.status if s.name.endswith("physics") and s.level in (DiagnosticStatus.ERROR, bytes([2]))]
        return found(diagnostics.wait_until(found))[0]

    def test_only_a_reset_or_a_snapshot_goes_on(self):
        self.rig.must(self.rig.save_state("before", ""))
        first = self.rig.advance(1)
        self.until_failure()
        for answer in (self.rig.step(frames=1), self.rig.save_state("after", "")):
            self.assertFalse(answer.success)
            self.assertIn("failed", answer.message)
        for refused in (self.rig.step(frames=1), self.rig.step(frames=10**6)):
            self.assertEqual(RigState.FAILED, refused.state.run_state)
            self.assertTrue(refused.state.header.stamp > first.header.stamp, "the last good frame's")
        self.assertIn("failed", self.rig.tare().message)
        failed = self.rig.list_states()
        self.assertEqual(["before"], failed.names)
        self.rig.must(self.rig.restore_state("before", ""))
        again = self.rig.advance(1)
        self.assertEqual(RigState.WAITING, again.run_state)
        self.assertEqual((first.hook_load, first.bit_depth), (again.hook_load, again.bit_depth))
        self.assertGreater(again.header.stamp, first.header.stamp)
        self.until_failure()
        self.rig.must(self.rig.reset_well("", 0.0))
        self.assertEqual(RigState.WAITING, self.rig.advance(1).run_state)


if __name__ == "__main__":
    run(Failure)
