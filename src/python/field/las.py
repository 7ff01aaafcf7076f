# SPDX-License-Identifier: BSD-3-Clause
"""Log ASCII Standard, LAS 1.2 and 2.0 (Canadian Well Logging Society), as a Table."""
import re

from drill_rig_sim.field.cells import is_number
from drill_rig_sim.field.column_finder import DATES
from drill_rig_sim.field.dates import is_time_of_day
from drill_rig_sim.field.signals import RANKS, word
from drill_rig_sim.field.table import RecordError, Table, lines_of, shown
from drill_rig_sim.field.units import is_unit, same_unit

LINE = re.compile(r"([^.:]*)\.((?:\d+ (?=[A-Za-z]))?\S*)(.*)$")  # NAME.UNIT  VALUE; of units `1000 lbf` alone has a blank
DELIMITERS = {"COMMA": ",", "TAB": "\t"}  # by DLM of ~V; blanks else
WORD = re.compile(r'"[^"]*"|\S+')
REPEATED = "PO"  # sections that files have several times: none of them is read


def read_las(file, text, times=()):
    """A Table of a log by time; RecordError where it is by depth and has no curve of time. `times`: names of such a curve, besides those of the trade."""
    sections = sections_of(file, text)
    version = values_in(sections.get("V", []))
    if "A" not in sections or "C" not in sections:
        raise RecordError("%s: has no section %s; needed: LAS 2.0 with ~V, ~W, ~C and ~A" % (file, "~A" if "A" not in sections else "~C"))
    if version.get("VERS", ("", "2.0"))[1] not in ("1.2", "1.20", "2.0", "2.00", "2"):
        raise RecordError("%s: is LAS %s; allowed: 1.2 and 2.0" % (file, version["VERS"][1]))
    curves = [parts[:2] for parts in parts_of(sections["C"])]
    names, units = [name for name, _ in curves], [unit.strip(" []()") or None for _, unit in curves]
    well = values_in(sections.get("W", []))
    null = well.get("NULL", ("", ""))[1]
    index = index_of(file, names, units, times)
    if index == 0:
        units[0] = units[0] or well.get("STRT", ("", ""))[0] or None
    rows, places = rows_of(file, sections["A"], names, version)
    remarks = start_differs(names, units, rows, well) if index == 0 else []
    return Table(file, names, units, rows, places, [(float(null),) if is_number(null) else ()] * len(names), index, remarks=remarks)


def start_differs(names, units, rows, well):
    """Lines, where the index of ~W begins with another number or has another unit than its curve."""
    unit, start = well.get("STRT", ("", ""))
    lines = []
    if unit and units[0] and not (is_unit(unit, "time") and same_unit(unit, units[0])):
        lines.append("%s: its unit is %s in ~C, that of STRT is %s: %s is used" % (names[0], units[0], unit, units[0]))
    first = rows[0][0] if rows else ""
    if is_number(start) and is_number(first) and abs(float(start) - float(first)) > 1e-3 * max(1.0, abs(float(start))):
        lines.append("STRT is %s, %s of the first row %s: the rows are used" % (start, names[0], first))
    return lines


def sections_of(file, text):
    """Lines with their numbers by the letter of their section; empty lines and comments are passed over."""
    found, lines = {}, None
    for number, line in enumerate(lines_of(text), 1):
        if line.lstrip().startswith("~"):
            letter = line.lstrip()[1:2].upper()
            if letter in found and letter not in REPEATED:
                raise RecordError("%s:%d: there is a second section ~%s; needed: one" % (file, number, letter))
            lines = found.setdefault(letter, [])
        elif line.strip() and not line.lstrip().startswith("#"):
            if lines is None:
                raise RecordError("%s:%d: is before the first section" % (file, number))
            lines.append((number, line))
    return found


def parts_of(lines):
    """Name, unit and value of each line that has them, without the description behind the last colon, which some programs leave out."""
    matches = (LINE.match(line.rpartition(":")[0] or line) for _, line in lines)
    return [[part.strip() for part in match.groups()] for match in matches if match]


def values_in(lines):
    """Unit and first word of the value by name."""
    return {name.upper(): (unit, (value.split() or [""])[0]) for name, unit, value in parts_of(lines)}


def rows_of(file, lines, names, version):
    """Of wrapped data a row goes on over lines until it has as many values as there are curves."""
    wrapped = version.get("WRAP", ("", "NO"))[1].upper() == "YES"
    delimiter = DELIMITERS.get(version.get("DLM", ("", ""))[1].upper())
    rows, places, cells, begun = [], [], [], None
    for number, line in lines:
        begun, cells = begun or number, cells + cells_of(line, delimiter, len(names))
        if wrapped and len(cells) < len(names):
            continue
        if len(cells) != len(names):
            raise RecordError("%s:%d: has %d values, there are %d curves (%s); needed: one value for each curve" % (file, begun, len(cells), len(names), shown(names, 8)))
        rows.append(cells)
        places.append(str(begun))
        cells, begun = [], None
    if cells:
        raise RecordError("%s:%d: the last row has %d values, there are %d curves" % (file, begun, len(cells), len(names)))
    return rows, places


def cells_of(line, delimiter, curves):
    """Of a line. Files with commas often have no DLM, and dates a blank before the time of the day."""
    if delimiter:
        return [cell.strip(' "') for cell in line.split(delimiter)]
    cells = [cell.strip('"') for cell in WORD.findall(line)]
    if len(cells) == curves:
        return cells
    commas = [cell.strip(' "') for cell in line.split(",")]
    if len(commas) == curves:
        return commas
    return with_whole_dates(cells) if len(cells) > curves else cells


def with_whole_dates(cells):
    """`2024-05-01`, `10:00:00` become one cell."""
    whole = []
    for cell in cells:
        if whole and is_time_of_day(cell) and not is_number(whole[-1]):
            whole[-1] += " " + cell
        else:
            whole.append(cell)
    return whole


def index_of(file, names, units, times):
    """The curve in `times`, else the first curve where it is a time, else the first that is called so."""
    asked = [place for place, name in enumerate(names) if name.lower() in times]
    places = asked + [place for place, name in enumerate(names) if word(name) in RANKS["time"]]
    if not asked and names and units[0] and is_unit(units[0], "time") and (word(names[0]) not in DATES or not places):
        return 0
    if not places:
        raise RecordError("%s: its index is %s [%s], and none of its curves is a time (%s); needed: a log by time" %
                          (file, names[0] if names else "(none)", units[0] or "" if names else "", shown(names)))
    return places[0]
