# SPDX-License-Identifier: BSD-3-Clause
"""What `drill calibrate` starts: fits parameters of a scene to a record or a table of weights, and says how sure they are and what a part of the data that
the fit never saw says; or predicts another record or table with what an earlier fit found. The runner has checked the command line."""
import argparse
import math
import os
import sys

import numpy
from drill_rig_sim.calibrate_prediction import UNITS, draw, lines, remarks
from drill_rig_sim.field.fit import FitError, Problem, fit
from drill_rig_sim.field.fit_plan import ModelError, PlanError, RecordError, read_fit
from drill_rig_sim.field.fitted import Fitted, parameter_as_json, read_fitted
from drill_rig_sim.field.models import Evaluator, RecordModel, TableModel
from drill_rig_sim.field.prediction import Prediction
from drill_rig_sim.field.progress import Pace
from drill_rig_sim.json_file import write_json
from drill_rig_sim.lockstep import Refused
from drill_rig_sim.refusal import refusal_lines
from drill_rig_sim.score_command import BAD_INPUT, FAILED, GOOD

BEYOND = 3.0  # of a record's noise, so much is more than noise
ONE_SIDED = 0.01  # of the string's weights, by which all of them may be off to one side
STRING_WEIGHTS = {"pick_up": "up", "slack_off": "down", "rotating": "around", "rotating_after_up": "around", "rotating_after_down": "around"}
FEWEST_WEIGHTS = 3
SI_UNITS = {"hook_load": "N", "torque": "N m", "stand_pipe_pressure": "Pa"}


def residuals(plan, found):
    """Root mean square of what is off, by signal: of the fitted part, and of what was held out (None where that is nothing)."""
    off, answered = found.predicted - plan.model.observed, {}
    for signal in sorted(set(plan.model.signals)):
        rows = (plan.model.signals == signal) & numpy.isfinite(off)
        answered[signal] = [float(numpy.sqrt(numpy.mean(off[part]**2))) if part.any() else None for part in (rows & plan.fitted, rows & plan.held_out)]
    return answered


def table(plan, found, left, why=lambda values, number: ""):
    lines = ["%-28s %14s %14s" % ("parameter", "value", "95 % within")]
    lines += ["%-28s %14.6g %14s" % (named(p), value, "+- " + three_digits(width) if numpy.isfinite(width) else "unknown")
              for p, value, width in zip(plan.parameters, found.values, found.half_widths)]
    lines += ["", "%-28s %14s %14s %14s" % ("off, root mean square", "fitted", "held out", "noise")]
    for signal, numbers in left.items():
        factor, unit = UNITS[signal]
        lines.append("%-28s %14s %14s %14s" % ("%s [%s]" % (signal, unit), *("-" if number is None else "%.4g" % (factor * number) for number in (*numbers, plan.model.noise.get(signal)))))
    idle = found.without_effect
    lines += ["%s: has no effect on these data at its start value: not changed" % name for name in idle]
    lines += ["%s: these data do not determine it" % p.name for p, width in zip(plan.parameters, found.half_widths) if not width < told_by(p) and p.name not in idle]
    lines += unexplained(plan, left)
    return lines + one_sided(plan, found) + not_predicted(plan, found, why) + ["", "%d points of the parameters were tried" % found.runs]


def not_predicted(plan, found, why):
    """A line on numbers without a prediction, with the first and its reason: `why(values, number)`."""
    lost = numpy.flatnonzero(~numpy.isfinite(found.predicted) & numpy.isfinite(plan.model.observed))
    if not len(lost):
        return []
    inner = [value for value, parameter in zip(found.values, plan.parameters) if parameter.signal is None]
    axis, places = plan.model.axis
    unit = "s" if axis == "time" else "m"
    return ["%d numbers could not be predicted (first: %s at %.2f %s): %s" % (len(lost), plan.model.groups[lost[0]], places[lost[0]], unit, why(inner, lost[0]))]


def one_sided(plan, found):
    """A line where all weights of the string in a table are off to the same side: no friction does that, for it raises some and lowers others."""
    observed, off = plan.model.observed, plan.model.observed - found.predicted
    of_string = plan.fitted & numpy.isfinite(off) & numpy.isin(plan.model.groups, list(STRING_WEIGHTS))
    if of_string.sum() < FEWEST_WEIGHTS or len({STRING_WEIGHTS[group] for group in plan.model.groups[of_string]}) < 2:
        return []
    off, share = off[of_string], abs(off[of_string].mean()) / observed[of_string].mean()
    if share < ONE_SIDED or numpy.unique(numpy.sign(off)).size > 1:
        return []
    return ["all %d weights of the string are %s than predicted, by %.1f kN in the mean: no friction explains that; are linear_mass (with tool joints), mud.density and the weight of the block right?" %
            (len(off), "larger" if off[0] > 0.0 else "smaller", 1e-3 * abs(off.mean()))]


def named(parameter):
    """With the unit of an offset; a key of the scene has the scene's."""
    return "%s [%s]" % (parameter.name, SI_UNITS[parameter.signal]) if parameter.signal else parameter.name


def three_digits(size):
    """Without an exponent, unless it needs one."""
    return "%.7g" % float("%.3g" % size)


def unexplained(plan, left):
    """Lines on signals of a record that are off by more than they vary, and not by their noise."""
    lines = []
    for signal, noise in plan.model.noise.items():
        (factor, unit), off = UNITS[signal], left[signal][0]
        varies = float(numpy.nanstd(plan.model.observed[(plan.model.signals == signal) & plan.fitted])) if off is not None else 0.0
        if off is not None and off > max(varies, BEYOND * noise):
            lines.append("%s: the error of the fit is larger than the variation in the record (%.4g %s): the scene does not reproduce the record, and the confidence bands are not reliable" %
                         (signal, factor * varies, unit))
    return lines


