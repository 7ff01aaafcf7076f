#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""A controller that knows topics only, in lockstep: the rig goes on to its next rig_state when the last one is answered, however long that takes."""
import random

from drill_rig_sim.msg import RigState, TopDriveCommand, WinchCommand
from rig_test import Rig, numbers, rospy, run, time, turn, unittest, wait_until, winch

STATES, PERIOD = 50, 100000000  # of a run; [ns]


class Controller:
    """Answers each new state after a random wall time."""

    def __init__(self, slowness):
        self.states, self.slowness = [], slowness
        self.winch = rospy.Publisher("/rig/winch/command", WinchCommand, queue_size=10)
        self.drive = rospy.Publisher("/rig/top_drive/command", TopDriveCommand, queue_size=10)
        self.subscriber = rospy.Subscriber("/rig/rig_state", RigState, self.take, queue_size=100, tcp_nodelay=True)

    def take(self, state):
        if len(self.states) < STATES:
            if not self.states or state.header.stamp > self.states[-1].header.stamp:
                self.states.append(state)
            time.sleep(random.uniform(0.0, self.slowness))
            self.answer(-0.1 if state.bit_depth < 99.9 else -0.005)

    def answer(self, velocity, stamp=None):
        down = winch(velocity)
        down.header.stamp = self.states[-1].header.stamp if stamp is None else stamp
        self.winch.publish(down)
        self.drive.publish(turn(6.0))

    def close(self):
        self.subscriber.unregister()


class StepOnCommands(unittest.TestCase):
    def setUp(self):
        self.rig = Rig()

    def played(self, slowness):
        self.assertTrue(self.rig.reset_well("", 0.0).success)
        controller = Controller(slowness)
        wait_until(controller.winch.get_num_connections, "the node hears the controller")
        wait_until(lambda: len(controller.states) == STATES, "%d states answered" % STATES)
        return controller

    def test_each_state_is_answered_and_runs_repeat(self):
        runs = []
        for slowness in (0.0, 0.05):
            controller = self.played(slowness)
            stamps = [state.header.stamp.to_nsec() for state in controller.states]
            self.assertEqual([stamps[0] + PERIOD * k for k in range(STATES)], stamps)
            runs.append([numbers(state) for state in controller.states])
            controller.close()
            time.sleep(1.0)
        self.assertEqual(*runs)
        self.assertNotEqual(runs[0][0], runs[0][-1])

    def test_an_answer_to_an_earlier_state_is_none(self):
        controller = self.played(0.0)
        self.addCleanup(controller.close)
        heard = self.rig.collect("rig_state", RigState)
        time.sleep(1.0)
        last = heard.wait_until(lambda m: m)[-1].header.stamp
        controller.answer(-0.005, stamp=controller.states[-2].header.stamp)
        time.sleep(1.0)
        self.assertEqual(last, heard.wait_until(lambda m: m)[-1].header.stamp)
        controller.answer(-0.005, stamp=rospy.Time())
        heard.wait_until(lambda m: m[-1].header.stamp.to_nsec() == last.to_nsec() + PERIOD)

    def test_the_service_is_refused(self):
        answer = self.rig.step(frames=1)
        self.assertFalse(answer.success)
        self.assertIn("this node steps on commands (~step_on_commands)", answer.message)


if __name__ == "__main__":
    run(StepOnCommands)
