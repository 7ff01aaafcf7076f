# SPDX-License-Identifier: BSD-3-Clause
"""Weights of a table that no string has: those of 0 or below are left out, others are reported."""
import numpy
from drill_rig_sim.field.contradictions import load_at
from drill_rig_sim.field.native import of_module
from drill_rig_sim.field.record import LEAST_LOAD

NEIGHBOURS, FAR, DEEPER = 2, 2.5, 2.0  # on each side; as a ratio of the loads, and of the depths up to which loads are compared
OUTSIDE = 0.1                          # of the pick-up or slack-off weight, by which a rotating weight may lie beyond both: sheaves and gauges


def leave_out_zeros(table, loads):
    """Makes loads (name -> array [N]) of 0 or below nan; lines on them."""
    lines = []
    for name, values in loads.items():
        rows = numpy.flatnonzero(values <= 0.0)
        if len(rows) and not name.startswith("slips"):  # the gauge may be zeroed with the empty block
            lines.append("%s: %d weights of 0 or below are left out (first: %s)" % (name, len(rows), table.place(rows[0])))
            values[rows] = numpy.nan
    return lines


def unlikely(table, depths, loads):
    """Lines on depths and loads in another unit, on one far from those at similar depths, and on a rotating weight that is not between pick-up and slack-off weight."""
    step = of_module().pipe_step_in_feet(depths)
    lines = ["depth: its rows are usually %.4g m apart, as joints and stands are in feet (31, 62 or 93); is its unit ft?" % step] if step else []
    lines += repeated(table, depths, loads)
    for name, values in loads.items():
        good = numpy.flatnonzero(numpy.isfinite(values))
        if len(good) and not name.startswith("slips") and values[good].max() < LEAST_LOAD:
            lines.append("%s: its largest weight is %.3g N, less than a block weighs; is its unit right?" % (name, values[good].max()))
        elif len(good) and not name.startswith("slips"):
            lines += load_at(name, values[good], float(depths[good].max()))
        lines += ["%s: %.4g kN at %.6g m is far from those at similar depths, about %.4g kN (%s); check it" % (name, values[row] / 1e3, depths[row], usual / 1e3, table.place(row))
                  for row, usual in far(depths, values, good)]
    if {"pick_up", "slack_off", "rotating"} <= set(loads):
        pair = numpy.array([loads["pick_up"], loads["slack_off"]])
        odd = numpy.flatnonzero((loads["rotating"] < (1.0 - OUTSIDE) * pair.min(axis=0)) | (loads["rotating"] > (1.0 + OUTSIDE) * pair.max(axis=0)))
        if len(odd):
            lines.append("%d of %d rows have a rotating weight that is not between pick-up and slack-off weight (first: %s); check columns and units" %
                         (len(odd), len(depths), table.place(odd[0])))
    return lines


def repeated(table, depths, loads):
    """Lines on depths that a table holds again with another weight: both are compared. A table of drill weights has a row for each move."""
    lines = []
    for name, values in loads.items() if "motion" not in table.names else ():
        rows, again, first = {}, 0, None
        for row in numpy.flatnonzero(numpy.isfinite(values)) if not name.startswith("slips") else ():
            before = rows.setdefault(float(depths[row]), row)
            if before != row and values[row] != values[before]:
                again, first = again + 1, first or (row, before)
        if again:
            lines.append("%s: %d rows hold a depth again with another weight, and each is used (first: %s: %.4g kN at %.6g m, %s: %.4g kN)" %
                         (name, again, table.place(first[0]), values[first[0]] / 1e3, depths[first[0]], table.place(first[1]), values[first[1]] / 1e3))
    return lines


def far(depths, values, good):
    """(row, usual load) of the loads of rows `good` that are far from all their neighbours in depth."""
    order = good[numpy.argsort(depths[good], kind="stable")]
    for k, row in enumerate(order):
        near = numpy.concatenate((order[max(0, k - NEIGHBOURS):k], order[k + 1:k + 1 + NEIGHBOURS]))
        near = near[(depths[near] <= DEEPER * depths[row]) & (DEEPER * depths[near] >= depths[row])]
        ratios = values[near] / values[row]
        if len(near) >= NEIGHBOURS and numpy.all(numpy.maximum(ratios, 1.0 / ratios) > FAR):
            yield row, numpy.median(values[near])
