# SPDX-License-Identifier: BSD-3-Clause
"""Set points that are repeated. To the node, a stream of commands that falls silent is a lost controller: it sets the brake and lets the drive
coast."""
import time

import rospy
from drill_rig_sim.lockstep import Refused
from drill_rig_sim.rig import COMMANDS

FOREIGN = 1.0  # another set point in force for so long is another controller's: it is left the rig [wall s]


class Streams:
    """Publishes commands by their names in COMMANDS, and repeats those that were given to keep()."""

    def __init__(self):
        self.publishers, self.kept, self.differs_since = {}, {}, {}

    def join(self):
        """A master has come, or another one."""
        for publisher in self.publishers.values():
            publisher.unregister()
        self.publishers = {name: rospy.Publisher(name + "/command", kind, queue_size=1) for name, kind in COMMANDS.items()}

    def publish(self, name, message):
        if name not in self.publishers:
            raise Refused("there is no ROS master yet")
        self.publishers[name].publish(message)

    def keep(self, name, message):
        """Publishes it, and repeats it from now on."""
        self.publish(name, message)
        self.kept[name] = message
        self.differs_since.pop(name, None)

    def drop(self, *names):
        for name in names:
            self.kept.pop(name, None)

    def repeat(self, state):
        """All that is kept. `state`: the latest RigState or None. Names of those that another controller has taken over, which are dropped."""
        lost = [name for name, message in self.kept.items() if self._is_foreign(name, message, state)]
        self.drop(*lost)
        for name, message in self.kept.items():
            self.publish(name, message)
        return lost

    def _is_foreign(self, name, message, state):
        if state is None or state.current_operation or same(name, message, getattr(state, name)):
            self.differs_since.pop(name, None)
            return False
        return time.monotonic() - self.differs_since.setdefault(name, time.monotonic()) > FOREIGN


def same(name, one, other):
    """Whether two set points of winch or top drive ask for the same."""
    if name == "winch":
        return one.brake == other.brake and (one.brake or one.block_velocity * other.block_velocity >= 0.0)
    return one.mode == other.mode and abs(one.speed - other.speed) < 1e-6
