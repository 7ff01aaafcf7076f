#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Records with columns that mark values as good or bad, with set points beside readings, a block in feet under a heading of metres, factors in names, and lines that
several delimiters part. See test_record.py."""
import unittest

import numpy
from drill_rig_sim.field.fit_plan import weights_of
from drill_rig_sim.campaign.plan_text import plan_of
from drill_rig_sim.field.record import RecordError
from drill_rig_sim.field.units import power_in
from record_folder import FEET, KLBF, ROWS, Folder

HEAD = "Time (s),Hook Load (klbf),Block Height (ft)"


def table(name, cells, wrong=999.0):
    """ROWS with a column of flags; a row more, whose hook load is wrong, carries the last cell."""
    lines = [*((*row, cell) for row, cell in zip(ROWS, cells)), (20, wrong, 27.0, cells[-1])]
    return HEAD + "," + name + "\n" + "".join("%g,%g,%g,%s\n" % line for line in lines)


class Rows(Folder):
    def test_what_is_marked_bad_is_left_out(self):
        for name, good, bad in (("Status", "GOOD", "BAD"), ("Quality", "good", "questionable"), ("QC", "", "BAD"), ("QC", "1", "999"), ("QC", "0", "-999.25"), ("QC Flag", "P", "F"),
                                ("Data Quality", "192", "24"), ("Valid", "1", "0"), ("Bad Data", "false", "true"), ("Comments", "drilling ahead", "bad data"), ("QC (code)", "ok", "suspect")):
            with self.subTest(name, good=good, bad=bad):
                record = self.read(table(name, [good] * 4 + [bad]))
                self.right(record)
                self.assertIn("1 of 5 rows are marked %s by %s and are left out (first: " % (bad, name), "\n".join(record.remarks))
                self.assertIn("r.csv:6)", "\n".join(record.remarks))

    def test_what_is_none(self):
        """What the rig does, a measure, the same everywhere, a flag of another thing."""
        for name, cells in (("Status", ["Drilling", "In slips", "Drilling", "Tripping"]), ("Rig Status", list("1234")), ("QC", ["ok"] * 4), ("QC", ["0"] * 4), ("Slips Status", list("0110")),
                            ("Signal Quality (%)", ["91.5", "92", "93", "94"]), ("QC Date", list("1212")), ("Comments", ["", "bad weather", "", "wait"])):
            with self.subTest(name, cells=cells):
                record = self.read(table(name, [*cells, cells[-1]], wrong=204.0))
                self.assertEqual(5, len(record.time))
                self.assertNotIn("marked", "\n".join(record.remarks))

    def test_neither_good_nor_bad(self):
        record = self.read(table("Quality", ["good", "good", "interpolated", "good", "bad"]))
        self.assertIn("1 of 5 rows are marked interpolated by Quality and are used", "\n".join(record.remarks))

    def test_unclear(self):
        self.refused(["r.csv: QC holds 0 and 1: which of them mark bad values is not known", "quality: {column: QC, good: 0}"], table("QC", list("00001")))
        self.refused("Quality holds A and B", table("Quality", list("AAAAB")))
        self.refused("all rows are marked bad by QC", table("QC", ["bad"] * 5))
        self.assertIn("Status holds 0 and 1: which of them mark bad values is not known", "\n".join(self.read(table("Status", list("00001"))).remarks))

    def test_map(self):
        """Numbers and words, as the map says; one list for several columns."""
        times = "time: {column: Time, unit: s}\n"
        self.right(self.read(table("QC", list("00001")), times + "quality: {column: QC, good: 0}\n"))
        self.right(self.read(table("X7", ["fine", "A", "fine", "A", "B"]), times + "quality: [{column: X7, good: [fine, A]}]\n"))
        self.right(self.read(table("QC", ["1", "2", "1.0", "2", "3"]), times + "quality: {column: QC, good: [1, 2]}\n"))
        self.refused("needs good", table("QC", list("00001")), times + "quality: {column: QC}\n")
        self.refused("there is no column QQ", table("QC", list("00001")), times + "quality: {column: QQ, good: 0}\n")


class Columns(Folder):
    def test_of_a_signal(self):
        for flags in ("HKLD_QC", "Hook Load Quality", "QC Hook Load", "HookLoadStatus", "hook load valid", "Hook Load (klbf) Quality"):
            good, bad = ("1", "0") if "valid" in flags else ("good", "bad")
            record = self.read("Time (s),Hook Load (klbf),%s,Block Height (ft)\n" % flags + "".join("%g,%g,%s,%g\n" % (time, load if k != 2 else 5.0, bad if k == 2 else good, block)
                                                                                                for k, (time, load, block) in enumerate(ROWS)))
            numpy.testing.assert_allclose(record.signals["block_height"], [FEET * row[2] for row in ROWS])
            self.assertTrue(numpy.isnan(record.signals["hook_load"][2]), flags)
            numpy.testing.assert_allclose(record.signals["hook_load"][[0, 1, 3]], [KLBF * ROWS[k][1] for k in (0, 1, 3)])
            self.assertIn("hook_load: 1 of 4 values are marked bad by" if bad == "bad" else "hook_load: 1 of 4 values are marked 0 by", "\n".join(record.remarks))

    def test_behind_each_column(self):
        """Several columns called alike: each is of the column before it."""
        record = self.read("Time (s),Hook Load (klbf),QC,Block Height (ft),QC,Gas,QC\n" + "".join(
            "%g,%g,%s,%g,%s,1,bad\n" % (*row[:2], "bad" if k == 1 else "ok", row[2], "bad" if k == 2 else "ok") for k, row in enumerate(ROWS)))
        self.assertEqual([False, True, False, False], list(numpy.isnan(record.signals["hook_load"])))
        self.assertEqual([False, False, True, False], list(numpy.isnan(record.signals["block_height"])))

    def test_las(self):
        lines = "".join("%g %g %g %s\n" % (*row, "G") for row in ROWS) + "20 5 27 B\n"
        text = "~V\nVERS. 2.0 :\nWRAP. NO :\n~W\nSTRT.S 0 :\nNULL. -999.25 :\n~C\nTIME.S :\nHKLD.KLBF :\nBPOS.FT :\nQC. : quality\n~A\n"
        self.right(self.read(text + lines, name="r.las"), ["1 of 5 rows are marked B by QC and are left out"])

    def test_witsml(self):
        text = ('<logs xmlns="http://www.witsml.org/schemas/1series" version="1.4.1.1"><log><nameWell>a</nameWell><indexType>date time</indexType><indexCurve>TIME</indexCurve>'
                "<logData><mnemonicList>TIME,HKLD,BPOS,HKLD_QC</mnemonicList><unitList>s,klbf,ft,unitless</unitList>%s</logData></log></logs>")
        data = "".join("<data>2024-05-01T10:00:%02dZ,%g,%g,%d</data>" % (*row, 192 if k else 0) for k, row in enumerate(ROWS))
        record = self.read(text % data, name="r.xml")
        self.assertEqual([True, False, False, False], list(numpy.isnan(record.signals["hook_load"])))

    def test_witsml_2(self):
        """A value with its quality, as the channel's metadata of points say."""
        channel = ('<Channel><Mnemonic>%s</Mnemonic><Uom>%s</Uom>%s</Channel>')
        quality = "<PointMetadata><Name>Quality</Name><DataKind>boolean</DataKind></PointMetadata>"
        rows = ",".join('[["2024-05-01T10:00:%02dZ"],[[%g,%s],%g]]' % (time, load, "false" if k == 3 else "true", block) for k, (time, load, block) in enumerate(ROWS))
        text = ('<Log xmlns="http://www.energistics.org/energyml/data/witsmlv2"><ChannelSet><Index><IndexType>date time</IndexType><Mnemonic>TIME</Mnemonic></Index>'
                + channel % ("HKLD", "klbf", quality) + channel % ("BPOS", "ft", "") + "<Data><Data>[%s]</Data></Data></ChannelSet></Log>" % rows)
        record = self.read(text, name="r.xml")
        self.assertEqual([False, False, False, True], list(numpy.isnan(record.signals["hook_load"])))
        numpy.testing.assert_allclose(record.signals["block_height"], [FEET * row[2] for row in ROWS])


