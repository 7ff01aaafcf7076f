# SPDX-License-Identifier: BSD-3-Clause
"""A table of texts with named columns: what a delimited file, a WITSML log and a LAS file have in common. Its cells become signals in signal_reader.py."""
import csv
import re
import typing

import numpy
from drill_rig_sim.field.cells import GROUPED, are_groups, first_decimal_comma, first_of_both_signs, first_of_groups, has_point, is_blank, is_number, with_point
from drill_rig_sim.field.dates import without_zone
from drill_rig_sim.field.heading import BLANK, CELL, COMMENT, WIDE, Wanted, are_places, heading_of, holds_data, is_line_of_units, name_in, names_in, split
from drill_rig_sim.field.native import of_module
from drill_rig_sim.field.said import remark_of
from drill_rig_sim.field.signals import RANKS, SIGNALS, word
from drill_rig_sim.field.units import is_unit, same_unit
from drill_rig_sim.refusal import Refusal

BRACKET = re.compile(r"(.*\S)\s*(?:\(([^()]*(?:\([^()]*\)[^()]*)*)\)|\[([^\[\]]*)\]|<([^<>]*)>|\{([^{}]*)\})$")
WORD = re.compile(r"\S+")  # of a line
FACTOR = re.compile(r"([x\u00d7*])\s*(?:10\s*(?:\^|\*\*)?\s*-?[\d\u2070\u00b9\u00b2\u00b3\u2074-\u2079\u207b]+|1e[+-]?\d|0?\.0*1|10*)(?![\d.])(?:\s+\D+)?$", re.IGNORECASE)  # `x1000`, `*0.1`
LONGEST_NAME, LONGEST_TEXT = 200, 60  # of a name with a factor, of a line in a message
SIGNED_POWER = r"10\s*(?:\^|\*\*)\s*-?\d+|10[\u2070\u00b9\u00b2\u00b3\u2074-\u2079\u207b]+"
POWER = re.compile(SIGNED_POWER + r"|10{2,6}")  # alone in brackets: `Hook Load (1000) (lbf)`
LAST_POWER = re.compile(r"(?<![\w.^*\u00d7])(?:%s)$" % SIGNED_POWER)  # `Hook Load 10^3 (lbf)`; that with an x is a FACTOR
ALL_NAMES = {name for ranks in RANKS.values() for name in ranks}
SEPARATOR, MOST_PARTS = re.compile(r"\s*[,/_]\s*|\s+(?:-\s+)?"), 4  # before a unit without brackets, and the most parts of its own: `gal_per_min`


class RecordError(Refusal):
    """What is wrong with a record, in one line."""


class Table:
    """`names` and `units` (None where the file does not say) by column; `rows`: lists of texts, all as long as `names`; `place(k)`: where row k stands, as
    FILE:LINE or FILE: row N. `nulls`: values that stand for no number, by column. `index`: place of the column that the file calls its index, or None, and
    `index_is_date`, None where the file does not say. `remarks`: what was noticed, without the file's name. `unit_cells`: of columns whose cells hold their unit, the
    first such cell. `well`: names of well and wellbore, "" where the file does not say. `in_any_order`: the file does not say that its rows are in the order of time. `title`:
    (line number, text) above the names."""

    def __init__(self, file, names, units, rows, places, nulls=None, index=None, index_is_date=None, remarks=()):
        self.file, self.names, self.units, self.rows, self.places = file, names, units, rows, places
        self.unit_cells, self.well, self.in_any_order, self.title = {}, ("", ""), False, []
        self.nulls = nulls or [()] * len(names)
        self.index, self.index_is_date, self.remarks = index, index_is_date, list(remarks)

    def place(self, k):
        return "%s:%s" % (self.file, self.places[k])

    def places_of(self, name):
        """Of the columns of a name; a unit in brackets may be left out."""
        asked = name.strip().lower()
        return [place for place, known in enumerate(self.names) if known == name] or [place for place, known in enumerate(self.names) if known.lower() == asked] or \
               [place for place, known in enumerate(self.names) if bare(known).lower() == asked]

    def column(self, name):
        """The place of a column by its name. RecordError where there is none or where there are two."""
        places = self.places_of(name)
        if len(places) == 1:
            return places[0]
        raise RecordError("%s: %s %s; columns: %s" % (self.file, "there is no column" if not places else "there are %d columns" % len(places), name, self.header()))

    def numbers(self, name, may_be_empty=False):
        """Of a column without nulls and texts, as the simulator writes it: an array, nan where a cell is empty and may be. RecordError with the first cell that is
        no finite number."""
        place = self.column(name)
        cells = [row[place] for row in self.rows]
        found = numpy.array([float(cell) if is_number(cell) else numpy.nan for cell in cells], dtype=float)
        odd = numpy.flatnonzero(~numpy.isfinite(found))
        wrong = next((k for k in odd if not (may_be_empty and is_blank(cells[k]))), None)
        if wrong is not None:
            raise RecordError("%s: %s: %s is not a finite number" % (self.place(wrong), name, cells[wrong].strip() or "an empty cell"))
        return found

    def header(self):
        return shown(self.names)


