#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The law drill_rig_sim.connection: one connection, by a noisy dead line."""
import os
import tempfile
import unittest

from drill_rig_sim.connection import Connection
from drill_rig_sim.control import drive
from drill_rig_sim.sim import Simulator


SCENES = os.path.join(os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__)))), "config", "scenes")


def turning(block_height):
    """The rig of stands.yaml, 0.3 m off bottom, with pump and rotary running."""
    with open(os.path.join(SCENES, "stands.yaml"), encoding="utf-8") as file:
        text = file.read()
    with tempfile.NamedTemporaryFile("w", suffix=".yaml") as scene:
        scene.write(text.replace("block_height: 25.0", "block_height: %g" % block_height))
        scene.flush()
        rig = Simulator(scene.name)
    rig.rotate(100.0)
    rig.pump(0.03)
    rig.step(30.0)
    return rig


class OneConnection(unittest.TestCase):
    def test_a_stand_is_added(self):
        rig = turning(3.0)
        stands, law = rig.state.stand_count, Connection()
        states = drive(rig, law, 900.0)
        self.assertEqual((True, ""), (law.done, law.given_up))
        last = states[-1]
        self.assertEqual((stands + 1, False, True), (last.stand_count, last.readings.in_slips, last.readings.brake_set))
        self.assertGreater(max(state.truth.hole_depth - state.truth.bit_depth for state in states), 0.9 * law.lift)
        self.assertEqual((0.0, 0.0), (last.mud_pump.flow, last.top_drive.speed))
        self.assertTrue(any(state.readings.in_slips for state in states))

    def test_what_the_rig_refuses_is_given_up_with_its_reason(self):
        law, rig = Connection(), turning(25.0)
        stands = rig.state.stand_count
        states = drive(rig, law, 900.0)
        self.assertTrue(law.done)
        self.assertIn("block", law.given_up)
        self.assertEqual((stands, True), (states[-1].stand_count, states[-1].readings.brake_set))


if __name__ == "__main__":
    unittest.main()
