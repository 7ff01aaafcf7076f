# SPDX-License-Identifier: BSD-3-Clause
"""An autodriller: keeps the bit on bottom by the feed of the block, gets off a stalled motor, and lets the weight drill off at the end.

Loops of weight, differential pressure and torque each ask for a feed, the rate of penetration is one by itself, and the lowest wins. A law for
drill_rig_sim.control: readings in, commands out, no ROS.
"""
from drill_rig_sim.law import RPM, Commands, Lag, Loop
from drill_rig_sim.tables import GAUGES

HOOK_LOAD = 1 << GAUGES.index("hook_load")  # of RigState.lost_gauges


class Autodriller:
    """`set_points`: weight [N], and where wanted pressure (differential) [Pa] and torque (above that off bottom) [N m]. `stiffness`: of the weight, of
    string and lines [N/m]; those of pressure and torque follow by what a newton on the bit makes of them: pressure_per_weight, torque_per_weight.
    `rop`: largest feed [m/s]. `stall_pressure`: differential, by which a stalled motor is known [Pa]. `tag_speed` [m/s].
    `hook_load_gain`: what the gauge makes of a newton on the hook while the block goes down: a dead line's sheaves rub."""
    period = 0.1                             # [s]
    lift_speed, return_speed = 0.15, 0.05    # of the block [m/s]
    tag_weight, weight_ramp = 5e3, 2e3       # [N], [N/s]
    tag_depth = 0.1                          # this length of new hole counts as bottom too: soft rock that never carries tag_weight [m]
    slew = 0.03                              # of the feed: a sudden change would ring in string and lines [m/s2]
    zero_time, wait_time, spin_up_time = 12.0, 10.0, 20.0  # [s]
    lift, stand_off = 1.5, 0.3               # off bottom [m]
    tag_time, stall_time = 1.5, 1.0          # so long a reading has to be beyond [s]
    bridge_time = 10.0                       # so long it feeds on as before when the hook load is lost, then no more [s]
    back_off = 0.8                           # share of the weight after a stall

    def __init__(self, set_points, stiffness, rop, rpm, flow, to_depth, stall_pressure=float("inf"), pressure_per_weight=1.0, torque_per_weight=1.0,
                 lowest_block=1.5, tag_speed=0.005, hook_load_gain=1.0):
        self.set_points, self.rop, self.rpm, self.flow = dict(set_points), rop, rpm, flow
        self.to_depth, self.stall_pressure, self.lowest_block = to_depth, stall_pressure, lowest_block
        self.tag_speed, self.hook_load_gain = tag_speed, hook_load_gain
        scale = {"weight": 1.0, "pressure": pressure_per_weight, "torque": torque_per_weight}
        self.loops = {name: Loop(value, stiffness * scale[name]) for name, value in self.set_points.items()}
        self.lags = {name: Lag(1.0) for name in ("weight", "pressure", "torque")}
        self.phase, self.since, self.done = "spinning_up", None, False
        self.winner, self.stalls = "", 0
        self.string_load = 0.0                   # what hangs on the hook off bottom [N]
        self.stay_off = self.blind = False       # for who steers: wait on off bottom; feed on as before, whatever the weight seems to be
        self.raw, self.zero, self.samples = {}, {}, []
        self.now = self.last_feed = self.height = self.hole = 0.0
        self.beyond_since = self.lost_since = None

    # --- what the gauges say

    def take(self, readings):
        """Readings less what they were off bottom, smoothed. The zero is a mean: one reading of a noisy gauge is none."""
        self.raw = {"weight": -readings.hook_load / self.hook_load_gain, "pressure": readings.stand_pipe_pressure, "torque": readings.torque}
        self.seen = {name: self.lags[name].follow(self.raw[name] - self.zero.get(name, self.raw[name]), self.period) for name in self.raw}

    def go(self, phase):
        self.phase, self.since = phase, self.now
        self.samples, self.beyond_since = [], None

    def restart(self):
        """After a connection: pump and drive come back, then the bit goes down again."""
        self.go("restarting")
        self.done = False

    def lasted(self, since=None):
        """Time since then, or since the phase began [s]: whole periods, wherever the clock began."""
        return round(self.now - (self.since if since is None else since), 6)

    def beyond(self, name, level, time):
        """Whether a reading has been beyond a level for so long: noise is not."""
        if self.seen[name] < level:
            self.beyond_since = None
        elif self.beyond_since is None:
            self.beyond_since = self.now
        return self.beyond_since is not None and self.lasted(self.beyond_since) >= time

    # --- the law

    def step(self, readings):
        self.now = readings.t
        if self.since is None:
            self.since = self.now
        self.take(readings)
        if not readings.lost_gauges & HOOK_LOAD:
            self.lost_since = None
        elif self.lost_since is None:
            self.lost_since = self.now
        self.winner = ""
        feed = getattr(self, self.phase)(readings)
        if self.lost_since is not None and self.lasted(self.lost_since) > self.bridge_time:
            feed = min(feed, 0.0)
        most = self.slew * self.period
        self.last_feed = feed = min(max(feed, self.last_feed - most), self.last_feed + most)
        for name, loop in self.loops.items():
            loop.follow(max(feed, 0.0), self.period, self.seen[name] if name == self.winner else None)
        return Commands(block_velocity=-feed, brake=feed == 0.0, flow=self.flow, top_drive={"mode": "SPEED", "speed": self.rpm * RPM})

    # --- phases: each gives the feed, + down [m/s]

    def spinning_up(self, _):
        if self.lasted() > self.spin_up_time:
            self.go("zeroing")
        return 0.0

    def restarting(self, _):
        if self.lasted() > self.spin_up_time:
            self.go("returning")
        return 0.0

    def zeroing(self, readings):
        """On the way down, as it drills: the block's rail carries the same share. The first seconds ring."""
        if self.lasted() > 0.3 * self.zero_time:
            self.samples.append(self.raw)
        if self.lasted() > self.zero_time:
            self.string_load = readings.hook_load_string
            self.zero = {name: sum(sample[name] for sample in self.samples) / len(self.samples) for name in self.raw}
            self.lags = {name: Lag(lag.time) for name, lag in self.lags.items()}
            self.hole = readings.hole_depth
            self.go("tagging")
        return self.tag_speed

    def tagging(self, readings):
        if self.beyond("weight", self.tag_weight, self.tag_time) or readings.hole_depth > self.hole + self.tag_depth:
            self.loops["weight"].set_point = self.tag_weight
            self.go("drilling")
        return self.tag_speed

    def drilling(self, readings):
        for name, wanted in self.set_points.items():
            ramp = self.loops[name].set_point + self.weight_ramp * self.period if name == "weight" else wanted  # weight comes on slowly
            self.loops[name].set_point = min(ramp, wanted)
        feeds = {name: loop.feed(self.seen[name]) for name, loop in self.loops.items()}
        feeds["rop"] = min(self.rop, self.tag_speed * (1.0 + 0.1 * self.lasted()))  # so does the feed, should the tag have been none
        self.winner = min(feeds, key=feeds.get)
        if self.blind or self.lost_since is not None:
            self.winner = ""
            return self.loops["weight"].integral
        if self.beyond("pressure", self.stall_pressure, self.stall_time):
            self.stalls += 1
            self.set_points["weight"] *= self.back_off
            self.go("lifting")
        elif readings.bit_depth > self.to_depth or readings.block_height < self.lowest_block:
            self.go("drilling_off")
        return max(feeds[self.winner], 0.0)

    def lifting(self, readings):
        if not self.samples:
            self.samples, self.height = [readings.block_height], readings.block_height
        if readings.block_height > self.height + self.lift:
            self.go("waiting")
        return -self.lift_speed

    def waiting(self, _):
        if self.lasted() > self.wait_time and not self.stay_off:
            self.go("returning")
        return 0.0

    def returning(self, readings):
        if readings.bit_depth > readings.hole_depth - self.stand_off:
            self.go("zeroing")
        return self.return_speed

    def drilling_off(self, _):
        """The block stands and the bit eats the string's stretch: nothing is left that would spring when it is lifted."""
        if self.seen["weight"] < 0.2 * self.set_points["weight"]:
            self.done = True
        return 0.0
