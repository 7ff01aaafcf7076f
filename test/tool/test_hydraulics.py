#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Pump and mud as a controller meets them: ramp, strokes, pressure that is late by the pipe's volume, peaks of the gel, losses, relief valve, ECD, the motor's
pressure, a pump that trips. Against closed forms of test/scenes/hydraulics.yaml."""
import math
import os
import unittest

from drill_rig_sim.sim import Simulator, series

SCENE = os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(__file__))), "scenes/hydraulics.yaml")
STROKE, RAMP, MOST = 0.016, 0.002, 0.06              # of the pump [m3, m3/s2, m3/s]
LENGTHS = {"motor": 8.0, "collar": 14 * 9.4}         # [m]
LENGTHS["pipe"] = 1999.5 - 0.3 - sum(LENGTHS.values())  # in the hole; 20 m stand above it
OUTER, INNER = {"motor": 0.172, "collar": 0.165, "pipe": 0.127}, {"motor": 0.09, "collar": 0.0714, "pipe": 0.1086}  # [m]
HOLE, BULK_MODULUS, GEL, DENSITY = 0.2159, 1.4e9, 8.0, 1200.0
ABOVE = 20.0                                         # pipe in the air [m]


def bore_volume():
    return sum(0.25 * math.pi * INNER[part] ** 2 * (LENGTHS[part] + (ABOVE if part == "pipe" else 0.0)) for part in LENGTHS)


def losses(flow):
    return 4e9 * MOST ** 2 * (flow / MOST) ** 1.8


class Hydraulics(unittest.TestCase):
    def setUp(self):
        self.rig = Simulator(SCENE)

    def run_at(self, flow, seconds):
        self.rig.pump(flow)
        return list(self.rig.frames(seconds, every=10))

    def test_pump_ramps_and_counts_its_strokes(self):
        states = self.run_at(0.03, 60.0)
        self.assertAlmostEqual(RAMP * 10.0, states[99].flow, delta=1e-9)
        self.assertAlmostEqual(0.03, states[-1].flow, delta=1e-12)
        self.assertAlmostEqual(0.03 / STROKE, states[-1].stroke_rate, delta=1e-9)
        pumped = 0.5 * 0.03 * 15.0 + 0.03 * 45.0
        self.assertAlmostEqual(pumped / STROKE, states[-1].pump_strokes, delta=1.0)

    def test_gel_yields_in_bore_and_annulus_and_pressure_follows_the_pump_by_the_pipes_volume(self):
        slow = 0.002
        states = self.run_at(slow, 60.0)
        time, pressure = series(states, "t") - states[0].t, series(states, "stand_pipe_pressure")
        rise = (pressure[34] - pressure[19]) / (time[34] - time[19])
        self.assertAlmostEqual(1.0, rise / (slow * BULK_MODULUS / bore_volume()), delta=0.01)
        in_bore = 4.0 * GEL * sum((LENGTHS[part] + (ABOVE if part == "pipe" else 0.0)) / INNER[part] for part in LENGTHS)
        in_annulus = 4.0 * GEL * sum(LENGTHS[part] / (HOLE - OUTER[part]) for part in LENGTHS)
        first = pressure[time < 8.0].max()
        self.assertAlmostEqual(1.0, first / in_bore, delta=0.07)
        self.assertAlmostEqual(1.0, pressure[time > 8.0].max() / (in_annulus + losses(slow)), delta=0.05)
        self.assertAlmostEqual(1.0, pressure[-1] / losses(slow), delta=0.01)
        self.assertEqual(0.0, self.run_at(0.0, 30.0)[-1].flow)

    def test_losses_relief_valve_and_density_at_the_bit(self):
        self.assertAlmostEqual(DENSITY, self.rig.state.ecd, delta=1e-6)
        flowing = self.run_at(0.045, 120.0)[-1]
        self.assertAlmostEqual(1.0, flowing.stand_pipe_pressure / losses(0.045), delta=0.001)
        self.assertFalse(flowing.relief_valve_open)
        self.assertGreater(flowing.ecd, DENSITY + 50.0)
        full = self.run_at(MOST, 60.0)[-1]
        self.assertEqual((1.2e7, True, MOST), (full.stand_pipe_pressure, full.relief_valve_open, full.flow))
        self.assertAlmostEqual(DENSITY, self.run_at(0.0, 120.0)[-1].ecd, delta=3.0)

    def test_the_motors_pressure_tells_the_bits_torque(self):
        self.run_at(0.03, 120.0)
        self.rig.rotate(rpm=40)
        self.rig.winch(-0.005)
        self.rig.step(20.0)
        self.assertEqual(0.0, self.rig.tare().differential_pressure)
        self.rig.step_until(lambda state: state.bit.wob > 3e4, timeout=300.0, every=10)
        self.rig.winch(-0.002)
        self.rig.step(60.0)
        states = list(self.rig.frames(20.0, every=10))
        needed = 2.0 * math.pi * series(states, "bit.torque").mean() / 0.01  # 10 l a turn
        self.assertGreater(needed, 3e5)
        self.assertAlmostEqual(1.0, series(states, "differential_pressure").mean() / needed, delta=0.05)

    def test_a_pump_that_trips_stops_by_its_ramp(self):
        self.run_at(0.03, 60.0)
        self.rig.fault("PUMP_TRIP")
        self.assertAlmostEqual(0.02, self.rig.step(5.0).flow, delta=1e-9)
        stopped = self.rig.step(40.0)
        self.assertEqual((0.0, 0.0, True), (stopped.flow, stopped.stroke_rate, stopped.pump_tripped))
        self.assertLess(stopped.stand_pipe_pressure, 1e5)
        self.rig.clear_fault("PUMP_TRIP")
        self.assertEqual(0.03, self.rig.step(30.0).flow)


if __name__ == "__main__":
    unittest.main()
