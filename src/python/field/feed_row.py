# SPDX-License-Identifier: BSD-3-Clause
"""A row of a live feed."""
import typing

import numpy
from drill_rig_sim.field.signal_reader import NULLS
from drill_rig_sim.field.signals import SIGNALS, si_unit


class Row(typing.NamedTuple):
    place: str    # in the feed, for messages
    time: float   # since any instant, the same of all rows [s]
    values: dict  # signals of field.signals [SI]; nan: not measured


def measured(signal, value, factor, place, say):
    """A signal's value [SI] of a number or a text; nan, and a line to `say`, where it cannot be. `factor`: SI units of one."""
    try:
        number = float(value)
    except ValueError:
        say("%s is left out: '%s' is not a number" % (place, str(value)[:20]))
        return numpy.nan
    if number in NULLS or number != number:
        return numpy.nan
    _, low, high = SIGNALS[signal]
    if not low <= number * factor <= high:
        say("%s is left out: %s must be between %g and %g %s (got %g)" % (place, signal, low, high, si_unit(signal), number * factor))
        return numpy.nan
    return number * factor
