#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The Python module drill_rig_sim.sim: a rig in this process. That it reads as a node's does: test/rostest/three_ways.test"""
import copy
import os
import pathlib
import pickle
import signal
import subprocess
import sys
import tempfile
import threading
import time
import unittest

import numpy
from drill_rig_sim.autodriller import Autodriller
from drill_rig_sim.control import drive
from drill_rig_sim.lockstep import MODES, RPM, UNSENSED
from drill_rig_sim.score import score
from drill_rig_sim.score_runs import run_of_record, run_of_states
from drill_rig_sim.sim import RPM, Failed, Refused, Simulator, TimedOut, series, static

PACKAGE_DIR = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
QUICK = os.path.join(PACKAGE_DIR, "config/scenes/quick.yaml")
STANDS = os.path.join(PACKAGE_DIR, "config/scenes/stands.yaml")
STEERABLE = os.path.join(PACKAGE_DIR, "test/scenes/steerable.yaml")
sys.path.insert(0, os.path.join(PACKAGE_DIR, "launch"))
OTHERWISE = ("header", "run_state", "last_command")  # fields of RigState that only a node has


def alone(folder):
    """quick.yaml without a companion, which takes most of the time."""
    file = os.path.join(folder, "alone.yaml")
    with open(QUICK, encoding="utf-8") as text, open(file, "w", encoding="utf-8") as out:
        out.write(text.read() + "numerics: {companion: none}\n")
    return file


def fields_of(kind):
    return [name for name in kind.__slots__ if name not in OTHERWISE]


