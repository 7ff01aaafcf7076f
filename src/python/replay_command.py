# SPDX-License-Identifier: BSD-3-Clause
"""What `drill replay` starts: plays a record to a scene and says how far the simulated hook load, torque and pressure are off. The runner has checked the
command line."""
import argparse
import os
import sys

from drill_rig_sim.field.models import ModelError, scene_and_survey
from drill_rig_sim.field.progress import Pace
from drill_rig_sim.field.record import COMPARED, RecordError, read_record
from drill_rig_sim.field.replay import check, play
from drill_rig_sim.field.start import FROM, on_hook, simulator_of, start_keys
from drill_rig_sim.field.window import limits, stretches
from drill_rig_sim.json_file import write_json
from drill_rig_sim.lockstep import Failed, Refused
from drill_rig_sim.refusal import after, refusal_lines
from drill_rig_sim.score_command import BAD_INPUT, FAILED, GOOD
from drill_rig_sim.sim import found
from drill_rig_sim.units import QUANTITIES, SI, SYSTEMS, Units

NAMES = {"hook_load": "hook load", "torque": "torque", "stand_pipe_pressure": "stand pipe"}


class Progress(Pace):
    """A line each ten seconds on a terminal: a long record takes minutes."""

    def __call__(self, done, whole):
        times = self.due(done, whole)
        if times and sys.stderr.isatty():
            print("drill replay: %.0f of %.0f s played, %s" % (done, whole, times), file=sys.stderr, flush=True)


def table(replay, units=SI):
    lines = ["%-12s %12s %12s %12s %12s  off: recorded minus simulated" % ("", "mean off", "rms off", "largest off", "range")]
    for signal, numbers in replay.table().items():
        unit = units[QUANTITIES[signal]]
        lines.append("%-12s %s %s" % (NAMES[signal], " ".join("%12.3f" % (unit.per_si * numbers[key]) for key in ("mean", "rms", "largest", "range")), unit.name))
    load, unit = replay.table().get("hook_load"), units[QUANTITIES["hook_load"]]
    return lines + error_lines(replay) + (["hook load not determined by the record's sampling: %.3g %s rms, %.3g %s at most" %
                     (unit.per_si * load["unresolved_rms"], unit.name, unit.per_si * load["unresolved_largest"], unit.name)] if load else [])


def error_lines(replay):
    """What of it may be the simulation's own error, as drill run shows it."""
    if replay.errors.why_not:
        return ["error of the simulation not measured: %s" % replay.errors.why_not]
    measured = ["%s %.2g %%" % (NAMES[signal], 100.0 * replay.errors.largest[signal]) for signal in replay.recorded if signal in replay.errors.largest]
    return ["measured error of the simulation, largest of 3 s: %s of the range" % ", ".join(measured)] if measured else []


def draw(replay, file, units=SI):
    from drill_rig_sim.score_plots import plt, save  # needs matplotlib
    figure, axes = plt.subplots(2 * len(replay.recorded), sharex=True, figsize=(9.0, 3.6 * len(replay.recorded)), squeeze=False, constrained_layout=True)
    for place, signal in enumerate(replay.recorded):
        unit, factor, *_ = units[QUANTITIES[signal]]
        both, off = axes[2 * place, 0], axes[2 * place + 1, 0]
        both.plot(replay.time, factor * replay.recorded[signal], color="#555555", linewidth=0.9, label="recorded")
        both.plot(replay.time, factor * replay.simulated[signal], color="#1f5fa8", linewidth=0.9, label="simulated")
        both.set_ylabel("%s [%s]" % (NAMES[signal], unit))
        both.legend(fontsize=8)
        off.plot(replay.time, factor * replay.residual(signal), color="#c0392b", linewidth=0.8)
        off.axhline(0.0, color="#bbbbbb", linewidth=0.6)
        off.set_ylabel("off [%s]" % unit)
    axes[-1, 0].set_xlabel("time [s]")
    axes[0, 0].set_title(os.path.basename(replay.name), fontsize=10)
    save(figure, file)


def write(replay, file):
    with open(file, "w", encoding="utf-8") as out:
        out.write(",".join(["time"] + [side + "_" + signal for signal in replay.recorded for side in ("recorded", "simulated")]) + "\n")
        for k, time in enumerate(replay.time):
            cells = [numbers[signal][k] for signal in replay.recorded for numbers in (replay.recorded, replay.simulated)]
            out.write(",".join(["%.9g" % time] + ["" if cell != cell else "%.9g" % cell for cell in cells]) + "\n")


def replay_of(options):
    record = read_record([options.record, *options.more], options.columns)
    with after(lambda: record.noticed):
        return replay_of_record(record, options)


def replay_of_record(record, options):
    left_out = stretches(options.leave_out, record)
    record, remarks = on_hook(record, *limits(record, options.from_time, options.to_time))
    check(record)
    file = found(os.path.abspath(options.scene) if os.path.exists(options.scene) else options.scene, "config/scenes")
    scene, survey = scene_and_survey(file)
    values, lines = start_keys(scene, record, options.start)
    with after(lambda: remarks + lines):
        replay = play(simulator_of(file, scene, survey, values), record, left_out, Progress())
    if not replay.table():
        raise RecordError("%s: no row is left to compare; needed: shorter stretches in --leave-out, or %s with the string on the hook" % (record.name, ", ".join(COMPARED)))
    replay.remarks += remarks + lines
    return replay


def main(words):
    parser = argparse.ArgumentParser(prog="drill replay", description=__doc__)
    parser.add_argument("record")
    parser.add_argument("scene")
    for name in ("--columns", "--json", "--csv", "--plots"):
        parser.add_argument(name)
    parser.add_argument("--with", dest="more", action="append", default=[])
    parser.add_argument("--from", dest="from_time", default="")
    parser.add_argument("--to", dest="to_time", default="")
    parser.add_argument("--leave-out", action="append", default=[])
    parser.add_argument("--start", choices=FROM, default="")
    parser.add_argument("--units", choices=SYSTEMS, default="si")
    options = parser.parse_args(words)
    units = Units(options.units)
    try:
        replay = replay_of(options)
        if options.json:
            write_json(replay.table(), options.json)
        if options.csv:
            write(replay, options.csv)
        if options.plots:
            draw(replay, options.plots, units)
        print("\n".join(table(replay, units)))
        print("".join("drill replay: %s\n" % line for line in replay.remarks), end="", file=sys.stderr)
        return GOOD
    except (RecordError, ModelError, Refused) as error:
        print(refusal_lines("drill replay", error), file=sys.stderr)
        return FAILED if isinstance(error, Failed) else BAD_INPUT
    except OSError as error:
        print("drill replay: %s: %s" % (error.filename, error.strerror), file=sys.stderr)
        return BAD_INPUT


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
