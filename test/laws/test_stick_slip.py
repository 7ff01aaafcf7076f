#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The law drill_rig_sim.stick_slip: sees by the torque that the bit of a 3 km string sticks and slips, and ends it by each of its remedies."""
import unittest

from drill_rig_sim.control import drive
from drill_rig_sim.sim import RPM, Simulator, series
from drill_rig_sim.stick_slip import StickSlip


class EndsStickSlip(unittest.TestCase):
    def ends_by(self, remedies, rpm=90.0):
        law = StickSlip(rpm, 0.03, remedies, torsion_period=5.0, stiffness=2.5e5)
        states = drive(Simulator("stick_slip.yaml"), law, 400.0)
        time, speed = series(states, "t") - states[0].t, series(states, "bit.speed")
        before, after = speed[(time > 15.0) & (time < 30.0)], speed[time > time[-1] - 30.0]
        tried = [what for _, what in law.tried]
        print("%s: bit %.0f to %.0f rpm, then %.0f to %.0f; tried %s; %.0f s" % (
            remedies, before.min() / RPM, before.max() / RPM, after.min() / RPM, after.max() / RPM, ", ".join(tried), time[-1]))
        self.assertTrue(law.done)
        mean = after.mean()
        self.assertLess(after.max() - after.min(), 0.1 * mean)
        return before.min(), tried, mean / RPM, states

    def test_modes_of_the_drive(self):
        for mode in ("SOFT_TORQUE", "Z_TORQUE"):
            least, tried, rpm, _ = self.ends_by([mode, "rpm"])
            self.assertLess(least, 0.1)  # it stuck
            self.assertEqual([mode], tried)
            self.assertAlmostEqual(90.0, rpm, delta=2.0)

    def test_faster(self):
        _, tried, rpm, _ = self.ends_by(["rpm", "weight"])
        self.assertEqual({"rpm"}, set(tried))
        self.assertGreater(rpm, 100.0)

    def test_less_weight(self):
        _, tried, rpm, states = self.ends_by(["weight"])
        self.assertEqual({"weight"}, set(tried))
        self.assertAlmostEqual(90.0, rpm, delta=2.0)
        self.assertLess(states[-1].bit.wob, 70e3)

    def test_what_does_not_swing_is_left_alone(self):
        _, tried, _, _ = self.ends_by(["SOFT_TORQUE"], rpm=160.0)
        self.assertEqual([], tried)


if __name__ == "__main__":
    unittest.main()
