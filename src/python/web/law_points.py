# SPDX-License-Identifier: BSD-3-Clause
"""Set points of the package's laws, with the bounds of their boxes. Written by test/tool/test_tables.py from the table of
src/rviz/console/law_points.h."""
import typing


class LawPoint(typing.NamedTuple):
    name: str      # in ControllerStatus
    order: str     # in an order to the autodriller
    label: str
    quantity: str  # of drill_rig_sim.units
    least: float   # what an order may have [SI]
    most: float
    first: float   # in the box before the first start [SI]; 0: none
    optional: bool  # no limit if it is left out


LAW_POINTS = (
    LawPoint("weight", "weight", "WOB", "force", 1e3, 1e6, 5e4, False),
    LawPoint("rop", "rop", "ROP", "penetration", 1e-4, 0.1, 0.01, False),
    LawPoint("pressure", "pressure", "differential pressure", "pressure", 1e4, 5e7, 0.0, True),
    LawPoint("torque", "torque", "torque over free", "torque", 10.0, 2e5, 0.0, True),
    LawPoint("rotary_speed", "rpm", "rotary speed", "rotation", 0.0, 40.0, 6.2832, False),
    LawPoint("flow", "flow", "flow", "flow", 0.0, 1.0, 0.03, False),
    LawPoint("to_depth", "to_depth", "to depth", "length", 0.0, 2e4, 0.0, False),
)
