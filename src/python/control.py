# SPDX-License-Identifier: BSD-3-Clause
"""Runs a control law against a rig. A law is a plain class without ROS:

    commands = law.step(readings)    # every law.period of simulated time [s]; until law.done. `commands`: a drill_rig_sim.law.Commands

`readings` has the fields of RigState, `t` [s], `toolface`, `survey`, `inclination` and `dynamics`: the last of each that came up, with the time `t` of their measurement, or None, and
`refused`: why the slips or the connection asked for last were not (else ""). What a rig cannot sense is not in it.
The same law runs in lockstep, with a node or without (`drive`), and by topics (drill_rig_sim.topics.follow).
"""
import copy

from drill_rig_sim.law import Commands
from drill_rig_sim.lockstep import UNSENSED, Refused


class Readings:
    """Of one instant."""

    def __init__(self, t, state, telemetry, refused=""):
        self.t, self._state, self.refused = t, state, refused
        self.toolface, self.survey = telemetry.toolface, telemetry.survey
        self.inclination, self.dynamics = telemetry.inclination, telemetry.dynamics

    def __getattr__(self, name):
        if name == "_state" or name.startswith("__"):  # of a copy that is not filled yet, and how it is made
            raise AttributeError(name)
        if name in UNSENSED:
            raise AttributeError("%s: is not a reading; only truth has it" % name)
        return getattr(self._state, name)


class NewRuns:
    """Lets a law begin again where the rig does: time goes back (the node was started again), or `epoch` of the state changes (the well was reset, a survey
    loaded, a snapshot restored). The law must be a plain object that can be copied; `problem`: why this one cannot, or ""."""

    def __init__(self, law):
        self._law, self._time, self._epoch, self.problem = law, None, None, ""
        try:
            self._fresh = copy.deepcopy(vars(law))
        except Exception as error:  # pylint: disable=broad-except
            self._fresh, self.problem = None, "%s: %s" % (type(error).__name__, error)

    def begins(self, now, epoch):
        """Whether a new run begins with the state of this time and epoch; the law is then as it was at first."""
        is_new = self._time is not None and (now < self._time or epoch != self._epoch)
        self._time, self._epoch = now, epoch
        if is_new and self._fresh is not None:
            vars(self._law).update(copy.deepcopy(self._fresh))  # at no time without an attribute: another thread may ask whether it is done
            for name in set(vars(self._law)) - set(self._fresh):
                delattr(self._law, name)
        return is_new


class Deaf:
    """In the place of telemetry, for a law that needs none."""
    toolface = survey = inclination = dynamics = None


class Ordered:
    """A law whose set points are changed during the run: rows of time since its first step [s], set point and value, of law.set_points."""

    def __init__(self, law, orders):
        self._law, self._orders, self._begin = law, sorted(orders), None

    @property
    def inner(self):
        """The law itself."""
        return self._law

    def __getattr__(self, name):
        if name == "_law" or name.startswith("__"):  # of a copy that is not filled yet, and how it is made
            raise AttributeError(name)
        return getattr(self._law, name)

    def step(self, readings):
        self._begin = readings.t if self._begin is None else self._begin
        while self._orders and readings.t - self._begin >= self._orders[0][0]:
            _, name, value = self._orders.pop(0)
            self._law.set_points[name] = value
        return self._law.step(readings)


def asked(law, readings):
    """The Commands of a law's step; TypeError where it gave none."""
    commands = law.step(readings)
    if not isinstance(commands, Commands):
        raise TypeError("%s.step() gave %s; needed: a drill_rig_sim.law.Commands" % (type(law).__name__, "nothing" if commands is None else type(commands).__name__))
    return commands


def hand_over(rig, commands):
    """Set points for the next step of a rig in lockstep; why slips or connection were refused, or ""."""
    if commands.brake:
        rig.brake()
    elif commands.block_velocity is not None:
        rig.winch(commands.block_velocity)
    if commands.top_drive is not None:
        rig.top_drive(**commands.top_drive)
    if commands.flow is not None:
        rig.pump(commands.flow)
    if commands.steering is not None:
        rig.steer(*commands.steering)
    return pipe_work(commands, rig.slips, rig.connection)


def pipe_work(commands, slips, connection):
    """Slips and connection, by two functions that may raise Refused; why they were refused, or ""."""
    try:
        if commands.slips is not None:
            slips(**commands.slips) if isinstance(commands.slips, dict) else slips(commands.slips)
        if commands.connection:
            connection(**(commands.connection if isinstance(commands.connection, dict) else {}))
    except Refused as refusal:
        return str(refusal)
    return ""


def frames_of(period, rate):
    """How many frames a law's period lasts."""
    frames = round(period * rate)
    if frames < 1 or abs(frames - period * rate) > 1e-6 * frames:
        raise ValueError("the law's period of %g s is not a whole number of frames of %g s" % (period, 1.0 / rate))
    return frames


def driven(rig, law, timeout, telemetry=Deaf):
    """Lockstep: steps the rig under the law until that is done, or for `timeout` simulated seconds; yields the state after each of its periods.
    `telemetry`: the rig itself, for a law that reads toolface, surveys or dynamics. Where the rig begins a new run meanwhile (NewRuns), so does the law."""
    every, refused, runs = frames_of(law.period, rig.rate), "", NewRuns(law)
    for _ in range(int(timeout * rig.rate / every)):
        if law.done:
            break
        if runs.begins(rig.state.t, rig.state.readings.epoch):
            refused = ""
        refused = hand_over(rig, asked(law, Readings(rig.state.t, rig.state.readings, telemetry, refused)))
        yield rig.step(frames=every)


def drive(rig, law, timeout, telemetry=Deaf, judge=None):
    """The states of driven() in a list. `judge`: called with each state, to look at the law meanwhile or to break the rig."""
    states = []
    for state in driven(rig, law, timeout, telemetry):
        states.append(state)
        if judge is not None:
            judge(state)
    return states