class InThisProcess(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.scene = alone(folder.name)

    def setUp(self):
        self.rig = Simulator(self.scene)

    def drilling(self):
        self.rig.rotate(rpm=90)
        self.rig.winch(-0.02)
        return self.rig.step_until(lambda s: s.truth.on_bottom and s.truth.hole_depth > 100.02, timeout=60)

    def test_it_needs_no_ros(self):
        asked = "import sys; from drill_rig_sim.sim import Simulator; Simulator(%r).step(); print([m for m in sys.modules if m.startswith(('ros', 'genpy'))])"
        said = subprocess.run([sys.executable, "-c", asked % QUICK], capture_output=True, text=True, check=True)
        self.assertEqual("[]", said.stdout.strip())

    def test_states_have_the_fields_of_the_messages(self):
        from drill_rig_sim.msg import BitTruth, RigState, RigTruth, TopDriveCommand
        state = self.drilling()
        for signals, kind in ((state.readings, RigState), (state.truth, RigTruth), (state.bit, BitTruth), (state.top_drive, TopDriveCommand)):
            for name in set(fields_of(kind)) - {"commands_refused", "last_refusal"}:  # here a refusal is an exception
                self.assertTrue(hasattr(signals, name), name)
        self.assertEqual({name: getattr(TopDriveCommand, name) for name in MODES}, MODES)
        self.assertIs(True, state.truth.on_bottom)
        with self.assertRaisesRegex(AttributeError, "truth.on_bottom"):
            state.on_bottom  # pylint: disable=pointless-statement

    def test_static_loads_are_what_the_gauge_shows_while_the_block_moves(self):
        """Off bottom, without rotation, at a speed that makes no waves; by gauges at both places."""
        with open(self.scene, encoding="utf-8") as text:
            scene = text.read()
        for place in ("block", "dead_line"):
            with tempfile.TemporaryDirectory() as folder:
                file = os.path.join(folder, "q.yaml")
                with open(file, "w", encoding="utf-8") as out:
                    out.write(scene.replace("hook_load: {place: block}", "hook_load: {place: %s}" % place))
                for motion, speed in (("up", 0.05), ("down", -0.01)):
                    rig = Simulator(file)
                    rig.winch(speed)
                    rig.step(20.0)
                    shown = numpy.mean([state.hook_load for state in rig.frames(5.0)])
                    self.assertAlmostEqual(1.0, shown / static(file, motion)["hook_load_gauge"], delta=2e-3, msg="%s %s" % (place, motion))

    def test_set_points_act_from_the_next_frame_on(self):
        self.rig.winch(-0.02)
        self.rig.pump(0.03)
        self.rig.rotate(rpm=60, torque_limit=5e3, mode="SOFT_TORQUE")
        self.assertTrue(self.rig.tare().tared)
        self.assertTrue(self.rig.state.brake_set)
        after = self.rig.step()
        self.assertAlmostEqual(0.01, after.t, places=12)
        self.assertEqual((-0.02, 0.03), (after.winch.block_velocity, after.mud_pump.flow))
        self.assertEqual((3, 60 * RPM, 5e3), (after.top_drive.mode, after.top_drive.speed, after.top_drive.torque_limit))
        self.rig.brake()
        self.assertTrue(self.rig.step().winch.brake)

    def test_a_record_holds_what_steps_give(self):
        first = self.drilling()
        self.rig.save("drilling")
        states = [self.rig.step() for _ in range(100)]
        self.assertEqual(first.t, self.rig.restore("drilling").t)
        run = self.rig.record(1.0)
        self.assertEqual(100, len(run.t))
        self.assertEqual(states[-1].hook_load, self.rig.state.hook_load)
        for name in ("hook_load", "winch.block_velocity", "stand_count", "brake_set", "lost_gauges"):
            self.assertTrue((series(states, name) == run.readings[name]).all(), name)
        self.assertTrue((series(states, "truth.hole_depth") == run.truth["hole_depth"]).all())
        self.assertTrue((series(states, "bit.position.z") == run.bit["position.z"]).all())
        self.rig.restore("drilling")
        self.assertTrue((run.t[[29, 59, 89, 99]] == self.rig.record(1.0, every=30).t).all())

    def test_a_record_is_judged_as_a_run(self):
        self.drilling()
        judged = score(run_of_record(self.rig.record(20.0)))
        self.assertAlmostEqual(20.0, judged["drilling"]["duration_s"], delta=0.02)

    def test_states_of_a_law_are_judged_as_a_run(self):
        law = Autodriller({"weight": 10e3}, stiffness=6e5, rop=0.012, rpm=60.0, flow=0.03, to_depth=1000.6)
        law.spin_up_time = law.zero_time = 5.0
        rig = Simulator("autodriller.yaml")
        states = drive(rig, law, 60.0, telemetry=rig)
        self.assertAlmostEqual(59.9, score(run_of_states(states))["drilling"]["duration_s"], delta=1e-6)
        with self.assertRaisesRegex(ValueError, "period of 0.1 s is not a whole number of frames of 0.25 s"):
            drive(Simulator("autodriller.yaml", rate=4.0), law, 1.0)

    def test_what_no_rig_can_sense_is_not_among_recorded_readings(self):
        run = self.rig.record(0.1)
        for name in UNSENSED:
            self.assertNotIn(name, run.readings.dtype.names)
            self.assertIn(name, run.truth.dtype.names)

    def test_a_long_record_is_one(self):
        rig = Simulator(self.scene, rate=1000.0)
        run = rig.record(150.0, every=40000)
        self.assertEqual([40.0, 80.0, 120.0, 150.0], list(run.t))

    def test_a_frame_that_fails_keeps_what_came_before(self):
        rig = Simulator(os.path.join(PACKAGE_DIR, "test/scenes/unsolvable.yaml"), rate=20.0, play_program=True)
        with self.assertRaisesRegex(Failed, "a frame failed") as caught:
            rig.record(100.0)
        self.assertGreater(len(caught.exception.record.t), 5)
        self.assertEqual(caught.exception.record.t[-1], rig.state.t)
        with self.assertRaisesRegex(Refused, "reset or restore first"):
            rig.step()
        self.assertEqual(0.0, rig.reset().t)

    def test_ctrl_c_ends_a_long_step(self):
        rig = Simulator("bohai.yaml")
        threading.Timer(0.3, lambda: os.kill(os.getpid(), signal.SIGINT)).start()
        begin = time.monotonic()
        with self.assertRaises(KeyboardInterrupt):
            rig.rotate(rpm=60)
            rig.step(1000.0)
        self.assertLess(time.monotonic() - begin, 60.0)
        self.assertTrue(0.0 < rig.state.t < 1000.0)

    def test_two_threads_at_once_are_refused(self):
        refused = []

        def step():
            for _ in range(20):
                try:
                    self.rig.step(5.0)
                except Refused as refusal:
                    refused.append(str(refusal))
        threads = [threading.Thread(target=step) for _ in range(2)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual({"another thread is using this rig"}, set(refused) or {"another thread is using this rig"})
        self.rig.step()

    def test_states_can_be_copied_and_pickled(self):
        state = self.drilling()
        for copied in (copy.deepcopy(state), pickle.loads(pickle.dumps(state))):
            self.assertEqual((state.t, state.hook_load, state.truth.hole_depth, state.bit.position.z, state.winch.block_velocity),
                             (copied.t, copied.hook_load, copied.truth.hole_depth, copied.bit.position.z, copied.winch.block_velocity))

    def test_scenes_by_name_package_and_path(self):
        for scene in ("quick.yaml", "package://drill_rig_sim/config/scenes/quick.yaml", pathlib.Path(QUICK)):
            self.assertEqual(self.rig.state.hook_load, Simulator(scene).state.hook_load)
        for wrong in ("nowhere.yaml", "package://drill_rig_sim", "package://nowhere/quick.yaml", "/nowhere.yaml"):
            with self.assertRaises(Refused):
                Simulator(wrong)

    def test_runs_repeat(self):
        runs = []
        for _ in range(2):
            self.drilling()
            runs.append(self.rig.record(5.0))
            self.rig.reset()
        for kind in ("readings", "truth"):
            first, second = (getattr(run, kind) for run in runs)
            self.assertEqual([name for name in first.dtype.names if name == "epoch" or not (first[name] == second[name]).all()], ["epoch"])
            self.assertTrue((first["epoch"] == 0).all() and (second["epoch"] == 1).all())
        self.assertTrue(numpy.isfinite(runs[0].bit["wob"]).all())

    def test_a_scenes_program_gives_the_set_points_until_somebody_else_does(self):
        rig = Simulator(os.path.join(PACKAGE_DIR, "test/scenes/operations.yaml"), play_program=True)
        state = rig.step(1.0)
        self.assertNotEqual("", state.current_operation)
        self.assertEqual(1, state.operation_number)
        rig.brake()
        self.assertEqual(("", 0), (rig.step().current_operation, rig.state.operation_number))

    def test_operations_are_asked_for_while_it_runs(self):
        rig = Simulator(os.path.join(PACKAGE_DIR, "test/scenes/operations.yaml"))
        rig.rotate(rpm=20)
        before = rig.operate([{"do": "pick_up", "distance": "3 m"}, {"do": "flow", "flow": 0.01}])
        self.assertEqual(20.0, round(rig.step(10.0).top_drive.speed / RPM, 6))
        self.assertEqual(("pick_up", 1), (rig.state.current_operation, rig.state.operation_number))
        rig.save("midway")
        after = rig.step_until(lambda s: s.operation_number == 0, timeout=60.0)
        self.assertAlmostEqual(3.0, after.block_height - before.block_height, delta=0.01)
        self.assertEqual((True, 0.01, ""), (rig.step().winch.brake, rig.state.mud_pump.flow, rig.given_up))
        rig.restore("midway")
        again = rig.step_until(lambda s: s.operation_number == 0, timeout=60.0)
        self.assertEqual((after.t, after.block_height), (again.t, again.block_height))
        rig.operate("{do: slack_off, distance: 3}")
        rig.step(5.0)
        rig.pump(0.02)
        self.assertEqual((True, 0), (rig.step().winch.brake, rig.state.operation_number))
        rig.operate({"do": "connection"})
        rig.step_until(lambda s: rig.given_up, timeout=60.0)
        self.assertIn("the bit reaches bottom before", rig.given_up)
        for operations, words in (({"do": "trip", "to_depth": "400 ft"}, "400 ft is below the hole's bottom"), ("{do: fly}", "allowed: flow"), ([], "is empty")):
            with self.assertRaisesRegex(Refused, words):
                rig.operate(operations)
        rig.rotate(rpm=0.0)
        rig.step(10.0)  # until all stands
        rig.slips(True)
        with self.assertRaisesRegex(Refused, "string is in the slips"):
            rig.operate("{do: wait, time: 1}")

    def test_another_well_and_another_start(self):
        self.assertAlmostEqual(50.0, self.rig.reset(bit_depth=50.0).truth.bit_depth, delta=1e-3)
        self.assertAlmostEqual(79.5, self.rig.load_survey(md=[0.0, 80.0], inclination=[0.0, 0.1], azimuth=[0.0, 0.5]).truth.bit_depth, delta=0.3)
        with tempfile.TemporaryDirectory() as folder:
            survey = os.path.join(folder, "survey.csv")
            with open(survey, "w") as text:
                text.write("md_m,inclination_deg,azimuth_deg\n0,0,0\n120,2,90\n")
            self.assertEqual(120.0, self.rig.load_survey(survey).truth.hole_depth)

    def test_a_zero_over_seconds_is_of_the_readings_before(self):
        states = list(self.rig.frames(12.0))[-1000:]
        loads = numpy.array([state.hook_load for state in states])
        zero = self.rig.tare_over(10.0)
        self.assertAlmostEqual(loads.mean(), zero.hook_load, delta=0.1 * loads.std() + 1.0)
        self.assertAlmostEqual(loads.std(), zero.hook_load_deviation, delta=0.1 * loads.std() + 1.0)
        self.assertAlmostEqual(zero.hook_load, self.rig.state.hook_load + self.rig.state.surface_wob, delta=1e-3)
        self.assertTrue(self.rig.state.tared)

    def test_what_is_refused_changes_nothing(self):
        self.drilling()
        state = self.rig.step()
        for text, call in {
                "on bottom": self.rig.tare, "bit is on bottom": lambda: self.rig.tare_over(1.0), "0.5 to 60": lambda: self.rig.tare_over(0.0),
                "rotary_steerable": lambda: (self.rig.steer(0.0, 0.5), self.rig.step()),
                "pipe in the hole": lambda: self.rig.fault("STUCK_PIPE", depth=1e4), "hook_load, dead_line": lambda: self.rig.fault("SENSOR_BIAS", magnitude=1.0),
                "fault is nonsense": lambda: self.rig.fault("NONSENSE"), "0 .a stand. to 12": lambda: self.rig.connection(13),
                "there is no state x": lambda: self.rig.restore("x"), "frames is 100001": lambda: self.rig.step(frames=100001),
                "every is 0": lambda: self.rig.record(0.1, every=0), "every is -1; allowed is 1 to": lambda: self.rig.record(0.1, every=-1),
                "seed is -1; allowed is 0 to": lambda: Simulator(STEERABLE, seed=-1), "nowhere.yaml": lambda: self.rig.reset("/nowhere.yaml"),
                "the same number of each": lambda: self.rig.load_survey(md=[0.0, 1.0], inclination=[0.0], azimuth=[0.0]),
                "bit_depth is": lambda: self.rig.reset(bit_depth=500.0), "block_velocity": lambda: (self.rig.winch(float("nan")), self.rig.step())}.items():
            with self.assertRaisesRegex(Refused, text):
                call()
        self.rig.save("here")
        self.rig.restore("here")  # what waits for a frame is forgotten
        self.assertEqual((state.t, state.hook_load), (self.rig.state.t, self.rig.state.hook_load))
        with self.assertRaisesRegex(Refused, "whole number"):
            Simulator(os.path.join(PACKAGE_DIR, "test/scenes/vertical_frictionless.yaml"), rate=333.0)
        with self.assertRaisesRegex(ValueError, "SOFT_TORQUE"):
            self.rig.rotate(10, mode="FOO")
        for frames in (-1, 1.5):
            with self.assertRaisesRegex(ValueError, "whole number"):
                self.rig.step(frames=frames)
        for text, call in {"^top_drive: angel is not known; allowed: [a-z_, ]*$": lambda: self.rig.top_drive(angel=1.0),
                           "^winch: block_velocity is 'up'; allowed is a number$": lambda: self.rig.winch("up")}.items():
            with self.assertRaisesRegex(TypeError, text):
                call()
        with self.assertRaises(TimedOut):
            self.rig.step_until(lambda s: False, timeout=0.1)

    def test_faults_connections_and_steering(self):
        self.rig.fault("SENSOR_BIAS", target="hook_load", magnitude=1e4)
        state = self.rig.step()
        self.assertAlmostEqual(1e4, state.hook_load - state.truth.hook_load, delta=1.0)
        self.rig.clear_fault("SENSOR_BIAS", target="hook_load")
        state = self.rig.step()
        self.assertAlmostEqual(0.0, state.hook_load - state.truth.hook_load, delta=1.0)
        self.rig.slips(True)
        self.assertTrue(self.rig.step().in_slips)
        rss = Simulator(STEERABLE)
        rss.steer(1.0, 0.5)
        self.assertEqual((1.0, 0.5), (rss.step().truth.steering.toolface, rss.state.truth.steering.ratio))

    def test_slips_on_the_joint_that_a_connection_needs(self):
        two = {"joints": 2, "remove": True}
        for connection, said in ((None, "the slips hold another joint"), (two, "made")):
            rig = Simulator(STANDS)
            rig.winch(0.3)
            rig.step(seconds=30.0)
            rig.brake()
            rig.step(seconds=3.0)
            rig.slips(connection=connection)
            rig.winch(-0.01)
            rig.step(seconds=2.0)
            rig.brake()
            rig.step(seconds=2.0)
            try:
                rig.connection(**two)
                answer = "made"
            except Refused as refusal:
                answer = str(refusal)
            self.assertIn(said, answer)
        with self.assertRaisesRegex(Refused, "joints is 50; allowed is 0"):
            Simulator(STANDS).slips(connection={"joints": 50, "remove": True})

    def test_faults_are_listed_and_fields_that_do_not_apply_refused(self):
        self.assertEqual([], self.rig.active_faults)
        self.rig.fault("SENSOR_BIAS", target="flow", magnitude=1e-3)
        self.rig.fault("PUMP_TRIP")
        self.assertEqual(["sensor_bias of flow", "pump_trip"], self.rig.active_faults)
        self.assertEqual(["sensor_bias of flow", "pump_trip"], self.rig.step().truth.active_faults)
        self.rig.clear_fault("PUMP_TRIP", depth=3.0)
        for fields, field in (({"depth": 3.0}, "depth"), ({"magnitude": 3.0}, "magnitude"), ({"target": "flow"}, "target")):
            with self.assertRaisesRegex(Refused, field + " has no effect on drive_trip"):
                self.rig.fault("DRIVE_TRIP", **fields)
        self.assertEqual(["sensor_bias of flow"], self.rig.active_faults)

    def test_all_telemetry_comes_up(self):
        with tempfile.TemporaryDirectory() as folder:
            scene = os.path.join(folder, "scene.yaml")
            with open(os.path.join(PACKAGE_DIR, "config/scenes/bohai.yaml")) as source, open(scene, "w") as target:
                text = source.read().replace("../surveys", os.path.join(PACKAGE_DIR, "config/surveys"))
                self.assertIn("  mwd: {", text)
                target.write(text.replace("  mwd: {", "  dynamics: {period: 5.0, latency: 1.0}\n  mwd: {inclination_period: 6.0, "))
            rig = Simulator(scene)
        self.assertEqual((None, None), (rig.inclination, rig.dynamics))
        rig.pump(0.03)
        rig.step(30.0)
        self.assertAlmostEqual(rig.survey.inclination, rig.inclination.inclination, delta=0.02)
        self.assertGreater(rig.inclination.t, 6.0)
        self.assertAlmostEqual(5.0, rig.dynamics.duration, delta=0.02)
        self.assertGreater(rig.dynamics.md, 0.0)

    def test_telemetry_is_the_same_until_another_comes(self):
        rig = Simulator(os.path.join(PACKAGE_DIR, "config/scenes/bohai.yaml"))
        self.assertIsNone(rig.toolface)
        rig.pump(0.03)
        rig.step(20.0)
        first = rig.toolface
        rig.step()
        self.assertIs(first, rig.toolface)
        rig.step(20.0)
        self.assertGreater(rig.toolface.t, first.t)

    def test_the_environment_for_learners_learns_what_its_rule_can(self):
        from weight_env import play
        rewards = play(self.scene)
        self.assertGreater(min(rewards[-50:]), -0.05)


if __name__ == "__main__":
    unittest.main()
