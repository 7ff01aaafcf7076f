"""A table of texts with named columns: what a delimited file, a WITSML log and a LAS file have in common. Its cells become signals in signal_reader.py."""
import csv
import re
import typing

import numpy
from drill_rig_sim.field.cells import GROUPED, are_groups, first_decimal_comma, has_point, is_blank, is_number, with_point
from drill_rig_sim.field.signals import RANKS, SIGNALS, word
from drill_rig_sim.field.units import TABLES, UnitError, factor_of, same_unit
from drill_rig_sim.refusal import Refusal

MOST_TITLE, MOST_LINES = 50, 10000  # lines before the names of the columns, and with comments
BLANK, WIDE = r"\s+", r"\s{2,}"  # delimiters of columns that are aligned
BRACKET = re.compile(r"(.*\S)\s*(?:\(([^()]*(?:\([^()]*\)[^()]*)*)\)|\[([^\[\]]*)\]|<([^<>]*)>|\{([^{}]*)\})$")
SEPARATOR, MOST_PARTS = re.compile(r"\s*[,/_]\s*|\s+"), 4  # before a unit without brackets, and so many of its own: `gal_per_min`
QUOTED = re.compile(r"'(.+)'$")  # a name; a cell in such quotes is a text for csv


class RecordError(Refusal):
    """What is wrong with a record, in one line."""


class Table:
    """`names` and `units` (None where the file does not say) by column; `rows`: lists of texts, all as long as `names`; `place(k)`: where row k stands, as
    FILE:LINE or FILE: row N. `nulls`: values that stand for no number, by column. `index`: place of the column that the file calls its index, or None, and
    `index_is_date`, None where the file does not say. `remarks`: what was noticed, without the file's name."""

    def __init__(self, file, names, units, rows, places, nulls=None, index=None, index_is_date=None, remarks=()):
        self.file, self.names, self.units, self.rows, self.places = file, names, units, rows, places
        self.nulls = nulls or [()] * len(names)
        self.index, self.index_is_date, self.remarks = index, index_is_date, list(remarks)

    def place(self, k):
        return "%s:%s" % (self.file, self.places[k])

    def column(self, name):
        """The place of a column by its name. RecordError where there is none or where there are two."""
        places = [place for place, known in enumerate(self.names) if known == name] or \
                 [place for place, known in enumerate(self.names) if known.lower() == name.strip().lower()]
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
            raise RecordError("%s: %s: %s is no finite number" % (self.place(wrong), name, cells[wrong].strip() or "an empty cell"))
        return found

    def header(self):
        return shown(self.names)


def shown(names, most=40):
    """A list of names for one line of a message."""
    return ", ".join(name or "(no name)" for name in names[:most]) + (", and %d more" % (len(names) - most) if len(names) > most else "")


class Layout(typing.NamedTuple):
    """`delimiter` of the cells (WIDE, BLANK: blanks align the columns) and `decimal` sign of a delimited file; None where they are to be recognised."""
    delimiter: typing.Optional[str] = None
    decimal: typing.Optional[str] = None


def read_delimited(file, text, layout=Layout(), is_header=lambda names: False, needed=None):
    """A Table of a file with a line that names its columns. Lines that are empty or begin with # are passed over, and a title before the names. A line of units
    may follow them. Every other row must have as many cells as the header: one too many is a decimal comma or a comma in a text, one too few a row cut off.
    `is_header(names)`: whether these are the columns' names, for files with a title. `needed(names)`: places of the columns to be kept, None: all."""
    lines, delimiter = without_mark_of_excel(lines_of(text), layout.delimiter)
    first, remarks = header_of(file, lines, delimiter, is_header)
    delimiter = delimiter or likely_delimiter(whole(lines, first))
    rows = rows_of(file, lines, first, delimiter)
    names = without_empty_end(list(map(name_in, next(rows, (0, []))[1])))
    if not names:
        raise no_header(file)
    units, table, places, before = [unit_in(name) for name in names], [], [], True
    keep = set(range(len(names)) if needed is None else needed(names))
    for line, cells in rows:
        cells = fitted(cells, file, line, names)
        if before and is_line_of_units(cells):
            units = [unit_of_both(file, line, *both) for both in zip(names, cells, units)]
            remarks.append("line %d was taken for the units of the columns" % line)
        else:
            table.append([cell if place in keep else "" for place, cell in enumerate(cells)])
            places.append(str(line))
        before = False
    decimal = layout.decimal or likely_decimal(file, table, places, delimiter, remarks)
    return Table(file, names, units, numbers_with_points(file, table, places, decimal), places, remarks=remarks)


def unit_of_both(file, line, name, cell, unit):
    """Of the line of units and of the column's name; RecordError where they differ."""
    said = cell.strip(" []()<>{}")
    if said and unit and not same_unit(said, unit):
        raise RecordError("%s:%d: the unit of %s is %s here; needed: the same, or one of them" % (file, line, name, said))
    return said or unit


def without_mark_of_excel(lines, delimiter):
    """The lines without a first one such as `sep=;`, and the delimiter that it names."""
    mark = re.match(r"\s*\"?sep=(.)\"?\s*$", lines[0], re.IGNORECASE)
    return (["", *lines[1:]], delimiter or mark.group(1)) if mark else (lines, delimiter)


