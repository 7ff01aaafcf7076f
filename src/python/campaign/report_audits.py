# SPDX-License-Identifier: BSD-3-Clause
"""Of a campaign's page what its audits found: how wrong the results are, by output, and the list of audited runs."""
import html

import numpy
from drill_rig_sim.campaign import audits
from drill_rig_sim.campaign.report_pictures import plt

NONE = "No run was audited: %s."
SHOWN = ("%d of %d runs were played once more together with two finer models of them, as <code>drill verify</code> does (%s): %s. An error is the root mean square of an output's "
         "difference to the finest model over 3 s, as a share of the output's range; the worst 3 s of each run count. The tolerance is %s (red in the picture).")


def intro(rows):
    """What was audited, in a line."""
    if not rows.audits:
        share = audits.share_of(rows.about, len(audits.once(rows.rows)))
        return NONE % ("it is not done yet" if share else "<code>audit</code> is 0 in the plan" if rows.about.get("audit") == 0.0 else
                       "there are fewer than %d; <code>audit: %g</code> in the plan asks for it" % (audits.SMALL, audits.SHARE))
    tolerances = sorted({row["outputs"]["tolerance"] for row in rows.audits if "tolerance" in row["outputs"]})
    found = [audits.summary(row["status"] for row in rows.audits), audits.unmeasured(rows.audits)]
    return SHOWN % (len(rows.audits), len(rows.rows), "drawn by the plan's seed, and those with extreme results", html.escape("; ".join(filter(None, found))),
                    " or ".join(percent(value) for value in tolerances) or "not known")


def percent(share):
    return "none" if share is None else "%.3g %%" % (100.0 * share)


def table_by_output(rows):
    """Head and lines."""
    lines = []
    for name, found in audits.by_output(rows.audits).items():
        worst = [(finding["worst"], row["number"]) for row, finding in found if finding["worst"] is not None]
        counts = audits.counts(finding["verdict"] for _, finding in found)
        needed = any(finding["needed"] for _, finding in found)
        lines.append([len(found), *counts.values(), percent(numpy.median([value for value, _ in worst]) if worst else None), percent(max(worst)[0] if worst else None),
                      max(worst)[1] if worst else "", name if needed else name + " (not in needs)"])
    return ["audited", *audits.VERDICTS.values(), "median error", "largest error", "in run", "output"], lines


def table_of_runs(rows):
    """Head and lines."""
    why, lines = audits.chosen(rows.rows, rows.about), []
    for row in rows.audits:
        name, finding = audits.worst_of(row)
        at = 3 * [""] if finding is None else [name, percent(finding["worst"]), "%.0f s" % finding["worst_until"]]
        lines.append([row["number"], audits.VERDICTS[audits.verdict_of(row["status"])], *at, *row["values"], why.get(row["number"], "chosen before"), row["reason"]])
    return ["run", "verdict", "farthest off", "by", "until", *rows.factors, "audited because", "ended"], lines


def histograms(rows):
    """Of the errors of the needed outputs; None where there are none."""
    shown = []
    for name, found in audits.by_output(rows.audits).items():
        worst = [finding["worst"] for _, finding in found if finding["needed"] and finding["worst"] is not None]
        if worst:
            shown.append((name, worst, found[0][0]["outputs"]["tolerance"]))
    if not shown:
        return None
    figure, panels = plt.subplots(1, len(shown), figsize=(2.4 * len(shown), 2.4), sharey=True, squeeze=False, constrained_layout=True)
    for panel, (name, worst, tolerance) in zip(panels[0], shown):
        edges = audits.bins(worst, tolerance)
        panel.hist(numpy.clip(worst, edges[0], edges[-1]), bins=edges, color="#1f5fa8")
        panel.axvline(tolerance, color="#c0392b", linewidth=0.9)
        panel.set_xscale("log")
        panel.set_xlabel("error [-]", fontsize=8)
        panel.set_title(name, fontsize=9)
        panel.tick_params(labelsize=7)
    panels[0, 0].set_ylabel("audited runs", fontsize=8)
    return figure
