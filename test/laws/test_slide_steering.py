#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The law drill_rig_sim.slide_steering: holds the toolface against the motor's torque in every slide, and follows its plan by slides and rotation."""
import math
import os
import unittest

import numpy
from drill_rig_sim.control import drive
from drill_rig_sim.law import Plan, turn_between
from drill_rig_sim.sim import Simulator, series
from drill_rig_sim.slide_steering import SlideSteering
from drill_rig_sim.survey import read_survey

SOURCE = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
PLAN = read_survey(os.path.join(SOURCE, "config/surveys/build_3_deg.csv"))
DRILLER = {"set_points": {"weight": 40e3}, "stiffness": 1e6, "rop": 0.03, "rpm": 60.0, "flow": 0.03, "to_depth": 414.0, "stall_pressure": 3.3e6}


class SlideSteeringOfAPlan(unittest.TestCase):
    def test_a_run(self):
        rig, sliding, law = Simulator("slide_steering.yaml"), [], SlideSteering(PLAN, build_rate=5.5, twist=4e-5, driller=DRILLER)

        def judge(state):
            if law.sliding and state.bit.wob > 0.0 and abs(state.top_drive_speed) < 0.1:
                sliding.append(abs(turn_between(state.bit.toolface, law.target)))
        states = drive(rig, law, 3000.0, rig, judge)
        self.assertTrue(law.done)
        errors = numpy.degrees(sliding)
        print("slides: %s" % ", ".join("%.1f to %.1f m at %.0f deg" % (begin, end, math.degrees(toolface)) for begin, end, toolface in law.slid))
        print("toolface within 10 deg for %.1f %% of %.0f s of sliding, largest error %.0f deg" % (100.0 * (errors < 10.0).mean(), 0.1 * len(errors), errors.max()))
        self.assertGreater((errors < 10.0).mean(), 0.95)
        self.assertGreaterEqual(len(law.slid), 2)
        self.follows_the_plan(states)

    def follows_the_plan(self, states):
        """By the places of the hole's bottom: the direction at the bit itself leans with every slide."""
        depth = series(states, "truth.hole_depth")
        begin, end = states[numpy.argmax(depth > 402.0)], states[-1]
        place = [numpy.array([getattr(s.bit.position, axis) for axis in "xyz"]) for s in (begin, end)]
        east, north, up = place[1] - place[0]
        plan = Plan(PLAN).at(0.5 * (begin.truth.hole_depth + end.truth.hole_depth))
        inclination, azimuth = math.atan2(math.hypot(east, north), -up), math.atan2(east, north)
        print("from 402 m on on the whole: inclination %.2f deg, planned %.2f; azimuth %.2f deg, planned %.2f" % tuple(
            math.degrees(angle) for angle in (inclination, plan[0], azimuth, plan[1])))
        self.assertLess(abs(inclination - plan[0]), math.radians(0.5))
        self.assertLess(math.sin(plan[0]) * abs(azimuth - plan[1]), math.radians(0.5))


if __name__ == "__main__":
    unittest.main()
