#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The node as a process: one line at the start, the end by a signal whatever it is doing, and what it says of other nodes' clocks."""
import os
import re
import signal
import subprocess
import tempfile
import threading

import roslib.packages
import rosgraph
from diagnostic_msgs.msg import DiagnosticArray
from drill_rig_sim import rig as lockstep
from drill_rig_sim.msg import MwdSurvey, MwdToolface, RigLimits
from drill_rig_sim.srv import StepSimulationRequest
from rig_test import PATIENCE, Collector, Rig, flow, numbers, rospy, run, time, turn, unittest, wait_until, winch

LONGEST_END = 10.0  # wall seconds from the signal to the end


class Node:
    """A rig_simulator in a namespace of its own, and what it says."""

    def __init__(self, namespace, *settings, **options):
        program = roslib.packages.find_node("drill_rig_sim", "rig_simulator")[0]
        self.name = "/" + namespace + "/rig_simulator"
        self.output = tempfile.TemporaryFile("w+")
        command = ["stdbuf", "-oL", program, "__ns:=" + namespace] + ["_" + s for s in ("scene:=quick.yaml", "settings:=numerics.companion=none") + settings]
        # stdbuf loads a library of its own ahead of all others, which an instrumented program refuses unless told
        environment = dict(os.environ, ASAN_OPTIONS=os.environ.get("ASAN_OPTIONS", "") + ":verify_asan_link_order=0")
        self.process = subprocess.Popen(command, stdout=self.output, stderr=subprocess.STDOUT, text=True, env=environment, **options)

    def said(self):
        self.output.seek(0)
        return self.output.read().splitlines()

    def end(self, how):
        """Exit status after the signal."""
        self.process.send_signal(how)
        return self.process.wait(LONGEST_END)

    def kill(self):
        if self.process.poll() is None:
            self.process.kill()
            self.process.wait()
        self.output.close()


