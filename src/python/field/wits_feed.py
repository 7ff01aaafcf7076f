# SPDX-License-Identifier: BSD-3-Clause
"""A rig's stream of WITS level 0 (drill_rig_sim.wits0) as rows: date, time and items of each record 01."""
import math
import re
import socket
from datetime import datetime, timezone

from drill_rig_sim.field.feed_row import Row, measured
from drill_rig_sim.field.signals import SIGNALS
from drill_rig_sim.field.table import RecordError
from drill_rig_sim.tables import SIGNALS as ITEMS
from drill_rig_sim.units import FOOT, GALLON, POUND, PSI
from drill_rig_sim.wits0 import WRITTEN

SYSTEMS = ("metric", "fps")  # of the specification
# of fps by quantity, SI units of one
FPS = {"length": FOOT, "force": 1e3 * POUND, "torque": 1e3 * POUND * FOOT, "rotation": math.pi / 30.0, "pressure": PSI, "flow": GALLON / 60.0}
PLAYED = {"%02d" % row.item: (row.name, row.quantity) for row in ITEMS if row.item and row.name in SIGNALS}  # items of record 01
LINE = re.compile(r"(\d\d)(\d\d)(.*)")
READ_AT_ONCE, LONGEST_RECORD = 4096, 1 << 16  # [B]
PATIENCE = 60.0  # that nothing may come before it is reported [s]


class Stream:
    """Bytes to rows. `say(text)` gets one line for each record or item that is refused."""

    def __init__(self, units, say):
        self.factors = {item: FPS[quantity] if units == "fps" else 1.0 / WRITTEN[quantity][0] for item, (_, quantity) in PLAYED.items()}
        self.say, self.rest, self.lines, self.count = say, b"", None, 0

    def take(self, data):
        """The Rows that are complete with these bytes."""
        *lines, self.rest = (self.rest + data).split(b"\n")
        if len(self.rest) > LONGEST_RECORD:
            raise RecordError("the feed has no line ends; needed: WITS level 0")
        return [row for row in map(self.line, lines) if row is not None]

    def line(self, line):
        """A Row where the line ends a record 01."""
        text = line.decode("ascii", "replace").strip()
        if text == "&&":
            if self.lines:
                self.cut_off()
            self.lines = []
        elif text == "!!" and self.lines is not None:
            lines, self.lines = self.lines, None
            return self.row(lines) if lines and lines[0][:2] == "01" else None
        elif self.lines is not None:
            self.lines.append(text)
        return None

    def cut_off(self):
        """Where a record does not end."""
        self.count += 1
        self.say("record %d is refused: it has no end (!!)" % self.count)
        self.lines = None

    def row(self, lines):
        self.count += 1
        place, items = "record %d" % self.count, {}
        for text in lines:
            found = LINE.fullmatch(text)
            if found is None or found.group(1) != "01":
                self.say("%s is refused: '%s' is not an item of record 01" % (place, text[:20]))
                return None
            items[found.group(2)] = found.group(3).strip()
        try:
            moment = datetime.strptime(items.get("05", "") + " " + items.get("06", ""), "%y%m%d %H%M%S").replace(tzinfo=timezone.utc)
        except ValueError:
            self.say("%s is refused: date and time (0105, 0106) must be YYMMDD and HHMMSS (got '%s', '%s')" % (place, items.get("05", ""), items.get("06", "")))
            return None
        values = {name: measured(name, items[item], self.factors[item], "%s: item 01%s" % (place, item), self.say)
                  for item, (name, _) in PLAYED.items() if item in items}
        return Row(place, moment.timestamp(), values)


def wits_rows(host, port, units, say):
    """Rows of a server until that ends the connection; OSError where there is none."""
    stream = Stream(units, say)
    with socket.create_connection((host, port), PATIENCE) as connection:
        while True:
            try:
                data = connection.recv(READ_AT_ONCE)
            except socket.timeout:
                say("nothing was received for %g s" % PATIENCE)
                continue
            except ConnectionError:
                data = b""
            if not data:
                break
            yield from stream.take(data)
    if stream.lines is not None:
        stream.cut_off()
