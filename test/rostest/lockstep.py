#!/usr/bin/env python3
"""Lockstep: exact frames, and bit-identical states on repetition and after a restored snapshot, in the middle of drilling."""
from drill_rig_sim.msg import DrillstringState, MwdSurvey, MwdToolface, RigState
from rig_test import Rig, flow, numbers, run, time, turn, unittest, winch
from rosgraph_msgs.msg import Clock

CHUNK = 100
CHUNKS = 100  # 10^4 frames
MIDDLE = 50


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
            commands = {"winch": winch(-0.004), "top_drive": turn(6.0), "mud_pump": flow(0.02)}
        elif number % 10 == 0:
            commands = {"winch": winch(-0.004 - 0.0001 * (number % 7)), "top_drive": turn(6.0 + 0.1 * (number % 3))}
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
        start = self.rig.advance(1, mud_pump=flow(0.02)).header.stamp
        arrived = None
        while arrived is None and (self.rig.advance(10).header.stamp - start).to_sec() < 60.0:
            time.sleep(0.005)
            arrived = surveys.messages[0] if surveys.messages else None
        now = self.rig.advance(0).header.stamp
        self.assertIsNotNone(arrived, "no survey within a minute")
        self.assertAlmostEqual(2.0, (now - arrived.header.stamp).to_sec(), delta=0.5)  # the scene's latency
        self.assertAlmostEqual(0.3, arrived.inclination, delta=0.1)
        self.assertTrue(toolfaces.wait(1))
        self.assertEqual(MwdToolface.GRAVITY, toolfaces.messages[-1].reference)

    def test_pause_and_set_speed_have_no_meaning(self):
        self.assertFalse(self.rig.pause().success)
        self.assertFalse(self.rig.set_speed(2.0).success)

    def test_unknown_snapshots_and_files_are_refused(self):
        self.assertFalse(self.rig.restore_state("never saved", "").success)
        self.assertIn("not available yet", self.rig.save_state("", "/tmp/state").message)
        self.assertFalse(self.rig.save_state("", "").success)


if __name__ == "__main__":
    run(Lockstep)
