"""What stands in the cells of a table: numbers with the decimal and grouping signs of any country, texts that stand for no number."""
import re

NO_NUMBER = frozenset("nan null none nil na n/a n.a. #n/a #na #null! #value! #div/0! #num! #ref! inf +inf -inf infinity +infinity -infinity".split())
BLANKS = " '\u00a0\u2009\u202f"  # between groups of digits
SIGNS_OF_GROUPS = re.compile("[%s]" % BLANKS)
SIGNS_ONLY = re.compile(r"[-*.#?_/ ]*$")  # `---`, `****`: a gauge without a value
SPACED = re.compile(r"[+-]?\d{1,3}([%s]\d{3})+([.,]\d*)?$" % BLANKS)  # 1 234.5, 1'234,5: digits in groups
GROUPED = {".": re.compile(r"[+-]?\d{1,3}(,\d{3})+(\.\d*)?$"), ",": re.compile(r"[+-]?\d{1,3}(\.\d{3})+(,\d*)?$")}  # by the decimal sign
COMMA = re.compile(r"[+-]?\d*,\d+([eE][+-]?\d+)?$")
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
    if decimal is None and not SIGNS_OF_GROUPS.search(cell):
        return cell
    text = cell.strip()
    if SPACED.match(text):
        text = SIGNS_OF_GROUPS.sub("", text)
    if decimal and GROUPED[decimal].match(text):
        text = text.replace("." if decimal == "," else ",", "")
    if decimal == "," and COMMA.match(text):
        text = text.replace(",", ".")
    return text if is_number(text) else cell


def has_point(cell):
    return "." in cell and is_number(cell)


def first_decimal_comma(rows):
    """(row, cell) of the first number with a comma, None where there is none or where some number has a point."""
    found = None
    for k, row in enumerate(rows):
        for cell in row:
            if has_point(cell):
                return None
            if found is None and "," in cell and COMMA.match(cell.strip()):
                found = k, cell.strip()
    return found


def are_groups(rows):
    """Whether every number with a comma may also be a whole one whose digits stand in groups."""
    return all(GROUPED["."].match(cell.strip()) for row in rows for cell in row if COMMA.match(cell.strip()))
