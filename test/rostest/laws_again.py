#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The controllers of launch/, each as its launch file has it, in the middle of their task: the rig is paused, then reset, then its node dies and is started
again. The law waits with the pause, begins again after the others, and never puts more on the bit than it did before or was asked to."""
import os
import re
import signal
import subprocess
import tempfile

from drill_rig_sim.msg import BitTruth, MudPumpCommand, RigState, TopDriveCommand, WinchCommand
from drill_rig_sim.srv import ResetWell, SetSpeed
from rig_test import PACKAGE_DIR, PATIENCE, Collector, process_of, rospy, run, time, unittest, wait_until
from rosgraph_msgs.msg import Log
from std_srvs.srv import Trigger

LAWS = ("autodriller", "slide_steering", "rss_steering", "stands", "stick_slip")
COMMANDS = {"winch": WinchCommand, "top_drive": TopDriveCommand, "mud_pump": MudPumpCommand}
SPEED = 8.0   # simulated seconds per wall second
TASK = 60.0   # simulated, so long the law works each time [s]
NODE = """
  <node ns="rig" pkg="drill_rig_sim" type="rig_simulator" name="rig_simulator" output="screen" respawn="true">
    <param name="scene" value="%s"/>
    <param name="settings" value="numerics.companion=none"/>
    <param name="command_timeout" value="5.0"/>
  </node>"""


def launch_file_of(law):
    """The package's own, but with a rig that is started again when it dies."""
    with open(os.path.join(PACKAGE_DIR, "launch", law + ".launch"), encoding="utf-8") as file:
        text = file.read()
    scene = re.search(r'<arg name="scene" value="([^"]*)"/>', text).group(1)
    text, count = re.subn(r"  <include .*?</include>", NODE % scene, text, flags=re.S)
    assert count == 1, law
    return text.replace("$(dirname)", os.path.join(PACKAGE_DIR, "launch"))


def weight_of(text):
    """What a launch file asks of its law [N]; 0: nothing."""
    found = re.search(r"\bweight: ([0-9.e+]+)", text)
    return float(found.group(1)) if found else 0.0


class Task:
    """A rig under a law."""

    def __init__(self, folder, law):
        name, text = os.path.join(folder, law + ".launch"), launch_file_of(law)
        with open(name, "w", encoding="utf-8") as file:
            file.write(text)
        self.weight = weight_of(text)
        if rospy.has_param("/rig"):
            rospy.delete_param("/rig")  # settings of the law before
        self.process = subprocess.Popen(["roslaunch", "--wait", name])
        self.speed_up()
        self.states, self.bits = Collector("/rig/rig_state", RigState), Collector("/rig/truth/bit", BitTruth)
        self.commands = [Collector("/rig/%s/command" % name, kind) for name, kind in COMMANDS.items()]
        self.remarks = Collector("/rosout", Log)

    @staticmethod
    def speed_up():
        rospy.wait_for_service("/rig/set_speed", PATIENCE)
        assert rospy.ServiceProxy("/rig/set_speed", SetSpeed)(SPEED).success

    def time(self):
        return self.states.messages[-1].header.stamp.to_sec() if self.states.messages else 0.0

    def commanded(self):
        return sum(len(each.messages) for each in self.commands)

    def work(self, until):
        """Until this time of the rig [s], with commands; the largest weight on bit meanwhile [N]."""
        commands, seen = self.commanded(), len(self.bits.messages)
        wait_until(lambda: self.time() > until and self.commanded() > commands, "the law at %g s" % until, 4 * PATIENCE)
        return max(bit.wob for bit in self.bits.messages[seen:])

    def has_begun_again(self, times):
        wait_until(lambda: sum("the law begins again" in message.msg for message in list(self.remarks.messages)) == times, "a remark of the controller")

    def end(self):
        self.process.send_signal(signal.SIGINT)
        self.process.wait(PATIENCE)


class LawsAgain(unittest.TestCase):
    def goes_on(self, task):
        heaviest = task.work(TASK)
        self.pause(task)
        heaviest = max(heaviest, task.work(task.time() + 5.0))

        self.assertTrue(rospy.ServiceProxy("/rig/reset_well", ResetWell)().success)
        epoch = task.states.wait_until(lambda m: m[-1].epoch > 0)[-1].epoch
        self.assertEqual(1, epoch)
        task.has_begun_again(1)
        after_reset = task.work(task.time() + TASK)

        old = process_of("/rig/rig_simulator")
        os.kill(old, signal.SIGKILL)
        wait_until(lambda: task.time() < TASK / 2, "the new node's states")
        self.assertNotEqual(old, process_of("/rig/rig_simulator"))
        task.speed_up()
        task.has_begun_again(2)
        after_restart = task.work(TASK)
        self.assertLess(max(after_reset, after_restart), 1.3 * max(heaviest, task.weight) + 2e3, "it must not run away")

    def pause(self, task):
        pause, resume = (rospy.ServiceProxy("/rig/" + name, Trigger) for name in ("pause", "resume"))
        self.assertTrue(pause().success)
        task.states.wait_until(lambda m: m[-1].run_state == RigState.PAUSED)
        for each in task.commands:
            each.quiet()
        time.sleep(1.0)
        self.assertEqual(0, task.commanded())
        self.assertTrue(resume().success)
        wait_until(task.commanded, "the law goes on")


def of(law):
    def test(self):
        with tempfile.TemporaryDirectory() as folder:
            task = Task(folder, law)
            self.addCleanup(task.end)
            self.goes_on(task)
    return test


for each_law in LAWS:
    setattr(LawsAgain, "test_" + each_law, of(each_law))


if __name__ == "__main__":
    run(LawsAgain)
