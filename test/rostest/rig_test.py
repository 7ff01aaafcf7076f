# SPDX-License-Identifier: BSD-3-Clause
"""What the tests of the node share: a client of one rig, and how a test file runs."""
import os
import shutil
import sys
import threading
import time
import unittest
import xmlrpc.client

import rosgraph
import rospy
import rostest
from drill_rig_sim.msg import MudPumpCommand, RigState, TopDriveCommand, WinchCommand
from drill_rig_sim.srv import (DeleteState, InjectFault, ListStates, LoadSurvey, MakeConnection, ResetWell, RestoreState,
                               SaveState, SetSpeed, StepSimulation, StepSimulationRequest, TareOver)
from std_srvs.srv import SetBool, Trigger

PACKAGE_DIR = os.path.dirname(os.path.dirname(os.path.dirname(os.path.realpath(__file__))))
PATIENCE = 60.0  # wall seconds that anything may take on a loaded machine

SERVICES = {"reset_well": ResetWell, "load_survey": LoadSurvey, "pause": Trigger, "resume": Trigger, "tare": Trigger, "tare_over": TareOver,
            "step": StepSimulation, "set_speed": SetSpeed, "save_state": SaveState, "restore_state": RestoreState,
            "list_states": ListStates, "delete_state": DeleteState, "set_slips": SetBool, "make_connection": MakeConnection, "inject_fault": InjectFault}


def needs(case, *programs):
    """Skips the case where one of the programs is missing."""
    for program in programs:
        if shutil.which(program) is None:
            case.skipTest(program + " is not installed")


def runner(case):
    """The program drill. Skips the case where it is not built, as on Debian 11."""
    places = [os.path.join(place, "lib", "drill_rig_sim", "drill") for place in os.environ.get("CMAKE_PREFIX_PATH", "").split(":")]
    program = next((place for place in places if os.path.exists(place)), None)
    if program is None:
        case.skipTest("the runner drill is not built")
    return program


def wait_until(condition, what, patience=PATIENCE):
    """Returns what `condition()` gives, once it is true."""
    deadline = time.monotonic() + patience
    while time.monotonic() < deadline:
        result = condition()
        if result:
            return result
        time.sleep(0.02)
    raise AssertionError("not within %g s: %s" % (patience, what))


def publishers_know(topic):
    """Whether every node that publishes the topic has this one among its subscribers: from then on no message is missed. What this
    side knows is not enough: rospy counts a connection before the publisher has taken it up."""
    topic, me = rospy.resolve_name(topic), rospy.get_name()
    master = rosgraph.Master(me)
    nodes = dict(master.getSystemState()[0]).get(topic, [])
    for node in nodes:
        try:
            _, _, connections = xmlrpc.client.ServerProxy(master.lookupNode(node)).getBusInfo(me)
        except OSError:  # it died without leaving the master
            continue
        if not any(c[1] == me and c[2] == "o" and c[4] == topic for c in connections):
            return False
    return bool(nodes)


def address_of(node):
    """Of its XML-RPC server; "" while the master does not know it."""
    try:
        return rosgraph.Master(rospy.get_name()).lookupNode(node)
    except rosgraph.MasterError:
        return ""


def process_of(node):
    """Its process id. A node that was started again may not be known for a moment."""
    return xmlrpc.client.ServerProxy(wait_until(lambda: address_of(node), "the master knows %s" % node)).getPid(rospy.get_name())[2]


class Collector:
    """Keeps every message of a topic."""

    def __init__(self, topic, kind):
        self.messages = []
        self.changed = threading.Condition()
        self.subscriber = rospy.Subscriber(topic, kind, self.take, queue_size=None, tcp_nodelay=True)
        wait_until(lambda: publishers_know(topic), "connection to " + topic)

    def take(self, message):
        with self.changed:
            self.messages.append(message)
            self.changed.notify_all()

    def wait(self, count=1, patience=PATIENCE):
        """The messages, once there are `count`; as many as came otherwise."""
        return self.wait_until(lambda messages: len(messages) >= count, patience)

    def wait_until(self, condition, patience=PATIENCE):
        deadline = time.monotonic() + patience
        with self.changed:
            while not condition(self.messages) and time.monotonic() < deadline:
                self.changed.wait(0.1)
            return list(self.messages)

    def after(self, stamp, count=1):
        """The messages stamped later, once there are `count`. A message sent before may still be on its way: stamps tell, order of arrival does not."""
        def later(messages):
            return [m for m in messages if m.header.stamp > stamp]
        return later(self.wait_until(lambda messages: len(later(messages)) >= count))

    def at(self, stamp):
        """The message of this stamp."""
        messages = self.wait_until(lambda messages: messages and messages[-1].header.stamp >= stamp)
        return next(m for m in messages if m.header.stamp == stamp)

    def take_until(self, stamp):
        """The messages that have come up to this stamp, which are forgotten then."""
        messages = self.wait_until(lambda messages: messages and messages[-1].header.stamp >= stamp)
        with self.changed:
            del self.messages[:len(messages)]
        return messages

    def quiet(self, seconds=0.5):
        """Waits until nothing has come for so long, and forgets what came before."""
        deadline = time.monotonic() + PATIENCE
        with self.changed:
            while self.changed.wait(seconds) and time.monotonic() < deadline:
                pass
            self.messages = []

    def clear(self):
        with self.changed:
            self.messages = []


