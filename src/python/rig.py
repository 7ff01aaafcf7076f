# SPDX-License-Identifier: BSD-3-Clause
"""A rig in lockstep (rig.launch clock:=lockstep), for tests of controllers in few lines:

    from drill_rig_sim.rig import Rig

    rig = Rig("rig")
    rig.rotate(rpm=90)
    rig.winch(-0.01)
    rig.step_until(lambda s: s.truth.on_bottom, timeout=300)

drill_rig_sim.sim has the same without a node.
"""
import threading
import time

import actionlib
import rosgraph
import rospy
from actionlib_msgs.msg import GoalStatus
from drill_rig_sim.lockstep import RPM, UNSENSED, Lockstep, Refused, State, TimedOut, arrived, series, yaml_of, zero_of  # pylint: disable=unused-import
from drill_rig_sim.msg import MudPumpCommand, RunOperationsAction, RunOperationsGoal, SteeringCommand, TopDriveCommand, WinchCommand
from drill_rig_sim.srv import (InjectFault, InjectFaultRequest, LoadSurvey, MakeConnection, ResetWell, RestoreState, SaveState, StepSimulation,
                               StepSimulationRequest, TareOver)
from std_srvs.srv import SetBool, Trigger

COMMANDS = {"winch": WinchCommand, "top_drive": TopDriveCommand, "mud_pump": MudPumpCommand, "steering": SteeringCommand}
UNDER_WAY = (GoalStatus.PENDING, GoalStatus.ACTIVE)
ASK_AGAIN = 2.0  # between looks whether a node that is waited for still answers [wall s]


class Lost(Exception):
    """The node does not answer any more: it has ended, or the connection to it has. What the last call did is not known."""


def wait_for_service(name, patience):
    """Until a service is there, `patience` wall seconds at most. Without a node rospy gives up while there is no master: its warning needs a node's time."""
    end = time.monotonic() + patience
    while True:
        try:
            return rospy.wait_for_service(name, max(end - time.monotonic(), 0.1))
        except rospy.ROSInitException as error:
            if time.monotonic() > end:
                raise rospy.ROSException("no ROS master at %s within %g s" % (rosgraph.get_master_uri(), patience)) from error
            time.sleep(0.3)


