# SPDX-License-Identifier: BSD-3-Clause
"""What a fit found, as a file: drill calibrate --json writes it, and --apply plays it to another record, table or well."""
import json
import math

import numpy
from drill_rig_sim.campaign.plan_text import PlanError
from drill_rig_sim.field.fit import Parameter
from drill_rig_sim.text_file import TextError, read_text


class Fitted:
    """`parameters`, whose starts are the values found; `covariance` and `student` as of a Fit; `scatter` by signal [SI],
    infinite of one that was wholly held out."""

    def __init__(self, parameters, covariance, student, scatter):
        self.parameters, self.covariance, self.student, self.scatter = parameters, covariance, student, scatter

    @property
    def values(self):
        return numpy.array([parameter.start for parameter in self.parameters])


def parameter_as_json(parameter, value):
    return {"name": parameter.name, "value": value, "keys": parameter.keys, "times": parameter.times, "signal": parameter.signal, "from": parameter.low, "to": parameter.high}


def read_fitted(file):
    """A Fitted; PlanError where the file is none."""
    try:
        tree = json.loads(read_text(file))
    except TextError as error:
        raise PlanError(str(error))
    except (ValueError, RecursionError) as error:
        raise PlanError("%s: is not valid JSON: %s" % (file, " ".join(str(error).split())))
    try:
        return fitted_of(tree)
    except (KeyError, TypeError, ValueError, AttributeError) as error:
        raise PlanError("%s: is not what drill calibrate --json of this version writes (%s: %s)" % (file, type(error).__name__, " ".join(str(error).split())))


def fitted_of(tree):
    """Of the file's tree; KeyError, TypeError or ValueError where that is another one."""
    parameters = [parameter_of(item) for item in tree["parameters"]]
    covariance = numpy.array([[number(cell, math.inf) for cell in row] for row in tree["covariance"]])
    if not parameters or covariance.shape != (len(parameters), len(parameters)):
        raise ValueError("covariance must have a row and a column for each of %d parameters" % len(parameters))
    scatter = {str(signal): number(entry["fitted"], math.inf) for signal, entry in tree["rms"].items()}
    return Fitted(parameters, covariance, number(tree["student"]), scatter)


def parameter_of(item):
    keys = list(map(str, item["keys"]))
    if bool(keys) == (item["signal"] is not None):
        raise ValueError("parameter %s must have keys or a signal" % item["name"])
    return Parameter(str(item["name"]), number(item["value"]), number(item["from"], -math.inf), number(item["to"], math.inf), keys, bool(item["times"]), item["signal"])


def number(value, otherwise=None):
    """A finite number; `otherwise` where the file has null."""
    if value is None and otherwise is not None:
        return otherwise
    if isinstance(value, bool) or not math.isfinite(float(value)):
        raise ValueError("%s is not a number" % value)
    return float(value)