def shown(names, most=40):
    """A list of names for one line of a message."""
    return ", ".join(name or "(no name)" for name in names[:most]) + (", and %d more" % (len(names) - most) if len(names) > most else "")


DELIMITERS = {"comma": ",", "semicolon": ";", "tab": "\t", "bar": "|", "blank": BLANK, ",": ",", ";": ";", "\t": "\t", "|": "|"}


class Layout(typing.NamedTuple):
    """`delimiter` of the cells (WIDE, BLANK: blanks align the columns) and `decimal` sign of a delimited file; None where they are to be recognised."""
    delimiter: typing.Optional[str] = None
    decimal: typing.Optional[str] = None


def read_delimited(file, text, layout=Layout(), wanted=Wanted()):
    """A Table of a file with one line or more that name its columns (`wanted`: by which names). Lines that are empty or begin with # are passed over, and a title
    before the names. A line of units may follow them. Every other row must have as many cells as the header: one too many is a decimal comma or a comma in a text,
    one too few a row cut off."""
    lines, delimiter = without_mark_of_excel(lines_of(text), layout.delimiter)
    heading = heading_of(lines, delimiter, wanted)
    names = without_empty_end(heading.names) if heading else []
    if not names:
        raise RecordError("%s: is empty; needed: a line with the names of the columns, then rows" % file)
    check_delimiter(file, heading)
    rows = rows_of(file, lines, heading, len(heading.names))
    units, remarks, table, places = [unit_in(name) for name in names], heading.remarks + remark_of(enumerate(lines[:heading.first], 1)), [], []
    keep, well, before, texts = set(wanted.places(names)), OneWell(file, names), None, []
    again = Again(file, [names_in(one, heading.delimiter) for one in lines[heading.first:heading.last + 1]] + [heading.names], wanted)
    for line, cells in rows:
        if table and not holds_data(cells) and again.is_header(line, cells, units):
            continue
        if heading.known and not table and (are_places(cells) or not holds_data(cells) and not is_line_of_units(cells)):
            remarks.append("line %d is skipped: it holds neither units nor measurements" % line)
            continue
        if table and not holds_data(cells) and (len(cells) < len(names) or sum(map(bool, map(str.strip, cells))) == 1):
            texts.append(line)
            continue
        cells = fitted(cells, file, line, names, len(heading.names))
        if not table and is_line_of_units(cells):
            units = [unit_of_both(file, line, *both) for both in zip(names, cells, units)]
            remarks.append("line %d was read as the units of the columns" % line)
        else:
            well.check(line, cells)
            if heading.delimiter in (BLANK, WIDE):
                before = below(file, line, lines[line - 1], before, names)
            table.append([cell if place in keep else "" for place, cell in enumerate(cells)])
            places.append(str(line))
    remarks += again.remarks()
    if texts:
        remarks.append("%d lines of text between the rows or after them are skipped (first: line %d: %s)" % (len(texts), texts[0], lines[texts[0] - 1].strip()[:LONGEST_TEXT]))
    beside = set(texts)
    well.check_texts([(k, line) for k, line in enumerate(lines, 1) if k <= heading.first or COMMENT.match(line) or k in beside])
    decimal = layout.decimal or likely_decimal(file, table, places, heading.delimiter, remarks)
    found = Table(file, names, units, numbers_with_points(file, table, places, decimal), places, remarks=remarks)
    found.in_any_order, found.title = True, list(enumerate(lines[:heading.first], 1))
    return found


