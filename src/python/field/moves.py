# SPDX-License-Identifier: BSD-3-Clause
"""Steady moves of a string off bottom in a record: pick-up, slack-off and rotating weights, those of a string that turns as it moves, and the empty block while the string is in the slips."""
import numpy
from drill_rig_sim.field.course import LOWER_HALF, Course, half_band, resolution
from drill_rig_sim.field.pipe import HANGS, check_directions, check_scale, clock, standstills
from drill_rig_sim.field.record import RecordError, long_step

MOVING = 0.02        # slowest block that counts as moving [m/s]
TURNING = 2.0        # slowest rotation that frees a string of friction along the hole [rad/s]
STILL = 0.5          # fastest rotation of a string that counts as not turned [rad/s]
EVEN = 0.15          # share by which the speed of a steady move may differ
TIMES = 3.0, 0.6     # deviations of the time of a row that are no change of speed; largest such deviation, of times rounded to 2 s [s]
STRAIGHT = 1.0       # by which the block of such rows may be early or late on its straight line [s]
UNEVEN = 0.6         # share by which the speed may differ at most, however uncertain the times are
OFF_BOTTOM = 2.0     # least height of the bit above bottom [m]
SPIKE = 5            # rows in a row of which the middle one counts as the depth of the hole
EMPTY = 0.95         # of the least load of a string, what the empty block may weigh
SETTLES = 10.0       # time from the start of a move in which waves decay [s]
STRETCH = 0.5, 1e-3  # way from a move's start until all of the string moves with the block: so much [m], and this share of the bit's depth
TWIST = 2.0, 3e-3    # turns from the start of rotation until all of the string turns: a number, and a number for each metre of depth
EMPTY_SETTLES = 2.0  # the same of the empty block [s]
CALM = 0.1           # share by which the load of the empty block may differ
SHORTEST = 5.0       # of a move that is averaged [s]
LEAST_ROWS = 4
VARIES = 3.0, 0.01   # of a load that is reported as uneven: this number of times the usual deviation, and this share of the load
MOVES = "pick_up", "slack_off", "rotating_up", "rotating_down"  # in which the block moves with the string
UNKNOWN = "rotating_unknown"  # after a gap that hides the last way of the block
STILL_BLOCK = 0.02    # change of height through a gap in which the block stood [m]
CLEAR = 0.5           # way of the block through a gap that shows how it came to where it is [m]
FLOWS = 1e-3          # flow from which on the pump counts as running [m3/s]


class Move:
    """`motion`: a column of the table that drill calibrate fits. Rows `begin` to `end` of the record, both within; mean `depth` and `block_height` [m], `load` [N], `torque` [N m] (None
    without a gauge), `speed` of the block [m/s], `rotation` [rad/s] and `flow` [m3/s]; `deviation` of the load from its straight line [N]."""

    def __init__(self, record, motion, rows, speeds):
        self.motion, self.begin, self.end, self.count = motion, int(rows[0]), int(rows[-1]), len(rows)
        self.from_time, self.to_time = clock(record, self.begin), clock(record, self.end)
        load = record.signals["hook_load"][rows]
        self.load, self.deviation = float(load.mean()), deviation(record.time[rows], load)
        self.depth, self.block_height, self.rotation, self.flow = (mean_of(record, signal, rows) for signal in ("bit_depth", "block_height", "top_drive_speed", "flow"))
        torque = record.signals["torque"][rows[0]:rows[-1] + 1] if "torque" in record else numpy.zeros(0)
        self.torque = float(numpy.nanmean(torque)) if numpy.isfinite(torque).any() else None
        self.speed = float(speeds[rows[0]:rows[-1]].mean())


    @property
    def empty(self):
        """Whether the block moved alone."""
        return self.motion.startswith("slips")

    @property
    def pumped(self):
        """Whether the flow of the pump is in the string's load."""
        return self.flow is not None and self.flow > FLOWS and not self.empty


def mean_of(record, signal, rows):
    """None where there is none; on straight lines between rows that were measured."""
    return float(record.at(signal, record.time[rows]).mean()) if signal in record and numpy.isfinite(record.signals[signal]).any() else None


