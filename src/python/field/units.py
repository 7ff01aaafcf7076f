# SPDX-License-Identifier: BSD-3-Clause
"""Units of records, to SI: those of the one table of units (math/unit_table.h), and dates."""
import functools
import math
import re

from drill_rig_sim.field.cells import is_number, with_point
from drill_rig_sim.field.native import of_module

QUANTITIES = ("length", "speed", "force", "torque", "pressure", "angular speed", "flow", "time")  # of signals
DATE = "date"  # the cells are dates with a time of the day, not numbers
# of measured depth, the rotary table's names behind a unit: `ftKB`, `mMD`, `m RKB`
DATUM = re.compile(r"(.*?\S)\s*(?:md ?)?(?:brkb|bkb|rkb|kb|brt|mdrt|rte|rt|df|md)$", re.IGNORECASE)
DATES = ("date", "datetime", "date time", "date.time", "iso 8601")

# a power of ten before a unit or behind it: `1000 lbf`, `x1000 lbf`, `klb x 10`, `10^3 N`; small ones have a sign, to differ from a mean over `10 s`
TEN = r"(10(?:\^|\*\*)-?\d|1e[+-]?\d|\d*\.?\d+)"
BEFORE, AFTER = re.compile(r"([x\u00d7*]\s*)?%s\s*[x\u00d7*\u00b7]?\s*([a-z%%\u00b0\"'].*)$" % TEN, re.IGNORECASE), re.compile(r"(.*\S)\s*([x\u00d7*])\s*%s$" % TEN, re.IGNORECASE)
LEAST_POWER, MOST_POWER, LONGEST = 1e-10, 1e10, 60  # and letters of a text with one
SMALL = 100.0  # from which on a power before a unit needs no sign
SUPERSCRIPTS = str.maketrans("\u2070\u00b9\u00b2\u00b3\u2074\u2075\u2076\u2077\u2078\u2079\u207b", "0123456789-")

WITH_UNIT = re.compile(r"([+-]?[\d.,]*\d[.,]?(?:[eE][+-]?\d+)?)\s*([A-Za-z%\u00b0\"'\u2032\u2033][^\s]*(?: [^\s\d]+)?)$")


class UnitError(Exception):
    """Why a text is not the unit of a quantity, and what is allowed."""


@functools.lru_cache(maxsize=None)
def found(quantity, text):
    """(SI units in one of `text` or None, why there are none)."""
    return of_module().find_unit(quantity, text)


def factor_of(quantity, text):
    """SI units in one of `text`, None for dates. UnitError where it is no unit of the quantity, or may be several."""
    exact = text.strip()
    if quantity == "time" and exact.lower() in DATES:
        return None
    factor, problem = found(quantity, exact)
    datum = DATUM.match(exact) if factor is None and quantity == "length" else None
    if datum:
        factor = found(quantity, datum[1])[0]
    power, unit = power_in(exact) if factor is None else (None, "")
    if power is not None:
        factor, problem = found(quantity, unit)
        factor = factor and power * factor
    if factor is None and not power_in(exact)[0] and power_in(exact + " m")[0]:
        raise UnitError("%s is a factor without a unit; needed: one behind it, %s %s" % (exact, exact, problem.rpartition("allowed: ")[2]))
    if factor is None:
        raise UnitError("unit " + problem + (", " + DATE if quantity == "time" else ""))
    return factor


def power_in(text):
    """(power of ten, unit) of a text that holds both, else (None, "")."""
    if len(text) > LONGEST:
        return None, ""
    plain = re.sub("10([\u2070\u00b9\u00b2\u00b3\u2074-\u2079\u207b]+)", lambda found: "10^" + found[1].translate(SUPERSCRIPTS), text.strip())
    plain = re.sub(r"(?<=10)\s*(\^|\*\*)\s*", "^", plain)
    before, after = BEFORE.match(plain), AFTER.match(plain)
    if before is None and after is None:
        return None, ""
    number, unit, sign = (before[2], before[3], before[1]) if before else (after[3], after[1], after[2])
    power = 10.0 ** float(number[3:]) if "^" in number else float(number)
    is_power = LEAST_POWER < power < MOST_POWER and abs(math.log10(power) - round(math.log10(power))) < 1e-9
    return (power, unit) if is_power and (sign or power >= SMALL) else (None, "")


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