def told_by(parameter):
    """Half the width of its bounds: a parameter that is no surer than that is not determined by the data."""
    return 0.5 * (parameter.high - parameter.low)


class Progress(Pace):
    """A line each ten seconds: a long record takes minutes."""

    def __init__(self):
        super().__init__()
        self.expected = 0

    def expect(self, _, points):
        self.expected = points

    def __call__(self, points):
        times = self.due(points, self.expected)
        if times:
            print("drill calibrate: %.3g of about %d points tried, %s" % (points, max(self.expected, points), times), file=sys.stderr, flush=True)


def as_json(plan, found, left):
    return {
        "parameters": [{**parameter_as_json(p, value), "half_width_95": width, "without_effect": p.name in found.without_effect}
                       for p, value, width in zip(plan.parameters, found.values, found.half_widths)],
        "covariance": found.covariance.tolist(), "student": found.student, "rms": {signal: {"fitted": numbers[0], "held_out": numbers[1]} for signal, numbers in left.items()},
        "points": found.runs, "residuals": residuals_by_group(plan, found)}


def residuals_by_group(plan, found):
    """Of each signal, or each motion of a table: recorded less predicted [SI], over time in the record [s] or depth [m]; and which rows were fitted."""
    groups, (axis, places) = plan.model.groups, plan.model.axis
    off = plan.model.observed - found.predicted
    return {str(group): {axis: places[groups == group].tolist(), "recorded": plan.model.observed[groups == group].tolist(), "residual": off[groups == group].tolist(),
                         "fitted": (plan.fitted & numpy.isfinite(off))[groups == group].tolist()} for group in dict.fromkeys(groups)}


def fit_and_tell(options, plan, problem, why):
    """A fit to the plan's data; `why(values)`: why nothing can be predicted there."""
    try:
        found = fit(problem)
    except FitError as error:
        raise FitError("%s: %s" % (error, why(problem.starts())))
    left = residuals(plan, found)
    if options.json:
        write_json(as_json(plan, found, left), options.json)
    if options.plots:
        scatter = {signal: math.inf if numbers[0] is None else numbers[0] for signal, numbers in left.items()}
        draw(Prediction(plan.model, problem, Fitted(plan.parameters, found.covariance, found.student, scatter), found.values), options.plots, os.path.basename(options.fit))
    print("\n".join(table(plan, found, left, why)))


def apply_and_tell(options, plan, problem, fitted, why):
    """What an earlier fit predicts of the plan's data."""
    unknown = [str(signal) for signal in dict.fromkeys(plan.model.signals) if str(signal) not in fitted.scatter]
    if unknown:
        raise PlanError("%s: %s: the fit had no such data, allowed: %s" % (options.apply, ", ".join(unknown), ", ".join(fitted.scatter)))
    problem.expect(1 + len(problem.moved))
    if not numpy.isfinite(problem.predict(fitted.values)).any():
        raise FitError("nothing can be predicted: %s" % why(problem.starts()))
    prediction = Prediction(plan.model, problem, fitted, fitted.values)
    if options.json:
        write_json(prediction.as_json(), options.json)
    if options.plots:
        draw(prediction, options.plots, "%s by %s" % (os.path.basename(options.fit), os.path.basename(options.apply)))
    print("\n".join(lines(prediction)), end="")
    print("".join("drill calibrate: %s\n" % line for line in remarks(prediction)), end="", file=sys.stderr)


def calibrate(options):
    fitted = read_fitted(options.apply) if options.apply else None
    plan = read_fit(options.fit, fitted)
    said = plan.scene_remarks + plan.model.remarks
    if isinstance(plan.model, TableModel):
        said += plan.model.drag_remarks([parameter.start for parameter in plan.parameters if parameter.signal is None])
    print("".join("drill calibrate: %s\n" % line for line in said), end="", file=sys.stderr)
    progress = Progress()
    evaluator = Evaluator(plan.model, options.workers, options.scheduler, progress)
    problem = Problem(plan.parameters, evaluator, plan.model.observed, plan.model.signals, plan.fitted, progress.expect,
                      evaluator.replicas if isinstance(plan.model, RecordModel) else None, plan.model.kinds, plan.model.errors)
    try:
        if fitted:
            apply_and_tell(options, plan, problem, fitted, evaluator.why)
        else:
            fit_and_tell(options, plan, problem, evaluator.why)
    finally:
        evaluator.close()


def main(words):
    parser = argparse.ArgumentParser(prog="drill calibrate", description=__doc__)
    parser.add_argument("fit")
    for name in ("--apply", "--json", "--plots", "--scheduler"):
        parser.add_argument(name)
    parser.add_argument("--workers", type=int)
    try:
        calibrate(parser.parse_args(words))
        return GOOD
    except ImportError as error:
        print("drill calibrate: %s; needed: Debian's python3-scipy for a fit, python3-matplotlib for --plots, python3-distributed for --scheduler" % error, file=sys.stderr)
        return FAILED
    except (PlanError, RecordError, ModelError, FitError, Refused) as error:
        print(refusal_lines("drill calibrate", error), file=sys.stderr)
        return BAD_INPUT
    except OSError as error:
        print("drill calibrate: %s: %s" % (error.filename, error.strerror), file=sys.stderr)
        return BAD_INPUT


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