class Weights(Folder):
    def read_weights(self, text):
        self.file("w.csv", text)
        return weights_of(plan_of(self.file("fit.yaml", "table: {file: w.csv}\n")).mapping(("table",))["table"], self.folder)

    def test_a_model_beside_what_was_measured(self):
        for names in ("pick_up (kN),pick_up (model) (kN)", "pick_up (kN),pick_up planned (kN)"):
            depths, found, *_ = self.read_weights("depth (m),%s\n1000,500,450\n2000,800,650\n" % names)
            numpy.testing.assert_allclose(found["pick_up"], [500e3, 800e3])
        depths, *_ = self.read_weights("depth (TVD) (m),depth (MD) (m),pick_up (kN)\n900,1000,500\n1800,2000,800\n")
        numpy.testing.assert_allclose(depths, [1000.0, 2000.0])
        with self.assertRaisesRegex(RecordError, "several columns are pick_up: pick_up .kN., pick_up .raw. .kN.; needed: one"):
            self.read_weights("depth (m),pick_up (kN),pick_up (raw) (kN)\n1000,500,450\n")

    def test_a_title(self):
        depths, found, remarks, *_ = self.read_weights("Data Type: Model\nWell: A-1\ndepth (m),pick_up (kN)\n1000,500\n2000,800\n")
        numpy.testing.assert_allclose(found["pick_up"], [500e3, 800e3])
        self.assertIn("w.csv: line 1 says that its values are not measured: Data Type: Model", "\n".join(remarks))

    def test_marked_rows_are_left_out(self):
        text = "depth (ft),pick_up (klbf),slack_off (klbf),Status\n3000,100,90,ok\n3500,300,250,BAD\n4000,120,100,ok\n"
        self.file("w.csv", text)
        entry = plan_of(self.file("fit.yaml", "table: {file: w.csv}\n")).mapping(("table",))["table"]
        depths, found, remarks, *_ = weights_of(entry, self.folder)
        numpy.testing.assert_allclose(depths, [3000 * FEET, 4000 * FEET])
        numpy.testing.assert_allclose(found["pick_up"], [100 * KLBF, 120 * KLBF])
        self.assertIn("marked BAD by Status", "\n".join(remarks))


