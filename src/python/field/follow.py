# SPDX-License-Identifier: BSD-3-Clause
"""A record's block, rotary speed and flow as a law for a simulated rig."""
import numpy
from drill_rig_sim.field.course import FINE, TURNS, Course, half_band
from drill_rig_sim.field.pipe import compared, height_without_pipe, standstills
from drill_rig_sim.field.record import RecordError
from drill_rig_sim.law import Commands, PipeWork

PATIENCE = 1800.0  # longest that a connection may take [s]
TURNING = 0.1      # rotary speed of a string that turns [rad/s]
CREEPS = 1e-6      # speed of a block that moves [m/s]: what rounding leaves of 0 is slower
STANDS_BEFORE = 3  # rows before the first one, in which the block stands
RINGING = 10.0     # how long the string rings after a change of speed [s],
LOUD = 2.5         # and as long as this by all of it, in the mean square [s]


class Connection:
    """Of a record: on the law's steps `leave` to `back` pipe is added or taken away; `doing`: fields of MakeConnection."""

    def __init__(self, leave, back, doing):
        self.leave, self.back, self.doing = leave, back, doing

    def __str__(self):
        return "%d joints %s" % (self.doing["joints"], "taken away" if self.doing["remove"] else "added")


def connections_of(record, stands, joint, period):
    """All of a record with these standstills, for joints of a length [m] and a law's period [s]; RecordError where these do not fit."""
    found = []
    for still in stands:
        leave, back = (int(round(record.time[row] / period)) for row in (still.left, still.back))
        try:
            doing = still.connection(joint)
        except ValueError as error:
            if still.end == len(record.time) - 1:
                continue  # the record ends while the block is on its way
            raise RecordError("%s: at %.1f s %s" % (record.name, record.time[still.left], error))
        if doing is not None:
            found.append(Connection(leave, back, doing))
    return found


