# SPDX-License-Identifier: BSD-3-Clause
"""The lines above the rows of a delimited table: a title, the names of the columns in one line or in up to three, and what stands between them and the rows."""
import csv
import re
import typing

from drill_rig_sim.field.cells import is_number
from drill_rig_sim.field.units import is_unit, parts_of

MOST_TITLE, MOST_LINES = 50, 10000  # lines before the names of the columns, and with comments
MOST_NAMES = 3                      # lines over which the names of the columns go
MOSTLY = 0.8                        # share of the first rows
SIGNS = ",;\t|"                     # that part cells
BLANK, WIDE = r"\s+", r"\s{2,}"     # delimiters of columns that are aligned
CELL = re.compile(r"\S+(?: \S+)*")  # of aligned columns
DATA = re.compile(r"[+-]?\d[\d.,:/+'eETZ -]*$|.*\d:\d\d")  # a number, a date or a time of the day
COMMENT = re.compile(r"\s*#(?![,;\t|\"])")  # not of a column that numbers the rows
QUOTED = re.compile(r"'(.+)'$")  # a name; a cell in such quotes is a text for csv
NO_QUANTITY = "% - none unitless dimensionless degc degf ppm api gapi v ohm.m ohmm v/v count counts".split()  # of other columns in a line of units


class Wanted:
    """What the names of a table's columns are known by; here any are good."""

    def count(self, names):  # pylint: disable=unused-argument
        """How many of these names of columns are known, 0 where they are no header."""
        return 0

    def is_name(self, name):  # pylint: disable=unused-argument
        return False

    def places(self, names):
        """Of the columns to be kept."""
        return range(len(names))


class Heading(typing.NamedTuple):
    """`first` and `last` line of the names, `delimiter`, `names` and `remarks`. `known`: how many of them are wanted. `tie`: another delimiter that parts names and rows
    as well, and differently; else None."""
    first: int
    last: int
    delimiter: str
    names: list
    known: int
    remarks: list
    tie: typing.Optional[str] = None


def heading_of(lines, delimiter, wanted):
    """The Heading of these lines, None where all are empty: the lines whose names `wanted` knows best, else the first that is neither empty nor a comment. Without a
    delimiter the one that parts names and rows alike."""
    filled = [k for k, line in enumerate(lines[:MOST_LINES]) if line.strip(" \t,;|\"") and not COMMENT.match(line)][:MOST_TITLE]
    if not filled:
        return None
    spans = [(filled[k], filled[k + count - 1]) for count in range(1, MOST_NAMES + 1) for k in range(len(filled) - count + 1)]
    likely = best_of(lines, spans, delimiter, wanted, filled[0])
    if delimiter or likely.known and likely.delimiter in (BLANK, WIDE):
        return likely
    same = [(likely.first, likely.last)] if likely.known else spans
    others = [best_of(lines, same, sign, wanted, filled[0]) for sign in SIGNS if sign != likely.delimiter and any(sign in line for first, last in same for line in lines[first:last + 1])]
    best = max([likely, *others], key=lambda one: (one.known > 0, fit(lines, one), one.known))
    alike = [one for one in (likely, *others) if one is not best and one.known == best.known > 0 and fit(lines, one) == fit(lines, best) and cells_below(lines, one) != cells_below(lines, best)]
    return best._replace(tie=alike[0].delimiter) if alike else best


def best_of(lines, spans, delimiter, wanted, top):
    """A Heading in the first of these spans whose names are known best. `top`: the first line that is filled."""
    names = [names_over(lines, span, delimiter, wanted) for span in spans]
    known = [wanted.count(one) for one in names]
    best = known.index(max(known))  # the first: of fewer lines, then higher up
    first, last = spans[best]
    which = "line %d was" % (first + 1) if first == last else "lines %d to %d were" % (first + 1, last + 1)
    title = ", the lines before as a title" if first != top else ""
    remarks = ["%s read as the names of the columns%s" % (which, title)] if title or first != last else []
    return Heading(first, last, delimiter_over(lines, (first, last), delimiter), names[best], known[best], remarks)


