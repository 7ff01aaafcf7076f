#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Each limit of the rig by itself: its flag is set where the limit holds the rig back, and not before or after; its number is kept."""
import math
import os
import tempfile

from by_hand import scene
from drill_rig_sim.msg import RigState, RigTruth, TopDriveCommand
from drill_rig_sim.srv import InjectFaultRequest
from rig_test import Rig, numbers, rospy, run, turn, unittest, winch
from sensor_msgs.msg import JointState

RIG = scene("values.yaml")["rig"]
HOISTING, DRIVE = RIG["hoisting"], RIG["top_drive"]
INERTIA = 2500.0  # of the rotor, a scene's default [kg m2]
GEARBOX = 1000.0  # its friction, a default too [N m]
FASTEST = DRIVE["max_speed_rpm"] * 2.0 * math.pi / 60.0


def torque(value, limit=0.0):
    return TopDriveCommand(mode=TopDriveCommand.TORQUE, torque=value, torque_limit=limit)


class Limits(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.rig = Rig()

    def setUp(self):
        self.rig.must(self.rig.reset_well("", 270.0))

    def frames(self, count, **commands):
        return [self.rig.advance(1, **(commands if i == 0 else {})) for i in range(count)]

    def test_nothing_is_limited_at_rest(self):
        for state in self.frames(5):
            self.assertEqual((False,) * 5, (state.winch_limited, state.top_drive_limited, state.command_clamped,
                                            state.commands_timed_out, state.in_slips))
            self.assertTrue(state.brake_set)

    def test_clamped_is_of_the_last_command(self):
        fast = self.rig.advance(1, winch=winch(-100.0))
        self.assertTrue(fast.command_clamped)
        self.assertEqual(-HOISTING["max_speed"], fast.winch.block_velocity)
        self.assertTrue(self.rig.advance(3).command_clamped)
        self.assertFalse(self.rig.advance(1, winch=winch(0.0)).command_clamped)
        self.assertTrue(self.rig.advance(1, top_drive=turn(100.0)).command_clamped)
        self.assertFalse(self.rig.advance(1, top_drive=turn(1.0)).command_clamped)

    def test_winch_ramps_at_its_acceleration(self):
        states = self.frames(60, winch=winch(0.16))  # 0.4 s at 0.4 m/s2, 0.032 m
        self.assertTrue(all(s.winch_limited for s in states[:39]))
        self.assertFalse(any(s.winch_limited for s in states[41:]))
        self.assertAlmostEqual(0.16 * 0.4 / 2 + 0.16 * 0.2, states[-1].block_height - 20.0, delta=3e-3)
        states = self.frames(60, winch=winch(0.0))
        self.assertTrue(all(s.winch_limited for s in states[:39]))
        self.assertFalse(any(s.winch_limited for s in states[41:]))

    def held_at(self, velocity, height):
        """Runs the block against a limit of height and away again."""
        states = self.frames(400, winch=winch(velocity))
        self.assertTrue(states[-1].winch_limited)
        self.assertAlmostEqual(height, states[-1].block_height, delta=0.01)
        self.assertLess(max(abs(s.block_height - 20.0) for s in states), abs(height - 20.0) + 0.02)
        states = self.frames(100, winch=winch(-0.2 * math.copysign(1.0, velocity)))
        self.assertFalse(states[-1].winch_limited)
        self.assertGreater(abs(states[-1].block_height - height), 0.1)

    def test_highest_and_lowest_block(self):
        self.held_at(0.5, HOISTING["highest_block_height"])
        self.rig.must(self.rig.reset_well("", 270.0))
        self.held_at(-0.5, HOISTING["lowest_block_height"])

    def test_hook_load(self):
        self.rig.must(self.rig.inject_fault(InjectFaultRequest(fault=InjectFaultRequest.STUCK_PIPE, depth=60.0)))
        free = self.rig.advance(1).hook_load
        self.assertLess(free, HOISTING["max_hook_load"] - 2e4)
        states = self.frames(300, winch=winch(0.03))
        truth = [s.hook_load - 5000.0 for s in states]  # less the gauge's bias
        first = next(i for i, s in enumerate(states) if i > 50 and s.winch_limited)  # after the ramp
        self.assertAlmostEqual(HOISTING["max_hook_load"], truth[first], delta=0.03 * HOISTING["max_hook_load"])
        self.assertLess(max(truth), 1.03 * HOISTING["max_hook_load"])
        self.assertLess(states[-1].block_height, HOISTING["highest_block_height"] - 0.1, "it is not the height")
        self.assertTrue(all(s.winch_limited for s in states[first:first + 5]))
        states = self.frames(100, winch=winch(-0.05))
        self.assertFalse(states[-1].winch_limited)
        self.assertLess(states[-1].hook_load, HOISTING["max_hook_load"])

    def test_torque_of_the_drive(self):
        states = self.frames(20, top_drive=turn(4.0))  # 4 rad/s at once would take 80 kN m
        self.assertTrue(all(s.top_drive_limited for s in states))
        # less what the string takes: a wave's resistance, some 320 N m s/rad
        expected = (DRIVE["max_torque"] - GEARBOX) / 320.0 * (1.0 - math.exp(-0.2 * 320.0 / INERTIA))
        self.assertAlmostEqual(expected, states[-1].top_drive_speed, delta=0.05 * expected)
        state = self.rig.advance(800)
        self.assertFalse(state.top_drive_limited)
        self.assertAlmostEqual(4.0, state.top_drive_speed, delta=0.05)

    def test_torque_limit_of_a_command(self):
        limited = turn(4.0)
        limited.torque_limit = 2000.0
        states = self.frames(20, top_drive=limited)
        self.assertTrue(all(s.top_drive_limited for s in states))
        expected = (2000.0 - GEARBOX) / 320.0 * (1.0 - math.exp(-0.2 * 320.0 / INERTIA))
        self.assertAlmostEqual(expected, states[-1].top_drive_speed, delta=0.05 * expected)
        self.assertEqual(2000.0, states[-1].top_drive.torque_limit)

    def test_power_of_the_drive(self):
        slow = self.rig.advance(1, top_drive=torque(DRIVE["max_torque"]))
        self.assertFalse(slow.top_drive_limited, "its full torque at rest")
        reached = DRIVE["max_power"] / DRIVE["max_torque"]  # where torque times speed is the power
        states = self.frames(280)
        for state in states:
            if abs(state.top_drive_speed - reached) > 0.1 and state.top_drive_speed < FASTEST - 0.5:
                self.assertEqual(state.top_drive_speed > reached, state.top_drive_limited, state.top_drive_speed)
        beyond = [s for s in states if reached + 0.1 < s.top_drive_speed < FASTEST - 0.5]
        self.assertGreater(len(beyond), 20)
        # what goes into the rotor and over the meter into the string is the power
        work = sum(0.5 * (a.torque + b.torque - 60.0) * (b.top_drive_angle - a.top_drive_angle) for a, b in zip(beyond, beyond[1:]))
        work += GEARBOX * (beyond[-1].top_drive_angle - beyond[0].top_drive_angle)
        work += 0.5 * INERTIA * (beyond[-1].top_drive_speed ** 2 - beyond[0].top_drive_speed ** 2)
        self.assertAlmostEqual(DRIVE["max_power"] * 0.01 * (len(beyond) - 1), work, delta=0.02 * work)

    def test_speed_of_the_drive(self):
        self.rig.advance(1500, top_drive=torque(3000.0))
        state = self.rig.advance(1)
        self.assertTrue(state.top_drive_limited)
        self.assertAlmostEqual(FASTEST, state.top_drive_speed, delta=0.02 * FASTEST)
        self.assertLess(state.torque, 2900.0, "the motor gives no more than holds the speed")

    def test_state_rate_is_every_fourth_frame_and_all_topics_keep_it(self):
        topics = [self.rig.collect(name, kind) for name, kind in (("rig_state", RigState), ("truth/rig_state", RigTruth), ("joint_states", JointState))]
        start = self.rig.advance(0).header.stamp  # reset_well has begun the rate anew
        self.rig.advance(16)
        for topic in topics:
            stamps = [m.header.stamp for m in topic.after(start, 4)]
            self.assertEqual([start + rospy.Duration(0, 40000000 * i) for i in (1, 2, 3, 4)], stamps)
            topic.subscriber.unregister()

    def test_snapshots_of_another_rig_are_refused(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        file = os.path.join(folder.name, "state")
        self.rig.must(self.rig.save_state("mine", ""))
        self.rig.must(self.rig.save_state("", file))
        self.rig.must(self.rig.reset_well("", 0.0))  # the same scene, the bit elsewhere
        for name, place in (("mine", ""), ("", file)):
            answer, expected, after = self.rig.next_frame_after(lambda n=name, p=place: self.rig.restore_state(n, p))
            self.assertFalse(answer.success, name or place)
            self.assertEqual(expected, after)
        self.assertEqual(["before"], self.rig.list_states().names)
        self.rig.must(self.rig.reset_well("", 270.0))
        self.rig.must(self.rig.restore_state("", file))

    def test_a_restored_rig_has_its_set_points_gauges_and_telemetry_back_and_time_runs_on(self):
        self.rig.advance(30, winch=winch(0.1), top_drive=turn(2.0))
        self.rig.must(self.rig.save_state("here", ""))
        saved = self.rig.advance(0)
        first = [numbers(s) for s in self.frames(30)]
        late = self.rig.advance(1, winch=winch(-0.1), top_drive=torque(100.0))
        self.rig.must(self.rig.restore_state("here", ""))
        back = self.rig.advance(0)
        self.assertEqual(numbers(saved), numbers(back))
        self.assertEqual((0.1, 2.0), (back.winch.block_velocity, back.top_drive.speed))
        self.assertEqual(late.header.stamp + rospy.Duration(0, 10000000), back.header.stamp)
        again = self.frames(30)
        self.assertEqual(first, [numbers(s) for s in again])
        self.assertEqual(back.header.stamp + rospy.Duration(0, 300000000), again[-1].header.stamp)


if __name__ == "__main__":
    run(Limits)
