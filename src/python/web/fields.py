# SPDX-License-Identifier: BSD-3-Clause
"""The one list of what the page shows of rig_state: which member, under which name, in which unit and on which track."""
import typing

import numpy
from drill_rig_sim import lockstep
from drill_rig_sim.web.flags import FLAGS


class Field(typing.NamedTuple):
    """`member`: of RigState. `quantity`: of drill_rig_sim.units. `track`: of the time log, "" for none. `scale`: its ends until the run exceeds them,
    in SI."""
    name: str
    label: str
    member: str
    quantity: str
    track: str
    scale: tuple


FIELDS = (
    Field("block_height", "Block height", "block_height", "length", "hoist", (0.0, 40.0)),
    Field("hook_load", "Hook load", "hook_load", "force", "hoist", (0.0, 5e5)),
    Field("wob", "WOB", "surface_wob", "force", "bit", (0.0, 1e5)),
    Field("rop", "ROP", "rop", "penetration", "bit", (0.0, 0.02)),
    Field("rpm", "Rotary", "top_drive_speed", "rotation", "rotary", (0.0, 15.708)),
    Field("torque", "Torque", "torque", "torque", "rotary", (0.0, 1e4)),
    Field("pressure", "SPP", "stand_pipe_pressure", "pressure", "mud", (0.0, 2e7)),
    Field("differential", "Diff. pressure", "differential_pressure", "pressure", "mud", (0.0, 5e6)),
    Field("flow", "Flow", "flow", "flow", "mud", (0.0, 0.05)),
    Field("bit_depth", "Bit depth", "bit_depth", "length", "", (0.0, 1000.0)),
    Field("hole_depth", "Hole depth", "hole_depth", "length", "", (0.0, 1000.0)))
NAMES = tuple(field.name for field in FIELDS)
MEMBERS = tuple(field.member for field in FIELDS)
TRACKS = (("hoist", "Hoist"), ("bit", "Bit"), ("rotary", "Rotary"), ("mud", "Mud"))

# the eight large numbers: what is shown, and small below it, by a label so short that it stands there on the narrowest screen
NUMBERS = (("hook_load", "block_height", "Block"), ("wob", "", ""), ("rop", "", ""), ("torque", "", ""), ("rpm", "", ""),
           ("pressure", "differential", "Diff."), ("flow", "", ""), ("bit_depth", "hole_depth", "Hole"))

# of the depth log, over new hole
DEPTH_TRACKS = (("rop", "ROP"), ("wob", "WOB"), ("torque", "Torque"), ("mse", "MSE, surface"), ("differential", "Diff. pressure"))

# flags that are only in the truth: no rig can sense them
UNSENSED = tuple(flag for flag in FLAGS if flag in lockstep.UNSENSED)
ACCURACY = "accuracy_warning"  # stands apart: of the simulation, not of the rig
SENSED = tuple(flag for flag in FLAGS if flag not in UNSENSED)
SEEN = (*MEMBERS, *SENSED, ACCURACY, "tared", "in_slips", "brake_set", "block_velocity", "stand_count", "run_state", "epoch")


def columns_of(rows):
    """By the names of FIELDS, of rows with the members SEEN. Without a zero, WOB and differential pressure are nan: before `tare`, in the slips."""
    columns = {field.name: rows[field.member].astype(float) for field in FIELDS}
    unknown = ~rows["tared"] | rows["in_slips"]
    for name in ("wob", "differential"):
        columns[name] = numpy.where(unknown, numpy.nan, columns[name])
    return columns
