#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The autodriller as pages and the driller's console start it: what it takes of an order and of the rig. No master, no browser."""
import math
import types
import unittest

import skips
from drill_rig_sim.lockstep import Refused
from drill_rig_sim.web.law_box import LawBox, law_of, settings_of, stall_pressure_of, stiffness_of
from drill_rig_sim.web.law_process import LawProcess


class Law(unittest.TestCase):
    def test_law(self):
        whole = {"weight": 5e4, "rop": 0.01, "rpm": 6.0, "flow": 0.03, "to_depth": 900.0, "stiffness": 6e5}
        self.assertEqual(settings_of({**whole, "pressure": None}), whole)
        with self.assertRaisesRegex(Refused, "^needed: rop, flow$"):
            settings_of({**whole, "rop": None, "flow": None})
        box = LawBox(None)
        with self.assertRaisesRegex(Refused, "is not running"):
            box.set(whole)
        self.assertFalse(box.status()["running"])

    def test_the_string_yields_as_its_parts_do(self):
        """By hand: 100 m of 5 in x 4.276 in pipe (3.404e-3 m2) are 7.012e6 N/m; 50 m and what is left of 150 m as much; a bit of 0.3 m adds little."""
        pipe = {"length": 0.0, "diameter": 0.127, "bore": 0.1086}
        self.assertAlmostEqual(7.012e6, stiffness_of([pipe], 100.0), delta=2e3)
        self.assertAlmostEqual(7.012e6 / 1.5, stiffness_of([{**pipe, "length": 50.0}, pipe], 150.0), delta=2e3)
        self.assertLess(stiffness_of([{"length": 0.3, "diameter": 0.2159, "bore": 0.0}, pipe], 100.3), 7.012e6)
        self.assertEqual(6e5, stiffness_of([], 100.0))

    def test_the_process_of_the_console_takes_the_orders_of_a_page(self):
        class Driven:
            def __init__(self, *_, **__):
                self.orders = []
                self.set_law = self.start_law = self.connect = self.alive = lambda *_: self.orders.append("law") or ""
                self.law, self.streams = types.SimpleNamespace(stop=lambda: self.orders.append("stop")), types.SimpleNamespace(drop=self.orders.append)
                self.running = True

            def stop_law(self, *_):
                raise Refused("no")

            def tick(self):
                return [{"type": "law", "running": self.running}, {"type": "answer", "text": "note"}]

        process = LawProcess(types.SimpleNamespace(), Driven)
        for line, answer in (('{"type": "start_law"}', ""), ('{"type": "stop_law"}', "no"), ("{", "no JSON object"), ("[]", "unknown command"),
                             ('{"type": "call"}', "unknown command")):
            self.assertEqual(answer, process.take(line), line)
        self.assertEqual([{"type": "law", "running": True}, {"type": "answer", "text": "note"}], process.report())
        self.assertEqual([{"type": "answer", "text": "note"}], process.report())  # the law has not changed
        process.take('{"type": "leave_block"}')
        self.assertEqual(["law", "stop", "winch"], process.hands.orders)

    def test_a_law_knows_bit_and_motor_by_the_scene(self):
        settings = {"weight": 6e4, "rop": 0.01, "rpm": 6.0, "flow": 0.03, "to_depth": 900.0, "stiffness": 6e5}
        parts = [{"type": "bit", "diameter": 0.2}, {"type": "mud_motor", "stall_torque": 3e3, "displacement_per_rev": 0.01}]
        self.assertAlmostEqual(stall_pressure_of(settings, parts), 0.95 * 2.0 * math.pi * 3e5)
        self.assertEqual(stall_pressure_of({**settings, "pressure": 1e6}, parts), 1.5e6)
        parts[1]["efficiency"] = 0.8
        self.assertAlmostEqual(stall_pressure_of(settings, parts), 0.95 * 2.0 * math.pi * 3e5 / 0.8)
        self.assertEqual(stall_pressure_of(settings, []), math.inf)
        self.assertAlmostEqual(law_of(settings, parts).loops["torque"].gain, 1.0 / (6e5 * 0.02 * 5.0))


if __name__ == "__main__":
    skips.main()
