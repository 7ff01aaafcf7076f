# SPDX-License-Identifier: BSD-3-Clause
"""What pages may ask for. Everybody may acknowledge alarms; the rig is commanded only where `drill web` was started with --control."""
import asyncio
import math

from drill_rig_sim.lockstep import Refused


class Orders:
    """`feed`: what pages are shown. `hands`: what commands the rig (hands.py), or None: read-only."""

    def __init__(self, feed, hands):
        self.feed, self.hands = feed, hands
        self.allowed = {"acknowledge": self.acknowledge, "broomstick": self.broomstick}
        self.moving = {} if hands is None else {"hold": hands.hold, "release": hands.release, "alive": hands.alive, "set": hands.set,
            "call": self.call, "connect": hands.connect,
                                                "start_law": hands.start_law, "set_law": hands.set_law, "stop_law": hands.stop_law}

    async def take(self, page, order):
        """Does it; what is to be said to the page, or ""."""
        kind = str(order.get("type"))
        if kind in self.allowed:
            return self.allowed[kind](order)
        if self.hands is None:
            return "read-only: start drill web with --control"
        if kind not in self.moving:
            return "unknown command: %s" % kind[:40]
        try:
            answer = self.moving[kind](page, order)
            return await answer if asyncio.iscoroutine(answer) else answer
        except Refused as refusal:
            return str(refusal)

    def acknowledge(self, order):
        number = order.get("number")
        return "" if self.feed.log.alarms.acknowledge(number) else "no such alarm"

    def broomstick(self, _):
        return self.feed.work_out()

    async def call(self, _, order):
        """A service of the rig, which may take its time."""
        return await asyncio.get_event_loop().run_in_executor(None, self.hands.call, str(order.get("service")), order.get("value"))

    def left(self, page):
        """The page was closed, or lost."""
        if self.hands is not None:
            self.hands.left(page)

    def tick(self):
        """With each period: messages for all pages."""
        return [] if self.hands is None else self.hands.tick()


def number_of(order, name, low, high):
    """A number of an order; Refused where it is none, or beyond the bounds."""
    value = order.get(name)
    if isinstance(value, bool) or not isinstance(value, (int, float)) or not math.isfinite(value) or not low <= value <= high:
        raise Refused("%s must be a number from %g to %g" % (name, low, high))
    return float(value)
