# SPDX-License-Identifier: BSD-3-Clause
"""Log ASCII Standard, LAS 1.2, 2.0 and 3.0 (Canadian Well Logging Society), as Tables."""
import csv
import re

from drill_rig_sim.field.cells import is_number
from drill_rig_sim.field.channel_sets import NotInTime
from drill_rig_sim.field.column_finder import DATES
from drill_rig_sim.field.dates import form_in, is_time_of_day, seconds_of
from drill_rig_sim.field.said import remark_of
from drill_rig_sim.field.signals import RANKS, word
from drill_rig_sim.field.table import RecordError, Table, lines_of, shown
from drill_rig_sim.field.units import is_unit, same_unit

LINE = re.compile(r"([^.:]*)\.((?:\d+ (?=[A-Za-z]))?\S*)(.*)$")  # NAME.UNIT  VALUE; of units `1000 lbf` alone has a blank
DELIMITERS = {"COMMA": ",", "TAB": "\t"}  # by DLM of ~V; blanks else
WORD = re.compile(r'"[^"]*"|\S+')
ABOUT = "VWPO"      # sections on the file, the well, parameters and others
REPEATED = "PO"  # sections that files have several times: none of them is read
VERSIONS = ("1.2", "1.20", "2", "2.0", "2.00", "3", "3.0", "3.00")
# of LAS 3.0: ~Log_Data[1] | Log_Definition[1], ~ASCII | Curve
TITLE = re.compile(r"~\s*(\w+\s*(?:\[\d+\])?)\s*(?:\|\s*(\w+\s*(?:\[\d+\])?))?")
BRACES = re.compile(r"\{([^{}]*)\}\s*(?:\|.*)?$")  # the format of a curve of LAS 3.0, at the end of its line


def read_las(file, text, times=()):
    """Tables of the logs that have an index or a curve of time; the others are reported in the first's remarks. RecordError where none has. `times`: names of such
    a curve, besides those of the trade."""
    sections = sections_of(file, text)
    version = values_in(next((lines for title, lines in sections if title[1:2].upper() == "V"), []))
    said = version.get("VERS", ("", "2.0"))[1]
    if said not in VERSIONS:
        raise RecordError("%s: is LAS %s; allowed: 1.2, 2.0 and 3.0" % (file, said))
    logs = logs_of_version_3(sections) if said.startswith("3") else logs_of(file, sections)
    well = values_in(next((lines for title, lines in sections if title[1:2].upper() == "W"), []))
    tables, passed = [], []
    for number, (curves, data) in enumerate(logs, 1):
        try:
            tables.append(table_of(file, curves, data, version, well, times, number == 1))
        except NotInTime as reason:
            passed.append((number, reason))
    if not tables:
        raise RecordError("%s: %s" % (file, passed[0][1] if passed else "has no section of a log with its curves; needed: ~Log_Data and ~Log_Definition, or ~ASCII and ~Curve"))
    tables[0].remarks += remark_of(texts_of(sections)) + ["log %d is skipped: %s" % one for one in passed]
    return tables


def texts_of(sections):
    """(line number, text) of what the sections before the curves say of the file: a line as it stands, and its description with its value."""
    for title, lines in sections:
        if title[1:2].upper() in ABOUT:
            for number, line in lines:
                said, _, description = line.rpartition(":")
                parts = LINE.match(said)
                yield number, line
                if parts:
                    yield number, "%s: %s" % (description.strip(), parts[3].strip())


def logs_of(file, sections):
    """Lines of curves and of data, of LAS 1.2 and 2.0: sections are known by their letters."""
    found = {}
    for title, lines in sections:
        letter = title[1:2].upper()
        if letter in found and letter not in REPEATED:
            raise RecordError("%s:%d: there is a second section ~%s; needed: one" % (file, lines.begin, letter))
        found[letter] = lines
    if "A" not in found or "C" not in found:
        raise RecordError("%s: has no section %s; needed: LAS with ~V, ~W, ~C and ~A" % (file, "~A" if "A" not in found else "~C"))
    return [(found["C"], found["A"])]


def logs_of_version_3(sections):
    """Lines of curves and of data of each log; sections are known by their titles. Other data, as of cores or tests, are passed over."""
    titles = [(TITLE.match(title), lines) for title, lines in sections]
    named = {plain(title[1]): lines for title, lines in titles if title}
    found = []
    for title, lines in titles:
        name = plain(title[1]) if title else ""
        if not re.fullmatch(r"a|ascii|log_data(\[\d+\])?", name):
            continue
        definitions = [plain(title[2] or ""), name.replace("data", "definition"), "curve", "c", "log_definition"]
        curves = next((named[one] for one in definitions if one in named and one != name), None)
        if curves is not None:
            found.append((curves, lines))
    return found