def deviation(times, values):
    """Standard deviation from the straight line of least squares."""
    line = numpy.polyfit(times - times[0], values, 1)
    return float(numpy.std(values - numpy.polyval(line, times - times[0]), ddof=2))


def moves_of(record, passed=None):
    """All Moves of a record, in their order, and lines on those that cannot be. `passed`: rows that are left out. RecordError where the record lacks the signals for them."""
    for signal in ("block_height", "bit_depth", "hook_load"):
        if signal not in record:
            raise RecordError("%s: has no %s; needed: block_height, bit_depth and hook_load%s" % (record.name, signal, record.why_missing(signal)))
    check_directions(record)
    check_scale(record)
    height = record.at("block_height", record.time)
    speeds = numpy.diff(Course(record.time, height, half_band(height, height)).heights) / numpy.diff(record.time)
    stands = standstills(record, in_parts=True)
    kinds = kinds_of(record, speeds, stands)
    if passed is not None:
        kinds[passed[1:] | passed[:-1]] = ""
    unsure = TIMES[0] * time_scatter(record, speeds, kinds) / numpy.diff(record.time)
    every = runs(kinds, speeds, allowed(numpy.sqrt(6.0) * numpy.maximum(unsure[1:], unsure[:-1])))
    found = [move for begin, end in every for move in [steady_part(record, kinds[begin], speeds, begin, end, allowed(numpy.sqrt(2.0) * unsure[begin:end]))] if move is not None]
    known = [move for move in found if move.motion != UNKNOWN]
    left_out = [move for move in found if move.motion == UNKNOWN]
    lines = ["%s: %d moves are left out: in a gap before them the block moved by an unknown distance (first: rotating at %.1f s)" %
             (record.name, len(left_out), left_out[0].from_time)] if left_out else []
    moves, odd = plausible(record, known)
    return moves, lines + odd + not_found(record, kinds, found) + uneven(record, moves)


def not_found(record, kinds, found):
    """A line on each kind of weight that the record may have, but no steady move of it."""
    lines = []
    for name, motions in (("pick_up", ("pick_up",)), ("slack_off", ("slack_off",)), ("rotating weight", ("rotating_after_up", "rotating_after_down", UNKNOWN))):
        ways = [way for way in runs(numpy.where(numpy.isin(kinds, motions), name, ""), numpy.zeros(len(kinds)), numpy.ones(len(kinds) - 1))
                if record.time[way[1]] - record.time[way[0]] >= SETTLES]
        if ways and not any(move.motion in motions for move in found):
            begin, end = max(ways, key=lambda way: record.time[way[1]] - record.time[way[0]])
            lines.append("%s: no steady %s was found in %d moves, the longest of %.0f s from %.1f s on; needed after the start of a move: an even speed for %g s and %d rows "
                         "with a hook load" % (record.name, name, len(ways), record.time[end] - record.time[begin], clock(record, begin), SHORTEST, LEAST_ROWS))
    return lines


def uneven(record, moves):
    """A line on moves whose load varies much more than in the others: a string that rings or sticks and slips, of which rows apart show a few instants."""
    if not moves:
        return []
    usual = numpy.median([move.deviation for move in moves])
    some = [move for move in moves if move.deviation > max(VARIES[0] * usual, VARIES[1] * move.load)]
    return ["%s: the load of %d moves varies more than %g times as much as usual (first: %s at %.1f s: %.1f kN); their weights are uncertain by as much" %
            (record.name, len(some), VARIES[0], some[0].motion, some[0].from_time, 1e-3 * some[0].deviation)] if some else []


def plausible(record, moves):
    """Without loads that contradict the depths of bit and block, and lines on these."""
    hung = [move.load for move in moves if not move.empty]
    if not hung:
        return moves, []
    usual, least = numpy.median(hung), min(load for load in hung if load >= HANGS * numpy.median(hung))
    light = [move for move in moves if not move.empty and move.load < HANGS * usual]
    heavy = [move for move in moves if move.empty and move.load > EMPTY * least]
    lines = ["%s: %d moves are left out, %s (first: at %.1f s)" % (record.name, len(some), why, some[0].from_time) for some, why in (
        (light, "with less than half of the usual load: the bit's depth moves, but the string may be in the slips"),
        (heavy, "with the load of the string: the block moves, but the bit's depth does not change")) if some]
    return [move for move in moves if move not in light and move not in heavy], lines