def check_delimiter(file, heading):
    """RecordError where another sign parts the cells as well, or where names hold the delimiter, as commas before units."""
    called = {sign: name for name, sign in DELIMITERS.items() if name.isalpha()}
    if heading.tie:
        raise RecordError("%s:%d: names and rows can be split at %s or at %s, with different results; needed: delimiter: %s or %s in a map" %
                          (file, heading.first + 1, *2 * (called[heading.delimiter], called[heading.tie])))
    units = [unit for name, unit in zip(heading.names, heading.names[1:]) if word(name) in ALL_NAMES and is_unit(unit) and word(unit) not in ALL_NAMES]
    if heading.delimiter == "," and len(units) > 1:
        raise RecordError("%s:%d: its names contain the delimiter, a comma before the unit (%s); needed: names in quotes, or units in brackets" % (file, heading.first + 1, shown(units, 4)))


class OneWell:
    """Columns that name the well of a row, and lines that name it: it must be the same in all."""

    def __init__(self, file, names):
        self.file, self.names, self.wells = file, names, {place: None for place, name in enumerate(names) if of_module().names_well(bare(name))}

    def check(self, line, cells):
        for place, well in self.wells.items():
            cell = cells[place].strip()
            if cell and well and cell.lower() != well.lower():
                raise RecordError("%s:%d: %s is %s, in the rows above %s; needed: one well in a file" % (self.file, line, self.names[place], cell, well))
            self.wells[place] = well or cell

    def check_texts(self, texts):
        """Of (line number, text) that are no rows, in their order."""
        other = of_module().other_well("\n".join(text for _, text in texts))
        if other:
            raise RecordError("%s:%d: is of %s, the lines above of %s; needed: one well in a file" % (self.file, texts[other[0] - 1][0], *other[1:]))


def below(file, line, text, before, names):
    """(line, begin and end of its cells) of a row of aligned columns; None where tabs hide the places. RecordError where one of this row and the row `before` leaves a
    cell empty: the cells before it overlap, in the gap after them the other row has its whole cell, and the next cell stands at the column after that."""
    spans = next((found for found in ([match.span() for match in form.finditer(text)] for form in (WORD, CELL)) if len(found) == len(names)), None)
    if spans is None or "\t" in text:
        return None
    if before:
        k = next((k for k, both in enumerate(zip(spans, before[1])) if not overlap(*both)), 0)
        if 0 < k < len(names) - 1 and any(a[k - 1][1] < b[k][0] and b[k][1] < a[k][0] and overlap(a[k], b[k + 1]) for a, b in ((spans, before[1]), (before[1], spans))):
            raise RecordError("%s:%d: the cells are not aligned with those of line %d from %s on: a cell is empty in one of these lines; needed: - in empty cells" %
                              (file, line, before[0], names[k]))
    return line, spans


def overlap(one, other):
    return max(one[0], other[0]) < min(one[1], other[1])


