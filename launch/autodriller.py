#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""A first controller: turns the string and feeds the bit so that 10 kN weigh on it. After a reset of the well it begins again."""
import rospy
from drill_rig_sim.msg import RigState, TopDriveCommand, WinchCommand
from std_srvs.srv import Trigger

epoch, began, speed = None, 0.0, 0.0  # run of the rig, its begin [s], speed of the block, downwards [m/s]


def feed(state):  # with every frame, 100 times a simulated second
    global epoch, began, speed
    now = state.header.stamp.to_sec()
    if state.epoch != epoch or now < began:  # the first frame, or the rig was reset or started again
        epoch, began, speed = state.epoch, now, 0.0
        winch.publish(WinchCommand(block_velocity=-0.01))
        top_drive.publish(TopDriveCommand(mode=TopDriveCommand.SPEED, speed=9.4))  # [rad/s], 90 rpm
    elif state.tared:
        missing = 10e3 - state.surface_wob  # weight on bit: how far the hook load is below its zero [N]
        speed = min(max(speed + 5e-9 * missing, 0.0), 0.015)
        winch.publish(WinchCommand(block_velocity=-speed))
    elif now > began + 8.0:
        tare()  # zero the hook load off bottom, moving down: at rest the rail friction is another


rospy.init_node("autodriller")
winch = rospy.Publisher("winch/command", WinchCommand, queue_size=1, latch=True)
top_drive = rospy.Publisher("top_drive/command", TopDriveCommand, queue_size=1, latch=True)
tare = rospy.ServiceProxy("tare", Trigger)
rospy.Subscriber("rig_state", RigState, feed, queue_size=1)
rospy.spin()
