"""A rig's record as arrays in SI: a CSV file with a map of its columns, or a log of WITSML 1.4.1.1."""
import csv
import os
from datetime import datetime

import numpy
from drill_rig_sim.campaign.plan_text import PlanError, plan_of
from drill_rig_sim.field.units import QUANTITIES, TIME

MNEMONICS = {"TIME": "time", "BLOCKCOMP": "block_height", "SURF_RPM": "top_drive_speed", "FLOWIN": "flow", "HKLD": "hook_load", "TORQUE": "torque",
             "SPP": "stand_pipe_pressure", "BITDEP": "bit_depth", "DBTM": "bit_depth", "DMEA": "hole_depth"}  # as used in the field
# of a time series of drill run --csv --readings
OWN = {"time": "time", "block_height": "reading_block_height", "top_drive_speed": "top_drive_speed", "flow": "reading_flow", "hook_load": "reading_hook_load",
       "torque": "reading_torque", "stand_pipe_pressure": "reading_stand_pipe_pressure", "bit_depth": "reading_bit_depth", "hole_depth": "reading_hole_depth"}
MOST_BYTES = 2**30
NULLS = (-999.25, -999.0, -9999.0)  # what stands for no number in logs
LONG_GAP, SHORTEST_GAP = 10.0, 5.0  # of rows' distance, and s, from which on a gap is told


class RecordError(Exception):
    """What is wrong with a record, in one line."""


class Record:
    """Signals by name (units.QUANTITIES), each an array [SI] as long as `time`, which begins at 0 and increases; rows without a number are nan. `remarks`: what
    its reader should know, a line each."""

    def __init__(self, signals, name):
        self.name = name
        if "time" not in signals:
            raise RecordError("%s: has no time" % name)
        good = numpy.isfinite(signals["time"])
        if good.sum() < 2:
            raise RecordError("%s: needed: two rows or more with a time" % name)
        time = signals["time"][good] - signals["time"][good][0]
        back = numpy.flatnonzero(numpy.diff(time) <= 0.0)
        if len(back):
            row = numpy.flatnonzero(good)[back[0] + 1] + 1
            raise RecordError("%s: row %d of the data: its time does not come after the row's before it (%.9g s, %.9g s before); needed: time that increases, "
                              "dates where it goes over midnight" % (name, row, time[back[0] + 1], time[back[0]]))
        self.signals = {key: values[good] for key, values in signals.items()}
        self.signals["time"] = self.time = time
        self.remarks = remarks_of(self, int((~good).sum()))

    def __contains__(self, signal):
        return signal in self.signals

    def at(self, signal, time):
        """On straight lines between the rows that have a number; the ends go on."""
        values = self.signals[signal]
        good = numpy.isfinite(values)
        if not good.any():
            raise RecordError("%s: %s has no numbers" % (self.name, signal))
        return numpy.interp(time, self.time[good], values[good])


def remarks_of(record, timeless):
    """Lines: rows without numbers, gaps, and what is not there and therefore rests."""
    lines = ["%d rows have no time and are left out" % timeless] if timeless else []
    for signal, values in record.signals.items():
        lost = int((~numpy.isfinite(values)).sum())
        if lost:
            lines.append("%s: %d of %d rows hold no number" % (signal, lost, len(values)))
    steps = numpy.diff(record.time)
    longest = int(steps.argmax())
    if steps[longest] > max(LONG_GAP * numpy.median(steps), SHORTEST_GAP):
        lines.append("a gap of %.4g s from %.6g s on" % (steps[longest], record.time[longest]))
    lines += ["has no %s: %s" % (signal, so) for signal, so in (("flow", "the pump stands"), ("top_drive_speed", "the string is not turned"),
                                                  ("bit_depth", "a block that runs without the string is taken for one with it")) if signal not in record]
    return ["%s: %s" % (record.name, line) for line in lines]


