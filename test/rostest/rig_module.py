#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The Python module drill_rig_sim.rig against the node: set points, time, readings and truth, what is refused, and runs that repeat."""
import os
import tempfile

import numpy
import yaml
from drill_rig_sim.msg import BitTruth, RigState, RigTruth, TopDriveCommand
from drill_rig_sim.recorder import Recorder
from drill_rig_sim.rig import RPM, Refused, Rig, TimedOut, series
from drill_rig_sim.score import read_run
from rig_test import PACKAGE_DIR, PATIENCE, Collector, numbers, rospy, run, time, unittest

FRAME = 0.01  # [s]


class RigModule(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.rig = Rig("rig")

    def setUp(self):
        self.rig.reset(scene="quick.yaml")

    def drilling(self):
        """Quick's bit, a few centimetres into the rock."""
        self.rig.rotate(rpm=90)
        self.rig.winch(-0.02)
        return self.rig.step_until(lambda s: s.truth.on_bottom and s.truth.hole_depth > 100.02, timeout=60)

    def test_a_run_is_recorded_as_the_runner_writes_it(self):
        with tempfile.TemporaryDirectory() as folder:
            recorder = Recorder(os.path.join(folder, "run.csv"), "rig/", period=FRAME)
            self.wait(lambda: self.rig.step() and recorder.last is not None)
            states = []
            for _ in range(5):
                states.append(self.rig.step())
                self.wait(lambda: recorder.last is not None and recorder.last > states[-1].t - 0.5 * FRAME)
            recorder.close()
            run = read_run(os.path.join(folder, "run.csv"))
        for column, wanted in (("time", series(states, "t")), ("hook_load", series(states, "truth.hook_load")), ("wob", series(states, "bit.wob"))):
            self.assertLess(max(abs(run[column][-5:] - wanted)), 1e-6 * max(abs(wanted)) + 1e-6)

    def test_operations_are_asked_for_while_it_runs(self):
        before = self.rig.operate([{"do": "pick_up", "distance": "3 m", "speed": 0.5}])
        self.rig.step_until(lambda s: s.operation_number == 0, timeout=60.0)
        after = self.rig.step(2.0)  # until the block stands
        self.assertAlmostEqual(3.0, after.block_height - before.block_height, delta=0.02)
        self.assertEqual("", self.rig.given_up)
        for _ in range(20):  # the answer to a goal may come before it is sent completely
            with self.assertRaisesRegex(Refused, "allowed: flow"):
                self.rig.operate({"do": "fly"})
        self.rig.operate({"do": "drill", "weight": 1e4, "distance": 1.0, "speed": 0.2})
        self.rig.step(1.0)
        self.rig.pump(0.01)
        self.assertTrue(self.rig.step().brake_set)
        self.wait(lambda: self.rig.given_up)
        self.assertIn("taken over", self.rig.given_up)

    def wait(self, until):
        deadline = time.monotonic() + PATIENCE
        while not until():
            self.assertLess(time.monotonic(), deadline)
            time.sleep(0.01)

    def test_the_rate_is_the_nodes(self):
        self.assertEqual(100.0, self.rig.rate)

    def variant(self, scene, change):
        """Resets to a shipped scene that `change` has changed, a function of its dictionary."""
        with open(os.path.join(PACKAGE_DIR, "config/scenes", scene), encoding="utf-8") as text:
            spec = yaml.safe_load(text)
        change(spec)
        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(folder, scene)
            with open(file, "w", encoding="utf-8") as out:
                yaml.safe_dump(spec, out)
            return self.rig.reset(scene=file)

    def test_a_steady_pick_up_does_not_ring(self):
        self.rig.reset(scene="autodriller.yaml")
        for speed in (0.2, 0.5):
            self.rig.winch(speed)
            self.rig.step(25.0)  # what the start has shaken dies away
            loads = series(list(self.rig.frames(5.0)), "truth.hook_load")
            self.assertLess(loads.std(), 5e3, speed)
            self.rig.reset()

    def test_gauges_have_outliers_and_the_control_system_a_latency(self):
        def flawed(spec):
            spec.setdefault("instruments", {}).setdefault("surface", {}).setdefault("hook_load", {}).update(outlier_interval=1.0, outlier_size=100e3)
            spec["rig"] = {**spec.get("rig", {}), "plc_latency": 0.2}
        self.variant("quick.yaml", flawed)
        states = list(self.rig.frames(20.0))
        off = abs(series(states, "hook_load") - series(states, "truth.hook_load"))
        self.assertGreater((off > 50e3).sum(), 5)
        self.assertLess((off > 50e3).mean(), 0.2)
        self.rig.winch(0.1)
        begin = self.rig.state.t
        state = self.rig.step_until(lambda s: s.winch.block_velocity == 0.1, timeout=2.0)
        self.assertAlmostEqual(0.2, state.t - begin, delta=2.1 * FRAME)

    def test_a_zero_over_seconds_tells_mean_and_deviation(self):
        with self.assertRaisesRegex(Refused, "needed: 10.0 s"):
            self.rig.tare_over(10.0)
        with self.assertRaisesRegex(Refused, "0.5 to 60"):
            self.rig.tare_over(0.0)
        loads = series(list(self.rig.frames(12.0)), "hook_load")[-1000:]
        zero = self.rig.tare_over(10.0)
        self.assertTrue(self.rig.state.tared)
        self.assertAlmostEqual(10.0, zero.duration, delta=0.25)
        self.assertAlmostEqual(loads.mean(), zero.hook_load, delta=0.1 * loads.std() + 1.0)
        self.assertAlmostEqual(loads.std(), zero.hook_load_deviation, delta=0.1 * loads.std() + 1.0)
        self.assertAlmostEqual(zero.hook_load, self.rig.state.hook_load + self.rig.state.surface_wob, delta=1e-3)

    def test_a_step_answers_with_the_telemetry_that_came_up(self):
        self.rig.reset(scene="bohai.yaml")
        self.assertIsNone(self.rig.toolface)
        self.rig.pump(0.03)
        self.rig.step(40.0)
        toolface, survey = self.rig.toolface, self.rig.survey
        self.assertLess(0.0, survey.md)
        self.rig.step()
        self.assertIs(survey, self.rig.survey, "the same object until another has come")
        self.rig.step(30.0)
        self.assertLess(toolface.t, self.rig.toolface.t)
        self.rig.reset(scene="quick.yaml")
        self.assertIsNone(self.rig.survey)

    def test_set_points_wait_for_a_frame_and_act_from_it_on(self):
        self.rig.winch(-0.02)
        self.rig.pump(0.03)
        self.rig.rotate(rpm=60, torque_limit=5e3)
        before = self.rig.tare()  # moves nothing, and loses none
        self.assertTrue(before.tared)
        self.assertTrue(before.brake_set)
        after = self.rig.step()
        self.assertAlmostEqual(before.t + FRAME, after.t, places=9)
        self.assertEqual((-0.02, 0.03), (after.winch.block_velocity, after.mud_pump.flow))
        self.assertEqual((TopDriveCommand.SPEED, 60 * RPM, 5e3), (after.top_drive.mode, after.top_drive.speed, after.top_drive.torque_limit))
        self.assertEqual(-0.02, self.rig.step().winch.block_velocity)
        self.rig.brake()
        self.rig.top_drive(mode=TopDriveCommand.TORQUE, torque=100.0)
        state = self.rig.step(1.0)
        self.assertAlmostEqual(before.t + 102 * FRAME, state.t, places=9)
        self.assertTrue(state.winch.brake and state.brake_set)
        self.assertEqual((TopDriveCommand.TORQUE, 100.0), (state.top_drive.mode, state.top_drive.torque))

    def test_time_moves_by_whole_frames(self):
        begin = self.rig.state.t
        self.assertEqual([3, 6, 9, 10], [round((s.t - begin) / FRAME) for s in self.rig.frames(0.1, every=3)])
        for seconds in (0.005, -1.0, float("nan"), float("inf")):
            self.assertRaises(ValueError, self.rig.step, seconds)
        self.assertAlmostEqual(begin + 0.1, self.rig.step(frames=0).t, places=9)

    def test_a_condition_is_waited_for_no_longer_than_told(self):
        begin = self.rig.state.t
        with self.assertRaisesRegex(TimedOut, "not within 0.5 s"):
            self.rig.step_until(lambda s: s.truth.on_bottom, timeout=0.5)
        self.assertAlmostEqual(begin + 0.5, self.rig.state.t, places=9)
        state = self.drilling()
        self.assertIs(state, self.rig.state)
        self.assertGreater(state.bit.wob, 0.0)

    def test_states_are_what_the_topics_say(self):
        topics = {"rig_state": RigState, "truth/rig_state": RigTruth, "truth/bit": BitTruth}
        heard = {name: Collector("/rig/" + name, kind) for name, kind in topics.items()}
        state = self.drilling()
        stamp = state.header.stamp
        self.assertEqual(stamp.to_sec(), state.t)
        for name, message in (("rig_state", state.readings), ("truth/rig_state", state.truth), ("truth/bit", state.bit)):
            self.assertEqual(numbers(heard[name].at(stamp)), numbers(message), name)
            self.assertEqual(stamp, message.header.stamp, name)
            heard[name].subscriber.unregister()

    def test_the_truth_of_the_bit(self):
        state = self.drilling()
        self.assertAlmostEqual(-state.truth.bit_depth, state.bit.position.z, delta=1e-6)  # the well is vertical
        self.assertLess(state.bit.inclination, 0.01)
        self.assertAlmostEqual(90 * RPM, state.bit.speed, delta=3.0)
        self.assertGreater(state.bit.torque, 0.0)
        self.assertGreater(state.truth.rop, 0.0)

    def test_what_no_rig_can_sense_is_asked_of_the_truth(self):
        state = self.drilling()
        self.assertFalse(hasattr(state.readings, "on_bottom"))
        with self.assertRaisesRegex(AttributeError, "truth.on_bottom"):
            self.rig.step_until(lambda s: s.on_bottom, timeout=1.0)

    def test_refusals_are_raised_and_change_nothing(self):
        before = self.rig.step()
        self.rig.winch(float("nan"))
        self.assertRaises(Refused, self.rig.step)
        self.rig.steer(0.0, 0.5)
        self.assertRaisesRegex(Refused, "no rotary_steerable", self.rig.step)
        self.assertRaisesRegex(Refused, "100000", self.rig.step, frames=100001)
        self.assertRaises(Refused, self.rig.restore, "never saved")
        self.assertRaises(Refused, self.rig.reset, bit_depth=1e6)
        self.assertRaises(Refused, self.rig.load_survey, "no_such.csv")
        self.assertRaisesRegex(Refused, "the slips are not set", self.rig.slips, False)
        self.assertRaisesRegex(Refused, "slips are not set", self.rig.connection)
        self.assertRaisesRegex(Refused, "magnitude", self.rig.fault, "BRAKE_SLIP", magnitude=-1.0)
        self.assertRaises(AttributeError, self.rig.fault, "EARTHQUAKE")
        self.assertEqual(before.t, self.rig.step(frames=0).t)
        self.assertAlmostEqual(before.t + FRAME, self.rig.step().t, places=9)
        with self.assertRaises(rospy.ROSException):
            Rig("no_such_rig", patience=0.5)

    def test_a_stuck_pipe_hangs_until_it_is_free(self):
        self.rig.fault("STUCK_PIPE", depth=90.0)
        self.rig.winch(0.05)
        stuck = self.rig.step(4.0)
        self.assertLess(abs(stuck.truth.bit_depth - 99.7), 0.02)
        self.rig.clear_fault("STUCK_PIPE")
        self.rig.step(4.0)
        self.assertLess(self.rig.state.truth.bit_depth, 99.5)

    def test_another_well(self):
        state = self.rig.load_survey(md=[0.0, 100.0], inclination=[0.0, 0.05], azimuth=[0.0, 1.0])
        self.assertAlmostEqual(0.05, state.bit.inclination, delta=1e-3)
        self.assertAlmostEqual(1.0, state.bit.azimuth, delta=1e-3)
        self.assertEqual(50.0, round(self.rig.reset(scene="quick.yaml", bit_depth=50.0).truth.bit_depth, 3))

    def test_runs_repeat_bit_for_bit_from_the_start_and_from_snapshots(self):
        def drill():
            speed, states = 0.01, []
            for _ in range(500):
                speed = min(max(speed + 5e-9 * (10e3 - self.rig.state.surface_wob), 0.0), 0.015)
                self.rig.winch(-speed)
                states.append(self.rig.step())
            return [numbers(s.readings) + numbers(s.truth) + numbers(s.bit) for s in states]

        self.drilling()
        self.rig.save("here")
        with tempfile.TemporaryDirectory() as folder:
            self.rig.save(file=os.path.join(folder, "state"))
            first = drill()
            self.rig.winch(0.5)  # forgotten
            self.rig.restore("here")
            self.assertEqual(first, drill())
            self.rig.restore(file=os.path.join(folder, "state"))
            self.assertEqual(first, drill())
        self.rig.reset()
        self.drilling()
        self.assertEqual(first, drill())

    def test_numbers_come_as_arrays(self):
        states = list(self.rig.frames(0.05))
        self.assertEqual((5,), series(states, "truth.hook_load").shape)
        self.assertEqual([s.hook_load for s in states], series(states, "hook_load").tolist())
        self.assertAlmostEqual(4 * FRAME, numpy.ptp(series(states, "t")), places=9)


if __name__ == "__main__":
    run(RigModule)
