# SPDX-License-Identifier: BSD-3-Clause
"""One connection, as the crew of a rig makes it: off bottom, rotary and pump stopped, slips, a stand, slips pulled. A law for drill_rig_sim.control."""
from drill_rig_sim.law import Commands, PipeWork


class Connection:
    """At the end the string hangs on the hook with the brake set; rotary and pump stay off. `given_up`: why it ended before, or ""."""
    period = 0.1
    lift, lift_speed = 1.0, 0.1  # off bottom, where the bit is nearer [m], [m/s]
    flow_ramp = 0.002            # [m3/s2]
    weighs = 3.0                 # so long the string hangs at rest before its load is read [s]
    patience = 120.0             # for the rig to take slips or connection, once the load is where it must be [s]
    rest_share = 0.03            # of the load that may be off when all of it is in the slips, or back [-]
    longest = 1800.0             # of slips, stand and picking up [s]

    def __init__(self):
        self.task, self.pumped, self.still_since = "raise_off", None, None
        self.work, self.work_task, self.work_since, self.began, self.refusal = None, "", 0.0, 0.0, ""
        self.done, self.given_up = False, ""

    @property
    def phase(self):
        return self.work.task if self.work is not None else self.task

    def step(self, readings):
        if self.pumped is None:
            self.pumped = readings.flow
        commands = Commands(brake=True)
        getattr(self, self.task)(readings, commands)
        return commands

    # --- tasks

    def raise_off(self, readings, commands):
        if readings.in_slips or readings.hole_depth - readings.bit_depth >= self.lift:
            self.task = "stop"
        else:
            PipeWork.move(commands, self.lift_speed)

    def stop(self, readings, commands):
        """Rotary and pump; then the string is weighed."""
        self.rest(commands)
        if self.pumped > 0.0 or abs(readings.top_drive_speed) > 0.01 or self.still_since is None:
            self.still_since = readings.t
        if readings.t > self.still_since + self.weighs:
            self.work = PipeWork(self.period, readings.t, readings.hook_load_string)
            self.task, self.work_since, self.began = "connect", readings.t, readings.t

    def connect(self, readings, commands):
        self.rest(commands)
        work = self.work.step(readings, self.pumped)
        commands.brake, commands.block_velocity, commands.slips, commands.connection = work.brake, work.block_velocity, work.slips, work.connection
        self.refusal = readings.refused or self.refusal
        if self.work.task != self.work_task or self.shifts_load(readings.hook_load_string):
            self.work_task, self.work_since = self.work.task, readings.t
        if self.work.done:
            self.done = True
        elif self.work.task != "connect" and (readings.t > self.work_since + self.patience or readings.t > self.began + self.longest):
            self.done, self.given_up = True, self.refusal or "the rig does not come to rest"
            commands.brake, commands.block_velocity, commands.slips, commands.connection = True, None, None, False

    def shifts_load(self, load):
        """Whether the load still goes to the slips, or comes back: a long string stretches for minutes."""
        share = load / self.work.string_load
        return (self.work.task == "slack" and share > self.rest_share) or (self.work.task == "pick_up" and share < 1.0 - self.rest_share)

    def rest(self, commands):
        self.pumped = max(self.pumped - self.flow_ramp * self.period, 0.0)
        commands.flow, commands.top_drive = self.pumped, {"mode": "SPEED", "speed": 0.0}
