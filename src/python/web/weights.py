# SPDX-License-Identifier: BSD-3-Clause
"""Weights of the string that a run has shown: steady pick-up, slack-off and rotating off bottom, as `drill weights` finds them."""
import math

from drill_rig_sim.field.moves import moves_of
from drill_rig_sim.field.record import Record, RecordError
from drill_rig_sim.web.bins import Bins

SIGNALS = {"hook_load": "hook_load", "block_height": "block_height", "bit_depth": "bit_depth", "hole_depth": "hole_depth", "top_drive_speed": "rpm",
           "torque": "torque", "flow": "flow"}
MOTIONS = {"pick_up": "up", "slack_off": "down", "rotating_after_up": "rotate", "rotating_after_down": "rotate"}
STEP = 1.0        # of the readings by whose means moves are found [s]
LEAST_ROWS = 20
LOOKED = 1800.0   # what is kept of a run is looked through as a whole until it is so long [s] ...
KEPT = 900.0      # ... then moves that ended so long ago are settled, and so much is kept from before them: how the block came there counts [s]
ANY_LENGTH = 1 << 40


class LogRecord(Record):
    """A record made of the means of a log by time, which begins at 0."""

    def __init__(self, log):  # pylint: disable=super-init-not-called
        means = log.mean()
        known = means[:, log.names.index("hook_load")]
        known = known == known
        self.name, self.begin, self.remarks = "the run", None, []
        self.signals = {signal: means[known, log.names.index(name)] for signal, name in SIGNALS.items()}
        times = log.times()[known]
        self.start = float(times[0]) if len(times) else 0.0  # time of the first row in the run [s]
        self.signals["time"] = self.time = times - self.start


class Weights:
    """Takes readings as they come. However long a run is, only its last half hour is looked through again."""

    def __init__(self):
        self.log, self.settled, self.settled_to = Bins(tuple(SIGNALS.values()), STEP, ANY_LENGTH), [], -math.inf

    def add(self, times, columns):
        self.log.add(times, columns)

    def find(self):
        """Dicts as weight_of() has them, in their order; [] where a run shows none."""
        if self.log.first is None or len(self.log.low) < LEAST_ROWS:
            return self.settled
        record = LogRecord(self.log)
        try:
            moves, _ = moves_of(record)
        except RecordError:
            moves = []
        spans = [(record.start + move.from_time, record.start + move.to_time, move) for move in moves]
        new = [(end, weight_of(move, begin)) for begin, end, move in spans if move.motion in MOTIONS and begin >= self.settled_to]
        found = self.settled + [weight for _, weight in new]
        begin, end = record.start, record.start + record.time[-1]
        if end - begin > LOOKED:
            cut = min([end - KEPT, *(start for start, stop, _ in spans if start <= end - KEPT <= stop)])  # not amid a move
            self.settled = self.settled + [weight for stop, weight in new if stop < cut]
            self.settled_to = cut
            self.log.forget(cut - KEPT)
        return found


def weight_of(move, begin):
    """motion (up, down, rotate), time [s], depth [m], load [N], speed of the block, + up [m/s], rotation [rad/s], flow of the pump [m3/s]."""
    return {"motion": MOTIONS[move.motion], "time": begin, "depth": move.depth, "load": move.load, "speed": move.speed,
            "rotation": move.rotation or 0.0, "flow": move.flow if move.pumped else 0.0}
