"""A record's block, rotary speed and flow, fed to a simulator; hook load, torque and pressure against what was recorded."""
import numpy
from drill_rig_sim.control import drive
from drill_rig_sim.field.follow import PATIENCE, Follow
from drill_rig_sim.field.pipe import compared
from drill_rig_sim.field.record import RecordError
from drill_rig_sim.lockstep import series

COMPARED = ("hook_load", "torque", "stand_pipe_pressure")
APART = 1.0    # of the bit at the beginning, record and scene [m]
BEHIND = 0.05  # of the block against the record's, from which on it is told [m]


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


def check_start(record, rig):
    """RecordError where the record's bit is not where the scene's is: a unit that is wrong, or a start that was not set. What else differs, as lines."""
    depth, height = rig.state.truth.bit_depth, rig.state.truth.block_height
    if "bit_depth" in record and abs(record.at("bit_depth", 0.0) - depth) > APART:
        raise RecordError("%s: begins with the bit at %.2f m, the scene at %.2f m: needed: within %g m, by start.bit_depth or the column's unit" %
                          (record.name, record.at("bit_depth", 0.0), depth, APART))
    if "block_height" in record and abs(record.at("block_height", 0.0) - height) > APART:
        return ["%s: begins with the block at %.2f m, the scene at %.2f m: its way is followed from there" % (record.name, record.at("block_height", 0.0), height)]
    return []


def play(rig, record):
    """Plays a record on a rig in lockstep (drill_rig_sim.sim) that stands where the record begins; a Replay."""
    check(record)
    remarks = record.remarks + check_start(record, rig)
    law = Follow(record, rig.joint_length)
    remarks += ["%s: connection at %.1f s: %s" % (record.name, law.times[one.leave], one) for one in law.connections]
    states = [rig.state, *drive(rig, law, law.times[-1] + PATIENCE * len(law.connections))]
    there = numpy.isfinite(law.clock)
    times = numpy.asarray(law.clock)[there]
    signals = [name for name in COMPARED if name in record]
    if law.farthest > BEHIND:
        remarks.append("%s: the scene's block was up to %.2f m off the record's: it could not follow" % (record.name, law.farthest))
    return Replay(record.name, record.time, {name: numpy.interp(record.time, times, series(states, name)[there]) for name in signals},
                  compared(record, signals, law.stands), remarks)
