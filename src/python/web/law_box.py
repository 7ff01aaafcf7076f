"""The package's autodriller, started, followed and stopped by pages; it drives the rig by topics as a node of launch/autodriller.launch does."""
import math
import struct

from drill_rig_sim.autodriller import Autodriller
from drill_rig_sim.law import RPM
from drill_rig_sim.lockstep import Refused
from drill_rig_sim.topics import Follower
from drill_rig_sim.web.news import STATE_KIND
from drill_rig_sim.web.orders import number_of

# what a page sets, in SI: its bounds, and whether it may be left out
BOUNDS = {"weight": (1e3, 1e6, False), "rop": (1e-4, 0.1, False), "pressure": (1e4, 5e7, True), "torque": (10.0, 2e5, True),
    "rpm": (0.0, 40.0, False),
          "flow": (0.0, 1.0, False), "to_depth": (0.0, 2e4, False), "stiffness": (1e4, 1e9, False)}
LOOPS = ("weight", "pressure", "torque")
TORQUE_PER_WEIGHT = 0.022    # of a newton on the bit [m], as in launch/autodriller.launch
PRESSURE_PER_WEIGHT = 18.0   # [Pa/N]
ANY = 1e12                   # a loop that is not wanted never leads


class LawBox:
    """`source`: NodeSource, which gives the states."""

    def __init__(self, source):
        self.source, self.follower, self.settings, self.problem = source, None, {}, ""

    @property
    def running(self):
        return self.follower is not None

    def start(self, order):
        """By the numbers of BOUNDS. Refused where one runs already or a number is wrong."""
        if self.running:
            raise Refused("the autodriller runs already")
        self.settings = settings_of(order)
        self.follower, self.problem = Follower(law_of(self.settings)), ""
        self.source.on_state = self.take

    def set(self, order):
        """Other set points while it runs."""
        if not self.running:
            raise Refused("the autodriller does not run")
        self.settings = settings_of({**self.settings, **order})
        law = self.follower.law
        for name in LOOPS:
            law.set_points[name] = self.settings.get(name, ANY)
        law.stall_pressure = stall_pressure_of(self.settings)
        law.rop, law.to_depth, law.flow, law.rpm = (self.settings["rop"], self.settings["to_depth"], self.settings["flow"],
            self.settings["rpm"] / RPM)

    def stop(self):
        self.follower, self.source.on_state = None, None

    def take(self, data):
        """With each message of rig_state, in rospy's thread: most come between two steps of the law and are not looked into."""
        follower = self.follower
        if follower is None:
            return
        seconds, nanoseconds = struct.unpack_from("<II", data, 4)
        now = seconds + 1e-9 * nanoseconds
        if follower.last is not None and follower.last <= now < follower.last + follower.law.period - 1e-6:
            return
        try:
            follower.take(STATE_KIND().deserialize(data))
        except Exception as error:  # pylint: disable=broad-except
            self.problem = "the autodriller has failed: %s: %s" % (type(error).__name__, error)
            self.stop()

    def status(self):
        """For the pages."""
        follower = self.follower
        if follower is None:
            return {"running": False, "phase": "", "leads": "", "problem": self.problem, "settings": self.settings}
        law = follower.law
        if law.done:
            self.problem = "the autodriller is done: the weight is drilled off"
            self.stop()
        return {"running": not law.done, "phase": law.phase.replace("_", " "), "leads": law.winner, "stalls": law.stalls, "problem": self.problem,
                "settings": self.settings}


def settings_of(order):
    """The numbers of BOUNDS that an order has."""
    missing = [name for name, (_, _, optional) in BOUNDS.items() if not optional and order.get(name) is None]
    if missing:
        raise Refused("needed: %s" % ", ".join(missing))
    return {name: number_of(order, name, low, high) for name, (low, high, _) in BOUNDS.items() if order.get(name) is not None}


def law_of(settings):
    return Autodriller({name: settings.get(name, ANY) for name in LOOPS}, settings["stiffness"], settings["rop"], settings["rpm"] / RPM,
        settings["flow"],
                       settings["to_depth"], stall_pressure=stall_pressure_of(settings), pressure_per_weight=PRESSURE_PER_WEIGHT,
                       torque_per_weight=TORQUE_PER_WEIGHT)


def stall_pressure_of(settings):
    """By which the law knows a stalled motor: half more than is asked for [Pa]."""
    return 1.5 * settings["pressure"] if "pressure" in settings else math.inf
