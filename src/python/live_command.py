# SPDX-License-Identifier: BSD-3-Clause
"""What `drill live` starts: a rig's feed drives a simulation; how far that is off is printed and published. The runner has checked the command line."""
import argparse
import contextlib
import os
import re
import sys
from signal import SIGINT
from signal import signal as handle

import numpy
from drill_rig_sim.field.bag_feed import bag_rows
from drill_rig_sim.field.live import FIRST, SHOWN, Live, Rows
from drill_rig_sim.field.models import ModelError, scene_and_survey
from drill_rig_sim.field.replay import beyond_limits, check, check_start, run_up
from drill_rig_sim.field.start import FROM, simulator_of, start_keys
from drill_rig_sim.field.table import RecordError
from drill_rig_sim.field.wits_feed import SYSTEMS as WITS_UNITS
from drill_rig_sim.field.wits_feed import wits_rows
from drill_rig_sim.lockstep import Failed, Refused
from drill_rig_sim.score_command import BAD_INPUT, FAILED, GOOD
from drill_rig_sim.sim import found
from drill_rig_sim.units import QUANTITIES, SYSTEMS, Units

NAMES = {"hook_load": "hook load", "torque": "torque", "stand_pipe_pressure": "stand pipe", "bit_depth": "bit depth"}
MOST_ALIKE = 5  # lines of one kind that are printed; the others are counted
ADDRESS = re.compile(r"([\w.-]+):(\d{1,5})")


class Reports:
    """Lines on the feed, to standard error as they come."""

    def __init__(self):
        self.kinds = {}

    def __call__(self, text):
        kind = self.kinds.setdefault(re.sub(r"'.*?'|[-0-9.]+", "", text), [0, text])
        kind[0] += 1
        if kind[0] <= MOST_ALIKE:
            print("drill live: %s" % text, file=sys.stderr, flush=True)

    def end(self):
        for count, text in self.kinds.values():
            if count > MOST_ALIKE:
                print("drill live: %d more like: %s" % (count - MOST_ALIKE, text), file=sys.stderr)


class Topics:
    """Residuals as std_msgs/Float64 [SI] on NAMESPACE/residual/SIGNAL, from the row on that has them."""

    def __init__(self, namespace):
        import rospy  # needed only for topics
        from std_msgs.msg import Float64
        rospy.init_node("drill_live", disable_signals=True)
        self.publishers = {signal: rospy.Publisher("%s/residual/%s" % (namespace, signal), Float64, queue_size=100) for signal in SHOWN}

    def __call__(self, signal, residual):
        self.publishers[signal].publish(residual)


class Shown:
    """Prints, publishes and writes rows, and keeps the residuals."""

    def __init__(self, units, publish, csv):
        self.units, self.publish, self.csv, self.residuals, self.names = units, publish, csv, {}, []

    def __call__(self, time, row):
        if not self.names:
            self.names = list(row)
            print("%8s %s  measured, measured minus simulated" % ("time [s]", " ".join("%24s" % self.units.label(NAMES[name], QUANTITIES[name]) for name in row)))
            if self.csv:
                self.csv.write(",".join(["time"] + ["%s_%s" % (side, name) for name in row for side in ("measured", "simulated")]) + "\n")
        cells, numbers = [], []
        for name in self.names:
            measured, simulated = row.get(name, (numpy.nan, numpy.nan))
            per_si, residual = self.units[QUANTITIES[name]].per_si, measured - simulated
            cells.append("%12.3f %11.3f" % (per_si * measured, per_si * residual) if residual == residual else "%24s" % "-")
            numbers += ["" if number != number else "%.9g" % number for number in (measured, simulated)]
            if residual == residual:
                self.residuals.setdefault(name, []).append(residual)
                self.publish(name, residual)
        print("%8.1f %s" % (time, " ".join(cells)), flush=True)
        if self.csv:
            self.csv.write(",".join(["%.9g" % time] + numbers) + "\n")
            self.csv.flush()

    def table(self):
        lines = ["%-12s %12s %12s %12s %8s  off: measured minus simulated" % ("", "mean off", "rms off", "largest off", "rows")]
        for name, values in self.residuals.items():
            unit, off = self.units[QUANTITIES[name]], numpy.array(values)
            lines.append("%-12s %s %8d %s" % (NAMES[name], " ".join("%12.3f" % (unit.per_si * number) for number in (
                off.mean(), numpy.sqrt((off**2).mean()), numpy.abs(off).max())), len(off), unit.name))
        return lines