class Again:
    """A header that stands again between the rows, as in files that were put together: passed over where it is the same, refused where it is another."""

    def __init__(self, file, heads, wanted):
        self.file, self.heads, self.wanted, self.lines = file, heads, wanted, []

    def is_header(self, line, cells, units):
        """Whether a row without data is the header or the line of units again. RecordError where it is another one."""
        found = [name_in(cell) for cell in cells]
        if found in self.heads:
            self.lines.append(line)
            return True
        if is_line_of_units(cells):
            differ = next((both for both in zip(units, found) if all(both) and not same_unit(*(text.strip(" []()<>{}") for text in both))), None)
            if differ:
                raise RecordError("%s:%d: has other units than the rows before it (%s, not %s); needed: one unit in a column, or a file for each part" %
                                  (self.file, line, differ[1], differ[0]))
            return True
        if self.wanted.count(found):
            raise RecordError("%s:%d: has other names of columns than the header (%s); needed: one header, or a file for each part" % (self.file, line, shown(found, 8)))
        return False

    def remarks(self):
        return ["%d lines repeat the names of the columns and are skipped (first: line %d)" % (len(self.lines), self.lines[0])] if self.lines else []


def unit_of_both(file, line, name, cell, unit):
    """Of the line of units and of the column's name, which may hold only a factor; RecordError where they differ."""
    said = cell.strip(" []()<>{}")
    if said and unit and FACTOR.fullmatch(unit):
        return "%s %s" % (unit, said)
    if said and unit and not same_unit(said, unit):
        raise RecordError("%s:%d: the unit of %s is %s here; needed: the same, or one of them" % (file, line, name, said))
    return said or unit


def without_mark_of_excel(lines, delimiter):
    """The lines without a first one such as `sep=;`, and the delimiter that it names."""
    mark = re.match(r"\s*\"?sep=(.)\"?\s*$", lines[0], re.IGNORECASE)
    return (["", *lines[1:]], delimiter or mark.group(1)) if mark else (lines, delimiter)


def likely_decimal(file, table, places, delimiter, remarks):
    """The decimal sign where the other one stands between groups of digits, the comma where some numbers have one and none has a point, else None. RecordError where
    the commas may as well group the digits of whole numbers."""
    point, comma = first_of_both_signs(table, "."), None if delimiter == "," else first_of_both_signs(table, ",")
    if point and comma:
        raise RecordError("%s:%s: %s has another decimal sign than %s (line %s); needed: one decimal sign in all numbers" %
                          (file, places[comma[0]], comma[1], point[1], places[point[0]]))
    point = point or (None if comma else first_of_groups(table))
    if point:
        remarks.append("its numbers have commas between groups of digits (first: line %s: %s)" % (places[point[0]], point[1]))
        return "."
    found = comma or first_decimal_comma(table)
    if found is None:
        return None
    if not comma and delimiter != ";" and are_groups(table):  # a semicolon is written where the comma is the decimal sign
        raise RecordError("%s:%s: %s may be a whole number or one with a decimal comma; needed: decimal: comma or point in a map" %
                          (file, places[found[0]], found[1]))
    remarks.append("its numbers have decimal commas (first: line %s: %s)" % (places[found[0]], found[1]))
    return ","


def numbers_with_points(file, table, places, decimal):
    """The cells, numbers as Python reads them. RecordError where a number with a point stands among those with commas."""
    for place, row in zip(places, table if decimal == "," else ()):
        odd = next((cell for cell in row if has_point(cell) and not GROUPED[","].match(cell.strip())), None)
        if odd is not None:
            raise RecordError("%s:%s: %s has a decimal point; needed: decimal commas in all numbers, as the map says" % (file, place, odd.strip()))
    return [[cell and with_point(cell, decimal) for cell in row] for row in table]


def lines_of(text):
    """As an editor counts them, with the line ends of any system and without its mark of the end of a file (DOS)."""
    return text.rstrip("\x1a\r\n").replace("\r\n", "\n").replace("\r", "\n").split("\n")


