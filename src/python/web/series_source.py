# SPDX-License-Identifier: BSD-3-Clause
"""A time series of `drill run --csv` as a source: all of it at once, the truth."""
import numpy
from drill_rig_sim.score import bottom_points, new_hole, on_bottom
from drill_rig_sim.score_runs import STATE
from drill_rig_sim.web.fields import SEEN
from drill_rig_sim.web.news import STATE_KIND, News, ReadSource
from drill_rig_sim.web.packed import Packed

UNKNOWN_STANDS = -1
SPACING = 10.0  # of points of a planned path [m]


class SeriesSource(ReadSource):
    """`run`: drill_rig_sim.score_runs.Run; `plan`: drill_rig_sim.survey.Survey or None."""

    def __init__(self, run, plan=None):
        path, begin = path_of_run(run)
        latest = {"drilled": (path, begin)}
        if plan is not None:
            latest["planned"] = path_of_survey(plan)
        super().__init__(run.title, News([], [], None, latest, rows_of(run)))


def rows_of(run):
    """As Packed.rows() gives them; what the series does not hold is nan, or false."""
    formats = Packed(STATE_KIND, SEEN).formats
    rows = numpy.zeros(len(run["time"]), dtype=[("stamp", "f8"), *((name, "i8" if name == "stand_count" else formats[name]) for name in SEEN)])
    rows["stamp"], rows["tared"], rows["stand_count"] = run["time"], True, UNKNOWN_STANDS
    columns = {member: column for column, member in STATE.items()}
    for name in SEEN:
        if columns.get(name) in run.columns:
            rows[name] = run[columns[name]]
        elif name != "tared" and name in run.columns:  # the truth has a weight on bit without a tare
            rows[name] = run[name]
        elif formats[name] == "<f8":
            rows[name] = numpy.gradient(run["block_height"], run["time"]) if name == "block_velocity" and "block_height" in run else numpy.nan
    return rows


def path_of_run(run):
    """East, north and depth of the bottom of new hole, and the measured depth where it begins [m]."""
    drilled = new_hole(run, on_bottom(run))
    points = bottom_points(run, drilled)
    if points is None:
        return numpy.empty((0, 3)), 0.0
    return numpy.array(points, dtype=float) * (1.0, 1.0, -1.0), float(run["hole_depth"][numpy.argmax(drilled > 0.0)])


def path_of_survey(survey):
    """East, north and depth along a planned well."""
    depths = numpy.union1d(numpy.arange(survey.md[0], survey.md[-1], SPACING), survey.md)
    return numpy.array([survey.at(md)[0] for md in depths]) * (1.0, 1.0, -1.0)
