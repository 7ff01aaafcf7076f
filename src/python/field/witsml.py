# SPDX-License-Identifier: BSD-3-Clause
"""Logs of WITSML as Tables: of 1.3.1.1 and 1.4.1.1 one for each logData; of 2.0 see channel_sets.py."""
import csv
import re

from drill_rig_sim.field.cells import is_number
from drill_rig_sim.field.channel_sets import NotInTime, sets_of, table_of_set, wells_of
from drill_rig_sim.field.files import text_of
from drill_rig_sim.field.said import not_measured
from drill_rig_sim.field.signals import RANKS, word
from drill_rig_sim.field.table import RecordError, Table, shown
from drill_rig_sim.field.units import same_unit

DECLARATION = re.compile(r"<\?xml[^>]*\?>\s*")
TIME_INDEX = {"date time": True, "datetime": True, "elapsed time": False, "time": None}  # whether its cells are dates


def read_witsml(file, data, times=()):
    """Tables of the document `data` (bytes) that have an index or a curve of time; the others are reported in the first's remarks. RecordError where none has, and
    where the logs are of several wells. `times`: names of a curve of time, besides those of the trade."""
    root, remarks = parsed(file, data)
    root, more = answer_in(file, root)
    remarks += more
    logs = [log for log in root.iter("{*}log") if log.find("{*}logData") is not None]
    sets = [] if logs else sets_of(root)
    if not logs and not sets:
        raise RecordError("%s: its root is %s, and it holds no log of WITSML 1.3.1.1, 1.4.1.1 or 2.0 with data" % (file, name_of(root)))
    wells = wellbores_of(logs) or [(title, "") for title in wells_of(root)]
    if len(wells) > 1:
        raise RecordError("%s: holds logs of %d wellbores (%s); needed: one" % (file, len(wells), ", ".join("/".join(filter(None, well)) for well in wells)))
    tables, passed = [], []
    for number, log in enumerate(logs or sets, 1):
        try:
            tables += tables_of_log(file, log, times) if logs else [table_of_set(file, *log, times)]
        except NotInTime as reason:
            passed.append((number, reason))
    if not tables:
        raise RecordError("%s: %s" % (file, passed[0][1] if passed else "its logs hold no rows"))
    for table in tables:
        table.well = wells[0] if wells else ("", "")
    tables[0].remarks += remarks + states_of(logs or [log for log, *_ in sets] + list(root.iter("{*}Log"))) + ["log %d is skipped: %s" % one for one in passed]
    return tables


def states_of(logs):
    """A line where a log reports that its values are not measured: by its state (`actual`, `model`, `plan`; of WITSML 2 `ExistenceKind`) or in words."""
    for log in logs:
        state = next((log.findtext(path) for path in ("{*}commonData/{*}itemState", "{*}Existence", "{*}ExistenceKind") if log.findtext(path)), "").strip()
        texts = ["data type: " + state] if state else []
        texts += [(log.findtext(path) or "").strip() for path in ("{*}name", "{*}description", "{*}commonData/{*}comments", "{*}Citation/{*}Title", "{*}Citation/{*}Description")]
        found = next((said for said in map(not_measured, texts) if said), "")
        if found:
            return ["its log says that its values are not measured: %s" % found]
    return []


def name_of(element):
    return element.tag.rpartition("}")[2]


def tables_of_log(file, log, times):
    return [table_of(file, log, block, times) for block in log.findall("{*}logData") if block.find("{*}data") is not None]


def wellbores_of(logs):
    """(well, wellbore) of these logs, by name, or by uid where names are missing or alike."""
    found = []
    for log in logs:
        uids = [(log.get(name) or "").strip() for name in ("uidWell", "uidWellbore")]
        names = [(log.findtext("{*}" + name) or "").strip() for name in ("nameWell", "nameWellbore")]
        if not any(are_of_one(uids, names, *known) for known in found):
            found.append((uids, names))
    named = [tuple(names) for _, names in found if all(names)]
    return sorted(named if len(set(named)) == len(found) else [tuple(uids) for uids, _ in found])


