"""Drills stand after stand: an autodriller to the end of each, then a connection by the rig's services, the pump ramped down and up. A law for
drill_rig_sim.control.

Whether the slips bear the string a noisy gauge with the sheaves' friction in it tells badly; the answer of the rig to slips and connection tells it, as the
look of its crew would. So both are asked for again and again while the block goes down, or up, little by little.
"""
from drill_rig_sim.autodriller import Autodriller


class Stands:
    """`stands`: so many connections. `driller`: settings of the autodriller, whose to_depth is the goal."""
    period, listens = 0.1, False
    lift = 1.0                     # off bottom for the connection [m]
    flow_ramp = 0.002              # [m3/s2]
    slow, creep = 0.02, 0.002      # of the block while weight goes to the slips and comes back; while the slips are tried [m/s]
    still = 3.0                    # so long all stands before the slips are asked for [s]

    def __init__(self, stands, driller):
        self.driller = Autodriller(**driller)
        self.set_points, self.rpm, self.flow = self.driller.set_points, self.driller.rpm, self.driller.flow
        self.left, self.task, self.since, self.done = stands, "drill", 0.0, False
        self.height, self.pumped, self.asked = 0.0, 0.0, ""

    @property
    def phase(self):
        return self.driller.phase if self.task == "drill" else self.task

    def go(self, task, now):
        self.task, self.since, self.asked = task, now, ""

    def step(self, readings):
        commands = self.driller.step(readings)
        if self.task != "drill":
            commands.brake, commands.block_velocity = True, None
        getattr(self, self.task)(readings, commands)
        stopped = self.task in ("quiet", "slack", "connect", "pick_up")
        self.pumped += min(max((0.0 if stopped else self.flow) - self.pumped, -self.flow_ramp * self.period), self.flow_ramp * self.period)
        commands.flow = self.pumped
        if stopped:
            commands.top_drive = {"mode": "SPEED", "speed": 0.0}
        return commands

    @staticmethod
    def move(commands, velocity):
        commands.brake, commands.block_velocity = False, velocity

    def tried(self, readings, what):
        """Whether a thing was asked for with the step before, and not refused."""
        asked, self.asked = self.asked, ""
        return asked == what and not readings.refused

    # --- tasks

    def drill(self, readings, commands):
        if not self.driller.done:
            return
        if readings.bit_depth >= self.driller.to_depth - 0.5 or self.left == 0:
            self.done = True
        else:
            self.height = readings.block_height
            self.go("raise_off", readings.t)

    def raise_off(self, readings, commands):
        self.move(commands, 0.1)
        if readings.block_height > self.height + self.lift:
            self.go("quiet", readings.t)

    def quiet(self, readings, commands):
        """Pump and drive stop, then the slips are set."""
        if self.tried(readings, "slips"):
            self.go("slack", readings.t)
        elif self.pumped > 0.0 or abs(readings.top_drive_speed) > 0.01:
            self.since = readings.t
        elif readings.t > self.since + self.still:
            commands.slips, self.asked, self.since = True, "slips", readings.t

    def slack(self, readings, commands):
        """The block goes down until the rig takes the connection: a second's way, a second's rest, a try."""
        if self.tried(readings, "connection"):
            self.left -= 1
            return self.go("connect", readings.t)
        beat = round((readings.t - self.since) / self.period) % 40
        if beat < 10:
            self.move(commands, -self.creep if readings.hook_load_string < 0.1 * self.driller.string_load else -self.slow)
        elif beat == 39:
            commands.connection, self.asked = True, "connection"

    def connect(self, readings, commands):
        if readings.t > self.since + 1.0 and readings.current_operation != "connecting":
            self.go("pick_up", readings.t)

    def pick_up(self, readings, commands):
        if self.tried(readings, "slips"):
            self.driller.restart()
            return self.go("drill", readings.t)
        self.move(commands, self.slow)
        if round((readings.t - self.since) / self.period) % 10 == 9:
            commands.slips, self.asked = False, "slips"
