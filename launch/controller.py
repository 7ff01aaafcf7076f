#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""A node that runs a control law of drill_rig_sim against the rig of its namespace: ~law (of LAWS, FILE.py:CLASS or PACKAGE.MODULE:CLASS) and its
arguments ~settings.

~plan: a survey's file, for a law that steers by one; ~plan_columns: a map of its columns, as `drill survey --columns`; ~plan_pass_over true, as its
--pass-over. ~orders: rows of time [s], set point and value. ~lockstep true: it steps the rig as fast as that goes, says how the law did (drill score)
and, given ~csv, writes the truth as drill run --csv does. False: it follows rig_state and publishes commands, as with a real rig.
"""
import os
import signal
import sys
import time

import rospy
from drill_rig_sim import control, topics
from drill_rig_sim.autodriller import Autodriller
from drill_rig_sim.campaign.blueprint import source_at
from drill_rig_sim.rig import Rig
from drill_rig_sim.rss_steering import RssSteering
from drill_rig_sim.score import score
from drill_rig_sim.score_command import table
from drill_rig_sim.score_runs import run_of_states, write_series
from drill_rig_sim.slide_steering import SlideSteering
from drill_rig_sim.stands import Stands
from drill_rig_sim.status import Status
from drill_rig_sim.stick_slip import StickSlip
from drill_rig_sim.survey import read_survey

LAWS = {"autodriller": Autodriller, "slide_steering": SlideSteering, "rss_steering": RssSteering, "stands": Stands, "stick_slip": StickSlip}


def planned():
    """The survey of ~plan; None without."""
    if not rospy.has_param("~plan"):
        return None
    return read_survey(rospy.get_param("~plan"), rospy.get_param("~plan_columns", ""), rospy.get_param("~plan_pass_over", False), plan=True)


def in_lockstep(law, timeout):
    rig = Rig(rospy.get_namespace().rstrip("/"))
    status = Status(law)
    states = control.drive(rig, law, timeout, telemetry=rig, judge=lambda state: status.publish(state.readings.header))
    status.end(rig.state.readings.header)
    run = run_of_states(states, rospy.get_param("~law"))
    if rospy.has_param("~csv"):
        write_series(run, rospy.get_param("~csv"))
    print("\n".join(table(score(run, planned(), **rospy.get_param("~score", {})))), flush=True)


def law_of_parameters():
    settings = dict(rospy.get_param("~settings", {}))
    if rospy.has_param("~plan"):
        settings["plan"] = planned()
    name = rospy.get_param("~law")
    law = (LAWS[name] if name in LAWS else source_at(name).load())(**settings)
    return control.Ordered(law, rospy.get_param("~orders", []))


def end_launch():
    """The launch file's goal is reached: ends roslaunch as Ctrl-C does. A required node that ends by itself is reported as one that has died, in red.
    Returns at once where this was started in another way."""
    parent = os.getppid()
    with open("/proc/%d/cmdline" % parent, "rb") as line:
        words = line.read().split(b"\0")
    if any(os.path.basename(word) == b"roslaunch" for word in words[:2]):
        os.kill(parent, signal.SIGINT)
        while not rospy.is_shutdown():  # until roslaunch ends this node too
            time.sleep(0.05)


def main():
    rospy.init_node("controller", disable_rostime=rospy.get_param("~lockstep", False))
    law = law_of_parameters()
    if rospy.get_param("~lockstep", False):
        in_lockstep(law, rospy.get_param("~timeout", 3600.0))
    else:
        topics.follow(law)
    given_up = getattr(law, "given_up", "")
    print("given up: " + given_up if given_up else "done" if law.done else "not done", flush=True)
    if given_up or not law.done:
        return 1
    end_launch()
    return 0


if __name__ == "__main__":
    sys.exit(main())