def are_of_one(uids, names, other_uids, other_names):
    """Whether two logs are of one wellbore: by their uids, where one has none by their names."""
    if all(uids) and all(other_uids):
        return uids == other_uids
    return [word(name) for name in names] == [word(name) for name in other_names]


def answer_in(file, root):
    """The document in the answer of a server (SOAP), and lines on its encoding; the root itself where it is none."""
    inner = next(root.iter("{*}XMLout"), None)
    text = (inner.text or "").strip() if inner is not None else ""
    return parsed(file, DECLARATION.sub("", text).encode()) if text.startswith("<") else (root, [])


def parsed(file, data):
    """(root of the document, lines on its encoding). Bytes that are not in the encoding they declare are read as other text files are."""
    try:
        from lxml import etree
    except ImportError:
        raise RecordError("%s: WITSML needs Debian's python3-lxml" % file)
    parser = etree.XMLParser(resolve_entities=False, no_network=True, load_dtd=False, huge_tree=False)
    remarks = []
    try:
        root = etree.fromstring(data, parser)
    except (etree.XMLSyntaxError, ValueError) as error:
        try:
            text, remarks = text_of(file)
            root = etree.fromstring(DECLARATION.sub("", text.lstrip()).encode(), parser)
        except (etree.XMLSyntaxError, ValueError, RecordError):
            raise RecordError("%s: is not valid XML: %s" % (file, " ".join(str(error).split())))
    if root.getroottree().docinfo.doctype:
        raise RecordError("%s: has a document type definition; WITSML has none" % file)
    return root, remarks


def table_of(file, log, block, times):
    """A Table of one logData."""
    infos, delimiter = curves_of(log), delimiter_of(log)
    rows, places = rows_of(block, delimiter)
    names, units, remarks = columns_of(file, with_list(log, block), infos, delimiter, max(map(len, rows)))
    rows = [fitted(file, row, place, names) for row, place in zip(rows, places)]
    index, dated, in_order = index_of(log, names, infos, times)
    if dated is False:
        units[index] = units[index] or (log.find("{*}startIndex").get("uom") if log.find("{*}startIndex") is not None else None)
    if in_order and (log.findtext("{*}direction") or "increasing").strip().lower() == "decreasing":
        rows, places = rows[::-1], places[::-1]
    nulls = [[null for null in (log.findtext("{*}nullValue"), infos.get(name, {}).get("null")) if null is not None] for name in names]
    rows = [[blank_where_null(cell, texts) for cell, texts in zip(row, nulls)] for row in rows]
    return Table(file, names, units, rows, places, [[float(null) for null in texts if is_number(null)] for texts in nulls], index, dated, remarks)


def delimiter_of(log):
    said = log.findtext("{*}dataDelimiter") or ","
    return said.strip() or said


def index_of(log, names, infos, times):
    """(place of the column of time, whether it holds dates or None, whether the log's direction is that of the time)."""
    kind, said = (log.findtext("{*}indexType") or "").strip().lower(), (log.findtext("{*}indexCurve") or "").strip().lower()
    named = [place for place, name in enumerate(names) if name.lower() == said]
    if not kind or kind in TIME_INDEX:
        return next(iter(named + time_curves(names, infos, times)), 0), TIME_INDEX.get(kind), True
    places = [place for place in time_curves(names, infos, times) if place not in named or names[place].lower() in times]
    if not places:
        raise NotInTime("its index is %s, and none of its curves is a time (%s); needed: a log by time" % (kind, shown(names)))
    typed = infos.get(names[places[0]], {}).get("type")
    return places[0], None if typed is None else typed == "date time", False


def time_curves(names, infos, times):
    """Places: of those in `times`, then of those whose type is a time's, then of those with a name of the trade."""
    asked = [place for place, name in enumerate(names) if name.lower() in times]
    dates = [place for place, name in enumerate(names) if infos.get(name, {}).get("type") == "date time"]
    return asked + dates + [place for place, name in enumerate(names) if word(name) in RANKS["time"]]


def blank_where_null(cell, nulls):
    """A null that is a text, or one of dates, is compared as it stands; numbers are compared later."""
    cell = cell.strip()
    return "" if any(cell == null.strip() for null in nulls) else cell