class ConvertedNulls(Folder):
    """-999.25 and the like, taken to the unit of a column with all its numbers."""
    def torque(self, head, cells):
        rows = "".join("%d,500,20,%s\n" % (k, cell) for k, cell in enumerate(cells))
        record = self.read("Time (s),Hook Load (kN),Block Height (m),%s\n%s" % (head, rows))
        return record.signals[head.partition(" (")[0].lower().replace(" ", "_").replace("flow_in", "flow")], "\n".join(record.remarks)

    def test_left_out(self):
        for head, null, said in (("Torque (N.m)", "-1354.80", "-999.25 ft.lbf"), ("Torque (kN.m)", "-1.355", "-999.25 ft.lbf"), ("Torque (kft.lbf)", "-0.737", "-999.25 N.m"),
                                 ("Flow In (gpm)", "-263.97", "-999.25 L/min"), ("Torque (N.m)", "-13556.82", "-9999 ft.lbf")):
            with self.subTest(head, null=null):
                values, remarks = self.torque(head, ["5.2", "5.1", null, null, "5.3"])
                self.assertEqual([False, False, True, True, False], list(numpy.isnan(values)))
                self.assertIn("2 values of %g %s are %s, a null value in another unit, and are treated as null values (first: " % (float(null), head.partition("(")[2][:-1], said), remarks)
                self.assertIn("r.csv:4)", remarks)

    def test_numbers(self):
        """Other digits; no negative value; a torque that goes on below zero; too few digits: -1 kN.m is not -999.25 N.m."""
        for cells in (["5200", "5100", "-1353.2", "5300"], ["5200", "5100", "1354.80", "5300"], ["5200", "-900", "-1354.80", "-1200"]):
            with self.subTest(cells):
                values, remarks = self.torque("Torque (N.m)", cells)
                self.assertTrue(numpy.isfinite(values).all())
                self.assertNotIn("null value", remarks)
        values, remarks = self.torque("Torque (kN.m)", ["5", "6", "-1", "5"])
        self.assertTrue(numpy.isfinite(values).all())
        self.assertNotIn("null value", remarks)


