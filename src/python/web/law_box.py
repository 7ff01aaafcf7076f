# SPDX-License-Identifier: BSD-3-Clause
"""The package's autodriller and its connection, started, followed and stopped by pages; they drive the rig by topics as a node of launch does."""
import math
import threading

import rospy
from drill_rig_sim.autodriller import Autodriller
from drill_rig_sim.connection import Connection
from drill_rig_sim.law import RPM
from drill_rig_sim.lockstep import Refused
from drill_rig_sim.topics import Follower
from drill_rig_sim.web.law_points import LAW_POINTS
from drill_rig_sim.web.news import STATE_KIND
from drill_rig_sim.web.node_source import BEHIND, stamp_of
from drill_rig_sim.web.orders import number_of
from std_srvs.srv import Trigger

# what an order sets, in SI: its bounds, and whether it may be left out
BOUNDS = {**{point.order: (point.least, point.most, point.optional) for point in LAW_POINTS}, "stiffness": (1e4, 1e9, True)}
LOOPS = ("weight", "pressure", "torque")
TORQUE_PER_DIAMETER = 0.1    # of a newton on the bit [m/m], as in launch/autodriller.launch
STEEL = 2.06e11              # Young's modulus [Pa]
USUAL_STIFFNESS = 6e5        # of the string along its axis, where its parts are not known [N/m]
USUAL_BIT = 0.2159           # diameter where the scene is not known [m]
PRESSURE_PER_WEIGHT = 18.0   # where the motor is not known [Pa/N]
ANY = 1e12                   # a loop that is not wanted never leads


class LawBox:
    """`source`: NodeSource, which gives the states. `scene`: gives the parts of the scene's string, as dicts; `parts`: those of shapes.parts_of()."""

    def __init__(self, source, scene=lambda: [], parts=lambda: []):
        self.source, self.scene, self.parts = source, scene, parts
        self.follower, self.connects, self.settings, self.problem = None, False, {}, ""  # connects: the last law was a connection
        self.news, self.data = threading.Condition(), None

    @property
    def running(self):
        return self.follower is not None

    @property
    def rpm_after(self):
        """Rotary speed with which the rig goes on after the law [rad/s]."""
        return 0.0 if self.connects else self.settings["rpm"]

    def start(self, order):
        """By the numbers of BOUNDS. Refused where one runs already or a number is wrong."""
        self.must_be_free()
        depth = self.source.last.bit_depth if self.source.last is not None else 0.0
        self.settings = {"stiffness": stiffness_of(self.parts(), depth), **settings_of(order)}
        self.begin(law_of(self.settings, self.scene()))

    def connect(self):
        """Makes a connection."""
        self.must_be_free()
        self.begin(Connection())

    def must_be_free(self):
        if self.running:
            raise Refused("a connection is being made: stop it first" if self.connects else "the autodriller is already running")

    def begin(self, law):
        self.connects, self.follower, self.problem, self.data = isinstance(law, Connection), Follower(law), "", None
        self.source.on_state = self.take
        threading.Thread(target=self.run, args=(self.follower,), daemon=True).start()

    def set(self, order):
        """Other set points while it runs."""
        if not self.running or self.connects:
            raise Refused("a connection is being made: stop it first" if self.running else "the autodriller is not running")
        self.settings = settings_of({**self.settings, **order})
        law = self.follower.law
        for name in LOOPS:
            law.set_points[name] = self.settings.get(name, ANY)
        law.stall_pressure = stall_pressure_of(self.settings, self.scene())
        law.rop, law.to_depth, law.flow, law.rpm = (self.settings["rop"], self.settings["to_depth"], self.settings["flow"],
            self.settings["rpm"] / RPM)

    def stop(self):
        with self.news:
            follower, self.follower, self.source.on_state = self.follower, None, None
            self.news.notify_all()
        if follower is not None:
            follower.end()

    def take(self, data):
        """With each message of rig_state, in rospy's thread."""
        with self.news:
            self.data = data
            self.news.notify_all()

    def run(self, follower):
        """In a thread: the law uses only the latest state, and none that is late; then its commands stop, and the node sets the brake."""
        while self.follower is follower:
            with self.news:
                self.news.wait(0.5)
                data, self.data = self.data, None
            if data is None or self.source.lag() > BEHIND or not is_due(follower, stamp_of(data)):
                continue
            try:
                before = follower.law.phase
                follower.take(STATE_KIND().deserialize(data))
                if before == "zeroing" and follower.law.phase == "tagging":
                    rospy.ServiceProxy("tare", Trigger)()  # so that the rig's WOB has the zero that the law has
            except Exception as error:  # pylint: disable=broad-except
                if self.follower is not follower:  # stopped meanwhile, and perhaps another has begun
                    return
                self.problem = "the %s has failed: %s: %s" % ("connection" if self.connects else "autodriller", type(error).__name__, error)
                self.stop()

    def status(self):
        """For the pages."""
        follower = self.follower
        if follower is None:
            return {"running": False, "connects": False, "phase": "", "leads": "", "problem": self.problem, "settings": self.settings}
        law = follower.law
        if law.done:
            self.problem = end_of(law)
            self.stop()
        return {"running": not law.done, "connects": self.connects, "phase": law.phase.replace("_", " "), "leads": getattr(law, "winner", ""),
                "stalls": getattr(law, "stalls", 0), "problem": self.problem, "settings": self.settings}


