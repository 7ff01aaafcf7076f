# SPDX-License-Identifier: BSD-3-Clause
"""Topic controller/status: what a control law does and asks for, for displays, logs and other controllers."""
import atexit
import math
import re
import threading
import time

import rospy
from drill_rig_sim.law import RPM
from drill_rig_sim.msg import ControllerStatus
from geometry_msgs.msg import Point

TOPIC = "controller/status"
NO_LIMIT = 1e11       # a set point beyond is none
PLAN_SPACING = 10.0   # between points of a plan [m]
SENDING = 0.3         # that rospy's threads take to send a message [s]


class Status:
    """Publishes the status of a law, latched, where it has changed. `law`: as drill_rig_sim.control says."""
    ended_at = -math.inf  # when the last law of this process ended [s]

    def __init__(self, law):
        self.law, self.last, self.plan = law, None, plan_of(law)
        self.lock, self.ended = threading.Lock(), False
        self.publisher = rospy.Publisher(TOPIC, ControllerStatus, queue_size=1, latch=True)

    def publish(self, header):
        """`header`: of the rig_state that the law goes by. After end() nothing is published."""
        with self.lock:
            if not self.ended:
                self._publish(header)

    def end(self, header):
        """The law commands the rig no more."""
        with self.lock:
            self.ended = True
            self._publish(header)
            Status.ended_at = time.monotonic()

    def _publish(self, header):
        message = status_of(self.law, not self.ended)
        message.plan = self.plan
        if message == self.last:
            return
        self.last = message
        self.publisher.publish(ControllerStatus(header, *(getattr(message, name) for name in message.__slots__[1:])))


@atexit.register
def wait_until_sent():
    """A process that ends at once after its law has not sent the last status yet. Runs before rospy closes its connections, as it was registered later."""
    time.sleep(max(0.0, Status.ended_at + SENDING - time.monotonic()))


def status_of(law, running):
    """A ControllerStatus without header and plan. A law of the package has an autodriller inside or is one."""
    driller = getattr(law, "driller", law)
    points = set_points_of(law, driller)
    return ControllerStatus(law=name_of(law), running=running, phase=str(getattr(law, "phase", "")).replace("_", " "),
                            leads=str(getattr(driller, "winner", "")), given_up=str(getattr(law, "given_up", "")),
                            set_point=list(points), value=list(points.values()))


def name_of(law):
    """Its class in small letters: "rss_steering"."""
    return re.sub(r"(?<=[a-z0-9])(?=[A-Z])", "_", type(getattr(law, "inner", law)).__name__).lower()


def set_points_of(law, driller):
    """By their names in ControllerStatus, in SI."""
    points = dict(getattr(law, "set_points", {}))
    points.update({name: getattr(driller, name) for name in ("rop", "rpm", "flow", "to_depth") if hasattr(driller, name) and name not in points})
    if "rpm" in points:
        points["rotary_speed"] = points.pop("rpm") * RPM
    return {name: float(value) for name, value in points.items() if abs(value) < NO_LIMIT}


def plan_of(law):
    """Points of the planned path of a law that steers; [] without one."""
    plan = getattr(law, "plan", None)
    return [] if plan is None else [Point(*(float(x) for x in point)) for point in plan.points(PLAN_SPACING)]