class TwoColumns(Folder):
    """Of one signal."""
    def test_the_one_in_a_unit_of_its_quantity_is_taken(self):
        rows = "".join("%g,%g,%g,%g,%g\n" % (*row, 300.0 + k, 5.0) for k, row in enumerate(ROWS))
        record = self.read("Time (s),Hook Load (klbf),Block Height (ft),Torque (amps),Rotary Torque (kft-lb)\n" + rows)
        numpy.testing.assert_allclose(record.signals["torque"], 5e3 * 1.3558179483314)
        self.assertIn("torque is taken from Rotary Torque (kft-lb); not used: Torque (amps)", "\n".join(record.remarks))

    def test_other_numbers_in_another_unit(self):
        head = "Time (s),Hook Load (klbf),Block Height (ft),Hook Load (kN)\n"
        for share, differs in ((1.0, False), (1.005, False), (0.9, True)):
            record = self.read(head + "".join("%g,%g,%g,%g\n" % (*row, share * row[1] * KLBF / 1e3) for row in ROWS))
            said = "hook_load: Hook Load (kN) is usually %.3g times Hook Load (klbf), both in the same unit; is one of their units wrong?" % share
            self.assertEqual(differs, said in "\n".join(record.remarks), record.remarks)


class NotMeasured(Folder):
    def test_set_points_are_no_readings(self):
        """`Hook Load (set point)` beside the gauge, and alone."""
        for words in ("set point", "target", "planned", "model", "SP", "alarm", "std dev", "delta"):
            head = "Time (s),Hook Load (%s) (klbf),Hook Load (klbf),Block Height (ft)\n" % words
            self.right(self.read(head + "".join("%g,77,%g,%g\n" % row for row in ROWS)))
            record = self.read("Time (s),Hook Load (%s) (klbf),Block Height (ft)\n" % words + "".join("%g,77,%g\n" % (row[0], row[2]) for row in ROWS))
            self.assertNotIn("hook_load", record)


    def test_other_lines_than_the_stand_pipe(self):
        for name in ("SPP (choke)", "Flow In (booster)", "Pump Pressure (cement)", "Bit Depth (lagged)"):
            unit = "bar" if "P" in name else "lpm" if "Flow" in name else "m"
            record = self.read("Time (s),Hook Load (klbf),Block Height (ft),%s (%s)\n" % (name, unit) + "".join("%g,%g,%g,100\n" % row for row in ROWS))
            self.right(record)
            self.assertEqual({"time", "hook_load", "block_height"}, set(record.signals), name)

    def test_what_else_brackets_say(self):
        """It may change the numbers: reported, but for words that every rig uses."""
        for words, said in (("excl. block", True), ("tared", True), ("avg", False), ("surface", False), ("average of 5 s", True), ("raw", False)):
            record = self.read("Time (s),Hook Load (%s) (klbf),Block Height (ft)\n" % words + "".join("%g,%g,%g\n" % row for row in ROWS))
            self.right(record)
            self.assertEqual(said, "hook_load: (%s) in the name of Hook Load (%s) (klbf) is not taken into account" % (words, words) in "\n".join(record.remarks), words)

    def test_downhole_tools_are_none_of_the_rig(self):
        for name in ("Hook Load (MWD)", "Hook Load (downhole)"):
            record = self.read("Time (s),%s (klbf),Block Height (ft)\n" % name + "".join("%g,%g,%g\n" % row for row in ROWS))
            self.assertNotIn("hook_load", record)

    def test_depths_from_the_rotary_table(self):
        for unit, factor in (("ftKB", FEET), ("mMD", 1.0), ("m RKB", 1.0), ("ft MD RKB", FEET), ("ft", FEET)):
            record = self.read("Time (s),Hook Load (klbf),Bit Depth (%s)\n" % unit + "".join("%g,%g,%g\n" % row for row in ROWS))
            numpy.testing.assert_allclose(record.signals["bit_depth"], [factor * row[2] for row in ROWS])
        self.assertNotIn("bit_depth", self.read("Time (s),Hook Load (klbf),Bit Depth (ftTVD)\n" + "".join("%g,%g,%g\n" % row for row in ROWS)))


