#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What the rig and the bit report, against numbers worked out by hand and each other: the gauges, the joints, the bit's motion and load."""
import math

from by_hand import GRAVITY, Well, add, angle_between, distance, dot, length, quaternion, rotated, scene, turn_between, xyz
from drill_rig_sim.msg import Accuracy, RigLimits, RigState, RigTruth
from geometry_msgs.msg import PoseStamped, TwistStamped, WrenchStamped
from rig_test import Rig, flow, rospy, run, turn, unittest, winch
from sensor_msgs.msg import JointState
from std_msgs.msg import Float64

SCENE = scene("values.yaml")
FRAME = 0.01  # [s]
BLOCK_WEIGHT = GRAVITY * SCENE["rig"]["hoisting"]["block_mass"]
MOTOR = SCENE["string"][1]


def mean(values):
    values = list(values)
    return sum(values) / len(values)


def lift_by_mud(rate):
    """What mud lifts of the string on its way up the annulus: per section its loss, f = 0.0133, on pi/4 D D_h [N]."""
    hole = SCENE["well"]["sections"][0]["diameter"]
    tools = [part for part in SCENE["string"][1:] if part["type"] != "pipe"]
    stretches = [(part["outer_diameter"], part.get("length") or part["joints"] * part["joint_length"]) for part in tools]
    below = SCENE["string"][0]["length"] + sum(long for _, long in stretches)
    stretches.append((SCENE["string"][-1]["outer_diameter"], SCENE["start"]["bit_depth"] - below))
    total = 0.0
    for diameter, long in stretches:
        speed = rate / (0.25 * math.pi * (hole**2 - diameter**2))
        total += 2.0 * 0.0133 * SCENE["mud"]["density"] * speed**2 / (hole - diameter) * long * 0.25 * math.pi * diameter * hole
    return total


class Record:
    """All topics of a stretch of frames, one entry per frame."""

    KINDS = {"readings": ("rig_state", RigState), "truth": ("truth/rig_state", RigTruth), "joints": ("joint_states", JointState),
             "pose": ("bit/pose", PoseStamped), "twist": ("bit/twist", TwistStamped), "wrench": ("bit/wrench", WrenchStamped)}

    def __init__(self, rig):
        self.rig = rig
        self.topics = {name: rig.collect(*kind) for name, kind in self.KINDS.items()}

    def take(self, frames, **commands):
        """So many frames."""
        first = self.rig.advance(0).header.stamp
        self.rig.advance(frames, **commands)
        stamps = [first + rospy.Duration(0, 10000000) * (i + 1) for i in range(frames)]
        for name, topic in self.topics.items():
            messages = [m for m in topic.take_until(stamps[-1]) if m.header.stamp > first]
            assert [m.header.stamp for m in messages] == stamps, name
            setattr(self, name, messages)
        self.axis = [rotated(quaternion(m.pose.orientation), (1.0, 0.0, 0.0)) for m in self.pose]
        return self


