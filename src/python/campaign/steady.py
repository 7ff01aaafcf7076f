# SPDX-License-Identifier: BSD-3-Clause
"""A controller for campaigns that want none: set points that stay."""
from drill_rig_sim.law import RPM, Commands


class Steady:
    """Turns at `rpm` in a mode of the top drive (SPEED, SOFT_TORQUE, Z_TORQUE), pumps `flow` [m3/s] and moves the block at `block_velocity` [m/s]; 0: it is braked."""
    period, done = 0.1, False

    def __init__(self, rpm, mode="SPEED", flow=0.0, block_velocity=0.0):
        self._commands = Commands(block_velocity if block_velocity else None, not block_velocity, {"mode": mode, "speed": rpm * RPM}, flow)

    def step(self, readings):  # pylint: disable=unused-argument
        return self._commands
