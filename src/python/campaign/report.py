# SPDX-License-Identifier: BSD-3-Clause
"""A campaign's page: what came of it, how wrong it is, map, sensitivity, histograms, the worst runs."""
import base64
import html
import io
import os

import numpy
from drill_rig_sim.campaign import again, report_audits, report_pictures
from drill_rig_sim.campaign.blueprint import Blueprint
from drill_rig_sim.campaign.measures import column
from drill_rig_sim.campaign.outputs import shown_as
from drill_rig_sim.campaign.results import ResultsError
from drill_rig_sim.campaign.runner import GOOD
from drill_rig_sim.units import Units

WORST = 10
STYLE = """body{font-family:sans-serif;margin:1.5em;color:#222;max-width:72em}img{max-width:100%;border:1px solid #ddd}table{border-collapse:collapse;margin:0.5em 0 1.5em}
td,th{border:1px solid #ccc;padding:0.2em 0.6em;text-align:right}td:last-child,th:last-child{text-align:left}pre{background:#f6f6f6;padding:1em;overflow-x:auto}"""


class Rows:
    """The plan's runs and audits that are there; outputs in SI as the results' file has them, or in oilfield units where their quantity is known."""

    def __init__(self, results, system="si"):
        self.about, self.units = results.about(), Units(system)
        if "factors" not in self.about:
            raise ResultsError("%s: holds no campaign" % results.file)
        self.blueprint = Blueprint.of_parts(self.about["blueprint"])
        self.rows, self.audits = list(results.rows()), list(results.audits())
        self.good = [row for row in self.rows if row["status"] == GOOD]
        self.factors, self.outputs = self.about["factors"], self.about["outputs"]

    def output(self, name, rows=None):
        """Numbers; not a number where a run has none."""
        numbers = [numpy.nan if row["outputs"].get(name) is None else row["outputs"][name] for row in (self.good if rows is None else rows)]
        return self.in_units(name, numpy.array(numbers, dtype=float))

    def quantity(self, name):
        """Of an output, with the factor to SI; None where it is shown as it is in the results' file."""
        return None if self.units.system == "si" else shown_as(self.blueprint.outputs[name])

    def in_units(self, name, number):
        """A number of an output as it is shown; a deviation is a difference."""
        known = self.quantity(name)
        if not known:
            return number
        unit, what = self.units[known[0]], self.blueprint.outputs[name]
        return known[1] * unit.per_si * number + (0.0 if what.startswith("deviation.") else unit.zero)

    def label_of(self, name):
        known = self.quantity(name)
        return self.units.label(name, known[0]) if known else name

    def factor(self, name):
        """Its values, as numbers where they are all in one unit."""
        return self.column(name)[0]

    def label(self, name):
        """Of a factor's axis."""
        unit = self.column(name)[1]
        return "%s [%s]" % (name, unit) if unit else name

    def column(self, name):
        return column([row["values"][self.factors.index(name)] for row in self.good])


def write_page(results, file, system="si"):
    """Returns the file. `system`: of the units that outputs are shown in."""
    rows = Rows(results, system)
    parts = ["<h1>%s</h1>" % html.escape(rows.about["name"]), "<p>%s</p>" % html.escape(summary(rows)), statistics(rows), *accuracy(rows)]
    for title, figure in report_pictures.figures_of(rows):
        parts += ["<h2>%s</h2>" % html.escape(title), picture(title, figure)]
    parts += ["<h2>The worst by %s</h2>" % html.escape(rows.about["report"]["worst"]), worst(rows, os.path.basename(results.file)),
              bad(rows), "<h2>Plan</h2><pre>%s</pre>" % html.escape(rows.about["plan"])]
    with open(file, "w", encoding="utf-8") as out:
        out.write('<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8"><title>%s</title><style>%s</style></head>\n<body>%s</body></html>\n' %
                  (html.escape(rows.about["name"]), STYLE, "\n".join(parts)))
    return file


def summary(rows):
    build, kernel = rows.about["identity"]
    return "%d runs, %d of them good; %.3g s of processor time. Build %s, kernel %s; sample: %s." % (
        len(rows.rows), len(rows.good), sum(row["cpu"] for row in rows.rows), build[:8], kernel,
        ", ".join("%s %s" % (name, value) for name, value in rows.about["sample"].items() if value))


def accuracy(rows):
    """What the audits found, in parts of the page."""
    parts = ["<h2>How wrong the runs are</h2>", "<p>%s</p>" % report_audits.intro(rows)]
    if rows.audits:
        figure = report_audits.histograms(rows)
        parts += [table(*report_audits.table_by_output(rows)), *([picture("Errors of audited runs", figure)] if figure else []), table(*report_audits.table_of_runs(rows))]
    return parts


def picture(title, figure):
    return '<img alt="%s" src="data:image/png;base64,%s">' % (html.escape(title), png_of(figure))


def table(head, lines):
    cells = lambda kind, line: "<tr>%s</tr>" % "".join("<%s>%s</%s>" % (kind, html.escape(str(shortly(cell))), kind) for cell in line)  # noqa: E731
    return "<table>%s%s</table>" % (cells("th", head), "".join(cells("td", line) for line in lines))


def statistics(rows):
    lines = []
    for name in rows.outputs:
        values = rows.output(name)
        values = values[numpy.isfinite(values)]
        if len(values):
            lines.append([len(values), *("%.4g" % q for q in (values.mean(), values.std(), *numpy.percentile(values, (0, 5, 50, 95, 100)))), rows.label_of(name)])
    return table(["runs", "mean", "deviation", "least", "5 %", "median", "95 %", "largest", "output"], lines)


def worst_rows(rows):
    name, least = rows.about["report"]["worst"], rows.about["report"]["least"]
    values = rows.output(name)
    order = numpy.argsort(values if least else -values, kind="stable")
    return [rows.good[k] for k in order if numpy.isfinite(values[k])][:WORST]


def worst(rows, file):
    """The runs, and what shows each of them in rviz."""
    shown = worst_rows(rows)
    name = rows.about["report"]["worst"]
    lines = [[row["number"], "%.5g" % rows.in_units(name, row["outputs"][name]), *row["values"], again.scene_command(file, row["number"])]
             for row in shown]
    text = table(["run", rows.label_of(name), *rows.factors, "its scene"], lines)
    if shown:
        text += "<p>%s</p><pre>%s</pre>" % (again_as(rows.blueprint), html.escape("\n".join(again.commands(rows.blueprint, shown[0], file))))
    return text


def again_as(blueprint):
    """What the commands do."""
    played = "with its controller" if blueprint.controller is not None else "by the scene's program"
    return "A look at one, %s and its seed; and the same run once more, to the last bit, as a time series:" % played


def shortly(value):
    return "%.5g" % value if isinstance(value, float) else value


def bad(rows):
    failed = [row for row in rows.rows if row["status"] != GOOD]
    if not failed:
        return ""
    lines = [[row["number"], row["status"], *row["values"], row["reason"]] for row in failed[:50]]
    more = "<p>and %d more</p>" % (len(failed) - 50) if len(failed) > 50 else ""
    return "<h2>What did not end well</h2>" + table(["run", "status", *rows.factors, "why"], lines) + more


def png_of(figure):
    out = io.BytesIO()
    figure.savefig(out, format="png", dpi=90)
    report_pictures.plt.close(figure)
    return base64.b64encode(out.getvalue()).decode("ascii")
