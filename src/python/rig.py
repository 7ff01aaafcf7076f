"""A rig in lockstep (rig.launch clock:=lockstep), for tests of controllers in few lines:

    from drill_rig_sim.rig import Rig

    rig = Rig("rig")
    rig.rotate(rpm=90)
    rig.winch(-0.01)
    rig.step_until(lambda s: s.truth.on_bottom, timeout=300)

A set point acts from the next frame on. Nothing moves but by step(), step_until() and frames(). Units and signs are the messages'.
"""
import math
import operator

import numpy
import rosgraph
import rospy
from drill_rig_sim.msg import MudPumpCommand, SteeringCommand, TopDriveCommand, WinchCommand
from drill_rig_sim.srv import (InjectFault, InjectFaultRequest, LoadSurvey, MakeConnection, ResetWell, RestoreState, SaveState, StepSimulation,
                               StepSimulationRequest)
from std_srvs.srv import SetBool, Trigger

RPM = 2.0 * math.pi / 60.0  # [rad/s]
UNSENSED = ("on_bottom", "motor_stalled", "over_stress", "over_torque", "buckled")  # fields of RigState that are false in every reading


class Refused(Exception):
    """The rig answered no; the text says why."""


class TimedOut(Exception):
    """A condition did not come true within its simulated time."""


class State:
    """What one frame tells. Its attributes are the readings, fields of RigState: what a controller may know. Beside them:

    t         stamp [s]
    truth     the RigState as it is, and
    bit       the BitTruth, for judging a controller
    readings  the readings as a message

    What no rig can sense is an error here and has to be asked of the truth: s.truth.on_bottom.
    """
    __slots__ = ("t", "readings", "truth", "bit")

    def __init__(self, answer):
        self.readings, self.truth, self.bit = answer.state, answer.truth, answer.bit
        self.t = answer.state.header.stamp.to_sec()

    def __getattr__(self, name):
        if name in UNSENSED:
            raise AttributeError("%s: no rig can sense it; ask for truth.%s" % (name, name))
        if name in State.__slots__:  # of a copy that is not filled yet
            raise AttributeError(name)
        return getattr(self.readings, name)


def series(states, name):
    """Numbers of a list of states as an array: series(states, "hook_load"), series(states, "bit.wob")."""
    return numpy.array([operator.attrgetter(name)(state) for state in states])


