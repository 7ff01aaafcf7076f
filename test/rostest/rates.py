#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Topics come at their rates, counted by their stamps, and real time is kept."""
from diagnostic_msgs.msg import DiagnosticArray
from drill_rig_sim.msg import BitTruth, DrillstringState, MwdSurvey, MwdToolface, RigLimits, RigState, RigTruth
from geometry_msgs.msg import PoseStamped, TwistStamped, WrenchStamped
from nav_msgs.msg import Path
from rig_test import Rig, rospy, run, time, unittest
from rosgraph_msgs.msg import Clock
from sensor_msgs.msg import JointState
from std_msgs.msg import Float64
from tf2_msgs.msg import TFMessage
from visualization_msgs.msg import MarkerArray

SECONDS = 5.0


class Rates(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rig = Rig()
        cls.topics = {name: rig.collect(name, kind) for name, kind in {
            "rig_state": RigState, "joint_states": JointState, "hook_load": Float64, "torque": Float64, "bit/pose": PoseStamped,
            "bit/twist": TwistStamped, "bit/wrench": WrenchStamped, "truth/rig_state": RigTruth, "truth/bit": BitTruth,
            "drillstring_state": DrillstringState, "markers": MarkerArray, "trajectory": Path, "rig_limits": RigLimits, "downhole/mwd": MwdSurvey, "downhole/toolface": MwdToolface,
            "/tf": TFMessage, "/tf_static": TFMessage, "/clock": Clock, "/diagnostics": DiagnosticArray}.items()}
        states = cls.topics["rig_state"]
        begin = states.wait(1)[-1].header.stamp
        started = time.monotonic()
        states.wait_until(lambda m: (m[-1].header.stamp - begin).to_sec() >= SECONDS)
        cls.wall = time.monotonic() - started
        end = begin + rospy.Duration(SECONDS)
        cls.states = [m for m in states.messages if begin < m.header.stamp <= end]
        cls.stamps = [m.header.stamp.to_nsec() for m in cls.states]
        cls.begin, cls.end = begin.to_nsec(), end.to_nsec()

    @staticmethod
    def span(messages):
        return (messages[-1].header.stamp - messages[0].header.stamp).to_sec()

    def stamps_of(self, name, stamp):
        """The stamps of a topic's messages in the time looked at, once a later one has come."""
        messages = self.topics[name].wait_until(lambda m: m and stamp(m[-1]) > self.end)
        return [stamp(m) for m in messages if self.begin < stamp(m) <= self.end]

    @staticmethod
    def header_stamp(message):
        return message.header.stamp.to_nsec()

    def test_rig_state_has_one_message_per_frame_and_none_is_missing(self):
        self.assertEqual(list(range(self.begin + 10000000, self.end + 1, 10000000)), self.stamps)

    def test_measurements_come_with_every_frame_and_its_stamp(self):
        for name in ("joint_states", "bit/pose", "bit/twist", "bit/wrench", "truth/rig_state", "truth/bit"):
            self.assertEqual(self.stamps, self.stamps_of(name, self.header_stamp), name)
        self.assertEqual(self.stamps, self.stamps_of("/clock", lambda m: m.clock.to_nsec()))

    def test_the_two_bare_numbers_come_with_every_frame(self):
        for name in ("hook_load", "torque"):
            expected = [getattr(m, name) for m in self.states]

            def has_all(messages):
                values = [m.data for m in messages]
                return any(values[i:i + len(expected)] == expected for i in range(len(values) - len(expected) + 1))
            self.assertTrue(has_all(self.topics[name].wait_until(has_all)), name)

    def test_drillstring_state_comes_ten_times_per_simulated_second(self):
        stamps = self.stamps_of("drillstring_state", self.header_stamp)
        self.assertTrue(set(self.stamps).issuperset(stamps))
        self.assertEqual({100000000}, {b - a for a, b in zip(stamps, stamps[1:])})
        self.assertEqual(10 * SECONDS, len(stamps))

    def test_displays_come_at_their_rates(self):
        frames = self.stamps_of("/tf", lambda m: m.transforms[0].header.stamp.to_nsec())
        markers = self.stamps_of("markers", lambda m: m.markers[0].header.stamp.to_nsec())
        self.assertAlmostEqual(30.0, len(frames) / self.wall, delta=4.0)
        self.assertAlmostEqual(5.0, len(markers) / self.wall, delta=1.0)

    def test_real_time_is_kept(self):
        self.assertGreater(self.span(self.states) / self.wall, 0.9)

    def test_clock_is_never_zero_and_only_grows(self):
        times = [m.clock.to_nsec() for m in self.topics["/clock"].wait(100)]
        self.assertGreater(times[0], 0)
        self.assertTrue(all(b > a for a, b in zip(times, times[1:])))

    def test_arrays_along_the_string_have_one_length(self):
        message = self.topics["drillstring_state"].wait(1)[-1]
        lengths = {len(getattr(message, name)) for name in message.__slots__ if name != "header"}
        self.assertEqual(1, len(lengths))
        self.assertGreater(lengths.pop(), 5)


if __name__ == "__main__":
    run(Rates, follows_clock=False)
