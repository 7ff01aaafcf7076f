#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The law drill_rig_sim.autodriller against a rig whose hook load is noisy and late: weight kept into harder rock, loops that take over from each
other without a bump, and a stalled motor got going again. Fed by readings, judged by the truth. And rock too soft to bear the weight of a tag."""
import types
import unittest

import numpy
from drill_rig_sim.autodriller import Autodriller
from drill_rig_sim.control import Ordered, drive
from drill_rig_sim.sim import Simulator, series

WEIGHT = 60e3
PRESSURE, TORQUE = 1.09e6, 1.32e3  # that this weight makes [Pa], [N m]
ORDERS = ((480.0, "pressure", PRESSURE), (480.0, "weight", 1.1 * WEIGHT),      # pressure takes over
          (540.0, "torque", TORQUE), (540.0, "pressure", 1.3 * PRESSURE),      # torque
          (600.0, "torque", 10 * TORQUE), (600.0, "pressure", 10 * PRESSURE),  # far too much weight: the motor stalls
          (600.0, "weight", 2 * WEIGHT), (660.0, "weight", WEIGHT))


class AutodrillerLoops(unittest.TestCase):
    def test_a_run(self):
        rig, phases = Simulator("autodriller.yaml"), []
        law = Ordered(Autodriller({"weight": WEIGHT, "pressure": 1.3 * PRESSURE, "torque": 1.5 * TORQUE}, stiffness=6e5, rop=0.012, rpm=60.0, flow=0.03,
                                  to_depth=1003.0, stall_pressure=1.8e6, pressure_per_weight=18.0, torque_per_weight=0.022), ORDERS)
        begin = rig.state.t
        states = drive(rig, law, 1500.0, judge=lambda state: phases.append((law.phase, law.winner)))
        self.time, self.weight = series(states, "t") - begin, series(states, "bit.wob")
        self.phases = phases
        self.assertTrue(law.done)
        self.holds_weight_into_harder_rock(series(states, "truth.hole_depth"))
        self.takes_over_without_a_bump()
        self.gets_off_a_stall(law, series(states, "truth.motor_stalled"))

    def means(self, begin, end, seconds):
        """Of the weight over windows of these seconds, all that lie between two times."""
        rows = (self.time > begin) & (self.time <= end)
        count = round(seconds / 0.1)
        return numpy.convolve(self.weight[rows], numpy.ones(count) / count, "valid")

    def holds_weight_into_harder_rock(self, depth):
        tag = self.time[self.phases.index(("drilling", "weight"))]
        changed = self.time[numpy.argmax(depth > 1001.5)]
        self.assertTrue(tag + 90.0 < changed < 420.0)
        errors = {name: abs(self.means(begin, end, 30.0) / WEIGHT - 1.0).max() for name, (begin, end) in {
            "settled": (tag + 60.0, changed), "through the change": (changed - 30.0, 480.0), "after it": (changed + 20.0, 480.0)}.items()}
        print("largest errors of the 30 s mean: %s" % ", ".join("%s %.1f %%" % (name, 100.0 * error) for name, error in errors.items()))
        self.assertLess(errors["settled"], 0.05)
        self.assertLess(errors["through the change"], 0.1)
        self.assertLess(errors["after it"], 0.05)

    def takes_over_without_a_bump(self):
        for time, winner in ((470.0, "weight"), (520.0, "pressure"), (590.0, "torque")):
            self.assertIn(("drilling", winner), [self.phases[i] for i in numpy.flatnonzero(abs(self.time - time) < 5.0)])
        error = abs(self.means(470.0, 600.0, 5.0) / WEIGHT - 1.0).max()
        print("largest bump of the 5 s mean: %.1f %%" % (100.0 * error))
        self.assertLess(error, 0.05)

    def gets_off_a_stall(self, law, stalled):
        self.assertGreaterEqual(law.stalls, 1)
        self.assertTrue(stalled.any())
        last = self.time[numpy.flatnonzero(stalled)[-1]]
        off = self.time[numpy.flatnonzero((self.weight == 0.0) & (self.time > 600.0))[0]]
        self.assertLess(off - self.time[numpy.flatnonzero(stalled)[0]], 10.0)
        again = self.time[numpy.flatnonzero((self.time > last + 5.0) & (abs(self.weight - WEIGHT) < 0.05 * WEIGHT))[0]]
        print("stalled at %.0f s, off bottom at %.0f s, on with the weight at %.0f s, stalls: %d" % (last, off, again, law.stalls))
        self.assertFalse(stalled[self.time > again].any())


class SoftRock(unittest.TestCase):
    def test_rock_that_bears_no_weight_is_drilled_at_the_largest_rate(self):
        law = Autodriller({"weight": WEIGHT}, stiffness=6e5, rop=0.01, rpm=60.0, flow=0.03, to_depth=1010.0)
        now = types.SimpleNamespace(t=0.0, hook_load=3e5, hook_load_string=3e5, stand_pipe_pressure=8e6, torque=2e3, lost_gauges=0, bit_depth=999.9,
                                    hole_depth=1000.0, block_height=20.0)
        for _ in range(1500):
            feed = -law.step(now).block_velocity
            now.t += law.period
            now.bit_depth += feed * law.period
            now.hole_depth = max(now.hole_depth, now.bit_depth)
            now.block_height -= feed * law.period
        self.assertEqual(law.phase, "drilling")
        self.assertAlmostEqual(feed, 0.01)


if __name__ == "__main__":
    unittest.main()
