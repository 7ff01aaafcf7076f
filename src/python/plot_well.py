# SPDX-License-Identifier: BSD-3-Clause
"""The well of a run from above, in section, and its toolfaces on a dial; the forces along a string as `drill static --csv` gives them."""
import math

import numpy
from drill_rig_sim.field.record import prefixed, read_table
from drill_rig_sim.field.table import RecordError
from drill_rig_sim.plot_logs import limits
from drill_rig_sim.refusal import Refusal
from drill_rig_sim.score import bottom_points, new_hole, on_bottom, sliding_rows
from drill_rig_sim.score_plots import LINE, plt
from drill_rig_sim.text_file import report
from drill_rig_sim.units import SI

PLAN = {"linestyle": "--", "color": "#2ca02c", "linewidth": 1.0, "label": "plan"}
AROUND = 20.0  # of a plan, that is shown beyond the drilled part [m]

# of a string: columns, quantity, name, what its scale spans at least in SI units
STRING_TRACKS = (
    ((("tension", "effective", "#1f5fa8"), ("true_axial_force", "true", "#888888")), "force", "tension", 10e3),
    ((("torque", "", "#1f5fa8"),), "torque", "torque", 200.0),
    ((("bending_moment", "", "#1f5fa8"),), "torque", "bending", 1e3),
    ((("contact_force", "", "#c0392b"),), "force", "contact", 1e3))


class StringError(Refusal):
    """What is wrong with a string's file, in one line."""


def path(run, plan=None, units=SI):
    """From above and in section along the way from the beginning of the new hole to its end. None where the run has no new hole."""
    points = bottom_points(run, new_hole(run, on_bottom(run)))
    if points is None:
        return None
    way = points[-1, :2] - points[0, :2]
    along = way / numpy.hypot(*way) if numpy.hypot(*way) > 1e-6 else numpy.array([0.0, 1.0])
    length = units["length"].per_si
    planned = plan_near(plan, points)
    if planned is not None:
        planned = length * planned
    points = length * points
    figure, (above, section) = plt.subplots(1, 2, figsize=(11.0, 5.5))
    if planned is not None:
        above.plot(planned[:, 0], planned[:, 1], **PLAN)
        section.plot((planned[:, :2] - points[0, :2]) @ along, -planned[:, 2], **PLAN)
    above.plot(points[:, 0], points[:, 1], label="drilled", **LINE)
    above.plot(*points[-1, :2], "o", color="#c0392b", markersize=4)
    section.plot((points[:, :2] - points[0, :2]) @ along, -points[:, 2], label="drilled", **LINE)
    around(above, points[:, 0], points[:, 1], 0.5 * length)
    label(above, "from above", units.label("east", "length"), units.label("north", "length"))
    label(section, "section, towards %.0f deg" % (math.degrees(math.atan2(along[0], along[1])) % 360.0), units.label("along it", "length"),
          units.label("true vertical depth", "length"))
    section.invert_yaxis()
    figure.suptitle("well: " + run.title, fontsize=10)
    figure.tight_layout()
    return figure


def plan_near(plan, points):
    """The part of a plan that lies beside the points, a row each metre."""
    if plan is None:
        return None
    md = numpy.arange(plan.md[0], plan.md[-1] + 0.5, 1.0)
    line = numpy.array([plan.at(depth)[0] for depth in md])
    near = numpy.array([numpy.linalg.norm(points - place, axis=1).min() for place in line]) < AROUND
    return line[near] if near.any() else None


def around(panel, x, y, least):
    """At least so far each way: a vertical hole has no shape from above."""
    half = max(0.55 * max(numpy.ptp(x), numpy.ptp(y)), least)
    panel.set_xlim(0.5 * (x.min() + x.max()) - half, 0.5 * (x.min() + x.max()) + half)
    panel.set_ylim(0.5 * (y.min() + y.max()) - half, 0.5 * (y.min() + y.max()) + half)


def label(panel, title, x, y):
    panel.set_title(title, fontsize=9)
    panel.set_xlabel(x)
    panel.set_ylabel(y)
    panel.grid(alpha=0.3)
    panel.legend(loc="best", fontsize=8)
    panel.set_aspect("equal", adjustable="datalim" if panel.get_autoscale_on() else "box")


def toolface_dial(run):
    """Of what was slid, older points nearer to the middle. None where the run never slides."""
    if "toolface" not in run:
        return None
    rows = sliding_rows(run, on_bottom(run))
    if not numpy.any(rows):
        return None
    figure, dial = plt.subplots(figsize=(5.0, 5.3), subplot_kw={"projection": "polar"})
    dial.set_theta_zero_location("N")
    dial.set_theta_direction(-1)
    time = run["time"][rows]
    dial.scatter(run["toolface"][rows], time - time[0] + 0.1 * (time[-1] - time[0] + 1.0), c=time, s=4, cmap="viridis")
    dial.set_yticks([])
    dial.set_title("toolface while sliding, %.0f to %.0f s\n0: high side, or north near the vertical" % (time[0], time[-1]), fontsize=9)
    return figure


def read_string(file):
    """Columns of a string by drill static --csv, or at the end of drill run --profile."""
    try:
        table = read_table(file)
        report(prefixed(file, table.remarks))
        columns = {name: table.numbers(name) for name in ("md", *(curve[0] for track, _, _, _ in STRING_TRACKS for curve in track))}
        time = table.numbers("time") if "time" in table.names else numpy.zeros(len(table.rows))
    except RecordError as error:
        raise StringError("%s (needed: a string as drill static --csv or drill run --profile writes it)" % error)
    if not table.rows:
        raise StringError("%s: has no rows" % file)
    return {name: values[time == time[-1]] for name, values in columns.items()}


def string_log(columns, name, units=SI):
    figure, axes = plt.subplots(1, len(STRING_TRACKS), sharey=True, figsize=(2.4 * len(STRING_TRACKS), 8.0))
    md = units["length"].per_si * columns["md"]
    for panel, (track, quantity, title, least) in zip(axes, STRING_TRACKS):
        factor = units[quantity].per_si
        for column, said, colour in track:
            panel.plot(factor * columns[column], md, color=colour, linewidth=0.9, label=said)
        if len(track) > 1:
            panel.legend(loc="best", fontsize=8)
        panel.axvline(0.0, color="#bbbbbb", linewidth=0.6)
        panel.set_xlim(*limits(numpy.concatenate([factor * columns[column] for column, _, _ in track]), factor * least))
        panel.set_xlabel(units.label(title, quantity))
        panel.grid(alpha=0.3)
    axes[0].set_ylabel(units.label("measured depth", "length"))
    axes[0].set_ylim(md.max(), md.min())
    figure.suptitle("string: " + name, fontsize=10)
    figure.tight_layout()
    return figure
