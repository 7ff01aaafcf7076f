# SPDX-License-Identifier: BSD-3-Clause
"""A map: which column of a record holds which signal, in which unit."""
from drill_rig_sim.campaign.plan_text import PlanError, plan_of
from drill_rig_sim.field.heading import name_in
from drill_rig_sim.field.signals import SIGNALS
from drill_rig_sim.field.table import DELIMITERS, Layout, RecordError
from drill_rig_sim.field.units import DATE, UnitError, factor_of

DECIMALS = {"point": ".", "comma": ",", ".": ".", ",": ","}
LAYOUT_KEYS = ("null", "delimiter", "decimal")
QUALITY = "quality"  # the key of columns that mark values as good or bad


class Column:
    """Of a signal: `names` of its columns (two: date and time of the day), `unit` (None: the file says it), `form` of dates (None: ISO 8601) and `nulls`: values
    that stand for no number in this column."""

    def __init__(self, names, unit=None, form=None, nulls=()):
        self.names, self.unit, self.form, self.nulls = list(map(name_in, names)), unit, form, tuple(nulls)


class ColumnMap:
    """`columns` by signal; `nulls`: values that stand for no number; `layout` of a delimited file; `quality`: of columns that mark values as good or bad the good cells,
    in small letters."""

    def __init__(self, columns, nulls=(), layout=Layout(), quality=None):
        self.columns, self.nulls, self.layout, self.quality = columns, tuple(nulls), layout, quality or {}


def read_map(file):
    """A ColumnMap of a file with lines as `hook_load: {column: HL, unit: klbf}`. RecordError with the first problem."""
    try:
        entries = plan_of(file).mapping((*SIGNALS, *LAYOUT_KEYS, QUALITY))
        columns = {signal: column_of(signal, entries[signal]) for signal in SIGNALS if signal in entries}
        check_apart(columns, entries)
        return ColumnMap(columns, *nulls_and_layout(entries), quality_of(entries))
    except PlanError as error:
        raise RecordError(str(error))


def check_apart(columns, entries):
    """That no two signals are of one column."""
    owners = {}
    for signal, column in columns.items():
        for name in column.names:
            owner = owners.setdefault(name.strip().lower(), signal)
            if owner != signal:
                entries[signal].fail("column %s is that of %s; needed: a column for each" % (name, owner))


def nulls_and_layout(entries):
    """Of LAYOUT_KEYS among these entries."""
    delimiter = DELIMITERS[entries["delimiter"].choice(tuple(DELIMITERS))] if "delimiter" in entries else None
    decimal = DECIMALS[entries["decimal"].choice(tuple(DECIMALS))] if "decimal" in entries else None
    return nulls_of(entries), Layout(delimiter, decimal)


def quality_of(entries):
    """Good cells by the name of a column: `quality: {column: QC, good: [1, OK]}`, or a list of these."""
    if QUALITY not in entries:
        return {}
    found = {}
    for item in entries[QUALITY].sequence() if entries[QUALITY].is_sequence() else [entries[QUALITY]]:
        parts = item.mapping(("column", "good"), needed=("column", "good"))
        cells = parts["good"].sequence() if parts["good"].is_sequence() else [parts["good"]]
        found[name_in(parts["column"].text())] = [cell.text().strip().lower() for cell in cells]
    return found


def nulls_of(entries):
    """A number, or a list of them."""
    if "null" not in entries:
        return ()
    return [item.number() for item in (entries["null"].sequence() if entries["null"].is_sequence() else [entries["null"]])]


def column_of(signal, entry):
    parts = entry.mapping(("column", "unit", "format") if signal == "time" else ("column", "unit", "null"), needed=("column",))
    two = signal == "time" and parts["column"].is_sequence()
    names = [item.text() for item in parts["column"].sequence()] if two else [parts["column"].text()]
    if len(names) > 2:
        parts["column"].fail("must be one column, or two: date and time of the day")
    unit = parts["unit"].text() if "unit" in parts else None
    form = parts["format"].text() if "format" in parts else None
    if unit is not None:
        check_unit(signal, unit, parts["unit"])
    if form and "%Z" in form:
        parts["format"].fail("must have %%z for a time zone such as +02:00: names as of %%Z are ambiguous (got %s)" % form)
    if form or len(names) == 2:
        if unit is not None and factor_of("time", unit) is not None:
            parts["unit"].fail("must be date where there is a format or two columns (got %s)" % unit)
        unit = DATE
    return Column(names, unit, form, nulls_of(parts))


def check_unit(signal, unit, entry):
    try:
        factor_of(SIGNALS[signal][0], unit)
    except UnitError as error:
        entry.fail(str(error))