class Feet(Folder):
    def rig(self, pipe, unit, connections=4):
        """A trip in with pipe of a length [m], its lengths written in one unit and called metres."""
        rows, time, bit, block = [], 0.0, 1000.0, 2.0 + pipe
        for _ in range(connections):
            for step in range(11):
                rows.append((time, 200.0, (block - pipe * step / 10) / unit, (bit + pipe * step / 10) / unit))
                time += 10.0
            bit += pipe
            for step in range(1, 6):
                rows.append((time, 20.0, (block - pipe * (1 - step / 5)) / unit, bit / unit))
                time += 10.0
        return "Time (s),Hook Load (klbf),Block Height (m),Bit Depth (m)\n" + "".join("%g,%g,%.3f,%.3f\n" % row for row in rows)

    PIPES = ((28.5, 1.0, None), (28.5, FEET, "farther than blocks do|higher than masts"), (9.45, 1.0, None), (9.45, FEET, "is its unit ft?"), (13.4, 1.0, None),
             (18.9, 1.0, None), (18.9, FEET, "is its unit ft?"), (38.1, 1.0, None))

    def reported(self, pipe, unit, said, text):
        with self.subTest(pipe, unit=unit):
            found = "\n".join(self.read(text).remarks)
            self.assertEqual(said is not None, "is its unit" in found, found)
            self.assertTrue(said is None or any(part in found for part in said.split("|")), found)

    def test_pipe(self):
        for pipe, unit, said in self.PIPES:
            self.reported(pipe, unit, said, self.rig(pipe, unit))

    def test_pipe_without_a_bit_depth(self):
        """The hook load shows where the block moves without the string; the string's weight grows with each stand."""
        for pipe, unit, said in self.PIPES:
            lines = [line.rpartition(",")[0] for line in self.rig(pipe, unit).splitlines()]
            self.reported(pipe, unit, said, "\n".join(lines))
            for load in (200.0, 190.0):  # never in the slips, and always so
                self.assertNotIn("is its unit ft?", "\n".join(self.read("\n".join(lines).replace(",20,", ",%g," % load)).remarks))

    def test_pipe_by_the_speed_of_the_block(self):
        for unit, said in ((1.0, False), (FEET, True)):
            rows = [[float(cell) for cell in line.split(",")] for line in self.rig(9.45, unit).splitlines()[1:]]
            time, load, block, _ = numpy.array(rows).T
            middle = 0.5 * (time[1:] + time[:-1])
            text = "Time (s),Hook Load (klbf),Block Velocity (m/s)\n" + "".join(
                "%g,%g,%.5f\n" % row for row in zip(middle, load[1:], numpy.diff(block) / numpy.diff(time)))
            speeds = "time: {column: Time, unit: s}\nblock_velocity: {column: Block Velocity, unit: m/s}\n"
            self.assertEqual(said, "block_velocity: 3 times about 3" in "\n".join(self.read(text, speeds).remarks))

    def test_steps_of_depth(self):
        """Weights at each joint or stand. Lists by 30 m and 100 ft, and stands in metres, are none."""
        tape = 0.1 * numpy.array([0, 1, -1, 2, 0, -2, 1, 0])  # no two joints are alike
        for step, off, is_told in ((28.6, tape, False), (28.6 / FEET, tape, True), (9.45, tape, False), (9.45 / FEET, tape, True), (18.9 / FEET, tape, True), (18.9, tape, False), (57.2, tape, False),
                                   (31.0, 0.0, True), (94.0, 0.0, True), (30.0, 0.0, False), (30.48, 0.0, False), (91.44, 0.0, False), (90.0, 0.0, False)):
            depths = 2000.0 + step * numpy.arange(8) + off
            self.file("w.csv", "depth (m),pick_up (kN)\n" + "".join("%.2f,%g\n" % (depth, 0.2 * depth) for depth in depths))
            entry = plan_of(self.file("fit.yaml", "table: {file: w.csv}\n")).mapping(("table",))["table"]
            self.assertEqual(is_told, "is its unit ft?" in "\n".join(weights_of(entry, self.folder)[2]), step)


