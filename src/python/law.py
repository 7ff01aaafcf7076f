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
        self.slips, self.connection = slips, connection  # set or pull them; add a stand


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
        """`feed`: in force. If it is this loop's, its `reading` tells more: on rock that gives way in proportion, set point over reading times that."""
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
