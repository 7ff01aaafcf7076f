#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""drill replay of a string that is run in without being filled (mud.fill), against a record worked out by hand."""
import math
import os
import unittest

import yaml
from drill_rig_sim.field.record import read_record
from drill_rig_sim.field.replay import play
from drill_rig_sim.sim import Simulator
from in_folder import InFolder

QUICK = os.path.join(os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__)))), "config/scenes/quick.yaml")
ROWS = "time,reading_block_height,reading_hook_load,reading_bit_depth"


class Unfilled(InFolder):
    def test_a_string_that_is_run_in_unfilled(self):
        """A record by hand: a string on its float hangs in a vertical hole, empty down to the bit, and is filled at 1000 m. Of it the hook bears what the steel weighs in mud,
        less the mud that is not inside; the rail of the block bears 3 % of the block on its way down."""
        density, inner, mass, block, feed = 1200.0, 0.1086, 31.9, 17500.0, 0.1
        with open(QUICK, encoding="utf-8") as text:
            scene = {key: value for key, value in yaml.safe_load(text).items() if key != "program"}
        bit, _, pipe = scene["string"]
        scene.update(well={"stations": [[0, 0, 0], [1100, 0, 0]], "sections": [{"to": 1100, "diameter": 0.2159, "friction": 0.25}]}, string=[bit, pipe],
                     mud={"density": density, "axial_damping": 1.0, "fill": [[0, 0], [1000, 1000], [1000.2, 0]]}, start={"bit_depth": 990, "block_height": 25},
                     numerics={"level": "axial_torsional"})
        rows = []
        for time in range(201):
            depth = 990.0 + feed * time
            steel = (bit["mass"] + mass * (depth - bit["length"])) * (1.0 - density / 7850.0) + mass * (1015.0 - depth)
            missing = density * 0.25 * math.pi * inner**2 * (depth - bit["length"]) if depth < 1000.1 else 0.0
            rows.append((time, 1015.0 - depth, 9.80665 * (0.97 * block + steel - missing), depth))
        file = self.file("unfilled.csv", "\n".join([ROWS, *(",".join("%.9g" % cell for cell in row) for row in rows)]) + "\n")
        off = {}
        for fill in (True, False):
            if not fill:
                del scene["mud"]["fill"]
            replay = play(Simulator(self.file("unfilled.yaml", yaml.safe_dump(scene))), read_record(file))
            off[fill] = replay.residual("hook_load")
        time = replay.time
        empty, full = (time > 20.0) & (time < 99.0), time > 120.0
        for part in (empty, full):  # the string rings after the start and the filling
            self.assertLess(abs(off[True][part].mean()), 1000.0)
        self.assertAlmostEqual(-9.80665 * density * 0.25 * math.pi * inner**2 * 996.0, off[False][empty].mean(), delta=1500.0)  # of a string taken for full
        self.assertLess(abs(off[False][full]).max(), 1500.0)


if __name__ == "__main__":
    unittest.main()
