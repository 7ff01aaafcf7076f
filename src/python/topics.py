# SPDX-License-Identifier: BSD-3-Clause
"""Control laws by topics (drill_rig_sim.control says what a law is): what a controller of a real rig would do."""
import time

import rospy
from drill_rig_sim.control import NewRuns, Readings, asked, pipe_work
from drill_rig_sim.lockstep import MODES, Refused, arrived
from drill_rig_sim.msg import DownholeDynamics, MudPumpCommand, MwdInclination, MwdSurvey, MwdToolface, RigState, SteeringCommand, TopDriveCommand, WinchCommand
from drill_rig_sim.rig import COMMANDS, answered
from drill_rig_sim.srv import MakeConnection
from drill_rig_sim.status import Status
from std_srvs.srv import SetBool


class Telemetry:
    """The last toolface, survey, inclination and dynamics that came up, of the messages' fields and the time `t` of measurement [s]; None before."""
    TOPICS = {"toolface": ("toolface", MwdToolface), "survey": ("mwd", MwdSurvey), "inclination": ("inclination", MwdInclination),
              "dynamics": ("dynamics", DownholeDynamics)}

    def __init__(self, prefix=""):
        self.toolface = self.survey = self.inclination = self.dynamics = None
        self._subscribers = [rospy.Subscriber(prefix + "downhole/" + topic, kind, lambda m, name=name: setattr(self, name, arrived(m)), tcp_nodelay=True)
                             for name, (topic, kind) in self.TOPICS.items()]

    def begin_again(self, now):
        """Forgets what is of a run before the one that begins at `now` [s]."""
        for name in self.TOPICS:
            last = getattr(self, name)
            if last is not None and last.t > now:
                setattr(self, name, None)


def messages_of(commands):
    """The set points that a law asks for, by their names in StepSimulation."""
    messages = {}
    if commands.brake or commands.block_velocity is not None:
        messages["winch"] = WinchCommand(block_velocity=commands.block_velocity or 0.0, brake=commands.brake)
    if commands.top_drive is not None:
        messages["top_drive"] = TopDriveCommand(**{**commands.top_drive, "mode": MODES[commands.top_drive["mode"]]})
    if commands.flow is not None:
        messages["mud_pump"] = MudPumpCommand(flow=commands.flow)
    if commands.steering is not None:
        messages["steering"] = SteeringCommand(toolface=commands.steering[0], ratio=commands.steering[1])
    return messages


class Follower:
    """A law that is asked with the first state of each of its periods, and whose commands and status are published."""

    def __init__(self, law):
        self.status, self.header = Status(law), None
        self.law, self.runs, self.telemetry, self.last, self.refused = law, NewRuns(law), Telemetry(), None, ""
        self.slips, self.connection = rospy.ServiceProxy("set_slips", SetBool), rospy.ServiceProxy("make_connection", MakeConnection)
        self.publishers = {name: rospy.Publisher(name + "/command", kind, queue_size=1) for name, kind in COMMANDS.items()}

    def take(self, state):
        now = state.header.stamp.to_sec()
        if self.runs.begins(now, state.epoch):
            self.begin_again(now)
        if self.law.done or (self.last is not None and now < self.last + self.law.period - 1e-6):
            return
        self.last, self.header = now, state.header
        commands = asked(self.law, Readings(now, state, self.telemetry, self.refused))
        for name, message in messages_of(commands).items():
            self.publishers[name].publish(message)
        self.status.publish(state.header)
        self.refused = pipe_work(commands, lambda are_set: served(self.slips, are_set), lambda **fields: served(self.connection, **fields))

    def end(self):
        """The law commands the rig no more."""
        if self.header is not None:
            self.status.end(self.header)

    def begin_again(self, now):
        rospy.logwarn("the rig begins a new run at %.2f s: %s" % (now, "the law continues, because it cannot be copied (%s)" % self.runs.problem
                                                                  if self.runs.problem else "the law begins again"))
        self.last, self.refused = None, ""
        self.telemetry.begin_again(now)


def served(service, *words, **fields):
    """Asks a service; Refused where it is not there, as while the node is started again, or refuses."""
    try:
        return answered(service(*words, **fields))
    except rospy.ServiceException as error:
        raise Refused(str(error)) from error


def follow(law):
    """By topics, in the node's namespace: a step with the first state of each period; returns once the law is done. Where the rig begins a new run, so
    does the law (drill_rig_sim.control.NewRuns)."""
    follower = Follower(law)
    subscriber = rospy.Subscriber("rig_state", RigState, follower.take, queue_size=1, tcp_nodelay=True)
    while not (law.done or rospy.is_shutdown()):
        time.sleep(0.05)
    subscriber.unregister()
    follower.end()
