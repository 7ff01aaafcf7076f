# SPDX-License-Identifier: BSD-3-Clause
"""A page of plots of a judged run."""
import math

import matplotlib
import numpy
from drill_rig_sim.companion import difference
from drill_rig_sim.score import WINDOW, bottom_points, new_hole, on_bottom, sliding_rows, stick_slip_windows
from drill_rig_sim.units import SI

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402 (after the choice of Agg)

matplotlib.rcParams["axes.formatter.useoffset"] = False  # depths as they are, not what they are beyond 3000 m

LINE = {"linewidth": 0.8, "color": "#1f5fa8"}
SET_POINT = {"color": "#2ca02c", "alpha": 0.25}
BAND = {"alpha": 0.3, "linewidth": 0.0}  # of the difference to the companion


def draw(run, scores, plan, bit_diameter, file, units=SI):
    """Writes the page to a file, of the kind that its name says (png, svg, pdf)."""
    figure, axes = plt.subplots(3, 2, figsize=(11.0, 9.5))
    depth(axes[0, 0], run, units)
    weight(axes[0, 1], run, scores, units)
    bit_speed(axes[1, 0], run)
    toolface(axes[1, 1], run, scores)
    energy(axes[2, 0], run, bit_diameter, units)
    section(axes[2, 1], run, plan, units)
    for panel in axes.flat[:5]:
        panel.set_xlabel("time [s]")
        panel.set_xlim(run["time"][0], run["time"][-1])
    for panel in axes.flat:
        panel.grid(alpha=0.3)
    figure.suptitle("%s, by its %s" % (run.title, run.source), fontsize=10)
    figure.tight_layout()
    save(figure, file)


def save(figure, file):
    """As a picture of the kind that the file's name says; closed then. OSError for an ending that is no picture's."""
    try:
        figure.savefig(file, dpi=110)
    except ValueError as error:
        raise OSError(22, str(error).splitlines()[0], file)
    finally:
        plt.close(figure)


def nothing(panel, what):
    panel.text(0.5, 0.5, what + ": not in this run", ha="center", va="center", transform=panel.transAxes, color="#888888")


def draw_band(panel, run, column, factor):
    """+- the difference to the companion around the curve, where there is one."""
    off = difference(run, column)
    if off is not None:
        panel.fill_between(run["time"], factor * (run[column] - off), factor * (run[column] + off), color=LINE["color"], **BAND)


def per_window(run, amounts):
    """Times at the middle of each whole 10 s [s], and the sums of the amounts in them."""
    begin = run["time"][0]
    number = numpy.maximum(numpy.ceil((run["time"] - begin - 1e-6) / WINDOW).astype(int) - 1, 0)
    whole = int((run["time"][-1] - begin + 1e-6) / WINDOW)
    return begin + WINDOW * (numpy.arange(whole) + 0.5), numpy.bincount(number, weights=amounts, minlength=whole)[:whole]


def depth(panel, run, units):
    panel.plot(run["time"], units["length"].per_si * run["hole_depth"], color="#555555", linewidth=1.2, label="hole")
    panel.plot(run["time"], units["length"].per_si * run["bit_depth"], label="bit", **LINE)
    panel.invert_yaxis()
    panel.set_ylabel(units.label("measured depth", "length"))
    panel.legend(loc="upper right", fontsize=8)
    rates = panel.twinx()
    middle, metres = per_window(run, new_hole(run, on_bottom(run)))
    rates.step(middle, units["penetration"].per_si * metres / WINDOW, where="mid", color="#c0392b", linewidth=0.8)
    rates.set_ylabel(units.label("rate of penetration, 10 s", "penetration"), color="#c0392b")


def weight(panel, run, scores, units):
    force = units["force"].per_si
    panel.plot(run["time"], force * run["wob"], **LINE)
    draw_band(panel, run, "wob", force)
    found = scores["wob"] or {}
    if "set_point" in found:
        panel.axhspan(force * (found["set_point"] - found["band"]), force * (found["set_point"] + found["band"]), **SET_POINT)
    panel.set_ylabel(units.label("weight on bit", "force"))


