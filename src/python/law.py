# SPDX-License-Identifier: BSD-3-Clause
"""What control laws are made of (drill_rig_sim.control runs them): no ROS."""
import math

RPM = math.pi / 30.0  # [rad/s]


class Commands:
    """What a law asks for; None leaves a set point alone. Units and signs are the messages'."""
    __slots__ = ("block_velocity", "brake", "top_drive", "flow", "steering", "slips", "connection")

    def __init__(self, block_velocity=None, brake=False, top_drive=None, flow=None, steering=None, slips=None, connection=False):
        self.block_velocity, self.brake = block_velocity, brake
        self.top_drive = top_drive  # fields of TopDriveCommand, mode by its name: {"mode": "SPEED", "speed": 9.4}
        self.flow, self.steering = flow, steering  # steering: toolface, ratio
        self.slips = slips  # set or pull them; a dict: fields of slips() of a simulator
        self.connection = connection  # add a stand; or what is to be done, as fields of MakeConnection: {"joints": 2, "remove": True}


class Lag:
    """First-order, from the first value on."""

    def __init__(self, time):
        self.time, self.value = time, None

    def follow(self, value, dt):
        self.value = value if self.value is None else self.value + min(1.0, dt / self.time) * (value - self.value)
        return self.value


class Loop:
    """The feed [m/s] that brings a reading to its set point. It is a PI controller whose integral is the feed in force, lagged by `reset_time`: while
    another loop's feed or a limit is in force it follows that, so it neither winds up nor bumps when its turn comes.

    `stiffness`: what a metre of feed adds to the reading on rock that does not give way; `closes` [s]: time in which an error would then be gone."""

    def __init__(self, set_point, stiffness, closes=5.0, reset_time=10.0):
        self.set_point, self.gain, self.reset_time = set_point, 1.0 / (stiffness * closes), reset_time
        self.integral = 0.0

    def feed(self, reading):
        return self.gain * (self.set_point - reading) + self.integral

    def follow(self, feed, dt, reading=None):
        """`feed`: in force. If it is this loop's, its `reading` gives more: on rock that gives way in proportion, set point over reading times that."""
        if reading is not None:
            feed *= self.set_point / max(reading, 0.5 * self.set_point)
        self.integral += dt / self.reset_time * (feed - self.integral)


def turn_between(angle, other):
    """The shorter way from one direction to the other [rad]."""
    return math.remainder(other - angle, 2.0 * math.pi)


def bend(begin, end, inclination):
    """From one direction of a hole to another, each (inclination, azimuth): (build, turn) [rad], the turn at an inclination."""
    return end[0] - begin[0], math.sin(inclination) * turn_between(begin[1], end[1])


class Steering:
    """What steering laws share: an autodriller that drills, and a plan. `given_up`: why it ended before its goal, or ""."""

    def __init__(self, driller, plan):
        self.driller, self.plan, self.set_points = driller, Plan(plan), driller.set_points
        self.given_up = ""

    @property
    def done(self):
        return self.driller.done or bool(self.given_up)

    @property
    def phase(self):
        return self.driller.phase

    def behind_plan(self, survey):
        """The plan at a survey's depth less the survey: (build, turn) [rad]."""
        planned = self.plan.at(survey.md)
        return bend((survey.inclination, survey.azimuth), planned, planned[0])


class Plan:
    """Planned well: a drill_rig_sim.survey.Survey."""

    def __init__(self, survey):
        self._survey = survey

    def at(self, depth):
        """Inclination and azimuth there [rad]; beyond its ends those of the end."""
        east, north, up = self._survey.at(depth)[1]
        return math.atan2(math.hypot(east, north), -up), math.atan2(east, north)

    def points(self, spacing):
        """Places of it, (east, north, up) from the rotary table, at most `spacing` apart along it, with both its ends [m]."""
        begin, end = float(self._survey.md[0]), float(self._survey.md[-1])
        parts = max(1, math.ceil((end - begin) / spacing))
        return [self._survey.at(begin + (end - begin) * n / parts)[0] for n in range(parts + 1)]


class PipeWork:
    """Sets the slips, adds pipe or takes it away, and picks up, by the rig's services; a part of a law that makes no way of its own meanwhile.

    A noisy gauge with the sheaves' friction in it does not show reliably whether the slips carry the string; the rig's answer to slips and connection does, as the
    look of its crew would. So both are asked for again and again while the block goes down, or up, little by little."""
    still = 3.0                # so long all stands before the slips are asked for [s]
    slow, creep = 0.02, 0.002  # of the block while weight goes to the slips and comes back; while the slips are tried [m/s]
    hangs = 0.3                # share of the string's load above which the hook surely carries it still
    rests = 30e3               # of the block on the pipe below it, more than a dead line is off [N]

    def __init__(self, period, now, string_load, connection=True):
        """`period`: of the law that has it [s]; `string_load`: what the hook carries of the string off bottom [N]; `connection`: as in Commands."""
        self.period, self.since, self.string_load, self.connection = period, now, string_load, connection
        self.task, self.asked, self.made = "quiet", "", False

    @property
    def done(self):
        return self.task == "done"

    def step(self, readings, flow=0.0):
        """Commands of this step: of the block, slips and connection. `flow`: that the law has still asked of the pump [m3/s], until which is 0 nothing is tried."""
        commands = Commands(brake=True)
        getattr(self, self.task)(readings, commands, flow)
        return commands

    def go(self, task, now):
        self.task, self.since, self.asked = task, now, ""

    @staticmethod
    def move(commands, velocity):
        commands.brake, commands.block_velocity = False, velocity

    def tried(self, readings, what):
        """Whether a thing was asked for with the step before, and not refused."""
        asked, self.asked = self.asked, ""
        return asked == what and not readings.refused

    def beat(self, readings, cycle):
        """How many steps of a cycle [s] have gone by, and how many it has."""
        steps = round(cycle / self.period)
        return round((readings.t - self.since) / self.period) % steps, steps

    # --- tasks

    def quiet(self, readings, commands, flow):
        """Pump and drive stop, then the slips are set."""
        if self.tried(readings, "slips"):
            self.go("slack", readings.t)
        elif flow > 0.0 or abs(readings.top_drive_speed) > 0.01:
            self.since = readings.t
        elif readings.t > self.since + self.still:
            commands.slips, self.asked, self.since = True, "slips", readings.t

    def slack(self, readings, commands, _):
        """The block goes down; from where the slips may carry the string until the rig takes the connection: a second's way, a second's rest, a try."""
        if self.tried(readings, "connection"):
            self.made = True
            return self.go("connect", readings.t)
        if readings.hook_load_string > self.hangs * self.string_load:
            self.since = readings.t
            return self.move(commands, -self.slow)
        step, steps = self.beat(readings, 4.0)
        if step < steps // 4 and readings.hook_load_string < -self.rests:  # it rests on the pipe: what is refused is refused for another reason
            self.move(commands, self.creep)
        elif step < steps // 4:
            self.move(commands, -self.creep if readings.hook_load_string < 0.1 * self.string_load else -self.slow)
        elif step == steps - 1:
            commands.connection, self.asked = self.connection, "connection"

    def connect(self, readings, commands, _):
        if readings.t > self.since + 1.0 and readings.current_operation != "connecting":
            self.go("pick_up", readings.t)

    def pick_up(self, readings, commands, _):
        if self.tried(readings, "slips"):
            return self.go("done", readings.t)
        self.move(commands, self.slow)
        step, steps = self.beat(readings, 1.0)
        if step == steps - 1:
            commands.slips, self.asked = False, "slips"
