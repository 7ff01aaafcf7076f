"""A table of texts with named columns: what a delimited file, a WITSML log and a LAS file have in common. Its cells become signals in signal_reader.py."""
import csv

from drill_rig_sim.field.units import TABLES, UnitError, factor_of
from drill_rig_sim.refusal import Refusal

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

    def header(self):
        return shown(self.names)


def shown(names, most=40):
    """A list of names for one line of a message."""
    return ", ".join(name or "(no name)" for name in names[:most]) + (", and %d more" % (len(names) - most) if len(names) > most else "")


def read_delimited(file, text, delimiter=None, decimal=None, needed=None):
    """A Table of a file whose first line names its columns. Lines that are empty or begin with # are passed over; a second line of units is one. Every other row
    must have as many cells as the header: a cell too many is a decimal comma or a comma within a text, a cell too few a row that was cut off.
    `delimiter` and `decimal` sign: None where they are to be recognised. `needed(names)`: places of the columns whose cells are kept, None: all."""
    lines = lines_of(text)
    header = next((line for line in lines if line.strip() and not line.lstrip().startswith("#")), None)
    if header is None:
        raise RecordError("%s: is empty; needed: a line with the names of the columns, then rows" % file)
    delimiter = delimiter or likely_delimiter(header)
    rows = rows_of(file, lines, delimiter)
    names = without_empty_end([cell.strip() for cell in next(rows)[1]])
    units, remarks, table, places = [unit_in(name) for name in names], [], [], []
    keep = set(range(len(names)) if needed is None else needed(names))
    for line, cells in rows:
        cells = fitted(cells, file, line, names)
        if not table and not remarks and is_line_of_units(cells):
            units = [cell.strip(" []()") or unit for cell, unit in zip(cells, units)]
            remarks.append("line %d was taken for the units of the columns" % line)
            continue
        table.append([cell if place in keep else "" for place, cell in enumerate(cells)])
        places.append(str(line))
    if decimal == "," or (decimal is None and delimiter != "," and has_decimal_commas(table)):
        table = [[cell.replace(",", ".") if is_decimal_comma(cell) else cell for cell in row] for row in table]
        remarks += ["its numbers have decimal commas"] if decimal is None else []
    return Table(file, names, units, table, places, remarks=remarks)


def lines_of(text):
    """As an editor counts them, with the line ends of any system."""
    return text.replace("\r\n", "\n").replace("\r", "\n").split("\n")


def rows_of(file, lines, delimiter):
    """Number of the first line and cells of each row that is neither empty nor a comment."""
    reader, line = csv.reader(lines, delimiter=delimiter, skipinitialspace=True), 1
    try:
        for cells in reader:
            begun, line = line, reader.line_num + 1
            if any(cell.strip() for cell in cells) and not cells[0].lstrip().startswith("#"):
                yield begun, cells
    except csv.Error as error:
        raise RecordError("%s:%d: %s" % (file, reader.line_num, error))


def likely_delimiter(header):
    """Of comma, semicolon and tab the one that stands most often in the header."""
    return max(",;\t", key=header.count)


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
    """Of a column called `Hook Load (klbs)` or `HKLD [kN]`: klbs, kN; else None."""
    for left, right in ("()", "[]"):
        if name.endswith(right) and left in name:
            return name[name.rindex(left) + 1:-1].strip() or None
    return None


def bare(name):
    """A column's name without its unit."""
    return name[:name.rindex("(" if name.endswith(")") else "[")].strip() if unit_in(name) else name


def is_unit(text):
    for quantity in TABLES:
        try:
            factor_of(quantity, text)
            return True
        except UnitError:
            pass
    return False


def is_line_of_units(row):
    words = [cell.strip(" []()") for cell in row if cell.strip()]
    return len(words) > 0 and not any(is_number(word) for word in words) and 2 * sum(map(is_unit, words)) >= len(words)


def is_number(text):
    try:
        float(text)
        return True
    except ValueError:
        return False


def is_decimal_comma(cell):
    whole, comma, rest = cell.strip().partition(",")
    return comma == "," and rest.isdigit() and (whole.lstrip("+-").isdigit() or whole in ("", "-"))


def has_decimal_commas(rows):
    """Where some numbers have a comma and none has a point."""
    some = False
    for row in rows:
        for cell in row:
            if "." in cell and is_number(cell):
                return False
            some = some or is_decimal_comma(cell)
    return some
