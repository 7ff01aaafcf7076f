# SPDX-License-Identifier: BSD-3-Clause
"""Logs of a run in the trade's layout: tracks side by side, time or depth downwards, each curve with its scale on top of its track."""
import numpy
from drill_rig_sim.companion import differences
from drill_rig_sim.score import new_hole, on_bottom, sliding_rows
from drill_rig_sim.score_plots import BAND, plt
from drill_rig_sim.units import SI

LEAST_INCLINATION = 0.005  # below it a hole has no azimuth [rad]
BIN = 0.1  # of new hole, of which a depth log shows the mean [m]

# tracks of scales: columns, their quantity, name, what it spans at least in SI units, colour; columns after the first are drawn on the same in grey
HOOK_LOAD = ("hook_load", "force", "hook load", 5e3, "#1f5fa8")
DRILLING = (("rop", "penetration", "ROP", 1.0 / 3600.0, "#c0392b"), ("wob", "force", "WOB", 2e3, "#1f5fa8"))
TURNING = (("top_drive_speed", "rotation", "top drive", 0.5, "#555555"), ("bit_speed", "rotation", "bit", 0.5, "#e08e0b"), ("torque", "torque", "torque", 200.0, "#1f5fa8"))
FLOW = ("flow", "flow", "flow", 3.3e-4, "#2ca02c")
TIME_TRACKS = (
    (("block_height", "length", "block", 1.0, "#555555"), HOOK_LOAD),
    DRILLING,
    TURNING,
    (("stand_pipe_pressure", "pressure", "stand pipe", 2e5, "#1f5fa8"), ("differential_pressure", "pressure", "differential", 2e5, "#c0392b"), FLOW),
    (("bit_depth hole_depth", "length", "bit, hole (grey)", 1.0, "#1f5fa8"),))
DEPTH_TRACKS = (
    DRILLING,
    TURNING,
    (HOOK_LOAD, ("stand_pipe_pressure", "pressure", "stand pipe", 2e5, "#c0392b"), FLOW),
    (("inclination", "angle", "inclination", 0.01, "#1f5fa8"), ("azimuth", "angle", "azimuth", 0.1, "#c0392b")))


def time_log(run, units=SI):
    """Over the whole run."""
    figure = tracks(run["time"], "time [s]", TIME_TRACKS, run.columns, "time log: " + run.title, units, differences(run))
    bands(figure, run)
    loads = run["hook_load"] if "hook_load" in run else numpy.array([])
    if numpy.isfinite(loads).any():
        largest, force = int(numpy.nanargmax(loads)), units["force"]
        figure.text(0.09, 0.01, "largest hook load %.1f %s at %.0f s" % (force.per_si * loads[largest], force.name, run["time"][largest]), fontsize=8)
    return figure


def depth_log(run, units=SI):
    """Over the new hole: means of what was on bottom, by BIN of depth, weighted by time. None where nothing was drilled."""
    bottom = on_bottom(run)
    if new_hole(run, bottom).sum() < 2.0 * BIN:
        return None
    number = numpy.floor(run["hole_depth"] / BIN).astype(int)
    first, number = number.min(), number - number.min()
    weights = numpy.where(bottom, run.dt, 0.0)
    total = numpy.bincount(number, weights)
    good = total > 0.0

    def averaged(columns):
        sums = {name: numpy.bincount(number, numpy.where(bottom, weights * values, 0.0), len(total)) for name, values in columns.items()}
        return {name: values[good] / total[good] for name, values in sums.items()}

    means = averaged(run.columns)
    means["rop"] = numpy.bincount(number, new_hole(run, bottom), len(total))[good] / total[good]
    if "azimuth" in means:
        means["azimuth"] = numpy.where(means["inclination"] > LEAST_INCLINATION, means["azimuth"], numpy.nan)
    depth = (first + numpy.flatnonzero(good) + 0.5) * BIN
    label, bands = units.label("measured depth", "length"), averaged(differences(run))
    return tracks(units["length"].per_si * depth, label, DEPTH_TRACKS, means, "depth log: " + run.title, units, bands)


