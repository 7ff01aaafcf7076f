# SPDX-License-Identifier: BSD-3-Clause
"""Commands to a live rig on behalf of the pages. Dead-man: the block moves while a page repeats its order, and streams of set points go on while a
page is alive. Where this process ends, the node's command_timeout sets the brake."""
import time

import rospy
from drill_rig_sim.lockstep import Refused
from drill_rig_sim.msg import MudPumpCommand, TopDriveCommand, WinchCommand
from drill_rig_sim.srv import MakeConnection, SetSpeed
from drill_rig_sim.topics import served
from drill_rig_sim.web.law_box import LawBox
from drill_rig_sim.web.orders import number_of
from drill_rig_sim.web.streams import Streams
from std_srvs.srv import SetBool, Trigger

HELD = 0.5   # without a repeated order for so long, the button counts as let go [wall s]
NO_PRESS = -1
MOST_PRESSES = 1e15
ALIVE = 3.0  # without a word of any page for so long, set points are not repeated any more [wall s]
SERVICES = {"pause": (Trigger, None), "resume": (Trigger, None), "tare": (Trigger, None), "set_slips": (SetBool, "data"),
            "set_speed": (SetSpeed, "speed"), "make_connection": (MakeConnection, "remove")}


class Hands:
    """`source`: NodeSource. `scene`, `parts`: as LawBox has them. Refused where an order cannot be obeyed."""

    def __init__(self, source, scene, streams=None, parts=lambda: []):
        self.source, self.law, self.streams = source, LawBox(source, scene, parts), streams or Streams()
        self.holder, self.held_at, self.heard_at, self.notes, self.law_ran = None, 0.0, 0.0, [], False
        self.press, self.tripped = NO_PRESS, None  # of the button that is held; page and press that the dead-man has ended
        source.on_join = self.streams.join

    # --- orders of a page

    def hold(self, page, order):
        """Repeated while a button is held: the block's velocity, + up [m/s]. `press`: a number of its own for each press of a button; one that the
        dead-man has ended stays ended, for the button may be let go long since."""
        velocity, press = number_of(order, "velocity", -3.0, 3.0), number_of(order, "press", 0.0, MOST_PRESSES)
        if (page, press) == self.tripped:
            return self.alive()
        if self.law.running:
            raise Refused("%s has the block: stop it first" % ("the connection" if self.law.connects else "the autodriller"))
        if self.holder not in (None, page):
            raise Refused("another page holds the block")
        self.streams.keep("winch", WinchCommand(block_velocity=velocity))
        self.holder, self.press, self.held_at = page, press, time.monotonic()
        return self.alive()

    def release(self, page, *_):
        if self.holder is not None and self.holder is page:
            self.holder = None
            self.streams.keep("winch", WinchCommand(brake=True))
        return ""

    def alive(self, *_):
        self.heard_at = time.monotonic()
        return ""

    def set(self, _, order):
        """Set points of top drive and pump: rpm [rad/s], flow [m3/s]."""
        if "rpm" in order:
            drive = TopDriveCommand(mode=TopDriveCommand.SPEED, speed=number_of(order, "rpm", -40.0, 40.0))
            if self.law.running:
                self.law.set({"rpm": drive.speed})
            else:
                self.streams.keep("top_drive", drive)
        if "flow" in order:
            flow = number_of(order, "flow", 0.0, 1.0)
            if self.law.running:
                self.law.set({"flow": flow})
            self.streams.publish("mud_pump", MudPumpCommand(flow=flow))
        return self.alive()

    def call(self, service, value):
        """What the service answers. `value`: its one field, where it has one."""
        if service not in SERVICES:
            raise Refused("no such service: %s" % service[:40])
        kind, field = SERVICES[service]
        fields = {}
        if field is not None:
            fields[field] = number_of({field: value}, field, 0.0, 1e3) if service == "set_speed" else bool(value)
        answer = served(rospy.ServiceProxy(service, kind), **fields)
        return "%s: %s" % (service, answer.message or "done")

    def start_law(self, _, order):
        self.law.start(order)
        return self._hand_over()

    def connect(self, *_):
        """A connection, by the crew."""
        self.law.connect()
        return self._hand_over()

    def _hand_over(self):
        self.holder, self.law_ran = None, True
        self.streams.drop("winch", "top_drive")  # they are the law's now
        return self.alive()

    def set_law(self, _, order):
        self.law.set(order)
        return self.alive()

    def stop_law(self, *_):
        self.law.stop()
        return self.alive()

    def _take_over(self):
        """After the law: brake, the drive goes on as it turned."""
        self.law_ran = False
        self.streams.keep("winch", WinchCommand(brake=True))
        self.streams.keep("top_drive", TopDriveCommand(mode=TopDriveCommand.SPEED, speed=self.law.rpm_after))

    # --- time

    def left(self, page):
        self.release(page)

    def tick(self):
        """With each period: messages for all pages."""
        now, law, ended = time.monotonic(), self.law.status(), []
        if self.law_ran and not law["running"]:
            self._take_over()
        if self.holder is not None and now > self.held_at + HELD:
            self.tripped = (self.holder, self.press)
            self.release(self.holder)
            ended = [{"type": "press_ended", "press": self.press}]
            self.notes.append("dead-man: brake set %.2f s after the page's last command; press again to move the block" % (now - self.held_at))
        if self.streams.kept and now > self.heard_at + ALIVE:
            self.streams.drop("winch", "top_drive")
            self.notes.append("dead-man: no page is open, set points are no longer repeated")
        lost = self.streams.repeat(self.source.last)
        notes, self.notes = self.notes + ["another controller has taken over: %s" % name.replace("_", " ") for name in lost], []
        return [{"type": "law", **law}, *ended, *({"type": "answer", "text": note} for note in notes)]
