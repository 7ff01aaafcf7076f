#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Faults and interlocks from outside: each begins, shows and ends; what makes no sense is refused and changes nothing."""
import math

from drill_rig_sim.msg import DownholeDynamics, MwdInclination, MwdSurvey, MwdToolface, RigLimits, RigState
from drill_rig_sim.srv import InjectFaultRequest as Fault
from rig_test import Rig, flow, rospy, run, turn, unittest, winch

# kind: what it needs
ALL = {Fault.STUCK_PIPE: dict(depth=60.0), Fault.SENSOR_FREEZE: dict(target="torque"), Fault.SENSOR_BIAS: dict(target="flow", magnitude=1e-3),
       Fault.SENSOR_NOISE: dict(target="block_height", magnitude=0.01), Fault.BRAKE_SLIP: dict(magnitude=1e6), Fault.DRIVE_TRIP: {}, Fault.MOTOR_STALL: {},
       Fault.WASHED_OUT_HOLE: dict(depth=60.0, magnitude=0.1), Fault.PUMP_TRIP: {}, Fault.SENSOR_DROPOUT: dict(target="hook_load"),
       Fault.SENSOR_DRIFT: dict(target="dead_line_hook_load", magnitude=100.0), Fault.DIFFERENTIAL_STICKING: dict(depth=60.0, magnitude=1e7),
       Fault.PACK_OFF: dict(depth=60.0, magnitude=2e4), Fault.FRICTION_CHANGE: dict(depth=0.0, magnitude=1.5),
       Fault.FORMATION_CHANGE: dict(magnitude=0.5), Fault.WASHED_OUT_PIPE: dict(depth=60.0, magnitude=5e-5)}
GAUGED = [Fault.SENSOR_FREEZE, Fault.SENSOR_BIAS, Fault.SENSOR_NOISE, Fault.SENSOR_DROPOUT, Fault.SENSOR_DRIFT]