def curves_of(log):
    """Of each mnemonic its unit, null value, type and place."""
    found = {}
    for info in log.findall("{*}logCurveInfo"):
        name = (info.findtext("{*}mnemonic") or info.get("uid") or "").strip()
        found[name] = {"unit": (info.findtext("{*}unit") or "").strip() or None, "null": info.findtext("{*}nullValue"),
                       "type": (info.findtext("{*}typeLogData") or "").strip() or None, "column": info.findtext("{*}columnIndex")}
    return found


def columns_of(file, block, infos, delimiter, most):
    """Names, units and remarks: of 1.4.1.1 in the logData, of 1.3.1.1 by each curve's columnIndex. `most`: values of a row."""
    said = block.findtext("{*}mnemonicList")
    if said is not None:
        return listed(file, block, infos, "," if "," in said else delimiter)
    if not infos:
        raise RecordError("%s: a log names no curves: it has neither mnemonicList nor logCurveInfo" % file)
    names = list(infos)
    if all((info["column"] or "").strip().isdecimal() for info in infos.values()):
        names = by_place(file, {name: int(info["column"]) for name, info in infos.items()}, most)
    return names, [infos.get(name, {}).get("unit") for name in names], []


def with_list(log, block):
    """The logData, or where it names no columns the first of the log that does: the order of the logCurveInfo may be another."""
    return next((one for one in (block, *log.findall("{*}logData")) if one.find("{*}mnemonicList") is not None), block)


def listed(file, block, infos, delimiter):
    names = [name.strip() for name in block.findtext("{*}mnemonicList").split(delimiter)]
    known = [infos.get(name, {}).get("unit") for name in names]
    if not (block.findtext("{*}unitList") or "").strip():
        return names, known, []
    units = [unit.strip() or None for unit in (block.findtext("{*}unitList") or "").split(delimiter)]
    if len(units) != len(names):
        raise RecordError("%s: mnemonicList has %d names, unitList %d units; needed: one unit for each name" % (file, len(names), len(units)))
    return names, units, ["%s: its unit is %s in unitList, %s in logCurveInfo: unitList is used" % (name, unit, other)
                          for name, unit, other in zip(names, units, known) if unit and other and not same_unit(unit, other)]


def by_place(file, places, most):
    """Names in the order of columnIndex; empty ones where a row holds columns that no curve names. RecordError where two have the same."""
    names = sorted(places, key=places.get)
    for one, other in zip(names, names[1:]):
        if places[one] == places[other]:
            raise RecordError("%s: %s and %s have the same columnIndex %d; needed: a column for each curve" % (file, one, other, places[one]))
    first = min(min(places.values()), 1)
    if most <= len(names):
        return names
    by_column = {place: name for name, place in places.items()}
    return [by_column.get(place, "") for place in range(first, 1 + max(places.values()))]


def rows_of(block, delimiter):
    """Cells of each row, and where it stands. Texts that hold the delimiter are in quotes; an element may hold a row in each line."""
    rows, places = [], []
    for number, data in enumerate(block.findall("{*}data"), 1):
        lines = [line.strip() for line in (data.text or "").split("\n") if line.strip()]
        apart = len(lines) > 1 and delimiter in lines[0] and len({line.count(delimiter) for line in lines}) == 1
        for text in lines if apart else [" ".join((data.text or "").split("\n"))]:
            quoted = '"' in text and len(delimiter) == 1
            rows.append(next(csv.reader([text], delimiter=delimiter, skipinitialspace=True)) if quoted else text.split(delimiter))
            places.append("%d: data row %d" % (data.sourceline, number))
    return rows, places


def fitted(file, row, place, names):
    """The row, as long as the names; RecordError where it is not."""
    if len(row) > len(names) and not any(cell.strip() for cell in row[len(names):]):
        row = row[:len(names)]
    if len(row) != len(names):
        raise RecordError("%s:%s has %d values, there are %d curves (%s); needed: one value for each curve" % (file, place, len(row), len(names), shown(names, 8)))
    return row
