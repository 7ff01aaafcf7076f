# SPDX-License-Identifier: BSD-3-Clause
"""Negative null values small enough for a gauge, such as -99.99 klbf or -1 m, in a column whose other values are not negative."""
import numpy

NEGATIVE = (-9.99, -9.999, -99.0, -99.9, -99.99, -99.25, -99.999, -888.0, -888.88, -999.9, -999.99, -3.2768, -32.768, -32.77, -327.68)  # as files write "no number", and an empty counter
BELOW = 0.1  # of such a value: all others are above this share of it, and it is at least this share of the largest
POSITIVE = ("hook_load", "bit_depth", "hole_depth")  # signals in which any negative value that comes again is none, where
FORWARD = {"flow": 5e-3, "stand_pipe_pressure": 1e6}  # that pumps do not turn round, and what they deliver at least [SI]; below it, it may be the zero of a gauge
SMALL = (-1.0, -0.5)  # as files write it too
NOISE = 2.0  # of such a value: where others are as small, it may be that of a gauge
FAR = 0.2    # all others are above this share of the largest


def leave_out_negative_nulls(table, signal, name, raw, factor, remarks):
    """Of the numbers of a column (`factor` takes them to SI) the least one, where it is negative, the only such one and no measurement by its digits, its signal or all others; reported."""
    good = numpy.isfinite(raw)
    least = raw[good].min() if good.any() else 0.0
    rows = numpy.flatnonzero(raw == least)
    others = raw[good & (raw != least)]
    if least >= 0.0 or not len(others):
        return
    lowest, largest = others.min(), others.max()
    known = numpy.isclose(least, NEGATIVE, rtol=1e-9, atol=0.0).any() or (len(rows) > 1 and factor * largest > FORWARD.get(signal, numpy.inf))
    by_size = known and lowest > BELOW * least and largest > 0.0 and -least >= BELOW * largest
    by_sign = signal in FORWARD and least in SMALL and factor * largest > FORWARD[signal] and not ((others != 0.0) & (numpy.abs(others) <= -NOISE * least)).any()
    if by_size or by_sign or ((signal in POSITIVE or least in SMALL) and len(rows) > 1 and lowest > FAR * largest > 0.0):
        remarks.append("%s: %d values of %g, below all others, are treated as null values (first: %s)" % (name, len(rows), least, table.place(rows[0])))
        raw[rows] = numpy.nan