class Dates(Folder):
    def test_names_of_other_languages(self):
        for name in ("Zeit", "Uhrzeit", "Datum/Zeit", "Zeitstempel", "Fecha y hora", "Heure", "Data/Hora"):
            record = self.read("%s;Hook Load (klbf);Block Height (ft)\n" % name + "".join("01.05.2024 10:00:%02d;%g;%g\n" % row for row in ROWS).replace(".5;", ",5;").replace(".5\n", ",5\n")
                               .replace("01.05", "21.05"))
            self.right(record)
            self.assertEqual(1716285600.0, record.begin)  # 2024-05-21 10:00 UTC

    def test_a_mean_below_the_rows(self):
        """Beside dates a text is no time: its row is left out."""
        rows = "Time,Hook Load (klbf),Block Height (ft)\n" + "".join("2024-05-01T10:00:%02dZ,%g,%g\n" % row for row in ROWS)
        for end in ("Average,201.6,29.1\n", "Average,,\n", "End of file,,\n"):
            record = self.read(rows + end)
            self.right(record)
            self.assertTrue(any("1 rows have no time" in line or "1 lines of text" in line for line in record.remarks), record.remarks)
        self.refused("is not a date", rows.replace("2024-05-01T10:00:00Z", "morning"))


class SaidOfItself(Folder):
    """A header that says that the values are not measured."""
    SAID = "says that its values are not measured: "

    def remarks(self, text, name="r.csv"):
        return "\n".join(self.read(text, name=name).remarks)

    def test_above_the_names(self):
        rows = HEAD + "\n" + "".join("%g,%g,%g\n" % row for row in ROWS)
        for line in ("Data Type: Simulated", "# Data Type: Model", "Data Type,Synthetic,", "Well: A-1; Data Source = Forecast; Rig: 4", "SYNTHETIC DATA", "Source: Simulation (run 4)", "Status: Predicted values"):
            found = self.remarks("Well A-1\n" + line + "\n" + rows)
            self.assertIn("r.csv: line 2 " + self.SAID, found, line)
        for line in ("Data Type: Measured", "Rig Model: NOV", "Rig Model,NOV,", "Source: Pason EDR", "Well Plan: rev 4", "Calculated by Pason", "Time log", "Generated 2024-05-22 10:00", "Well type: Development", "Data Type: Real time"):
            self.assertNotIn(self.SAID, self.remarks("Well A-1\n" + line + "\n" + rows), line)

    def test_las(self):
        rows = "~C\nTIME.S :\nHKLD.KLBF :\nBPOS.FT :\n~A\n" + "".join("%g %g %g\n" % row for row in ROWS)
        for section, said in (("~P\nDTYP.  SIMULATED : Data type\n", True), ("~O\nData Type: Model\n", True), ("~P\nDTYP.  MEASURED : Data type\nRIG. A : model of the rig\n", False)):
            text = "~V\nVERS. 2.0 :\nWRAP. NO :\n~W\nSTRT.S 0 :\nNULL. -999.25 :\n" + section + rows
            self.assertEqual(said, self.SAID in self.remarks(text, "r.las"), section)

    def test_witsml(self):
        text = ('<logs xmlns="http://www.witsml.org/schemas/1series" version="1.4.1.1"><log><nameWell>a</nameWell><indexType>date time</indexType><indexCurve>TIME</indexCurve>'
                "<logData><mnemonicList>TIME,HKLD,BPOS</mnemonicList><unitList>s,klbf,ft</unitList>%s</logData>%%s</log></logs>")
        text %= "".join("<data>2024-05-01T10:00:%02dZ,%g,%g</data>" % row for row in ROWS)
        for end, said in (("<commonData><itemState>model</itemState></commonData>", True), ("<commonData><itemState>plan</itemState></commonData>", True),
                          ("<commonData><itemState>actual</itemState></commonData>", False), ("<description>Data Type: Simulated</description>", True), ("<description>Time log</description>", False), ("", False)):
            self.assertEqual(said, self.SAID in self.remarks(text % end, "r.xml"), end)


