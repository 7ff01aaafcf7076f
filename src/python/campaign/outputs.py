# SPDX-License-Identifier: BSD-3-Clause
"""What may be asked of a run by a path: drill score's numbers, and statistics over time of any number of a frame."""
import math

import numpy
from drill_rig_sim.campaign.played import SIDES, STATISTICS
from drill_rig_sim.score import score
from drill_rig_sim.score_command import TABLE
from drill_rig_sim.score_runs import BIT, STATE, Run
from drill_rig_sim.survey import Survey
from drill_rig_sim.units import QUANTITIES


def check(path, rig):
    """What is wrong with a path, or "". Moves the rig by a frame."""
    first, _, rest = path.partition(".")
    if first in STATISTICS:
        side, _, name = rest.partition(".")
        if side not in SIDES:
            return "%s: needed: %s.SIDE.NAME, SIDE one of %s" % (path, first, ", ".join(SIDES))
        numbers = getattr(rig.record(1.0 / rig.rate), side).dtype.names
        return "" if name in numbers else "%s: %s has no number %s" % (path, side, name)
    paths = score_paths()
    return "" if path in paths else "%s: is neither STATISTIC.SIDE.NAME (STATISTIC one of %s; SIDE one of %s) nor of drill score: %s" % (
        path, ", ".join(STATISTICS), ", ".join(SIDES), ", ".join(paths))


def shown_as(what):
    """Quantity and factor to SI of an output's number; None where its quantity is not known (a function's, a count's)."""
    first, _, rest = what.partition(".") if isinstance(what, str) else ("", "", "")
    if first in STATISTICS:
        quantity = QUANTITIES.get(rest.split(".")[-1])
        return (quantity, 1.0) if quantity else None
    if first == "wob" and rest in ("least", "set_point", "band"):
        return ("force", 1.0)
    return next(((quantity, factor) for section, name, _, quantity, factor, _ in TABLE if (section, name) == (first, rest)), None)


def score_paths():
    """Of all numbers that drill score gives, from a run that has everything."""
    time = numpy.arange(0.0, 60.0, 0.1)
    columns = {name: numpy.full_like(time, 1.0) for name in (*STATE, *BIT)}
    depth = 10.0 + 0.1 * time
    columns.update(time=time, hole_depth=depth, bit_depth=depth, top_drive_speed=0.0 * time, bit_up=-depth)
    scores = score(Run(columns), plan=Survey([0.0, 100.0], [0.0, 0.0], [0.0, 0.0]), bit_diameter=0.3, wob=1.0, toolface=math.pi)
    del scores["companion"]  # a campaign's runs have none
    return sorted(paths_in(scores))


def paths_in(scores, before=""):
    for name, value in scores.items():
        if isinstance(value, dict):
            yield from paths_in(value, before + name + ".")
        elif value is None or isinstance(value, (int, float)):
            yield before + name
