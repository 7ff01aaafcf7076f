# SPDX-License-Identifier: BSD-3-Clause
"""Rows of a record in which a signal falls to nothing and comes back while what goes with it stays: a flow of 0 under the pressure of the running pump, a torque of 0 of a top
drive that turns on. A gauge was lost there, whatever the file writes for it (0, -1, 0.001)."""
import numpy
from drill_rig_sim.spans import spans

NOTHING = 0.02       # of the largest value, up to which a signal has fallen to nothing
HIGH = 0.2           # of the largest value, above which it is before and after
BESIDE = 2           # rows before and after that show that it is steady: what swings goes through 0 by itself
LIKE = 0.3           # share by which values before, between and after may differ
# signal, what stays as it was, and the longest time in which the signal cannot come back by itself [s]
LOST = (("flow", "stand_pipe_pressure", 600.0), ("stand_pipe_pressure", "flow", 600.0), ("top_drive_speed", "torque", 30.0), ("torque", "top_drive_speed", 15.0))


def leave_out_dropouts(time, signals, place):
    """Makes rows of dropouts nan; lines on them. `place(k)`: where row k stands in its file."""
    found = [(name, other, dropouts(time, signals, name, other, longest)) for name, other, longest in LOST if name in signals and other in signals]
    for name, _, rows in found:
        signals[name][rows] = numpy.nan
    return ["%s: %d rows in which it falls to nothing and comes back, while %s stays as it is, are no measurements (first: %s)" % (name, len(rows), other, place(rows[0]))
            for name, other, rows in found if len(rows)]


def dropouts(time, signals, name, other, longest):
    """Rows of a signal."""
    sizes, beside = numpy.abs(signals[name]), numpy.abs(signals[other])
    known = numpy.flatnonzero(numpy.isfinite(sizes))
    there, found = sizes[known], []
    most = there.max() if len(there) else 0.0
    filled = known[there > NOTHING * most]
    for begin, end in spans(there <= NOTHING * most):
        if begin == 0 or end == len(known):
            continue
        before, after, rows = known[begin - 1], known[end], known[begin:end]
        sides = numpy.concatenate((filled[:numpy.searchsorted(filled, before) + 1][-BESIDE:], filled[numpy.searchsorted(filled, after):][:BESIDE]))
        back = sizes[sides].min() > HIGH * most and are_like(sizes[sides])
        if back and time[after] - time[before] <= longest and stays(beside, before, after, rows):
            found += list(rows)
    return numpy.array(found, int)


def stays(values, before, after, rows):
    """Whether values do not fall between two rows."""
    if not numpy.isfinite(values[[before, after]]).all() or not numpy.isfinite(values[rows]).all():
        return False
    return min(values[[before, after]]) > HIGH * numpy.nanmax(values) and are_like(numpy.concatenate((values[[before, after]], values[rows])))


def are_like(values):
    """Whether values differ by a small share."""
    return values.max() - values.min() <= LIKE * values.max()
