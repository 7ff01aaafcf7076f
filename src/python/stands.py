# SPDX-License-Identifier: BSD-3-Clause
"""Drills stand after stand: an autodriller to the end of each, then a connection by the rig's services, the pump ramped down and up. A law for
drill_rig_sim.control."""
from drill_rig_sim.autodriller import Autodriller
from drill_rig_sim.law import PipeWork


class Stands:
    """`stands`: number of connections. `driller`: settings of the autodriller, whose to_depth is the goal."""
    period = 0.1
    lift = 1.0                     # off bottom for the connection [m]
    flow_ramp = 0.002              # [m3/s2]

    def __init__(self, stands, driller):
        self.driller = Autodriller(**driller)
        self.set_points, self.rpm, self.flow = self.driller.set_points, self.driller.rpm, self.driller.flow
        self.left, self.task, self.done = stands, "drill", False
        self.height, self.pumped, self.work = 0.0, 0.0, None

    @property
    def phase(self):
        if self.task == "connect":
            return self.work.task
        return self.driller.phase if self.task == "drill" else self.task

    def step(self, readings):
        commands = self.driller.step(readings)
        getattr(self, self.task)(readings, commands)
        stopped = self.task == "connect"
        self.pumped += min(max((0.0 if stopped else self.flow) - self.pumped, -self.flow_ramp * self.period), self.flow_ramp * self.period)
        commands.flow = self.pumped
        if stopped:
            commands.top_drive = {"mode": "SPEED", "speed": 0.0}
        return commands

    # --- tasks

    def drill(self, readings, commands):
        if not self.driller.done:
            return
        if readings.bit_depth >= self.driller.to_depth - 0.5 or self.left == 0:
            self.done = True
        else:
            self.height, self.task = readings.block_height, "raise_off"

    def raise_off(self, readings, commands):
        commands.brake, commands.block_velocity = False, 0.1
        if readings.block_height > self.height + self.lift:
            self.work, self.task = PipeWork(self.period, readings.t, self.driller.string_load), "connect"

    def connect(self, readings, commands):
        made, work = self.work.made, self.work.step(readings, self.pumped)
        commands.brake, commands.block_velocity, commands.slips, commands.connection = work.brake, work.block_velocity, work.slips, work.connection
        self.left -= self.work.made and not made
        if self.work.done:
            self.driller.restart()
            self.task = "drill"
