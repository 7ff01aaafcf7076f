#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Control laws and their parts without a rig: what they are made of against closed forms. With a rig: test/laws."""
import copy
import math
import os
import pickle
import tempfile
import threading
import types
import unittest
from unittest import mock

import rospy
from drill_rig_sim import topics
from drill_rig_sim.autodriller import HOOK_LOAD, Autodriller
from drill_rig_sim.control import Deaf, NewRuns, Ordered, Readings, asked, drive, pipe_work
from drill_rig_sim.law import Commands, Lag, Loop, Plan, turn_between
from drill_rig_sim.msg import BitTruth, MwdToolface, RigState, RigTruth
from drill_rig_sim.recorder import Recorder
from drill_rig_sim.rig import Refused
from drill_rig_sim.rss_steering import downlink
from drill_rig_sim.score_runs import read_run
from drill_rig_sim.slide_steering import SlideSteering
from drill_rig_sim.status import name_of, plan_of, status_of
from drill_rig_sim.stick_slip import StickSlip
from drill_rig_sim.survey import Survey

DT, STIFFNESS = 0.1, 6e5


def weight_after(time, drillability, set_point=60e3, limit=1.0):
    """Of a string on rock, dW/dt = K (feed - c W), under a Loop whose set point comes on by 2 kN/s; and the loop."""
    loop, weight = Loop(0.0, STIFFNESS), 0.0
    for i in range(round(time / DT)):
        loop.set_point = min(set_point, 5e3 + 2e3 * DT * i)
        wanted = loop.feed(weight)
        feed = min(max(wanted, 0.0), limit)
        loop.follow(feed, DT, weight if wanted <= limit else None)
        weight += DT * STIFFNESS * (feed - drillability * weight)
    return weight, loop


class StatusOfALaw(unittest.TestCase):
    """What controller/status says."""
    settings = {"set_points": {"weight": 6e4, "pressure": 1e12}, "stiffness": STIFFNESS, "rop": 0.01, "rpm": 60.0, "flow": 0.03, "to_depth": 900.0}

    def points(self, law):
        status = status_of(law, True)
        return dict(zip(status.set_point, status.value))

    def test_of_an_autodriller(self):
        law = Ordered(Autodriller(**self.settings), [])
        status = status_of(law, True)
        self.assertEqual(("autodriller", True, "spinning up", "", ""), (status.law, status.running, status.phase, status.leads, status.given_up))
        points = self.points(law)
        self.assertAlmostEqual(2.0 * math.pi, points.pop("rotary_speed"))
        self.assertEqual({"weight": 6e4, "rop": 0.01, "flow": 0.03, "to_depth": 900.0}, points)  # no limit of pressure
        law.inner.winner, law.inner.set_points["weight"] = "rop", 5e4
        self.assertEqual(("rop", 5e4), (status_of(law, True).leads, self.points(law)["weight"]))
        self.assertEqual([], plan_of(law))

    def test_of_a_law_that_steers(self):
        survey = Survey([0.0, 100.0, 195.0], [0.0, 0.0, 0.5], [0.0, 0.0, 0.0])
        law = SlideSteering(survey, 5.5, 4e-5, self.settings)
        law.driller.winner, law.given_up = "weight", "the plan cannot be reached"
        status = status_of(law, False)
        self.assertEqual(("slide_steering", False, "weight", law.given_up), (status.law, status.running, status.leads, status.given_up))
        plan = plan_of(law)
        self.assertEqual(21, len(plan))  # 195 m
        self.assertEqual((0.0, 0.0, 0.0), (plan[0].x, plan[0].y, plan[0].z))
        for n, value in enumerate(survey.positions[-1]):
            self.assertAlmostEqual(value, (plan[-1].x, plan[-1].y, plan[-1].z)[n])

    def test_of_others(self):
        self.assertEqual("stick_slip", name_of(StickSlip(60.0, 0.03, ["rpm"], torsion_period=5.0, stiffness=STIFFNESS)))
        status = status_of(types.SimpleNamespace(), True)
        self.assertEqual(("", [], []), (status.phase, status.set_point, status.value))