class Factors(Folder):
    """Powers of ten in the names of columns and in units."""

    def test_obeyed(self):
        for name, per in (("Hook Load x1000 (lbf)", 1.0), ("Hook Load (klbf x 10)", 0.1), ("Hook Load (1000 lbf)", 1.0), ("Hook Load x1000 lbf", 1.0), ("Hook Load, x1000 lbf", 1.0), ("Hook Load *0.1 (klbf)", 10.0),
                          ("Hook Load \u00d710\u00b3 (lbf)", 1.0), ("Hook Load [10^3 lbf]", 1.0), ("Hook Load (lbf*100)", 10.0), ("HKLDx1000 (lbf)", 1.0), ("Hook Load (x1000) (lbf)", 1.0), ("Hook Load (avg) (x1000 lbf)", 1.0), ("Hook Load (avg) x1000 (lbf)", 1.0), ("Hook Load (surface) *0.1 [klbf]", 10.0), ("Hook Load (10^3) (lbf)", 1.0), ("Hook Load 1e3 lbf", 1.0), ("Hook Load 10^3 (lbf)", 1.0), ("Hook Load 10\u00b3 (lbf)", 1.0)):
            record = self.read("Time (s),\"%s\",Block Height (ft)\n" % name + "".join("%g,%.10g,%g\n" % (time, per * load, block) for time, load, block in ROWS))
            with self.subTest(name):
                self.right(record)
                self.assertEqual("x" in name or "*" in name or "\u00d7" in name or any(sign in name for sign in "^\u00b3"), "is read in" in "\n".join(record.remarks), record.remarks)

    def test_refused(self):
        rows = "".join("%g,%g,%g\n" % row for row in ROWS)
        for name, said in (("Hook Load x1000", "x1000 is a factor without a unit; needed: one behind it, x1000 N"), ("Hook Load (x1000)", "x1000 is a factor without a unit"),
                           ("Hook Load (lbf/1000)", "unit lbf/1000 is not known for a force; allowed: N"), ("Hook Load (lbf x 7)", "not known for a force")):
            record = self.read("Time (s),%s,Block Height (ft)\n" % name + rows)
            self.assertNotIn("hook_load", record)
            self.assertIn(said, "\n".join(record.remarks))
        header = "Time (s),Hook Load x1000,Block Height (ft)\n" + rows
        times = "time: {column: Time, unit: s}\nhook_load: {column: Hook Load x1000, unit: %s}\n"
        self.refused("the file says a factor (x1000), the map a unit without one (lbf); needed: unit: x1000 lbf, or x1 lbf where the numbers are lbf", header, times % "lbf")
        self.right(self.read(header, times % "x1000 lbf"))
        numpy.testing.assert_allclose(self.read(header, times % "x1 klbf").signals["hook_load"][0], 200 * KLBF)

    def test_a_number_in_brackets(self):
        record = self.read("Time (s),Hook Load (1000) (lbf),Block Height (ft)\n" + "".join("%g,%g,%g\n" % row for row in ROWS))
        self.right(record, ["hook_load: Hook Load (1000) (lbf) is read in x1000 lbf: 1 is 4448.22 N"])

    def test_above_a_line_of_units(self):
        text = "Time,Hook Load%s,Block Height\ns,%s,ft\n" + "".join("%g,%g,%g\n" % row for row in ROWS)
        self.right(self.read(text % (" x1000", "lbf")))
        self.right(self.read(text % ("", "x1000 lbf")))
        self.assertIn("lbf/1000 is not known", "\n".join(self.read(text % ("", "lbf/1000")).remarks))

    def test_what_is_no_factor(self):
        """A mean over 10 s; a box of ten; no power of ten, and none of any size."""
        for text in ("9" * 40 + " m", "9" * 9999, "x " * 9999, "9" * 400 + " m", "1" + "0" * 400 + " m", "x7 m", "x0 m", "10 m", ". m"):
            self.assertEqual((None, ""), power_in(text))
        self.assertEqual((1e3, "m"), power_in("x10^3 m"))
        rows = "".join("%g,%g,%g\n" % row for row in ROWS)
        self.right(self.read("Time (s),Hook Load (klbf) (10 s),Block Height (ft)\n" + rows))
        self.right(self.read("Time (s),Hook Load (klbf),Block Height (ft),Box 10,Max10\n" + rows.replace("\n", ",1,2\n")))

    def test_weights(self):
        self.file("w.csv", "depth (m),pick_up x1000 (lbf)\n1000,100\n1500,120\n")
        entry = plan_of(self.file("fit.yaml", "table: {file: w.csv}\n")).mapping(("table",))["table"]
        numpy.testing.assert_allclose(weights_of(entry, self.folder)[1]["pick_up"], [100 * KLBF, 120 * KLBF])