def read_record(file, columns=None):
    """By the file's name: .xml is WITSML, else CSV. `columns`: the file of a map, needed where the columns are not those of drill run --csv --readings."""
    try:
        if os.path.getsize(file) > MOST_BYTES:
            raise RecordError("%s: is larger than 1 GiB" % file)
        return read_witsml(file) if file.endswith(".xml") else read_csv(file, columns)
    except (OSError, UnicodeDecodeError) as error:
        raise RecordError("%s: %s" % (file, getattr(error, "strerror", None) or error))


def read_csv(file, columns):
    with open(file, newline="", encoding="utf-8-sig") as text:
        rows = csv.reader(text)
        names = [name.strip() for name in next(rows, [])]
        table = [row for row in rows if any(cell.strip() for cell in row)]
    wanted = read_map(columns) if columns else {signal: (column, 1.0) for signal, column in OWN.items() if column in names}
    signals = {}
    for signal, (column, factor) in wanted.items():
        if column not in names:
            raise RecordError("%s: has no column %s; there are %s" % (file, column, ", ".join(names)))
        place = names.index(column)
        signals[signal] = numbers([row[place] if place < len(row) else "" for row in table], factor)
    if not signals:
        raise RecordError("%s: its columns are not those of drill run --csv --readings: needed: a map of them, --columns" % file)
    return Record(signals, file)


def read_map(file):
    """Signals to column and factor: `hook_load: {column: HL, unit: klbf}` a line."""
    try:
        found = {}
        for signal, entry in plan_of(file).mapping(tuple(QUANTITIES)).items():
            parts = entry.mapping(("column", "unit"), needed=("column", "unit"))
            found[signal] = parts["column"].text(), QUANTITIES[signal][parts["unit"].choice(tuple(QUANTITIES[signal]))]
        return found
    except PlanError as error:
        raise RecordError(str(error))


def numbers(cells, factor):
    """nan where there is none; `factor` None: dates."""
    if factor is None:
        return numpy.array([seconds_of(cell) for cell in cells])
    return numpy.array([factor * number(cell) for cell in cells])


def number(cell):
    """nan for what is none, by its text or as logs write it (NULLS)."""
    try:
        value = float(cell)
    except ValueError:
        return numpy.nan
    return numpy.nan if value in NULLS else value


def seconds_of(text):
    """Of an ISO date; a time without a zone is taken as UTC."""
    try:
        when = datetime.fromisoformat(text.strip().replace("Z", "+00:00"))
    except ValueError:
        return numpy.nan
    return (when if when.tzinfo else datetime.fromisoformat(text.strip() + "+00:00")).timestamp()


def read_witsml(file):
    """The first log of a document; curves by their usual mnemonics, units by the document."""
    try:
        from lxml import etree
    except ImportError:
        raise RecordError("%s: WITSML needs Debian's python3-lxml" % file)
    try:
        root = etree.parse(file, etree.XMLParser(resolve_entities=False, no_network=True, huge_tree=False)).getroot()
    except etree.XMLSyntaxError as error:
        raise RecordError("%s: %s" % (file, error))
    data = root.find(".//{*}logData")
    if data is None or data.find("{*}mnemonicList") is None or data.find("{*}unitList") is None:
        raise RecordError("%s: holds no log of WITSML 1.4.1.1 with data" % file)
    names, units = ([part.strip() for part in (data.find("{*}%s" % part).text or "").split(",")] for part in ("mnemonicList", "unitList"))
    rows = [(row.text or "").split(",") for row in data.findall("{*}data")]
    index, null = root.findtext(".//{*}indexCurve"), root.findtext(".//{*}nullValue")
    signals = {}
    for place, (name, unit) in enumerate(zip(names, units)):
        signal = "time" if name == index else MNEMONICS.get(name)
        if signal is None or signal in signals:
            continue
        cells = ["" if place >= len(row) or row[place] == null else row[place] for row in rows]
        if signal == "time":
            factor = None if root.findtext(".//{*}indexType") == "date time" else TIME.get(unit, 1.0)
        elif unit in QUANTITIES[signal]:
            factor = QUANTITIES[signal][unit]
        else:
            raise RecordError("%s: %s: the unit %s is not known, allowed: %s" % (file, name, unit, ", ".join(QUANTITIES[signal])))
        signals[signal] = numbers(cells, factor)
    return Record(signals, file)
