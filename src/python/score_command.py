# SPDX-License-Identifier: BSD-3-Clause
"""What `drill score` starts: the scores as a table, as JSON, and as a page of plots. The runner has checked the command line."""
import argparse
import math
import os
import sys

from drill_rig_sim.json_file import write_json
from drill_rig_sim.score import read_run, read_survey, score
from drill_rig_sim.score_runs import RunError
from drill_rig_sim.survey import SurveyError
from drill_rig_sim.units import DEGREE, SI, SYSTEMS, Units

GOOD, BAD_INPUT, FAILED = 0, 2, 3

PER_HOUR = 1.0 / 3600.0
# section, score, what the table calls it, quantity, factor to SI, decimals in SI
TABLE = (
    ("drilling", "duration_s", "run", "time", 1.0, 1),
    ("drilling", "on_bottom_s", "on bottom", "time", 1.0, 1),
    ("drilling", "drilled_m", "drilled", "length", 1.0, 3),
    ("drilling", "rop_on_bottom_m_h", "rate of penetration on bottom", "penetration", PER_HOUR, 2),
    ("drilling", "rop_m_h", "rate of penetration of the run", "penetration", PER_HOUR, 2),
    ("wob", "mean", "weight on bit, mean", "force", 1.0, 2),
    ("wob", "deviation", "weight on bit, deviation", "force", 1.0, 2),
    ("wob", "largest", "weight on bit, largest", "force", 1.0, 2),
    ("wob", "share_in_band", "weight on bit within its band", "share", 1.0, 1),
    ("toolface", "sliding_s", "sliding", "time", 1.0, 1),
    ("toolface", "mean_deg", "toolface, mean", "angle", DEGREE, 1),
    ("toolface", "deviation_deg", "toolface, deviation", "angle", DEGREE, 1),
    ("toolface", "share_in_band", "toolface within its band", "share", 1.0, 1),
    ("stick_slip", "mean", "stick-slip index, mean", "number", 1.0, 2),
    ("stick_slip", "largest", "stick-slip index, largest", "number", 1.0, 2),
    ("stick_slip", "share_at_1", "windows in full stick-slip", "share", 1.0, 1),
    ("energy", "mse_mpa", "mechanical specific energy", "specific_energy", 1e6, 1),
    ("connections", "number", "connections", "count", 1.0, 0),
    ("connections", "in_slips_s", "in slips, mean", "time", 1.0, 1),
    ("connections", "weight_to_weight_s", "weight to weight, mean", "time", 1.0, 1),
    ("stalls", "number", "stalls of the motor", "count", 1.0, 0),
    ("stalls", "s", "stalled", "time", 1.0, 1),
    ("path", "dogleg_mean_deg_30m", "dogleg, mean", "dogleg", DEGREE / 30.0, 2),
    ("path", "dogleg_largest_deg_30m", "dogleg, largest", "dogleg", DEGREE / 30.0, 2),
    ("path", "tortuosity_deg_30m", "tortuosity beyond the plan's", "dogleg", DEGREE / 30.0, 2),
    ("path", "distance_mean_m", "distance to plan, mean", "length", 1.0, 2),
    ("path", "distance_largest_m", "distance to plan, largest", "length", 1.0, 2),
    ("path", "distance_end_m", "distance to plan, at the end", "length", 1.0, 2))


def table(scores, units=SI):
    """Lines of what was determined, with the difference to the companion's where there is one, and of what was left out and why."""
    lines = ["%s, by its %s%s" % (scores["run"], scores["source"], ", +- the difference to its companion" if scores["companion"] else "")]
    for section, name, meaning, quantity, factor, decimals in TABLE:
        value, off, unit = score_in(scores, section, name), off_companion(scores, section, name, quantity), units[quantity]
        if value is not None:
            digits, factor = decimals if units.system == "si" else unit.digits, factor * unit.per_si
            beside = "" if off is None else " +- %.*f" % (digits, factor * off)
            lines.append("%-32s %12.*f%s %s" % (meaning, digits, factor * value, beside, unit.name))
    for flag, found in scores["limits"].items():
        other = score_in(scores["companion"], "limits", flag) if flag != "accuracy_warning" else None  # the companion's is of its own numerics
        beside = " (companion: %d times, %.1f s)" % (other["number"], other["s"]) if other else ""
        if found["number"]:
            lines.append("%-32s %12d times, %.1f s%s" % (flag, found["number"], found["s"], beside))
    return [line.rstrip() for line in lines] + ["left out: " + reason for reason in scores["left_out"]]


def score_in(scores, section, name):
    """None where it is not determined."""
    return ((scores or {}).get(section) or {}).get(name)


def off_companion(scores, section, name, quantity):
    """How far a score is from the companion's, in the score's unit; None where one of them is not determined."""
    value, other = score_in(scores, section, name), score_in(scores["companion"], section, name)
    if value is None or other is None:
        return None
    off = abs(value - other)
    return min(off, 360.0 - off) if quantity == "angle" else off


def parse(words):
    parser = argparse.ArgumentParser(prog="drill score", description=__doc__)
    parser.add_argument("run")
    for name in ("--namespace", "--plots"):
        parser.add_argument(name)
    add_judging(parser)
    return parser.parse_args(words)


def add_judging(parser):
    """What runs are judged by, the scores' file and their units."""
    for name in ("--plan", "--columns", "--json"):
        parser.add_argument(name)
    for name in ("--bit-diameter", "--wob", "--wob-band", "--toolface", "--toolface-band"):
        parser.add_argument(name, type=float)
    parser.add_argument("--pass-over", action="store_true")
    parser.add_argument("--units", choices=SYSTEMS, default="si")


def require_files_apart(args):
    """No output is an input or the other output."""
    files = [("the run", args.run), ("the plan", args.plan), ("--columns", args.columns), ("--json", args.json), ("--plots", args.plots)]
    for i, (option, file) in enumerate(files[3:], 3):
        for what, other in files[:i]:
            if file and other and os.path.realpath(file) == os.path.realpath(other) != "/dev/null":
                raise RunError("%s: %s is the file of %s, needed: another file" % (option, file, what))


def radians(angle):
    return None if angle is None else math.radians(angle)


def plan_of(args):
    """Of the options of add_judging()."""
    return read_survey(args.plan, args.columns or "", args.pass_over, plan=True) if args.plan else None


def scores_of(run, plan, args):
    """By the options of add_judging()."""
    return score(run, plan, args.bit_diameter, args.wob, args.wob_band, radians(args.toolface), radians(args.toolface_band))


def judge(args):
    require_files_apart(args)
    units = Units(args.units)
    run = read_run(args.run, args.namespace)
    plan = plan_of(args)
    scores = scores_of(run, plan, args)
    if args.json:
        write_json(scores, args.json)
    if args.plots:
        from drill_rig_sim import score_plots  # needs matplotlib
        score_plots.draw(run, scores, plan, args.bit_diameter, args.plots, units)
    print("\n".join(table(scores, units)))


def main(words):
    try:
        judge(parse(words))
        return GOOD
    except (RunError, SurveyError) as error:
        print("drill score: %s" % error, file=sys.stderr)
        return BAD_INPUT
    except OSError as error:
        print("drill score: %s: %s" % (error.filename, error.strerror), file=sys.stderr)
        return BAD_INPUT
    except ImportError as error:
        print("drill score: %s; plots need Debian's python3-matplotlib" % error, file=sys.stderr)
        return FAILED


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
