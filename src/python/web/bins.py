# SPDX-License-Identifier: BSD-3-Clause
"""Signals in equal steps of time or depth: least, mean and largest value of each step. No peak is lost, however much a run is condensed."""
import numpy


class Bins:
    """`names`: of the signals. `width`: of a step; it doubles where there would be more than `most` steps. Keys must not go back."""

    def __init__(self, names, width, most=4096):
        self.names, self.width, self.most = tuple(names), width, most
        self.first = None                         # number of the first step: its key over the width
        self.low = self.high = self.sum = self.count = numpy.empty((0, len(self.names)))
        self.changed, self.is_new = 0, True       # first row that has changed since the last change() was asked for; all are new

    def add(self, keys, columns):
        """`columns`: by the names, an array each; nan counts as no value."""
        if not len(keys):
            return
        values = numpy.column_stack([columns[name] for name in self.names]).astype(float)
        steps = numpy.floor(numpy.asarray(keys) / self.width).astype(int)
        if self.first is None:
            self.first = int(steps[0])
        while steps[-1] - self.first >= self.most:
            self._double()
            steps = numpy.floor(numpy.asarray(keys) / self.width).astype(int)
        self._extend(int(steps[-1]) - self.first + 1)
        starts = numpy.flatnonzero(numpy.diff(steps, prepend=steps[0] - 1))
        self._put(numpy.maximum(steps[starts] - self.first, 0), starts, values)

    def _put(self, rows, starts, values):
        known = numpy.isfinite(values)
        self.low[rows] = numpy.fmin(self.low[rows], numpy.fmin.reduceat(values, starts, axis=0))
        self.high[rows] = numpy.fmax(self.high[rows], numpy.fmax.reduceat(values, starts, axis=0))
        self.sum[rows] += numpy.add.reduceat(numpy.where(known, values, 0.0), starts, axis=0)
        self.count[rows] += numpy.add.reduceat(known.astype(float), starts, axis=0)
        self.changed = min(self.changed, int(rows[0]))

    def _extend(self, rows):
        more = rows - len(self.low)
        if more <= 0:
            return
        empty, zero = numpy.full((more, len(self.names)), numpy.nan), numpy.zeros((more, len(self.names)))
        self.changed = min(self.changed, len(self.low))
        self.low, self.high = numpy.vstack([self.low, empty]), numpy.vstack([self.high, empty])
        self.sum, self.count = numpy.vstack([self.sum, zero]), numpy.vstack([self.count, zero])

    def _double(self):
        """Each two steps become one."""
        if self.first % 2:
            self.low, self.high, self.sum, self.count = (numpy.vstack([numpy.full((1, len(self.names)), filler), table]) for filler, table in (
                (numpy.nan, self.low), (numpy.nan, self.high), (0.0, self.sum), (0.0, self.count)))
        pairs = numpy.arange(0, len(self.low), 2)
        if len(pairs):
            self.low, self.high = numpy.fmin.reduceat(self.low, pairs, axis=0), numpy.fmax.reduceat(self.high, pairs, axis=0)
            self.sum, self.count = numpy.add.reduceat(self.sum, pairs, axis=0), numpy.add.reduceat(self.count, pairs, axis=0)
        self.first, self.width, self.is_new = self.first // 2, 2.0 * self.width, True

    def times(self):
        """The middle of each step."""
        return (self.first + 0.5 + numpy.arange(len(self.low))) * self.width

    def forget(self, key):
        """All steps before a key; for a log that no page is sent."""
        rows = min(max(int(key // self.width) - self.first, 0), len(self.low))
        self.low, self.high, self.sum, self.count = (table[rows:] for table in (self.low, self.high, self.sum, self.count))
        self.first += rows

    def mean(self):
        with numpy.errstate(invalid="ignore", divide="ignore"):
            return self.sum / self.count

    def change(self, whole=False):
        """What has changed since the last time, or the whole, as the page takes it: {width, from, new, signals: {name: [low, mean, high]}}; None for
        nothing."""
        whole = whole or self.is_new
        begin = 0 if whole else self.changed
        if self.first is None or begin >= len(self.low):
            return None
        mean = self.mean()
        self.changed, self.is_new = len(self.low), False
        signals = {name: [numbers(table[begin:, n]) for table in (self.low, mean, self.high)] for n, name in enumerate(self.names)}
        return {"width": self.width, "from": self.first + begin, "new": whole, "signals": signals}


def numbers(values):
    """For JSON: six digits, None where there is no value."""
    return [float("%.6g" % value) if value == value and abs(value) != numpy.inf else None for value in numpy.asarray(values, dtype=float).tolist()]
