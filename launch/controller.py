#!/usr/bin/env python3
"""A node that runs a control law of drill_rig_sim against the rig of its namespace: ~law and its arguments ~settings.

~lockstep true: it steps the rig as fast as that goes, says how the law did (drill score) and, given ~csv, writes the truth as drill run --csv does.
False: it follows rig_state and publishes commands, as with a real rig.
"""
import csv
import sys

import rospy
from drill_rig_sim import control
from drill_rig_sim.autodriller import Autodriller
from drill_rig_sim.rig import Rig
from drill_rig_sim.score import score
from drill_rig_sim.score_command import table
from drill_rig_sim.score_runs import Run, columns_of_truth
from drill_rig_sim.slide_steering import SlideSteering

LAWS = {"autodriller": Autodriller, "slide_steering": SlideSteering}


def in_lockstep(law, timeout):
    rig = Rig(rospy.get_namespace().rstrip("/"))
    telemetry = control.Telemetry() if law.listens else control.Deaf
    states = control.drive(rig, law, timeout, telemetry)
    run = Run(columns_of_truth([s.truth for s in states], [s.bit for s in states]), "truth", rospy.get_param("~law"))
    if rospy.has_param("~csv"):
        write(run, rospy.get_param("~csv"))
    print("\n".join(table(score(run, **rospy.get_param("~score", {})))), flush=True)


def write(run, file):
    with open(file, "w", newline="", encoding="utf-8") as text:
        rows = csv.writer(text)
        rows.writerow(run.columns)
        rows.writerows(zip(*(column.tolist() for column in run.columns.values())))


def main():
    rospy.init_node("controller", disable_rostime=rospy.get_param("~lockstep", False))
    law = LAWS[rospy.get_param("~law")](**rospy.get_param("~settings", {}))
    law = control.Ordered(law, rospy.get_param("~orders", []))
    if rospy.get_param("~lockstep", False):
        in_lockstep(law, rospy.get_param("~timeout", 3600.0))
    else:
        control.follow(law)
    print("done" if law.done else "not done", flush=True)
    return 0 if law.done else 1


if __name__ == "__main__":
    sys.exit(main())