def kinds_of(record, speeds, stands):
    """The motion of each interval between rows, "" where it is none that is weighed."""
    turning = numpy.abs(record.at("top_drive_speed", record.time)) if "top_drive_speed" in record else numpy.zeros(len(record.time))
    faster, slower = numpy.maximum(turning[1:], turning[:-1]), numpy.minimum(turning[1:], turning[:-1])
    hung = off_bottom(record)
    turned = hung & (slower > TURNING)
    kinds = numpy.full(len(speeds), "", dtype="U20")
    kinds[hung & (faster < STILL) & (speeds > MOVING)] = "pick_up"
    kinds[hung & (faster < STILL) & (speeds < -MOVING)] = "slack_off"
    kinds[turned & (speeds > MOVING)] = "rotating_up"
    kinds[turned & (speeds < -MOVING)] = "rotating_down"
    last = last_ways(record, speeds)
    for way, name in ((1, "rotating_after_up"), (-1, "rotating_after_down"), (numpy.inf, UNKNOWN)):
        kinds[turned & (numpy.abs(speeds) < MOVING) & (last == way)] = name
    for still in stands:
        kinds[still.begin:still.end] = ""
        away = numpy.arange(still.left, still.back)
        kinds[away[speeds[away] > MOVING]] = "slips_up"
        kinds[away[speeds[away] < -MOVING]] = "slips_down"
    return kinds


def off_bottom(record):
    """Of each interval: whether the bit is off bottom at both ends."""
    bit = record.at("bit_depth", record.time)
    hole = without_spikes(record.at("hole_depth", record.time)) if "hole_depth" in record else numpy.maximum.accumulate(without_spikes(bit))
    above = hole - bit > OFF_BOTTOM
    return above[1:] & above[:-1]


