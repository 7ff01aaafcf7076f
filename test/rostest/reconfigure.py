#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""launch/knobs.py: what is turned by dynamic_reconfigure acts on the rig, and goes on acting after a reset."""
from drill_rig_sim.cfg import KnobsConfig
from drill_rig_sim.tables import GAUGES
from dynamic_reconfigure.client import Client
from rig_test import PATIENCE, Rig, run, unittest, wait_until


class Knobs(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.rig = Rig()
        cls.client = Client(cls.rig.topic("knobs"), timeout=PATIENCE)
        answer = cls.rig.answer(1)
        cls.started = answer.state.torque - answer.truth.torque

    def setUp(self):
        self.client.update_configuration(KnobsConfig.defaults)

    def off(self, gauge):
        """How much it reads too much."""
        answer = self.rig.answer(1)
        return getattr(answer.state, gauge) - getattr(answer.truth, gauge)

    def faults(self):
        return self.rig.answer(1).truth.active_faults

    def test_a_parameter_of_the_start_acts(self):
        self.assertAlmostEqual(500.0, self.started, delta=1.0)

    def test_all_gauges_have_knobs(self):
        knobs = {name for name in KnobsConfig.defaults if name.endswith(("_bias", "_noise"))}
        self.assertEqual({gauge + kind for gauge in GAUGES for kind in ("_bias", "_noise")}, knobs)

    def test_a_bias_and_back(self):
        before = self.off("hook_load")
        self.client.update_configuration({"hook_load_bias": 2e4})
        self.assertAlmostEqual(2e4, self.off("hook_load") - before, delta=10.0)
        self.assertEqual(["sensor_bias of hook_load"], self.faults())
        self.client.update_configuration({"hook_load_bias": 0.0})
        self.assertEqual([], self.faults())

    def test_friction_and_drillability(self):
        self.client.update_configuration({"friction": 2.0, "drillability": 0.5})
        self.assertEqual(["friction_change", "formation_change"], self.faults())

    def test_what_is_beyond_the_range_is_its_end(self):
        self.assertEqual(10.0, self.client.update_configuration({"friction": 99.0})["friction"])

    def test_a_knob_holds_after_a_reset(self):
        self.client.update_configuration({"hook_load_bias": -1e4})
        self.rig.must(self.rig.reset_well("", 0.0))
        wait_until(lambda: "sensor_bias of hook_load" in self.faults(), "the knob acts on the new run")


if __name__ == "__main__":
    run("reconfigure", Knobs)
