#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""A rig that is reset, or whose snapshot is restored, in the middle of a law's run: the law begins again, and what follows is the first run once more."""
import os
import unittest

from drill_rig_sim.autodriller import Autodriller
from drill_rig_sim.control import driven
from drill_rig_sim.rss_steering import RssSteering
from drill_rig_sim.sim import Simulator, series
from drill_rig_sim.slide_steering import SlideSteering
from drill_rig_sim.stands import Stands
from drill_rig_sim.stick_slip import StickSlip
from drill_rig_sim.survey import read_survey

SOURCE = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
STEER = {"set_points": {"weight": 40e3}, "stiffness": 1e6, "rop": 0.03, "rpm": 60.0, "flow": 0.03, "to_depth": 414.0, "stall_pressure": 3.3e6}
PLAN = read_survey(os.path.join(SOURCE, "config/surveys/build_3_deg.csv"))
LAWS = {
    "autodriller": lambda: Autodriller({"weight": 60e3}, stiffness=6e5, rop=0.012, rpm=60.0, flow=0.03, to_depth=1003.0),
    "stick_slip": lambda: StickSlip(90.0, 0.03, ["SOFT_TORQUE", "rpm"], torsion_period=5.0, stiffness=2.5e5),
    "slide_steering": lambda: SlideSteering(PLAN, build_rate=5.5, twist=4e-5, driller=STEER),
    "rss_steering": lambda: RssSteering(PLAN, tool_rate=4.1, bit_time=6.0, driller={**STEER, "rpm": 120.0}),
    "stands": lambda: Stands(5, {"set_points": {"weight": 30e3}, "stiffness": 2e6, "rop": 0.08, "rpm": 100.0, "flow": 0.03, "to_depth": 460.0, "tag_speed": 0.02,
                                 "hook_load_gain": 1.094}),
}
SECONDS = 100.0  # until the rig is reset: by then the bit drills [s]
AGAIN = 40.0     # compared after it [s]


class Reset(unittest.TestCase):
    def test_the_law_begins_again(self):
        for name, law in LAWS.items():
            for restored in (False, True):
                with self.subTest(law=name, restored=restored):
                    self.begins_again(name + ".yaml", law(), restored)

    def begins_again(self, scene, law, restored):
        rig = Simulator(scene)
        rig.save("start")
        states, was_reset = [], False
        for state in driven(rig, law, SECONDS + AGAIN, rig):
            states.append(state)
            if not was_reset and len(states) * law.period >= SECONDS - 1e-6:
                rig.restore("start") if restored else rig.reset()
                was_reset = True
        first = round(SECONDS / law.period)
        again = len(states) - first
        self.assertGreaterEqual(again * law.period, AGAIN - 1.0)
        self.assertEqual({(0, 1)}, set(zip(series(states[:first], "epoch"), series(states[first:], "epoch"))))
        for signal in ("hook_load", "block_height", "truth.hole_depth", "torque"):
            self.assertEqual(series(states[:again], signal).tolist(), series(states[first:], signal).tolist(), signal)


if __name__ == "__main__":
    unittest.main()