class Parts(unittest.TestCase):
    def test_readings_can_be_copied(self):
        readings = Readings(1.5, RigState(hook_load=1e5), Deaf())
        for again in (copy.deepcopy(readings), pickle.loads(pickle.dumps(readings))):
            self.assertEqual((1.5, 1e5), (again.t, again.hook_load))
        with self.assertRaisesRegex(AttributeError, "on_bottom: is not a reading"):
            again.on_bottom  # pylint: disable=pointless-statement

    def test_a_step_that_gives_no_commands_is_told(self):
        for given, said in ((None, "nothing"), (0.1, "float")):
            law = types.SimpleNamespace(step=lambda _, given=given: given)
            self.assertRaisesRegex(TypeError, r"SimpleNamespace.step\(\) gave %s; needed: a drill_rig_sim.law.Commands" % said, asked, law, None)

    def test_lag(self):
        lag = Lag(2.0)
        self.assertEqual(5.0, lag.follow(5.0, DT))
        for _ in range(2000):
            value = lag.follow(7.0, DT / 100)
        self.assertAlmostEqual(7.0 - 2.0 * math.exp(-1.0), value, delta=1e-3)

    def test_loop_has_no_lasting_error_on_any_rock(self):
        for drillability in (1e-8, 9e-8, 4e-7, 2e-6):
            self.assertAlmostEqual(60e3, weight_after(1000.0, drillability)[0], delta=60.0)

    def test_loop_does_not_wind_up(self):
        """Held back by a limit for long, it asks for the set point's feed and no more once the weight is there."""
        weight, loop = weight_after(500.0, 9e-8, limit=0.8 * 9e-8 * 60e3)
        self.assertAlmostEqual(0.8 * 60e3, weight, delta=60.0)
        self.assertAlmostEqual(0.8 * 9e-8 * 60e3, loop.integral, delta=1e-6)

    def test_loop_takes_over_without_a_bump(self):
        loop = Loop(60e3, STIFFNESS)
        for _ in range(2000):
            loop.follow(4e-3, DT)
        self.assertAlmostEqual(4e-3, loop.feed(60e3), delta=1e-9)

    def test_plan(self):
        plan = Plan(Survey([0.0, 100.0, 400.0], [0.0, 0.0, math.radians(30.0)], [1.0, 1.0, 1.0]))
        self.assertAlmostEqual(math.radians(15.0), plan.at(250.0)[0], delta=1e-9)
        self.assertAlmostEqual(1.0, plan.at(250.0)[1], delta=1e-9)
        self.assertAlmostEqual(math.radians(30.0), plan.at(500.0)[0], delta=1e-9)

    def test_turn_between(self):
        self.assertAlmostEqual(math.radians(20.0), turn_between(math.radians(350.0), math.radians(10.0)))
        self.assertAlmostEqual(math.radians(-20.0), turn_between(math.radians(10.0), math.radians(350.0)))

    def test_downlink(self):
        self.assertEqual([1, 0, 1, 1, 0, 1, 0, 0, 0, 1, 0], downlink(6, 8))   # 135 deg, 0.8
        self.assertEqual([1, 1, 1, 1, 1, 0, 0, 0, 1, 1, 0], downlink(-1, 1))  # 337.5 deg, 0.1
        for direction in range(16):
            for tenths in range(11):
                self.assertEqual(0, sum(downlink(direction, tenths)[1:10]) % 2)


