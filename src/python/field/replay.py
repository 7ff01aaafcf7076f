# SPDX-License-Identifier: BSD-3-Clause
"""A record's block, rotary speed and flow, fed to a simulator; hook load, torque and pressure against what was recorded."""
import re

import numpy
from drill_rig_sim.control import driven
from drill_rig_sim.field.follow import PATIENCE, Follow
from drill_rig_sim.field.pipe import Slip, check_connections, check_directions, check_scale, clock, compared, pipe_events
from drill_rig_sim.field.record import COMPARED, RecordError, gaps_in
from drill_rig_sim.field.window import inside
from drill_rig_sim.law import RPM
from drill_rig_sim.refusal import after
from drill_rig_sim.units import GRAVITY, POUND, QUANTITIES, SI

FORCES = {"N": 1.0, "lbf": POUND, "kgf": GRAVITY}  # and their thousands, by which hook loads are mistaken
SHORTEST = 0.1  # of a record, some frames of the simulation [s]
LONGEST_GAP = 86400.0  # that can be simulated in a sensible time [s]
APART = 1.0    # of the bit at the beginning, record and scene [m]
RUN_UP = 30.0  # before the record, in which pump and top drive come to where it begins [s]
RUNS = 0.1, 1e-3  # rotary speed [rad/s] and flow [m3/s] from which on they run
ROUNDS = 0.02  # share by which a gauge may read beyond the rig's limit
NEAR, MOSTLY, LEAST_ROWS = 0.05, 0.8, 5  # of a ratio of units: share by which loads may be off it, share of rows that are not, rows that show it
RATIOS = {"of %s to %s" % (one, other): FORCES[one] / FORCES[other] for one in FORCES for other in FORCES if one != other}
BEHIND = 0.05  # of the drum against the record's, from which on it is reported [m]


class Replay:
    """`time` in the record's file [s] of its rows; `simulated` and `recorded`: arrays by signal, as the gauges show it. `remarks`: what its reader should know, a line each.
    `unresolved`: root mean square and largest of the hook load that the sampling leaves unknown [N]. `errors`: MeasuredErrors of the simulated run."""

    def __init__(self, name, time, simulated, recorded, remarks, unresolved, errors):
        self.name, self.time, self.simulated, self.recorded, self.remarks, self.unresolved = name, time, simulated, recorded, remarks, unresolved
        self.errors = errors

    def residual(self, signal):
        """Recorded less simulated; nan where nothing was recorded."""
        return self.recorded[signal] - self.simulated[signal]

    def table(self, begin=0.0, end=float("inf")):
        """Of each signal over the rows between two times: mean, root mean square and largest residual, and the recorded range."""
        found = {}
        for signal in self.recorded:
            rows = (self.time >= begin) & (self.time <= end) & numpy.isfinite(self.recorded[signal])
            if rows.any():
                off = self.residual(signal)[rows]
                found[signal] = {"mean": float(off.mean()), "rms": float(numpy.sqrt((off**2).mean())), "largest": float(numpy.abs(off).max()),
                                 "range": float(numpy.ptp(self.recorded[signal][rows])), "measured_error": self.errors.largest.get(signal)}
        if "hook_load" in found:
            found["hook_load"]["unresolved_rms"], found["hook_load"]["unresolved_largest"] = self.unresolved
        return found


class Warnings:
    """Accuracy warnings of a simulated run: of each kind the text that came first, and when it was set."""

    def __init__(self):
        self.kinds, self.time = {}, None

    def look(self, rig, time):
        """At each row. `time` in the record's file [s]."""
        before, self.time = self.time, time
        if rig.state.truth.accuracy_warning:
            text = rig.accuracy_warning
            kind = self.kinds.setdefault(re.sub(r"[-0-9.e]+", "", text), [text, time, time, 0.0])
            if kind[2] == before:
                kind[3] += time - before
            kind[2] = time

    def lines(self):
        """As drill run: how long, where it was not set all the time."""
        gaps = "accuracy warning, {3:.1f} s between {1:.1f} and {2:.1f} s: {0}"
        return [(gaps if kind[3] < kind[2] - kind[1] - 0.05 else "accuracy warning, {1:.1f} to {2:.1f} s: {0}").format(*kind) for kind in self.kinds.values()]