def rows_of(file, lines, heading, count):
    """Number of the first line and cells of each row below the heading that is neither empty nor a comment. `count`: of the columns."""
    header = heading.first == heading.last  # is read with the rows: its cells may go over lines
    first = heading.first if header else heading.last + 1
    try:
        for line, cells in split(lines[first:], heading.delimiter, count):
            if any(cell.strip() for cell in cells) and (cells[0].strip() == "#" or not cells[0].lstrip().startswith("#")):
                if not header:
                    yield first + line, cells
                header = False
    except csv.Error as error:
        raise RecordError("%s: %s" % (file, error))


def without_empty_end(names):
    while len(names) > 1 and not names[-1]:
        names = names[:-1]
    return names


def fitted(cells, file, line, names, most):
    """The cells, as many as there are names; RecordError with the line where they are not. `most`: cells of the header, empty ones too. Each value
    of a row of whole numbers may have a decimal comma, where as many cells at its end are empty."""
    more, filled = len(cells) - most, sum(1 for cell in cells if cell.strip())
    has_commas = more > 1 and filled == 2 * more and not any(map(has_point, cells))
    if len(cells) > len(names) and not any(cell.strip() for cell in cells[len(names):]) and not has_commas:
        return cells[:len(names)]
    if len(cells) != len(names):
        raise RecordError("%s:%d: has %d cells, the header %d (%s); needed: the same number, and texts with a delimiter in quotes" %
                          (file, line, len(cells), len(names), shown(names, 8)))
    return cells


def unit_in(name):
    """Of a column called `Hook Load (klbs)`, `HKLD [kN]`, `Hook Load, kN`, `Hook Load kN` or `HKLD_kN`: klbs, kN; else None."""
    return parts_of(without_zone(name))[1]


def bare(name):
    """A column's name without its unit, a time zone and what else stands in brackets after it."""
    return parts_of(without_zone(name))[0]


def parts_of(name):
    """Name and unit. Of several brackets the unit is the last that is one, else the last; two units that differ are shown both, which is none. A factor stands before
    the unit: `Torque x100 (ft-lb)` is in x100 ft-lb."""
    rest, inside = apart(name)
    rest, factor = factor_apart(rest, inside)
    rest = apart(rest)[0] if factor else rest
    if inside:
        units = [text for text in inside if is_unit(text)]
        differ = any(not same_unit(units[0], other) for other in units[1:])
        unit = ", ".join(reversed(units)) if differ else (units or inside)[0] or None
        return rest, ("%s %s" % (factor, unit or "")).strip() if factor else unit
    if factor:
        return rest, factor
    for sign in list(SEPARATOR.finditer(name))[:-1 - MOST_PARTS:-1]:
        rest, unit = apart(name[:sign.start()])[0], name[sign.end():]
        if any(word(rest) in RANKS[signal] and is_unit(unit, SIGNALS[signal][0]) for signal in RANKS):
            return rest, unit
    return name, None


def factor_apart(rest, inside):
    """A name without the factor at its end, with a unit behind it perhaps, and these, as `x1000` or `x100 ft-lb`; "" without one. Takes one alone in brackets out of
    the texts `inside`."""
    alone = next((text for text in inside if FACTOR.fullmatch(text) and not is_unit(text) or POWER.fullmatch(text)), None)
    if alone is not None:
        inside.remove(alone)
        return rest, "x" + alone if POWER.fullmatch(alone) else alone
    power = LAST_POWER.search(rest)
    if power is not None and power.start():
        return rest[:power.start()].rstrip(" ,_"), "x" + power.group()
    found = FACTOR.search(rest) if len(rest) <= LONGEST_NAME else None
    if found is None or not found.start() or (found[1].lower() == "x" and rest[found.start() - 1].isalnum() and word(rest[:found.start()]) not in ALL_NAMES):
        return rest, ""
    return rest[:found.start()].rstrip(" ,_"), found.group()


def apart(name):
    """A name without the brackets at its end, and what stands in these, the last first."""
    inside = []
    while (match := BRACKET.match(name)) is not None:
        name = match.group(1).strip()
        inside.append(next(text for text in match.groups()[1:] if text is not None).strip())
    return name, inside
