#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Knobs that a person turns while a rig runs, by dynamic_reconfigure (rqt_reconfigure, or `rosrun dynamic_reconfigure dynparam set`): friction of the
wall, drillability of the rock, bias and noise of gauges (config/Knobs.cfg). Start it in the namespace of the rig.

Each knob is a fault of the service inject_fault, which begins where the knob leaves its default, and ends where it comes back. What a knob shows holds
after reset_well, load_survey and restore_state, too. For runs that repeat bit by bit call inject_fault in lockstep instead."""
import threading

import rospy
from drill_rig_sim.cfg import KnobsConfig
from drill_rig_sim.msg import RigState
from drill_rig_sim.srv import InjectFault, InjectFaultRequest
from dynamic_reconfigure.server import Server

OF_HOLE = {"friction": InjectFaultRequest.FRICTION_CHANGE, "drillability": InjectFaultRequest.FORMATION_CHANGE}
OF_GAUGE = {"bias": InjectFaultRequest.SENSOR_BIAS, "noise": InjectFaultRequest.SENSOR_NOISE}


def fault_of(knob, value):
    """What the service is asked for."""
    gauge, _, kind = knob.rpartition("_")
    clear = value == KnobsConfig.defaults[knob]
    if knob in OF_HOLE:
        return InjectFaultRequest(fault=OF_HOLE[knob], clear=clear, magnitude=0.0 if clear else value)
    return InjectFaultRequest(fault=OF_GAUGE[kind], clear=clear, target=gauge, magnitude=0.0 if clear else value)


class Knobs:
    """What the knobs show, and the rig that they are turned on."""

    def __init__(self, inject):
        self.inject = inject
        self.values = dict(KnobsConfig.defaults)
        self.epoch = None
        self.lock = threading.Lock()

    def turn(self, config, _level):
        """A knob whose fault is refused goes back to where it was."""
        with self.lock:
            for knob, before in self.values.items():
                if config[knob] != before and not self.ask(knob, config[knob]):
                    config[knob] = before
                self.values[knob] = config[knob]
        return config

    def ask(self, knob, value):
        try:
            answer = self.inject(fault_of(knob, value))
        except rospy.ServiceException as error:
            rospy.logwarn("%s: %s", knob, error)
            return False
        if not answer.success:
            rospy.logwarn("%s: %s", knob, answer.message)
        return answer.success

    def look(self, state):
        """Turns them on another run of the rig as well."""
        with self.lock:
            is_other, self.epoch = self.epoch not in (None, state.epoch), state.epoch
            for knob, value in self.values.items():
                if is_other and value != KnobsConfig.defaults[knob]:
                    self.ask(knob, value)


if __name__ == "__main__":
    rospy.init_node("knobs")
    rospy.wait_for_service("inject_fault")
    knobs = Knobs(rospy.ServiceProxy("inject_fault", InjectFault))
    server = Server(KnobsConfig, knobs.turn)
    subscriber = rospy.Subscriber("rig_state", RigState, knobs.look, queue_size=1)
    rospy.spin()
