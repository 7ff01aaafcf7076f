# SPDX-License-Identifier: BSD-3-Clause
"""Units of records, to SI: those of the one table of units (math/unit_table.h), and dates."""
import functools
import re

from drill_rig_sim.field.cells import is_number, with_point
from drill_rig_sim.refusal import Refusal

QUANTITIES = ("length", "speed", "force", "torque", "pressure", "angular speed", "flow", "time")  # of signals
DATE = "date"  # the cells are dates with a time of the day, not numbers
# of measured depth, the rotary table's names behind a unit: `ftKB`, `mMD`, `m RKB`
DATUM = re.compile(r"(.*?\S)\s*(?:md ?)?(?:brkb|bkb|rkb|kb|brt|mdrt|rte|rt|df|md)$", re.IGNORECASE)
DATES = ("date", "datetime", "date time", "date.time", "iso 8601")

WITH_UNIT = re.compile(r"([+-]?[\d.,]*\d[.,]?(?:[eE][+-]?\d+)?)\s*([A-Za-z%\u00b0\"'\u2032\u2033][^\s]*(?: [^\s\d]+)?)$")


class UnitError(Exception):
    """Why a text is not the unit of a quantity, and what is allowed."""


@functools.lru_cache(maxsize=None)
def found(quantity, text):
    """(SI units in one of `text` or None, why there are none)."""
    try:
        from drill_rig_sim import _sim  # pylint: disable=import-outside-toplevel
    except ImportError as error:
        raise Refusal("records are read by the Python module sim, which is not built (it needs pybind11-dev): %s" % error)
    return _sim.find_unit(quantity, text)


def factor_of(quantity, text):
    """SI units in one of `text`, None for dates. UnitError where it is no unit of the quantity, or may be several."""
    exact = text.strip()
    if quantity == "time" and exact.lower() in DATES:
        return None
    factor, problem = found(quantity, exact)
    datum = DATUM.match(exact) if factor is None and quantity == "length" else None
    if datum:
        factor = found(quantity, datum[1])[0]
    if factor is None:
        raise UnitError("unit " + problem + (", " + DATE if quantity == "time" else ""))
    return factor


def is_unit(text, *quantities):
    """Of one of these quantities, of any signal's where there are none."""
    for quantity in quantities or QUANTITIES:
        try:
            factor_of(quantity, text)
            return True
        except UnitError:
            pass
    return False


def parts_of(cell):
    """(number, unit) of a cell that holds both; None of any other."""
    found = WITH_UNIT.match(cell.strip())
    if found is None or is_number(cell):
        return None
    number, unit = found.groups()
    number = with_point(number, "." if "." in number else None)
    return (number, unit) if is_number(number) and is_unit(unit) else None


def same_unit(one, other):
    """Whether two texts may be the same unit; of units that are not known, yes."""
    for quantity in QUANTITIES:
        try:
            factors = factor_of(quantity, one), factor_of(quantity, other)
        except UnitError:
            continue
        return None in factors or factors[0] == factors[1]
    return True