class MeasuredErrors:
    """Of a simulated run beside its companion: `largest` by signal, over any 3 s, as a share of the simulated range; empty where nothing is measured. `why_not`: one line."""

    def __init__(self):
        self.largest, self.why_not = {}, ""

    def look(self, rig):
        self.why_not = rig.not_measured
        for signal, error in rig.measured_errors.items():
            self.largest[signal] = max(error, self.largest.get(signal, 0.0))


def check(record):
    """RecordError where a record cannot be played."""
    if "block_height" not in record and "block_velocity" not in record:
        raise RecordError("%s: needs block_height or block_velocity%s" % (record.name, record.why_missing("block_height", "block_velocity")))
    if record.time[-1] < SHORTEST:
        raise RecordError("%s: lasts %.3g s; needed: %g s or more; is the unit of the time right?" % (record.name, record.time[-1], SHORTEST))
    check_directions(record)
    check_scale(record)
    check_connections(record)
    gap = int(numpy.diff(record.time).argmax())
    if record.time[gap + 1] - record.time[gap] > LONGEST_GAP:
        raise RecordError("%s: has a gap of %.6g days from %.1f s on; allowed: a day; needed: a part before or after it (drill replay --from, --to; from and to of a fit)" %
                          (record.name, (record.time[gap + 1] - record.time[gap]) / 86400.0, clock(record, gap)))
    if not any(signal in record for signal in COMPARED):
        raise RecordError("%s: holds nothing to compare; needed: %s%s" % (record.name, " or ".join(COMPARED), record.why_missing(*COMPARED)))


def check_start(record, rig):
    """RecordError where the record's bit is not where the scene's is: a unit that is wrong, or a start that was not set. What else differs, as lines."""
    depth, height = rig.state.truth.bit_depth, rig.state.truth.block_height
    if "bit_depth" in record and abs(record.at("bit_depth", 0.0) - depth) > APART:
        raise RecordError("%s: begins with the bit at %.2f m, the scene at %.2f m; needed: within %g m, by --start record (start: record of a fit), start.bit_depth or the column's unit" %
                          (record.name, record.at("bit_depth", 0.0), depth, APART))
    if "block_height" in record and numpy.nanmax(record.signals["block_height"]) > rig.crown_height:
        raise RecordError("%s: the block is at up to %.2f m, the crown of the scene's mast at %.2f m; is the unit of block_height right?" %
                          (record.name, numpy.nanmax(record.signals["block_height"]), rig.crown_height))
    if "block_height" in record and abs(record.at("block_height", 0.0) - height) > APART:
        return ["begins with the block at %.2f m, the scene at %.2f m: only changes of the block height are replayed" % (record.at("block_height", 0.0), height)]
    return []


def beyond_limits(record, rig):
    """Lines on signals that are more than the scene's rig can do."""
    lines = []
    for signal, most in rig.limits.items():
        rows = numpy.flatnonzero(numpy.abs(record.signals[signal]) > (1.0 + ROUNDS) * most) if signal in record else ()
        if len(rows):
            unit, per_si, *_ = SI[QUANTITIES[signal]]
            lines.append("%s is up to %.4g %s, beyond the %.4g %s of the scene's rig in %d rows (first: at %.1f s); is the unit right?" % (
                signal, per_si * numpy.nanmax(numpy.abs(record.signals[signal])), unit, per_si * most, unit, len(rows), clock(record, rows[0])))
    return lines


def ratio_of_units(recorded, simulated):
    """A line where a signal is nearly all the time the same multiple of what is simulated, and that is the ratio of two units; else none."""
    known = numpy.isfinite(recorded) & (simulated != 0.0)
    if known.sum() < LEAST_ROWS:
        return []
    ratios = recorded[known] / simulated[known]
    usual = float(numpy.median(ratios))
    steady = (numpy.abs(ratios - usual) <= NEAR * abs(usual)).mean() >= MOSTLY
    pair = next((pair for pair, ratio in RATIOS.items() if abs(usual - ratio) <= NEAR * ratio), None)
    return ["the recorded hook load is %.3g times the simulated one, as %s; is the unit right?" % (usual, pair)] if steady and pair else []