def without_spikes(values):
    """Each value's median with its neighbours'."""
    around = numpy.pad(values, SPIKE // 2, mode="edge")
    return numpy.median([around[place:len(around) - SPIKE + 1 + place] for place in range(SPIKE)], axis=0)


def last_ways(record, speeds):
    """Of each interval the sign of the last way of the block [-]: friction of rail and sheaves stays in the gauge as that left it. 0 before the first; inf after a gap
    through which the block moved, but not clearly one way."""
    steps, height = numpy.diff(record.time), record.at("block_height", record.time)
    changes = numpy.diff(height)
    seen = numpy.sign(changes) == numpy.sign(speeds)  # a smoothed trajectory goes on beside a gap where the gauge stands
    moved = numpy.where((numpy.abs(speeds) > MOVING) & seen, numpy.sign(speeds), 0.0)
    hidden = (steps > long_step(record.time)) & (numpy.abs(changes) > max(resolution(height), STILL_BLOCK))
    moved[hidden] = numpy.where(numpy.abs(changes[hidden]) >= CLEAR, numpy.sign(changes[hidden]), numpy.inf)
    places = numpy.maximum.accumulate(numpy.where(moved != 0.0, numpy.arange(len(speeds)), -1))
    return numpy.where(places >= 0, moved[places], 0.0)


def time_scatter(record, speeds, kinds):
    """Standard deviation of the times at which a display's values were taken from those of its rows, by the speed of a block that moves evenly in most rows [s]."""
    alike = (kinds[2:] == kinds[1:-1]) & (kinds[1:-1] == kinds[:-2]) & ((kinds[2:] == "pick_up") | (kinds[2:] == "slack_off"))
    three = numpy.array([speeds[:-2], speeds[1:-1], speeds[2:]])[:, alike]
    third = numpy.sort(numpy.abs(three[0] - 2.0 * three[1] + three[2]) / numpy.abs(three.mean(axis=0)))
    if len(third) < 8:
        return 0.0
    usual = float(third[:(len(third) + 1) // 2].mean()) / LOWER_HALF / numpy.sqrt(20.0)
    return min(usual * float(numpy.median(numpy.diff(record.time))), TIMES[1])


def allowed(unsure):
    """Share by which speeds may differ that are as uncertain by the times of their rows."""
    return numpy.clip(unsure, EVEN, UNEVEN)


def runs(kinds, speeds, most):
    """(first, last + 1) of the intervals of one motion in which the speed of a block that moves with the string does not change abruptly: by more than the share `most`."""
    fastest = numpy.maximum(numpy.abs(speeds[1:]), numpy.abs(speeds[:-1]))
    abrupt = (fastest > MOVING) & (numpy.abs(numpy.diff(speeds)) > most * fastest) & ~numpy.char.startswith(kinds[1:], "slips")
    bounds = [0, *(numpy.flatnonzero((kinds[1:] != kinds[:-1]) | abrupt) + 1), len(kinds)]
    return [(begin, end) for begin, end in zip(bounds, bounds[1:]) if kinds[begin]]


def steady_part(record, kind, speeds, begin, end, most):
    """A Move of the intervals begin to end - 1, without what comes before it is steady; None where too little is left. `most`: by interval, share by which its speed may differ."""
    rows = numpy.arange(begin, end + 1)
    rows = rows[settled(record, kind, speeds, rows)]
    measured = numpy.isfinite(record.signals["hook_load"])
    if kind.startswith("rotating") and len(rows) > 1:
        rows = even(rows, numpy.abs(record.at("top_drive_speed", record.time[rows[1:]])), EVEN)
    if kind in MOVES and len(rows) > 1:
        rows = even(rows, speeds[rows[0]:rows[-1]], most[rows[0] - begin:rows[-1] - begin])
        if most.max() > EVEN and len(rows) > LEAST_ROWS:  # the first and the last interval may hold a start and a stop
            rows = next((part for part in (rows, rows[:-1], rows[1:], rows[1:-1]) if is_straight(record.time[part], speeds[part[:-1]])), rows[:0])
        rows = rows[rows < end]  # the load of the last row may be that of the block at rest
    elif kind.startswith("slips") and len(rows):  # what accelerates the empty block is little, and none in the mean
        rows = rows[measured[rows]]
        load = record.signals["hook_load"][rows]
        rows = rows[numpy.abs(load - numpy.median(load)) <= CALM * abs(numpy.median(load))]  # not where it takes up the string
    rows = rows[measured[rows]]
    long_enough = len(rows) >= LEAST_ROWS and record.time[rows[-1]] - record.time[rows[0]] >= SHORTEST
    return Move(record, kind, rows, speeds) if long_enough else None


def settled(record, kind, speeds, rows):
    """Which rows of a move are not its start any more."""
    lasted = record.time[rows] - record.time[rows[0]]
    if kind.startswith("slips"):
        return lasted >= EMPTY_SETTLES
    depth = record.at("bit_depth", record.time[rows[0]])
    steady = lasted >= SETTLES
    if kind.startswith("rotating"):
        steady &= turns_of(record, rows) >= TWIST[0] + TWIST[1] * depth
    if kind not in MOVES:
        return steady
    way = numpy.abs(numpy.concatenate(([0.0], numpy.cumsum(speeds[rows[:-1]] * numpy.diff(record.time[rows])))))
    return steady & (way >= STRETCH[0] + STRETCH[1] * depth)


def even(rows, speeds, most):
    """The longest part of consecutive rows in which the speeds from row to row are the usual one, but for a share `most` of it."""
    usual = numpy.median(speeds)
    bounds = numpy.flatnonzero(numpy.concatenate(([True], numpy.abs(speeds - usual) > most * abs(usual), [True])))
    longest = int(numpy.diff(bounds).argmax())
    return rows[bounds[longest]:bounds[longest + 1]]


def is_straight(times, speeds):
    """Whether a block with these speeds between the times is never far from a straight line: the errors of times do not add up, as changes of the speed do."""
    heights = numpy.concatenate(([0.0], numpy.cumsum(speeds * numpy.diff(times))))
    line = numpy.polyfit(times - times[0], heights, 1)
    return bool(numpy.abs(heights - numpy.polyval(line, times - times[0])).max() <= STRAIGHT * abs(line[0]))


def turns_of(record, rows):
    """Of the top drive from the first row on."""
    turning = numpy.abs(record.at("top_drive_speed", record.time[rows]))
    return numpy.concatenate(([0.0], numpy.cumsum(0.5 * (turning[1:] + turning[:-1]) * numpy.diff(record.time[rows])))) / (2.0 * numpy.pi)
