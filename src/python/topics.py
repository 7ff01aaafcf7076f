"""Control laws by topics (drill_rig_sim.control says what a law is): what a controller of a real rig would do."""
import time
import types

import rospy
from drill_rig_sim.control import Readings, asked, pipe_work
from drill_rig_sim.lockstep import MODES
from drill_rig_sim.msg import MudPumpCommand, MwdSurvey, MwdToolface, RigState, SteeringCommand, TopDriveCommand, WinchCommand
from drill_rig_sim.rig import COMMANDS, answered
from drill_rig_sim.srv import MakeConnection
from std_srvs.srv import SetBool

PATIENCE = 0.004  # wall time that telemetry may take to come from the rig's node, beside the answers of its steps: once a second [s]


class Telemetry:
    """The last toolface and survey that came up, of the messages' fields and the time `t` of measurement [s]; None before."""

    def __init__(self, prefix=""):
        self.toolface = self.survey = None
        self._subscribers = [rospy.Subscriber(prefix + "downhole/toolface", MwdToolface, lambda m: setattr(self, "toolface", arrived(m)), tcp_nodelay=True),
                             rospy.Subscriber(prefix + "downhole/mwd", MwdSurvey, lambda m: setattr(self, "survey", arrived(m)), tcp_nodelay=True)]

    @staticmethod
    def listen(now, period):
        """Lockstep, before each step of a law: leaves what is on its way the time to arrive."""
        if int(now) > int(now - period):
            time.sleep(PATIENCE)


def arrived(message):
    fields = {name: getattr(message, name) for name in message.__slots__ if name != "header"}
    return types.SimpleNamespace(t=message.header.stamp.to_sec(), **fields)


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


def follow(law):
    """By topics, in the node's namespace: a step with the first state of each period; returns once the law is done."""
    telemetry, last, refused = Telemetry(), [None], [""]
    slips, connection = rospy.ServiceProxy("set_slips", SetBool), rospy.ServiceProxy("make_connection", MakeConnection)
    publishers = {name: rospy.Publisher(name + "/command", kind, queue_size=1) for name, kind in COMMANDS.items()}

    def take(state):
        now = state.header.stamp.to_sec()
        if law.done or (last[0] is not None and now < last[0] + law.period - 1e-6):
            return
        last[0] = now
        commands = asked(law, Readings(now, state, telemetry, refused[0]))
        for name, message in messages_of(commands).items():
            publishers[name].publish(message)
        refused[0] = pipe_work(commands, lambda are_set: answered(slips(are_set)), lambda **fields: answered(connection(**fields)))

    subscriber = rospy.Subscriber("rig_state", RigState, take, queue_size=1, tcp_nodelay=True)
    while not (law.done or rospy.is_shutdown()):
        time.sleep(0.05)
    subscriber.unregister()
