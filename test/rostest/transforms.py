#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The frames make one connected tree, move as the signs say, and are never sent twice with one stamp."""
import math
import xml.etree.ElementTree as xml

from rig_test import Rig, rospy, run, turn, unittest
from tf2_msgs.msg import TFMessage


class Transforms(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.rig = Rig()
        static = cls.rig.collect("/tf_static", TFMessage)
        cls.moving = cls.rig.collect("/tf", TFMessage)
        cls.states = [cls.rig.advance(1, top_drive=turn(0.5))] + [cls.rig.advance(1) for _ in range(103)]
        end = cls.states[-1].header.stamp - rospy.Duration(0, 35000000)
        cls.messages = cls.moving.wait_until(lambda m: m and m[-1].transforms[0].header.stamp >= end)
        cls.parents = {t.child_frame_id: t.header.frame_id for m in static.wait(1) + cls.messages for t in m.transforms}

    def test_every_frame_leads_to_the_world(self):
        for frame in self.parents:
            seen = {frame}
            while frame != "world":
                self.assertIn(frame, self.parents)
                frame = self.parents[frame]
                self.assertNotIn(frame, seen)
                seen.add(frame)

    def test_every_part_has_its_frame(self):
        for name in ("rig_floor", "traveling_block", "top_drive", "bit", "motor", "float_valve", "stabilizer", "mwd"):
            self.assertIn(name, self.parents)
        self.assertGreater(sum(name.startswith("pipe_") for name in self.parents), 5)

    def test_each_link_of_robot_description_has_its_frame(self):
        links = {link.get("name") for link in xml.fromstring(rospy.get_param(self.rig.topic("robot_description"))).iter("link")}
        self.assertIn("mwd", links)
        self.assertLessEqual(links, set(self.parents))

    def test_parts_hang_on_the_rig_floor(self):
        self.assertEqual({"rig_floor"}, {parent for child, parent in self.parents.items() if child != "rig_floor"})

    def test_rotations_have_unit_length_and_stamps_grow(self):
        last = 0
        for message in self.messages:
            stamps = {t.header.stamp.to_nsec() for t in message.transforms}
            self.assertEqual(1, len(stamps))
            self.assertGreater(min(stamps), last)
            last = min(stamps)
            for t in message.transforms:
                q = t.transform.rotation
                self.assertAlmostEqual(1.0, q.x**2 + q.y**2 + q.z**2 + q.w**2, places=9)

    def test_frames_thirty_times_per_second_in_lockstep_by_simulated_time(self):
        self.assertAlmostEqual(31, len(self.messages), delta=2)

    def test_top_drive_turns_clockwise_looking_downhole(self):
        message = self.messages[-1]
        state = next(s for s in self.states if s.header.stamp == message.transforms[0].header.stamp)
        self.assertGreater(state.top_drive_angle, 0.01)
        frames = {t.child_frame_id: t.transform for t in message.transforms}
        q = frames["top_drive"].rotation
        self.assertAlmostEqual(-state.top_drive_angle, 2.0 * math.atan2(q.z, q.w), places=6)
        self.assertAlmostEqual(state.block_height, frames["traveling_block"].translation.z, places=9)


if __name__ == "__main__":
    run(Transforms)
