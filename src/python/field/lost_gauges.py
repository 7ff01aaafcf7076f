# SPDX-License-Identifier: BSD-3-Clause
"""Values of a record that no gauge measured: zeros of a gauge that was lost, the same value while the string moves, a single value far above all others."""
import numpy

FAST = 2.5           # speed at which a block does not go to 0 and come back from there between rows [m/s]
JUMP = 1.0           # and so far it has to go [m]
DEEP = 10.0          # by which a depth jumps more than the fastest block moves it [m]
TOGETHER = 0.2       # share of the block's way by which the bit's may differ, where the block moves the string
MOVES = 0.05         # from which on it moves between two rows [m]
PIPE = 100.0         # of pipe in the hole has a weight that no gauge shows as 0 [m]
LEAST_HUNG = 3       # steps of such a block from row to row
HELD = 60.0, 10      # time and rows over which a value is the same [s]
LEAST_WAY = 5.0      # of the string meanwhile [m]
CHANCE = 1e-9        # that a gauge with this resolution shows one value so often
TIMES, BEYOND = 3.0, 1.5  # of a single value over its neighbours, and over the largest of all others
LIKE = 0.3           # share by which its neighbours may differ
SINGLE = ("hook_load", "torque", "stand_pipe_pressure", "flow", "top_drive_speed")
TURNING = 3.0        # rotation that makes a torque vary [rad/s]


def leave_out_lost(time, signals, place):
    """Makes zeros nan that no gauge measured; lines on them. `place(k)`: where row k stands in its file."""
    lines = []
    for name in ("bit_depth", "hole_depth", "block_height", "hook_load"):
        if name not in signals:
            continue
        rows = hung_at_zero(signals) if name == "hook_load" else jumped_to_zero(time, signals[name], *((FAST, JUMP) if name == "block_height" else (2.0 * FAST, DEEP)))
        if len(rows):
            why = "while the block moves %g m of pipe or more" % PIPE if name == "hook_load" else "as no %s changes between rows" % ("block" if name == "block_height" else "depth")
            lines.append("%s: %d rows of exactly 0, %s, are no measurements (first: %s)" % (name, len(rows), why, place(rows[0])))
            signals[name][rows] = numpy.nan
    return lines


def spans(flags):
    """(first, last + 1) of each run of true ones."""
    edges = numpy.flatnonzero(numpy.diff(numpy.concatenate(([0], flags.astype(int), [0]))))
    return list(zip(edges[::2], edges[1::2]))


def jumped_to_zero(time, values, speed, jump):
    """Rows of exactly 0 to which and from which a value changes faster than it can."""
    known = numpy.flatnonzero(numpy.isfinite(values))
    at, there, found = time[known], values[known], []
    for begin, end in spans(there == 0.0):
        sides = [(abs(there[beside]), abs(at[row] - at[beside])) for row, beside in ((begin, begin - 1), (end - 1, end)) if 0 <= beside < len(known)]
        if sides and all(change > jump and change > speed * step + (jump if speed > FAST else 0.0) for change, step in sides):
            found += list(known[begin:end])
    return numpy.array(found, int)


def way_of_string(signals):
    """From row to row, of a block that moves the string [m]; 0 where it does not, or that is not known."""
    if "bit_depth" not in signals or "block_height" not in signals:
        return numpy.zeros(max(len(signals["time"]) - 1, 0))
    block, bit = (numpy.nan_to_num(numpy.diff(signals[name])) for name in ("block_height", "bit_depth"))
    return numpy.where((numpy.abs(block) > MOVES) & (numpy.abs(block + bit) <= TOGETHER * numpy.abs(block)), block, 0.0)


def hung_at_zero(signals):
    """Rows with a hook load of exactly 0 while the block moves the string, and those on end before and after it until the block moves by itself: one row may be that in which
    the slips are pulled."""
    load, way = signals["hook_load"], way_of_string(signals)
    if not way.any():
        return numpy.zeros(0, int)
    block, deep, found = numpy.abs(numpy.diff(signals["block_height"])), signals["bit_depth"] > PIPE, []
    for begin, end in spans((load == 0.0) & deep):
        steps = numpy.arange(begin, end - 1)
        bounds = [begin - 1, *steps[(block[steps] > MOVES) & (way[steps] == 0.0)], end - 1]
        for first, last in zip(bounds, bounds[1:]):
            inside = way[first + 1:last]
            if (inside != 0.0).sum() >= LEAST_HUNG and numpy.abs(inside).sum() >= JUMP:
                found += list(range(first + 1, last + 1))
    return numpy.array(found, int)


def unlikely_values(time, signals, place):
    """Lines on values that may be right, but are those of a gauge that hangs or of a wrong digit."""
    return held(time, signals, place) + single(signals, place)


def held(time, signals, place):
    """Of the hook load while the string moves, and of the torque while it turns as well. How often a value comes again by itself, the other rows show."""
    lines, way = [], way_of_string(signals)
    turns = numpy.abs(numpy.nan_to_num(signals["top_drive_speed"])) > TURNING if "top_drive_speed" in signals else numpy.zeros(len(time), bool)
    for name, moving in (("hook_load", way != 0.0), ("torque", (way != 0.0) & turns[1:] & turns[:-1])):
        if name not in signals or not moving.any():
            continue
        values = signals[name]
        again = (numpy.diff(values) == 0.0) & (values[1:] != 0.0)
        for begin, end in spans(again):
            inside = numpy.arange(begin, end)[moving[begin:end]]
            others = moving.copy()
            others[begin:end] = False
            usual = (1.0 + again[others].sum()) / (2.0 + others.sum())  # Laplace's rule
            if len(inside) >= HELD[1] and time[end] - time[begin] >= HELD[0] and numpy.abs(way[inside]).sum() >= LEAST_WAY and usual**len(inside) < CHANCE:
                lines.append("%s: it is the same to the last digit in %d rows, over %.4g s in which the string moves %.3g m (first: %s); check its gauge" %
                             (name, end - begin + 1, time[end] - time[begin], numpy.abs(way[inside]).sum(), place(begin)))
    return lines


def single(signals, place):
    """On values far above both neighbours, which are alike, and above all others."""
    lines = []
    for name in SINGLE:
        sizes = numpy.abs(signals.get(name, numpy.zeros(0)))
        known = numpy.flatnonzero(numpy.isfinite(sizes))
        there = sizes[known]
        if len(there) < 8 or name == "hook_load" and not way_of_string(signals).any():  # it may hang in the slips, but for a pull
            continue
        before, middle, after = there[:-2], there[1:-1], there[2:]
        lone = 1 + numpy.flatnonzero((middle > TIMES * numpy.maximum(before, after)) & (numpy.abs(before - after) <= LIKE * numpy.maximum(before, after)) & (numpy.minimum(before, after) > 0.0))
        others = numpy.delete(there, lone).max()
        far = lone[there[lone] > BEYOND * others]
        if len(far):
            lines.append("%s: %d single values are %.3g times as large as the rows beside them or more (first: %s); check their digits" %
                         (name, len(far), (there[far] / numpy.maximum(there[far - 1], there[far + 1])).min(), place(known[far[0]])))
    return lines
