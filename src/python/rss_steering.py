# SPDX-License-Identifier: BSD-3-Clause
"""Follows a plan with a rotary steerable tool, which receives commands only by downlink: the pump's flow, lowered and raised bit by bit. A law for
drill_rig_sim.control; an autodriller inside keeps the weight, and feeds on as before while a downlink upsets the hook load.

Wanted is the plan's curvature, and what brings direction and place back to the plan within some metres. What the hole does below the survey's sensor is
predicted by what the tool was sent.
"""
import math

from drill_rig_sim.autodriller import Autodriller
from drill_rig_sim.law import Steering, bend

DIRECTIONS, TENTHS = 16, 10  # what a downlink can say: steps of the toolface, of the ratio


def downlink(direction, tenths):
    """Its bits, 1: flow lowered. Start bit, four bits of toolface, four of ratio, a bit that makes their ones even, stop bit."""
    data = [int(bit) for bit in "{:04b}{:04b}".format(direction % DIRECTIONS, tenths)]
    return [1] + data + [sum(data) % 2, 0]


class RssSteering(Steering):
    """`plan`: a drill_rig_sim.survey.Survey. `tool_rate`: of the hole at full steering [deg/30 m]. `bit_time`: of a downlink [s]. `driller`: settings
    of the autodriller."""
    period = 0.1
    low = 0.7                       # share of the flow that says 1
    turn_within, back_within = 6.0, 10.0  # back to the plan's direction, and to its place [m]
    apart, settling = 3.0, 15.0     # between downlinks [m]; after one, until the hook load is right again [s]

    def __init__(self, plan, tool_rate, bit_time, driller):
        super().__init__(Autodriller(**driller), plan)
        self.tool_rate, self.bit_time = math.radians(tool_rate) / 30.0, bit_time
        self.survey, self.survey_depth = None, None
        self.before, self.sag = [], (0.0, 0.0)  # what the surveys show before drilling, and its mean (build, turn) [rad]
        self.error = self.offset = (0.0, 0.0)  # at the sensor: behind the plan (build, turn) [rad], away from it [m]
        self.schedule = []                  # [depth, (build, turn)]: what the tool steers from there on [rad/m]
        self.code, self.bits, self.began = (0, 0), [], 0.0

    def step(self, readings):
        self.listen(readings.survey)
        if self.driller.phase == "drilling" and self.driller.lasted() > self.settling and not self.bits and self.survey is not None:
            self.choose(readings)
        self.driller.blind = bool(self.bits)
        commands = self.driller.step(readings)
        if self.bits:
            commands.flow *= self.share_of_flow(readings)
        return commands

    def listen(self, survey):
        """A new survey's distance from the plan, in direction; in place it is the sum of that over the way. What it is before drilling begins is the
        tool's own, which sags in its hole: that hole is on the plan."""
        if survey is None or survey is self.survey:
            return
        seen = self.behind_plan(survey)
        way = 0.0 if self.survey is None else max(0.0, survey.md - self.survey.md)
        self.survey = survey
        if not self.schedule:
            self.before.append(seen)
            self.sag = tuple(sum(values) / len(self.before) for values in zip(*self.before))
            return
        self.error = tuple(old + 0.4 * (new - sag - old) for old, new, sag in zip(self.error, seen, self.sag))
        self.offset = tuple(offset + way * error for offset, error in zip(self.offset, self.error))

    def since(self, depth, bit):
        """How far the tool has turned the hole from a depth to the bit, as it was commanded: (build, turn) [rad]."""
        turned = [0.0, 0.0]
        ends = [row[0] for row in self.schedule[1:]] + [bit]
        for (begin, rate), end in zip(self.schedule, ends):
            length = max(0.0, end - max(begin, depth))
            turned = [old + length * one for old, one in zip(turned, rate)]
        return turned

    def choose(self, readings):
        """What the hole should do from here on, and a downlink where the tool has another command."""
        bit = readings.bit_depth
        if not self.schedule:
            self.schedule = [[bit, (0.0, 0.0)]]
        below = max(self.schedule[0][0], self.survey.md)
        begun, now, ahead = self.plan.at(below), self.plan.at(bit), self.plan.at(bit + 5.0)
        planned = [angle / 5.0 for angle in bend(now, ahead, now[0])]
        change = bend(begun, now, now[0])
        rates = [rate + (error + more - turned) / self.turn_within + offset / self.back_within ** 2
                 for rate, error, more, turned, offset in zip(planned, self.error, change, self.since(below, bit), self.offset)]
        code = (round(math.atan2(rates[1], rates[0]) / (2.0 * math.pi) * DIRECTIONS) % DIRECTIONS,
                min(TENTHS, round(TENTHS * math.hypot(*rates) / self.tool_rate)))
        if code != self.code and (len(self.schedule) == 1 or bit > self.schedule[-1][0] + self.apart):
            toolface, rate = code[0] * 2.0 * math.pi / DIRECTIONS, code[1] / TENTHS * self.tool_rate
            self.schedule.append([bit, (rate * math.cos(toolface), rate * math.sin(toolface))])
            self.code, self.bits, self.began = code, downlink(*code), readings.t

    def share_of_flow(self, readings):
        number = int((readings.t - self.began) / self.bit_time + 1e-6)
        if readings.t > self.began + len(self.bits) * self.bit_time + self.settling:
            self.bits = []
        return self.low if number < len(self.bits) and self.bits[number] else 1.0
