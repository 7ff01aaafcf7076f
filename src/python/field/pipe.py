# SPDX-License-Identifier: BSD-3-Clause
"""Where in a record pipe was added or taken away: the bit stands while the block goes its own way."""
import numpy
from drill_rig_sim.field.record import RecordError, long_step

AWAY = 0.5    # so much that bit and block together are off where they were: pipe was added or taken away, or the block was moved without the string [m]
DRIFTS = 2.0 * AWAY  # below that bit and block creep and drift apart: no pipe is so short [m]
STILL = 0.05  # by which the bit moves in the slips, or its gauge [m]
FASTEST = 1.0  # mean speed of a block that goes away and comes back between two rows [m/s]
SCALED = 0.2, 0.05  # way of the block over which its way and the bit's are compared: at least so much [m], and this share of all
ALIKE, UNLIKE, LEAST_WAYS = 0.1, 2.0, 4  # share by which these ratios may differ, ratio from which on a unit is wrong, ways that show it
PIPE = 5.0    # way of the block without the string that is a connection [m]
HANGS = 0.5   # share of the usual hook load below which the string is taken to hang in the slips


class Standstill:
    """Rows `begin` to `end`, both within: the bit stands, and the block goes its own way between rows `left` and `back`. `length`: of the pipe that was added,
    < 0: taken away, about 0: none [m]."""

    def __init__(self, begin, end, left, back, length):
        self.begin, self.end, self.left, self.back, self.length = begin, end, left, back, length

    def connection(self, joint):
        """What was done, as fields of MakeConnection for joints of a length [m]; None: nothing. ValueError where that is no whole number of them."""
        if abs(self.length) < AWAY:
            return None
        joints = round(abs(self.length) / joint)
        if joints < 1 or abs(abs(self.length) - joints * joint) > 0.1 * abs(self.length):
            raise ValueError("%.2f m of pipe were %s; needed: whole joints of the scene's last part (joint_length %g m)" %
                             (abs(self.length), "added" if self.length > 0.0 else "taken away", joint))
        return {"joints": joints, "remove": self.length < 0.0}


class Slip:
    """Of the depth tracking, at a row: the bit depth changed by `length` [m], the block did not."""

    def __init__(self, row, length):
        self.row, self.length = row, length


def standstills(record, in_parts=False):
    """All of a record, in their order; none where it has not both bit_depth and block_height. RecordError where the bit jumps. `in_parts`: what was done in a gap need
    not be known."""
    return [found for found in pipe_events(record, in_parts) if isinstance(found, Standstill)]


def pipe_events(record, in_parts=False):
    """Standstills and Slips of a record, in their order."""
    if "bit_depth" not in record or "block_height" not in record:
        return []
    bit, block = (record.at(signal, record.time) for signal in ("bit_depth", "block_height"))
    both, found, k, level = bit + block, [], 0, bit[0] + block[0]
    while k < len(both):
        if abs(both[k] - level) < AWAY:
            k += 1
            continue
        here = abs(bit - bit[k]) < STILL
        begin, end = k - run(here[:k][::-1]), k + run(here[k:]) - 1
        slip = begin == k and slipped(record, bit, block, k)
        if begin == k and not slip and abs(bit[k] - bit[k - 1]) > AWAY:
            gap = record.time[k] - record.time[k - 1]
            in_gap = gap > long_step(record.time)
            if not (in_parts and in_gap):
                raise RecordError("%s: at %.1f s bit_depth jumps by %.2f m%s" % (
                    record.name, clock(record, k), bit[k] - bit[k - 1], ", in a gap of %.0f s in which pipe was moved, added or removed; needed: a part of the record before or after it" % gap
                    if in_gap else "; needed: constant bit_depth while pipe is added or removed"))
            k, level = k + 1, both[k]
            continue
        begin = min(begin, k - 1)
        inside = numpy.arange(begin, end + 1)
        if slip or numpy.ptp(both[inside]) < DRIFTS:
            found.append(Slip(k, both[k] - level))
            k, level = k + 1, both[k]
            continue
        left = inside[numpy.abs(both[inside] - level) < AWAY][-1]
        back = inside[numpy.abs(both[inside] - both[end]) >= AWAY][-1] + 1
        found.append(Standstill(begin, end, left, max(left, back), both[end] - level))
        k, level = end + 1, both[end]
    return found