class Rig(Lockstep):
    """The rig of a namespace, in lockstep. `patience`: wall seconds to wait for it. A call during which its node ends, or after that, raises Lost."""

    def __init__(self, namespace="rig", patience=60.0):
        self._prefix = rospy.resolve_name(namespace)
        wait_for_service(self._prefix + "/step", patience)
        self._step = rospy.ServiceProxy(self._prefix + "/step", StepSimulation, persistent=True)
        self._request = StepSimulationRequest()
        self._telemetry = {"toolface": None, "survey": None, "inclination": None, "dynamics": None}
        self._operations = self._goal = None  # the client of the action run_operations, and its last goal
        self.rate = frames_per_second(self._prefix + "/step")
        self._look()

    # --- what downhole tools sent up, for drill_rig_sim.control.drive(rig, law, timeout, telemetry=rig)

    @property
    def toolface(self):
        """The last that came up, fields of MwdToolface and the time `t` of measurement [s]; None before."""
        return self._telemetry["toolface"]

    @property
    def survey(self):
        """The last that came up, fields of MwdSurvey and the time `t` of measurement [s]; None before."""
        return self._telemetry["survey"]

    @property
    def inclination(self):
        """The last between surveys that came up, fields of MwdInclination and the time `t` of measurement [s]; None before."""
        return self._telemetry["inclination"]

    @property
    def dynamics(self):
        """The last of the tool of dynamics that came up, fields of DownholeDynamics and the time `t` of its interval's end [s]; None before."""
        return self._telemetry["dynamics"]

    # --- services

    def reset(self, scene="", bit_depth=0.0):
        """Back to the start of a scene file, by default of the present one; the state there. Set points are forgotten."""
        return self._rebuilt("reset_well", ResetWell, scene=scene, bit_depth=bit_depth)

    def load_survey(self, file="", **fields):
        """A new well, from a file or by the fields of LoadSurvey; the state at its start. Set points are forgotten."""
        return self._rebuilt("load_survey", LoadSurvey, file=file, **fields)

    @property
    def accuracy_warning(self):
        """Why the last frame's numbers may be wrong, in one line; "" without a reason."""
        return self.state.accuracy_reason

    @property
    def accuracy_code(self):
        """Its short identifier, which stays the same in later versions (msg/README.md lists them); "" without a reason."""
        return self.state.accuracy_code

    @property
    def active_faults(self):
        """The faults under way, by their words in scenes, those of gauges as "sensor_bias of hook_load"."""
        return self.state.truth.active_faults

    def tare(self):
        """Zeroes surface WOB and differential pressure, off bottom; the state then."""
        self._call("tare", Trigger)
        return self._look()

    def tare_over(self, duration):
        """The same at their means over the last `duration` seconds, 0.5 to 60; what was zeroed, a Zero."""
        zero = zero_of(self._call("tare_over", TareOver, duration=duration))
        self._look()
        return zero

    def save(self, name="", file=""):
        """A snapshot, by name in memory or in a file."""
        self._call("save_state", SaveState, name=name, file=file)

    def restore(self, name="", file=""):
        """Back to a snapshot; the state there."""
        return self._rebuilt("restore_state", RestoreState, name=name, file=file)

    def fault(self, fault, clear=False, **fields):
        """Begins a fault, named as in InjectFault: rig.fault("STUCK_PIPE", depth=900.0)."""
        self._call("inject_fault", InjectFault, fault=getattr(InjectFaultRequest, fault), clear=clear, **fields)

    def slips(self, are_set):
        """Hangs the string in the slips or takes it from there."""
        self._call("set_slips", SetBool, data=are_set)

    def connection(self, joints=0, remove=False):
        """Adds joints of drill pipe, or removes them; 0: a stand."""
        self._call("make_connection", MakeConnection, joints=joints, remove=remove)

    def operate(self, operations):
        """The driller begins operations, one after the other, as a scene has them: {"do": "trip", "to_depth": 1200}, a list of such, or their YAML. The reading
        operation_number is 0 once all are finished. A set point takes over the rig from them."""
        self._advance(0)
        if not self._operations:
            self._operations = actionlib.ActionClient(self._prefix + "/run_operations", RunOperationsAction)
        self._operations.wait_for_server()
        begun = threading.Event()
        # a simple client loses the state of a goal that is refused before send_goal() returns
        self._goal = goal = self._operations.send_goal(RunOperationsGoal(operations=yaml_of(operations)), feedback_cb=lambda *_: begun.set())
        self._wait_while(lambda: not begun.is_set() and goal.get_goal_status() in UNDER_WAY)
        if self.given_up:
            raise Refused(self.given_up)
        return self._look()

    @property
    def given_up(self):
        """Why the operation under way was given up, the block braked; "": it was not."""
        goal = self._goal
        if not goal or goal.get_goal_status() != GoalStatus.ABORTED:
            return ""
        self._wait_while(lambda: goal.get_result() is None)  # a topic of its own, which may be later than the state's
        return goal.get_result().message

    # --- the connection

    def _set(self, kind, **fields):
        setattr(self._request, kind, [COMMANDS[kind](**fields)])

    def _wait_while(self, condition):
        asked = time.monotonic()
        while condition():
            time.sleep(0.01)
            if time.monotonic() > asked + ASK_AGAIN:
                asked = time.monotonic()
                self._look()  # raises Lost where the node is gone

    def _advance(self, frames):
        self._request.frames = frames
        request, self._request = self._request, StepSimulationRequest()
        return self._asked(request)

    def _look(self):
        """The state as it is; set points that wait for a frame go on waiting."""
        self.state = self._asked(StepSimulationRequest())
        return self.state

    def _asked(self, request):
        answer = self._served("step", lambda: self._step.call(request))
        for name in self._telemetry:
            self._take(name, getattr(answer, name))
        return State(answer.state.header.stamp.to_sec(), answer.state, answer.truth, answer.bit)

    def _take(self, name, messages):
        """The last of a kind of telemetry, none or one: the same object until another has come."""
        now = arrived(messages[0]) if messages else None
        if now != self._telemetry[name]:
            self._telemetry[name] = now

    def _rebuilt(self, service, kind, **fields):
        self._call(service, kind, **fields)
        self._request = StepSimulationRequest()
        return self._look()

    def _call(self, service, kind, **fields):
        return self._served(service, lambda: rospy.ServiceProxy(self._prefix + "/" + service, kind)(**fields))

    def _served(self, service, ask):
        """The answer that `ask` gets from a service."""
        try:
            return answered(ask())
        except (rospy.ServiceException, rospy.exceptions.TransportException, OSError) as error:
            after = " after t = %g s" % self.state.t if hasattr(self, "state") else ""
            raise Lost("%s/%s: the node does not answer%s (%s); start it again and make a new Rig" % (self._prefix, service, after, error)) from None


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
