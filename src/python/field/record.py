# SPDX-License-Identifier: BSD-3-Clause
"""A rig's record as arrays in SI: delimited tables, logs of WITSML and LAS files, one or several files of the same well joined by time."""
import os
import re

import numpy
from drill_rig_sim.field.column_finder import AllOf, ByMap, OfTheTrade
from drill_rig_sim.field.columns import ColumnMap, read_map
from drill_rig_sim.field.contradictions import contradictions
from drill_rig_sim.field.dates import written
from drill_rig_sim.field.dropouts import leave_out_dropouts
from drill_rig_sim.field.files import begins_with, bytes_of, text_of
from drill_rig_sim.field.in_feet import pipe_in_feet
from drill_rig_sim.field.las import read_las
from drill_rig_sim.field.lost_gauges import leave_out_lost, unlikely_values
from drill_rig_sim.field.signal_reader import part_of
from drill_rig_sim.field.signals import si_unit, word
from drill_rig_sim.field.table import Layout, RecordError, read_delimited
from drill_rig_sim.field.unit_change import unit_changes
from drill_rig_sim.field.witsml import read_witsml
from drill_rig_sim.refusal import after

MOST_DAYS = 400.0  # that a record may last
COMPARED = ("hook_load", "torque", "stand_pipe_pressure")  # with what is simulated; the others are played
BELOW_BOTTOM = 1.0  # from which on a bit below the hole's bottom is reported [m]
LEAST_LOAD, HIGHEST_BLOCK, LONGEST_WAY = 5e3, 65.0, 55.0  # of a rig [N], of its block and of that's way [m]; others are reported
LEAST_PRESSURE, LEAST_FLOW, MOST_FLOW = 2e4, 3e-3, 0.13  # of a stand pipe while the pump runs [Pa], [m3/s]; more than three pumps deliver [m3/s]
MOST_PRESSURE, MOST_SPEED, MOST_TORQUE = 6e7, 33.5, 1.5e5  # of pumps [Pa], and of top drives: 320 rpm [rad/s], [N m]; others are reported
FASTEST_BLOCK = 6.0  # of a record, between two rows; twice what drawworks do, because times may be rounded [m/s]
FAR_LOAD, MOST_FAR = 4.0, 3  # times as large as the largest of all other hook loads; rows
SPACINGS = (1e-3, 120.0)  # of a record's rows [s]; others are reported
NOT_READ = r"\b%s\b.* left out: |no column is recognised as [^;]*\b%s\b"  # in a remark
CLOCKS = 3600.0  # by which clocks are changed in spring and autumn [s]
LONG_GAP, SHORTEST_GAP = 10.0, 5.0  # of rows' distance, and s, from which on a gap is reported


class Record:
    """Signals by name (signals.SIGNALS), each an array [SI] as long as `time`, which begins at 0 and increases; rows without a measurement are nan. `begin`: seconds
    since 1970 UTC at time 0, None where the record has no dates. `offset`: of the time zone by which dates without one are read [s]. `remarks`: what its reader should know, a line each; `noticed`: those
    that do not depend on what is done with it."""

    def __init__(self, parts, name):
        """Of the Parts of one well, in any order."""
        self.name = name
        if len({part.dated for part in parts}) > 1:
            raise RecordError("%s: some of its tables have dates, others seconds; needed: the same in all" % name)
        for part in parts:
            check_order(part)
        self.remarks = [line for part in parts for line in prefixed(part.table.file, part.remarks)]
        self.signals, said = joined(parts)
        said += both_hold(parts) + of_one_well(parts) + leave_out_empty(self.signals)
        time = self.signals["time"]
        if len(time) < 2:
            rows = sum(len(part.signals["time"]) for part in parts)
            raise RecordError("%s: needed: two rows or more with a time (has %d%s)" % (name, rows, ", all with the same" if rows > len(time) else ""))
        self.begin, self.offset = float(time[0]) if parts[0].dated else None, parts[0].offset
        check_length(self, parts)
        for look in (leave_out_lost, leave_out_dropouts, unlikely_values):
            said += look(time, self.signals, lambda row: place_of(parts, time[row])) + leave_out_empty(self.signals)
        self.time = self.signals["time"] = time - time[0]
        self.noticed = self.remarks + prefixed(name, said + remarks_of(self))
        self.remarks = self.noticed + prefixed(name, assumptions(self))

    def __contains__(self, signal):
        return signal in self.signals

    def why_missing(self, *signals):
        """What was noticed when columns of these signals were left out or not recognised, for the end of a message."""
        lines = [line.partition(": ")[2] for signal in signals for line in self.remarks if re.search(NOT_READ % (signal, signal), line)]
        return "".join("; " + line for line in dict.fromkeys(lines))

    def at(self, signal, time):
        """On straight lines between the rows that have a number; the ends go on."""
        values = self.signals[signal]
        good = numpy.isfinite(values)
        if not good.any():
            raise RecordError("%s: %s has no numbers" % (self.name, signal))
        return numpy.interp(time, self.time[good], values[good])


