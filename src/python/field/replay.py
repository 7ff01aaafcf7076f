"""A record's block, rotary speed and flow, fed to a simulator; hook load, torque and pressure against what was recorded."""
import numpy
from drill_rig_sim.control import drive
from drill_rig_sim.field.record import RecordError
from drill_rig_sim.law import Commands
from drill_rig_sim.lockstep import series

COMPARED = ("hook_load", "torque", "stand_pipe_pressure")
JOINED = 0.5  # so much that the bit did not follow the block from row to row: pipe was added or taken away [m]
APART = 1.0   # of the bit at the beginning, record and scene [m]
PLAY = 2e-3   # by which a gauge of the block's height may go back and forth while the block does not [m]
BEHIND = 0.05  # of the block against the record's, from which on it is told [m]


class Follow:
    """A law (drill_rig_sim.control): moves the block, turns the string and pumps as the record says, from where the rig stands at its first step. The block
    never goes against the record, not to make up for what it is off either: friction of its rail and of the string would act the other way."""
    period, listens = 0.02, False  # [s]: jerks of longer steps would ring in the string
    catch_up = 1.0  # in which the block makes up for what it is off [s]

    def __init__(self, record):
        self.times = self.period * numpy.arange(int(record.time[-1] / self.period) + 2)
        self.course = course_of(record, self.times)
        self.speed = record.at("top_drive_speed", self.times) if "top_drive_speed" in record else None
        self.flow = numpy.maximum(record.at("flow", self.times), 0.0) if "flow" in record else None
        self.steps, self.begin, self.done, self.farthest = 0, None, False, 0.0

    def step(self, readings):
        k, self.steps = self.steps, self.steps + 1
        self.begin = readings.block_height if self.begin is None else self.begin
        self.done = self.steps >= len(self.times) - 1
        off = self.begin + self.course[k] - readings.block_height
        self.farthest = max(self.farthest, abs(off))
        speed = (self.course[k + 1] - self.course[k]) / self.period
        made_up = speed + off / self.catch_up if speed else 0.0
        drive_at = None if self.speed is None else {"mode": "SPEED", "speed": float(self.speed[k])}
        return Commands(float(made_up if made_up * speed > 0.0 else 0.0), top_drive=drive_at,
                        flow=None if self.flow is None else float(self.flow[k]))


class Replay:
    """`time` [s] of the record's rows; `simulated` and `recorded`: arrays by signal, as the gauges show it. `remarks`: what its reader should know, a line each."""

    def __init__(self, name, time, simulated, recorded, remarks):
        self.name, self.time, self.simulated, self.recorded, self.remarks = name, time, simulated, recorded, remarks

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
                                 "range": float(numpy.ptp(self.recorded[signal][rows]))}
        return found


def check(record):
    """RecordError where a record cannot be played."""
    if "block_height" not in record and "block_velocity" not in record:
        raise RecordError("%s: needs block_height or block_velocity" % record.name)
    if not any(signal in record for signal in COMPARED):
        raise RecordError("%s: holds nothing to compare: %s" % (record.name, ", ".join(COMPARED)))
    if "bit_depth" in record and "block_height" in record:
        moved = numpy.abs(numpy.diff(record.at("bit_depth", record.time)) + numpy.diff(record.at("block_height", record.time)))
        if (moved > JOINED).any():
            raise RecordError("%s: at %.1f s pipe was added or taken away: connections are not available yet, cut the record there" %
                              (record.name, record.time[1:][moved > JOINED][0]))


def check_start(record, rig):
    """RecordError where the record's bit is not where the scene's is: a unit that is wrong, or a start that was not set. What else differs, as lines."""
    depth, height = rig.state.truth.bit_depth, rig.state.truth.block_height
    if "bit_depth" in record and abs(record.at("bit_depth", 0.0) - depth) > APART:
        raise RecordError("%s: begins with the bit at %.2f m, the scene at %.2f m: needed: within %g m, by start.bit_depth or the column's unit" %
                          (record.name, record.at("bit_depth", 0.0), depth, APART))
    if "block_height" in record and abs(record.at("block_height", 0.0) - height) > APART:
        return ["%s: begins with the block at %.2f m, the scene at %.2f m: its way is followed from there" % (record.name, record.at("block_height", 0.0), height)]
    return []


def course_of(record, times):
    """The block's height less that at the start [m]."""
    if "block_height" in record:
        height = without_play(record.at("block_height", record.time))
        return smooth(times, record.time, height - height[0])
    speed = record.at("block_velocity", record.time)
    way = numpy.concatenate(([0.0], numpy.cumsum(0.5 * (speed[1:] + speed[:-1]) * numpy.diff(record.time))))
    return numpy.interp(times, record.time, way)


def without_play(height):
    """The heights without what goes back less than PLAY: the farthest so far stays, until it has gone back by more."""
    moved = height[numpy.abs(height - height[0]) > PLAY]
    found, farthest, up = numpy.empty(len(height)), height[0], len(moved) > 0 and moved[0] > height[0]
    for k, value in enumerate(height):
        if (value - farthest if up else farthest - value) < -PLAY:
            up, farthest = not up, value
        farthest = max(farthest, value) if up else min(farthest, value)
        found[k] = farthest
    return found


def smooth(at, times, values):
    """Cubics between the rows without overshoot (slopes at the rows by the harmonic mean of those on both sides, 0 where these differ in sign: Fritsch and
    Butland): a block has no jumps of speed, and one that stops does not come back. Beyond the end it stays."""
    sides = numpy.diff(values) / numpy.diff(times)
    before, after = numpy.concatenate((sides[:1], sides)), numpy.concatenate((sides, sides[-1:]))
    same = before * after > 0.0
    slopes = numpy.where(same, 2.0 * before * after / numpy.where(same, before + after, 1.0), 0.0)
    k = numpy.clip(numpy.searchsorted(times, at, side="right") - 1, 0, len(times) - 2)
    width = times[k + 1] - times[k]
    u = numpy.clip((at - times[k]) / width, 0.0, 1.0)
    return ((1.0 + 2.0 * u) * (1.0 - u)**2 * values[k] + u**2 * (3.0 - 2.0 * u) * values[k + 1] +
            u * (1.0 - u)**2 * width * slopes[k] - u**2 * (1.0 - u) * width * slopes[k + 1])


def play(rig, record):
    """Plays a record on a rig in lockstep (drill_rig_sim.sim or .rig) that stands where the record begins; a Replay."""
    check(record)
    remarks = record.remarks + check_start(record, rig)
    law = Follow(record)
    states = [rig.state, *drive(rig, law, law.times[-1])]
    times = series(states, "t") - states[0].t
    signals = [name for name in COMPARED if name in record]
    if law.farthest > BEHIND:
        remarks.append("%s: the scene's block was up to %.2f m off the record's: it could not follow" % (record.name, law.farthest))
    return Replay(record.name, record.time, {name: numpy.interp(record.time, times, series(states, name)) for name in signals},
                  {name: record.signals[name] for name in signals}, remarks)
