# SPDX-License-Identifier: BSD-3-Clause
"""Units in which the runner's commands and a campaign's page show numbers, by quantity; include/drill_rig_sim/math/shown_units.h says the same for C++. JSON
and CSV files stay in SI."""
import math
import typing

from drill_rig_sim.tables import SIGNALS

SYSTEMS = ("si", "oilfield")
DEGREE = math.pi / 180.0
# exact by definition, as in math/unit_table.h: [m], [m], [N], [kg]
GRAVITY = 9.80665  # standard [m/s2]
FOOT, INCH, POUND, POUND_MASS = 0.3048, 0.0254, 4.4482216152605, 0.45359237
PSI, GALLON, BARREL = POUND / INCH**2, 231.0 * INCH**3, 9702.0 * INCH**3  # [Pa], of the USA [m3], [m3]


class Unit(typing.NamedTuple):
    """shown = SI * per_si + zero; differences have no zero."""
    name: str
    per_si: float
    digits: int
    zero: float = 0.0


SHOWN = {
    "force": (Unit("kN", 1e-3, 2), Unit("klbf", 1e-3 / POUND, 2)),
    "torque": (Unit("kN m", 1e-3, 2), Unit("kft.lbf", 1e-3 / (POUND * FOOT), 2)),
    "rotation": (Unit("rpm", 30.0 / math.pi, 1), Unit("rpm", 30.0 / math.pi, 1)),
    "penetration": (Unit("m/h", 3600.0, 2), Unit("ft/h", 3600.0 / FOOT, 1)),
    "pressure": (Unit("bar", 1e-5, 1), Unit("psi", 1.0 / PSI, 0)),
    "specific_energy": (Unit("MPa", 1e-6, 1), Unit("ksi", 1e-3 / PSI, 1)),
    "flow": (Unit("L/min", 6e4, 0), Unit("gpm", 60.0 / GALLON, 0)),
    "length": (Unit("m", 1.0, 2), Unit("ft", 1.0 / FOOT, 2)),
    "speed": (Unit("m/s", 1.0, 3), Unit("ft/min", 60.0 / FOOT, 1)),
    "angle": (Unit("deg", 1.0 / DEGREE, 1), Unit("deg", 1.0 / DEGREE, 1)),
    "density": (Unit("kg/m3", 1.0, 0), Unit("ppg", GALLON / POUND_MASS, 2)),
    "dogleg": (Unit("deg/30 m", 30.0 / DEGREE, 2), Unit("deg/100 ft", 100.0 * FOOT / DEGREE, 2)),
    "temperature": (Unit("degC", 1.0, 1), Unit("degF", 1.8, 1, 32.0)),
    "time": (Unit("s", 1.0, 1), Unit("s", 1.0, 1)),
    "share": (Unit("%", 100.0, 1), Unit("%", 100.0, 1)),
    "number": (Unit("", 1.0, 2), Unit("", 1.0, 2)),
    "count": (Unit("", 1.0, 0), Unit("", 1.0, 0))}

# of the columns of a run, and of the profile along the string
QUANTITIES = {
    **{row.name: row.quantity for row in SIGNALS if row.type in ("float64", "") and row.quantity in SHOWN},
    "surface_torque": "torque", "tension": "force", "true_axial_force": "force", "contact_force": "force", "bending_moment": "torque"}


class Units:
    """units["force"]: the Unit of a quantity; units.label("hook load", "force"): "hook load [kN]"."""

    def __init__(self, system="si"):
        self.system = system

    def __getitem__(self, quantity):
        return SHOWN[quantity][SYSTEMS.index(self.system)]

    def label(self, name, quantity):
        return "%s [%s]" % (name, self[quantity].name)


SI = Units()
