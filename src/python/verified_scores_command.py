# SPDX-License-Identifier: BSD-3-Clause
"""What `drill verify --score` starts: the scores of a run and of two finer models of it, and how far the run's are off the finest's. The runner has checked the
command line."""
import argparse
import sys

from drill_rig_sim.json_file import write_json
from drill_rig_sim.refusal import Refusal
from drill_rig_sim.score import read_run
from drill_rig_sim.score_command import BAD_INPUT, GOOD, TABLE, add_judging, plan_of, scores_of
from drill_rig_sim.units import SI, Units


def parse(words):
    parser = argparse.ArgumentParser(prog="drill verify --score", description=__doc__)
    parser.add_argument("runs", nargs=3)
    add_judging(parser)
    return parser.parse_args(words)


def rows_of(scores):
    """Of each score that all of the runs have: its row of TABLE and its numbers."""
    for row in TABLE:
        values = [(one[row[0]] or {}).get(row[1]) for one in scores]
        if None not in values:
            yield row, values


def off(values, quantity):
    """Of the first number from the last: an angle the shorter way round."""
    difference = values[0] - values[-1]
    return (difference + 180.0) % 360.0 - 180.0 if quantity == "angle" else difference


def table(scores, units=SI):
    """Lines."""
    lines = ["%-32s %12s %12s %12s %12s" % ("score", "run", "finer", "finest", "off")]
    for (_, _, meaning, quantity, factor, decimals), values in rows_of(scores):
        unit = units[quantity]
        digits = decimals if units.system == "si" else unit.digits
        shown = ["%12.*f" % (digits, factor * value * unit.per_si) for value in values] + ["%12.3g" % (factor * off(values, quantity) * unit.per_si)]
        lines.append(("%-32s %s %s" % (meaning, " ".join(shown), unit.name)).rstrip())
    return lines + ["left out: " + reason for reason in scores[0]["left_out"]]


def differences(scores):
    """By section and name, the run's from the finest's."""
    found = {}
    for (section, name, _, quantity, _, _), values in rows_of(scores):
        found.setdefault(section, {})[name] = off(values, quantity)
    return found


def compare(args):
    plan = plan_of(args)
    scores = [scores_of(read_run(run), plan, args) for run in args.runs]
    if args.json:
        write_json({**dict(zip(("run", "finer", "finest"), scores)), "off": differences(scores)}, args.json)
    print("\n".join(table(scores, Units(args.units))))


def main(words):
    try:
        compare(parse(words))
        return GOOD
    except Refusal as error:
        print("drill verify: %s" % error, file=sys.stderr)
    except OSError as error:
        print("drill verify: %s: %s" % (error.filename, error.strerror), file=sys.stderr)
    return BAD_INPUT


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
