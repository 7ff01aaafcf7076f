#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The laws on their own rigs, whose mud is replaced by a thick one with a rheology: less weight reaches the bit, pressures are higher and follow each move of the
string. Each run is as long as its figure needs; the other tests of the laws have the whole runs."""
import math
import os
import tempfile
import unittest

import numpy
import yaml
from drill_rig_sim.autodriller import Autodriller
from drill_rig_sim.control import drive
from drill_rig_sim.law import turn_between
from drill_rig_sim.rss_steering import RssSteering
from drill_rig_sim.sim import Simulator, series
from drill_rig_sim.slide_steering import SlideSteering
from drill_rig_sim.stands import Stands
from drill_rig_sim.stick_slip import StickSlip
from drill_rig_sim.survey import read_survey

CONFIG = os.path.join(os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__)))), "config")
PLAN = read_survey(os.path.join(CONFIG, "surveys/build_3_deg.csv"))
THICK = {"law": "herschel_bulkley", "readings": [[600, 65], [300, 42], [6, 9], [3, 8]]}
NOZZLES = [14, 14, 14, 14]  # [1/32 in]


def rig_with_thick_mud(name):
    """The rig of config/scenes/NAME.yaml, and what the same flow costs there: its first reading."""
    with open(os.path.join(CONFIG, "scenes", name + ".yaml"), encoding="utf-8") as file:
        scene = yaml.safe_load(file)
    scene["mud"]["rheology"] = THICK
    scene["string"][0]["nozzles"] = NOZZLES
    if "survey" in scene["well"]:
        scene["well"]["survey"] = os.path.join(CONFIG, "scenes", scene["well"]["survey"])
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, name + ".yaml")
        with open(path, "w", encoding="utf-8") as file:
            yaml.safe_dump(scene, file)
        return Simulator(path)


class ThickMud(unittest.TestCase):
    def losses_are_of_the_thick_mud(self, states):
        """An annulus at rest would have the density of the mud."""
        ecd, density = series(states, "truth.ecd"), 1150.0
        print("ECD up to %.0f kg/m3, stand-pipe pressure up to %.1f MPa" % (ecd.max(), 1e-6 * series(states, "stand_pipe_pressure").max()))
        self.assertGreater(ecd.max(), density + 10.0)

    def test_autodriller(self):
        weight, phases = 60e3, []
        law = Autodriller({"weight": weight}, stiffness=6e5, rop=0.012, rpm=60.0, flow=0.03, to_depth=1000.8)
        states = drive(rig_with_thick_mud("autodriller"), law, 600.0, judge=lambda state: phases.append((law.phase, law.lasted())))
        self.assertTrue(law.done)
        settled = [phase == "drilling" and lasted > 60.0 for phase, lasted in phases]
        means = numpy.convolve(series(states, "bit.wob")[settled], numpy.ones(300) / 300.0, "valid")
        print("30 s mean of the weight: %.1f %% off at most" % (100.0 * abs(means / weight - 1.0).max()))
        self.assertLess(abs(means / weight - 1.0).max(), 0.05)
        self.losses_are_of_the_thick_mud(states)

    def test_stands(self):
        driller = {"set_points": {"weight": 30e3}, "stiffness": 2e6, "rop": 0.08, "rpm": 100.0, "flow": 0.03, "to_depth": 350.0, "tag_speed": 0.02,
                   "hook_load_gain": 1.094}
        rig, law = rig_with_thick_mud("stands"), Stands(1, driller)
        begin = rig.state
        states = drive(rig, law, 2000.0)
        self.assertTrue(law.done)
        self.assertEqual(begin.stand_count + 1, states[-1].stand_count)
        self.losses_are_of_the_thick_mud(states)

    def test_slide_steering(self):
        driller = {"set_points": {"weight": 40e3}, "stiffness": 1e6, "rop": 0.03, "rpm": 60.0, "flow": 0.03, "to_depth": 408.0, "stall_pressure": 3.3e6}
        rig, errors, law = rig_with_thick_mud("slide_steering"), [], SlideSteering(PLAN, build_rate=5.5, twist=4e-5, driller=driller)

        def judge(state):
            if law.sliding and state.bit.wob > 0.0 and abs(state.top_drive_speed) < 0.1:
                errors.append(math.degrees(abs(turn_between(state.bit.toolface, law.target))))
        states = drive(rig, law, 2000.0, rig, judge)
        self.assertTrue(law.done)
        within = (numpy.array(errors) < 10.0).mean()
        print("toolface within 10 deg for %.1f %% of %.0f s of sliding" % (100.0 * within, 0.1 * len(errors)))
        self.assertGreater(within, 0.95)
        self.losses_are_of_the_thick_mud(states)

    def test_rss_steering(self):
        driller = {"set_points": {"weight": 40e3}, "stiffness": 1e6, "rop": 0.04, "rpm": 120.0, "flow": 0.03, "to_depth": 404.0}
        rig, heard = rig_with_thick_mud("rss_steering"), []
        law = RssSteering(PLAN, tool_rate=4.1, bit_time=6.0, driller=driller)
        states = drive(rig, law, 2000.0, rig, lambda state: heard.append((state.truth.steering.toolface, state.truth.steering.ratio)))
        self.assertTrue(law.done)
        self.assertEqual(len(law.schedule), len([1 for k, now in enumerate(heard) if k == 0 or now != heard[k - 1]]))  # each downlink was heard
        self.losses_are_of_the_thick_mud(states)

    def test_stick_slip(self):
        law = StickSlip(90.0, 0.03, ["SOFT_TORQUE", "rpm", "weight"], torsion_period=5.0, stiffness=2.5e5)
        states = drive(rig_with_thick_mud("stick_slip"), law, 400.0)
        time, speed = series(states, "t"), series(states, "bit.speed")
        self.assertTrue(law.done)
        self.assertLess(speed[(time > time[0] + 15.0) & (time < time[0] + 30.0)].min(), 0.1)  # it stuck
        after = speed[time > time[-1] - 30.0]
        print("tried %s; the bit then turns by %.0f to %.0f rpm" % (law.tried, after.min() * 30.0 / math.pi, after.max() * 30.0 / math.pi))
        self.assertLess(after.max() - after.min(), 0.1 * after.mean())


if __name__ == "__main__":
    unittest.main()
