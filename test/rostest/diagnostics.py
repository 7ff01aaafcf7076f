#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Diagnostics come while the rig runs, while it is paused and after a frame that failed, from which reset_well recovers."""
import math

from diagnostic_msgs.msg import DiagnosticArray, DiagnosticStatus
from drill_rig_sim.msg import RigState, TopDriveCommand, WinchCommand
from rig_test import Rig, run, time, turn, unittest, winch
from rosgraph_msgs.msg import Clock


def values(array):
    return {pair.key: pair.value for status in array.status for pair in status.values}


class Diagnostics(unittest.TestCase):
    def setUp(self):
        self.rig = Rig()
        self.assertTrue(self.rig.reset_well("", 0.0).success)
        self.assertTrue(self.rig.resume().success)
        self.diagnostics = self.rig.collect("/diagnostics", DiagnosticArray)

    def until_state(self, word):
        """The first message that reports it, with all that came after."""
        def said(messages):
            return any(values(m).get("state") == word for m in messages)
        messages = self.diagnostics.wait_until(said)
        self.assertTrue(said(messages), "never: " + word)
        return next(m for m in messages if values(m).get("state") == word)

    def test_what_is_told_while_running(self):
        def sound(message):
            """All is well; on a loaded machine it may be slower than asked for a while."""
            levels = [s.level if isinstance(s.level, int) else s.level[0] for s in message.status]
            return "real_time_factor" in values(message) and levels == [DiagnosticStatus.OK] * 4
        messages = self.diagnostics.wait_until(lambda m: any(map(sound, m)))
        self.assertTrue(any(map(sound, messages)), messages[-1:])
        told = values(next(filter(sound, messages)))
        self.assertEqual("running", told["state"])
        for key in ("real_time_factor", "frame_times", "overruns", "dropped_seconds", "newton_iterations", "convergence_failures",
                    "error_estimate", "level", "integrator", "kernel", "companion", "why_not_measured", "refused", "clamped"):
            self.assertIn(key, told)
        self.assertEqual("hybrid", told["level"])

    def test_they_keep_coming_while_paused(self):
        self.assertTrue(self.rig.pause().success)
        self.until_state("paused")
        clock = self.rig.collect("/clock", Clock)
        clock.quiet()
        self.diagnostics.clear()
        self.assertEqual("paused", values(self.diagnostics.wait(3)[-1])["state"])
        self.assertEqual([], clock.messages)

    def test_a_failed_frame_stops_time_says_why_and_reset_well_recovers(self):
        states = self.rig.collect("rig_state", RigState)
        self.rig.publisher("top_drive/command", TopDriveCommand).publish(turn(23.0))
        self.rig.publisher("winch/command", WinchCommand).publish(winch(-1.5))
        message = self.until_state("failed")
        status = next(s for s in message.status if s.name.endswith("physics"))
        self.assertIn(status.level, (DiagnosticStatus.ERROR, bytes([2]), 2))
        self.assertIn("did not converge", status.message)
        heard = states.wait_until(lambda m: m and m[-1].run_state == RigState.FAILED)
        self.assertEqual(1, sum(m.run_state == RigState.FAILED for m in heard), "once")
        self.assertEqual(heard[-2].header.stamp, heard[-1].header.stamp, "of the last good frame")
        self.assertEqual(RigState.RUNNING, heard[-2].run_state)
        for m in heard:
            self.assertTrue(math.isfinite(m.hook_load) and math.isfinite(m.bit_depth))
        states.quiet()
        self.diagnostics.clear()
        self.assertEqual("failed", values(self.diagnostics.wait(3)[-1])["state"])  # they keep coming
        self.assertEqual([], states.messages)
        self.assertFalse(self.rig.resume().success)
        self.assertTrue(self.rig.reset_well("", 0.0).success)
        states.clear()
        after = states.wait(3)
        self.assertGreater(after[-1].header.stamp, after[0].header.stamp)
        self.assertAlmostEqual(99.5, after[0].bit_depth, places=3)


if __name__ == "__main__":
    run(Diagnostics)
