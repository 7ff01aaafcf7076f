# SPDX-License-Identifier: BSD-3-Clause
"""The cells of a Table as signals in SI: which column holds which signal, in which unit, which cells are no measurements."""
import numpy
from drill_rig_sim.field.cell_units import take_units
from drill_rig_sim.field.cells import is_blank, is_foreign_number, is_number
from drill_rig_sim.field.column_finder import columns_of, form_of_header, zones_in
from drill_rig_sim.field.converted_nulls import leave_out_converted_nulls
from drill_rig_sim.field.dates import elapsed_of, fitting, form_in, forms_for, joined, number_as_time, offset_of, own_offset, seconds_of, zone_said
from drill_rig_sim.field.negative_nulls import leave_out_negative_nulls
from drill_rig_sim.field.quality import take_flags
from drill_rig_sim.field.signals import SIGNALS, si_unit, word
from drill_rig_sim.field.table import RecordError
from drill_rig_sim.field.title_units import take_title_units
from drill_rig_sim.field.units import UnitError, factor_of, is_unit, power_in

NULLS = (-999.0, -999.25, -9999.0, -9999.25, -99999.0, -99999.25, -999999.0, -999999.25)  # as logs write "no number"
# a sign was lost, or a counter is full
LIKE_NULLS = tuple(float(text) for text in "999.25 9999.25 99999.25 999 999.9 999.99 9999 9999.9 9999.99 99999 99999.9 99999.99 999999 32767 32768 65535".split())
FULL = (888.88, 8888.0, 8888.88)  # all segments of a display
ALONE = 2.0  # times as large as all other values of its column, or as small, from which on such a number is a null
NEVER_ZERO = ("hook_load", "bit_depth", "hole_depth", "block_height")  # for a moment
ALIKE, FAR, MOST_ZEROS = 0.05, 0.2, 3  # of values about zeros: share by which they may differ, least share of the largest value; rows
MOST_GUESSED = 2000  # dates by which formats are tried
MOST_ODD = 0.5  # share of the numbers out of a signal's range from which on the unit is taken to be wrong


class Part:
    """Of one table: `signals` in SI by name, `time` among them; `dated`: it is in seconds since 1970, else since any instant. `zoned`: the dates or the header say a
    time zone. `offset`: of that of the header [s], 0 without one. `rows`: the table's row of each. `remarks`: a line each."""

    def __init__(self, table, signals, dated, zoned, offset, rows, remarks):
        self.table, self.signals, self.dated, self.zoned, self.offset, self.rows, self.remarks = table, signals, dated, zoned, offset, rows, remarks

    def place(self, k):
        return self.table.place(self.rows[k])


def part_of(table, columns=None):
    """A Part of a table; `columns`: a ColumnMap, None where all columns are known by their names."""
    take_units(table)
    remarks = table.remarks
    mapped, nulls = (columns.columns, columns.nulls) if columns else ({}, ())
    take_title_units(table, mapped, remarks)
    wanted = columns_of(table, mapped, remarks)
    if "time" not in wanted:
        raise RecordError("%s: no column is recognised as the time; columns: %s; needed: a map, --columns%s" % (table.file, table.header(), encoding_choice(table)))
    take_flags(table, wanted, columns.quality if columns else {}, remarks)
    signals = {}
    time, dated, zoned, offset = times_of(table, wanted["time"], "time" in mapped, remarks)
    for signal, column in wanted.items():
        if signal == "time":
            continue
        values = values_of(table, signal, column, nulls, signal in mapped, remarks)
        if values is not None:
            signals[signal] = values
    timed = numpy.isfinite(time)
    if not timed.all():
        remarks.append("%d rows have no time and are left out (first: %s)" % ((~timed).sum(), table.place(int(numpy.flatnonzero(~timed)[0]))))
    rows = numpy.flatnonzero(timed & ~of_others(table, signals, remarks))
    if table.in_any_order and len(rows) > 2 and (numpy.diff(time[rows]) <= 0.0).all() and time[rows[0]] > time[rows[-1]]:
        remarks.append("its rows begin with the last one in time and are read in the order of time")
        rows = rows[::-1]
    signals = {"time": time[rows], **{signal: values[rows] for signal, values in signals.items()}}
    return Part(table, signals, dated, zoned, offset, rows, remarks)


