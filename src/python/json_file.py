# SPDX-License-Identifier: BSD-3-Clause
"""JSON files of the runner's commands. JSON has no infinite number and no NaN: they become null."""
import json
import math


def write_json(value, file):
    """`value` of dictionaries, lists and numbers into a file. OSError where it cannot be written."""
    with open(file, "w", encoding="utf-8") as out:
        json.dump(finite(value), out, indent=2, allow_nan=False)
        out.write("\n")


def finite(value):
    """Numbers that are not finite become None."""
    if isinstance(value, dict):
        return {key: finite(inner) for key, inner in value.items()}
    if isinstance(value, (list, tuple)):
        return [finite(inner) for inner in value]
    if isinstance(value, float):  # numpy's are too
        return float(value) if math.isfinite(value) else None
    return value