def prefixed(file, lines):
    return [line if line.startswith(file) else "%s: %s" % (file, line) for line in lines]


def place_of(parts, time):
    """Where the first row of a time stands."""
    part = next(part for part in parts if time in part.signals["time"])
    return part.place(int(numpy.flatnonzero(part.signals["time"] == time)[0]))


def check_order(part):
    """RecordError where the time of a part goes back."""
    time = part.signals["time"]
    back = numpy.flatnonzero(numpy.diff(time) < 0.0)
    if len(back):
        after, before = (written(time[k]) if part.dated else "%.9g s" % time[k] for k in (back[0] + 1, back[0]))
        by_clock = part.dated and is_clock_change(time[back[0]] - time[back[0] + 1], -float(numpy.median(numpy.diff(time))))
        needed = "times with their zone, such as 01:30:00-05:00; this is the hour by which clocks are put back" if by_clock else "time that increases, dates where it goes over midnight"
        raise RecordError("%s: the time goes back to %s (the row before: %s); needed: %s" % (part.place(back[0] + 1), after, before, needed))


def is_clock_change(step, spacing):
    """Whether a step of the time is the hour by which clocks are changed, and a row."""
    return abs(step - spacing - CLOCKS) <= abs(spacing)


def joined(parts):
    """Signals of all rows in the order of time, and lines on rows of the same time: these become one, the first measurement of each signal stands."""
    names = list(dict.fromkeys(name for part in parts for name in part.signals))
    columns = {name: numpy.concatenate([part.signals.get(name, numpy.full(len(part.signals["time"]), numpy.nan)) for part in parts]) for name in names}
    origins = [(part, k) for part in parts for k in range(len(part.signals["time"]))]
    order = numpy.argsort(columns["time"], kind="stable")
    columns = {name: values[order] for name, values in columns.items()}
    again = numpy.concatenate(([False], numpy.diff(columns["time"]) <= 0.0)) if len(order) else numpy.zeros(0, bool)
    if not again.any():
        return columns, []
    first, differing = numpy.flatnonzero(~again), None
    owner = first[numpy.cumsum(~again) - 1]
    for name in names[1:] if names[0] == "time" else names:
        values = columns[name]
        for k in numpy.flatnonzero(again):
            if numpy.isnan(values[owner[k]]):
                values[owner[k]] = values[k]
            elif numpy.isfinite(values[k]) and values[k] != values[owner[k]]:
                differing = k if differing is None else min(differing, k)
    if differing is None:
        return {name: values[first] for name, values in columns.items()}, []
    part, row = origins[order[differing]]
    lines = ["%d rows have the same time as the row before; where values differ, the first is used (first: %s)" % (again.sum(), part.place(row))]
    return {name: values[first] for name, values in columns.items()}, lines


