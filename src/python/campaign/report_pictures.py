# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of a campaign's page."""
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402  pylint: disable=wrong-import-position
import numpy  # noqa: E402  pylint: disable=wrong-import-position
from drill_rig_sim.campaign import sensitivity  # noqa: E402  pylint: disable=wrong-import-position

MOST_HISTOGRAMS, MOST_MAPS = 12, 6


def figures_of(rows):
    """Titles and figures; what there are no numbers for is left out."""
    drawn = [("Map", factor_map(rows)), ("Sensitivity", influence(rows)), ("Histograms", histograms(rows))]
    return [one for one in drawn if one[1] is not None]


def numbers(values):
    """A column as numbers; words by their place in the list of them, with their names."""
    try:
        return numpy.array([float(value) for value in values]), None
    except (TypeError, ValueError):
        names = sorted({str(value) for value in values})
        return numpy.array([float(names.index(str(value))) for value in values]), names


def factor_map(rows):
    """An output over two factors, one beside the other for each value of a third: squares where the runs are a grid, else points."""
    shown, each = rows.about["report"]["map"], rows.about["report"]["each"]
    if not shown or not rows.good:
        return None
    first, second, output = shown
    (x, x_names), (y, y_names), z = numbers(rows.factor(first)), numbers(rows.factor(second)), rows.output(output)
    if not numpy.isfinite(z).any():
        return None
    groups = [str(value) for value in rows.factor(each)] if each else [""] * len(z)
    names = sorted(set(groups), key=groups.index)[:MOST_MAPS]
    limits = {"vmin": numpy.nanmin(z), "vmax": numpy.nanmax(z), "cmap": "viridis"}
    figure, panels = plt.subplots(1, len(names), figsize=(max(7.5, 1.2 + 3.8 * len(names)), 4.8), sharey=True, squeeze=False, constrained_layout=True)
    for panel, name in zip(panels[0], names):
        inside = numpy.array([group == name for group in groups]) & numpy.isfinite(z)
        drawn = draw_map(panel, x[inside], y[inside], z[inside], limits)
        for words, axis in ((x_names, panel.xaxis), (y_names, panel.yaxis)):
            if words:
                axis.set_ticks(range(len(words)), words)
        panel.set_xlabel(rows.label(first))
        panel.set_title("%s %s" % (rows.label(each), name) if each else "", fontsize=9)
    panels[0, 0].set_ylabel(rows.label(second))
    figure.colorbar(drawn, ax=list(panels[0]), label=rows.label_of(output))
    return figure


def draw_map(panel, x, y, z, limits):
    columns, lines = numpy.unique(x), numpy.unique(y)
    if not 1 < len(columns) * len(lines) <= len(z):
        return panel.scatter(x, y, c=z, s=18, **limits)
    squares = numpy.array([[z[(x == column) & (y == line)].mean() if ((x == column) & (y == line)).any() else numpy.nan for column in columns] for line in lines])
    return panel.pcolormesh(columns, lines, squares, shading="nearest", **limits)


def influence(rows):
    """Sobol's indices of a saltelli design, else rank correlations; a panel an output."""
    saltelli = rows.about["sample"]["kind"] == "saltelli"
    found = {output: (indices_of if saltelli else correlations_of)(rows, output) for output in rows.outputs}
    found = {output: values for output, values in found.items() if values}
    if not found:
        return None
    bars = 1 if saltelli else max(len(values) for values in found.values())
    figure, panels = plt.subplots(1, len(found), figsize=(max(4.0, 3.4 * len(found)), (0.35 + 0.15 * bars) * len(rows.factors) + 1.6), sharey=True, squeeze=False)
    for panel, (output, values) in zip(panels[0], found.items()):
        (draw_indices if saltelli else draw_correlations)(panel, values)
        panel.axvline(0.0, color="#555555", linewidth=0.6)
        panel.set_title(output, fontsize=9)
        panel.set_yticks(range(len(rows.factors)), rows.factors)
    figure.tight_layout()
    return figure


def indices_of(rows, output):
    """None where the design is not complete."""
    whole = rows.output(output, [row if row["status"] == "good" else {"outputs": {}} for row in rows.rows])
    complete = len(rows.rows) == rows.about["sample"]["runs"] * (len(rows.factors) + 2)
    return sensitivity.indices(whole, len(rows.factors)) if complete else None


def correlations_of(rows, output):
    """Rank correlations by the groups that the map shows apart: pooled, a factor that acts one way in one group and the other way in another would seem to do
    nothing, or the contrary of what the map shows. None where there are none."""
    each = rows.about["report"]["each"]
    groups = [str(value) for value in rows.factor(each)] if each else [""] * len(rows.good)
    columns, values, found = [rows.factor(name) for name in rows.factors], rows.output(output), {}
    for name in sorted(set(groups), key=groups.index)[:MOST_MAPS]:
        inside = [k for k, group in enumerate(groups) if group == name]
        found["%s %s" % (each, name) if each else ""] = sensitivity.rank_correlations([[column[k] for k in inside] for column in columns], values[inside])
    return found if any(value is not None for group in found.values() for value in group) else None


def draw_indices(panel, values):
    places = numpy.arange(len(values))
    first, first_width, total, total_width = numpy.array(values).T
    panel.barh(places - 0.18, first, 0.34, xerr=first_width, label="first order", color="#1f5fa8")
    panel.barh(places + 0.18, total, 0.34, xerr=total_width, label="total", color="#e08e0b")
    panel.set_xlim(-0.1, 1.1)
    panel.legend(fontsize=7)


def draw_correlations(panel, groups):
    height = 0.7 / len(groups)
    for k, (name, values) in enumerate(groups.items()):
        places = numpy.arange(len(values)) + (k - 0.5 * (len(groups) - 1)) * height
        panel.barh(places, [0.0 if value is None else value for value in values], height, label=name)
        if len(groups) == 1:
            for place, value in zip(places, values):
                if value is None:
                    panel.text(0.03, place, "words, or constant", fontsize=7, color="#777777", va="center")
    if len(groups) > 1:
        panel.legend(fontsize=7)
    panel.set_xlim(-1.0, 1.0)
    panel.set_xlabel("rank correlation", fontsize=8)


def histograms(rows):
    shown = [(name, rows.output(name)) for name in rows.outputs]
    shown = [(name, values[numpy.isfinite(values)]) for name, values in shown if numpy.isfinite(values).any()][:MOST_HISTOGRAMS]
    if not shown:
        return None
    wide = min(3, len(shown))
    high = (len(shown) + wide - 1) // wide
    figure, panels = plt.subplots(high, wide, figsize=(3.6 * wide, 2.4 * high), squeeze=False)
    for panel in panels.flat[len(shown):]:
        panel.set_visible(False)
    for panel, (name, values) in zip(panels.flat, shown):
        panel.hist(values, bins=min(40, max(5, int(len(values)**0.5))), color="#1f5fa8")
        panel.set_xlabel(rows.label_of(name), fontsize=8)
        panel.set_ylabel("runs", fontsize=8)
    figure.tight_layout()
    return figure