def encoding_choice(table):
    """The end of a refusal of names that were read by a guess of their encoding."""
    guess = next((line.partition("read as ")[2] for line in table.remarks if "is not UTF-8; read as " in line and not table.header().isascii()), "")
    return ", or the file in UTF-8 where letters are wrong here (it is not UTF-8 and was read as %s)" % guess if guess else ""


def of_others(table, signals, remarks):
    """Whether each row holds no number of these signals where another row does: rows of another device, a gas detector, with times of its own."""
    empty = ~numpy.any([numpy.isfinite(values) for values in signals.values()], axis=0) if signals else numpy.zeros(len(table.rows), bool)
    if not empty.any() or empty.all():
        return numpy.zeros(len(table.rows), bool)
    remarks.append("%d rows hold none of the signals and are left out (first: %s)" % (empty.sum(), table.place(int(numpy.flatnonzero(empty)[0]))))
    return empty


# --- time

def times_of(table, column, mapped, remarks):
    """(seconds by row, nan where there is none; whether they are dates; whether these have a time zone; the offset of the header's time zone [s])."""
    places = [table.column(name) for name in column.names]
    cells = [joined(["" if is_null(row[place]) else row[place].strip() for place in places]) for row in table.rows]
    elapsed = elapsed_of(cells, " ".join([*column.names, table.units[places[0]] or ""])) if len(places) == 1 and not column.unit and not column.form else None
    if elapsed is not None:
        remarks.append("%s: is read as elapsed time (first: %s: %s)" % (column.names[0], *next((table.place(k), cell) for k, cell in enumerate(cells) if cell)))
        return numpy.array(elapsed), False, False, 0.0
    if is_date(table, places, column, cells):
        time, zoned = dates_of(table, cells, column, form_of_header(table, places))
        offsets = numpy.zeros(len(time)) if zoned else offsets_by_row(table, places, remarks)
        remarks += unused_zone(table, places, cells, column.form) if zoned else []
        said = zoned or bool(zone_said(texts_of(table, places))[1]) or bool(zones_in(table.names))
        return time - offsets, True, said, float(offsets[0]) if len(offsets) else 0.0
    unit = unit_of(table, places[0], column, "time")
    first = next((k for k, cell in enumerate(cells) if cell), None)
    if first is not None and not is_number(cells[first]) and not (unit and is_unit(unit, "time")):
        raise no_date(table, first, column, cells)
    factor = None if unit is None else factor_for(table, "time", column.names[0], unit)
    if factor is None:
        raise no_unit(table, first, column, cells, mapped)
    return numbers_or_refuse(table, column.names[0], cells, NULLS, "a number of %s" % unit, remarks) * factor, False, False, 0.0


def no_unit(table, first, column, cells, mapped):
    """The error of a time that is a number without a unit; `first`: row of the first one."""
    name, cell = column.names[0], "no rows" if first is None else cells[first]
    if first is not None and fitting(cells[first:first + 1]):
        return no_date(table, first, column, cells)
    what, line = (number_as_time(cell, name) if first is not None else None) or (None, None)
    needed = (" " + line) if line else " with its unit"
    return RecordError("%s: %s: the time has no unit and is not a date (first: %s%s); needed: %s" %
                       (table.file, name, cell, ", as " + what if what else "", "unit: in the map" if mapped and not line else "a map, --columns,%s" % needed))


NO_OFFSET = "%s: the time zone %s is not known by its offset: the dates are taken as UTC; needed where that matters: UTC-06:00"