def both_hold(parts):
    """Lines on files that hold the same signals at the same times, in rows of their own: seconds that begin anew in each file, or two gauges."""
    lines = []
    for number, one in enumerate(parts):
        for other in parts[number + 1:]:
            times = [part.signals["time"] for part in (one, other)]
            if one.table.file == other.table.file or not all(map(len, times)):
                continue
            begin, end = max(time[0] for time in times), min(time[-1] for time in times)
            inside = [time[(time >= begin) & (time <= end)] for time in times]
            alike = [name for name in one.signals if name in other.signals and name != "time"]
            if begin < end and alike and not any(numpy.isin(first, second).all() for first, second in (inside, inside[::-1])):
                what = "dates" if one.dated else "seconds; dates are needed where these begin anew in each file"
                lines.append("%s and %s both hold %s at the same %s: rows of both are used in turn" % (one.table.file, other.table.file, ", ".join(alike), what))
    return lines


def of_one_well(parts):
    """Lines on files that name different wells, and on dates with and without a time zone."""
    lines, first = [], next((part for part in parts if part.table.well[0]), None)
    other = next((part for part in parts if first and any(all(both) and word(both[0]) != word(both[1]) for both in zip(part.table.well, first.table.well))), None)
    if other:
        lines.append("%s is of well %s, %s of %s; they are joined as one well" % tuple(
            text for part in (first, other) for text in (part.table.file, "/".join(filter(None, part.table.well)))))
    apart = [next((part.table.file for part in parts if part.zoned is zoned), None) for zoned in (True, False)]
    if None not in apart and parts[0].dated:
        lines.append("the dates of %s have a time zone, those of %s have none and are taken as UTC" % tuple(apart))
    return lines


def check_length(record, parts):
    """RecordError where a record is longer than any can be: a time that is wrong."""
    time = record.signals["time"]
    if time[-1] - time[0] > 86400.0 * MOST_DAYS:
        gap = int(numpy.diff(time).argmax())
        raise RecordError("%s: its time is %.6g days after the row before it; allowed: records of up to %g days" %
                          (place_of(parts, time[gap + 1]), (time[gap + 1] - time[gap]) / 86400.0, MOST_DAYS))


def leave_out_empty(signals):
    """Takes away what holds no number at all, as channels that were recorded but not connected; lines on it."""
    empty = [name for name, values in signals.items() if name != "time" and len(values) and not numpy.isfinite(values).any()]
    for name in empty:
        del signals[name]
    return ["%s is left out: it holds no number" % name for name in empty]


def remarks_of(record):
    """Lines: rows without numbers, gaps, and values that no rig has."""
    lines = []
    for signal, values in record.signals.items():
        good = numpy.isfinite(values)
        if not good.all():
            filled = "" if signal in COMPARED else bridged(record.time, good)
            lines.append("%s: %d of %d rows hold no measurement%s" % (signal, (~good).sum(), len(values), filled))
    spacing = float(numpy.median(numpy.diff(record.time)))
    if not SPACINGS[0] <= spacing <= SPACINGS[1]:
        lines.append("its rows are %.3g s apart; check the unit of the time" % spacing)
    gaps, (longest, begin) = gaps_in(record.time), longest_step(record.time)
    if len(gaps):
        by_clock = record.begin is not None and is_clock_change(longest, spacing)
        lines.append("a gap of %.4g s from %.6g s on%s%s" % (longest, begin, ", the longest of %d, of %.4g s in all" % (len(gaps), gaps.sum()) if len(gaps) > 1 else "", ", the hour by which clocks are put forward; are the times those of one zone?" if by_clock else ""))
    lines += ["%s is %.4g times as large from %.6g s on, as if its unit changed from %s to %s; check its values before that time and after it" %
              (signal, ratio, record.time[row], before, after) for signal, row, ratio, before, after in unit_changes(record.time, record.signals)]
    lines += below_bottom(record) + unlikely(record) + fast_block(record) + far_loads(record) + contradictions(record)
    return lines


