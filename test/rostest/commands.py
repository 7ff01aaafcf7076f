#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Commands beyond a limit are clamped and flagged, nonsense is refused whole, and a stream that stops brakes the rig."""
import math

from diagnostic_msgs.msg import DiagnosticArray, DiagnosticStatus
from drill_rig_sim.msg import MudPumpCommand, RigState, SteeringCommand, TopDriveCommand, WinchCommand
from drill_rig_sim.srv import InjectFaultRequest, StepSimulationRequest
from rig_test import PATIENCE, Rig, flow, run, rospy, time, turn, unittest, wait_until, winch


class Commands(unittest.TestCase):
    def setUp(self):
        self.rig = Rig()
        self.assertTrue(self.rig.reset_well("", 0.0).success)

    def by_topic(self, publisher, command, obeyed):
        """Sends the command and takes frames until it is in force."""
        publisher.publish(command)
        deadline = time.monotonic() + PATIENCE
        while time.monotonic() < deadline:
            state = self.rig.advance(1)
            if obeyed(state):
                return state
            time.sleep(0.02)
        self.fail("the command was not obeyed: %s" % command)

    def refused(self):
        """How many commands the node counts as refused."""
        diagnostics = self.rig.collect("/diagnostics", DiagnosticArray)
        self.assertTrue(diagnostics.wait(2))
        for status in diagnostics.messages[-1].status:
            for pair in status.values:
                if pair.key == "refused":
                    return int(pair.value)
        self.fail("no count of refused commands")

    def commands_status(self, said):
        """The diagnostics of commands, once they report it."""
        diagnostics = self.rig.collect("/diagnostics", DiagnosticArray)

        def status(messages):
            found = [s for m in messages for s in m.status if s.name.endswith("commands") and said in s.message]
            return found[0] if found else None
        diagnostics.wait_until(status)
        found = status(diagnostics.messages)
        self.assertIsNotNone(found, "never: " + said)
        return found

    def test_a_refusal_is_counted_and_explained_at_once(self):
        before = self.rig.advance(1)
        states, diagnostics = self.rig.collect("rig_state", RigState), self.rig.collect("/diagnostics", DiagnosticArray)
        sent = time.monotonic()
        self.rig.publisher("winch/command", WinchCommand).publish(winch(math.nan))
        told = states.wait_until(lambda m: any(s.commands_refused > before.commands_refused for s in m))[-1]  # time stands all the while
        self.assertEqual((before.header.stamp, before.commands_refused + 1), (told.header.stamp, told.commands_refused))
        self.assertEqual("block_velocity: must be finite", told.last_refusal)
        found = diagnostics.wait_until(lambda m: any("block_velocity: must be finite" in s.message for a in m for s in a.status))
        self.assertTrue(any("block_velocity: must be finite" in s.message for a in found for s in a.status))
        self.assertLess(time.monotonic() - sent, PATIENCE)
        self.assertEqual(told.commands_refused, self.rig.advance(1).commands_refused)

    def test_every_kind_of_command_takes_effect_from_its_topic(self):
        winches = self.rig.publisher("winch/command", WinchCommand)
        drives = self.rig.publisher("top_drive/command", TopDriveCommand)
        pumps = self.rig.publisher("mud_pump/command", MudPumpCommand)
        state = self.by_topic(winches, winch(0.2), lambda s: s.winch.block_velocity == 0.2)
        self.assertFalse(state.brake_set)
        self.assertGreater(state.last_command.to_nsec(), 0)
        state = self.by_topic(drives, turn(3.0), lambda s: s.top_drive.speed == 3.0)
        self.assertEqual(state.last_command, state.top_drive.header.stamp)
        state = self.by_topic(pumps, flow(0.01), lambda s: s.mud_pump.flow == 0.01)
        self.assertFalse(state.command_clamped)

    def test_beyond_a_limit_is_clamped_and_flagged(self):
        state = self.rig.advance(1, winch=winch(-100.0))
        self.assertEqual(-1.5, state.winch.block_velocity)
        self.assertTrue(state.command_clamped)
        status = self.commands_status("beyond a limit: block_velocity")
        self.assertIn(status.level, (DiagnosticStatus.WARN, bytes([1]), 1))
        self.assertGreater(int(next(p.value for p in status.values if p.key == "clamped")), 0)
        state = self.rig.advance(1, top_drive=turn(1e4))
        self.assertAlmostEqual(220.0 * math.pi / 30.0, state.top_drive.speed, places=9)
        self.assertTrue(state.command_clamped)
        state = self.rig.advance(1, mud_pump=flow(9.0))
        self.assertEqual(0.06, state.mud_pump.flow)
        self.assertTrue(state.command_clamped)

    def test_nonsense_in_a_step_is_refused_whole_and_no_frame_computed(self):
        self.rig.advance(5, winch=winch(0.1), top_drive=turn(2.0))
        for bad in ({"winch": [winch(math.nan)]}, {"top_drive": [turn(math.inf)]}, {"mud_pump": [flow(math.nan)]},
                    {"top_drive": [TopDriveCommand(mode=7)]}, {"top_drive": [TopDriveCommand(mode=TopDriveCommand.ANGLE, angle=1e12)]}, {"top_drive": [TopDriveCommand(mode=TopDriveCommand.OSCILLATE)]},
                    {"top_drive": [TopDriveCommand(mode=TopDriveCommand.OSCILLATE, amplitude_right=1.0, amplitude_left=-1.0)]}, {"winch": [winch(0.3)], "top_drive": [turn(math.nan)]},
                    {"winch": [winch(0.1), winch(0.2)]}, {"steering": [SteeringCommand(toolface=0.0, ratio=1.0)]}):
            answer, expected, after = self.rig.next_frame_after(lambda: self.rig.step(StepSimulationRequest(frames=5, **bad)))
            self.assertFalse(answer.success, bad)
            self.assertNotEqual("", answer.message)
            self.assertEqual(expected, after, bad)

    def test_a_steps_commands_come_after_those_that_topics_brought_before(self):
        winches = self.rig.publisher("winch/command", WinchCommand)
        self.by_topic(winches, winch(0.3), lambda s: s.winch.block_velocity == 0.3)  # it is heard
        for velocity in (0.2, 0.4):
            winches.publish(winch(velocity))
            time.sleep(0.5)  # it has come by now; if not, this shows nothing
            self.assertEqual(0.01, self.rig.advance(1, winch=winch(0.01)).winch.block_velocity)

    def test_nonsense_on_a_topic_is_refused_and_counted(self):
        self.rig.advance(1, winch=winch(0.1), top_drive=turn(2.0))
        before = self.refused()
        publishers = {"winch/command": (WinchCommand, winch(math.nan)), "mud_pump/command": (MudPumpCommand, flow(math.inf)),
                      "top_drive/command": (TopDriveCommand, TopDriveCommand(mode=99)),
                      "steering/command": (SteeringCommand, SteeringCommand())}
        for topic, (kind, command) in publishers.items():
            self.rig.publisher(topic, kind).publish(command)
        deadline = time.monotonic() + PATIENCE
        count = before
        while count < before + len(publishers) and time.monotonic() < deadline:
            self.rig.advance(1)
            count = self.refused()
        self.assertEqual(before + len(publishers), count)
        state = self.rig.advance(0)
        self.assertEqual(0.1, state.winch.block_velocity)
        self.assertEqual(2.0, state.top_drive.speed)

    def test_the_refusal_of_steering_names_itself(self):
        before = self.refused()
        self.rig.publisher("steering/command", SteeringCommand).publish(SteeringCommand())
        wait_until(lambda: self.rig.advance(1) and self.refused() > before, "refusal of steering/command")
        status = self.commands_status("")
        self.assertIn("rotary_steerable", next(p.value for p in status.values if p.key == "last_refusal"))

    def test_silence_sets_the_brake_and_the_next_command_takes_it_off(self):
        def speak():
            return self.rig.advance(50, winch=winch(0.05), top_drive=turn(2.0))

        for _ in range(4):
            state = speak()
        self.assertFalse(state.commands_timed_out)
        self.assertFalse(state.brake_set)
        self.assertTrue(self.rig.advance(60).commands_timed_out)  # the parameter says 1 s, 0.5 s had passed
        state = self.rig.advance(200)
        self.assertTrue(state.brake_set)
        later = self.rig.advance(500)  # it swings on the lines, but it goes nowhere
        self.assertAlmostEqual(state.block_height, later.block_height, delta=0.02)
        self.assertAlmostEqual(0.0, later.top_drive.speed)
        state = speak()
        self.assertFalse(state.commands_timed_out)
        self.assertFalse(state.brake_set)

    def test_stuck_pipe_holds_the_string_until_it_is_freed(self):
        stuck = InjectFaultRequest(fault=InjectFaultRequest.STUCK_PIPE, depth=90.0)
        for nowhere in (500.0, 0.0, -3.0, math.nan, math.inf):  # below the bit, in the air, no place at all
            answer, expected, after = self.rig.next_frame_after(
                lambda: self.rig.inject_fault(InjectFaultRequest(fault=InjectFaultRequest.STUCK_PIPE, depth=nowhere)))
            self.assertFalse(answer.success, nowhere)
            self.assertIn("rotary table", answer.message)
            self.assertEqual(expected, after)

        def mean_hook_load():  # the block swings on its lines for long
            return sum(self.rig.advance(1).hook_load for _ in range(400)) / 400

        still = mean_hook_load()
        self.assertTrue(self.rig.inject_fault(stuck).success)
        self.rig.advance(40, winch=winch(0.05))
        self.rig.advance(40, winch=winch(0.0))
        self.assertGreater(mean_hook_load(), 1.2 * still)
        stuck.clear = True
        self.assertTrue(self.rig.inject_fault(stuck).success)
        self.assertAlmostEqual(still, mean_hook_load(), delta=0.05 * still)

    def test_tare_makes_zero_here(self):
        self.assertTrue(self.rig.tare().success)
        state = self.rig.advance(1)
        self.assertTrue(state.tared)
        self.assertAlmostEqual(0.0, state.surface_wob, delta=0.01 * state.hook_load)


if __name__ == "__main__":
    run(Commands)