class Rig:
    """A client of the rig in a namespace."""

    def __init__(self, namespace="rig"):
        self.namespace = "/" + namespace
        for name, kind in SERVICES.items():
            rospy.wait_for_service(self.topic(name), PATIENCE)
            setattr(self, name, rospy.ServiceProxy(self.topic(name), kind))

    def topic(self, name):
        return self.namespace + "/" + name

    def collect(self, name, kind):
        return Collector(name if name.startswith("/") else self.topic(name), kind)

    def publisher(self, name, kind):
        """A publisher whose node listens already."""
        publisher = rospy.Publisher(self.topic(name), kind, queue_size=10)
        wait_until(publisher.get_num_connections, "connection to " + name)
        return publisher

    def next_frame_after(self, refused):
        """Lockstep: what `refused()` answers, and the numbers of the next frame with it and without it, from the same state. The
        last published record would show nothing: it is the one of before."""
        self.must(self.save_state("before", ""))
        expected = numbers(self.advance(1))
        self.must(self.restore_state("before", ""))
        before = self.advance(0).header.stamp
        answer = refused()
        after = self.advance(1)
        assert after.header.stamp - before == rospy.Duration(0, 10000000), "time moved by itself"
        return answer, expected, numbers(after)

    @staticmethod
    def must(answer):
        assert answer.success, answer.message

    def state(self):
        return rospy.wait_for_message(self.topic("rig_state"), RigState, PATIENCE)

    def advance(self, frames, **commands):
        """Lockstep: the readings after this number of frames."""
        return self.answer(frames, **commands).state

    def advance_truth(self, frames, **commands):
        """The same, but the truth."""
        return self.answer(frames, **commands).truth

    def answer(self, frames, winch=None, top_drive=None, mud_pump=None, steering=None):
        """Lockstep: the answer to this number of frames."""
        request = StepSimulationRequest(frames=frames)
        request.winch = [] if winch is None else [winch]
        request.top_drive = [] if top_drive is None else [top_drive]
        request.mud_pump = [] if mud_pump is None else [mud_pump]
        request.steering = [] if steering is None else [steering]
        answer = self.step(request)
        if not answer.success:
            raise AssertionError("step: " + answer.message)
        return answer


def winch(velocity, brake=False):
    return WinchCommand(block_velocity=velocity, brake=brake)


def turn(speed):
    return TopDriveCommand(mode=TopDriveCommand.SPEED, speed=speed)


def flow(rate):
    return MudPumpCommand(flow=rate)


def numbers(message):
    """All of a RigState but its stamps, epoch and count of refusals, as a tuple that compares bit by bit."""
    def flat(value):
        if hasattr(value, "__slots__"):
            for name in value.__slots__:
                if name not in ("header", "last_command", "epoch", "commands_refused", "last_refusal"):
                    yield from flat(getattr(value, name))
        elif isinstance(value, (list, tuple)):
            for item in value:
                yield from flat(item)
        else:
            yield value.hex() if isinstance(value, float) else value
    return tuple(flat(message))


def run(case, follows_clock=True):
    """Runs the test case of a file as rostest wants it. A test that counts /clock must not follow it: rospy's own subscription makes the
    queue one message long for the whole process, and under load some are overwritten."""
    name = os.path.basename(sys.argv[0]).replace(".py", "")
    rospy.init_node("test_" + name, anonymous=True, disable_rostime=not follows_clock)
    rostest.rosrun("drill_rig_sim", name, case)


__all__ = ["PACKAGE_DIR", "PATIENCE", "Collector", "Rig", "winch", "turn", "flow", "numbers", "process_of", "run", "unittest", "rospy", "time", "wait_until"]