def plain(title):
    return re.sub(r"\s", "", title).lower()


def table_of(file, lines, data, version, well, times, first):
    """A Table of one log, the first or another one of the file. NotInTime where it is by depth and has no curve of time."""
    curves = [parts[:2] for parts in parts_of(lines)]
    names, units = [name for name, _ in curves], [unit.strip(" []()") or None for _, unit in curves]
    forms = forms_of(lines) if version.get("VERS", ("", ""))[1].startswith("3") else {}
    units = [forms.get(name, unit) for name, unit in zip(names, units)]
    null = well.get("NULL", ("", ""))[1]
    index = index_of(names, units, times)
    if index == 0:
        units[0] = units[0] or well.get("STRT", ("", ""))[0] or None
    rows, places = rows_of(file, data, names, version)
    remarks = start_differs(names, units, rows, well) if index == 0 and first else []
    if index == 0 and goes_down(well) and rows and not is_later(rows[-1][0], rows[0][0]):
        rows, places = rows[::-1], places[::-1]
    table = Table(file, names, units, rows, places, [(float(null),) if is_number(null) else ()] * len(names), index, remarks=remarks)
    table.well = well.get("WELL", ("", ""))[1], ""
    return table


def forms_of(lines):
    """Of curves with dates how these are written, as {YYYY-MM-DD hh:mm:ss} at the end of the line."""
    found = {}
    for _, line in lines:
        form, parts = BRACES.search(line), LINE.match(line)
        if form and parts and form_in(form[1]):
            found[parts[1].strip()] = form[1].strip()
    return found


def goes_down(well):
    """Whether the file says that its last row is the first in time."""
    step, start, stop = (well.get(name, ("", ""))[1] for name in ("STEP", "STRT", "STOP"))
    return is_later(start, stop) or is_number(step) and float(step) < 0.0


def is_later(one, other):
    """Whether it is, of two numbers or dates."""
    if is_number(one) and is_number(other):
        return float(one) > float(other)
    one, other = seconds_of(one), seconds_of(other)
    return bool(one and other and one > other)


class Lines(list):
    """Of a section, with their numbers, without empty lines and comments. `begin`: of its title."""

    def __init__(self, begin):
        super().__init__()
        self.begin = begin


def start_differs(names, units, rows, well):
    """Lines, where the index of ~W begins with another number or has another unit than its curve."""
    unit, start = well.get("STRT", ("", ""))
    lines = []
    if unit and units[0] and not (is_unit(unit, "time") and same_unit(unit, units[0])) and not form_in(unit):
        lines.append("%s: its unit is %s in ~C, that of STRT is %s: %s is used" % (names[0], units[0], unit, units[0]))
    first = rows[0][0] if rows else ""
    if is_number(start) and is_number(first) and abs(float(start) - float(first)) > 1e-3 * max(1.0, abs(float(start))):
        lines.append("STRT is %s, %s of the first row %s: the rows are used" % (start, names[0], first))
    return lines


def sections_of(file, text):
    """Title and Lines of each section."""
    found = []
    for number, line in enumerate(lines_of(text), 1):
        if line.lstrip().startswith("~"):
            found.append((line.strip(), Lines(number)))
        elif line.strip() and not line.lstrip().startswith("#"):
            if not found:
                raise RecordError("%s:%d: is before the first section" % (file, number))
            found[-1][1].append((number, line))
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
        cells = next(csv.reader([line], delimiter=delimiter, skipinitialspace=True))
        return [cell.strip(' "') for cell in (cells[:curves] if not any(cell.strip() for cell in cells[curves:]) else cells)]
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


def index_of(names, units, times):
    """The place of the curve in `times`, else the first curve where it is a time, else the first that is called so."""
    asked = [place for place, name in enumerate(names) if name.lower() in times]
    places = asked + [place for place, name in enumerate(names) if word(name) in RANKS["time"]]
    if not asked and names and units[0] and is_unit(units[0], "time") and (word(names[0]) not in DATES or not places):
        return 0
    if not places:
        raise NotInTime("its index is %s [%s], and none of its curves is a time (%s); needed: a log by time" %
                        (names[0] if names else "(none)", units[0] or "" if names else "", shown(names)))
    return places[0]
