# SPDX-License-Identifier: BSD-3-Clause
"""A unit that changes in the middle of a record's column: from one row to the next all values are larger or smaller by the ratio of two units of the trade."""
import numpy

from drill_rig_sim.field.signals import SIGNALS
from drill_rig_sim.field.units import factor_of

UNITS = {  # in which rigs record these quantities
    "force": ("kN", "klbf", "tonne", "kdaN", "daN", "N", "lbf", "kgf"),
    "torque": ("kN.m", "kft.lbf", "N.m", "ft.lbf"),
    "pressure": ("bar", "psi", "kPa", "MPa", "Pa"),
    "flow": ("L/min", "gpm", "L/s", "bbl/min", "m3/s"),
    "length": ("m", "ft")}
LEAST = 2.0                    # the smallest ratio of units that is looked for: loads change by less
NEAR, NEAREST = 0.06, 0.01     # share by which the ratio of two rows may differ from that of the units; of heights and depths, which hardly change between two rows
LEVEL = 0.15                   # share by which that of the quantiles of the rows before and after may
QUANTILES = (0.1, 0.5, 0.9)
LEAST_ROWS, FEW_ROWS, MOST_ROWS = 5, 20, 300  # before and after
STEADY = 0.1                   # share by which what goes on over the change may differ
TWO_LEVELS = 1.3               # ratio of the outer quantiles from which on a column has more than one level
FASTEST, STEP = 5.0, 1.0       # of a block [m/s], [m]
MOVING = 0.02                  # way of a block from row to row that moves steadily [m]
GOES_ON = {"hook_load": ("flow", "top_drive_speed"), "torque": ("top_drive_speed",), "stand_pipe_pressure": ("flow",), "flow": ("stand_pipe_pressure",)}


def unit_changes(time, signals):
    """(signal, row, ratio, the unit before, the unit after) of each change; `signals` in SI by name."""
    return [(signal, *change) for signal, values in signals.items() if SIGNALS[signal][0] in UNITS for change in changes_of(time, signals, signal, values)]


def changes_of(time, signals, signal, values):
    """Of one signal."""
    ratios = ratios_of(SIGNALS[signal][0])
    rows = numpy.flatnonzero(numpy.isfinite(values) & (values != 0.0))
    if len(rows) < 2 * LEAST_ROWS:
        return []
    is_length = SIGNALS[signal][0] == "length"
    steps = numpy.log(numpy.abs(values[rows[1:]] / values[rows[:-1]]))
    found = []
    for k in numpy.flatnonzero(numpy.abs(steps) > numpy.log(LEAST / (1.0 + NEAR))) + 1:
        ratio, before, after = min(ratios, key=lambda one: round(abs(numpy.log(one[0]) - steps[k - 1]), 6))  # the first of those with the same ratio
        near = NEAREST if is_length else NEAR
        if abs(steps[k - 1] - numpy.log(ratio)) > near or values[rows[k]] * values[rows[k - 1]] < 0.0:
            continue
        before_it, after_it = values[rows[max(0, k - MOST_ROWS):k]], values[rows[k:k + MOST_ROWS]]
        if min(len(before_it), len(after_it)) < LEAST_ROWS:
            continue
        here = rows[k - 1], rows[k]
        if jumps(time, values, *here, after_it, ratio) if is_length else is_another_unit(signals, signal, here, before_it, after_it, ratio):
            found.append((int(rows[k]), ratio, before, after))
    return found


def ratios_of(quantity):
    """(ratio of values, unit before, unit after) of two units whose ratio is LEAST or more."""
    pairs = [(factor_of(quantity, one), factor_of(quantity, other), one, other) for one in UNITS[quantity] for other in UNITS[quantity]]
    return [(first / second, one, other) for first, second, one, other in pairs if not 1.0 / LEAST < first / second < LEAST]


def is_another_unit(signals, signal, rows, before, after, ratio):
    """Whether the values before two rows and after them differ by the ratio, and the load cannot."""
    if nothing_else_changes(signals, signal, *rows):
        return scales(before[-FEW_ROWS:], after[:FEW_ROWS], ratio) or scales(before, after, ratio)
    return scales(before, after, ratio) and all(spread(part) > TWO_LEVELS for part in (before, after))


def scales(before, after, ratio):
    """Whether all levels after are those before times the ratio."""
    first, second = (numpy.quantile(numpy.abs(part), QUANTILES) for part in (before, after))
    return bool((numpy.abs(second - ratio * first) <= LEVEL * ratio * first).all())


def spread(part):
    low, _, high = numpy.quantile(numpy.abs(part), QUANTILES)
    return high / low if low > 0.0 else 1.0


def nothing_else_changes(signals, signal, before, after):
    """Whether flow or rotation go on over both rows, or the block moves on as before: no load changes so then, as it does where slips are set or the pump starts."""
    for other in GOES_ON[signal]:
        if other in signals and are_alike(*numpy.abs(signals[other][[before, after]])):
            return True
    if signal != "hook_load" or "block_height" not in signals or not 0 < before < after < len(signals["block_height"]) - 1:
        return False
    height = signals["block_height"]
    ways = height[before] - height[before - 1], height[after] - height[before], height[after + 1] - height[after]
    return all(are_alike(way, ways[1]) for way in ways) and abs(ways[1]) > MOVING


def are_alike(one, other):
    return bool(one * other > 0.0 and abs(one - other) <= STEADY * max(abs(one), abs(other)))


def jumps(time, values, before, after, later, ratio):
    """Whether a height or depth changes faster than any block, and does not come back."""
    moved = abs(values[after] - values[before])
    away = numpy.abs(numpy.log(numpy.abs(later / values[before]))) > 0.5 * abs(numpy.log(ratio))
    return moved > STEP + FASTEST * (time[after] - time[before]) and bool(away.all())
