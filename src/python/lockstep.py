# SPDX-License-Identifier: BSD-3-Clause
"""A rig that is stepped: the same for the node in lockstep (drill_rig_sim.rig) and for a simulator in this process (drill_rig_sim.sim). No ROS."""
import collections
import json
import math
import operator
import types

import numpy
from drill_rig_sim.tables import SIGNALS, TOP_DRIVE_MODES

RPM = 2.0 * math.pi / 60.0  # [rad/s]
UNSENSED = tuple(row.name for row in SIGNALS if row.of == "truth")  # signals that RigState does not have
MODES = {word.upper(): number for number, word in enumerate(TOP_DRIVE_MODES)}  # of TopDriveCommand


class Refused(Exception):
    """The rig answered no; the text says why."""


class Failed(Refused):
    """A frame could not be computed: the state is that of the last one that could; restore() or reset() goes on. `record`: what a record() had got by then."""
    record = None


class TimedOut(Exception):
    """A condition did not come true within its simulated time."""


class State:
    """The results of one frame. Its attributes are the readings, fields of RigState: what a controller may know. Beside them:

    t         stamp [s]
    truth     the RigTruth, and
    bit       the BitTruth, for judging a controller
    readings  the readings in one

    What no rig can sense is an error here and has to be asked of the truth: s.truth.on_bottom.
    """
    __slots__ = ("t", "readings", "truth", "bit")

    def __init__(self, t, readings, truth, bit):
        self.t, self.readings, self.truth, self.bit = t, readings, truth, bit

    def __getattr__(self, name):
        if name in State.__slots__ or name.startswith("__"):  # of a copy that is not filled yet, and how it is made
            raise AttributeError(name)
        if not hasattr(self.readings, name) and hasattr(self.truth, name):
            raise AttributeError("%s: is not a reading; use truth.%s" % (name, name))
        return getattr(self.readings, name)


def yaml_of(operations):
    """Operations as text, of a list or one block."""
    return operations if isinstance(operations, str) else json.dumps(operations)


Zero = collections.namedtuple("Zero", "duration hook_load hook_load_deviation stand_pipe_pressure stand_pipe_pressure_deviation")
Zero.__doc__ = """What tare_over() has zeroed: means over `duration` [s] of the readings of hook load [N] and pressure [Pa], and their standard deviations."""


def zero_of(answer):
    """The Zero of an object with its fields."""
    return Zero(*(getattr(answer, name) for name in Zero._fields))


def arrived(message):
    """A message of telemetry, its stamp as the time `t` of measurement [s]."""
    fields = {name: getattr(message, name) for name in message.__slots__ if name != "header"}
    return types.SimpleNamespace(t=message.header.stamp.to_sec(), **fields)


def series(states, name):
    """Numbers of a list of states as an array: series(states, "hook_load"), series(states, "bit.wob")."""
    return numpy.array([operator.attrgetter(name)(state) for state in states])


class Lockstep:
    """A set point acts from the next frame on, the last one of its kind. Nothing moves but by step(), step_until() and frames(). Units and signs are the
    messages'. A call that the rig refuses raises Refused and changes nothing, but for the set points that wait: they are forgotten, all of them.

    rate   frames a second
    state  after the last frame
    """

    # --- set points, from the next frame on

    def winch(self, velocity):
        """Speed of the block, + up [m/s]."""
        self._set("winch", block_velocity=velocity)

    def brake(self):
        """Stops the block and holds it."""
        self._set("winch", brake=True)

    def rotate(self, rpm, torque_limit=0.0, mode="SPEED"):
        """Turns the string, + clockwise looking downhole [rpm]. mode: SPEED, SOFT_TORQUE or Z_TORQUE of TopDriveCommand."""
        self.top_drive(mode=mode, speed=rpm * RPM, torque_limit=torque_limit)

    def top_drive(self, mode="SPEED", **fields):
        """Any set point of the top drive, by the fields of TopDriveCommand; its mode by name or number."""
        if isinstance(mode, str) and mode not in MODES:
            raise ValueError("mode is %s; allowed is %s" % (mode, ", ".join(MODES)))
        self._set("top_drive", mode=MODES.get(mode, mode), **fields)

    def pump(self, flow):
        """Flow [m3/s]."""
        self._set("mud_pump", flow=flow)

    def steer(self, toolface, ratio):
        """Of a rotary steerable system: direction [rad] and share of its full steering [0..1]."""
        self._set("steering", toolface=toolface, ratio=ratio)

    # --- time

    def step(self, seconds=None, frames=1):
        """Computes `frames` frames, or as many as last `seconds`, at most 100000; the state after them."""
        if seconds is None and (frames != int(frames) or frames < 0):
            raise ValueError("frames is %r; allowed is a whole number from 0 on" % frames)
        self.state = self._advance(int(frames) if seconds is None else self._frames_in(seconds))
        return self.state

    def frames(self, seconds, every=1):
        """Steps through `seconds`, giving the state after each `every` frames: for s in rig.frames(60.0): ..."""
        left = self._frames_in(seconds)
        while left > 0:
            yield self.step(frames=min(every, left))
            left -= every

    def step_until(self, condition, timeout, every=1):
        """Steps until condition(state), looked at after each `every` frames; the state then. TimedOut after `timeout` simulated seconds."""
        for state in self.frames(timeout, every):
            if condition(state):
                return state
        raise TimedOut("not within %g s, at t = %g s" % (timeout, self.state.t))

    def clear_fault(self, fault, **fields):
        """Ends a fault."""
        self.fault(fault, clear=True, **fields)

    def _frames_in(self, seconds):
        frames = seconds * self.rate
        if not (math.isfinite(frames) and frames >= 0.0 and abs(frames - round(frames)) < 1e-6 * max(1.0, frames)):
            raise ValueError("%r s is not a whole number of frames of %g s" % (seconds, 1.0 / self.rate))
        return round(frames)

    # --- what each rig does in its own way

    def _set(self, kind, **fields):
        """Keeps a set point, by its name in StepSimulation, for the next frame."""
        raise NotImplementedError

    def _advance(self, frames):
        """Hands the set points over and computes; the state then."""
        raise NotImplementedError

    def fault(self, fault, clear=False, **fields):
        """Begins a fault, named as in InjectFault: rig.fault("STUCK_PIPE", depth=900.0)."""
        raise NotImplementedError