def assumptions(record):
    """Lines on what is not there and is taken as constant."""
    return ["has no %s: %s" % (signal, so) for signal, so in (
        ("flow", "the pump is assumed to be off"), ("top_drive_speed", "the string is assumed not to rotate"),
        ("bit_depth", "the string is assumed to move with the block at all times")) if signal not in record]


def below_bottom(record):
    """A line, where the bit is deeper than the hole."""
    if "bit_depth" not in record or "hole_depth" not in record:
        return []
    below = numpy.nan_to_num(record.signals["bit_depth"] - record.signals["hole_depth"], nan=0.0)
    rows = numpy.flatnonzero(below > BELOW_BOTTOM)
    return ["bit_depth is up to %.4g m below hole_depth (%d of %d rows, first at %.6g s); check the names of both columns" %
            (below.max(), len(rows), len(below), record.time[rows[0]])] if len(rows) else []


def unlikely(record):
    """Lines on signals whose values are in range and that no rig has, as of a number in another unit."""
    def largest(signal):
        values = record.signals.get(signal, numpy.zeros(0))
        return numpy.nanmax(numpy.abs(values)) if numpy.isfinite(values).any() else numpy.nan
    height = record.signals.get("block_height", numpy.zeros(0))
    way = numpy.nanmax(height) - numpy.nanmin(height) if numpy.isfinite(height).any() else 0.0
    high = ["block_height: it moves over %.3g m, farther than blocks do; is its unit right?" % way] if LONGEST_WAY < way and largest("block_height") <= HIGHEST_BLOCK else []
    return high + pipe_in_feet(record) + ["%s: its largest value is %.3g %s, %s; is its unit right?" % (signal, largest(signal), si_unit(signal), why) for signal, so, why in (
        ("hook_load", largest("hook_load") < LEAST_LOAD, "less than a block weighs"),
        ("block_height", largest("block_height") > HIGHEST_BLOCK, "higher than masts are"),
        ("flow", largest("flow") > MOST_FLOW, "more than the pumps of a rig deliver"),
        ("stand_pipe_pressure", largest("stand_pipe_pressure") > MOST_PRESSURE, "more than the pumps of a rig are rated for"),
        ("top_drive_speed", largest("top_drive_speed") > MOST_SPEED, "faster than top drives turn"),
        ("torque", largest("torque") > MOST_TORQUE, "more than top drives have"),
        ("stand_pipe_pressure", largest("stand_pipe_pressure") < LEAST_PRESSURE and largest("flow") > LEAST_FLOW, "while the pump runs")) if so]


def fast_block(record):
    """A line on a block that is faster than blocks are: digits that are wrong, or a gauge that was set anew."""
    if "block_height" not in record:
        return []
    good = numpy.isfinite(record.signals["block_height"])
    time, steps = record.time[good], numpy.diff(record.signals["block_height"][good])
    fast = numpy.flatnonzero(numpy.abs(steps) > FASTEST_BLOCK * numpy.diff(time))
    return ["block_height changes by %.3g m from %.6g to %.6g s, faster than blocks move (%d times); check its values" %
            (steps[fast[0]], time[fast[0]], time[fast[0] + 1], len(fast))] if len(fast) else []


def far_loads(record):
    """A line on a few hook loads far above all others, between two of these: digits that are wrong."""
    loads = record.signals.get("hook_load", numpy.zeros(0))
    good = numpy.flatnonzero(numpy.isfinite(loads))
    order = good[numpy.argsort(loads[good])]
    for count in range(1, min(MOST_FAR, len(order) - 3 * MOST_FAR) + 1):
        far, others = numpy.sort(order[-count:]), loads[order[-count - 1]]
        if loads[far].min() >= FAR_LOAD * others > 0.0 and far[0] > good[0] and far[-1] < good[-1]:
            return ["hook_load: %d values are %.3g times as large as all others or more (first: %.4g kN at %.6g s); check their digits" %
                    (count, loads[far].min() / others, 1e-3 * loads[far[0]], record.time[far[0]])]
    return []