class Follow:
    """A law (drill_rig_sim.control) for a simulator in this process: its drum goes as the record's did, from where the rig stands at the law's first step. The
    block itself would be followed against the ringing of the string on its lines, which makes that worse. The drum never goes against the record, not to make
    up for what it is off either: friction of rail, sheaves and string would act the other way. Where pipe was added or taken away the record waits until the
    rig has done so too, and the bit is where it then belongs."""
    period = 0.05      # [s]: longer steps of the speed would ring in the string
    catch_up = 0.2     # in which the drum makes up for what it is off [s]
    to_place = 0.1     # fastest way of the bit to where it belongs after a connection [m/s]
    to_place_in = 1.0  # it slows down in [s]
    placed = 2e-3      # so near is there [m]
    from_rest = True   # whether the block of a coarse gauge stands before the first row, too

    def __init__(self, record, rig):
        """RecordError where the record's connections do not go with the rig's joints of pipe."""
        self.name, self.rig = record.name, rig
        self.take(record)
        self.clock = [0.0]  # the record's, at the rig's start and after each step; not a number while it waits [s]
        self.k, self.begin, self.done, self.farthest = 0, None, False, 0.0
        self.work, self.depth, self.began, self.off, self.refused = None, 0.0, 0.0, 0.0, ""

    def take(self, record):
        """What is worked out of the record."""
        self.times = self.period * numpy.arange(int(record.time[-1] / self.period) + 2)
        self.stands = standstills(record)
        self.heights = heights_of(record, self.stands, self.rig)
        self.way = numpy.interp(self.times, record.time, self.heights)
        self.drum = drum_course(record, self.stands, self.heights, self.rig, self.from_rest)
        self.course = self.drum(self.times)
        middle = self.times + 0.5 * self.period
        self.speed = record.at("top_drive_speed", middle) if "top_drive_speed" in record else None
        self.flow = numpy.maximum(record.at("flow", middle), 0.0) if "flow" in record else None
        self.connections = self.connections_in(record)

    def connections_in(self, record):
        return connections_of(record, self.stands, self.rig.joint_length, self.period)

    def step(self, readings):
        if self.begin is None:  # a corner at the first row is rounded before it as well
            self.begin = self.rig.drum_height - self.drum.straight(self.times[0])
        if self.connections and self.k >= self.connections[0].leave:
            waits = self.connect(readings, self.connections[0])
            if waits is not None:
                self.clock.append(numpy.nan)
                return waits
            self.k, self.work = self.connections.pop(0).back, None
            self.begin = self.rig.drum_height - self.course[self.k]
        return self.as_recorded()

    def as_recorded(self):
        k, self.k = self.k, self.k + 1
        self.done = self.k >= len(self.times) - 1
        self.clock.append(self.times[self.k])
        off = self.begin + self.course[k] - self.rig.drum_height
        self.farthest = max(self.farthest, abs(off))
        drive_at = None if self.speed is None else {"mode": "SPEED", "speed": float(self.speed[k])}
        return Commands(self.new_speed((self.course[k + 1] - self.course[k]) / self.period, off), top_drive=drive_at,
                        flow=None if self.flow is None else float(self.flow[k]))

    def new_speed(self, recorded, off):
        """The block's speed; `off`: of the drum, by which the record is further up [m]. Commanded at every step, changed or not: each ends a step of the simulation,
        and where these ends depended on the speeds, a fit's simulations would differ by more than their parameters do."""
        made_up = recorded + off / self.catch_up
        return float(made_up if abs(recorded) > CREEPS and made_up * recorded > 0.0 else 0.0)

    def connect(self, readings, connection):
        """Commands while the rig adds pipe or takes it away and brings the bit to where it then is in the record; None once that is done."""
        if self.work is None:
            self.work, self.began, self.off = PipeWork(self.period, readings.t, readings.hook_load_string, connection.doing), readings.t, 0.0
            self.depth = self.depth_after(readings, connection)
        self.refused = readings.refused or self.refused
        if readings.t > self.began + PATIENCE:
            raise RecordError("%s: at %.1f s the scene's rig refuses the connection of the record: %s" % (self.name, self.times[self.k], self.refused))
        if not self.work.done:
            commands = self.work.step(readings)
            if commands.slips:  # the joints of the scene may lie elsewhere than the rig's
                commands.slips = {"connection": connection.doing}
            commands.flow, commands.top_drive = 0.0, {"mode": "SPEED", "speed": 0.0}
            return commands
        before, self.off = self.off, readings.bit_depth - self.depth
        if abs(self.off) < self.placed or self.off * before < 0.0:  # there, or beyond
            return None
        return Commands(float(numpy.clip(self.off / self.to_place_in, -self.to_place, self.to_place)))

    def depth_after(self, readings, connection):
        """Where the bit belongs after a connection [m]; `readings`: before it."""
        return readings.bit_depth + self.way[connection.leave] - self.way[connection.back]

    def standing(self, record):
        """How long after each corner of the drum's trajectory the string neither moves nor turns nor hangs in the slips [s]."""
        ends = [self.drum.corners[numpy.abs(self.drum.after) > TURNS], record.time[[still.begin for still in self.stands]], record.time[-1:]]
        if "top_drive_speed" in record:
            ends.append(record.time[numpy.abs(record.at("top_drive_speed", record.time)) > TURNING])
        ends = numpy.sort(numpy.concatenate(ends))
        corners = numpy.minimum(self.drum.corners, record.time[-1])
        return ends[numpy.searchsorted(ends, corners)] - corners

    def unresolved(self, record, times, loads):
        """Of the hook load, what the sampling of the record leaves unknown, root mean square and largest [N]. Where the speed changes, half of the change is unknown
        for a while: it goes into the string as a wave, and accelerates the block. Friction keeps what the wave of a stop leaves until the string moves or turns. When the drum starts, stops and turns back is unknown by half a row, and
        with it half of what the recorded load changed in that row; at most by a whole row: the load may be any within that. `loads`: simulated, at `times` [s]."""
        drum, gaps = self.drum, numpy.diff(self.drum.corners)
        nearest = numpy.minimum(numpy.concatenate((gaps[:1], gaps)), numpy.concatenate((gaps, gaps[-1:])))
        waves = 0.5 * numpy.abs(drum.after - drum.before) * (self.rig.wave_impedance + self.rig.block_mass / nearest)
        squares, most = (waves**2 * numpy.clip(nearest, LOUD, RINGING)).sum() / record.time[-1], waves.max()
        kept = 0.5 * numpy.abs(drum.before) * self.rig.wave_impedance * (numpy.abs(drum.after) <= TURNS)
        squares += (kept**2 * numpy.maximum(self.standing(record) - numpy.clip(nearest, LOUD, RINGING), 0.0)).sum() / record.time[-1]
        if "hook_load" in record:
            recorded = compared(record, ["hook_load"], self.stands)["hook_load"]
            changes, known = 0.5 * numpy.abs(numpy.diff(recorded)), numpy.isfinite(recorded)
            turns = (drum.before * drum.after <= 0.0) & (numpy.abs(drum.after - drum.before) > TURNS)
            intervals = numpy.clip(numpy.searchsorted(record.time, drum.corners[turns], side="right") - 1, 0, len(changes) - 1)
            unknown = changes[numpy.unique(intervals)]
            unknown = unknown[numpy.isfinite(unknown)]
            squares += (unknown**2).sum() / 3.0 / len(record.time)  # uniformly distributed
            most = max(most, *unknown, *(span(record.time, k, 1.0, times, loads) for k in rows_near(record.time, drum.turns) if known[k]), 0.0)
        return float(numpy.sqrt(squares)), float(most)


