# SPDX-License-Identifier: BSD-3-Clause
"""Follows a plan with a bent motor: slides, the bend turned to where the hole has to go, until the hole is ahead of the plan, then rotates until it is
behind. A law for drill_rig_sim.control; an autodriller inside keeps the weight and goes off and on bottom.

The motor's torque twists the string back. What the pressure says of it is turned ahead by the drive at once, what is left by the toolface that comes up.
"""
import math

from drill_rig_sim.autodriller import Autodriller
from drill_rig_sim.law import Lag, Steering, bend, turn_between


class SlideSteering(Steering):
    """`plan`: a drill_rig_sim.survey.Survey. `build_rate`: of a slide [deg/30 m]. `twist`: of the string by the bit's torque, by its differential pressure
    [deg/Pa]. `rocking`: of the string while it is brought to its toolface, off bottom [turns]. `driller`: settings of the autodriller."""
    period = 0.1
    ahead, behind = math.radians(0.3), math.radians(0.3)  # of the plan, where a slide ends and begins
    settling = 8.0                      # so old has a drive's angle to be for a toolface to speak of it [s]
    on_target = math.radians(5.0)       # off bottom, before the slide
    dead_band = math.radians(1.5)       # of the drive's angle: no brake opens for less
    rocking_time, rocking_speed = 30.0, 1.0  # [s], [rad/s]
    patience = 300.0                    # without a toolface, in a slide [s]

    def __init__(self, plan, build_rate, twist, driller, rocking=0.5, gain=0.6):
        super().__init__(Autodriller(**driller), plan)
        self.build_rate = math.radians(build_rate) / 30.0
        self.twist, self.rocking, self.gain = math.radians(twist), 2.0 * math.pi * rocking, gain
        self.sliding = False
        self.target = self.angle = self.base = 0.0
        self.seen, self.turned_at, self.stopped_at, self.heard_at = None, 0.0, None, 0.0
        self.start, self.slid = None, []    # where drilling began; [from, to, toolface] of the slides [m, m, rad]
        self.survey, self.behind_at_sensor = None, (Lag(3.0), Lag(3.0))  # in surveys

    def step(self, readings):
        self.choose(readings)
        commands = self.driller.step(readings)
        if self.sliding and (self.driller.phase != "lifting" or self.stopped_at is not None):  # on the way up from rotating it still turns
            commands.top_drive = self.hold_toolface(readings)
            if readings.t > max(self.stopped_at, self.heard_at) + self.patience:
                self.given_up = "no toolface for %g s: the direction of a slide is unknown" % self.patience
                commands.brake, commands.block_velocity = True, None
        return commands

    # --- slide or rotate

    def missing(self, readings):
        """How far the hole at the bit is behind the plan: (build, turn) [rad]. By the surveys, smoothed; between sensor and bit as far as the hole was
        there before it is on the plan, and below that it has turned by what was slid."""
        survey, depth = readings.survey, readings.bit_depth
        if survey is not self.survey:
            self.survey = survey
            for lag, value in zip(self.behind_at_sensor, self.behind_plan(survey)):
                lag.follow(value, 1.0)
        below = max(self.start, survey.md)
        begun, now = self.plan.at(below), self.plan.at(depth)
        turned = [(self.build_rate * max(0.0, end - max(begin, below)), toolface) for begin, end, toolface in self.slid]
        build, turn = bend(begun, now, now[0])
        build -= sum(angle * math.cos(toolface) for angle, toolface in turned)
        turn -= sum(angle * math.sin(toolface) for angle, toolface in turned)
        return self.behind_at_sensor[0].value + build, self.behind_at_sensor[1].value + turn

    def choose(self, readings):
        if readings.survey is None or self.driller.phase != "drilling":
            return
        depth = readings.bit_depth
        self.start = depth if self.start is None else self.start
        build, turn = self.missing(readings)
        if self.sliding:
            self.slid[-1][1] = depth
            if build * math.cos(self.target) + turn * math.sin(self.target) < -self.ahead:
                self.sliding = False
                self.driller.go("lifting")
        elif math.hypot(build, turn) > self.behind:
            self.sliding, self.target, self.stopped_at = True, math.atan2(turn, build), None
            self.slid.append([depth, depth, self.target])
            self.driller.stay_off = True
            self.driller.go("lifting")

    # --- the drive while it slides

    def hold_toolface(self, readings):
        if self.stopped_at is None:
            self.stopped_at, self.base = readings.t, readings.top_drive_angle
            self.angle, self.turned_at = self.base, readings.t + self.rocking_time
        if readings.t < self.stopped_at + self.rocking_time:  # what rotating has wound up, friction would keep
            return {"mode": "OSCILLATE", "angle": self.base, "amplitude_right": self.rocking, "amplitude_left": self.rocking, "speed": self.rocking_speed}
        self.listen(readings.toolface)
        wanted = self.base + self.twist * max(0.0, self.driller.seen["pressure"])
        if abs(wanted - self.angle) > self.dead_band:
            self.angle = wanted
        return {"mode": "ANGLE", "angle": self.angle}

    def listen(self, toolface):
        if toolface is not None:
            self.heard_at = toolface.t
        if toolface is None or toolface is self.seen or toolface.t < self.turned_at + self.settling:
            return
        self.seen = toolface
        error = turn_between(toolface.toolface, self.target)
        off_bottom = self.driller.stay_off
        self.driller.stay_off = off_bottom and abs(error) > self.on_target
        self.base += (1.0 if off_bottom else self.gain) * error
        self.turned_at = toolface.t + 4.0