def rows_of(options, say):
    """Rows of the feed, their time since its first one."""
    address = ADDRESS.fullmatch(options.feed)
    if address and not os.path.exists(options.feed):
        if int(address.group(2)) > 65535:
            raise RecordError("%s: the port must be at most 65535" % options.feed)
        rows = wits_rows(address.group(1), int(address.group(2)), options.wits_units, say)
    else:
        rows = bag_rows(options.feed, options.namespace, options.every, say)
    first = None
    for row in rows:
        first = row.time if first is None else first
        yield row._replace(time=row.time - first)


def first_rows(rows, name, say):
    """Rows enough to begin with."""
    kept = []
    for row in rows:
        if not all(row.values.get(signal, numpy.nan) == row.values.get(signal) for signal in ("block_height", "bit_depth")):
            say("%s is refused: has no block_height or no bit_depth" % row.place)
        elif kept and row.time <= kept[-1].time:
            say("%s is refused: its time is not after that of the row before" % row.place)
        else:
            kept.append(row)
            if len(kept) == FIRST:
                return kept
    raise RecordError("%s: ended after %d rows with block_height and bit_depth; needed: %d" % (name, len(kept), FIRST))


@contextlib.contextmanager
def uninterrupted():
    """Ctrl-C waits for the end of the block: a row that is half taken could not be played on."""
    asked = []
    before = handle(SIGINT, lambda *_: asked.append(True))
    try:
        yield
    finally:
        handle(SIGINT, before)
    if asked:
        raise KeyboardInterrupt


def follow(options, shown, say):
    """Until the feed ends, or is interrupted."""
    rows = rows_of(options, say)
    first = first_rows(rows, options.feed, say)
    record = Rows(options.feed, first, first[0].time)
    check(record)
    file = found(os.path.abspath(options.scene) if os.path.exists(options.scene) else options.scene, "config/scenes")
    scene, survey = scene_and_survey(file)
    values, lines = start_keys(scene, record, options.start)
    rig = simulator_of(file, scene, survey, values)
    for line in lines + check_start(record, rig) + beyond_limits(record, rig) + run_up(rig, record):
        say(line)
    live = Live(options.feed, rig, [row._replace(time=row.time - first[0].time) for row in first], say, shown)
    try:
        for row in rows:
            with uninterrupted():
                live.take(row._replace(time=row.time - first[0].time))
    except KeyboardInterrupt:
        pass
    live.finish()


def options_of(words):
    parser = argparse.ArgumentParser(prog="drill live", description=__doc__)
    parser.add_argument("feed")
    parser.add_argument("scene")
    parser.add_argument("--namespace")
    parser.add_argument("--every", type=float, default=1.0)
    parser.add_argument("--wits-units", choices=WITS_UNITS, default=WITS_UNITS[0])
    parser.add_argument("--start", choices=FROM, default="")
    parser.add_argument("--topics", default="")
    parser.add_argument("--csv", default="")
    parser.add_argument("--units", choices=SYSTEMS, default="si")
    return parser.parse_args(words)


def main(words):
    options, say = options_of(words), Reports()
    try:
        publish = Topics(options.topics) if options.topics else lambda signal, residual: None
        with open(options.csv or os.devnull, "w", encoding="utf-8") as csv:
            shown = Shown(Units(options.units), publish, csv if options.csv else None)
            follow(options, shown, say)
        print("\n".join(shown.table()))
        return GOOD
    except (RecordError, ModelError, Refused) as error:
        print("drill live: %s" % error, file=sys.stderr)
        return FAILED if isinstance(error, Failed) else BAD_INPUT
    except ImportError as error:
        print("drill live: %s; topics need Debian's python3-rospy" % error, file=sys.stderr)
        return FAILED
    except OSError as error:
        print("drill live: %s: %s" % (error.filename or options.feed, error.strerror or error), file=sys.stderr)
        return BAD_INPUT
    finally:
        say.end()


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
