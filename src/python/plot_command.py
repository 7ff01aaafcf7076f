# SPDX-License-Identifier: BSD-3-Clause
"""What `drill plot` starts: logs and pictures of a run as PNG and SVG, and one page that holds them. The runner has checked the command line."""
import argparse
import base64
import html
import os
import sys

from drill_rig_sim import plot_logs, plot_well
from drill_rig_sim.score import read_run, read_survey, score
from drill_rig_sim.score_command import BAD_INPUT, FAILED, GOOD, table
from drill_rig_sim.score_plots import plt
from drill_rig_sim.score_runs import RunError
from drill_rig_sim.survey import SurveyError
from drill_rig_sim.text_file import report
from drill_rig_sim.units import SI, SYSTEMS, Units
from drill_rig_sim.web.bag_source import BagSource
from drill_rig_sim.web.chart_library import has_chart_library
from drill_rig_sim.web.offline import page_of
from drill_rig_sim.web.series_source import SeriesSource

WEB_PAGE = "web.html"
PAGE = """<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><title>%(name)s</title><meta name="viewport" content="width=device-width">
<meta name="color-scheme" content="light dark">
<style>
:root{color-scheme:light dark;--back:#fff;--ink:#222;--panel:#f6f6f6;--line:#ddd;--link:#0b63a5}
body{font-family:sans-serif;margin:1.5em;color:var(--ink);background:var(--back)}
a{color:var(--link)}
nav a{margin-right:1em}
pre{background:var(--panel);padding:1em;overflow-x:auto}
img{max-width:100%%;height:auto;border:1px solid var(--line);margin:0 0 1.5em}
@media screen and (prefers-color-scheme:dark){
:root{--back:#10151a;--ink:#e8edf2;--panel:#1a2128;--line:#36424d;--link:#62b5f0}
img{filter:invert(.93) hue-rotate(180deg)}  /* pictures are drawn on white; hues stay */
}
@media print{
@page{size:A4;margin:12mm}
:root{color-scheme:light}
body{margin:0}
nav{display:none}
pre{white-space:pre-wrap;font-size:8pt;padding:.5em}
section{break-inside:avoid}
h2{break-after:avoid;margin:0 0 2mm}
img{max-height:255mm;border:0;margin:0}
}
</style></head>
<body><h1>%(name)s</h1><nav>%(links)s</nav><pre>%(scores)s</pre>
%(pictures)s
</body></html>
"""


def pictures_of(run, plan, string, units=SI):
    """Names, titles and figures; what the run does not hold is not there."""
    drawn = [("time_log", "Time log", plot_logs.time_log(run, units)), ("depth_log", "Depth log", plot_logs.depth_log(run, units)),
             ("well", "Well", plot_well.path(run, plan, units)), ("toolface", "Toolface", plot_well.toolface_dial(run))]
    if string is not None:
        drawn.append(("string", "String", plot_well.string_log(plot_well.read_string(string), os.path.basename(string), units)))
    return [picture for picture in drawn if picture[2] is not None]


def write(pictures, folder, run, scores, units=SI):
    """PNG, SVG and the page; returns the page's path."""
    os.makedirs(folder, exist_ok=True)
    parts = []
    for name, title, figure in pictures:
        for kind in ("png", "svg"):
            figure.savefig(os.path.join(folder, "%s.%s" % (name, kind)), dpi=100)
        plt.close(figure)
        with open(os.path.join(folder, name + ".png"), "rb") as png:
            data = base64.b64encode(png.read()).decode("ascii")
        parts.append('<section><h2 id="%s">%s</h2>\n<img alt="%s" src="data:image/png;base64,%s"></section>' % (name, title, title, data))
    page = os.path.join(folder, "index.html")
    with open(page, "w", encoding="utf-8") as out:
        out.write(PAGE % {"name": html.escape(run.title), "links": "".join('<a href="#%s">%s</a>' % (name, title) for name, title, _ in pictures),
                          "scores": html.escape("\n".join(table(scores, units))), "pictures": "\n".join(parts)})
    return page


def write_web_page(run, plan, options, folder, units):
    """The page of drill web with the run inside, where Chart.js is installed."""
    if not has_chart_library():
        return
    try:
        source = BagSource(run.name, options.namespace) if run.name.endswith(".bag") else SeriesSource(run, plan)
    except RunError as problem:
        report(["%s is left out: %s" % (WEB_PAGE, problem)])
        return
    with open(os.path.join(folder, WEB_PAGE), "w", encoding="utf-8") as out:
        out.write(page_of(source, units.system, options.scene))


def main(words):
    parser = argparse.ArgumentParser(prog="drill plot", description=__doc__)
    parser.add_argument("run")
    for name in ("--out", "--plan", "--columns", "--namespace", "--string", "--scene"):
        parser.add_argument(name)
    parser.add_argument("--pass-over", action="store_true")
    parser.add_argument("--units", choices=SYSTEMS, default="si")
    options = parser.parse_args(words)
    units = Units(options.units)
    folder = options.out or os.path.splitext(options.run)[0] + "_plots"
    try:
        run = read_run(options.run, options.namespace)
        plan = read_survey(options.plan, options.columns or "", options.pass_over, plan=True) if options.plan else None
        page = write(pictures_of(run, plan, options.string, units), folder, run, score(run, plan), units)
        write_web_page(run, plan, options, folder, units)
    except (RunError, SurveyError, plot_well.StringError) as error:
        print("drill plot: %s" % error, file=sys.stderr)
        return BAD_INPUT
    except OSError as error:
        print("drill plot: %s: %s" % (error.filename, error.strerror), file=sys.stderr)
        return FAILED
    print(page)
    return GOOD


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
