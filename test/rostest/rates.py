#!/usr/bin/env python3
"""Topics come at their rates, counted by their stamps, and real time is kept."""
from diagnostic_msgs.msg import DiagnosticArray
from drill_rig_sim.msg import DrillstringState, MwdSurvey, MwdToolface, RigLimits, RigState
from geometry_msgs.msg import PoseStamped, TwistStamped, WrenchStamped
from nav_msgs.msg import Path
from rig_test import Rig, run, time, unittest
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
            "bit/twist": TwistStamped, "bit/wrench": WrenchStamped, "drillstring_state": DrillstringState, "markers": MarkerArray,
            "trajectory": Path, "rig_limits": RigLimits, "downhole/mwd": MwdSurvey, "downhole/toolface": MwdToolface,
            "/tf": TFMessage, "/tf_static": TFMessage, "/clock": Clock, "/diagnostics": DiagnosticArray}.items()}
        for name, topic in cls.topics.items():
            if not name.startswith("downhole"):  # seldom
                topic.wait(1)  # it is connected
        for topic in cls.topics.values():
            topic.clear()
        started = time.monotonic()
        states = cls.topics["rig_state"]
        cls.states = states.wait_until(lambda m: len(m) > 1 and cls.span(m) >= SECONDS)
        cls.wall = time.monotonic() - started

    @staticmethod
    def span(messages):
        return (messages[-1].header.stamp - messages[0].header.stamp).to_sec()

    def count_per_second(self, name):
        return len(self.topics[name].messages) / self.span(self.states)

    def test_rig_state_has_one_message_per_frame_and_none_is_missing(self):
        stamps = [m.header.stamp.to_nsec() for m in self.states]
        self.assertEqual({10000000}, {b - a for a, b in zip(stamps, stamps[1:])})

    def test_measurements_come_with_every_frame(self):
        for name in ("joint_states", "hook_load", "torque", "bit/pose", "bit/twist", "bit/wrench", "/clock"):
            self.assertAlmostEqual(100.0, self.count_per_second(name), delta=3.0, msg=name)

    def test_all_topics_of_a_frame_have_one_stamp(self):
        stamps = {m.header.stamp.to_nsec() for m in self.states}
        for name in ("joint_states", "bit/pose", "bit/twist", "bit/wrench", "drillstring_state"):
            own = [m.header.stamp.to_nsec() for m in self.topics[name].messages[2:-5]]
            self.assertTrue(own and stamps.issuperset(own), name)

    def test_drillstring_state_comes_ten_times_per_simulated_second(self):
        stamps = [m.header.stamp.to_nsec() for m in self.topics["drillstring_state"].messages]
        self.assertEqual({100000000}, {b - a for a, b in zip(stamps, stamps[1:])})

    def test_displays_come_at_their_rates(self):
        self.assertAlmostEqual(30.0, self.count_per_second("/tf"), delta=4.0)
        self.assertAlmostEqual(5.0, self.count_per_second("markers"), delta=1.0)

    def test_real_time_is_kept(self):
        self.assertGreater(self.span(self.states) / self.wall, 0.9)

    def test_clock_is_never_zero_and_only_grows(self):
        times = [m.clock.to_nsec() for m in self.topics["/clock"].messages]
        self.assertGreater(times[0], 0)
        self.assertTrue(all(b > a for a, b in zip(times, times[1:])))

    def test_arrays_along_the_string_have_one_length(self):
        message = self.topics["drillstring_state"].messages[-1]
        lengths = {len(getattr(message, name)) for name in message.__slots__ if name != "header"}
        self.assertEqual(1, len(lengths))
        self.assertGreater(lengths.pop(), 5)


if __name__ == "__main__":
    run(Rates)