def check_directions(record):
    """RecordError where the bit's depth is negative, or where the bit moves up and down with the block: of one the sign is wrong, or the columns are."""
    if "bit_depth" not in record:
        return
    usual = float(numpy.nanmedian(record.signals["bit_depth"]))
    if usual < 0.0:
        raise RecordError("%s: bit_depth is negative, %.2f m in the median; needed: measured depth downwards from the rotary table" % (record.name, usual))
    if "block_height" not in record:
        return
    bit, block = (numpy.diff(record.at(signal, record.time)) for signal in ("bit_depth", "block_height"))
    with_block, against = (numpy.abs(block[numpy.abs(bit - sign * block) < 0.2 * numpy.abs(block)]).sum() for sign in (1.0, -1.0))
    if with_block > max(AWAY, 2.0 * against):
        raise RecordError("%s: bit_depth rises and falls with block_height, by %.2f m in all; needed: block_height upwards, bit_depth downwards" %
                          (record.name, with_block))


def check_scale(record):
    """RecordError where the block moves a constant multiple of the bit's way, by which the unit of one must be wrong."""
    if "bit_depth" not in record or "block_height" not in record:
        return
    bit, block = (record.at(signal, record.time) for signal in ("bit_depth", "block_height"))
    rows = [0]
    least = max(SCALED[0], SCALED[1] * numpy.ptp(block))
    for k, height in enumerate(block):
        if abs(height - block[rows[-1]]) >= least:
            rows.append(k)
    ways, went = numpy.abs(numpy.diff(block[rows])), numpy.abs(numpy.diff(bit[rows]))
    together = went > ALIKE**2 * ways
    if together.sum() < LEAST_WAYS:
        return
    ratios = ways[together] / went[together]
    usual = float(numpy.median(ratios))
    if max(usual, 1.0 / usual) > UNLIKE and (numpy.abs(ratios - usual) <= ALIKE * usual).mean() > 1.0 - 2.0 * ALIKE:
        raise RecordError("%s: block_height changes by %.3g m for each metre of bit_depth; needed: equal changes; are both units right?" % (record.name, usual))


def check_connections(record):
    """RecordError where a record without the bit's depth has connections: the block would be taken to move the string when it runs empty."""
    if "bit_depth" in record or not {"block_height", "hook_load"} <= set(record.signals):
        return
    height, load = (record.at(signal, record.time) for signal in ("block_height", "hook_load"))
    empty = load < HANGS * numpy.median(load)
    way = numpy.abs(numpy.diff(height)) * (empty[1:] & empty[:-1])
    if way.sum() > PIPE:
        raise RecordError("%s: has no bit_depth, and the block moves by %.1f m with less than half of the usual hook load (first: at %.1f s), as in connections; needed: "
                          "bit_depth, or a part of the record without connections" % (record.name, way.sum(), clock(record, int(numpy.argmax(way > 0.0)))))


def slipped(record, bit, block, k):
    """Whether the bit depth changes at a row as neither the block does nor pipe that is added in so short a time."""
    moved, jumped = abs(block[k] - block[k - 1]), abs(bit[k] - bit[k - 1])
    if jumped < AWAY:
        return True  # little by little
    return moved < STILL and 2.0 * jumped > FASTEST * (record.time[k] - record.time[k - 1])


def clock(record, row):
    """The time of a row in the file [s], of which the record may be a part."""
    return record.signals["time"][row]


def first_hung(record):
    """The first row from which on the string moves with the block, where the record begins with the string in the slips; else 0."""
    events = pipe_events(record)
    first = events[0] if events and isinstance(events[0], Standstill) else None
    if first is not None and first.left == 0 and first.end < len(record.time) - 1:
        return first.end
    if "bit_depth" not in record or "hook_load" not in record:
        return 0
    loads, bit = (record.at(signal, record.time) for signal in ("hook_load", "bit_depth"))
    slack = run(loads < HANGS * numpy.median(loads))
    return slack if 0 < slack < len(loads) - 1 and numpy.ptp(bit[:slack + 1]) < STILL else 0


def run(flags):
    """How many are true from the first on."""
    false = numpy.flatnonzero(~flags)
    return int(false[0]) if len(false) else len(flags)


def compared(record, signals, stands):
    """What was recorded of signals, by name; not a number where the bit stands while the block goes its own way: the simulated crew takes another time for that."""
    left_out = numpy.zeros(len(record.time), bool)
    for still in stands:
        left_out[still.begin:still.end + 1] = True
    return {name: numpy.where(left_out, numpy.nan, record.signals[name]) for name in signals}


def height_without_pipe(record, stands):
    """The height by the rows that a block would have which had never been moved without the string [m]."""
    height = record.at("block_height", record.time)
    change = numpy.diff(height)
    for still in stands:
        change[still.begin:still.end] = -numpy.diff(record.at("bit_depth", record.time)[still.begin:still.end + 1])
    return numpy.concatenate((height[:1], height[0] + numpy.cumsum(change)))
