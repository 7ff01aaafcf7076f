# SPDX-License-Identifier: BSD-3-Clause
"""Values of a record that no gauge measured: zeros of a gauge that was lost, the same value while the string moves, a single value far above all others."""
import numpy
from drill_rig_sim.field.signals import si_unit
from drill_rig_sim.spans import spans

FAST = 2.5           # speed at which a block does not go to 0 and come back from there between rows [m/s]
JUMP = 1.0           # and so far it has to go [m]
NOTHING = (0.0, 1.0, -1.0, -0.5, 1e-4)  # that files write for no number, at their begin or end too [m]
DEEP = 10.0          # by which a depth jumps more than the fastest block moves it [m]
TOGETHER = 0.2, 0.1  # share of the block's way by which the bit's may differ, where the block moves the string, and what gauges add to that [m]
HANGS = 0.6          # of the largest hook load, with which a string hangs on the hook
APART = 0.3          # of bit and block, from which on the block has moved by itself [m]
PIPE = 50.0          # of pipe in the hole has a weight that no gauge shows as 0 [m]
NO_WEIGHT = 3.0      # of a metre of pipe in a fluid, a tenth of the lightest [N/m]
DRILLED = 0.05       # by which a hole gets deeper under a string that hangs on the hook [m]
LEAST_WAY, LEAST_STEPS = 0.5, 3  # of a moving string [m], and rows
HELD = 60.0, 10      # time and rows over which a value is the same [s]
LONGER, CHANCE = 5, 1e-9  # than the next longest of such times; that a gauge with this resolution shows one value so often
TIMES, BEYOND = 3.0, 1.5  # of a single value over its neighbours, and over the largest of all others
LIKE = 0.3           # share by which its neighbours may differ
SINGLE = ("hook_load", "torque", "stand_pipe_pressure", "flow", "top_drive_speed")
TURNING = 3.0        # rotation that makes a torque vary [rad/s]


def leave_out_lost(time, signals, place):
    """Makes zeros nan that no gauge measured; lines on them. `place(k)`: where row k stands in its file."""
    return [line for name, rows_of, why in (
        ("bit_depth", lambda: jumped_to_nothing(time, signals["bit_depth"], 2.0 * FAST, DEEP), "to which no bit goes between rows"),
        ("hole_depth", lambda: jumped_to_nothing(time, signals["hole_depth"], 2.0 * FAST, DEEP), "to which no hole goes between rows"),
        ("block_height", lambda: jumped_to_nothing(time, signals["block_height"], FAST, 0.0, without_string(signals)), "to which no block goes between rows"),
        ("hook_load", lambda: hung_at_nothing(signals), "while the block moves the string")) if name in signals for line in left_out(signals, name, rows_of(), why, place)]


def left_out(signals, name, rows, why, place):
    """Makes the rows of a signal nan; a line on them for each value."""
    there = signals[name][rows]
    signals[name][rows] = numpy.nan
    return ["%s: %d rows of exactly %s, %s, are no measurements (first: %s)" %
            (name, (there == value).sum(), "%.6g %s" % (value, si_unit(name)) if value else "0", why, place(rows[there == value][0])) for value in dict.fromkeys(there)]


def same(values, suits):
    """(begin, end) of rows that suit and hold one value."""
    found = []
    for begin, end in spans(suits):
        edges = [begin, *(begin + 1 + numpy.flatnonzero(numpy.diff(values[begin:end]))), end]
        found += zip(edges, edges[1:])
    return found


def jumped_to_nothing(time, values, speed, beyond, cannot=lambda row, beside: False):
    """Rows of one value near 0, as files write for none (0, 1, -0.5), to which and from which a signal changes faster than it can: by JUMP, and either `cannot` or at a
    speed, and so much `beyond` that [m]."""
    known = numpy.flatnonzero(numpy.isfinite(values))
    at, there, found = time[known], values[known], []
    for begin, end in same(there, numpy.abs(there) <= JUMP):
        sides = [(row, beside) for row, beside in ((begin, begin - 1), (end - 1, end)) if 0 <= beside < len(known)]
        ways = [(abs(there[beside] - there[row]), speed * abs(at[row] - at[beside]) + beyond, row, beside) for row, beside in sides]
        if (len(ways) == 2 or ways and there[begin] in NOTHING) and all(way > JUMP and (way > most or cannot(known[row], known[beside])) for way, most, row, beside in ways):
            found += list(known[begin:end])
    return numpy.array(found, int)


def without_string(signals):
    """Whether a block that goes from one row to another leaves a bit where it is that hangs on it, by the hook load."""
    if "bit_depth" not in signals or "hook_load" not in signals:
        return lambda row, beside: False
    bit, load, block = signals["bit_depth"], signals["hook_load"], signals["block_height"]
    hung = HANGS * numpy.nanmax(load) if numpy.isfinite(load).any() else numpy.inf
    return lambda row, beside: bool(min(load[row], load[beside]) > hung and abs(bit[row] - bit[beside]) < TOGETHER[0] * abs(block[row] - block[beside]))


def way_of_string(signals):
    """From row to row, of a block that moves the string [m]; 0 where it does not, or that is not known."""
    if "bit_depth" not in signals or "block_height" not in signals:
        return numpy.zeros(max(len(signals["time"]) - 1, 0))
    block, bit = (numpy.nan_to_num(numpy.diff(signals[name])) for name in ("block_height", "bit_depth"))
    return numpy.where((numpy.abs(block + bit) <= TOGETHER[0] * numpy.abs(block)) | ((numpy.abs(block + bit) <= TOGETHER[1]) & (block * bit < 0.0)), block, 0.0)


def hung_at_nothing(signals):
    """Rows of one hook load of nothing while the block moves the string, and those on end before and after it until the block moves by itself: one row may be that in which
    the slips are pulled."""
    load, found = signals["hook_load"], []
    if "bit_depth" not in signals or "block_height" not in signals:
        return numpy.zeros(0, int)
    bit, block, hole = signals["bit_depth"], signals["block_height"], signals.get("hole_depth", numpy.zeros(len(load)))
    for begin, end in same(load, (load >= 0.0) & (load < NO_WEIGHT * bit) & (bit > PIPE) & numpy.isfinite(block)):
        while begin < end:
            last = begin + int(numpy.argmin(numpy.append(numpy.abs((bit + block)[begin:end] - bit[begin] - block[begin]) < APART, False)))
            there = block[begin:last]
            moved = numpy.ptp(there) >= LEAST_WAY or numpy.ptp(numpy.nan_to_num(hole[begin:last])) >= DRILLED
            if moved and (numpy.diff(there) != 0.0).sum() >= LEAST_STEPS:
                found += list(range(begin, last))
            begin = last
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
        again = spans((numpy.diff(values) == 0.0) & (values[1:] != 0.0))
        counts = numpy.array([moving[begin:end].sum() for begin, end in again])
        for (begin, end), count in zip(again, counts):
            usual = (1.0 + counts.sum() - count) / (2.0 + moving.sum() - count)  # Laplace's rule, by the other rows
            went = numpy.abs(way[begin:end]).sum()
            if count >= max(HELD[1], LONGER * numpy.append(counts[counts != count], 1).max()) and time[end] - time[begin] >= HELD[0] and went >= LEAST_WAY and usual**count < CHANCE:
                lines.append("%s: it is the same to the last digit in %d rows, over %.4g s in which the string moves %.3g m (first: %s); check its gauge" %
                             (name, end - begin + 1, time[end] - time[begin], went, place(begin)))
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
