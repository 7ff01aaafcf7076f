#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Lockstep: exact frames, and bit-identical states on repetition and after a restored snapshot, in the middle of drilling."""
import os
import tempfile
import threading

from drill_rig_sim.msg import DrillstringState, MwdSurvey, MwdToolface, RigState
from drill_rig_sim.srv import StepSimulation
from rig_test import PATIENCE, Rig, flow, numbers, rospy, run, time, turn, unittest, winch
from rosgraph_msgs.msg import Clock

CHUNK = 100
CHUNKS = 36  # 3600 frames, in each half of which the path is corrected at least once
MIDDLE = 18


class Lockstep(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.rig = Rig()
        cls.strings = cls.rig.collect("drillstring_state", DrillstringState)

    def setUp(self):
        self.assertTrue(self.rig.reset_well("", 0.0).success)

    def chunk(self, number):
        """The state after the next chunk of frames of a fixed schedule of commands, and the string's last profile."""
        commands = {}
        if number == 0:
            commands = {"winch": winch(-0.008), "top_drive": turn(6.0), "mud_pump": flow(0.02)}
        elif number % 10 == 0:
            commands = {"winch": winch(-0.008 - 0.0001 * (number % 7)), "top_drive": turn(6.0 + 0.1 * (number % 3))}
        state = self.rig.advance(CHUNK, **commands)
        strings = self.strings.wait_until(lambda m: m and m[-1].header.stamp >= state.header.stamp)
        return state, numbers(state) + numbers(strings[-1])

    def test_a_step_advances_exactly_so_many_frames(self):
        clock, states = self.rig.collect("/clock", Clock), self.rig.collect("rig_state", RigState)
        start = self.rig.advance(0).header.stamp
        first = self.rig.advance(1)
        for frames in (1, 2, 5, 7):
            before = self.rig.advance(0)
            after = self.rig.advance(frames)
            self.assertEqual(frames * 10000000, (after.header.stamp - before.header.stamp).to_nsec())
        received = states.after(start, 16)
        self.assertEqual([first.header.stamp.to_nsec() + 10000000 * i for i in range(16)], [m.header.stamp.to_nsec() for m in received])
        self.assertEqual(after.header.stamp, clock.wait_until(lambda m: m and m[-1].clock >= after.header.stamp)[-1].clock)
        time.sleep(0.5)
        self.assertEqual(numbers(after), numbers(self.rig.advance(0)))  # nothing moves by itself

    def test_no_frame_of_a_long_step_is_missed(self):
        states = self.rig.collect("rig_state", RigState)
        self.addCleanup(states.subscriber.unregister)
        before = self.rig.advance(0).header.stamp
        after = self.rig.advance(1500).header.stamp
        states.wait_until(lambda m: m and m[-1].header.stamp >= after)
        heard = [m.header.stamp.to_nsec() for m in states.after(before, 1500)]
        self.assertEqual([before.to_nsec() + 10000000 * i for i in range(1, 1501)], heard)

    def test_no_frames_change_nothing(self):
        before = self.rig.advance(0)
        self.assertEqual(before, self.rig.advance(0))

    def test_repeated_and_restored_runs_are_bit_identical(self):
        first, depths = [], []
        for i in range(CHUNKS):
            if i == MIDDLE:
                self.assertTrue(self.rig.save_state("middle", "").success)
            state, everything = self.chunk(i)
            first.append(everything)
            depths.append(state.hole_depth)
        # in the middle of drilling, inside a correction interval, which is 0.1 m
        self.assertGreater(depths[MIDDLE], depths[MIDDLE - 1] + 1e-3)
        self.assertGreater((depths[MIDDLE - 1] - 160.0) % 0.1, 1e-3)
        self.assertGreater(depths[-1], depths[MIDDLE] + 0.1)

        self.assertTrue(self.rig.reset_well("", 0.0).success)
        for i in range(CHUNKS):
            self.assertEqual(first[i], self.chunk(i)[1], "repeated, chunk %d" % i)

        self.assertTrue(self.rig.restore_state("middle", "").success)
        for i in range(MIDDLE, CHUNKS):
            self.assertEqual(first[i], self.chunk(i)[1], "restored, chunk %d" % i)

    def test_telemetry_carries_the_time_of_measurement(self):
        surveys, toolfaces = self.rig.collect("downhole/mwd", MwdSurvey), self.rig.collect("downhole/toolface", MwdToolface)
        surveys.quiet()
        start = self.rig.advance(1, mud_pump=flow(0.02)).header.stamp
        latency = 2.0  # the scene's [s]
        now = self.rig.advance(round(100 * (latency - 0.05))).header.stamp
        time.sleep(0.5)  # long enough for a message that should not be there
        self.assertEqual([], surveys.messages)
        now = self.rig.advance(10).header.stamp
        arrived = surveys.wait(1)
        self.assertEqual(1, len(arrived), "no survey after the latency")
        self.assertAlmostEqual(latency, (now - arrived[0].header.stamp).to_sec(), delta=0.1)
        self.assertLessEqual((arrived[0].header.stamp - start).to_sec(), 0.011)
        self.assertAlmostEqual(0.3, arrived[0].inclination, delta=0.1)
        self.assertTrue(toolfaces.wait(1))
        self.assertEqual(MwdToolface.GRAVITY, toolfaces.messages[-1].reference)

    def test_time_is_not_anybodys_to_pause_or_to_pace(self):
        for answer in (self.rig.pause(), self.rig.resume(), self.rig.set_speed(2.0)):
            self.assertFalse(answer.success)
            self.assertIn("step", answer.message)

    def test_a_step_takes_seconds_too(self):
        before = self.rig.advance(0).header.stamp
        answer = self.rig.step(seconds=0.3)
        self.assertTrue(answer.success, answer.message)
        self.assertEqual(300000000, (answer.state.header.stamp - before).to_nsec())
        for fields, words in (({"seconds": 0.3, "frames": 30}, "frames and seconds are both given"), ({"seconds": 0.015}, "whole number of frames of 0.01 s"),
                              ({"seconds": -1.0}, "seconds must be"), ({"seconds": 1000.01}, "at most 1000 s"), ({"seconds": float("nan")}, "seconds must be")):
            refused, expected, after = self.rig.next_frame_after(lambda fields=fields: self.rig.step(**fields))
            self.assertFalse(refused.success)
            self.assertIn(words, refused.message)
            self.assertEqual(expected, after)

    def test_a_step_is_bounded(self):
        for frames in (100001, 4000000000):
            answer, expected, after = self.rig.next_frame_after(lambda: self.rig.step(frames=frames))
            self.assertFalse(answer.success)
            self.assertIn("100000", answer.message)
            self.assertEqual(expected, after)

    def test_while_a_step_runs_the_other_services_answer_and_pause_ends_it(self):
        states = self.rig.collect("rig_state", RigState)
        # drilling, that takes minutes: at rest a long step is over in seconds
        start = self.rig.advance(1, winch=winch(-0.004), top_drive=turn(6.0), mud_pump=flow(0.02))
        answers = []
        stepping = threading.Thread(target=lambda: answers.append(self.rig.step(frames=100000)))
        stepping.start()
        states.after(start.header.stamp, 10)
        self.assertTrue(self.rig.save_state("on the way", "").success)
        self.assertIn("on the way", self.rig.list_states().names)
        self.assertFalse(self.rig.set_speed(2.0).success)
        # a proxy of its own: that of the thread holds its connection, and on Debian 11 all calls of a proxy share one
        another_step = rospy.ServiceProxy("/rig/step", StepSimulation)
        for refused in (self.rig.reset_well("", 0.0), self.rig.restore_state("on the way", ""), another_step(frames=1),
                        self.rig.load_survey(md=[0.0, 100.0], inclination=[0.0, 0.0], azimuth=[0.0, 0.0])):
            self.assertFalse(refused.success)
            self.assertIn("a step is under way", refused.message)
        self.assertEqual([], answers, "the step ended by itself")
        self.assertTrue(self.rig.pause().success)
        stepping.join(PATIENCE)
        self.assertFalse(answers[0].success)
        self.assertIn("ended by pause", answers[0].message)
        done = int(answers[0].message.split("(")[1].split()[0])
        self.assertEqual(done * 10000000, (answers[0].state.header.stamp - start.header.stamp).to_nsec())
        self.assertEqual(numbers(answers[0].state), numbers(self.rig.advance(0)))
        self.assertFalse(self.rig.pause().success)  # there is none any more
        self.assertTrue(self.rig.restore_state("on the way", "").success)
        self.rig.advance(1)

    def test_snapshots_are_listed_and_deleted(self):
        for name in self.rig.list_states().names:
            self.rig.must(self.rig.delete_state(name))
        for name in ("b", "a", "a"):
            stamp = self.rig.advance(1).header.stamp
            self.rig.must(self.rig.save_state(name, ""))
        listed = self.rig.list_states()
        self.assertTrue(listed.success)
        self.assertEqual(["a", "b"], listed.names)
        self.assertEqual(stamp, listed.stamps[0])
        self.assertEqual(stamp - rospy.Duration(0, 20000000), listed.stamps[1])
        self.assertTrue(all(10000 < b < listed.limit for b in listed.bytes), listed)
        self.assertTrue(self.rig.delete_state("a").success)
        self.assertEqual(["b"], self.rig.list_states().names)
        for refused in (self.rig.delete_state("a"), self.rig.restore_state("a", "")):
            self.assertFalse(refused.success)
            self.assertIn("saved are: b", refused.message)

    def delete_all(self):
        for name in self.rig.list_states().names:
            self.rig.must(self.rig.delete_state(name))

    def test_snapshots_have_a_limit(self):
        self.delete_all()
        self.addCleanup(self.delete_all)
        answer = self.rig.save_state("0", "")
        count = 0
        while answer.success and count < 10000:
            count += 1
            answer = self.rig.save_state(str(count), "")
        self.assertIn("allowed are 1000", answer.message)
        listed = self.rig.list_states()
        self.assertEqual(count, len(listed.names))
        self.assertLessEqual(sum(listed.bytes), listed.limit)
        self.assertTrue(self.rig.save_state("0", "").success)  # in place of another
        self.rig.must(self.rig.delete_state("0"))
        self.assertTrue(self.rig.save_state("new", "").success)

    def test_a_file_brings_the_rig_back(self):
        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(folder, "state")
            self.rig.must(self.rig.save_state("", file))
            first = self.rig.advance(50)
            self.rig.must(self.rig.restore_state("", file))
            again = self.rig.advance(50)
            self.assertEqual(first.epoch + 1, again.epoch)
            again.header.stamp, again.epoch = first.header.stamp, first.epoch
            self.assertEqual(first, again)

    def test_restored_set_points_have_the_stamps_they_were_accepted_at(self):
        self.rig.advance(1, winch=winch(0.02))
        saved = self.rig.advance(10)
        self.rig.must(self.rig.save_state("commanded", ""))
        other = self.rig.advance(10, winch=winch(-0.02), mud_pump=flow(0.02))
        self.assertNotEqual(saved.winch.header.stamp, other.winch.header.stamp)
        self.rig.must(self.rig.restore_state("commanded", ""))
        state = self.rig.advance(0)
        self.assertEqual((0.02, 0.0), (state.winch.block_velocity, state.mud_pump.flow))
        self.assertEqual(saved.winch, state.winch)
        self.assertEqual(saved.last_command, state.last_command)
        self.assertEqual(rospy.Time(), state.mud_pump.header.stamp)

    def test_unknown_snapshots_and_files_are_refused(self):
        self.assertFalse(self.rig.restore_state("never saved", "").success)
        for answer in (self.rig.save_state("a", "/tmp/state"), self.rig.restore_state("a", "/tmp/state")):
            self.assertFalse(answer.success)
            self.assertIn("allowed is one of them", answer.message)
        for place in ("/dev/zero", "/nowhere/at/all", __file__):
            answer = self.rig.restore_state("", place)
            self.assertFalse(answer.success)
            self.assertIn(place, answer.message)
        self.assertFalse(self.rig.save_state("", "").success)
        self.assertFalse(self.rig.save_state(201 * "x", "").success)


if __name__ == "__main__":
    run(Lockstep)