class Laws(unittest.TestCase):
    def test_orders_come_in_time(self):
        law = types.SimpleNamespace(set_points={"weight": 1.0}, step=lambda readings: law.set_points["weight"])
        ordered = Ordered(law, [[2.0, "weight", 3.0], [1.0, "weight", 2.0]])
        self.assertEqual([1.0, 1.0, 2.0, 3.0], [ordered.step(types.SimpleNamespace(t=10.0 + t)) for t in (0.0, 0.9, 1.0, 2.5)])

    def test_a_refusal_is_told(self):
        def refuse(_):
            raise Refused("the block moves")
        self.assertEqual("the block moves", pipe_work(Commands(slips=True), refuse, None))
        self.assertEqual("", pipe_work(Commands(), refuse, None))

    def test_a_blind_driller_does_not_feed_for_long(self):
        law = Autodriller({"weight": 60e3}, STIFFNESS, rop=0.01, rpm=60.0, flow=0.03, to_depth=2000.0)
        law.phase, law.zero = "drilling", {"weight": -500e3, "pressure": 0.0, "torque": 0.0}
        speeds = []
        for i in range(320):
            lost = HOOK_LOAD if i >= 200 else 0
            speeds.append(law.step(types.SimpleNamespace(t=0.1 * i, hook_load=480e3, stand_pipe_pressure=1e6, torque=1e3, lost_gauges=lost, bit_depth=1000.0,
                                                         block_height=20.0)))
        self.assertLess(speeds[199].block_velocity, -0.001)
        self.assertAlmostEqual(speeds[230].block_velocity, speeds[290].block_velocity, delta=1e-9)  # as before
        self.assertFalse(speeds[290].brake)
        self.assertTrue(speeds[319].brake)

    def test_slides_begin_behind_the_plan_and_aim_at_it(self):
        plan = Survey([0.0, 400.0, 500.0], [math.radians(30.0)] * 3, [1.0] * 3)
        law = SlideSteering(plan, 6.0, 0.0, {"set_points": {"weight": 1.0}, "stiffness": 1.0, "rop": 1.0, "rpm": 1.0, "flow": 1.0, "to_depth": 500.0})
        law.driller.phase = "drilling"
        survey = types.SimpleNamespace(md=400.0, inclination=math.radians(29.0), azimuth=1.0 - math.radians(2.0))  # half as much across: sin 30 deg
        law.choose(types.SimpleNamespace(survey=survey, bit_depth=400.0))
        self.assertTrue(law.sliding)
        self.assertAlmostEqual(math.radians(45.0), law.target, delta=1e-6)
        self.assertEqual("lifting", law.driller.phase)

    def test_a_slide_without_toolfaces_is_given_up_with_the_block_braked(self):
        plan = Survey([0.0, 100.0, 400.0], [0.0, 0.0, math.radians(30.0)], [1.0, 1.0, 1.0])
        law = SlideSteering(plan, 6.0, 0.0, {"set_points": {"weight": 1e4}, "stiffness": 6e5, "rop": 0.01, "rpm": 60.0, "flow": 0.03, "to_depth": 500.0})
        law.driller.go("lifting")
        law.sliding, law.stopped_at, law.driller.stay_off = True, 0.0, True
        rig = {"hook_load": 2e5, "stand_pipe_pressure": 1e7, "torque": 0.0, "lost_gauges": 0, "block_height": 10.0, "bit_depth": 390.0, "hole_depth": 400.0,
               "survey": None, "toolface": None, "top_drive_angle": 0.0, "surface_wob": 0.0, "differential_pressure": 0.0, "rop": 0.0}
        for i in range(10 * 301):
            commands = law.step(types.SimpleNamespace(t=DT * i, **rig))
            if law.done:
                break
        self.assertAlmostEqual(300.0, DT * i, delta=0.2)
        self.assertIn("no toolface for 300 s", law.given_up)
        self.assertEqual((True, None), (commands.brake, commands.block_velocity))

    def test_swings_by_the_torque(self):
        for amplitude, tried in ((0.05, []), (0.4, [[30.0, "SOFT_TORQUE"]])):
            law = StickSlip(90.0, 0.03, ["SOFT_TORQUE"], 5.0, 1e6)
            for i in range(310):
                torque = 5e3 * (1.0 + amplitude * math.sin(2.0 * math.pi * 0.1 * i / 5.0))
                law.step(types.SimpleNamespace(t=0.1 * i, torque=torque))
            self.assertAlmostEqual(amplitude, law.swing, delta=0.02)
            self.assertEqual([what for _, what in tried], [what for _, what in law.tried])


