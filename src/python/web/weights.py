# SPDX-License-Identifier: BSD-3-Clause
"""Weights of the string that a run has shown: steady pick-up, slack-off and rotating off bottom, as `drill weights` finds them."""
import numpy
from drill_rig_sim.field.moves import moves_of
from drill_rig_sim.field.record import Record, RecordError

SIGNALS = {"hook_load": "hook_load", "block_height": "block_height", "bit_depth": "bit_depth", "hole_depth": "hole_depth", "top_drive_speed": "rpm",
           "torque": "torque", "flow": "flow"}
MOTIONS = {"pick_up": "up", "slack_off": "down", "rotating_after_up": "rotate", "rotating_after_down": "rotate"}
COARSEST = 2.0  # step of a log from which on a move is not seen any more [s]


class LogRecord(Record):
    """A record made of the means of a log by time."""

    def __init__(self, log):  # pylint: disable=super-init-not-called
        means = log.mean()
        known = numpy.isfinite(means[:, log.names.index("hook_load")])
        time = (log.first + 0.5 + numpy.arange(len(means)))[known] * log.width
        self.name, self.begin, self.remarks = "the run", None, []
        self.signals = {signal: means[known, log.names.index(name)] for signal, name in SIGNALS.items()}
        self.signals["time"] = self.time = time - time[0]


def weights_of(log):
    """Dicts of motion (up, down, rotate), depth [m] and load [N]; [] where a run shows none."""
    if log.first is None or log.width > COARSEST or len(log.low) < 20:
        return []
    try:
        moves, _ = moves_of(LogRecord(log))
    except RecordError:
        return []
    return [{"motion": MOTIONS[move.motion], "depth": move.depth, "load": move.load} for move in moves if move.motion in MOTIONS]
