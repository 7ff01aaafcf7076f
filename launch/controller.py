#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""A node that runs a control law of drill_rig_sim against the rig of its namespace: ~law (of LAWS, FILE.py:CLASS or PACKAGE.MODULE:CLASS) and its
arguments ~settings.

~plan: a survey's file, for a law that steers by one; ~plan_columns: a map of its columns, as `drill survey --columns`; ~plan_pass_over true, as its
--pass-over. ~orders: rows of time [s], set point and value. ~lockstep true: it steps the rig as fast as that goes, says how the law did (drill score)
and, given ~csv, writes the truth as drill run --csv does. False: it follows rig_state and publishes commands, as with a real rig.
"""
import inspect
import os
import signal
import sys
import time

import rospy
from drill_rig_sim import control, topics
from drill_rig_sim.autodriller import Autodriller
from drill_rig_sim.campaign.blueprint import SourceError, source_at
from drill_rig_sim.rig import Rig
from drill_rig_sim.rss_steering import RssSteering
from drill_rig_sim.score import score
from drill_rig_sim.score_command import table
from drill_rig_sim.score_runs import run_of_states, write_series
from drill_rig_sim.slide_steering import SlideSteering
from drill_rig_sim.stands import Stands
from drill_rig_sim.status import Status
from drill_rig_sim.stick_slip import StickSlip
from drill_rig_sim.survey import SurveyError, read_survey

LAWS = {"autodriller": Autodriller, "slide_steering": SlideSteering, "rss_steering": RssSteering, "stands": Stands, "stick_slip": StickSlip}


def planned():
    """The survey of ~plan; None without."""
    if not rospy.has_param("~plan"):
        return None
    try:
        return read_survey(rospy.get_param("~plan"), rospy.get_param("~plan_columns", ""), rospy.get_param("~plan_pass_over", False), plan=True)
    except SurveyError as error:
        sys.exit("parameter ~plan: %s" % error)


def in_lockstep(law, timeout):
    rig = Rig(rospy.get_namespace().rstrip("/"))
    status = Status(law)
    states = control.drive(rig, law, timeout, telemetry=rig, judge=lambda state: status.publish(state.readings.header))
    status.end(rig.state.readings.header)
    run = run_of_states(states, rospy.get_param("~law"))
    if rospy.has_param("~csv"):
        write_series(run, rospy.get_param("~csv"))
    print("\n".join(table(score(run, planned(), **rospy.get_param("~score", {})))), flush=True)


def class_of_law():
    """The class that ~law names."""
    name = rospy.get_param("~law", "")
    allowed = "allowed: %s, FILE.py:CLASS or PACKAGE.MODULE:CLASS" % ", ".join(LAWS)
    if not isinstance(name, str) or name not in LAWS and not all(name.rpartition(":")):
        sys.exit("parameter ~law is %r; %s" % (name, allowed))
    try:
        return LAWS[name] if name in LAWS else source_at(name).load()
    except (OSError, UnicodeDecodeError, SourceError) as error:
        sys.exit("parameter ~law is %r: %s; %s" % (name, error, allowed))


def check_settings(law, settings):
    """That a law's class takes them, and has all that it needs."""
    taken = inspect.signature(law).parameters.values()
    names = [one.name for one in taken if one.kind in (one.POSITIONAL_OR_KEYWORD, one.KEYWORD_ONLY)]
    missing = [one.name for one in taken if one.name in names and one.default is one.empty and one.name not in settings]
    unknown = [] if any(one.kind == one.VAR_KEYWORD for one in taken) else [name for name in settings if name not in names]
    if unknown:
        sys.exit("parameter ~settings: %s has no %s; allowed: %s" % (law.__name__, ", ".join(unknown), ", ".join(names) or "none"))
    if missing:
        sys.exit("parameter ~settings: %s needs %s" % (law.__name__, ", ".join(missing)))


def law_of_parameters():
    settings = rospy.get_param("~settings", {})
    if not isinstance(settings, dict):
        sys.exit("parameter ~settings is %r; allowed is names with values" % (settings,))
    settings = dict(settings)
    if rospy.has_param("~plan"):
        settings["plan"] = planned()
    law = class_of_law()
    check_settings(law, settings)
    return control.Ordered(law(**settings), rospy.get_param("~orders", []))


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