class Delimiters(Folder):
    """Names and rows that may be parted by several signs."""

    def test_the_one_that_parts_names_and_rows(self):
        lines = "".join("%.1f;%.1f;%.1f\n" % row for row in ROWS).replace(".", ",")
        self.all_right({"commas in names, by tabs": "Time, s\tHook Load, klbf\tBlock Height, ft\n" + "".join("%g\t%g\t%g\n" % row for row in ROWS),
                        "commas in names and numbers, by semicolons": "Time, s;Hook Load, klbf;Block Height, ft\n" + lines,
                        "a title with more commas": "Well A, B, C, D, E, F\nTime (s);Hook Load (klbf);Block Height (ft)\n" + lines,
                        "a title before bars": "Well: A-3\nRig: 7\n\n" + HEAD.replace(" (", ", ").replace(")", "").replace("Time, s,", "Time, s|").replace("klbf,", "klbf|") + "\n" + "".join("%g|%g|%g\n" % row for row in ROWS),
                        "a comma and a tab": HEAD.replace(",", ",\t") + "\n" + "".join("%g,\t%g,\t%g\n" % row for row in ROWS),
                        "a delimiter at the end of rows": HEAD + "\n" + "".join("%g,%g,%g,\n" % row for row in ROWS)})

    def test_refused(self):
        """Where another sign parts the same lines into other numbers, and where decimal commas may stand between commas."""
        self.all_refused({
            "two delimiters": ("Time (s),Hook Load (klbf),x;Time (s);Hook Load (klbf)\n0,200,1;5;300\n5,201,1;9;300\n",
                               "r.csv:1: names and rows can be split at comma or at semicolon, with different results; needed: delimiter: "),
            "decimal commas below names with commas": ("Time, s,Hook Load, klbf,Block Height, ft\n0,0,200,5,30,1\n5,0,201,5,29,1\n",
                                                       "r.csv:1: its names contain the delimiter, a comma before the unit (s, klbf, ft)"),
            "decimal commas before empty cells": (HEAD + ",Gas,Temp,x\n0,0,200,5,30,1,,,\n5,0,201,5,29,1,,,\n", "r.csv:2: has 9 cells, the header 6"),
            "decimal commas below empty names": (HEAD + ",,,\n0,0,200,5,30,1\n5,0,201,5,29,1\n", "r.csv:2: has 6 cells, the header 3")})
        text = "Time (s),Hook Load (klbf),x;Time (s);Hook Load (klbf)\n0,200,1;5;300\n5,201,1;9;300\n"
        self.assertEqual([0.0, 5.0], list(self.read(text, "delimiter: comma\n").time + 0.0))


if __name__ == "__main__":
    unittest.main()
