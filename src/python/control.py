"""Runs a control law against a rig. A law is a plain class without ROS:

    commands = law.step(readings)    # every law.period of simulated time [s]; until law.done

`readings` has the fields of RigState, `t` [s], `toolface` and `survey`: the last of each that came up, or None, and `refused`: why the slips or the connection
asked for last were not (else ""). What a rig cannot sense is not in it.
The same law runs in lockstep (`drive`) and by topics (`follow`).
"""
import time

import rospy
from drill_rig_sim.msg import MudPumpCommand, MwdSurvey, MwdToolface, RigState, SteeringCommand, TopDriveCommand, WinchCommand
from drill_rig_sim.rig import UNSENSED, Refused, answered
from drill_rig_sim.srv import MakeConnection
from std_srvs.srv import SetBool

PATIENCE = 0.004  # wall time that telemetry may take to come from the rig's node, beside the answers of its steps: once a second [s]


class Readings:
    """Of one instant."""

    def __init__(self, state, telemetry, refused=""):
        self._state, self.refused = state, refused
        self.t = state.header.stamp.to_sec()
        self.toolface, self.survey = telemetry.toolface, telemetry.survey

    def __getattr__(self, name):
        if name in UNSENSED:
            raise AttributeError("%s: no rig can sense it" % name)
        return getattr(self._state, name)


class Telemetry:
    """The last toolface and survey that came up."""

    def __init__(self, prefix=""):
        self.toolface = self.survey = None
        self._subscribers = [rospy.Subscriber(prefix + "downhole/toolface", MwdToolface, lambda m: setattr(self, "toolface", m), tcp_nodelay=True),
                             rospy.Subscriber(prefix + "downhole/mwd", MwdSurvey, lambda m: setattr(self, "survey", m), tcp_nodelay=True)]


class Deaf:
    """In the place of Telemetry, for a law that needs none."""
    toolface = survey = None


class Ordered:
    """A law whose operator changes his mind: rows of time since its first step [s], set point and value, of law.set_points."""

    def __init__(self, law, orders):
        self._law, self._orders, self._begin = law, sorted(orders), None

    def __getattr__(self, name):
        return getattr(self._law, name)

    def step(self, readings):
        self._begin = readings.t if self._begin is None else self._begin
        while self._orders and readings.t - self._begin >= self._orders[0][0]:
            _, name, value = self._orders.pop(0)
            self._law.set_points[name] = value
        return self._law.step(readings)


def top_drive_command(fields):
    return TopDriveCommand(**{**fields, "mode": getattr(TopDriveCommand, fields["mode"])})


def hand_over(rig, commands):
    """Set points for the next step of a drill_rig_sim.rig.Rig; why slips or connection were refused, or ""."""
    if commands.brake:
        rig.brake()
    elif commands.block_velocity is not None:
        rig.winch(commands.block_velocity)
    if commands.top_drive is not None:
        rig.top_drive(**vars_of(top_drive_command(commands.top_drive)))
    if commands.flow is not None:
        rig.pump(commands.flow)
    if commands.steering is not None:
        rig.steer(*commands.steering)
    return pipe_work(commands, rig.slips, rig.connection)


def pipe_work(commands, slips, connection):
    """Slips and connection, by two functions that may raise Refused; why they were refused, or ""."""
    try:
        if commands.slips is not None:
            slips(commands.slips)
        if commands.connection:
            connection()
    except Refused as refusal:
        return str(refusal)
    return ""


def vars_of(message):
    return {name: getattr(message, name) for name in message.__slots__ if name != "header"}


def drive(rig, law, timeout, telemetry=Deaf, judge=None):
    """Lockstep: steps the rig under the law until that is done, or for `timeout` simulated seconds; the states after each of its periods.
    `judge`: called with each state, to look at the law meanwhile or to break the rig."""
    states, every, refused = [], max(1, round(law.period * rig.rate)), ""
    for _ in range(int(timeout * rig.rate / every)):
        if law.done:
            break
        if telemetry is not Deaf and int(rig.state.t) > int(rig.state.t - law.period):
            time.sleep(PATIENCE)
        refused = hand_over(rig, law.step(Readings(rig.state.readings, telemetry, refused)))
        states.append(rig.step(frames=every))
        if judge is not None:
            judge(states[-1])
    return states


def follow(law):
    """By topics, in the node's namespace: a step with the first state of each period; returns once the law is done."""
    telemetry, last, refused = Telemetry(), [None], [""]
    slips, connection = rospy.ServiceProxy("set_slips", SetBool), rospy.ServiceProxy("make_connection", MakeConnection)
    winch = rospy.Publisher("winch/command", WinchCommand, queue_size=1)
    top_drive = rospy.Publisher("top_drive/command", TopDriveCommand, queue_size=1)
    pump = rospy.Publisher("mud_pump/command", MudPumpCommand, queue_size=1)
    steering = rospy.Publisher("steering/command", SteeringCommand, queue_size=1)

    def take(state):
        now = state.header.stamp.to_sec()
        if law.done or (last[0] is not None and now < last[0] + law.period - 1e-6):
            return
        last[0] = now
        commands = law.step(Readings(state, telemetry, refused[0]))
        if commands.brake or commands.block_velocity is not None:
            winch.publish(WinchCommand(block_velocity=commands.block_velocity or 0.0, brake=commands.brake))
        if commands.top_drive is not None:
            top_drive.publish(top_drive_command(commands.top_drive))
        if commands.flow is not None:
            pump.publish(MudPumpCommand(flow=commands.flow))
        if commands.steering is not None:
            steering.publish(SteeringCommand(toolface=commands.steering[0], ratio=commands.steering[1]))
        refused[0] = pipe_work(commands, lambda are_set: answered(slips(are_set)), lambda: answered(connection()))

    subscriber = rospy.Subscriber("rig_state", RigState, take, queue_size=1, tcp_nodelay=True)
    while not (law.done or rospy.is_shutdown()):
        time.sleep(0.05)
    subscriber.unregister()
