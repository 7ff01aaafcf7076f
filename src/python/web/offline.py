# SPDX-License-Identifier: BSD-3-Clause
"""The page with a run's data inside, as one file that needs no server: modules, styles and Chart.js stand in it."""
import json
import os
import re

import yaml
from drill_rig_sim.score_runs import RunError
from drill_rig_sim.web.broomstick import points, ways_of
from drill_rig_sim.web.chart_library import chart_library
from drill_rig_sim.web.feed import Feed

FOLDER = os.path.join(os.path.dirname(os.path.abspath(__file__)), "page")
RUN = '<script type="application/json" id="run">%s</script>\n<script type="module">\n%s</script>'
IMPORT = re.compile(r'^import (\{[^}]*\}) from "\./([\w.]+)";\n', re.MULTILINE)
EXPORT = re.compile(r"^export (?=(?:async )?function|const|class)", re.MULTILINE)
EXPORTED = re.compile(r"^export (?:async )?(?:function|const|class) (\w+)", re.MULTILINE)


def read(name):
    with open(os.path.join(FOLDER, name), encoding="utf-8") as text:
        return text.read()


def in_order(name, found=None):
    """A module and what it imports, each after what it needs itself."""
    found = [] if found is None else found
    for _, other in IMPORT.findall(read(name)):
        if other not in found:
            in_order(other, found)
    found.append(name)
    return found


def wrapped(name):
    """A module as a function of its own that hands out what it exports."""
    text = read(name)
    body = EXPORT.sub("", IMPORT.sub(r'const \1 = modules["\2"];' + "\n", text))
    return 'modules["%s"] = (() => {\n%s\nreturn { %s };\n})();\n' % (name, body, ", ".join(EXPORTED.findall(text)))


def script():
    return "const modules = {};\n" + "\n".join(wrapped(name) for name in in_order("main.js"))


def no_end(text, tag):
    """A text that cannot end the element in which it stands."""
    return re.sub("</(?=%s)" % tag, r"<\\/", text, flags=re.IGNORECASE)


def page_of(source, units, scene=None):
    """HTML of the page about all that a source has; `units`: a system of drill_rig_sim.units; `scene`: file for the broomstick chart and the specific energy."""
    feed, tree = Feed(source, False, units), tree_of(scene) if scene else None
    if tree:
        feed.log.bit_diameter = tree["string"][0]["diameter"]
    state = feed.take()[-1]
    theory = [broomstick_of(tree, float(feed.log.last["hole_depth"]), ways_of(feed.log.weights.find()))] if tree else []
    return html_of([*feed.whole(), *theory, state])


def tree_of(file):
    """A scene in SI units; RunError where it cannot be read."""
    try:
        from drill_rig_sim.lockstep import Refused
        from drill_rig_sim.sim import plain_scene
    except ImportError:
        raise RunError("--scene needs the Python module drill_rig_sim.sim, which is not built") from None
    try:
        return yaml.safe_load(plain_scene(file))
    except (Refused, ValueError) as problem:
        raise RunError(str(problem).splitlines()[0]) from None


def broomstick_of(scene, depth, ways):
    """The message of the broomstick chart that is computed."""
    computed = list(points(scene, depth, ways))
    return {"type": "broomstick", "points": computed, "ways": ways, "count": len(computed), "done": True, "running": False, "problem": ""}


def html_of(messages):
    with open(chart_library(), encoding="utf-8") as library:
        chart = library.read()
    parts = {'<link rel="stylesheet" href="style.css">': "<style>\n%s</style>" % read("style.css"),
             '<link rel="stylesheet" href="layout.css">': "<style>\n%s</style>" % read("layout.css"),
             '<script src="chart.js"></script>': "<script>%s</script>" % no_end(chart, "script"),
             '<script type="module" src="main.js"></script>': RUN % (no_end(json.dumps(messages), "script").replace("<!--", "<\\u0021--"),
                                                                     no_end(script(), "script"))}
    html = read("index.html")
    for element, inside in parts.items():
        if element not in html:
            raise AssertionError("index.html has no %s" % element)
        html = html.replace(element, inside)
    return html