def bridged(time, good):
    """What is added to a line on rows without a measurement where they are many on end and the signal is played."""
    known = numpy.concatenate((time[:1], time[good], time[-1:]))
    longest, begin = longest_step(known)
    return "; none for %.4g s from %.6g s on: filled by a straight line, at an end by the nearest value" % (longest, begin) if longest > long_step(time) else ""


def longest_step(time):
    """Length and begin."""
    steps = numpy.diff(time)
    longest = int(steps.argmax())
    return steps[longest], time[longest]


def gaps_in(time):
    """Lengths of the gaps between rows that are reported [s]."""
    steps = numpy.diff(time)
    return steps[steps > long_step(time)]


def long_step(time):
    """From which on a gap between rows is reported [s]."""
    return max(LONG_GAP * numpy.median(numpy.diff(time)), SHORTEST_GAP)


def read_record(files, columns=None):
    """A Record of one file or a list of files of one well. The content decides the format: WITSML begins with <, LAS with ~, all else is a delimited table.
    `columns`: the file of a map (columns.py), for all of them; without it the columns are known by the names of the trade or those of drill run --csv --readings.
    RecordError with one line."""
    files = [files] if isinstance(files, (str, os.PathLike)) else list(files)
    scene = next((file for file in files if os.fspath(file).endswith((".yaml", ".yml"))), None)
    if scene:
        raise RecordError("%s: is YAML, as scenes and maps are, not a record; needed: the record before the scene" % scene)
    mapping = read_map(columns) if columns else None
    tables = [table for file in files for table in tables_of(os.fspath(file), mapping)]
    with after(lambda: [line for table in tables for line in prefixed(table.file, table.remarks)]):
        parts = [part_of(table, mapping and of_table(mapping, table, tables)) for table in tables]
        return Record(parts, os.fspath(files[0]) if len(files) == 1 else "%s and %d more" % (files[0], len(files) - 1))


def of_table(mapping, table, tables):
    """The map without the columns that stand only in others of the tables."""
    def is_in(one, column):
        return all(map(one.places_of, column.names))
    columns = {signal: column for signal, column in mapping.columns.items()
               if signal == "time" or is_in(table, column) or not any(is_in(other, column) for other in tables)}
    quality = {name: good for name, good in mapping.quality.items() if table.places_of(name) or not any(other.places_of(name) for other in tables)}
    return ColumnMap(columns, mapping.nulls, mapping.layout, quality)


def tables_of(file, mapping):
    """The Tables of a file."""
    times = [name.lower() for name in mapping.columns["time"].names] if mapping and "time" in mapping.columns else []
    if begins_with(file, b"<"):
        return read_witsml(file, bytes_of(file), times)
    text, remarks = text_of(file)
    if text.lstrip()[:2] == "&&":
        raise RecordError("%s: is a stream of WITS level 0, whose items have no names and units; needed: a table, WITSML or LAS" % file)
    if text.lstrip()[:1] == "~" or file.lower().endswith(".las"):
        tables = read_las(file, text, times)
    else:
        tables = [read_delimited(file, text, mapping.layout if mapping else Layout(), ByMap(mapping) if mapping else OfTheTrade())]
    tables[0].remarks += remarks
    return tables


def read_table(file, layout=Layout(), columns=(), wanted=None):
    """The Table of a delimited file, with all its columns. `columns`: names that its header must have, for files with a title before it, or `wanted`: some of them."""
    text, remarks = text_of(file)
    table = read_delimited(file, text, layout, wanted or AllOf(columns))
    table.remarks += remarks
    return table
