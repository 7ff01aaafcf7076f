# SPDX-License-Identifier: BSD-3-Clause
"""What stands in the cells of a table: numbers with the decimal and grouping signs of any country, texts that stand for no number."""
import re

NO_NUMBER = frozenset("nan null none nil na n/a n.a. #n/a #na #null! #value! #div/0! #num! #ref! inf +inf -inf infinity +infinity -infinity".split())
BLANKS = " '\u2019\u00a0\u2009\u202f"  # between groups of digits
SIGNS_OF_GROUPS = re.compile("[%s]" % BLANKS)
SIGNS_ONLY = re.compile(r"[-*.#?_/ ]*$")  # `---`, `****`: a gauge without a value
SPACED = re.compile(r"[+-]?[1-9]\d{0,2}([%s]\d{3})+([.,]\d*)?$" % BLANKS)  # 1 234.5, 1'234,5: digits in groups
GROUPED = {".": re.compile(r"[+-]?[1-9]\d{0,2}(,\d{3})+(\.\d*)?$"), ",": re.compile(r"[+-]?[1-9]\d{0,2}(\.\d{3})+(,\d*)?$")}  # by the decimal sign
BOTH_SIGNS = {".": re.compile(r"[+-]?[1-9]\d{0,2}(,\d{3})+\.\d*$|[+-]?[1-9]\d{0,2}(,\d{3}){2,}$"), ",": re.compile(r"[+-]?[1-9]\d{0,2}(\.\d{3})+,\d*$")}
COMMA = re.compile(r"[+-]?\d*,\d+([eE][+-]?\d+)?$")
MINUS = re.compile(r"^\s*[\u2212\u2013](?=[\d.,])")  # as typesetters write it: U+2212, U+2013
FOREIGN = re.compile(r"[+-]?\d[\d.,%s]*([eE][+-]?\d+)?$" % BLANKS)


def is_number(text):
    try:
        float(text)
        return "_" not in text  # Python's sign for groups, no file's
    except ValueError:
        return False


def is_blank(cell):
    """Whether a cell is empty or holds what files write for no number."""
    return SIGNS_ONLY.match(cell.strip()) is not None or cell.strip().lower() in NO_NUMBER


def is_foreign_number(cell):
    """Of a cell that is no number: whether other decimal or grouping signs would make it one."""
    return FOREIGN.match(cell.strip()) is not None


def with_point(cell, decimal=None):
    """A number as Python reads it, any other text as it is. `decimal`: the sign of the table's numbers, None: not known, commas stay as they are."""
    if not cell.isascii():
        cell = MINUS.sub("-", cell)
    if decimal is None and not SIGNS_OF_GROUPS.search(cell):
        return cell
    text = without_blanks(cell).strip()
    if decimal and GROUPED[decimal].match(text):
        text = text.replace("." if decimal == "," else ",", "")
    if decimal == "," and COMMA.match(text):
        text = text.replace(",", ".")
    return text if is_number(text) else cell


def without_blanks(cell):
    """A number without the blanks or apostrophes between its groups of digits, any other text as it is."""
    return SIGNS_OF_GROUPS.sub("", cell.strip()) if SPACED.match(cell.strip()) else cell


def has_point(cell):
    return "." in cell and is_number(without_blanks(cell))


def first_with_comma(rows, suits):
    """(row, cell) of the first with a comma that suits, None where none does."""
    return next(((k, cell.strip()) for k, row in enumerate(rows) for cell in row if "," in cell and suits(cell.strip())), None)


def any_point(rows):
    return any(has_point(cell) for row in rows for cell in row)


def first_decimal_comma(rows):
    """(row, cell) of the first number with a comma, None where there is none or where some number has a point."""
    found = first_with_comma(rows, lambda cell: COMMA.match(without_blanks(cell)))
    return None if found and any_point(rows) else found


def first_of_both_signs(rows, decimal):
    """(row, cell) of the first number that has this decimal sign and the other one between groups of digits."""
    return first_with_comma(rows, BOTH_SIGNS[decimal].match)


def first_of_groups(rows):
    """(row, cell) of the first number of a column all of whose numbers have commas between groups of digits, where other columns have decimal points; else None."""
    if not first_with_comma(rows, GROUPED["."].match) or not any_point(rows):
        return None
    for cells in zip(*rows):
        numbers = [(k, cell.strip()) for k, cell in enumerate(cells) if is_number(cell) or is_foreign_number(cell)]
        if numbers and all(GROUPED["."].match(cell) for _, cell in numbers):
            return numbers[0]
    return None


def are_groups(rows):
    """Whether every number with a comma may also be a whole one whose digits stand in groups."""
    return all(GROUPED["."].match(cell.strip()) for row in rows for cell in row if COMMA.match(cell.strip()))
