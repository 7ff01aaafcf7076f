"""A record's block, rotary speed and flow, fed to a simulator; hook load, torque and pressure against what was recorded."""
import numpy
from drill_rig_sim.control import drive
from drill_rig_sim.field.record import RecordError
from drill_rig_sim.law import Commands
from drill_rig_sim.lockstep import series

COMPARED = ("hook_load", "torque", "stand_pipe_pressure")
JOINED = 0.5  # so much that the bit did not follow the block from row to row: pipe was added or taken away [m]


class Follow:
    """A law (drill_rig_sim.control): moves the block, turns the string and pumps as the record says, from where the rig stands at its first step."""
    period, listens = 0.02, False  # [s]: jerks of longer steps would ring in the string
    catch_up = 1.0  # in which the block makes up for what it is off [s]

    def __init__(self, record):
        self.times = self.period * numpy.arange(int(record.time[-1] / self.period) + 2)
        self.course = course_of(record, self.times)
        self.speed = record.at("top_drive_speed", self.times) if "top_drive_speed" in record else None
        self.flow = numpy.maximum(record.at("flow", self.times), 0.0) if "flow" in record else None
        self.steps, self.begin, self.done = 0, None, False

    def step(self, readings):
        k, self.steps = self.steps, self.steps + 1
        self.begin = readings.block_height if self.begin is None else self.begin
        self.done = self.steps >= len(self.times) - 1
        off = self.begin + self.course[k] - readings.block_height
        drive_at = None if self.speed is None else {"mode": "SPEED", "speed": float(self.speed[k])}
        return Commands(float((self.course[k + 1] - self.course[k]) / self.period + off / self.catch_up), top_drive=drive_at,
                        flow=None if self.flow is None else float(self.flow[k]))


class Replay:
    """`time` [s] of the record's rows; `simulated` and `recorded`: arrays by signal, as the gauges show it."""

    def __init__(self, name, time, simulated, recorded):
        self.name, self.time, self.simulated, self.recorded = name, time, simulated, recorded

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


def course_of(record, times):
    """The block's height less that at the start [m]."""
    if "block_height" in record:
        height = record.at("block_height", record.time)
        return smooth(times, record.time, height - height[0])
    speed = record.at("block_velocity", record.time)
    way = numpy.concatenate(([0.0], numpy.cumsum(0.5 * (speed[1:] + speed[:-1]) * numpy.diff(record.time))))
    return numpy.interp(times, record.time, way)


def smooth(at, times, values):
    """Cubics between the rows, whose slopes at the rows are those from row to row on both sides: a block has no jumps of speed. Beyond the end it stays."""
    slopes = numpy.gradient(values, times)
    k = numpy.clip(numpy.searchsorted(times, at, side="right") - 1, 0, len(times) - 2)
    width = times[k + 1] - times[k]
    u = numpy.clip((at - times[k]) / width, 0.0, 1.0)
    return ((1.0 + 2.0 * u) * (1.0 - u)**2 * values[k] + u**2 * (3.0 - 2.0 * u) * values[k + 1] +
            u * (1.0 - u)**2 * width * slopes[k] - u**2 * (1.0 - u) * width * slopes[k + 1])


def play(rig, record):
    """Plays a record on a rig in lockstep (drill_rig_sim.sim or .rig) that stands where the record begins; a Replay."""
    check(record)
    law = Follow(record)
    states = [rig.state, *drive(rig, law, law.times[-1])]
    times = series(states, "t") - states[0].t
    signals = [name for name in COMPARED if name in record]
    return Replay(record.name, record.time, {name: numpy.interp(record.time, times, series(states, name)) for name in signals},
                  {name: record.signals[name] for name in signals})