class Values(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.rig = Rig()
        cls.well = Well(SCENE)
        cls.record = Record(cls.rig)

    def setUp(self):
        self.rig.must(self.rig.reset_well("", 0.0))

    def off_bottom(self, **commands):
        """Ten metres off bottom, after this number of commands."""
        self.rig.must(self.rig.reset_well("", 270.0))
        if commands:
            self.rig.advance(1, **commands)

    def drilling(self):
        """A steady 10 mm/s into the rock, rotating, tared before."""
        self.rig.must(self.rig.reset_well("", 0.0))
        self.rig.must(self.rig.tare())
        self.rig.advance(400, winch=winch(0.0), top_drive=turn(4.0), mud_pump=flow(0.02))
        self.rig.advance(1500, winch=winch(-0.01))

    def test_bare_numbers_are_rig_states(self):
        topics = {name: self.rig.collect(name, Float64) for name in ("hook_load", "torque")}
        for topic in topics.values():
            self.addCleanup(topic.subscriber.unregister)
            topic.quiet()  # bare numbers have no stamp: one of the frame before may still be on its way
        record = self.record.take(20, winch=winch(0.05), top_drive=turn(1.0))
        for name, topic in topics.items():
            self.assertEqual([getattr(m, name) for m in record.readings], [m.data for m in topic.wait(20)], name)
        self.assertEqual(20, len({m.hook_load for m in record.readings}), "noise makes each another")

    def test_joint_states_are_the_readings_of_block_and_drive(self):
        record = self.record.take(100, winch=winch(0.2), top_drive=turn(1.0))
        for joints, state in zip(record.joints, record.readings):
            self.assertEqual(["traveling_block", "top_drive"], joints.name)
            self.assertEqual((state.block_height, state.top_drive_angle), joints.position)
            self.assertEqual((state.block_velocity, state.top_drive_speed), joints.velocity)
            self.assertEqual((state.hook_load, state.torque), joints.effort)
        for joint, least in ((0, 0.1), (1, 0.5)):
            for before, here, after in zip(record.joints[40:], record.joints[41:], record.joints[42:]):
                rate = (after.position[joint] - before.position[joint]) / (2 * FRAME)
                self.assertAlmostEqual(rate, here.velocity[joint], delta=0.02 * abs(rate) + 1e-3)
                self.assertGreater(rate, least)

    def test_readings_are_off_by_what_the_scene_says(self):
        record = self.record.take(400, top_drive=turn(1.0), mud_pump=flow(0.02))
        errors = [r.hook_load - t.hook_load for r, t in zip(record.readings, record.truth)]
        self.assertAlmostEqual(5000.0, mean(errors), delta=4 * 20.0 / math.sqrt(400))
        self.assertAlmostEqual(20.0, math.sqrt(mean((e - mean(errors)) ** 2 for e in errors)), delta=4 * 20.0 / math.sqrt(800))
        for reading, truth in zip(record.readings, record.truth):
            self.assertAlmostEqual(30.0, reading.torque - truth.torque, places=6)
            for name in ("block_height", "block_velocity", "top_drive_angle", "top_drive_speed", "stand_pipe_pressure", "flow"):
                self.assertEqual(getattr(truth, name), getattr(reading, name), name)
            for state in (reading, truth):
                self.assertAlmostEqual(state.hook_load - BLOCK_WEIGHT, state.hook_load_string, places=6)
        # the motor turns freely; the string, which bounces by a millimetre a second, displaces a little mud
        self.assertAlmostEqual(4.0e9 * 0.02**2, record.readings[-1].stand_pipe_pressure, delta=400.0)
        self.assertEqual(0.02, record.readings[-1].flow)

    def test_tare_is_the_zero_of_both(self):
        """The zero is the mean of the hook load over whole periods of its ringing, 2 s or more."""
        self.off_bottom()
        record = self.record.take(300)
        rung_before = list(record.readings), list(record.truth)
        for state in (record.readings[0], record.truth[0]):
            self.assertFalse(state.tared)
            self.assertEqual(0.0, state.surface_wob)
            self.assertFalse(state.in_slips)
        self.rig.must(self.rig.tare())
        record = self.record.take(30, winch=winch(0.2))
        for rung, states in zip(rung_before, (record.readings, record.truth)):
            loads = [state.hook_load for state in rung[-200:]]
            zero = states[0].surface_wob + states[0].hook_load
            self.assertAlmostEqual(sum(loads) / len(loads), zero, delta=1.0 + 0.1 * (max(loads) - min(loads)))
            for state in states:
                self.assertTrue(state.tared)
                self.assertAlmostEqual(zero - state.hook_load, state.surface_wob, places=6)
        self.assertLess(min(s.surface_wob for s in record.truth), -100.0, "the load of lifting")

    def test_accuracy_is_measured_once_a_second(self):
        accuracy = self.rig.collect("accuracy", Accuracy)
        self.addCleanup(accuracy.subscriber.unregister)
        begin = self.rig.advance(0).header.stamp
        self.rig.advance(500, winch=winch(0.05), top_drive=turn(2.0))
        messages = accuracy.after(begin, 5)
        self.assertEqual([begin + rospy.Duration(n) for n in range(1, 6)], [m.header.stamp for m in messages])
        m = messages[-1]
        self.assertEqual("rig_floor", m.header.frame_id)
        self.assertEqual(["hook_load", "torque", "wob", "rop", "bit_speed", "stand_pipe_pressure"], m.outputs)
        self.assertEqual([True] * 6, [bool(needed) for needed in m.needed])
        self.assertTrue(m.measured, m.why_not_measured)
        self.assertEqual(("", 3.0, 0.02), (m.why_not_measured, m.window, m.tolerance))
        self.assertTrue(m.companion.startswith("beam3d, "), m.companion)
        for errors in (m.error, m.absolute):
            self.assertEqual(6, len(errors))
            self.assertTrue(all(0.0 <= error < math.inf for error in errors), errors)
        self.assertGreater(m.absolute[0], 0.0)
        self.assertGreater(m.absolute[0], m.error[0], "in N")
        self.assertTrue(0.0 < m.cost_share < 1.0, m.cost_share)

    def test_rig_limits_are_the_scenes(self):
        limits = self.rig.collect("rig_limits", RigLimits).wait(1)[-1]
        hoisting, drive = SCENE["rig"]["hoisting"], SCENE["rig"]["top_drive"]
        self.assertEqual("rig_floor", limits.header.frame_id)
        expected = {"max_block_speed": hoisting["max_speed"], "max_block_acceleration": hoisting["max_acceleration"],
                    "max_hook_load": hoisting["max_hook_load"], "lowest_block_height": hoisting["lowest_block_height"],
                    "highest_block_height": hoisting["highest_block_height"], "max_top_drive_torque": drive["max_torque"],
                    "max_top_drive_speed": drive["max_speed_rpm"] * 2.0 * math.pi / 60.0, "max_top_drive_power": drive["max_power"],
                    "max_flow": SCENE["rig"]["mud_pump"]["max_flow"]}
        for name, value in expected.items():
            self.assertAlmostEqual(value, getattr(limits, name), delta=1e-12 * value, msg=name)

    def test_depths_are_those_of_bit_and_hole(self):
        self.record.take(1)
        reading, truth = self.record.readings[0], self.record.truth[0]
        for s in (reading, truth):
            self.assertAlmostEqual(279.995, s.bit_depth, delta=1e-4)
            self.assertAlmostEqual(20.0, s.block_height, delta=1e-4)
        self.assertEqual(280.0, truth.hole_depth)
        record = self.record.take(100, winch=winch(0.1))
        for s in record.readings:
            self.assertAlmostEqual(reading.bit_depth + reading.block_height, s.bit_depth + s.block_height, places=9)  # the tally
        moved = record.truth[-1].bit_depth - truth.bit_depth
        self.assertAlmostEqual(-(record.truth[-1].block_height - truth.block_height), moved, delta=0.02)  # and the string's stretch

    def test_bit_lies_in_the_hole_and_points_along_it(self):
        self.off_bottom(winch=winch(0.0), top_drive=turn(4.0), mud_pump=flow(0.02))
        record = self.record.take(200)
        for pose, axis, state in zip(record.pose, record.axis, record.truth):
            place, along = self.well.at(state.bit_depth)
            away = add(xyz(pose.pose.position), place, -1.0)
            self.assertLess(length(away), 5e-3, "bit and hole have one diameter")
            self.assertAlmostEqual(0.0, dot(away, along), delta=1e-3)
            self.assertLess(angle_between(axis, along), math.radians(2.0))
            self.assertAlmostEqual(1.0, length(quaternion(pose.pose.orientation)), places=12)

    def test_twist_is_the_poses_rate(self):
        self.off_bottom(winch=winch(0.1), top_drive=turn(4.0), mud_pump=flow(0.01))
        self.rig.advance(300)
        record = self.record.take(200)
        sums = (0.0, 0.0, 0.0)
        for i in range(1, 200):
            before, after = record.twist[i - 1].twist, record.twist[i].twist
            sums = add(sums, add(xyz(before.linear), xyz(after.linear)), 0.5 * FRAME)
            turned = turn_between(quaternion(record.pose[i - 1].pose.orientation), quaternion(record.pose[i].pose.orientation))
            said = tuple(0.5 * FRAME * x for x in add(xyz(before.angular), xyz(after.angular)))
            self.assertLess(distance(turned, said), 0.02 * length(turned) + 1e-4)
        moved = add(xyz(record.pose[-1].pose.position), xyz(record.pose[0].pose.position), -1.0)
        self.assertLess(distance(moved, sums), 1e-3)
        self.assertGreater(length(moved), 0.1)

    def spin_of_bit(self, record):
        """The bit's angular velocity about its axis, mean [rad/s]."""
        return mean(dot(xyz(t.twist.angular), axis) for t, axis in zip(record.twist, record.axis))

    def test_bit_turns_with_string_and_motor(self):
        self.off_bottom(winch=winch(0.0), top_drive=turn(4.0))
        self.rig.advance(500)
        self.assertAlmostEqual(4.0, self.spin_of_bit(self.record.take(300)), delta=0.04)
        self.rig.advance(300, mud_pump=flow(0.02))
        free = 2.0 * math.pi * 0.02 / MOTOR["displacement_per_rev"]
        self.assertAlmostEqual(4.0 + free, self.spin_of_bit(self.record.take(300)), delta=0.01 * (4.0 + free))

    def test_rock_pushes_up_the_hole_and_against_the_turn(self):
        self.drilling()
        record = self.record.take(500)
        along = [dot(xyz(w.wrench.force), axis) for w, axis in zip(record.wrench, record.axis)]
        torque = [-dot(xyz(w.wrench.torque), axis) for w, axis in zip(record.wrench, record.axis)]
        self.assertLess(max(along), 0.0)
        self.assertGreater(min(torque), 0.0)
        weight = -mean(along)
        self.assertGreater(weight, 3000.0)
        rail = 0.03 * BLOCK_WEIGHT  # the zero was taken at rest; of a block that goes down its rail carries this
        for states in (record.truth, record.readings):  # in a hole without friction the surface sees all of the weight
            self.assertAlmostEqual(weight + rail + lift_by_mud(0.02), mean(s.surface_wob for s in states), delta=0.03 * weight)
        self.assertTrue(all(s.on_bottom for s in record.truth))
        self.assertFalse(hasattr(record.readings[0], "on_bottom"), "no gauge senses it")
        bit = SCENE["string"][0]
        self.assertAlmostEqual(bit["torque"]["kinetic"] * bit["diameter"] / 3.0 * weight, mean(torque), delta=0.02 * mean(torque))
        turning = self.spin_of_bit(record)
        rate = SCENE["formation"][0]["drillability"] * weight * turning
        self.assertAlmostEqual(rate, mean(s.rop for s in record.truth), delta=0.03 * rate)
        slip = 1.0 - (mean(torque) / MOTOR["stall_torque"]) ** 4
        free = 2.0 * math.pi * 0.02 / MOTOR["displacement_per_rev"]
        self.assertAlmostEqual(4.0 + slip * free, turning, delta=0.02 * free)
        pressure = 2.0 * math.pi * mean(torque) / MOTOR["displacement_per_rev"]
        for states in (record.truth, record.readings):
            surge = mean(s.stand_pipe_pressure for s in states) - 4.0e9 * 0.02**2 - pressure  # of the string that follows the bit
            self.assertGreater(surge, -0.01 * pressure)
            self.assertLess(surge, 0.05 * pressure)
        self.assertAlmostEqual(mean(torque), mean(s.torque for s in record.truth), delta=0.1 * mean(torque))

    def test_rate_of_penetration_is_the_depths(self):
        self.drilling()
        record = self.record.take(1000)
        for before, state in zip(record.truth, record.truth[1:]):
            self.assertAlmostEqual((state.hole_depth - before.hole_depth) / FRAME, state.rop, delta=1e-9)
        self.assertAlmostEqual(0.01, mean(s.rop for s in record.truth), delta=5e-4)
        self.assertAlmostEqual(0.01, record.readings[-1].rop, delta=1e-4)  # by the block's travel
        self.assertAlmostEqual(record.readings[-1].rop,
                               (record.readings[-1].hole_depth - record.readings[0].hole_depth) / (999 * FRAME), delta=2e-4)


if __name__ == "__main__":
    run(Values)