NO_ZONE = "%s: %s in the header is not known as a time zone: the dates are taken as UTC; needed where that matters: UTC-06:00"
FORMS = ("date", "datetime", "time", "timestamp", "iso", "iso8601", "text", "string", "none", "unitless", "na", "24h", "24hr", "24hrs")


def offsets_by_row(table, places, remarks):
    """Of the time zones of dates that have none themselves [s]: of a column of zones, else of the header; reported where they are not UTC."""
    column = next(iter(zones_in(table.names)), None)
    if column is None:
        return numpy.full(len(table.rows), offset_said(table, places, remarks))
    cells = [row[column].strip() for row in table.rows]
    found = [0.0 if not cell else offset_of(cell) for cell in cells]
    odd = next((cell for cell, offset in zip(cells, found) if offset is None), None)
    if odd is not None:
        remarks.append(NO_OFFSET % (table.names[column], odd))
        return numpy.zeros(len(cells))
    if any(found):
        remarks.append("%s: the dates are taken by the time zones of %s" % (table.names[places[0]], table.names[column]))
    return numpy.array(found, dtype=float)


def texts_of(table, places):
    """Names and units of columns."""
    return [text for place in places for text in (table.names[place], table.units[place]) if text]


def offset_said(table, places, remarks):
    """Of the time zone in the header [s]; reported."""
    zone, text = zone_said(texts_of(table, places))
    name = table.names[places[0]]
    offset = zone.utcoffset(None).total_seconds() if zone else 0.0
    if offset:
        remarks.append("%s: its dates are taken by %s, as the header says" % (name, text))
    elif text and not zone:
        remarks.append(NO_OFFSET % (name, text))
    elif not text:
        unknown = next((table.units[place] for place in places if table.units[place] and not is_form(table.units[place])), None)
        remarks += [NO_ZONE % (name, unknown)] if unknown else []
    return offset


def unused_zone(table, places, cells, form):
    """A line, where the dates have a time zone of their own and the header says another."""
    zone, text = zone_said(texts_of(table, places))
    first = next((cell for cell in cells if cell), "")
    if zone is None or own_offset(first, form) in (None, zone.utcoffset(None).total_seconds()):
        return []
    return ["%s: the dates are taken by their own time zone (first: %s), not by %s of the header" % (table.names[places[0]], first, text)]


def is_form(unit):
    """Whether what stands for a unit of dates says how they are written, or nothing."""
    return bool(form_in(unit)) or is_unit(unit, "time") or word(unit) in FORMS


def is_null(cell):
    return is_blank(cell) or (is_number(cell) and float(cell) in NULLS)


def is_date(table, places, column, cells):
    if column.unit is not None:
        return factor_for(table, "time", column.names[0], column.unit) is None
    if len(places) == 2:
        return True
    if table.index == places[0] and table.index_is_date is not None:
        return table.index_is_date
    first = next((cell for cell in cells if cell), "")
    return seconds_of(first) is not None or seconds_of(first, form_of_header(table, places)) is not None


def dates_of(table, cells, column, said):
    """(seconds by row, whether they have a time zone). `said`: the format that the header writes, for dates that need one and have none in the map."""
    found, zones = numpy.full(len(cells), numpy.nan), [None, None]
    for k, cell in enumerate(cells):
        if not cell or (k and is_text(cell)):
            continue
        date = seconds_of(cell, column.form) or (seconds_of(cell, said) if said and not column.form else None)
        if date is None:
            raise no_date(table, k, column, cells)
        found[k], zoned = date
        if zones[zoned] is None:
            zones[zoned] = k
        if None not in zones:
            raise RecordError("%s: %s: %s has %s time zone, others of this column have %s; needed: all or none" %
                              (table.place(k), column.names[0], cell, "a" if zoned else "no", "none" if zoned else "one"))
    return found, zones[True] is not None


def is_text(cell):
    """Of a cell among dates: `Average`, `End`."""
    return not any(letter.isdigit() for letter in cell)