class Rig:
    """The rig of a namespace, in lockstep. `patience`: wall seconds to wait for it. A call that it refuses raises Refused and changes nothing."""

    def __init__(self, namespace="rig", patience=60.0):
        self._prefix = rospy.resolve_name(namespace)
        rospy.wait_for_service(self._prefix + "/step", patience)
        self._step = rospy.ServiceProxy(self._prefix + "/step", StepSimulation, persistent=True)
        self._request = StepSimulationRequest()
        self.rate = frames_per_second(self._prefix + "/step")
        self.state = None  # after the last frame
        self._look()

    # --- set points, from the next frame on

    def winch(self, velocity):
        """Speed of the block, + up [m/s]."""
        self._request.winch = [WinchCommand(block_velocity=velocity)]

    def brake(self):
        """Stops the block and holds it."""
        self._request.winch = [WinchCommand(brake=True)]

    def rotate(self, rpm, torque_limit=0.0, mode=TopDriveCommand.SPEED):
        """Turns the string, + clockwise looking downhole [rpm]. mode: SPEED, SOFT_TORQUE or Z_TORQUE of TopDriveCommand."""
        self.top_drive(mode=mode, speed=rpm * RPM, torque_limit=torque_limit)

    def top_drive(self, **fields):
        """Any set point of the top drive, by the fields of TopDriveCommand."""
        self._request.top_drive = [TopDriveCommand(**fields)]

    def pump(self, flow):
        """Flow [m3/s]."""
        self._request.mud_pump = [MudPumpCommand(flow=flow)]

    def steer(self, toolface, ratio):
        """Of a rotary steerable system: direction [rad] and share of its full steering [0..1]."""
        self._request.steering = [SteeringCommand(toolface=toolface, ratio=ratio)]

    # --- time

    def step(self, seconds=None, frames=1):
        """Computes so many frames, or as many as last `seconds`, at most 100000; the state after them."""
        self._request.frames = frames if seconds is None else self._frames_in(seconds)
        request, self._request = self._request, StepSimulationRequest()
        self.state = State(answered(self._step.call(request)))
        return self.state

    def frames(self, seconds, every=1):
        """Steps through `seconds`, giving the state after every so many frames: for s in rig.frames(60.0): ..."""
        left = self._frames_in(seconds)
        while left > 0:
            yield self.step(frames=min(every, left))
            left -= every

    def step_until(self, condition, timeout, every=1):
        """Steps until condition(state), looked at after every so many frames; the state then. TimedOut after `timeout` simulated seconds."""
        for state in self.frames(timeout, every):
            if condition(state):
                return state
        raise TimedOut("not within %g s, at t = %g s" % (timeout, self.state.t))

    # --- services

    def reset(self, scene="", bit_depth=0.0):
        """Back to the start of a scene file, by default of the present one; the state there. Set points are forgotten."""
        return self._rebuilt("reset_well", ResetWell, scene=scene, bit_depth=bit_depth)

    def load_survey(self, file="", **fields):
        """A new well, from a file or by the fields of LoadSurvey; the state at its start. Set points are forgotten."""
        return self._rebuilt("load_survey", LoadSurvey, file=file, **fields)

    def tare(self):
        """Zeroes surface WOB and differential pressure, off bottom; the state then."""
        self._call("tare", Trigger)
        return self._look()

    def save(self, name="", file=""):
        """A snapshot, by name in memory or in a file."""
        self._call("save_state", SaveState, name=name, file=file)

    def restore(self, name="", file=""):
        """Back to a snapshot; the state there."""
        return self._rebuilt("restore_state", RestoreState, name=name, file=file)

    def fault(self, fault, **fields):
        """Begins a fault, named as in InjectFault: rig.fault("STUCK_PIPE", depth=900.0)."""
        self._call("inject_fault", InjectFault, fault=getattr(InjectFaultRequest, fault), **fields)

    def clear_fault(self, fault, **fields):
        """Ends it."""
        self.fault(fault, clear=True, **fields)

    def slips(self, are_set):
        """Hangs the string in the slips or takes it from there."""
        self._call("set_slips", SetBool, data=are_set)

    def connection(self, joints=0):
        """Adds joints of drill pipe; 0: a stand."""
        self._call("make_connection", MakeConnection, joints=joints)

    # --- the connection

    def _frames_in(self, seconds):
        frames = seconds * self.rate
        if not (math.isfinite(frames) and frames >= 0.0 and abs(frames - round(frames)) < 1e-6 * max(1.0, frames)):
            raise ValueError("%r s is no whole number of frames of %g s" % (seconds, 1.0 / self.rate))
        return round(frames)

    def _look(self):
        """The state as it is; set points that wait for a frame go on waiting."""
        self.state = State(answered(self._step.call(StepSimulationRequest())))
        return self.state

    def _rebuilt(self, service, kind, **fields):
        self._call(service, kind, **fields)
        self._request = StepSimulationRequest()
        return self._look()

    def _call(self, service, kind, **fields):
        answered(rospy.ServiceProxy(self._prefix + "/" + service, kind)(**fields))


def answered(answer):
    """The answer of a service that has done what it was asked."""
    if not answer.success:
        raise Refused(answer.message)
    return answer


def frames_per_second(service):
    """The parameter ~rate of the node that offers the service, however that is called."""
    _, _, services = rosgraph.Master(rospy.get_name()).getSystemState()
    nodes = [node for name, providers in services if name == service for node in providers]
    return float(rospy.get_param(nodes[0] + "/rate", 100.0))
