# SPDX-License-Identifier: BSD-3-Clause
"""Alarms of a run: a red one stays until it is acknowledged, however short it was."""
import numpy
from drill_rig_sim.web.flags import FLAGS

AGAIN = 10.0  # one that comes back within this time is the same one [s]
MOST = 300    # are kept


class Alarms:
    """`entries`: dicts of number, flag, rank, text, from, to [s] (None while it lasts), times (how often it came) and acknowledged."""

    def __init__(self):
        self.entries, self._last, self.revision, self._next = [], {}, 0, 1

    def take(self, stamps, rows, flags):
        """Flags over a batch of rows, in order of time."""
        for flag in flags:
            on = rows[flag]
            if on.any():
                self._raise(flag, float(stamps[numpy.argmax(on)]), float(stamps[-1 - numpy.argmax(on[::-1])]), bool(on[-1]))
            elif flag in self._last and self._last[flag]["to"] is None:
                self._end(flag, float(stamps[0]))

    def _raise(self, flag, begin, end, lasts):
        entry = self._last.get(flag)
        if entry is None or (entry["to"] is not None and (begin > entry["to"] + AGAIN or (entry["acknowledged"] and entry["rank"] == "red"))):
            rank, text = FLAGS[flag]
            entry = {"number": self._next, "flag": flag, "rank": rank, "text": text, "from": begin, "to": begin, "times": 0,
                "acknowledged": rank != "red"}
            self._next += 1
            self.entries, self._last[flag] = [*self.entries[1 - MOST:], entry], entry
        if entry["to"] is not None:
            entry["times"] += 1
            self.revision += 1
        entry["to"] = None if lasts else end
        self.revision += not lasts

    def _end(self, flag, stamp):
        self._last[flag]["to"] = stamp
        self.revision += 1

    def acknowledge(self, number=None):
        """One, or all; False where there is no such."""
        found = [entry for entry in self.entries if number in (None, entry["number"]) and not entry["acknowledged"]]
        for entry in found:
            entry["acknowledged"] = True
        self.revision += bool(found)
        return bool(found)

    def shown(self):
        """What still lasts or is not acknowledged first, then the latest."""
        return sorted(self.entries, key=lambda entry: (entry["to"] is not None and entry["acknowledged"], -entry["number"]))
