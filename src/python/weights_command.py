# SPDX-License-Identifier: BSD-3-Clause
"""What `drill weights` starts: finds the steady pick-up, slack-off and rotating moves of a time log and what the gauge shows of the empty block, as a table that
drill calibrate fits. The runner has checked the command line."""
import argparse
import csv
import sys

import numpy
from drill_rig_sim.field.moves import OFF_BOTTOM, moves_of
from drill_rig_sim.field.record import RecordError, read_record
from drill_rig_sim.field.window import between, inside, limits, stretches
from drill_rig_sim.json_file import write_json
from drill_rig_sim.refusal import Refusal, after, refusal_lines
from drill_rig_sim.score_command import BAD_INPUT, GOOD
from drill_rig_sim.units import SYSTEMS, Units

# of the table: column, motions whose load it holds
WEIGHTS = ("pick_up", "slack_off", "rotating_up", "rotating_down", "rotating_after_up", "rotating_after_down", "slips_up", "slips_down")
HEADER = ["motion", "begin (s)", "end (s)", "rows", "speed (m/s)", "rotation (rad/s)", "flow (m3/s)", "deviation (N)", "depth (m)", "block_height (m)", *("%s (N)" % name for name in WEIGHTS), "torque (N.m)"]


def rows_of(moves):
    """Of the table, in SI; "" where a move has no such number."""
    for move in moves:
        turned = move.motion.startswith("rotating")
        numbers = [move.from_time, move.to_time, move.count, move.speed, move.rotation, move.flow, move.deviation, move.depth, move.block_height,
                   *(move.load if move.motion == name else None for name in WEIGHTS), move.torque if turned else None]
        yield [move.motion] + ["" if number is None else "%.9g" % number for number in numbers]


def write_table(moves, file):
    with open(file, "w", encoding="utf-8", newline="") as out:
        writer = csv.writer(out, lineterminator="\n")
        writer.writerow(HEADER)
        writer.writerows(rows_of(moves))


def write_moves(moves, file):
    names = ("motion", "from_time", "to_time", "count", "depth", "block_height", "load", "deviation", "torque", "speed", "rotation", "flow")
    write_json([{name: getattr(move, name) for name in names} for move in moves], file)


def text(moves, units):
    force, torque, length, turning = (units[quantity] for quantity in ("force", "torque", "length", "rotation"))
    lines = ["%-20s %9s %9s %5s %12s %12s %12s %12s %9s" % ("motion", "begin s", "end s", "rows", "depth " + length.name, "load " + force.name, "deviation", "torque " + torque.name, turning.name)]
    for move in moves:
        lines.append("%-20s %9.1f %9.1f %5d %12.2f %12.2f %12.3f %12s %9s" % (
            move.motion, move.from_time, move.to_time, move.count, length.per_si * move.depth, force.per_si * move.load, force.per_si * move.deviation,
            "-" if move.torque is None else "%.3f" % (torque.per_si * move.torque), "-" if move.rotation is None else "%.1f" % (turning.per_si * move.rotation)))
    return lines


def remarks_on(record, moves, odd):
    """What its reader should know, a line each. `odd`: on moves that are left out."""
    lines = record.remarks + odd
    if "hole_depth" not in record:
        lines.append("%s: has no hole_depth: the bit counts as off bottom where it is %g m or more above its deepest position so far" % (record.name, OFF_BOTTOM))
    if "top_drive_speed" not in record:
        lines.append("%s: has no top_drive_speed: the string counts as not turned, and moves with rotation are among pick_up and slack_off" % record.name)
    pumped = [move for move in moves if move.pumped]
    if pumped:
        lines.append("%s: the pump ran in %d of %d moves; drill calibrate adds what the flow lifts by the scene's mud: compare with --no-flow" % (record.name, len(pumped), len(moves)))
    if not any(move.empty for move in moves):
        lines.append("%s: the block never moves with the string in the slips: the weight of the empty block is not known" % record.name)
    return lines


def not_measured(record):
    """How many rows hold no measurement of what the moves are found by."""
    missing = [(name, int(numpy.isnan(record.signals[name]).sum())) for name in ("hook_load", "block_height", "bit_depth", "top_drive_speed") if name in record]
    return ["%d of %d rows hold no %s" % (count, len(record.time), name) for name, count in missing if count]


def found_in(options):
    """(record, its moves, lines on what is no move) by the command line."""
    record = read_record([options.record, *options.more], options.columns)
    with after(lambda: record.noticed):
        left_out = stretches(options.leave_out, record)
        record = between(record, *limits(record, options.from_time, options.to_time))
        moves, odd = moves_of(record, inside(record.signals["time"], left_out))
    return record, [move for move in moves if not (options.no_flow and move.pumped)], odd


def main(words):
    parser = argparse.ArgumentParser(prog="drill weights", description=__doc__)
    parser.add_argument("record")
    for name in ("--columns", "--csv", "--json"):
        parser.add_argument(name)
    parser.add_argument("--with", dest="more", action="append", default=[])
    parser.add_argument("--from", dest="from_time", default="")
    parser.add_argument("--to", dest="to_time", default="")
    parser.add_argument("--leave-out", action="append", default=[])
    parser.add_argument("--no-flow", action="store_true")
    parser.add_argument("--units", choices=SYSTEMS, default="si")
    options = parser.parse_args(words)
    try:
        record, moves, odd = found_in(options)
        if not moves:
            with after(lambda: record.noticed):
                raise RecordError("%s: holds no steady pick-up, slack-off or rotating off bottom%s" % (record.name, "".join("; " + line for line in not_measured(record) + odd)))
        for write, file in ((write_table, options.csv), (write_moves, options.json)):
            if file:
                write(moves, file)
        print("\n".join(text(moves, Units(options.units))))
        print("".join("drill weights: %s\n" % line for line in remarks_on(record, moves, odd)), end="", file=sys.stderr)
        return GOOD
    except Refusal as error:
        print(refusal_lines("drill weights", error), file=sys.stderr)
        return BAD_INPUT
    except OSError as error:
        print("drill weights: %s: %s" % (error.filename, error.strerror), file=sys.stderr)
        return BAD_INPUT


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
