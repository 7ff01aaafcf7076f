#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Records that change on the way: a unit from a row on, a header that stands again, an index that is not what it is called. See test_record.py."""
import unittest

import numpy
from drill_rig_sim.field.record import read_record
from drill_rig_sim.field.unit_change import unit_changes
from record_folder import FEET, KLBF, ROWS as RIGHT, Folder

ROWS, CHANGES = 120, 70
TIME = 5.0 * numpy.arange(ROWS)
HEAD = "Time (s),Hook Load (klbf),Block Height (ft)"
LINES = "0,200,30\n5,201,29.5\n"


def signals(flow=0.03, speed=6.0):
    """A string that is lowered slowly while it drills, with noise."""
    noise = numpy.random.default_rng(3).normal(0.0, 1.0, (4, ROWS))
    return {"hook_load": 9e5 - 100.0 * TIME + 4e3 * noise[0], "stand_pipe_pressure": 2e7 + 2e5 * noise[1], "flow": flow * (1.0 + 0.01 * noise[2]),
            "torque": 1.5e4 + 1e3 * noise[3], "top_drive_speed": numpy.full(ROWS, speed), "block_height": 30.0 - 0.01 * TIME, "bit_depth": 3000.0 + 0.01 * TIME}


def changed(signal, ratio, last=ROWS, **options):
    found = signals(**options)
    found[signal][CHANGES:last] *= ratio
    return [(name, row, before, after) for name, row, _, before, after in unit_changes(TIME, found)]