class Counter:
    """Counts its steps; its own list and that of a part are one."""
    period = 0.1

    def __init__(self):
        self.steps, self.done, self.seen = 0, False, []
        self.part = types.SimpleNamespace(seen=self.seen)

    def step(self, readings):
        self.steps += 1
        self.part.seen.append((readings.t, readings.refused, readings.toolface))
        return Commands(block_velocity=-0.01 * self.steps, slips=True)


class StateAt:
    """A state of a rig in lockstep."""

    def __init__(self, t, epoch=0):
        self.t, self.readings = t, types.SimpleNamespace(epoch=epoch)


class Runs(unittest.TestCase):
    def test_time_that_goes_back_or_another_epoch_begins_a_run(self):
        for states, begins in (((0.0, 0), (1.0, 0), (1.0, 0)), ""), (((5.0, 0), (0.1, 0), (0.2, 0)), "1"), (((5.0, 0), (5.1, 1), (5.2, 1)), "1"), \
                (((5.0, 7), (0.1, 0), (0.2, 1)), "12"), (((5.0, 0), (3.0, 0), (1.0, 0)), "12"):
            law = Counter()
            runs = NewRuns(law)
            law.steps, law.seen[:] = 7, [1, 2]
            for i, (now, epoch) in enumerate(states):
                law.steps = 7
                self.assertEqual(str(i) in begins, runs.begins(now, epoch), (states, i))
                self.assertEqual(0 if str(i) in begins else 7, law.steps)
            self.assertIs(law.seen, law.part.seen)
            self.assertEqual([] if begins else [1, 2], law.seen)

    def test_an_ordered_law_begins_again_with_its_orders(self):
        inner = Counter()
        inner.set_points = {"weight": 1.0}
        law = Ordered(inner, [[0.0, "weight", 5.0]])
        runs = NewRuns(law)
        law.step(types.SimpleNamespace(t=3.0, refused="", toolface=None))
        self.assertEqual((5.0, 1), (law.set_points["weight"], law.steps))
        runs.begins(3.0, 0)
        self.assertTrue(runs.begins(0.0, 0))
        self.assertEqual((1.0, 0), (law.set_points["weight"], law.steps))
        law.step(types.SimpleNamespace(t=0.0, refused="", toolface=None))
        self.assertEqual(5.0, law.set_points["weight"])

    def test_a_law_that_cannot_be_copied_goes_on(self):
        law = Counter()
        law.lock = threading.Lock()
        runs = NewRuns(law)
        law.steps = 7
        runs.begins(3.0, 0)
        self.assertTrue(runs.begins(0.0, 0))
        self.assertEqual(7, law.steps)
        self.assertIn("cannot pickle", runs.problem)

    def test_in_lockstep_a_law_begins_again_with_the_rig(self):
        class Rig:
            rate, state, asked = 100.0, StateAt(0.0), []

            def step(self, frames):
                self.state = StateAt(0.0 if len(self.asked) == 5 else self.state.t + frames / self.rate)
                return self.state

            def winch(self, velocity):
                self.asked.append(velocity)

            @staticmethod
            def slips(are_set):
                raise Refused("no slips")
            connection = slips

        law, rig = Counter(), Rig()
        drive(rig, law, 0.8)
        self.assertEqual([-0.01, -0.02, -0.03, -0.04, -0.05, -0.01, -0.02, -0.03], [round(velocity, 9) for velocity in rig.asked])
        self.assertEqual(["", "no slips", "no slips"], [refused for _, refused, _ in law.seen])


