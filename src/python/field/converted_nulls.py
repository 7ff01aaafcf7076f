# SPDX-License-Identifier: BSD-3-Clause
"""Null values that a program has converted with the numbers of their column: -999.25 ft.lbf as -1354.8 N.m."""
import functools

import numpy
from drill_rig_sim.field.signals import SIGNALS
from drill_rig_sim.field.units import factor_of

WRITTEN = (-999.25, -999.0, -9999.0, -9999.25)  # before the conversion
UNITS = {"length": "m ft", "speed": "m/s m/min m/h ft/s ft/min ft/h", "angular speed": "rad/s rpm rev/s deg/s", "flow": "m3/s m3/min m3/h L/s L/min gpm bbl/min galUK/min",
         "force": "N daN kN kgf tf lbf klbf", "torque": "N.m daN.m kN.m kgf.m ft.lbf kft.lbf", "pressure": "Pa kPa MPa bar atm kgf/cm2 psi"}
FAR = 0.3  # of such a value, from which on all others of its column are above
FEWEST_DIGITS = 1e-3  # of the value, half of its last digit: -0.737 has enough, -1 has not
FACTOR_DIGITS = 2e-5  # relative error of the factors by which programs convert


@functools.lru_cache(maxsize=None)
def converted(quantity):
    """[(value in SI, null, unit)]."""
    return [(null * factor_of(quantity, unit), null, unit) for unit in UNITS[quantity].split() for null in WRITTEN]


def leave_out_converted_nulls(table, signal, name, unit, place, raw, factor, remarks):
    """Of the numbers of a column (`factor` takes them to SI) the least one where it is far below all others and is a null value of another unit by all its digits; reported."""
    good = numpy.isfinite(raw)
    least = raw[good].min() if good.any() else 0.0
    rows = numpy.flatnonzero(raw == least)
    others = raw[good & (raw != least)]
    if least >= 0.0 or not len(others) or others.min() <= FAR * least:
        return
    digits = 0.5 * 10.0 ** -decimals_of(table.rows[rows[0]][place])
    if digits > FEWEST_DIGITS * abs(least):
        return
    for value, null, other in converted(SIGNALS[signal][0]):
        if abs(least - value / factor) <= digits + FACTOR_DIGITS * abs(least):
            remarks.append("%s: %d values of %g %s are %g %s, a null value in another unit, and are treated as null values (first: %s)" %
                           (name, len(rows), least, unit, null, other, table.place(rows[0])))
            raw[rows] = numpy.nan
            return


def decimals_of(cell):
    """Behind the point of a number."""
    mantissa = cell.strip().lower().partition("e")[0]
    return len(mantissa.partition(".")[2])
