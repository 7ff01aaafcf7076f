# SPDX-License-Identifier: BSD-3-Clause
"""The package's autodriller for a program that is no page: the driller's console. The orders are those of a page (start_law, set_law, stop_law, connect, alive) and leave_block,
a line of JSON each on standard input; the answers and the law's status go as such lines to standard output. When the input ends, the law stops and
the brake is set.

    python3 -m drill_rig_sim.web.law_process NAMESPACE
"""
import json
import os
import queue
import sys
import threading
import time

PERIOD = 0.1   # between looks at orders and rig [s]
SENDING = 0.3  # that rospy's threads take to send the last messages [s]
PATIENCE = 10  # until a rig's messages are received, whose parts a law needs [s]
END = object()


def read_orders(orders):
    """In a thread: the lines of standard input, then END."""
    for line in sys.stdin:
        orders.put(line)
    orders.put(END)


def write(message):
    print(json.dumps(message), flush=True)


class LawProcess:
    """`source`: NodeSource. Takes orders as Orders does of a page."""

    def __init__(self, source, hands_of):
        self.source, self.scene, self.parts, self.shown = source, [], [], None
        self.hands = hands_of(source, lambda: self.scene, parts=lambda: self.parts)
        self.kinds = {"start_law": self.hands.start_law, "set_law": self.hands.set_law, "stop_law": self.hands.stop_law, "connect": self.hands.connect, "alive": self.hands.alive,
                      "leave_block": self.leave_block}

    def look(self):
        """Takes what the rig has published."""
        from drill_rig_sim.web import shapes
        latest = self.source.poll().latest
        if "scene" in latest:
            self.scene = shapes.parts_of_scene(latest["scene"].data)
        if "description" in latest:
            self.parts = shapes.parts_of(latest["description"])

    def take(self, line):
        """Does an order; what is to be said to who gave it, or ""."""
        from drill_rig_sim.lockstep import Refused
        try:
            order = json.loads(line)
        except ValueError:
            return "no JSON object"
        if not isinstance(order, dict) or order.get("type") not in self.kinds:
            return "unknown command"
        try:
            return self.kinds[order["type"]](None, order)
        except Refused as refusal:
            return str(refusal)

    def leave_block(self, *_):
        """Somebody else moves the block: the law stops, and only the top drive goes on as it turned."""
        self.hands.law.stop()
        self.hands.tick()
        self.hands.streams.drop("winch")
        return ""

    def report(self):
        """Messages of this period: the law's where it has changed, and answers."""
        messages = self.hands.tick()
        law = [message for message in messages if message["type"] == "law" and message != self.shown]
        self.shown = law[-1] if law else self.shown
        return law + [message for message in messages if message["type"] == "answer"]


def run(process):
    orders = queue.Queue()
    threading.Thread(target=read_orders, args=(orders,), daemon=True).start()
    begin = time.monotonic()
    while not process.parts and time.monotonic() < begin + PATIENCE:
        process.look()
        time.sleep(PERIOD)
    while True:
        process.look()
        while not orders.empty():
            line = orders.get()
            if line is END:
                process.hands.law.stop()
                process.hands.tick()
                time.sleep(SENDING)
                return
            answer = process.take(line)
            if answer:
                write({"type": "answer", "text": answer})
        for message in process.report():
            write(message)
        time.sleep(PERIOD)


def main(words):
    os.environ["ROS_NAMESPACE"] = "/" + words[0].strip("/")  # before rospy is imported
    from drill_rig_sim.web.hands import Hands
    from drill_rig_sim.web.node_source import NodeSource
    source = NodeSource(words[0].strip("/"), "autodriller")
    process = LawProcess(source, Hands)
    source.start()
    run(process)


if __name__ == "__main__":
    main(sys.argv[1:])
