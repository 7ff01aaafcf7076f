#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Sends what the rig's instruments show as WITS level 0 over TCP: record 01 from rig_state, record 07 from downhole/mwd and downhole/toolface.
What clients send is not looked at."""
import sys

import rospy
from drill_rig_sim import wits0
from drill_rig_sim.msg import MwdSurvey, MwdToolface, RigState


def parameter(name, default, kind, is_good, allowed):
    value = rospy.get_param("~" + name, default)
    if isinstance(value, bool) or not isinstance(value, kind) or not is_good(value):
        sys.exit("parameter ~%s is %r; allowed is %s" % (name, value, allowed))
    return value


def start_date():
    """Of simulated time 0, since 1970 [s]."""
    text = rospy.get_param("~start_date", wits0.START_DATE)
    try:
        return wits0.start_date_of(text)
    except (TypeError, ValueError):
        sys.exit("parameter ~start_date is %r; allowed is a UTC date from 1970 to 2199, such as 2024-05-17 or 2024-05-17T06:30:00Z" % (text,))


class General:
    """Record 01, once a period of simulated time. `start`: the date of simulated time 0, since 1970 [s]."""

    def __init__(self, server, period, start):
        self.server, self.period, self.start = server, period, start
        self.sent = None  # stamp [s]

    def take(self, state):
        stamp = state.header.stamp.to_sec()
        if self.sent is None or stamp < self.sent or stamp >= self.sent + self.period - 1e-6:
            self.server.send(wits0.general_record(state, self.start))
            self.sent = stamp


def main():
    rospy.init_node("wits0_server")
    host = parameter("host", "127.0.0.1", str, lambda v: v != "", "a name or address of this machine")
    port = parameter("port", 0, int, lambda v: 0 <= v <= 65535, "0 (any that is free) to 65535")
    period = parameter("period", 1.0, (int, float), lambda v: 0.0 < v < 1e6, "more than 0 s")
    start = start_date()
    try:
        server = wits0.Server(host, port, rospy.loginfo)
    except OSError as error:
        sys.exit("cannot listen on %s:%d: %s" % (host, port, error))
    rospy.set_param("~port", server.port)  # which it is, where it was 0
    rospy.loginfo("WITS level 0 on %s:%d", host, server.port)
    rospy.Subscriber("rig_state", RigState, General(server, period, start).take, queue_size=1000)
    rospy.Subscriber("downhole/mwd", MwdSurvey, lambda m: server.send(wits0.survey_record(m, start)), queue_size=100)
    rospy.Subscriber("downhole/toolface", MwdToolface, lambda m: server.send(wits0.toolface_record(m, start)), queue_size=100)
    rospy.on_shutdown(server.close)
    rospy.spin()


if __name__ == "__main__":
    main()
