# SPDX-License-Identifier: BSD-3-Clause
"""Signals of a record that are nothing for long, while the bit moves and what goes with them stays: a gauge that was lost, or a true value beside one that hangs."""
import numpy
from drill_rig_sim.spans import spans

NOTHING, RUNS = 0.02, 0.2      # of the largest value, up to which a signal is nothing, and above which it is not
STAYS = 0.8                    # of what goes with it, of the usual value where the signal is not nothing
LONG, WAY = 60.0, 0.3          # time [s], and way of the bit or growth of the hole in it [m]
DEPTHS = ("bit_depth", "hole_depth")
# signal, what goes with it, and the ways that show that it cannot be nothing: a string turns without torque where it does not drill; it hangs in the slips while the block
# moves, but not under a pump and a top drive that run
TOGETHER = (("flow", ("stand_pipe_pressure",), DEPTHS), ("stand_pipe_pressure", ("flow",), DEPTHS), ("top_drive_speed", ("torque",), DEPTHS), ("torque", ("top_drive_speed",), DEPTHS[1:]),
            ("hook_load", ("top_drive_speed", "flow"), ("block_height",)))


def idle(record):
    """Lines, one for each signal."""
    lines = []
    for signal, others, ways in TOGETHER:
        found = idle_spans(record, signal, others, ways) if all(name in record for name in (signal, *others)) else []
        if found:
            begin, end, way = found[0]
            lines.append("%s: it is nothing from %.6g s on, for %.4g s in which the %s moves %.3g m and %s (%d such times); if it was not measured there, leave these rows out or empty" %
                         (signal, record.time[begin], record.time[end - 1] - record.time[begin], "block" if ways[0] == "block_height" else "bit", way,
                          " and ".join(others) + (" stay" if len(others) > 1 else " stays"), len(found)))
    return lines


def idle_spans(record, signal, others, ways):
    """(begin, end, way) of runs of rows."""
    sizes = numpy.abs(numpy.nan_to_num(record.signals[signal]))
    runs, rows = sizes > RUNS * sizes.max(), numpy.isfinite(record.signals[signal]) & (sizes <= NOTHING * sizes.max())
    for beside in (numpy.abs(numpy.nan_to_num(record.signals[name])) for name in others):
        usual = float(numpy.median(beside[runs])) if runs.any() else 0.0
        rows = rows & (beside >= STAYS * usual) & (usual > 0.0)
    found = [(begin, end, way_in(record, begin, end, ways)) for begin, end in spans(rows) if record.time[end - 1] - record.time[begin] >= LONG]
    return [one for one in found if one[2] >= WAY]


def way_in(record, begin, end, names):
    ways = [numpy.ptp(values[numpy.isfinite(values)]) for values in (record.signals[name][begin:end] for name in names if name in record) if numpy.isfinite(values).any()]
    return max(ways, default=0.0)