def tracks(down, label, layout, columns, title, units, bands):
    """One axes a track; a track none of whose scales is there is left out. `bands`: half the width of a band around a column's curve, by columns."""
    layout = [[scale for scale in track if scale[0].split()[0] in columns] for track in layout]
    layout = [track for track in layout if track]
    figure, axes = plt.subplots(1, len(layout), sharey=True, figsize=(2.3 * len(layout) + 0.6, 9.0), squeeze=False)
    for panel, track in zip(axes[0], layout):
        panel.set_xticks([])
        panel.grid(alpha=0.3)
        for place, scale in enumerate(track):
            draw_scale(panel, place, down, [columns[column] for column in scale[0].split()], scale, units, bands.get(scale[0]))
    figure.tracks = len(layout)
    axes[0, 0].set_ylabel(label)
    axes[0, 0].set_ylim(down[-1], down[0])
    figure.suptitle(title, fontsize=10)
    figure.subplots_adjust(left=0.09, right=0.98, bottom=0.04, top=0.80, wspace=0.08)
    return figure


def draw_scale(panel, place, down, curves, drawn, units, band):
    """Above those before it. `band`: of the first curve, or None."""
    _, quantity, name, least, colour = drawn
    factor, scale = units[quantity].per_si, panel.twiny()
    curves = [factor * curve for curve in curves]
    for curve, shade in zip(curves, (colour, "#999999")):
        scale.plot(curve, down, color=shade, linewidth=0.8)
    if band is not None:
        scale.fill_betweenx(down, curves[0] - factor * band, curves[0] + factor * band, color=colour, **BAND)
    scale.set_xlim(*limits(numpy.concatenate(curves), factor * least))
    mark_cuts(scale, curves[0], down, colour)
    scale.spines["top"].set_position(("outward", 34.0 * place))
    scale.spines["top"].set_color(colour)
    scale.tick_params(axis="x", colors=colour, labelsize=7)
    scale.xaxis.set_major_locator(plt.MaxNLocator(3))
    scale.set_xlabel(units.label(name, quantity), color=colour, fontsize=8, labelpad=2)


def limits(values, least):
    """Of a scale: what is within the outer half percents, so that a short peak does not flatten all else; from 0 where that is near."""
    low, high = numpy.percentile(values[numpy.isfinite(values)], (0.5, 99.5)) if numpy.isfinite(values).any() else (0.0, 0.0)
    low, high = min(low, 0.0) if low < 0.5 * high else low, max(high, 0.0) if high > 0.5 * low else high
    margin = max(0.05 * (high - low), 0.5 * (least - (high - low)))
    return low - margin, high + margin


def mark_cuts(scale, curve, down, colour):
    """An arrow with the extreme value where a curve leaves its scale."""
    low, high = scale.get_xlim()
    known = numpy.isfinite(curve)
    if not known.any():
        return
    most, least = int(numpy.nanargmax(curve)), int(numpy.nanargmin(curve))
    if curve[most] > high:
        scale.annotate("%.4g \u25b6" % curve[most], (high, down[most]), ha="right", va="center", color=colour, fontsize=7, annotation_clip=False)
    if curve[least] < low:
        scale.annotate("\u25c0 %.4g" % curve[least], (low, down[least]), ha="left", va="center", color=colour, fontsize=7, annotation_clip=False)


def bands(figure, run):
    """In all tracks: pipe in the slips over the whole width, slides along the left edge, warnings of accuracy along the right one, so that none hides another."""
    slides = sliding_rows(run, on_bottom(run)) if "top_drive_speed" in run else numpy.zeros(len(run["time"]), bool)
    shown = []
    for name, rows, where, look in (("in slips", raised(run, "in_slips"), (0.0, 1.0), {"color": "#cccccc", "alpha": 0.5, "linewidth": 0.0}),
                                    ("slide", slides, (0.0, 0.06), {"color": "#e08e0b", "linewidth": 0.0}),
                                    ("accuracy warning", raised(run, "accuracy_warning"), (0.94, 1.0), {"facecolor": "#f6d8d5", "edgecolor": "#c0392b", "hatch": "///", "linewidth": 0.0})):
        edges = numpy.flatnonzero(numpy.diff(numpy.concatenate(([0.0], rows, [0.0]))))
        for begin, end in zip(edges[::2], edges[1::2]):
            for panel in figure.axes[:figure.tracks]:
                panel.axhspan(run["time"][begin], run["time"][min(end, len(run["time"]) - 1)], *where, zorder=0, **look)
        if len(edges):
            shown.append(plt.Rectangle((0, 0), 1, 1, label=name, **look))
    if shown:
        figure.legend(handles=shown, loc="lower right", ncol=3, fontsize=8, frameon=False, borderaxespad=0.1)


def raised(run, flag):
    return run[flag] > 0.0 if flag in run else numpy.zeros(len(run["time"]), bool)