class Process(unittest.TestCase):
    def start(self, namespace, *settings):
        node = Node(namespace, *settings)
        self.addCleanup(node.kill)
        return node

    def on_master(self, node):
        groups = rosgraph.Master(rospy.get_name()).getSystemState()
        return any(node.name in nodes for group in groups for _, nodes in group)

    def ends_cleanly(self, node, how):
        self.assertEqual(0, node.end(how), node.said())
        self.assertFalse(self.on_master(node))

    @staticmethod
    def clock_moves():
        """In lockstep it does while a step runs. Another step would show it too, but where it comes first the long one is refused."""
        before = rospy.get_time()
        time.sleep(0.05)
        return rospy.get_time() > before

    def test_one_line_at_the_start(self):
        node = self.start("one_line", "clock:=lockstep")
        Rig("one_line")
        lines = [line for line in node.said() if line]
        self.assertEqual(1, len(lines), lines)
        for word in ("quick", "level hybrid (auto: the string hangs", "nodes", "variable steps by a tolerance of 0.02", "rate 100 Hz", "namespace /one_line"):
            self.assertIn(word, lines[0])

    def test_signals_end_it_at_work_and_in_a_long_step(self):
        for number, how in enumerate((signal.SIGINT, signal.SIGTERM)):
            node = self.start("stepping_%d" % number, "clock:=lockstep")
            rig = Rig("stepping_%d" % number)
            answers = []
            stepping = threading.Thread(target=lambda: answers.append(rig.step(frames=100000)))
            stepping.start()
            wait_until(self.clock_moves, "step under way")
            self.ends_cleanly(node, how)
            stepping.join(PATIENCE)
            self.assertFalse(stepping.is_alive())

    def test_a_client_in_mid_step_gets_one_clear_error_when_it_is_killed(self):
        node = self.start("killed", "clock:=lockstep")
        client, errors = lockstep.Rig("killed"), []

        def step():
            try:
                client.step(frames=100000)
            except lockstep.Lost as error:
                errors.append(str(error))
        stepping = threading.Thread(target=step)
        stepping.start()
        wait_until(self.clock_moves, "step under way")
        node.kill()
        stepping.join(PATIENCE)
        self.assertEqual(1, len(errors), "the step ended without an error of its own")
        self.assertRegex(errors[0], "^/killed/step: the node does not answer after t = [0-9.]+ s ")
        with self.assertRaises(lockstep.Lost):
            client.tare()

    def test_signals_end_it_while_it_waits_for_a_clock(self):
        for number, how in enumerate((signal.SIGINT, signal.SIGTERM)):
            node = self.start("waiting_%d" % number, "publish_clock:=false")
            Rig("waiting_%d" % number)
            self.ends_cleanly(node, how)

    def test_signals_end_it_while_it_starts(self):
        for number, how in enumerate((signal.SIGINT, signal.SIGTERM)):
            node = self.start("starting_%d" % number, "scene:=bohai.yaml")
            wait_until(lambda: self.on_master(node), "node on the master")
            self.ends_cleanly(node, how)

    def told(self, node, words):
        """Waits until the node's diagnostics of time report it, as a warning."""
        diagnostics = Collector("/diagnostics", DiagnosticArray)

        def says(messages):
            return any(s.name == node.name[1:] + ": time" and words in s.message and s.level in (1, bytes([1]))
                       for m in messages for s in m.status)
        self.assertTrue(says(diagnostics.wait_until(says)), "never: " + words)
        diagnostics.subscriber.unregister()

    def warned(self, node, words):
        return len([line for line in node.said() if "WARN" in line and words in line])

    def warned_once(self, node, words):
        """The warning comes by a timer of its own, before or after the diagnostics that tell the same."""
        wait_until(lambda: self.warned(node, words), "warning: " + words)
        self.assertEqual(1, self.warned(node, words), node.said())

    def test_a_follower_says_what_is_wrong_with_its_clock(self):
        follower = self.start("follower", "publish_clock:=false")
        Rig("follower")
        self.told(follower, "waiting for /clock")
        self.warned_once(follower, "waiting for /clock")

        limits = Collector("/follower/rig_limits", RigLimits)
        leader = self.start("leader")
        self.assertGreater(limits.wait(1)[0].header.stamp.to_nsec(), 0)
        rig = Rig("follower")
        rig.state()
        leader.kill()
        self.told(follower, "/clock")
        wait_until(lambda: self.warned(follower, "leader"), "warning of the dead clock")
        time.sleep(2.0)
        self.assertEqual(1, self.warned(follower, "/leader/rig_simulator"), follower.said())

        other = self.start("other_leader")  # it follows the one that goes on
        rig.state()
        self.ends_cleanly(follower, signal.SIGTERM)
        self.ends_cleanly(other, signal.SIGTERM)

    def test_a_state_of_another_node_brings_no_old_telemetry(self):
        """Its surveys are older than the stamps of a node that has just started."""
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        saved = os.path.join(folder.name, "saved")
        writer = self.start("writer", "clock:=lockstep", "scene:=bohai.yaml")
        rig = Rig("writer")
        surveys = rig.collect("downhole/mwd", MwdSurvey)
        rig.advance(6000, winch=winch(0.01), mud_pump=flow(0.03))
        self.assertTrue(surveys.wait(1))
        before = rig.advance(1)
        rig.must(rig.save_state("", saved))
        expected = numbers(rig.advance(1))
        self.ends_cleanly(writer, signal.SIGTERM)

        reader = self.start("reader", "clock:=lockstep", "scene:=bohai.yaml")
        rig = Rig("reader")
        surveys, toolfaces = rig.collect("downhole/mwd", MwdSurvey), rig.collect("downhole/toolface", MwdToolface)
        start = rig.advance(0).header.stamp
        rig.must(rig.restore_state("", saved))
        state = rig.advance(0)
        self.assertEqual(numbers(before), numbers(state))
        self.assertEqual(start, state.winch.header.stamp)
        self.assertEqual(start, state.last_command)
        self.assertEqual(expected, numbers(rig.advance(1)))
        later = rig.advance(6000)
        self.assertTrue(toolfaces.wait(1))
        self.assertGreater(min(m.header.stamp for m in toolfaces.messages), rospy.Time())
        self.assertEqual([], [m for m in surveys.messages if m.header.stamp > later.header.stamp])
        self.ends_cleanly(reader, signal.SIGTERM)

    def test_a_refused_step_leaves_the_program_playing(self):
        node = self.start("playing", "clock:=lockstep", "play_program:=true")
        rig = Rig("playing")
        rig.must(rig.save_state("start", ""))
        expected = rig.advance(1000)
        rig.must(rig.restore_state("start", ""))
        refused = rig.step(StepSimulationRequest(frames=1, winch=[winch(0.1)], top_drive=[turn(float("nan"))]))
        self.assertFalse(refused.success)
        state = rig.advance(1000)
        self.assertEqual(numbers(expected), numbers(state))
        self.assertNotEqual(0.0, state.top_drive.speed)
        self.ends_cleanly(node, signal.SIGTERM)

    def test_backlog_is_dropped_counted_and_told_once(self):
        node = self.start("stopped")
        rig = Rig("stopped")
        rig.state()
        diagnostics = Collector("/diagnostics", DiagnosticArray)
        self.addCleanup(diagnostics.subscriber.unregister)
        before = float(self.time_values(diagnostics, node, lambda s: True)["dropped_seconds"])
        node.process.send_signal(signal.SIGSTOP)
        time.sleep(1.0)
        node.process.send_signal(signal.SIGCONT)
        told = self.time_values(diagnostics, node, lambda s: "slower than the requested speed" in s.message)
        self.assertGreaterEqual(float(told["dropped_seconds"]) - before, 1.0 - 0.1 - 0.02)  # a tenth of a second is caught up
        self.assertGreater(int(told["overruns"]), 0)
        self.ends_cleanly(node, signal.SIGTERM)

    @staticmethod
    def time_values(diagnostics, node, wanted):
        """The node's numbers of time once its status is the wanted one."""
        def found(messages):
            return [s for m in messages for s in m.status if s.name == node.name[1:] + ": time" and wanted(s)]
        return {pair.key: pair.value for pair in found(diagnostics.wait_until(found))[0].values}

    def test_it_knows_its_own_clock_without_listening_to_it(self):
        node = self.start("alone", "clock:=lockstep")
        rig = Rig("alone")
        state = rig.advance(50)
        subscribers = dict(rosgraph.Master(rospy.get_name()).getSystemState()[1]).get("/clock", [])
        self.assertNotIn(node.name, subscribers)
        self.assertFalse(rig.restore_state("never saved", "").success)
        wait_until(lambda: [line for line in node.said() if "WARN" in line], "a warning")
        told = [re.search(r"\[\d+\.\d+, (\d+\.\d+)\]", line) for line in node.said() if "WARN" in line]
        self.assertEqual([state.header.stamp.to_sec()], [float(match.group(1)) for match in told])  # the time of its log
        self.ends_cleanly(node, signal.SIGTERM)

    def test_two_clocks_are_noticed(self):
        first = self.start("first")
        Rig("first").state()
        second = self.start("second")
        for node, other in ((first, second), (second, first)):
            self.told(node, "two nodes publish /clock: " + node.name + " and " + other.name)
            self.warned_once(node, "two nodes publish /clock")


if __name__ == "__main__":
    run(Process)
