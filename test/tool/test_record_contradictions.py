#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Records one of whose columns has another unit than its map or its header says: reported where the record is read. Ordinary ones are not."""
import math
import unittest

import numpy
from record_folder import FEET, Folder

NAMES = {"block_height": "Block (m)", "top_drive_speed": "RPM (rpm)", "flow": "Flow In (L/min)", "hook_load": "Hook Load (kN)", "torque": "Torque (kN.m)",
         "stand_pipe_pressure": "SPP (bar)", "bit_depth": "Bit Depth (m)", "hole_depth": "Hole Depth (m)"}
ROWS = 40


def well(**changes):
    """Rows of a stand that is drilled at 3000 m and lifted again, every 5 s; `changes`: factors of columns."""
    lines = ["Time (s)," + ",".join(NAMES.values())]
    for k in range(ROWS):
        up = max(0, k - 29)  # ten rows upwards by 1.5 m
        way = 0.02 * min(k, 29) - 1.5 * up
        values = {"block_height": 25.0 - way, "top_drive_speed": 120.0, "flow": 2000.0, "hook_load": 1200.0 + k % 3, "torque": 15.0 + 0.1 * (k % 5), "stand_pipe_pressure": 210.0 + k % 4,
                  "bit_depth": 3000.0 + way, "hole_depth": 3000.0 + 0.02 * min(k, 29)}
        lines.append(",".join("%.9g" % (changes.get(name, 1.0) * value) for name, value in [("time", 5.0 * k), *values.items()]))
    return "\n".join(lines) + "\n"


PSI, KPA, GPM, LBF = 6894.757293168, 1e3, 3.785411784 / 60e3, 4.4482216152605


class Units(Folder):
    def reported(self, lines, **changes):
        """Exactly these among the lines of the record, by their begins."""
        remarks = [line.partition(": ")[2] for line in self.read(well(**changes)).remarks]
        for line in lines:
            self.assertTrue(any(remark.startswith(line) for remark in remarks), "%s\nnot in\n%s" % (line, "\n".join(remarks)))
        if not lines:
            self.assertEqual([], remarks)

    def test_an_ordinary_record(self):
        self.reported([])

    def test_pressure(self):
        """213 bar are 21300 kPa; called psi they are 21300 psi. As kPa under bar's number: 213 kPa."""
        self.reported(["stand_pipe_pressure: its largest value is 1.47e+08 Pa, more than the pumps of a rig are rated for"], stand_pipe_pressure=100.0 * PSI / 1e5)
        # 33.3 L/s in 152 mm: 1.837 m/s, Re 279e3, f 0.00344; 2 f 1000 1.837^2 3000/0.152 = 458 kPa
        self.reported(["stand_pipe_pressure: it is usually 212 kPa at up to 0.0333 m3/s, less than water loses in the widest drill pipe (458 kPa)"], stand_pipe_pressure=0.01)

    def test_low_pressure(self):
        """21.3 MPa called bar are 2.13 MPa; not where less is pumped."""
        line = "stand_pipe_pressure: its largest value is 2.13 MPa at up to 0.0333 m3/s with the bit at 3000.6 m, less than bit and pipe need"
        self.reported([line], stand_pipe_pressure=0.1)
        self.assertFalse(any("bit and pipe need" in remark for remark in self.read(well(stand_pipe_pressure=0.15)).remarks))
        self.assertFalse(any("bit and pipe need" in remark for remark in self.read(well(stand_pipe_pressure=0.1, flow=0.7)).remarks))

    def test_flow(self):
        """2000 L/min called gpm, 33 L/s called L/min."""
        self.reported(["flow: its largest value is 0.000556 m3/s while the stand pipe has up to 21.3 MPa"], flow=1.0 / 60.0)
        self.reported(["stand_pipe_pressure and flow: together up to 5.61 MW, more than the pumps of a rig have (5 MW)"], flow=7.9)

    def test_flow_through_the_bit(self):
        """2000 L/min as 120 m3/h called L/min: 2 L/s at 21 MPa is a hole of 9.7 mm2. A slim hole's 2.5 L/s at 6 MPa need 23 mm2."""
        self.reported(["flow: it is usually 0.002 m3/s at 21.1 MPa, less than the smallest nozzles of a bit let through"], flow=0.06)
        self.assertFalse(any("nozzles" in remark for remark in self.read(well(flow=0.075, stand_pipe_pressure=0.28)).remarks))

    def test_rotary_speed_and_torque(self):
        self.reported(["top_drive_speed: its largest value is 41.9 rad/s, faster than top drives turn"], top_drive_speed=400.0 / 120.0)
        self.reported(["torque: its largest value is 15.4 N.m while 3001 m of pipe turn"], torque=1e-3)
        self.reported(["torque: its largest value is 1.54e+05 N.m, more than top drives have"], torque=10.0)

    def test_hook_load(self):
        """120 t called kN weigh less than 3000 m of pipe; 1200 kN called klbf more."""
        self.reported(["hook_load: its largest value is 12 kN with the bit at 3000.6 m, less than so much pipe weighs"], hook_load=0.01)
        self.reported(["hook_load: it is usually 6e+03 kN with the bit at up to 3000.6 m, more than block and pipe weigh"], hook_load=5.0)

    def test_time(self):
        """Ten rows a second in ms, called s; rows of 5 s called ms."""
        self.reported(["block_height: it rises by 15 m at 0.0015 m/s at most, slower than blocks are lifted"], time=200.0)
        self.reported(["hole_depth: it usually grows by 4 m/s, faster than holes are drilled"], time=1e-3)

    def test_a_hole_depth_that_varies(self):
        """By a millimetre from row to row while the bit is far above: no hole that gets deeper."""
        lines = ["Time (s),Block (m),Hook Load (kN),Bit Depth (m),Hole Depth (m)"] + ["%d,20,1000,2000,%.3f" % (k, 2500.0 + 0.001 * (k % 2)) for k in range(2000)]
        self.assertEqual([], [line for line in self.read("\n".join(lines)).remarks if "it grows" in line])

    def test_depths(self):
        """A hole in feet over a bit in metres."""
        self.reported(["hole_depth: it grows while the bit is usually 6843 m above the bottom"], hole_depth=1.0 / FEET)


