# SPDX-License-Identifier: BSD-3-Clause
"""A run as the page has it, made of the messages of rig_state as they come: logs by time and depth, alarms, activity, the present state."""
import math

import numpy
from drill_rig_sim.web.activity import Activity
from drill_rig_sim.web.alarms import Alarms
from drill_rig_sim.web.bins import Bins
from drill_rig_sim.web.fields import ACCURACY, DEPTH_TRACKS, NAMES, SEEN, SENSED, UNSENSED, columns_of
from drill_rig_sim.web.news import STATE_KIND, TRUTH_KIND
from drill_rig_sim.web.packed import Packed
from drill_rig_sim.web.weights import Weights

TIME_STEP, DEPTH_STEP = 0.25, 0.1   # of the logs at first [s], [m]
DRILLS = 5e-5                       # rate of penetration from which on MSE means something [m/s]
ROP_OVER = 10.0                     # over which the reading of the rate of penetration is a mean [s]


class RunLog:
    """`run`: number of the run; a new one begins where time goes back or `epoch` changes. `bit_diameter` [m], for MSE; None: not known."""

    def __init__(self):
        self.packed, self.packed_truth = Packed(STATE_KIND, SEEN), Packed(TRUTH_KIND, UNSENSED)
        self.run, self.bit_diameter = 0, None
        self.begin()

    def begin(self):
        self.run += 1
        self.time, self.depth = Bins(NAMES, TIME_STEP), Bins([name for name, _ in DEPTH_TRACKS], DEPTH_STEP)
        self.alarms, self.activity, self.weights = Alarms(), Activity(), Weights()
        self.last, self.flags, self.truth_flags = None, [], []
        self.idle_at = -math.inf  # when nothing was drilled last [s]
        self.extremes = None  # of each signal since take_state() was asked for last: least, largest

    def take(self, messages):
        """Of rig_state, as bytes, in the order of their coming."""
        self.take_rows(self.packed.rows(messages))

    def take_rows(self, rows):
        """The same as Packed.rows() gives them."""
        anew = (numpy.diff(rows["stamp"]) < 0.0) | (numpy.diff(rows["epoch"].astype(int)) != 0)
        for part in numpy.split(rows, numpy.flatnonzero(anew) + 1):
            if self.last is not None and (part["stamp"][0] < self.last["stamp"] or part["epoch"][0] != self.last["epoch"]):
                self.begin()
            self._take_part(part)

    def _take_part(self, rows):
        columns = columns_of(rows)
        self.time.add(rows["stamp"], columns)
        self.weights.add(rows["stamp"], columns)
        self._take_depths(rows, columns)
        self.alarms.take(rows["stamp"], rows, SENSED)
        self.activity.take(rows)
        self.flags = [flag for flag in (*SENSED, ACCURACY, "in_slips", "brake_set") if rows[flag][-1]]
        table = numpy.column_stack([columns[name] for name in NAMES])
        least, largest = numpy.fmin.reduce(table), numpy.fmax.reduce(table)
        if self.extremes is not None:
            least, largest = numpy.fmin(self.extremes[0], least), numpy.fmax(self.extremes[1], largest)
        self.extremes, self.last, self.values = (least, largest), rows[-1], table[-1]

    def _take_depths(self, rows, columns):
        """Into the depth log: what was seen while the hole became deeper."""
        before = rows["hole_depth"][0] if self.last is None else self.last["hole_depth"]
        deeper = numpy.diff(rows["hole_depth"], prepend=before) > 0.0
        kept = {name: columns[name][deeper] for name, _ in DEPTH_TRACKS if name in columns}
        columns = {**columns, "rop": numpy.where(self._drills_steadily(rows), columns["rop"], numpy.nan)}
        kept["mse"] = self.specific_energy({name: columns[name][deeper] for name in ("wob", "torque", "rpm", "rop")})
        self.depth.add(rows["hole_depth"][deeper], kept)

    def _drills_steadily(self, rows):
        """Whether the reading of the rate of penetration is only that of drilling: at first it is too small, and MSE by it far too large."""
        idle_at = numpy.maximum.accumulate(numpy.where(rows["rop"] > DRILLS, -math.inf, rows["stamp"]))
        idle_at = numpy.maximum(idle_at, self.idle_at)
        self.idle_at = idle_at[-1]
        return rows["stamp"] - idle_at > ROP_OVER

    def specific_energy(self, columns):
        """By what the surface shows (Teale, 1965), without a motor's share [Pa]; nan where nothing is drilled."""
        if self.bit_diameter is None:
            return numpy.full(len(columns["rop"]), numpy.nan)
        area = 0.25 * math.pi * self.bit_diameter**2
        rop = numpy.where(columns["rop"] > DRILLS, columns["rop"], numpy.nan)
        return (columns["wob"] + columns["torque"] * columns["rpm"] / rop) / area

    def take_truth(self, messages):
        """Of truth/rig_state, as bytes: the flags that no rig can sense."""
        rows = self.packed_truth.rows(messages)
        if self.last is not None and rows["stamp"][-1] >= self.last["stamp"] - 60.0:
            self.alarms.take(rows["stamp"], rows, UNSENSED)
            self.truth_flags = [flag for flag in UNSENSED if rows[flag][-1]]

    def take_state(self):
        """The present values and their extremes since the last time: {t, run, run_state, flags, values: {name: [last, least, largest]}}; None before
        the first message."""
        if self.last is None:
            return None
        least, largest = (self.values, self.values) if self.extremes is None else self.extremes
        self.extremes = None
        return {"t": float(self.last["stamp"]), "run": self.run, "flags": self.flags + self.truth_flags, "run_state": int(self.last["run_state"]),
                "values": {name: [shown(v) for v in (self.values[n], least[n], largest[n])] for n, name in enumerate(NAMES)}}


def shown(value):
    return float("%.7g" % value) if math.isfinite(value) else None
