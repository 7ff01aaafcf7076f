#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The watchdog as the launch files set it: a controller that dies stops the block, a single command stands; and two senders on one topic are reported."""
import os
import subprocess
import sys

from diagnostic_msgs.msg import DiagnosticArray
from drill_rig_sim.msg import RigState, TopDriveCommand, WinchCommand
from rig_test import PATIENCE, Rig, run, rospy, time, turn, unittest, wait_until, winch

TIMEOUT = 5.0  # of rig.launch [simulated s]
SPEED = 8.0    # simulated seconds per wall second
SENDER = """import sys, rospy
from drill_rig_sim.msg import WinchCommand
rospy.init_node(sys.argv[1])
publisher = rospy.Publisher("/rig/winch/command", WinchCommand, queue_size=1)
while not rospy.is_shutdown():
    publisher.publish(block_velocity=-0.001)
    rospy.rostime.wallsleep(0.05)
"""


class Watchdog(unittest.TestCase):
    def setUp(self):
        self.rig = Rig()
        self.rig.must(self.rig.reset_well("", 0.0))
        self.rig.must(self.rig.set_speed(SPEED))
        self.states = self.rig.collect("rig_state", RigState)
        self.addCleanup(self.states.subscriber.unregister)
        self.winch = self.rig.publisher("winch/command", WinchCommand)
        self.drive = self.rig.publisher("top_drive/command", TopDriveCommand)

    def sender(self, name):
        """A node that lowers the block by a stream of commands."""
        process = subprocess.Popen([sys.executable, "-c", SENDER, name], env=os.environ)
        self.addCleanup(process.wait)
        self.addCleanup(process.kill)
        return process

    def state(self, condition, what):
        """The first one from now on with the condition."""
        self.states.clear()
        wait_until(lambda: any(map(condition, list(self.states.messages))), what)
        return next(filter(condition, list(self.states.messages)))

    def after(self, seconds):
        """The state this number of simulated seconds later."""
        now = self.state(lambda s: True, "a state").header.stamp
        return self.state(lambda s: s.header.stamp >= now + rospy.Duration.from_sec(seconds), "%g simulated s" % seconds)

    def test_a_stream_that_dies_stops_the_block(self):
        sender = self.sender("controller")
        self.state(lambda s: not s.brake_set and s.winch.block_velocity == -0.001, "the block goes down")
        self.assertFalse(self.after(2.0 * TIMEOUT).commands_timed_out)
        sender.kill()
        state = self.state(lambda s: s.commands_timed_out, "the silence is noticed")
        self.assertTrue(state.brake_set)
        stands = self.after(2.0).block_height
        self.assertAlmostEqual(stands, self.after(4.0).block_height, delta=5e-4)
        self.winch.publish(winch(-0.002))
        state = self.state(lambda s: s.winch.block_velocity == -0.002, "the next command is obeyed")
        self.assertFalse(state.commands_timed_out or state.brake_set)

    def test_single_commands_stand(self):
        self.winch.publish(winch(-0.001))
        self.drive.publish(turn(3.0))
        self.state(lambda s: s.winch.block_velocity == -0.001 and s.top_drive.speed == 3.0, "both are obeyed")
        begin = self.state(lambda s: True, "a state")
        end = self.after(3.0 * TIMEOUT)
        self.assertFalse(end.commands_timed_out or end.brake_set)
        self.assertAlmostEqual(3.0, end.top_drive_speed, delta=0.5)
        self.assertLess(end.block_height, begin.block_height - 0.01)
        self.drive.publish(turn(4.0))
        self.winch.publish(winch(-0.0005))
        self.state(lambda s: s.winch.block_velocity == -0.0005 and s.top_drive.speed == 4.0, "both are obeyed again")
        self.assertFalse(self.after(3.0 * TIMEOUT).commands_timed_out)

    def test_a_button_that_is_let_go_is_no_lost_controller(self):
        self.drive.publish(turn(3.0))
        for _ in range(20):
            self.winch.publish(winch(-0.01))
            time.sleep(0.1)
        self.winch.publish(winch(0.0))
        self.state(lambda s: s.winch.block_velocity == 0.0, "it stands")
        state = self.after(3.0 * TIMEOUT)
        self.assertFalse(state.commands_timed_out or state.brake_set)
        self.assertAlmostEqual(3.0, state.top_drive_speed, delta=0.5)

    def test_two_senders_are_reported(self):
        diagnostics = self.rig.collect("/diagnostics", DiagnosticArray)
        self.addCleanup(diagnostics.subscriber.unregister)

        def warned():
            return [s.message for m in list(diagnostics.messages) for s in m.status if s.name.endswith("commands") and s.level in (1, bytes([1])) and "nodes publish" in s.message]
        self.sender("one")
        self.state(lambda s: s.winch.block_velocity == -0.001, "the first one is obeyed")
        time.sleep(6.0)  # what other tests have sent is forgotten
        diagnostics.clear()
        diagnostics.wait(3)
        self.assertEqual([], warned())
        self.sender("two")
        wait_until(warned, "a warning", PATIENCE)
        self.assertEqual("2 nodes publish /rig/winch/command: /one, /two", warned()[0])


if __name__ == "__main__":
    run(Watchdog)
