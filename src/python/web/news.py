# SPDX-License-Identifier: BSD-3-Clause
"""What a source has for the feed since it was asked last."""
import math
import typing

from drill_rig_sim.msg import DrillstringState, RigDescription, RigLimits, RigState, RigTruth
from nav_msgs.msg import Path
from std_msgs.msg import String


class News(typing.NamedTuple):
    """`states`, `truth`: messages of rig_state and truth/rig_state as bytes, none left out. `last`: the latest STATE_KIND, or None. `latest`: the
    latest message by what it is: limits, description, scene, trajectory, string, margin (pull to yield [N]); or a path: drilled, planned. `rows`: states that are no messages, as
    Packed.rows() gives them."""
    states: list
    truth: list
    last: object
    latest: dict
    rows: object = None


class ReadSource:
    """A source that has been read: all of it at once. `name`: what the page calls it."""
    live = False

    def __init__(self, name, news):
        self.name, self._news = name, news

    def poll(self):
        news, self._news = self._news, News([], [], None, {})
        return news

    @staticmethod
    def status():
        return {"silent": None, "heard": True, "why": ""}


STATE, TRUTH = "rig_state", "truth/rig_state"
STATE_KIND, TRUTH_KIND = RigState, RigTruth
# by topic: what it is, its type; a string is shown with the strength of the parts described before it
TOPICS = {"rig_limits": ("limits", RigLimits), "scene": ("scene", String), "rig_description": ("description", RigDescription),
    "trajectory": ("trajectory", Path),
          "drillstring_state": ("string", DrillstringState)}


def margin_of(message, namespace):
    """`pull_to_yield` [N] of the node in this namespace ("/rig/"), of a DiagnosticArray; None where the message has none."""
    for status in message.status:
        if status.name.endswith(": physics") and ("/" + status.hardware_id).rpartition("/")[0] + "/" == namespace:
            for one in status.values:
                if one.key == "pull_to_yield" and math.isfinite(float(one.value)):
                    return float(one.value)
    return None
