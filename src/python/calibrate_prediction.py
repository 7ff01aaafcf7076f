# SPDX-License-Identifier: BSD-3-Clause
"""How drill calibrate prints and draws what fitted parameters predict."""
import numpy

UNITS = {"hook_load": (1e-3, "kN"), "torque": (1e-3, "kN m"), "stand_pipe_pressure": (1e-5, "bar")}
AXES = {"time": "time [s]", "depth": "depth [m]"}
MOST_ROWS, MOST_DECIMALS = 30, 4  # of a group that are printed; of a number in kN, kN m or bar


def lines(prediction):
    """Of each group its rows, thinned where they are many, and what is off in all of them."""
    found = []
    for group, rows in prediction.parts().items():
        factor, unit = UNITS[prediction.signals[rows[0]]]
        shown = rows[numpy.unique(numpy.linspace(0, len(rows) - 1, MOST_ROWS).round().astype(int))] if len(rows) > MOST_ROWS else rows
        said = prediction.summary()[group]
        places = decimals(factor * min([said["rms"], *prediction.band[rows][numpy.isfinite(prediction.band[rows])]]))
        found.append("%-14s %12s %12s %12s %12s" % (AXES[prediction.axis], "recorded", "predicted", "difference", "band"))
        for k in shown:
            numbers = [fixed(factor * value, places) for value in (prediction.observed[k], prediction.predicted[k], prediction.off[k])]
            band = "+- " + fixed(factor * prediction.band[k], places) if numpy.isfinite(prediction.band[k]) else "unknown"
            found.append("%-14.8g %12s %12s %12s %12s%s" % (prediction.places[k], *numbers, band, "" if abs(prediction.off[k]) <= prediction.band[k] else "  beyond"))
        within = "the band of %d rows is unknown" % said["rows"] if said["within"] is None else "%.1f %% of %d rows within the band" % (100.0 * said["within"], said["rows"])
        found += ["%s [%s]: %s; off by %s in the mean, %s rms, %s at most%s" %
                  (group, unit, within, *(fixed(factor * said[key], places) for key in ("mean", "rms", "largest")),
                   "" if len(shown) == len(rows) else "; %d rows are shown" % len(shown)), ""]
    return found


def decimals(size):
    """So many places after the point show three digits of a size, but at most MOST_DECIMALS."""
    return int(numpy.clip(2 - numpy.floor(numpy.log10(size)), 0, MOST_DECIMALS)) if size > 0.0 else MOST_DECIMALS


def fixed(value, places):
    """A number without an exponent, and a zero without a sign."""
    return "%.*f" % (places, round(value, places) + 0.0)


def remarks(prediction):
    """What its reader should know, a line each."""
    lost = int((~numpy.isfinite(prediction.predicted) & numpy.isfinite(prediction.observed)).sum())
    return (["the band is unknown where it depends on values that the fit's data do not determine: %s" % ", ".join(prediction.untold)] if prediction.untold else []) + (
        ["%d numbers could not be predicted: no equilibrium, or a scene out of range" % lost] if lost else [])


def draw(prediction, file, title):
    from drill_rig_sim.score_plots import plt, save  # needs matplotlib
    parts = prediction.parts()
    figure, axes = plt.subplots(len(parts), figsize=(9.0, 0.5 + 3.2 * len(parts)), squeeze=False, constrained_layout=True)
    for axis, (group, rows) in zip(axes[:, 0], parts.items()):
        factor, unit = UNITS[prediction.signals[rows[0]]]
        rows = rows[numpy.argsort(prediction.places[rows], kind="stable")]
        places, middle = prediction.places[rows], factor * prediction.predicted[rows]
        width = factor * numpy.where(numpy.isfinite(prediction.band[rows]), prediction.band[rows], numpy.nan)
        axis.fill_between(places, middle - width, middle + width, color="#1f5fa8", alpha=0.2, linewidth=0.0, label="95 % band")
        axis.plot(places, middle, color="#1f5fa8", linewidth=0.9, label="predicted")
        axis.plot(places, factor * prediction.observed[rows], color="#555555", linewidth=0.9, marker="." if len(rows) < 100 else "", label="recorded")
        axis.set_ylabel("%s [%s]" % (group.replace("_", " "), unit))
        axis.legend(fontsize=8)
    axes[-1, 0].set_xlabel(AXES[prediction.axis])
    axes[0, 0].set_title(title, fontsize=10)
    save(figure, file)
