"""Logs of a run in the trade's layout: tracks side by side, time or depth downwards, each curve with its scale on top of its track."""
import math

import numpy
from drill_rig_sim.score import new_hole, on_bottom
from drill_rig_sim.score_plots import plt

RPM, DEGREE, BAR = 30.0 / math.pi, 180.0 / math.pi, 1e-5
LEAST_INCLINATION = 0.005  # below it a hole has no azimuth [rad]
BIN = 0.1  # of new hole, of which a depth log shows the mean [m]

# tracks of scales: columns, factor to the unit, name with unit, what it spans at least, colour; columns after the first are drawn on the same in grey
TIME_TRACKS = (
    (("block_height", 1.0, "block [m]", 1, "#555555"), ("hook_load", 1e-3, "hook load [kN]", 5, "#1f5fa8")),
    (("rop", 3600.0, "ROP [m/h]", 1, "#c0392b"), ("wob", 1e-3, "WOB [kN]", 2, "#1f5fa8")),
    (("top_drive_speed", RPM, "top drive [rpm]", 5, "#555555"), ("bit_speed", RPM, "bit [rpm]", 5, "#e08e0b"), ("torque", 1e-3, "torque [kN m]", 0.2, "#1f5fa8")),
    (("stand_pipe_pressure", BAR, "stand pipe [bar]", 2, "#1f5fa8"), ("differential_pressure", BAR, "differential [bar]", 2, "#c0392b"),
     ("flow", 6e4, "flow [L/min]", 20, "#2ca02c")),
    (("bit_depth hole_depth", 1.0, "bit, hole (grey) [m]", 1, "#1f5fa8"),))
DEPTH_TRACKS = (
    (("rop", 3600.0, "ROP [m/h]", 1, "#c0392b"), ("wob", 1e-3, "WOB [kN]", 2, "#1f5fa8")),
    (("top_drive_speed", RPM, "top drive [rpm]", 5, "#555555"), ("bit_speed", RPM, "bit [rpm]", 5, "#e08e0b"), ("torque", 1e-3, "torque [kN m]", 0.2, "#1f5fa8")),
    (("hook_load", 1e-3, "hook load [kN]", 5, "#1f5fa8"), ("stand_pipe_pressure", BAR, "stand pipe [bar]", 2, "#c0392b"), ("flow", 6e4, "flow [L/min]", 20, "#2ca02c")),
    (("inclination", DEGREE, "inclination [deg]", 0.5, "#1f5fa8"), ("azimuth", DEGREE, "azimuth [deg]", 5, "#c0392b")))


def time_log(run):
    """Over the whole run."""
    figure = tracks(run["time"], "time [s]", TIME_TRACKS, run.columns, "time log: " + run.title)
    flags(figure.axes[0], run)
    return figure


def depth_log(run):
    """Over the new hole: means of what was on bottom, by BIN of depth, weighted by time. None where nothing was drilled."""
    bottom = on_bottom(run)
    if new_hole(run, bottom).sum() < 2.0 * BIN:
        return None
    number = numpy.floor(run["hole_depth"] / BIN).astype(int)
    first, number = number.min(), number - number.min()
    weights = numpy.where(bottom, run.dt, 0.0)
    total = numpy.bincount(number, weights)
    good = total > 0.0
    means = {name: numpy.bincount(number, numpy.where(bottom, weights * values, 0.0), len(total))[good] / total[good] for name, values in run.columns.items()}
    means["rop"] = numpy.bincount(number, new_hole(run, bottom), len(total))[good] / total[good]
    if "azimuth" in means:
        means["azimuth"] = numpy.where(means["inclination"] > LEAST_INCLINATION, means["azimuth"], numpy.nan)
    return tracks((first + numpy.flatnonzero(good) + 0.5) * BIN, "measured depth [m]", DEPTH_TRACKS, means, "depth log: " + run.title)


def tracks(down, label, layout, columns, title):
    """One axes a track; a track none of whose scales is there is left out."""
    layout = [[scale for scale in track if scale[0].split()[0] in columns] for track in layout]
    layout = [track for track in layout if track]
    figure, axes = plt.subplots(1, len(layout), sharey=True, figsize=(2.3 * len(layout) + 0.6, 9.0), squeeze=False)
    for panel, track in zip(axes[0], layout):
        panel.set_xticks([])
        panel.grid(alpha=0.3)
        for place, scale in enumerate(track):
            draw_scale(panel, place, down, [scale[1] * columns[column] for column in scale[0].split()], scale)
    axes[0, 0].set_ylabel(label)
    axes[0, 0].set_ylim(down[-1], down[0])
    figure.suptitle(title, fontsize=10)
    figure.subplots_adjust(left=0.09, right=0.98, bottom=0.03, top=0.80, wspace=0.08)
    return figure


def draw_scale(panel, place, down, curves, drawn):
    """Above those before it."""
    _, _, name, least, colour = drawn
    scale = panel.twiny()
    for curve, shade in zip(curves, (colour, "#999999")):
        scale.plot(curve, down, color=shade, linewidth=0.8)
    scale.set_xlim(*limits(numpy.concatenate(curves), least))
    scale.spines["top"].set_position(("outward", 34.0 * place))
    scale.spines["top"].set_color(colour)
    scale.tick_params(axis="x", colors=colour, labelsize=7)
    scale.xaxis.set_major_locator(plt.MaxNLocator(3))
    scale.set_xlabel(name, color=colour, fontsize=8, labelpad=2)


def limits(values, least):
    """Of a scale: what is within the outer half percents, so that a jerk does not flatten all else; from 0 where that is near."""
    low, high = numpy.percentile(values[numpy.isfinite(values)], (0.5, 99.5)) if numpy.isfinite(values).any() else (0.0, 0.0)
    low, high = min(low, 0.0) if low < 0.5 * high else low, max(high, 0.0) if high > 0.5 * low else high
    margin = max(0.05 * (high - low), 0.5 * (least - (high - low)))
    return low - margin, high + margin


def flags(panel, run):
    """Where pipe hangs in the slips, and where the simulation doubts itself."""
    for name, colour in (("in_slips", "#cccccc"), ("accuracy_warning", "#f6d8d5")):
        if name not in run:
            continue
        edges = numpy.flatnonzero(numpy.diff(numpy.concatenate(([0.0], run[name] > 0.0, [0.0]))))
        for begin, end in zip(edges[::2], edges[1::2]):
            panel.axhspan(run["time"][begin], run["time"][min(end, len(run["time"]) - 1)], color=colour, zorder=0)