class Faults(unittest.TestCase):
    def setUp(self):
        self.rig = Rig()
        self.rig.must(self.rig.reset_well("", 0.0))

    def inject(self, kind, **needs):
        self.rig.must(self.rig.inject_fault(Fault(fault=kind, **{**ALL[kind], **needs})))

    def clear(self, kind):
        self.inject(kind, clear=True)

    def mean(self, field, frames=300):
        """Of rig_state: the block swings on its lines for long."""
        return sum(getattr(self.rig.advance(1), field) for _ in range(frames)) / frames

    def test_each_begins_and_ends(self):
        self.assertEqual(set(ALL), {v for k, v in vars(Fault).items() if k.isupper() and isinstance(v, int)})
        words = {number: name.lower() for name, number in vars(Fault).items() if name.isupper() and isinstance(number, int)}
        for kind, needs in ALL.items():
            word = words[kind] + (" of " + needs["target"] if "target" in needs else "")
            for clear in (False, True):
                answer = self.rig.inject_fault(Fault(fault=kind, clear=clear, **needs))
                self.assertTrue(answer.success, answer.message)
                self.assertTrue(answer.message)
                self.assertNotIn("\n", answer.message)
                self.assertEqual([] if clear else [word], self.rig.advance_truth(20).active_faults)

    def test_what_makes_no_sense_is_refused_and_changes_nothing(self):
        refused = [(Fault(fault=200), "fault is 200")]
        refused += [(Fault(fault=kind, **{**needs, field: value}), field + " has no effect on") for kind, needs in ALL.items()
                    for field, value in (("depth", 60.0), ("magnitude", 1.0), ("target", "flow")) if field not in needs]
        refused += [(Fault(fault=kind, **{**ALL[kind], "target": target}), "target") for kind in GAUGED for target in ("", "wob", "hook load")]
        refused += [(Fault(fault=kind, **{**needs, "magnitude": wrong}), "magnitude") for kind, needs in ALL.items() if "magnitude" in needs
                    for wrong in (math.nan, math.inf, -math.inf, 1e15)]
        refused += [(Fault(fault=kind, **{**ALL[kind], "depth": nowhere}), "depth") for kind in ALL if "depth" in ALL[kind]
                    for nowhere in (-1.0, 500.0, math.nan)]
        refused += [(Fault(fault=kind, **{**ALL[kind], "depth": 0.0}), "rotary table")
                    for kind in (Fault.STUCK_PIPE, Fault.PACK_OFF, Fault.DIFFERENTIAL_STICKING, Fault.WASHED_OUT_HOLE, Fault.WASHED_OUT_PIPE)]

        def ask():
            return [self.rig.inject_fault(request) for request, _ in refused]

        answers, expected, after = self.rig.next_frame_after(ask)
        for answer, (request, says) in zip(answers, refused):
            self.assertFalse(answer.success, request)
            self.assertIn(says, answer.message)
            self.assertNotIn("\n", answer.message)
        self.assertEqual(expected, after)

    def test_packed_cuttings_drag(self):
        self.rig.advance(300, winch=winch(0.05))
        free = self.mean("hook_load")
        self.inject(Fault.PACK_OFF)
        self.rig.advance(300)
        self.assertAlmostEqual(2e4, self.mean("hook_load") - free, delta=1e3)
        self.clear(Fault.PACK_OFF)
        self.rig.advance(300)
        self.assertAlmostEqual(free, self.mean("hook_load"), delta=1e3)

    def test_a_brake_that_slips(self):
        state = self.rig.advance(100)
        self.assertTrue(state.brake_set)
        self.inject(Fault.BRAKE_SLIP, magnitude=0.9 * state.hook_load)
        sunk = self.rig.advance(200)
        self.assertTrue(sunk.brake_set)
        self.assertLess(sunk.block_height, state.block_height - 0.2)
        self.clear(Fault.BRAKE_SLIP)
        self.rig.advance(800)
        state = self.rig.advance(1)
        self.assertAlmostEqual(state.block_height, self.rig.advance(500).block_height, delta=0.02)

    def test_drive_and_pump_trip(self):
        self.rig.advance(1500, top_drive=turn(5.0), mud_pump=flow(0.02))
        for kind, flag, signal, value in ((Fault.DRIVE_TRIP, "drive_tripped", "top_drive_speed", 5.0), (Fault.PUMP_TRIP, "pump_tripped", "flow", 0.02)):
            self.inject(kind)
            state = self.rig.advance(3000)
            self.assertTrue(getattr(state, flag))
            self.assertAlmostEqual(0.0, getattr(state, signal), delta=0.05 * value)
            self.clear(kind)
            state = self.rig.advance(1500)
            self.assertFalse(getattr(state, flag))
            self.assertAlmostEqual(value, getattr(state, signal), delta=0.05 * value)

    def test_a_drop_out_tells_and_a_frozen_gauge_does_not(self):
        self.rig.advance(100, winch=winch(0.05))
        self.inject(Fault.SENSOR_DROPOUT, target="block_height")
        self.inject(Fault.SENSOR_FREEZE, target="flow")
        first = self.rig.advance(1)
        last = self.rig.advance(100, mud_pump=flow(0.02))
        self.assertEqual(RigState.BLOCK_HEIGHT, last.lost_gauges)
        self.assertEqual((first.block_height, first.bit_depth, 0.0), (last.block_height, last.bit_depth, last.flow))
        self.assertGreater(last.block_velocity, 0.04)
        self.rig.must(self.rig.inject_fault(Fault(fault=Fault.SENSOR_DROPOUT, target="block_height", clear=True)))
        self.rig.must(self.rig.inject_fault(Fault(fault=Fault.SENSOR_FREEZE, target="flow", clear=True)))
        state = self.rig.advance(1)
        self.assertEqual(0, state.lost_gauges)
        self.assertGreater(state.block_height, last.block_height + 0.03)
        self.assertGreater(state.flow, 0.005)

    def test_over_pull_sets_the_brake(self):
        limits = rospy.wait_for_message(self.rig.topic("rig_limits"), RigLimits)
        self.assertEqual((3.5e5, 5e4, 9e6), (limits.trip_hook_load, limits.min_hook_load, limits.trip_pressure))
        self.inject(Fault.STUCK_PIPE)
        state = self.rig.advance(1000, winch=winch(0.02))
        self.assertTrue(state.over_pull and state.brake_set)
        self.assertAlmostEqual(limits.trip_hook_load, state.hook_load, delta=0.05 * limits.trip_hook_load)
        self.assertTrue(self.rig.advance(100, winch=winch(0.02)).over_pull)
        self.assertFalse(self.rig.advance(100, winch=winch(-0.02)).over_pull)

    def test_over_pressure_stops_the_pump(self):
        state = self.rig.advance(2000, mud_pump=flow(0.05))
        self.assertTrue(state.pump_tripped)
        self.assertEqual((0.0, 0.0), (state.flow, state.mud_pump.flow))
        self.assertTrue(self.rig.advance(100, mud_pump=flow(0.01)).pump_tripped)
        self.assertFalse(self.rig.advance(10, mud_pump=flow(0.0)).pump_tripped)
        self.assertAlmostEqual(0.01, self.rig.advance(1000, mud_pump=flow(0.01)).flow, delta=1e-6)

    def test_a_tool_of_dynamics(self):
        readings = self.rig.collect("downhole/dynamics", DownholeDynamics)
        state = self.rig.advance(1500, mud_pump=flow(0.01), top_drive=turn(5.0))
        last = readings.after(state.header.stamp - rospy.Duration(3))[-1]
        self.assertGreaterEqual(len(readings.messages), 5)
        self.assertAlmostEqual(2.0, last.duration, delta=1e-6)
        self.assertAlmostEqual(99.0, last.md, delta=0.5)
        self.assertAlmostEqual(5.0, last.speed, delta=0.1)
        self.assertGreaterEqual(last.largest_speed, last.least_speed)
        self.assertLess(abs(last.weight), 0.02 * state.hook_load, "it hangs")

    def test_telemetry_of_a_pump_cycle(self):
        surveys, toolfaces, inclinations = (self.rig.collect("downhole/" + name, kind) for name, kind in
                                            (("mwd", MwdSurvey), ("toolface", MwdToolface), ("inclination", MwdInclination)))
        begin = self.rig.advance(0).header.stamp
        self.rig.advance(1000, mud_pump=flow(0.02))
        self.rig.advance(1500, mud_pump=flow(0.0), top_drive=turn(5.0))  # the flow runs out in some seconds
        self.rig.advance(1000, mud_pump=flow(0.02))
        now = self.rig.advance(0).header.stamp
        survey = surveys.wait_until(lambda m: m and m[-1].header.stamp > begin + rospy.Duration(10))[-1]
        age = (now - survey.header.stamp).to_sec()
        self.assertGreater(age, 10.0, "taken before the flow came back")
        self.assertLess(age, 25.0, "and after it had stopped")
        self.assertGreater(len(inclinations.wait(3)), 2)
        self.assertTrue(all(m.inclination < 0.01 for m in inclinations.messages))
        turning = begin + rospy.Duration(12)
        self.assertTrue(toolfaces.wait(1))
        self.assertFalse([m for m in toolfaces.messages if m.header.stamp > turning], "silent while it turns")


if __name__ == "__main__":
    run(Faults)