def header_of(file, lines, delimiter, is_header):
    """Place of the line with the names of the columns, and remarks: the first that is_header() knows, else the first that is neither empty nor a comment."""
    filled = [k for k, line in enumerate(lines[:MOST_LINES]) if line.strip() and not line.lstrip().startswith("#")][:MOST_TITLE]
    if not filled:
        raise no_header(file)
    first = next((k for k in filled if is_header(names_in(whole(lines, k), delimiter))), filled[0])
    return first, [] if first == filled[0] else ["line %d was taken for the names of the columns, what is before it for a title" % (first + 1)]


def no_header(file):
    return RecordError("%s: is empty; needed: a line with the names of the columns, then rows" % file)


def whole(lines, first):
    """The line, with those after it into which a cell in quotes goes on."""
    for last in range(first + 1, min(first + MOST_TITLE, len(lines))):
        line = "".join(lines[first:last])
        if line.count('"') % 2 == 0:
            return line
    return lines[first]


def names_in(line, delimiter):
    try:
        return [name_in(cell) for _, cells in split([line], delimiter or likely_delimiter(line)) for cell in cells]
    except csv.Error:
        return []


def name_in(cell):
    """Of a column, without blanks and single quotes around it."""
    name = cell.strip()
    quoted = QUOTED.match(name)
    return quoted.group(1).strip() if quoted else name


def likely_decimal(file, table, places, delimiter, remarks):
    """The comma where some numbers have one and none has a point, else None. RecordError where the commas may as well group the digits of whole numbers."""
    found = None if delimiter == "," else first_decimal_comma(table)
    if found is None:
        return None
    if delimiter != ";" and are_groups(table):  # a semicolon is written where the comma is the decimal sign
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


def rows_of(file, lines, first, delimiter):
    """Number of the first line and cells of each row from line `first` on that is neither empty nor a comment."""
    try:
        for line, cells in split(lines[first:], delimiter):
            if any(cell.strip() for cell in cells) and not cells[0].lstrip().startswith("#"):
                yield first + line, cells
    except csv.Error as error:
        raise RecordError("%s: %s" % (file, error))


def split(lines, delimiter):
    """Number of its first line, from 1, and cells of each row."""
    if delimiter in (BLANK, WIDE):
        yield from enumerate(split_by_blanks(lines, delimiter), 1)
        return
    reader, line = csv.reader(lines, delimiter=delimiter, skipinitialspace=True), 1
    for cells in reader:
        begun, line = line, reader.line_num + 1
        yield begun, cells


def split_by_blanks(lines, delimiter):
    """Cells of each line, by wide blanks where single ones do not come to as many as in the first line, and the other way round: values may be as wide as a column."""
    count, other = None, BLANK if delimiter == WIDE else WIDE
    for line in lines:
        cells = re.split(delimiter, line.strip())
        count = count or len(cells)
        others = re.split(other, line.strip()) if len(cells) != count else cells
        yield others if len(others) == count else cells


def likely_delimiter(header):
    """Of comma, semicolon, tab and | the one that stands most often in the header; where there is none, blanks."""
    best = max(",;\t|", key=header.count)
    if best in header:
        return best
    return WIDE if re.search(WIDE, header.strip()) else BLANK


def without_empty_end(names):
    while len(names) > 1 and not names[-1]:
        names = names[:-1]
    return names


def fitted(cells, file, line, names):
    """The cells, as many as there are names; RecordError with the line where they are not."""
    if len(cells) > len(names) and not any(cell.strip() for cell in cells[len(names):]):
        return cells[:len(names)]
    if len(cells) != len(names):
        raise RecordError("%s:%d: has %d cells, the header %d (%s); needed: as many, texts with a delimiter in quotes" %
                          (file, line, len(cells), len(names), shown(names, 8)))
    return cells


def unit_in(name):
    """Of a column called `Hook Load (klbs)`, `HKLD [kN]`, `Hook Load, kN`, `Hook Load kN` or `HKLD_kN`: klbs, kN; else None."""
    return parts_of(name)[1]


def bare(name):
    """A column's name without its unit and what else stands in brackets after it."""
    return parts_of(name)[0]


def parts_of(name):
    """Name and unit. Of several brackets the unit is the last that is one, else the last."""
    rest, inside = apart(name)
    if inside:
        return rest, next((text for text in inside if is_unit(text)), inside[0]) or None
    for sign in list(SEPARATOR.finditer(name))[:-1 - MOST_PARTS:-1]:
        rest, unit = apart(name[:sign.start()])[0], name[sign.end():]
        if any(word(rest) in RANKS[signal] and is_unit(unit, SIGNALS[signal][0]) for signal in RANKS):
            return rest, unit
    return name, None


def apart(name):
    """A name without the brackets at its end, and what stands in these, the last first."""
    inside = []
    while (match := BRACKET.match(name)) is not None:
        name = match.group(1).strip()
        inside.append(next(text for text in match.groups()[1:] if text is not None).strip())
    return name, inside


def is_unit(text, *quantities):
    """Of one of these quantities, of any where there are none."""
    for quantity in quantities or TABLES:
        try:
            factor_of(quantity, text)
            return True
        except UnitError:
            pass
    return False


def is_line_of_units(row):
    words = [cell.strip(" []()<>{}") for cell in row if cell.strip()]
    return len(words) > 0 and not any(is_number(word) for word in words) and 2 * sum(map(is_unit, words)) >= len(words)