class ByTopics(unittest.TestCase):
    """A law that follows a node, against stand-ins of what rospy gives."""

    def setUp(self):
        self.published, self.subscribers = [], {}
        outer = self

        class Publisher:
            def __init__(self, topic, *_, **__):
                self.topic = topic

            def publish(self, message):
                outer.published.append((self.topic, message))

        def subscriber(topic, kind, callback, *_, **__):
            outer.subscribers[topic] = callback
            return mock.Mock()

        def gone(*_, **__):
            raise rospy.ServiceException("service [/rig/set_slips] unavailable")

        for name, stand_in in (("Publisher", Publisher), ("Subscriber", subscriber), ("ServiceProxy", lambda *_: gone), ("logwarn", self.warned)):
            patch = mock.patch.object(rospy, name, stand_in)
            patch.start()
            self.addCleanup(patch.stop)
        self.warnings = []

    def warned(self, text):
        self.warnings.append(text)

    @staticmethod
    def state(t, epoch=0, kind=RigState):
        state = kind(hole_depth=100.0, epoch=epoch)
        state.header.stamp = rospy.Time.from_sec(t)
        return state

    def toolface(self, t):
        message = MwdToolface(toolface=1.0)
        message.header.stamp = rospy.Time.from_sec(t)
        self.subscribers["downhole/toolface"](message)

    def velocities(self):
        return [round(message.block_velocity, 9) for topic, message in self.published if topic == "winch/command"]

    def test_a_node_that_is_started_again_begins_a_new_run(self):
        law = Counter()
        follower = topics.Follower(law)
        self.toolface(499.0)
        for t in (500.0, 500.05, 500.1, 500.2):
            follower.take(self.state(t))
        self.assertEqual([-0.01, -0.02, -0.03], self.velocities())
        self.assertEqual("service [/rig/set_slips] unavailable", law.seen[-1][1])
        self.assertEqual(499.0, law.seen[-1][2].t)
        del self.published[:]
        for t in (0.01, 0.05, 0.11, 0.21):
            follower.take(self.state(t))
        self.assertEqual([-0.01, -0.02, -0.03], self.velocities())
        self.assertEqual((0.01, "", None), law.seen[0])
        self.assertEqual(["the rig begins a new run at 0.01 s: the law begins again"], self.warnings)
        self.toolface(0.2)
        follower.take(self.state(0.31))
        self.assertEqual(0.2, law.seen[-1][2].t)

    def test_a_well_that_is_reset_begins_a_new_run(self):
        law = Counter()
        follower = topics.Follower(law)
        for t, epoch in ((5.0, 0), (5.1, 0), (5.11, 1), (5.12, 1), (5.21, 1)):
            follower.take(self.state(t, epoch))
        self.assertEqual([-0.01, -0.02, -0.01, -0.02], self.velocities())

    def test_the_recorder_goes_on_with_the_new_run(self):
        with tempfile.TemporaryDirectory() as folder:
            recorder = Recorder(os.path.join(folder, "run.csv"), period=0.1)

            def bit(t):
                message = BitTruth(wob=t)
                message.header.stamp = rospy.Time.from_sec(t)
                recorder.take(message, "bit")

            for t in (9.9, 9.95, 10.0, 0.0, 0.05, 0.1, 0.2):
                recorder.take(self.state(t, kind=RigTruth), "state")
                if t != 10.0:  # lost with the node
                    bit(t)
            recorder.close()
            self.assertEqual({}, recorder.waiting)
            with open(os.path.join(folder, "run.csv"), encoding="utf-8") as text:
                self.assertEqual(["time", "9.9", "0", "0.1", "0.2"], [line.split(",")[0] for line in text])
            run = read_run(os.path.join(folder, "run.csv"))
            self.assertEqual([0.0, 0.1, 0.2], list(run["time"]))
            self.assertIn("time goes back to 0 s", run.earlier)


if __name__ == "__main__":
    unittest.main()
