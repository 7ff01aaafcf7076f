# SPDX-License-Identifier: BSD-3-Clause
"""Where Chart.js is: Debian's libjs-chart.js, never a copy in this package."""
import os

from drill_rig_sim.refusal import Refusal

FILES = ("/usr/share/javascript/chart.js/chart.min.js", "/usr/share/javascript/chart.js/Chart.min.js")
VARIABLE = "DRILL_RIG_SIM_CHART_JS"  # another file, of Chart.js 3


class NoLibrary(Refusal):
    """Chart.js is not installed."""


def found():
    """Its file; None where it is not installed."""
    return next((file for file in (os.environ.get(VARIABLE), *FILES) if file and os.path.isfile(file)), None)


def has_chart_library():
    return found() is not None


def chart_library():
    """Its file. NoLibrary where it is not installed."""
    file = found()
    if file is None:
        raise NoLibrary("charts need Debian's libjs-chart.js (or %s=FILE of Chart.js 3)" % VARIABLE)
    return file