def end_of(law):
    """Why a law has ended by itself; "" for a connection that is made."""
    if isinstance(law, Connection):
        return "the connection is given up: " + law.given_up if law.given_up else ""
    return "the autodriller has finished: the weight is drilled off"


def settings_of(order):
    """The numbers of BOUNDS that an order has."""
    missing = [name for name, (_, _, optional) in BOUNDS.items() if not optional and order.get(name) is None]
    if missing:
        raise Refused("needed: %s" % ", ".join(missing))
    return {name: number_of(order, name, low, high) for name, (low, high, _) in BOUNDS.items() if order.get(name) is not None}


def stiffness_of(parts, depth):
    """Of the string along its axis [N/m]: of its parts in series, as shapes.parts_of() gives them; pipe up to the surface is what is left of the bit's
    depth."""
    given = sum(part["length"] for part in parts)
    yielding = sum((part["length"] or max(depth - given, 1.0)) / (STEEL * 0.25 * math.pi * (part["diameter"]**2 - part["bore"]**2)) for part in parts)
    return 1.0 / yielding if yielding > 0.0 else USUAL_STIFFNESS


def is_due(follower, stamp):
    """Whether a law wants a state of this time: it is asked once a period, and of another run at once."""
    return follower.last is None or not follower.last <= stamp < follower.last + follower.law.period - 1e-6


def motor_of(parts):
    """The mud motor of a scene's string; {} without one."""
    return next((part for part in parts if part.get("type") == "mud_motor"), {})


def motor_pressure(motor, torque):
    """As mud_motor.h: what a torque [N m] needs [Pa]."""
    return 2.0 * math.pi * torque / (motor.get("efficiency", 1.0) * motor["displacement_per_rev"])


def stall_pressure_of(settings, parts):
    """Differential pressure by which the law knows a stalled motor [Pa]: by the motor's data, and at most half more than is asked for."""
    motor = motor_of(parts)
    stall = motor_pressure(motor, motor["stall_torque"]) if "stall_torque" in motor else math.inf
    return min(0.95 * stall, 1.5 * settings.get("pressure", math.inf))


def law_of(settings, parts):
    """The loops know what a newton on the bit adds to torque and pressure by the sizes of bit and motor."""
    bit, motor = next((part for part in parts if part.get("type") == "bit"), {}), motor_of(parts)
    torque = TORQUE_PER_DIAMETER * bit.get("diameter", USUAL_BIT)
    pressure = motor_pressure(motor, torque) if motor else PRESSURE_PER_WEIGHT
    return Autodriller({name: settings.get(name, ANY) for name in LOOPS}, settings["stiffness"], settings["rop"], settings["rpm"] / RPM,
                       settings["flow"], settings["to_depth"], stall_pressure=stall_pressure_of(settings, parts), pressure_per_weight=pressure,
                       torque_per_weight=torque)