class UnitChanges(Folder):
    def test_each_quantity(self):
        for signal, ratio, before, after in (("hook_load", 1e3 / KLBF, "kN", "klbf"), ("hook_load", 1e3 / 9806.65, "kN", "tonne"), ("hook_load", KLBF / 9806.65, "klbf", "tonne"),
                                             ("stand_pipe_pressure", 1e5 / 6894.757, "bar", "psi"), ("stand_pipe_pressure", 6.894757, "psi", "kPa"),
                                             ("flow", 1.0 / 3.785412, "L/min", "gpm"), ("flow", 3.785412, "gpm", "L/min"), ("torque", 1e3, "kN.m", "N.m"),
                                             ("block_height", 1.0 / FEET, "m", "ft"), ("bit_depth", FEET, "ft", "m")):
            with self.subTest(signal, ratio=ratio):
                self.assertEqual([(signal, CHANGES)], [found[:2] for found in changed(signal, ratio)])
                pairs = {"kN klbf", "kN tonne", "klbf tonne", "bar psi", "psi kPa", "L/min gpm", "gpm L/min", "kN.m N.m", "m ft", "ft m"}
                self.assertIn("%s %s" % (before, after), pairs)
                self.assertEqual((before, after), changed(signal, ratio)[0][2:])

    def test_for_a_while(self):
        self.assertEqual([("hook_load", CHANGES, "kN", "klbf"), ("hook_load", 100, "klbf", "kN")], changed("hook_load", 1e3 / KLBF, last=100))

    def test_what_is_none(self):
        self.assertEqual([], unit_changes(TIME, signals()))
        self.assertEqual([], changed("hook_load", 0.6), "no ratio of units")
        self.assertEqual([], changed("hook_load", 1e3 / KLBF, last=CHANGES + 3), "a few rows")
        self.assertEqual([], changed("torque", 3.0))
        self.assertEqual([], changed("bit_depth", 0.998), "a correction")

    def test_slips_are_none(self):
        """At a standstill without pump and rotation the load falls by any ratio, and stays so."""
        standing = signals(flow=0.0, speed=0.0)
        standing["block_height"][:] = 3.0
        standing["hook_load"][CHANGES:] *= 1e3 / KLBF
        self.assertEqual([], unit_changes(TIME, standing))

    def test_a_pump_that_starts_is_none(self):
        """The pressure follows the flow."""
        found = signals()
        for signal, ratio in (("flow", 0.25), ("stand_pipe_pressure", 6894.757 / 1e5)):
            found[signal][:CHANGES] *= ratio
        self.assertEqual([], unit_changes(TIME, found))

    def test_trips_are_none(self):
        """Pipe is lifted and set into the slips, twenty times; block and empty hook weigh a quarter."""
        found = signals(flow=0.0, speed=0.0)
        found["hook_load"][(numpy.arange(ROWS) // 3) % 2 == 1] = 9e5 / 4.448
        found["block_height"] = 15.0 + 10.0 * numpy.sin(TIME / 5.0)
        self.assertEqual([], unit_changes(TIME, found))

    def test_is_reported(self):
        found = signals()
        load = found["hook_load"] / numpy.where(numpy.arange(ROWS) < CHANGES, 1e3, KLBF)
        text = "Time (s),Hook Load (kN),Block Height (m),Flow In (L/min)\n" + "".join("%g,%.1f,%.3f,1800\n" % row for row in zip(TIME, load, found["block_height"]))
        self.assertIn("hook_load is 0.2", "\n".join(self.read(text).remarks))
        self.assertIn("times as large from 350 s on, as if its unit changed from kN to klbf", "\n".join(self.read(text).remarks))


class HeadersAgain(Folder):
    def test_the_same(self):
        record = self.read("%s\n%s%s\n10,202,29\n" % (HEAD, LINES, HEAD))
        self.assertEqual([0.0, 5.0, 10.0], list(record.time))
        self.assertIn("1 lines repeat the names of the columns and are skipped (first: line 4)", "\n".join(record.remarks))

    def test_the_same_over_two_lines(self):
        head = "Time,Hook,Block\n,Load,Height\ns,klbf,ft\n"
        record = self.read(head + LINES + head + "10,202,29\n")
        numpy.testing.assert_allclose(record.signals["hook_load"], [200.0 * KLBF, 201.0 * KLBF, 202.0 * KLBF])

    def test_another_unit(self):
        self.refused(("r.csv:4", "other names of columns than the header"), "%s\n%sTime (s),Hook Load (kN),Block Height (m)\n10,900,9\n" % (HEAD, LINES))

    def test_another_line_of_units(self):
        self.refused("r.csv:5: has other units than the rows before it (kN, not klbf)", "TIME,HKLD,BPOS\ns,klbf,ft\n%ss,kN,m\n10,900,9\n" % LINES)

    def test_another_order(self):
        self.refused("r.csv:4", "%s\n%sTime (s),Block Height (ft),Hook Load (klbf)\n10,29,202\n" % (HEAD, LINES))


class Files(Folder):
    def joined(self, one, other, head="Time (s)"):
        texts = ["%s,Hook Load (klbf),Block Height (ft)\n%s" % (head, lines) for lines in (one, other)]
        return "\n".join(read_record([self.file("r%d.csv" % k, text) for k, text in enumerate(texts)]).remarks)

    def test_seconds_that_begin_anew(self):
        said = self.joined(LINES + "10,202,29\n", "0,300,20\n4,301,19\n8,302,18\n")
        self.assertIn("r1.csv both hold hook_load, block_height at the same seconds; dates are needed where these begin anew in each file", said.replace("block_height, hook_load", "hook_load, block_height"))

    def test_dates(self):
        days = ["2024-05-01T10:00:%02dZ,200,30\n" % second for second in (0, 2, 4, 6)]
        self.assertIn("at the same dates", self.joined(days[0] + days[2], days[1] + days[3], head="DateTime"))

    def test_what_goes_on(self):
        self.assertNotIn("both hold", self.joined(LINES, "10,202,29\n15,203,28\n"))
        self.assertNotIn("both hold", self.joined(LINES, LINES + "10,202,29\n"), "a part again")


class Indices(Folder):
    def test_a_depth_that_is_called_time(self):
        """WITSML 1.4 and 2.0."""
        curves = "".join("<logCurveInfo><mnemonic>%s</mnemonic><unit>%s</unit></logCurveInfo>" % both for both in (("TIME", "m"), ("HKLD", "klbf"), ("BPOS", "ft")))
        data = "".join("<data>%s</data>" % line for line in LINES.split())
        self.refused("its index is measured depth", "<logs><log><indexType>measured depth</indexType><indexCurve>TIME</indexCurve>%s<logData>"
                     "<mnemonicList>TIME,HKLD,BPOS</mnemonicList><unitList>m,klbf,ft</unitList>%s</logData></log></logs>" % (curves, data), name="r.xml")
        channels = "".join("<Channel><Mnemonic>%s</Mnemonic><Uom>%s</Uom></Channel>" % both for both in (("HKLD", "klbf"), ("BPOS", "ft")))
        self.refused("its index is measured depth", "<Log xmlns='http://www.energistics.org/energyml/data/witsmlv2'><ChannelSet><Index><IndexType>measured depth</IndexType><Uom>s</Uom>"
                     "<Mnemonic>TIME</Mnemonic></Index>%s<Data><Data>[[[0],[200,30]],[[5],[201,29.5]]]</Data></Data></ChannelSet></Log>" % channels, name="r.xml")

    def test_las_whose_start_differs(self):
        las = "~V\nVERS. 2.0 :\nWRAP. NO :\n~W\nSTRT.%s %s :\nNULL. -999.25 :\n~C\nTIME.S :\nHKLD.KLBF :\nBPOS.FT :\n~A\n0 200 30\n5 201 29.5\n"
        self.assertNotIn("STRT", "\n".join(self.read(las % ("S", "0.0"), name="r.las").remarks))
        self.assertIn("STRT is 100, TIME of the first row 0", "\n".join(self.read(las % ("S", "100"), name="r.las").remarks))
        self.assertIn("that of STRT is M: S is used", "\n".join(self.read(las % ("M", "0"), name="r.las").remarks))


class UnitsInCells(Folder):
    def table(self, head, cells):
        return "\n".join([head, *(cells % row for row in RIGHT)]) + "\n"

    def test_what_is_read(self):
        for head, cells in (("Time,Hook Load,Block Height", "%d s,%.1f klbf,%.1f ft"), ("Time (s),Hook Load,Block Height", "%d,%.1fklbf,%.1fft"),
                            (HEAD, "%d,%.1f klbf,%.1f"), ("Time;Hook Load;Block Height", '%d s;%.1f klb;%.1f\'')):
            with self.subTest(cells):
                self.right(self.read(self.table(head, cells)), ["Hook Load", "its cells hold their unit (first: "])

    def test_some_cells_beside_a_unit_in_the_header(self):
        text = self.table(HEAD, "%d,%.1f,%.1f").replace("201.0", "201.0 klbf")
        self.right(self.read(text))

    def test_what_is_refused(self):
        bare = self.table("Time (s),Hook Load,Block Height (ft)", "%d,%.1f klbf,%.1f")
        for text, said in ((self.table(HEAD, "%d,%.1f kN,%.1f"), "r.csv:2: Hook Load (klbf): 200.0 kN is in another unit than the header says (klbf)"),
                           (bare.replace("203.0 klbf", "203.0 kN"), "r.csv:5: Hook Load: 203.0 kN is in another unit than the cells before (klbf)"),
                           (bare.replace("203.0 klbf", "203.0"), "r.csv:5: Hook Load: 203.0 has no unit, others of this column have one")):
            self.refused(said, text)
        self.assertIn("unit psi is not known for a force", "\n".join(self.read(self.table("Time (s),Hook Load,Block Height (ft)", "%d,%.1f psi,%.1f")).remarks))


class WrongDigits(Folder):
    """Single rows whose numbers are in range, and that no rig has between those before and after."""

    def remarks(self, row=None, load="200", block="20", rows=15):
        lines = ["%d,%s,%s" % (k, *((load, block) if k == row else ("200", "%.2f" % (20.0 - 0.1 * k)))) for k in range(rows)]
        return "\n".join(self.read("Time (s),Hook Load (kN),Block Height (m)\n" + "\n".join(lines) + "\n").remarks)

    def test_hook_load(self):
        self.assertIn("hook_load: 1 values are 10 times as large as all others or more (first: 2000 kN at 7 s); check their digits", self.remarks(7, load="2000"))
        for row, load in ((7, "700"), (0, "2000"), (14, "2000"), (7, "20")):  # a pull; the string before and after the slips; the slips
            self.assertNotIn("check their digits", self.remarks(row, load=load))

    def test_block(self):
        self.assertIn("block_height changes by -17.4 m from 6 to 7 s, faster than blocks move (2 times); check its values", self.remarks(7, block="2.0"))
        self.assertNotIn("faster than blocks", self.remarks(7, block="16.5"))
        self.assertNotIn("check", self.remarks())


class ElapsedTimes(Folder):
    def test_what_is_read(self):
        for head, times in (("Time (hh:mm:ss)", ("25:00:05", "25:00:10", "25:00:15", "25:00:20")), ("Elapsed", ("0:59:50", "0:59:55", "1:00:00", "1:00:05")),
                            ("Elapsed Time", ("1 day 00:00:00", "1 day 00:00:05", "1 day 00:00:10", "1d 00:00:15")), ("Time (mm:ss)", ("59:50", "59:55", "60:00", "60:05"))):
            with self.subTest(head):
                rows = "\n".join("%s,%.1f,%.1f" % (time, *row[1:]) for time, row in zip(times, RIGHT))
                record = self.read("%s,Hook Load (klbf),Block Height (ft)\n%s\n" % (head, rows))
                self.assertEqual([0.0, 5.0, 10.0, 15.0], list(record.time))
                self.assertIn("is read as elapsed time (first: ", "\n".join(record.remarks))

    def test_times_of_the_day_need_a_date(self):
        rows = "".join("10:00:%02d,%.1f,%.1f\n" % row for row in RIGHT)
        self.refused("r.csv:2: Time: 10:00:00 is not a date", "Time,Hook Load (klbf),Block Height (ft)\n" + rows)


if __name__ == "__main__":
    unittest.main()
