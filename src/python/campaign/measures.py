# SPDX-License-Identifier: BSD-3-Clause
"""Numbers with their unit in a campaign's plan, as in `9.5 ppg`. Whether a key takes the unit is for the scene's reader to say, which gets them as they are."""
import re

MEASURE = re.compile(r"([-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?) *(?![eE][-+]?\d)([A-Za-z%\u00b0'\"].*|1/\S+)$")


def split(text):
    """Number and unit of a text that is both; (None, "") of any other."""
    found = MEASURE.match(text.strip()) if isinstance(text, str) else None
    return (float(found.group(1)), found.group(2)) if found else (None, "")


def with_unit(number, unit):
    """Written as a scene has it: a number where there is no unit."""
    return "%r %s" % (number, unit) if unit else number


def column(values):
    """Values of a factor as numbers, and their unit; as they are, and "", where they are not all in one unit."""
    parts = [split(value) for value in values]
    unit = parts[0][1] if parts else ""
    return ([number for number, _ in parts], unit) if unit and all(part[1] == unit for part in parts) else (values, "")