def bit_speed(panel, run):
    panel.set_ylabel("speed [rpm]")
    panel.plot(run["time"], 30.0 / math.pi * run["top_drive_speed"], color="#555555", linewidth=0.8, label="top drive")
    if "bit_speed" in run:
        panel.plot(run["time"], 30.0 / math.pi * run["bit_speed"], label="bit", **LINE)
        draw_band(panel, run, "bit_speed", 30.0 / math.pi)
        windows = stick_slip_windows(run, on_bottom(run))
        indices = panel.twinx()
        indices.plot([begin + 0.5 * WINDOW for begin, _ in windows], [index for _, index in windows], "o", markersize=3, color="#c0392b")
        indices.set_ylim(0.0, max([1.2] + [1.1 * index for _, index in windows]))
        indices.set_ylabel("stick-slip index", color="#c0392b")
    panel.legend(loc="upper right", fontsize=8)


def toolface(panel, run, scores):
    panel.set_ylabel("toolface while sliding [deg]")
    if scores["toolface"] is None:
        nothing(panel, "sliding")
        return
    rows = sliding_rows(run, on_bottom(run))
    panel.plot(run["time"][rows], numpy.degrees(numpy.angle(numpy.exp(1j * run["toolface"][rows]))), ".", markersize=2.0, color="#1f5fa8")
    found = scores["toolface"]
    if "set_point_deg" in found:
        panel.axhspan(found["set_point_deg"] - found["band_deg"], found["set_point_deg"] + found["band_deg"], **SET_POINT)
    panel.set_ylim(-180.0, 180.0)


def energy(panel, run, bit_diameter, units):
    panel.set_ylabel(units.label("specific energy, 10 s", "specific_energy"))
    if bit_diameter is None:
        nothing(panel, "the bit's diameter")
        return
    bottom = on_bottom(run)
    drilled = new_hole(run, bottom)
    torque, speed = (run["bit_torque"], run["bit_speed"]) if "bit_torque" in run else (run["torque"], run["top_drive_speed"])
    middle, metres = per_window(run, drilled)
    _, work = per_window(run, numpy.where(drilled > 0.0, run["wob"] * drilled, 0.0) + numpy.where(bottom, torque * speed * run.dt, 0.0))
    good = metres > 1e-3
    panel.plot(middle[good], units["specific_energy"].per_si * work[good] / (0.25 * math.pi * bit_diameter**2 * metres[good]), ".-", **LINE)


def section(panel, run, plan, units):
    """Vertical section through the ends of the new hole: true vertical depth over the way along it."""
    length = units["length"].per_si
    panel.set_xlabel(units.label("along the new hole, horizontally", "length"))
    panel.set_ylabel(units.label("true vertical depth", "length"))
    points = bottom_points(run, new_hole(run, on_bottom(run)))
    if points is None:
        nothing(panel, "new hole")
        return
    begin, way = points[0], points[-1, :2] - points[0, :2]
    along = way / max(numpy.hypot(*way), 1e-9)
    if plan is not None:
        md = numpy.linspace(plan.md[0], plan.md[-1], 500)
        line = numpy.array([plan.at(depth)[0] for depth in md])
        near = (line[:, 2] <= points[:, 2].max() + 20.0) & (line[:, 2] >= points[:, 2].min() - 20.0)
        panel.plot(length * (line[near, :2] - begin[:2]) @ along, -length * line[near, 2], "--", color="#2ca02c", label="plan")
        panel.legend(loc="upper right", fontsize=8)
    panel.plot(length * (points[:, :2] - begin[:2]) @ along, -length * points[:, 2], ".-", markersize=3, **LINE)
    panel.invert_yaxis()
