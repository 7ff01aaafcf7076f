#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""A string of 1300 elements and its well as a rig would publish them, 12 km, half of it horizontal: for what displays cost. It turns at 120 rpm, at the
default rates: drillstring_state ten times, tf thirty times a second."""
import math

import rospy
from drill_rig_sim.msg import DrillstringState, RigDescription
from geometry_msgs.msg import Point, PoseStamped, TransformStamped
from nav_msgs.msg import Path
from tf2_msgs.msg import TFMessage

ELEMENTS, LENGTH = 1300, 9.5  # [m]
DEPTH = ELEMENTS * LENGTH - 30.0
KICK_OFF, RADIUS, CLEARANCE = 1500.0, 800.0, 0.044  # vertical down to there, then a quarter of a circle, then level [m]


def at(md):
    """Place and tangent of the hole's axis: (east, up), (east, up)."""
    if md < KICK_OFF:
        return (0.0, -md), (0.0, -1.0)
    angle = min((md - KICK_OFF) / RADIUS, math.pi / 2)
    level = max(0.0, md - KICK_OFF - RADIUS * math.pi / 2)
    return (RADIUS * (1 - math.cos(angle)) + level, -KICK_OFF - RADIUS * math.sin(angle)), (math.sin(angle), -math.cos(angle))


def description():
    m = RigDescription()
    m.header.frame_id = "rig_floor"
    m.part_name, m.part_type = ["bit", "stabilizer", "pipe"], [m.BIT, m.STABILIZER, m.PIPE]
    m.part_length, m.part_joint_length = [0.3, 1.8, 0.0], [0.3, 1.8, LENGTH]
    m.part_diameter, m.part_bore, m.part_widest = [0.2159, 0.165, 0.127], [0.0, 0.07, 0.1086], [0.2159, 0.212, 0.168]
    m.section_bottom, m.section_diameter = [3000.0, 20000.0], [0.2205, 0.2159]
    m.layer_base, m.layer_drillability = [800.0, 1600.0, 9000.0], [1e-8] * 3
    m.station_md = [30.0 * i for i in range(int(DEPTH / 30.0))]
    m.station = [Point(at(md)[0][0], 0.0, at(md)[0][1]) for md in m.station_md]
    m.plan, m.crown_height, m.sheaves = m.station, 46.0, 6
    return m


def trajectory():
    path = Path()
    path.header.frame_id = "rig_floor"
    for md in range(int(DEPTH) + 1):
        (east, up), (tangent_east, tangent_up) = at(md)
        pose = PoseStamped()
        pose.pose.position = Point(east, 0.0, up)
        turn = math.atan2(-tangent_up, tangent_east)  # about north, x axis to the tangent
        pose.pose.orientation.y, pose.pose.orientation.w = math.sin(turn / 2), math.cos(turn / 2)
        path.poses.append(pose)
    return path


def string(phase):
    m = DrillstringState()
    m.header.stamp, m.header.frame_id = rospy.Time.now(), "rig_floor"
    for i in range(ELEMENTS + 1):
        from_bit = 0.1 + LENGTH * i
        md = DEPTH - from_bit
        (east, up), (tangent_east, tangent_up) = at(md)
        side = 0.3 * math.sin(phase + 0.05 * i)  # on the low side, rolling a little
        low = CLEARANCE * math.cos(side)
        m.md.append(md)
        m.from_bit.append(from_bit)
        m.position.append(Point(east + low * tangent_up, CLEARANCE * math.sin(side), up - low * tangent_east))
        m.tension.append(300.0 * from_bit - 5e4)
        m.torque.append(5e3 + 2.0 * from_bit)
        m.contact_force.append(2e3 * (1.0 + math.sin(0.1 * i + phase)))
        m.spin_speed.append(12.6)
    zeros = [0.0] * (ELEMENTS + 1)
    m.true_axial_force = m.tension
    m.bending_moment = m.bending_stress = m.contact_side = m.buckling_factor = zeros
    m.guided = [False] * (ELEMENTS + 1)
    return m


def transforms(angle):
    message = TFMessage()
    for name in ("bit", "stabilizer", "traveling_block"):
        t = TransformStamped()
        t.header.stamp, t.header.frame_id, t.child_frame_id = rospy.Time.now(), "rig_floor", name
        (east, up), _ = at(DEPTH)
        t.transform.translation.x, t.transform.translation.z = (0.0, 25.0) if name == "traveling_block" else (east, up)
        t.transform.rotation.x, t.transform.rotation.w = math.sin(angle / 2), math.cos(angle / 2)
        message.transforms.append(t)
    return message


def main():
    rospy.init_node("long_string")
    latched = [rospy.Publisher("rig_description", RigDescription, queue_size=1, latch=True), rospy.Publisher("trajectory", Path, queue_size=1, latch=True)]
    for publisher, message in zip(latched, (description(), trajectory())):
        publisher.publish(message)
    strings = rospy.Publisher("drillstring_state", DrillstringState, queue_size=1)
    tf = rospy.Publisher("/tf", TFMessage, queue_size=10)
    messages = [string(0.6 * i) for i in range(10)]
    rate = rospy.Rate(30)
    count = 0
    while not rospy.is_shutdown():
        if count % 3 == 0:
            message = messages[count // 3 % len(messages)]
            message.header.stamp = rospy.Time.now()
            strings.publish(message)
        tf.publish(transforms(12.6 * count / 30.0))
        count += 1
        rate.sleep()


if __name__ == "__main__":
    main()