def no_date(table, k, column, cells):
    """The error of a cell; formats that read others of the column as well are named, or the unit of a number."""
    some = [cell for cell in cells if cell]
    what, line = (number_as_time(cells[k], column.names[0]) if is_number(cells[k]) and len(column.names) == 1 else None) or ("", None)
    return RecordError("%s: %s: %s is not a date with a time of day%s; %s" %
                       (table.place(k), " and ".join(column.names), cells[k], " by the format %s" % column.form if column.form else ", but %s" % what if what else "",
                        "needed: a map, --columns, " + line if line else "allowed: " + forms_for(some[::1 + len(some) // MOST_GUESSED], column.names)))


# --- values

def values_of(table, signal, column, nulls, mapped, remarks):
    """Of a signal by row [SI], nan where there is no measurement. None where its curve is left out, which is reported; RecordError where the map asks for it."""
    name = column.names[0]
    try:
        place = table.column(name)
        unit = unit_of(table, place, column, signal)
        if unit is None:
            raise RecordError("%s: %s: %s has no unit in the file; needed: unit: in the map" % (table.file, signal, name))
        factor = factor_for(table, signal, name, unit)
    except RecordError as error:
        if mapped:
            raise
        remarks.append("%s is left out: %s" % (signal, str(error)[len(table.file) + 2:]))
        return None
    if power_in(unit)[0] and set("x\u00d7*^X") & set(unit):
        remarks.append("%s: %s is read in %s: 1 is %.6g %s" % (signal, name, unit, factor, si_unit(signal)))
    raw = numbers_or_refuse(table, name, [row[place] for row in table.rows], (*NULLS, *table.nulls[place], *nulls, *column.nulls), "a number", remarks)
    leave_out_likely_nulls(table, name, raw, remarks)
    leave_out_converted_nulls(table, signal, name, unit, place, raw, factor, remarks)
    leave_out_negative_nulls(table, signal, name, raw, factor, remarks)
    values = in_range(table, signal, name, unit, raw, factor, remarks)
    if signal in NEVER_ZERO:
        leave_out_drop_outs(table, name, values, remarks)
    return values


def unit_of(table, place, column, signal):
    """The unit of a column's cells; RecordError where the map and the file disagree."""
    said = table.units[place]
    if column.unit is None or said is None:
        return column.unit or said
    quantity = SIGNALS[signal][0]
    try:
        same = factor_of(quantity, column.unit) == factor_of(quantity, said)
    except UnitError:  # a factor alone counts
        if power_in(said + " m")[0] and not power_in(said)[0] and not power_in(column.unit)[0]:
            raise RecordError("%s: %s: the file says a factor (%s), the map a unit without one (%s); needed: unit: %s %s, or x1 %s where the numbers are %s" %
                              (table.file, column.names[0], said, column.unit, said, column.unit, column.unit, column.unit))
        # the map's stands where the file's is not known, as M is for minutes
        same = not is_unit(said) or (signal == "time" and column.unit == "min")
    if not same:
        raise RecordError("%s: %s: the map says %s, the file %s; needed: the same, or no unit in the map" % (table.file, column.names[0], column.unit, said))
    return column.unit


def factor_for(table, signal, name, unit):
    try:
        return factor_of(SIGNALS[signal][0], unit)
    except UnitError as error:
        cell = table.unit_cells.get(table.column(name))
        raise RecordError("%s: %s: %s%s" % (table.file, name, error, " (first: %s)" % cell if cell else ""))


def numbers_or_refuse(table, name, cells, nulls, needed, remarks):
    """nan where there is no number or a null; texts are reported. RecordError where no cell of the column that holds something is a number, and where one has
    decimal or grouping signs that the others have not."""
    found = numpy.array([float(cell) if is_number(cell) else numpy.nan for cell in cells], dtype=float)
    texts = [k for k, cell in enumerate(cells) if not is_number(cell) and not is_blank(cell)]
    if texts and not numpy.isfinite(found).any():
        raise RecordError("%s: %s: %s is not %s, and no other cell of this column is one; columns as read: %s" %
                          (table.place(texts[0]), name, cells[texts[0]].strip(), needed, table.header()))
    foreign = next((k for k in texts if is_foreign_number(cells[k])), None)
    if foreign is not None:
        raise RecordError("%s: %s: %s is not a number with a decimal point like the others; needed: one decimal sign in all numbers (map: decimal: comma or point)" %
                          (table.place(foreign), name, cells[foreign].strip()))
    if texts:
        remarks.append("%d cells of %s hold text, not a number (first: %s: %s)" % (len(texts), name, table.place(texts[0]), cells[texts[0]].strip()))
    found[~numpy.isfinite(found)] = numpy.nan
    for null in set(nulls):
        found[close(found, null)] = numpy.nan
    return found


def close(number, null):
    return abs(number - null) <= 1e-9 * abs(null)


def leave_out_likely_nulls(table, name, raw, remarks):
    """Of numbers that files write for no number those which stand far from all others of their column; reported."""
    sizes = numpy.abs(raw)
    odd = numpy.isin(sizes, LIKE_NULLS) | numpy.isin(raw, FULL)
    others = sizes[numpy.isfinite(sizes) & ~odd]
    if not len(others):
        return
    with numpy.errstate(invalid="ignore", over="ignore"):
        odd = numpy.flatnonzero(odd & ((sizes >= ALONE * others.max()) | (ALONE * sizes <= others.min())))
    if len(odd):
        remarks.append("%s: %d values such as %g are far from all others and are treated as null values (first: %s)" % (name, len(odd), raw[odd[0]], table.place(odd[0])))
        raw[odd] = numpy.nan


def leave_out_drop_outs(table, name, values, remarks):
    """Of a few zeros or negative values in a row between two values that are alike and far from zero: a gauge that was lost for a moment; reported."""
    known = numpy.flatnonzero(numpy.isfinite(values))
    filled = known[values[known] > 0.0]
    if not len(filled):
        return
    before, after = filled[:-1], filled[1:]
    zeros = numpy.searchsorted(known, after) - numpy.searchsorted(known, before) - 1
    sizes, largest = numpy.abs(values[filled]), numpy.abs(values[filled]).max()
    alike = (numpy.abs(values[after] - values[before]) <= ALIKE * sizes[:-1]) & (sizes[:-1] >= FAR * largest)
    odd = [k for place in numpy.flatnonzero((zeros > 0) & (zeros <= MOST_ZEROS) & alike) for k in known[(known > before[place]) & (known < after[place])]]
    if odd:
        remarks.append("%s: %d zeros or negative values between similar values are treated as null values (first: %s)" % (name, len(odd), table.place(odd[0])))
        values[odd] = numpy.nan


def in_range(table, signal, name, unit, raw, factor, remarks):
    """In SI, without what no gauge can have measured, which is reported with its row; RecordError where that is most of it."""
    _, least, most = SIGNALS[signal]
    with numpy.errstate(invalid="ignore", over="ignore"):  # 1.7e308 stands for no number
        values = factor * raw
        odd = numpy.flatnonzero((values < least) | (values > most))
    if not len(odd):
        return values
    allowed = "%.6g to %.6g %s" % (least / factor, most / factor, unit)
    first = "%s: %s %.6g %s" % (table.place(odd[0]), name, raw[odd[0]], unit)
    numbers = int(numpy.isfinite(values).sum())
    if len(odd) > MOST_ODD * numbers:
        raise RecordError("%s: %s: %d of %d values are out of the range of %s on a rig (allowed: %s; first: %s); is the unit right?" %
                          (table.file, name, len(odd), numbers, signal, allowed, first))
    remarks.append("%s: %d of %d values are out of range and are treated as missing (allowed: %s; first: %s)" % (signal, len(odd), numbers, allowed, first))
    values[odd] = numpy.nan
    return values