def cells_below(lines, heading):
    """Of the first rows below a heading."""
    rows = [line for line in lines[heading.last + 1:heading.last + 1 + MOST_TITLE] if line.strip(" \t,;|\"")]
    return [[cell.strip() for cell in names_in(line, heading.delimiter)] for line in rows]


def fit(lines, heading):
    """Whether the first rows below a heading have as many cells as it has names, by its delimiter: most of them."""
    rows = cells_below(lines, heading)
    return bool(rows) and sum(len(row) == len(heading.names) for row in rows) > MOSTLY * len(rows)


def names_over(lines, span, delimiter, wanted):
    """Names of columns that stand in the lines of a span, one or more."""
    first, last = span
    if first == last:
        return names_in(whole(lines, first), delimiter)
    return joined_names([line for line in lines[first:last + 1] if line.strip(" \t,;|\"") and not COMMENT.match(line)], delimiter_over(lines, span, delimiter), wanted)


def delimiter_over(lines, span, delimiter):
    """The one that is asked for, else the likely one of the lines of a span."""
    first, last = span
    if delimiter or first == last:
        return delimiter or likely_delimiter(whole(lines, first))
    return likely_delimiter(max(lines[first:last + 1], key=lambda line: len(names_in(line, None))))


def joined_names(lines, delimiter, wanted):
    """Names that stand in several lines, a part in each; [] where a line holds data. Of a column's names one line's is taken where only that is known."""
    rows = aligned(lines) if delimiter == WIDE else [names_in(line, delimiter) for line in lines]
    if any(holds_data(row) or is_line_of_units(row) for row in rows) or any(line.count('"') % 2 for line in lines):
        return []
    width = max(map(len, rows))
    columns = [[row[place] for row in rows if place < len(row) and row[place]] for place in range(width)]
    return [next((name for name in (" ".join(parts), *parts) if wanted.is_name(name)), " ".join(parts)) for parts in columns]


def aligned(lines):
    """Cells of lines whose columns are aligned by blanks; a line with fewer cells than the longest has empty ones where none stands below or above."""
    found = [[(match.start(), match.end(), match.group()) for match in CELL.finditer(line)] for line in lines]
    columns = max(found, key=len)
    rows = []
    for cells in found:
        row = [""] * len(columns)
        for begin, end, text in cells:
            place = min(range(len(columns)), key=lambda k: abs(columns[k][0] + columns[k][1] - begin - end))
            row[place] = ("%s %s" % (row[place], text)).strip()
        rows.append(row)
    return rows


def holds_data(row):
    """Whether one of the cells is a number, with a unit or without, a date or a time of the day."""
    return any(DATA.match(cell.strip()) or parts_of(cell) for cell in row)


def are_places(row):
    """Whether a row numbers the columns, from 0 or 1."""
    return len(row) > 2 and [cell.strip() for cell in row] in ([str(k + first) for k in range(len(row))] for first in (0, 1))


def is_line_of_units(row):
    words = [cell.strip(" []()<>{}") for cell in row if cell.strip()]
    return bool(words) and not any(is_number(word) for word in words) and 2 * sum(is_unit(word) or word.lower() in NO_QUANTITY for word in words) >= len(words) and \
        any(map(is_unit, words))


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


def split(lines, delimiter, count=None):
    """Number of its first line, from 1, and cells of each row. `count`: of the columns."""
    if delimiter in (BLANK, WIDE):
        yield from enumerate(split_by_blanks(lines, delimiter, count), 1)
        return
    reader, line = csv.reader(lines, delimiter=delimiter, skipinitialspace=True), 1
    for cells in reader:
        begun, line = line, reader.line_num + 1
        yield begun, cells


def split_by_blanks(lines, delimiter, count):
    """Cells of each line, by wide blanks where single ones do not come to as many as there are columns, and the other way round: values may be as wide as a column."""
    other = BLANK if delimiter == WIDE else WIDE
    for line in lines:
        cells = re.split(delimiter, line.strip())
        others = re.split(other, line.strip()) if count and len(cells) != count else cells
        yield others if len(others) == count else cells


def likely_delimiter(header):
    """Of comma, semicolon, tab and | the one that stands most often in the header; where there is none, blanks."""
    best = max(SIGNS, key=header.count)
    if best in header:
        return best
    return WIDE if re.search(WIDE, header.strip()) else BLANK