def events_of(record, law):
    """Lines on what happens to the pipe in a record."""
    slips = [event for event in pipe_events(record) if isinstance(event, Slip)]
    return ["connection at %.1f s: %s" % (law.times[one.leave] + clock(record, 0), one) for one in law.connections] + [
        "at %.1f s the bit depth changes by %.2f m while the block does not: taken as a slip of the depth tracking" % (clock(record, one.row), one.length) for one in slips]


def over_gaps(record):
    """A line where rows are so far apart that what the rig did between them is not known."""
    gaps = gaps_in(record.time)
    return ["%d gaps, %.4g s in all: block, top drive and pump go through them on straight lines; the rows after them may be off by what was done there" % (len(gaps), gaps.sum())] if len(gaps) else []


def run_up(rig, record):
    """Brings pump and top drive to where the record begins, while the block stands; lines on it."""
    speed, flow = (float(record.at(signal, 0.0)) if signal in record else 0.0 for signal in ("top_drive_speed", "flow"))
    if abs(speed) < RUNS[0] and flow < RUNS[1]:
        return []
    rig.brake()
    rig.top_drive(mode="SPEED", speed=speed)
    rig.pump(max(flow, 0.0))
    rig.step(seconds=RUN_UP)
    running = ["the top drive at %.1f rpm" % (speed / RPM)] * (abs(speed) >= RUNS[0]) + ["the pump at %.3g m3/s" % flow] * (flow >= RUNS[1])
    return ["begins with %s: played for %g s before it, with the block at rest" % (" and ".join(running), RUN_UP)]


def play(rig, record, left_out=(), tell=lambda done, whole: None):
    """Plays a record on a rig in lockstep (drill_rig_sim.sim) that stands where the record begins; a Replay. `left_out`: (begin, end) in the record's file [s], which are
    not compared. `tell`: called with how much of the record is played, and with its length [s]."""
    check(record)
    remarks = check_start(record, rig)
    law = Follow(record, rig)
    remarks += over_gaps(record) + events_of(record, law) + beyond_limits(record, rig) + run_up(rig, record)
    signals = [name for name in COMPARED if name in record]
    shown, warnings, errors = [[getattr(rig.state, name) for name in signals]], Warnings(), MeasuredErrors()
    with after(lambda: ["%s: %s" % (record.name, line) for line in remarks]):
        for state in driven(rig, law, law.times[-1] + PATIENCE * len(law.connections)):
            shown.append([getattr(state, name) for name in signals])
            warnings.look(rig, clock(record, 0) + law.times[law.k])
            errors.look(rig)
            tell(float(law.times[law.k]), float(record.time[-1]))
    there, shown = numpy.isfinite(law.clock), numpy.array(shown)
    times = numpy.asarray(law.clock)[there]
    if law.farthest > BEHIND:
        remarks.append("the scene's block was up to %.2f m off the record, because its winch could not follow; use a larger rig.hoisting.max_speed or max_acceleration" % law.farthest)
    load = shown[there, signals.index("hook_load")] if "hook_load" in signals else None
    recorded = compared(record, signals, law.stands)
    simulated = {name: numpy.interp(record.time, times, shown[there, k]) for k, name in enumerate(signals)}
    remarks += ratio_of_units(recorded["hook_load"], simulated["hook_load"]) if "hook_load" in signals else []
    passed = inside(record.signals["time"], left_out)
    return Replay(record.name, record.signals["time"], simulated,
                  {name: numpy.where(passed, numpy.nan, values) for name, values in recorded.items()},
                  record.remarks + ["%s: %s" % (record.name, line) for line in remarks + warnings.lines()], law.unresolved(record, times, load), errors)
