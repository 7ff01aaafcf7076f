# SPDX-License-Identifier: BSD-3-Clause
"""Watches the torque for stick-slip and does something against it, one remedy after the other until the swings are gone. A law for drill_rig_sim.control.

A bit that sticks and slips winds the string up and lets it go: at the surface the torque swings at the string's slowest torsion. No rig sees the bit.
"""
import math
import statistics
from collections import deque

from drill_rig_sim.law import RPM, Commands


class StickSlip:
    """`remedies`: modes of the top drive ("SOFT_TORQUE", "Z_TORQUE"), "rpm" (faster, step by step to most_rpm) and "weight" (less, step by step), in the
    order of trial. `torsion_period`: of the string's slowest torsion [s]. `stiffness`: of string and lines [N/m]."""
    period = 0.1
    swing_limit, calm_limit = 0.2, 0.1      # amplitude of the torque's swings over its mean: stick-slip, and its end
    patience, calm_time = 6.0, 12.0         # what a remedy is given, and so long it has to be calm [torsion periods]
    rpm_step, weight_step, lift_speed = 15.0, 10e3, 2e-3  # [rpm], [N], of the block [m/s]

    def __init__(self, rpm, flow, remedies, torsion_period, stiffness, most_rpm=180.0):
        self.set_points = {"rpm": rpm}
        self.flow, self.remedies, self.torsion_period, self.stiffness, self.most_rpm = flow, list(remedies), torsion_period, stiffness, most_rpm
        self.mode, self.lifting_until, self.done = "SPEED", 0.0, False
        self.torques = deque(maxlen=round(2.5 * torsion_period / self.period))
        self.swing, self.tried_at, self.calm_since = None, None, None
        self.phase, self.tried = "watching", []  # [time, what]

    def step(self, readings):
        now = readings.t
        if self.tried_at is None:
            self.tried_at = now
        self.watch(readings.torque, now)
        if self.swing is not None and self.swing > self.swing_limit and now > self.tried_at + self.patience * self.torsion_period:
            self.try_next(now)
        self.done = self.calm_since is not None and now - self.calm_since > self.calm_time * self.torsion_period
        lifts = now < self.lifting_until
        return Commands(flow=self.flow, top_drive={"mode": self.mode, "speed": self.set_points["rpm"] * RPM},
                        block_velocity=self.lift_speed if lifts else None, brake=not lifts)

    def watch(self, torque, now):
        self.torques.append(torque)
        if len(self.torques) < self.torques.maxlen:
            return
        mean = statistics.fmean(self.torques)
        self.swing = math.sqrt(2.0) * statistics.pstdev(self.torques, mean) / max(abs(mean), 1.0)
        if self.swing > self.calm_limit:
            self.calm_since = None
        elif self.calm_since is None:
            self.calm_since = now

    def try_next(self, now):
        """The first remedy that is left; those that go by steps stay until they can no further."""
        if not self.remedies:
            return
        remedy = self.remedies[0]
        if remedy == "rpm":
            self.set_points["rpm"] = min(self.set_points["rpm"] + self.rpm_step, self.most_rpm)
        elif remedy == "weight":
            self.lifting_until = now + self.weight_step / self.stiffness / self.lift_speed
        else:
            self.mode = remedy
        if remedy not in ("rpm", "weight") or (remedy == "rpm" and self.set_points["rpm"] >= self.most_rpm):
            self.remedies.pop(0)
        self.tried_at = now
        self.phase = remedy
        self.tried.append([now, remedy])
