"""A record's block, rotary speed and flow as a law for a simulated rig."""
import numpy
from drill_rig_sim.field.pipe import height_without_pipe, standstills
from drill_rig_sim.field.record import RecordError
from drill_rig_sim.law import Commands, PipeWork

PLAY = 2e-3        # by which a gauge of the block's height may go back and forth while the block does not [m]
PATIENCE = 1800.0  # longest that a connection may take [s]


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
    """A law (drill_rig_sim.control): moves the block, turns the string and pumps as the record says, from where the rig stands at its first step. The block
    never goes against the record, not to make up for what it is off either: friction of its rail and of the string would act the other way. Where pipe was added
    or taken away the record waits until the rig has done so too, and the bit is where it then belongs."""
    period, listens = 0.02, False  # [s]: jerks of longer steps would ring in the string
    catch_up = 1.0  # in which the block makes up for what it is off [s]
    to_place = 0.1  # fastest way of the bit to where it belongs after a connection [m/s]
    placed = 2e-3   # so near is there [m]

    def __init__(self, record, joint):
        """`joint`: length of the scene's joints of pipe [m]. RecordError where the record's connections do not go with these."""
        self.name = record.name
        self.times = self.period * numpy.arange(int(record.time[-1] / self.period) + 2)
        self.stands = standstills(record)
        self.course = course_of(record, self.stands, self.times)
        self.speed = record.at("top_drive_speed", self.times) if "top_drive_speed" in record else None
        self.flow = numpy.maximum(record.at("flow", self.times), 0.0) if "flow" in record else None
        self.connections = connections_of(record, self.stands, joint, self.period)
        self.clock = [0.0]  # the record's, at the rig's start and after each step; not a number while it waits [s]
        self.k, self.begin, self.done, self.farthest = 0, None, False, 0.0
        self.work, self.depth, self.began, self.off, self.refused = None, 0.0, 0.0, 0.0, ""

    def step(self, readings):
        self.begin = readings.block_height if self.begin is None else self.begin
        if self.connections and self.k >= self.connections[0].leave:
            waits = self.connect(readings, self.connections[0])
            if waits is not None:
                self.clock.append(numpy.nan)
                return waits
            self.k, self.work = self.connections.pop(0).back, None
            self.begin = readings.block_height - self.course[self.k]
        return self.as_recorded(readings)

    def as_recorded(self, readings):
        k, self.k = self.k, self.k + 1
        self.done = self.k >= len(self.times) - 1
        self.clock.append(self.times[self.k])
        off = self.begin + self.course[k] - readings.block_height
        self.farthest = max(self.farthest, abs(off))
        speed = (self.course[k + 1] - self.course[k]) / self.period
        made_up = speed + off / self.catch_up if speed else 0.0
        drive_at = None if self.speed is None else {"mode": "SPEED", "speed": float(self.speed[k])}
        return Commands(float(made_up if made_up * speed > 0.0 else 0.0), top_drive=drive_at,
                        flow=None if self.flow is None else float(self.flow[k]))

    def connect(self, readings, connection):
        """Commands while the rig adds pipe or takes it away and brings the bit to where it then is in the record; None once that is done."""
        if self.work is None:
            self.work, self.began, self.off = PipeWork(self.period, readings.t, readings.hook_load_string, connection.doing), readings.t, 0.0
            self.depth = readings.bit_depth + self.course[connection.leave] - self.course[connection.back]
        self.refused = readings.refused or self.refused
        if readings.t > self.began + PATIENCE:
            raise RecordError("%s: at %.1f s the scene's rig does not make the record's connection: %s" % (self.name, self.times[self.k], self.refused))
        if not self.work.done:
            commands = self.work.step(readings)
            commands.flow, commands.top_drive = 0.0, {"mode": "SPEED", "speed": 0.0}
            return commands
        before, self.off = self.off, readings.bit_depth - self.depth
        if abs(self.off) < self.placed or self.off * before < 0.0:  # there, or beyond
            return None
        return Commands(float(numpy.clip(self.off / self.catch_up, -self.to_place, self.to_place)))


def course_of(record, stands, times):
    """The block's height less that at the start [m]."""
    if "block_height" in record:
        height = without_play(height_without_pipe(record, stands))
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
