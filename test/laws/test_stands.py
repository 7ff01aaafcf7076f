#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The law drill_rig_sim.stands: five stands drilled, with the connections between them, by a noisy dead line."""
import unittest

import numpy
from drill_rig_sim.control import drive
from drill_rig_sim.score import score
from drill_rig_sim.score_runs import run_of_states
from drill_rig_sim.sim import Simulator, series
from drill_rig_sim.stands import Stands

WEIGHT, STAND = 30e3, 28.5
DRILLER = {"set_points": {"weight": WEIGHT}, "stiffness": 2e6, "rop": 0.08, "rpm": 100.0, "flow": 0.03, "to_depth": 460.0, "tag_speed": 0.02,
           "hook_load_gain": 1.094}


class FiveStands(unittest.TestCase):
    def test_a_run(self):
        rig, law, tasks = Simulator("stands.yaml"), Stands(5, DRILLER), []
        begin = rig.state
        states = drive(rig, law, 6000.0, judge=lambda state: tasks.append((law.task, law.driller.phase, law.driller.lasted())))
        self.assertTrue(law.done)
        self.assertEqual(begin.stand_count + 5, states[-1].stand_count)
        self.assertGreater(states[-1].truth.hole_depth - begin.truth.hole_depth, 5 * STAND)
        scores = score(run_of_states(states), wob=WEIGHT)
        print("%.1f m, %d connections, in slips %.0f s, weight to weight %.0f s" % (
            scores["drilling"]["drilled_m"], scores["connections"]["number"], scores["connections"]["in_slips_s"], scores["connections"]["weight_to_weight_s"]))
        self.assertEqual(5, scores["connections"]["number"])
        self.assertLess(scores["connections"]["in_slips_s"], 100.0)  # 60 of them the rig's own

        weight = series(states, "bit.wob")
        settled = numpy.array([task == "drill" and phase == "drilling" and lasted > 40.0 for task, phase, lasted in tasks])
        means = numpy.convolve(weight, numpy.ones(300) / 300.0, "valid")
        whole = numpy.convolve(settled, numpy.ones(300), "valid") > 299.5
        errors = means[whole] / WEIGHT - 1.0
        print("30 s mean of the weight, settled: %.1f to %.1f %% off" % (100.0 * errors.min(), 100.0 * errors.max()))
        self.assertLess(abs(errors).max(), 0.1)
        flow = series(states, "truth.flow")
        self.assertLess(abs(numpy.diff(flow)).max() / law.period, 1.2 * law.flow_ramp)


if __name__ == "__main__":
    unittest.main()