class Titles(Folder):
    def test_units_of_a_title(self):
        """Taken where the names have none; a map goes before it."""
        lines = "".join("%g,%g,%g,%g\n" % (5 * k, 200.0 + k, 60.0 - k, 3000.0 + k) for k in range(4))
        record = self.read("Rig 7, depths and heights in feet, hook load in klbs\nTime (s),Hook Load,Block Height,Bit Depth\n" + lines)
        numpy.testing.assert_allclose(record.signals["hook_load"], [1e3 * LBF * (200.0 + k) for k in range(4)])
        numpy.testing.assert_allclose(record.signals["bit_depth"], [FEET * (3000.0 + k) for k in range(4)])
        self.assertIn("hook_load: Hook Load has no unit and is read in klbs, as line 1 says", "\n".join(record.remarks))
        record = self.read("# Hook load units: klbs\nTime (s),Hook Load,Block Height (m)\n0,90,20\n5,91,19\n", "time: {column: Time, unit: s}\nhook_load: {column: Hook Load, unit: tf}\n")
        numpy.testing.assert_allclose(record.signals["hook_load"], [9806.65 * 90.0, 9806.65 * 91.0])

    def test_a_title_with_another_unit(self):
        """Feet of a title over metres of the names; the same unit, another signal and a sentence are none."""
        lines = "\nTime (s),Hook Load (kN),Block Height (m),Bit Depth (m)\n0,900,20,1000\n5,901,19,1001\n"
        for title, said in (("Depths in feet", "bit_depth: line 1 says feet, Bit Depth (m) is in m: it is read so (1 is 1 m); is that right?"), ("Hook load: klbf", "hook_load: line 1 says klbf"),
                            ("Depths in metres", None), ("Hole depth in feet", None), ("Hook load in the slips", None), ("Casing pressure in psi", None)):
            with self.subTest(title):
                found = "\n".join(self.read(title + lines).remarks)
                self.assertEqual(said is not None, "is that right?" in found, found)
                self.assertIn(said or "", found)


class Limits(unittest.TestCase):
    def test_of_a_string(self):
        from drill_rig_sim.field.contradictions import load_at
        self.assertEqual([], load_at("x", numpy.array([91e3]), 3000.0))
        self.assertEqual(1, len(load_at("x", numpy.array([89e3]), 3000.0)))
        self.assertEqual([], load_at("x", numpy.array([4.8e6, 4.8e6, 7e6]), 3000.0))
        self.assertEqual(1, len(load_at("x", numpy.array([5.0e6, 5.0e6, 7e6]), 3000.0)))
        for load in (1e3, 6e6):
            self.assertEqual([], load_at("x", numpy.array([load]), 100.0), "a short string, a blow-out preventer")

    def test_what_water_loses(self):
        """By hand: the loss of the docstring of test_pressure."""
        speed = 2000.0 / 60e3 / (0.25 * math.pi * 0.152**2)
        self.assertAlmostEqual(1.837, speed, 3)
        self.assertAlmostEqual(458.0, 2.0 * 0.0791 * (1e3 * speed * 0.152 / 1e-3)**-0.25 * 1e3 * speed**2 * 3000.6 / 0.152 / 1e3, 0)


if __name__ == "__main__":
    unittest.main()
