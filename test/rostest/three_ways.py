#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""One controller, the same rig three ways: commands on topics, commands with the service `step`, and a simulator in this process. Readings, truth and
bit are the same to the last bit."""
import time

from drill_rig_sim.autodriller import Autodriller
from drill_rig_sim.control import Deaf, Readings, drive
from drill_rig_sim.msg import BitTruth, RigState, RigTruth
from drill_rig_sim.rig import COMMANDS, Rig
from drill_rig_sim.sim import Simulator
from drill_rig_sim.topics import Telemetry, messages_of
from rig_test import PATIENCE, Rig as Client, publishers_know, run, unittest, wait_until

SCENE = "autodriller.yaml"  # hook load noisy and late
SECONDS = 70.0              # it spins up, zeroes its weight, tags and drills
PERIOD = 10                 # frames
OTHERWISE = ("header", "run_state", "last_command", "epoch", "commands_refused", "last_refusal")  # stamps and node, and what happened to it before


def law():
    driller = Autodriller({"weight": 60e3}, stiffness=6e5, rop=0.012, rpm=60.0, flow=0.03, to_depth=1003.0)
    driller.spin_up_time, driller.tag_speed = 10.0, 0.01
    return driller


def plain(message, like):
    """All that a message says, or a signal in this process by the fields of a message: [(field, value)]."""
    values = []
    for name, kind in zip(like.__slots__, like._slot_types):
        if name in OTHERWISE:
            continue
        value = getattr(message, name)
        values += [(name + "." + inner, v) for inner, v in plain(value, getattr(like, name))] if "/" in kind else [(name, value)]
    return values


def everything(states):
    return [plain(s.readings, RigState()) + plain(s.truth, RigTruth()) + plain(s.bit, BitTruth()) for s in states]


class ByTopics:
    """Publishes what a law asks for, and steps by a service that carries no command. Where a command comes too late for its frame all is done anew, from
    the state before; in its place may have come one that was published twice."""

    def __init__(self, client, rig):
        self.client, self.rig = client, rig
        self.publishers = {name: client.publisher(name + "/command", kind) for name, kind in COMMANDS.items()}

    def drive(self, driller, periods):
        states = []
        for k in range(periods):  # by the count: the node's clock runs on through what is done anew
            commands = driller.step(Readings(k * PERIOD / self.rig.rate, self.rig.state.readings, Deaf))
            states.append(self.stepped(messages_of(commands)))
        return states

    @staticmethod
    def was_taken(in_force, message, began):
        return in_force.header.stamp == began and plain(in_force, message) == plain(message, message)

    def stepped(self, messages):
        self.rig.save("before")
        patience = 0.004
        while patience < PATIENCE:
            began = self.rig.state.readings.header.stamp
            for kind, message in messages.items():
                self.publishers[kind].publish(message)
            time.sleep(patience)
            state = self.rig.step(frames=PERIOD)
            if all(self.was_taken(getattr(state.readings, kind), message, began) for kind, message in messages.items()):
                return state
            self.rig.restore("before")
            patience *= 2.0
        raise AssertionError("no command arrived")


class ThreeWays(unittest.TestCase):
    def assert_same(self, expected, states, how):
        for k, (a, b) in enumerate(zip(expected, everything(states))):
            self.assertEqual([pair for pair in a if pair not in b], [pair for pair in b if pair not in a], "%s, period %d" % (how, k))
        self.assertEqual(len(expected), len(states))

    def test_the_same_controller_reads_the_same(self):
        periods = round(SECONDS * 100 / PERIOD)
        rig, stepped = Rig("rig"), law()
        rig.reset(scene=SCENE)
        expected = everything(drive(rig, stepped, SECONDS))
        self.assertEqual(periods, len(expected))
        self.assertEqual("drilling", stepped.phase)
        self.assertGreater(rig.state.bit.wob, 2e4)

        self.assert_same(expected, drive(Simulator(SCENE), law(), SECONDS), "in this process")

        rig.reset()
        self.assert_same(expected, ByTopics(Client("rig"), rig).drive(law(), periods), "by topics")

    def test_telemetry_comes_up_at_the_same_frames(self):
        rig, inside = Rig("rig"), Simulator("bohai.yaml")
        rig.reset(scene="bohai.yaml")
        telemetry, begin = Telemetry("/rig/"), rig.state.t
        wait_until(lambda: publishers_know("/rig/downhole/toolface") and publishers_know("/rig/downhole/mwd"), "connections")
        for each in (rig, inside):
            each.pump(0.03)
            each.step(40.0)
        wait_until(lambda: telemetry.toolface is not None and telemetry.survey is not None, "telemetry")
        wait_until(lambda: abs(telemetry.toolface.t - begin - inside.toolface.t) < 1e-6, "the last toolface")
        wait_until(lambda: abs(telemetry.survey.t - begin - inside.survey.t) < 1e-6, "the last survey")
        self.assertEqual((telemetry.toolface.toolface, telemetry.toolface.reference), (inside.toolface.toolface, inside.toolface.reference))
        for survey in (telemetry.survey, rig.survey):
            self.assertEqual((survey.md, survey.inclination, survey.azimuth), (inside.survey.md, inside.survey.inclination, inside.survey.azimuth))
        self.assertEqual((rig.toolface.toolface, rig.toolface.t), (telemetry.toolface.toolface, telemetry.toolface.t))


if __name__ == "__main__":
    run(ThreeWays)
