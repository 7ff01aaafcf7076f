# SPDX-License-Identifier: BSD-3-Clause
"""What the rig does over time: rotary drilling, slides, connections, trips, circulation; and the sheets that are made of it."""
import numpy

OTHER, ROTARY, SLIDE, CONNECTION, TRIP, CIRCULATE = range(6)
NAMES = ("other", "rotary", "slide", "connection", "trip", "circulate")
NEAR = 0.1        # of the bit to the bottom of the hole, that counts as on it [m]
TURNS = 0.5       # rotation from which on the hole is drilled rotary [rad/s]
FLOWS = 1e-3      # [m3/s]
MOVES = 0.02      # of the block off bottom [m/s]
DRILLS = 5e-5     # rate of penetration [m/s]
LASTS = 3.0       # a change counts once it has lasted so long [s]


def kinds_of(rows):
    """The activity of each row."""
    near = rows["bit_depth"] > rows["hole_depth"] - NEAR
    drills = near & (rows["rop"] > DRILLS)
    flows = ~(rows["flow"] <= FLOWS)  # a flow that is not known may be
    turns, moves = numpy.abs(rows["top_drive_speed"]) > TURNS, numpy.abs(rows["block_velocity"]) > MOVES
    return numpy.select([rows["in_slips"], drills & turns, drills & flows, ~near & moves, flows],
                        [CONNECTION, ROTARY, SLIDE, TRIP, CIRCULATE], OTHER)


class Activity:
    """`intervals`: dicts of kind, from, to [s], and at both ends depth_from, depth_to (of the hole [m]) and stands_from, stands_to (below 0: not
    known)."""

    def __init__(self):
        self.intervals, self._next = [], None  # _next: kind and begin of a change that has not lasted long enough yet

    def take(self, rows):
        kinds = kinds_of(rows)
        for begin in numpy.flatnonzero(numpy.diff(kinds, prepend=-1)):
            self._change(int(kinds[begin]), rows[begin])
        self._settle(rows[-1])

    def _change(self, kind, row):
        self._settle(row)
        if not self.intervals:
            self.intervals.append(interval(kind, row))
        elif NAMES[kind] == self.intervals[-1]["kind"]:
            self._next = None
        elif self._next is None or NAMES[kind] != self._next["kind"]:
            self._next = interval(kind, row)

    def _settle(self, row):
        """The present interval goes on to here, or the next one begins."""
        if self._next is not None and row["stamp"] - self._next["from"] >= LASTS:
            self.intervals.append(self._next)
            self._next = None
        if self.intervals and self._next is None:
            self.intervals[-1].update(to=float(row["stamp"]), depth_to=float(row["hole_depth"]), stands_to=int(row["stand_count"]))

    def connections(self):
        """Dicts of number, time, depth, in_slips and weight_to_weight [s] (None where it is not known yet). What takes pipe away is of a trip: no
        connection."""
        found = []
        for n, one in enumerate(self.intervals):
            if one["kind"] != "connection":
                continue
            before, after = self.drilling(reversed(self.intervals[:n])), self.drilling(self.intervals[n + 1:])
            if not (self.stands_after(n) > one["stands_from"] or (one["stands_from"] < 0 and before and after)):
                continue
            weight = after["from"] - before["to"] if before and after else None
            found.append({"number": len(found) + 1, "time": one["from"], "depth": one["depth_from"], "in_slips": one["to"] - one["from"],
                          "weight_to_weight": weight})
        return found

    def stands_after(self, n):
        return self.intervals[n + 1]["stands_to"] if n + 1 < len(self.intervals) else self.intervals[n]["stands_to"]

    @staticmethod
    def drilling(intervals):
        return next((one for one in intervals if one["kind"] in ("rotary", "slide")), None)

    def sheet(self, log):
        """Rows of the slide sheet: slides and rotary drilling by depth, with means of `log`, Bins by time. A row: kind, from, to, depth_from,
        depth_to, seconds and means."""
        rows = []
        for one in self.intervals:
            if one["kind"] not in ("rotary", "slide") or one["depth_to"] <= one["depth_from"]:
                continue
            if rows and rows[-1]["kind"] == one["kind"]:
                rows[-1].update(to=one["to"], depth_to=one["depth_to"], seconds=rows[-1]["seconds"] + one["to"] - one["from"])
            else:
                rows.append({**{name: one[name] for name in ("kind", "from", "to", "depth_from", "depth_to")}, "seconds": one["to"] - one["from"]})
        for row in rows:
            row["rop"] = (row["depth_to"] - row["depth_from"]) / row["seconds"] if row["seconds"] > 0.0 else None
            row.update(means(log, row["from"], row["to"], ("wob", "differential", "torque")))
        return rows


def interval(kind, row):
    stamp, depth, stands = float(row["stamp"]), float(row["hole_depth"]), int(row["stand_count"])
    return {"kind": NAMES[kind], "from": stamp, "to": stamp, "depth_from": depth, "depth_to": depth, "stands_from": stands, "stands_to": stands}


def means(log, begin, end, names):
    """Of Bins by time, between two times; None where there is no value."""
    rows = slice(max(int(begin / log.width) - log.first, 0), int(end / log.width) - log.first + 1)
    sums, counts = log.sum[rows].sum(axis=0), log.count[rows].sum(axis=0)
    return {name: float(sums[n] / counts[n]) if counts[n] > 0.0 else None for n, name in ((log.names.index(name), name) for name in names)}
