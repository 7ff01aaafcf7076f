#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The rig is paused in the middle of a law's run, and the law waits with it. Its node dies and is started again, its time from 0 on: controller, recorder
and WITS go on with the new run."""
import os
import signal
import socket
import tempfile

from drill_rig_sim.msg import RigState, TopDriveCommand
from drill_rig_sim.recorder import Recorder
from drill_rig_sim.score_runs import read_run
from rig_test import PATIENCE, Collector, process_of, rospy, run, time, unittest, wait_until
from rosgraph_msgs.msg import Log
from std_srvs.srv import Trigger

BEFORE = 5.0  # simulated, until the node is killed [s]


class Wits:
    """Times of day of the records 01 that have come, as text."""

    def __init__(self):
        port = wait_until(lambda: rospy.get_param("/rig/wits0_server/port", 0), "the server's port")
        self.connection, self.text = socket.create_connection(("127.0.0.1", port), PATIENCE), ""
        self.connection.settimeout(0.2)

    def times(self):
        try:
            self.text += self.connection.recv(1 << 16).decode()
        except socket.timeout:
            pass
        return [line[4:] for line in self.text.split("\r\n") if line.startswith("0106")]


class Restart(unittest.TestCase):
    def test_a_pause_holds_the_law(self):
        states, commands = Collector("/rig/rig_state", RigState), Collector("/rig/top_drive/command", TopDriveCommand)
        wait_until(lambda: states.messages and states.messages[-1].top_drive_speed > 6.0, "the law turns the string")
        pause, resume = (rospy.ServiceProxy("/rig/" + name, Trigger) for name in ("pause", "resume"))
        self.assertTrue(pause().success)
        states.wait_until(lambda m: m[-1].run_state == RigState.PAUSED)
        commands.quiet()
        before = states.messages[-1]
        time.sleep(1.5)
        self.assertEqual([], commands.messages)
        self.assertTrue(resume().success)
        after = states.after(before.header.stamp)[0]
        self.assertLess((after.header.stamp - before.header.stamp).to_sec(), 0.1)
        self.assertAlmostEqual(before.top_drive_speed, after.top_drive_speed, delta=0.1)
        self.assertTrue(commands.wait(1), "the law goes on")

    def test_all_go_on_with_the_new_run(self):
        states, remarks = Collector("/rig/rig_state", RigState), Collector("/rosout", Log)
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        recorder, wits = Recorder(os.path.join(folder.name, "run.csv"), "/rig/"), Wits()
        self.addCleanup(wits.connection.close)

        def turned():
            last = states.messages[-1]
            return last.header.stamp.to_sec() > BEFORE and last.top_drive_speed > 6.0

        wait_until(lambda: states.messages and turned(), "the law turns the string")
        wait_until(lambda: len(wits.times()) > 3, "records")
        old = process_of("/rig/rig_simulator")
        os.kill(old, signal.SIGKILL)
        wait_until(lambda: states.messages[-1].header.stamp.to_sec() < BEFORE, "the new node's states")
        wait_until(turned, "the law turns the string again")
        self.assertNotEqual(old, process_of("/rig/rig_simulator"))
        wait_until(lambda: any("the law begins again" in m.msg for m in list(remarks.messages)), "a remark of the controller")
        times = wits.times()
        self.assertTrue(any(after < before for before, after in zip(times, times[1:])), times)
        self.assertGreater(len(times) - times.index(min(times[3:])), 3)
        recorder.close()
        recorded = read_run(os.path.join(folder.name, "run.csv"))
        self.assertIn("1 earlier run of the file", recorded.earlier)
        self.assertLess(recorded["time"][0], BEFORE)
        self.assertGreater(recorded["time"][-1], BEFORE - 1.0)
        time.sleep(0.1)  # what still comes to the recorder that is closed must not be an error


if __name__ == "__main__":
    run(Restart)
