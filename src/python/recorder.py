# SPDX-License-Identifier: BSD-3-Clause
"""A run in the making as the time series that `drill run --csv` writes, by the truth on a rig's topics."""
import threading

import rospy
from drill_rig_sim.msg import BitTruth, RigTruth
from drill_rig_sim.score_runs import BIT, STATE, field

KEPT = 1000  # states whose bit has not arrived yet, or the other way round


class Recorder:
    """Rows of STATE and BIT in a file, one each `period` [simulated s]; a state is written once both its messages are there. An OSError where
    the file cannot be opened. Time that goes back or another epoch begins a new run, in the same file: drill score and drill plot take the last one."""

    def __init__(self, file, prefix="", period=0.1):
        self.period, self.last, self.waiting, self.latest, self.lock = period, None, {}, {}, threading.Lock()
        self.out = open(file, "w", encoding="utf-8")
        self.out.write(",".join(("time", *self.columns(), "epoch")) + "\n")
        self.subscribers = [rospy.Subscriber(prefix + "truth/rig_state", RigTruth, self.take, callback_args="state", queue_size=100),
                            rospy.Subscriber(prefix + "truth/bit", BitTruth, self.take, callback_args="bit", queue_size=100)]

    @staticmethod
    def columns():
        return list({**STATE, **BIT})

    def take(self, message, kind):
        with self.lock:
            stamp = message.header.stamp.to_nsec()
            if stamp < self.latest.get(kind, stamp):  # of the run before, what this topic still owes will not come
                self.waiting = {other: pair for other, pair in self.waiting.items() if kind not in pair}
            self.latest[kind] = stamp
            pair = self.waiting.setdefault(stamp, {})
            pair[kind] = message
            if len(pair) == 2:
                del self.waiting[stamp]
                self.write(1e-9 * stamp, pair["state"], pair["bit"])
            elif len(self.waiting) > KEPT:
                del self.waiting[min(self.waiting)]

    def write(self, now, state, bit):
        if self.out.closed or (self.last is not None and self.last <= now < self.last + self.period - 1e-6):
            return
        self.last = now
        row = [field(bit, BIT[name]) if name in BIT else field(state, STATE[name]) for name in self.columns()]
        self.out.write(",".join("%.9g" % value for value in (now, *row, state.epoch)) + "\n")

    def close(self):
        for subscriber in self.subscribers:
            subscriber.unregister()
        with self.lock:
            self.out.close()
