"""Logs of WITSML 1.3.1.1 and 1.4.1.1 as Tables, one for each logData."""
from drill_rig_sim.field.signals import RANKS, word
from drill_rig_sim.field.table import RecordError, Table, is_number, shown

TIME_INDEX = {"date time": True, "elapsed time": False}  # whether its cells are dates


class NotInTime(Exception):
    """Why a log cannot be put on a time axis."""


def read_witsml(file, data):
    """Tables of the document `data` (bytes) that have an index or a curve of time; the others are reported in the first's remarks. RecordError where none has, and
    where the logs are of several wells."""
    logs = [log for log in parsed(file, data).iter("{*}log") if log.find("{*}logData") is not None]
    if not logs:
        raise RecordError("%s: holds no log of WITSML 1.3.1.1 or 1.4.1.1 with data" % file)
    wells = sorted({wellbore_of(log) for log in logs})
    if len(wells) > 1:
        raise RecordError("%s: holds logs of %d wellbores (%s); needed: one" % (file, len(wells), ", ".join(wells)))
    tables, passed = [], []
    for number, log in enumerate(logs, 1):
        try:
            tables += [table_of(file, log, block) for block in log.findall("{*}logData") if block.find("{*}data") is not None]
        except NotInTime as reason:
            passed.append((number, reason))
    if not tables:
        raise RecordError("%s: %s" % (file, passed[0][1] if passed else "its logs hold no rows"))
    tables[0].remarks += ["log %d is passed over: %s" % one for one in passed]
    return tables


def wellbore_of(log):
    return "%s/%s" % (log.get("uidWell") or log.findtext("{*}nameWell") or "", log.get("uidWellbore") or log.findtext("{*}nameWellbore") or "")


def parsed(file, data):
    try:
        from lxml import etree
    except ImportError:
        raise RecordError("%s: WITSML needs Debian's python3-lxml" % file)
    try:
        root = etree.fromstring(data, etree.XMLParser(resolve_entities=False, no_network=True, load_dtd=False, huge_tree=False))
    except (etree.XMLSyntaxError, ValueError) as error:
        raise RecordError("%s: is no XML: %s" % (file, " ".join(str(error).split())))
    if root.getroottree().docinfo.doctype:
        raise RecordError("%s: has a document type definition; WITSML has none" % file)
    return root


def table_of(file, log, block):
    """A Table of one logData."""
    infos = curves_of(log)
    names, units = columns_of(file, block, infos)
    index, dated, in_order = index_of(log, names, infos)
    rows, places = rows_of(file, block, names, log.findtext("{*}dataDelimiter") or ",")
    if in_order and (log.findtext("{*}direction") or "increasing").strip() == "decreasing":
        rows, places = rows[::-1], places[::-1]
    nulls = [[null for null in (log.findtext("{*}nullValue"), infos.get(name, {}).get("null")) if null is not None] for name in names]
    rows = [[blank_where_null(cell, texts) for cell, texts in zip(row, nulls)] for row in rows]
    return Table(file, names, units, rows, places, [[float(null) for null in texts if is_number(null)] for texts in nulls], index, dated)


def index_of(log, names, infos):
    """(place of the column of time, whether it holds dates or None, whether the log's direction is that of the time)."""
    kind, index = (log.findtext("{*}indexType") or "").strip().lower(), (log.findtext("{*}indexCurve") or "").strip()
    if not kind or kind in TIME_INDEX:
        return names.index(index) if index in names else 0, TIME_INDEX.get(kind), True
    index = time_curve(names, infos, kind)
    said = infos.get(names[index], {}).get("type")
    return index, None if said is None else said == "date time", False


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


def columns_of(file, block, infos):
    """Names and units: of 1.4.1.1 in the logData, of 1.3.1.1 by each curve's columnIndex."""
    said = block.findtext("{*}mnemonicList")
    if said is not None:
        names = [name.strip() for name in said.split(",")]
        units = [infos.get(name, {}).get("unit") for name in names]
        if block.find("{*}unitList") is not None:
            units = [unit.strip() or None for unit in (block.findtext("{*}unitList") or "").split(",")]
        if len(units) != len(names):
            raise RecordError("%s: mnemonicList has %d names, unitList %d units; needed: as many" % (file, len(names), len(units)))
        return names, units
    if not infos:
        raise RecordError("%s: a log names no curves: it has neither mnemonicList nor logCurveInfo" % file)
    names = list(infos)
    if all((info["column"] or "").strip().isdecimal() for info in infos.values()):
        names.sort(key=lambda name: int(infos[name]["column"]))
    return names, [infos[name]["unit"] for name in names]


def time_curve(names, infos, index_type):
    """The place of a depth log's curve of time. NotInTime where it has none."""
    dates = [name for name in names if infos.get(name, {}).get("type") == "date time"]
    named = [name for name in names if word(name) in RANKS["time"]]
    if not dates and not named:
        raise NotInTime("its index is %s, and none of its curves is a time (%s); needed: a log by time" % (index_type, shown(names)))
    return names.index((dates or named)[0])


def rows_of(file, block, names, delimiter):
    """Cells of each row, and where it stands."""
    rows, places = [], []
    for number, data in enumerate(block.findall("{*}data"), 1):
        row = (data.text or "").split(delimiter)
        if len(row) > len(names) and not any(cell.strip() for cell in row[len(names):]):
            row = row[:len(names)]
        if len(row) != len(names):
            raise RecordError("%s:%d: data row %d has %d values, there are %d curves (%s); needed: as many" %
                              (file, data.sourceline, number, len(row), len(names), shown(names, 8)))
        rows.append(row)
        places.append("%d: data row %d" % (data.sourceline, number))
    return rows, places
