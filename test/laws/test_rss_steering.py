#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The law drill_rig_sim.rss_steering: builds 3 deg/30 m by downlinks within half a degree and a metre of its plan."""
import os
import unittest

import numpy
from drill_rig_sim.control import drive
from drill_rig_sim.law import Plan, turn_between
from drill_rig_sim.rss_steering import RssSteering
from drill_rig_sim.score import score
from drill_rig_sim.score_runs import run_of_states
from drill_rig_sim.sim import Simulator
from drill_rig_sim.survey import read_survey

SOURCE = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
PLAN = read_survey(os.path.join(SOURCE, "config/surveys/build_3_deg.csv"))
DRILLER = {"set_points": {"weight": 40e3}, "stiffness": 1e6, "rop": 0.04, "rpm": 120.0, "flow": 0.03, "to_depth": 425.0}


class RssSteeringOfAPlan(unittest.TestCase):
    def test_a_run(self):
        rig, told = Simulator("rss_steering.yaml"), []
        law = RssSteering(PLAN, tool_rate=4.1, bit_time=6.0, driller=DRILLER)
        begin = rig.state.truth.hole_depth

        def judge(state):
            heard = (state.truth.steering.toolface, state.truth.steering.ratio)
            if not told or told[-1] != heard:
                told.append(heard)
        states = drive(rig, law, 3000.0, rig, judge)
        self.assertTrue(law.done)
        self.assertEqual(len(law.schedule), len(told))  # each downlink was heard: the first of both says 0
        print("told: %s" % ", ".join("%.0f deg %.1f" % (numpy.degrees(toolface), ratio) for toolface, ratio in told))

        plan, errors = Plan(PLAN), []
        for state in states:
            if state.truth.hole_depth > begin + 1.0:
                inclination, azimuth = plan.at(state.truth.hole_depth)
                errors.append(numpy.hypot(state.bit.inclination - inclination, numpy.sin(inclination) * turn_between(azimuth, state.bit.azimuth)))
        path = score(run_of_states(states), PLAN)["path"]
        print("largest distance from the plan: %.2f deg, %.2f m" % (numpy.degrees(max(errors)), path["distance_largest_m"]))
        self.assertLess(numpy.degrees(max(errors)), 0.5)
        self.assertLess(path["distance_largest_m"], 1.0)


if __name__ == "__main__":
    unittest.main()