def rows_near(times, corners):
    """Rows at these corners, which are rows, and their neighbours."""
    at = numpy.searchsorted(times, corners)
    return numpy.unique(numpy.clip(numpy.concatenate((at - 1, at, at + 1)), 0, len(times) - 1))


def rows_at_turns(record, stands):
    """Rows next to where the block starts, stops or turns back: what their hook load is depends on when. None where the record has no block height, or few other rows."""
    if "block_height" not in record:
        return numpy.zeros(0, int)
    heights = height_without_pipe(record, stands)
    rows = rows_near(record.time, Course(record.time, heights, half_band(record.at("block_height", record.time), heights)).turns)
    return rows if 2 * len(rows) < len(record.time) else rows[:0]


def span(rows, k, share, times, loads):
    """Largest less least of the loads within a share of a row around row k; 0 where no load is, between rows that are closer than the frames of the simulation."""
    begin, end = (rows[k] + share * (rows[numpy.clip(other, 0, len(rows) - 1)] - rows[k]) for other in (k - 1, k + 1))
    inside = loads[(times >= begin) & (times <= end)]
    return float(numpy.ptp(inside)) if len(inside) else 0.0


def heights_of(record, stands, rig):
    """Of a block that had never been moved without the string, by the rows [m]."""
    if "block_height" in record:
        return height_without_pipe(record, stands)
    speed = record.at("block_velocity", record.time)
    way = numpy.concatenate(([0.0], numpy.cumsum(0.5 * (speed[1:] + speed[:-1]) * numpy.diff(record.time))))
    return rig.state.truth.block_height + way


def drum_course(record, stands, heights, rig, rests):
    """Of heights by the rows with what the recorded hook load stretched the lines."""
    gauge = record.at("block_height", record.time) if "block_height" in record else heights
    hung = numpy.ones(len(record.time), bool)
    for still in stands:
        hung[still.begin:still.end + 1] = False
    if "hook_load" not in record or not hung.any():
        return from_rest(record.time, heights, half_band(gauge, heights), rig.block_acceleration, rests)
    loads = numpy.interp(record.time, record.time[hung], numpy.maximum(record.at("hook_load", record.time[hung]), 0.0))
    band = half_band(gauge, gauge)
    block = gauge if band < FINE else Course(record.time, gauge, band).heights
    heights = heights + rig.drum_heights(block, loads) - block
    return from_rest(record.time, heights, half_band(gauge, heights), rig.block_acceleration, rests)


def from_rest(times, heights, band, acceleration, rests):
    """A trajectory whose block stands before the first row, as the rig does that follows it; by a coarse gauge if it `rests`."""
    if band >= FINE and not rests:
        return Course(times, heights, band, acceleration)
    before = times[0] - (times[1] - times[0]) * numpy.arange(STANDS_BEFORE, 0, -1)
    return Course(numpy.concatenate((before, times)), numpy.concatenate((numpy.full(STANDS_BEFORE, heights[0]), heights)), band, acceleration)
