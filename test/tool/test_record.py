#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Records of rigs are read as they are published: delimited tables here, WITSML and LAS in test_record_logs.py; and what is wrong in them is refused or reported by file, row and column.
The kinds are those of test/cases, each with variants."""
import datetime
import io
import math
import os
import unittest
import zipfile

import numpy
from drill_rig_sim.field.dates import seconds_of, written
from drill_rig_sim.field.record import RecordError, read_record
from drill_rig_sim.field.units import QUANTITIES, UnitError, factor_of
from drill_rig_sim.sim import units
from record_folder import CASES, FEET, KLBF, MAP, ROWS, STAMPS, Folder


def table(delimiter=",", header=("T", "H", "B"), number="%g", times=None, end="\n"):
    rows = [delimiter.join(header)] + [delimiter.join([times[k] if times else number % t, number % h, number % b]) for k, (t, h, b) in enumerate(ROWS)]
    return end.join(rows) + end


class Tables(Folder):
    def test_columns_by_a_map(self):
        columns = "time: {column: T, unit: min}\nhook_load: {column: Hook Load, unit: klbf}\nblock_height: {column: B, unit: ft}\nflow: {column: Q, unit: gpm}\n"
        record = self.read("T, Hook Load,B,Q,x\n1,100,30,500,a\n2,-,29,500,b\n\n3,101,28,500,c\n", columns)
        self.assertEqual([0.0, 60.0, 120.0], list(record.time))
        self.assertAlmostEqual(444822.16152605, record.at("hook_load", 0.0), places=4)
        self.assertAlmostEqual(0.5 * (100 + 101) * KLBF, record.at("hook_load", 60.0), places=3)
        self.assertTrue(math.isnan(record.signals["hook_load"][1]))
        self.assertAlmostEqual(30 * FEET, record.at("block_height", 0.0))
        self.assertAlmostEqual(500 * 3.785411784e-3 / 60, record.at("flow", 10.0))

    def test_delimiters_decimal_commas_and_ends_of_lines(self):
        for text in (table(), table(";"), table("\t"), table(end="\r\n"), table(end="\r"), table().replace("\n", ",\n"), "# by hand\n\n" + table(), table().replace("T,H,B", '"T","H","B"')):
            self.right(self.read(text, MAP))
        comma = table(";", number="%.2f").replace(".", ",")
        self.right(self.read(comma, MAP), ["its numbers have decimal commas"])
        self.right(self.read(comma, MAP + "decimal: comma\ndelimiter: semicolon\n"))
        self.assertNotIn("decimal", "".join(self.read(comma, MAP + "decimal: comma\n").remarks))

    def test_columns_by_the_names_of_the_trade(self):
        self.right(self.read(table(header=("Time (s)", "Hook Load (klbs)", "Block Height (feet)"))))
        self.right(self.read(table(header=("TIME [sec]", "HKLA [KLB]", "BPOS [FT]"))))
        self.right(self.read(table(header=("time", "HKLD", "BLOCKCOMP")).replace("BLOCKCOMP\n", "BLOCKCOMP\ns,klbf,ft\n")), ["line 2 was read as the units"])
        self.right(self.read(table(header=("DateTime", "Hookload (klbf)", "block_position (ft)"), times=STAMPS)))
        date = table(header=("YYYY/MM/DD,HH:MM:SS", "Hook Load (klbs)", "Block Height (feet)"), times=["2024/05/01,10:00:%02d" % row[0] for row in ROWS])
        self.right(self.read(date))
        two = self.read(table(header=("Time (s)", "HKLA (klbf)", "HKLD (klbf)")))
        self.assertAlmostEqual(30.0 * KLBF, two.at("hook_load", 0.0))
        self.assertIn("hook_load is taken from HKLD (klbf); not used: HKLA (klbf)", "\n".join(two.remarks))

    def test_a_column_without_a_unit_is_left_out_or_refused(self):
        record = self.read(table(header=("Time (s)", "HKLD (klbf)", "BPOS")))
        self.assertNotIn("block_height", record)
        self.assertIn("block_height: BPOS is left out: it has no unit", "\n".join(record.remarks))
        self.refused("the time has no unit", table(header=("time", "HKLD (klbf)", "BPOS (ft)")))
        self.refused(["no column is recognised as the time", "columns: a, b, c"], table(header=("a", "b", "c")))

    def test_ragged_rows(self):
        """Kind 09: refused by line, with the columns as read."""
        good = table()
        for bad, said in ((good.replace("5,201,29.5", "5,201"), "r.csv:3: has 2 cells, the header 3 (T, H, B)"),
                          (good.replace("5,201,29.5", "5,201,29,5"), "r.csv:3: has 4 cells"), (good.replace("15,203,28", "15"), "r.csv:5: has 1 cells"),
                          (good.replace("0,200,30", "0,200,30,ok"), "r.csv:2: has 4 cells"), (good.replace("T,H,B", "T,H,B,Note"), "r.csv:2: has 3 cells"),
                          (table(number="%.1f").replace(".", ","), "r.csv:2: has 6 cells")):
            self.refused(said, bad, MAP)
        with self.assertRaisesRegex(RecordError, "ragged.csv:2: has 10 cells"):
            read_record(os.path.join(CASES, "09_ragged_rows/ragged.csv"), os.path.join(CASES, "09_ragged_rows/map.yaml"))

    def test_what_is_no_record(self):
        for text, columns, said in (("a,b\n1,2\n", None, "needed: a map"), ("T\n1\n2\n", "time: {column: X, unit: s}\n", "there is no column X; columns: T"),
                                    ("T\n1\n2\n", "time: {column: T, unit: fortnight}\n", "unit fortnight is not known for a time; allowed: s, ms"),
                                    ("T\n1\n2\n", "tim: {column: T, unit: s}\n", "unknown key"), ("T\n1\n\n3\n2\n", "time: {column: T, unit: s}\n", "r.csv:5: the time goes back to 2 s"),
                                    ("T\n1\n", "time: {column: T, unit: s}\n", "two rows"), ("", None, "is empty"), ("\n\n", None, "is empty"),
                                    ("T,T\n1,2\n2,3\n", "time: {column: T, unit: s}\n", "there are 2 columns T"),
                                    ("T,H\n1,1\n2,2\n", "time: {column: T, unit: s}\nhook_load: {column: H}\n", "hook_load: H has no unit"),
                                    ("T,H\na,1\nb,2\n", MAP[:MAP.index("block_height")], "r.csv:2: T: a is not a number of s"),
                                    ("T\n1\n2\n", "time: {column: T, unit: s, format: '%H'}\n", "must be date where there is a format")):
            self.refused(said, text, columns)
        self.assertRaisesRegex(RecordError, "/nowhere.csv: cannot be read", read_record, "/nowhere.csv")
        self.assertRaisesRegex(RecordError, "is not a regular file", read_record, self.folder)

    def test_what_its_reader_should_know(self):
        columns = "time: {column: T, unit: s}\nhook_load: {column: H, unit: klbf}\nblock_height: {column: B, unit: m}\n"
        rows = ["%d,%s,10" % (k if k < 20 else k + 60, {3: "-999.25", 4: "off", 5: ""}.get(k, "100")) for k in range(40)]
        record = self.read("T,H,B\n" + "\n".join(rows) + "\n,100,10\n", columns)
        self.assertEqual(3, numpy.isnan(record.signals["hook_load"]).sum())
        self.assertEqual(["1 cells of H hold text, not a number (first: %s:6: off)" % os.path.join(self.folder, "r.csv"),
                          "1 rows have no time and are left out (first: %s:42)" % os.path.join(self.folder, "r.csv"), "hook_load: 3 of 40 rows hold no measurement",
                          "a gap of 61 s from 19 s on", "has no flow: the pump is assumed to be off", "has no top_drive_speed: the string is assumed not to rotate",
                          "has no bit_depth: the string is assumed to move with the block at all times"], [line.split(": ", 1)[1] for line in record.remarks])


class Values(Folder):
    """Kind 04: nulls and values that cannot be."""

    def test_nulls_compare_as_numbers(self):
        for null in ("-999.25", "-999.2500", "-9999.25", "-999", "-9999", "-99999.25", "-9.9925e2", " -999.25 "):
            record = self.read(table().replace("201,29.5", null + ",29.5"), MAP)
            self.assertTrue(math.isnan(record.signals["hook_load"][1]), null)
        for null, cell in (("0", "0.00"), ("[-1, 777]", "777.0"), ("-1", "-1.0"), ("999.25", "999.25"), ("[0, 1e30]", "1E30")):
            record = self.read(table().replace("201,29.5", cell + ",29.5"), MAP + "null: %s\n" % null)
            self.assertTrue(math.isnan(record.signals["hook_load"][1]), null)

    def test_values_that_no_gauge_has(self):
        for cell in ("-8888", "1e9", "44684", "-100000", "1e300"):
            record = self.read(table().replace("201,29.5", cell + ",29.5"), MAP)
            self.assertTrue(math.isnan(record.signals["hook_load"][1]), cell)
            self.assertIn("hook_load: 1 of 4 values are out of range and are treated as missing (allowed: -112.404 to 4496.18 klbf; first: %s:3: H %g klbf)" %
                          (os.path.join(self.folder, "r.csv"), float(cell)), "\n".join(record.remarks))
        for cell in ("nan", "inf", "-Infinity", "NaN", "#N/A", "1,5e"):
            if "," not in cell:
                self.assertTrue(math.isnan(self.read(table().replace("201,29.5", cell + ",29.5"), MAP).signals["hook_load"][1]), cell)

    def test_full_displays(self):
        """Nines and eights far from all other values, as of a gauge that is lost or a display that is full."""
        for cell in ("999", "999.9", "999.99", "-999.99", "9999.9", "9999.99", "888.88", "8888"):
            with self.subTest(cell):
                record = self.read(table().replace("201,29.5", cell + ",29.5"), MAP)
                self.assertTrue(math.isnan(record.signals["hook_load"][1]))
                self.assertIn("1 values such as %g are far from all others and are treated as null values" % float(cell), "\n".join(record.remarks))
        near = table().replace("201,", "799,").replace("200,", "999,")
        self.assertFalse(numpy.isnan(self.read(near, MAP).signals["hook_load"]).any(), "a load near the others")

    def test_small_negative_nulls(self):
        """-99.99 in any signal, and any negative value that comes again in a hook load or depth that stays far from zero."""
        def rows(name, value, lost, low=200.0):
            cells = [low + k if k not in (3, 4) else lost for k in range(8)]
            return "Time (s),%s,BPOS (ft)\n" % name + "".join("%d,%g,%g\n" % (k, value * cell if cell is not lost else lost, 30.0 - 0.1 * k) for k, cell in enumerate(cells))
        for name, signal, value, lost in (("HKLD (klbf)", "hook_load", 1.0, -99.99), ("HKLD (klbf)", "hook_load", 1.0, -1.0), ("RPM (rpm)", "top_drive_speed", 0.5, -99.99), ("FLOWIN (gpm)", "flow", 2.0, -99.99),
                                          ("SPP (psi)", "stand_pipe_pressure", 1.0, -99.9), ("FLOWIN (gpm)", "flow", 2.0, -100.0),
                                          ("TQ (kft.lbf)", "torque", 0.1, -32.768), ("TQ (kft.lbf)", "torque", 0.1, -9.99), ("BITDEP (m)", "bit_depth", 10.0, -1.0)):
            with self.subTest(name=name, lost=lost):
                record = self.read(rows(name, value, lost))
                self.assertIn("%s: 2 values of %g, below all others, are treated as null values (first: %s:5)" % (name, lost, os.path.join(self.folder, "r.csv")), "\n".join(record.remarks))
                self.assertGreater(numpy.nanmin(record.signals[signal]), 0.0)
        for name, signal, lost, low in (("RPM (rpm)", "top_drive_speed", -20.0, 0.0), ("FLOWIN (gpm)", "flow", -2.0, 0.0), ("TQ (kft.lbf)", "torque", -1.0, 0.0), ("HKLD (klbf)", "hook_load", -1.0, 0.0), ("SPP (psi)", "stand_pipe_pressure", -0.5, 0.0)):
            with self.subTest(name=name, kept=lost):
                record = self.read(rows(name, 10.0, lost, low))
                self.assertLess(numpy.nanmin(record.signals[signal]), 0.0)
                self.assertNotIn("below all others", "\n".join(record.remarks))
        self.assertNotIn("below all others", "\n".join(self.read(rows("SPP (psi)", 0.1, -3.0)).remarks), "pumps that stand")

    def test_minus_signs(self):
        """As typesetters write them: the minus sign and the en dash."""
        for sign in "-\u2212\u2013":
            for text in ("Time (s),HKLD (klbf),TQ (kft.lbf)\n0,200,%s0.25\n5,201.5,1.5\n", "Time (s);HKLD (klbf);TQ (kft.lbf)\n0;200;%s0,25\n5;201,5;1,5\n"):
                record = self.read(text % sign)
                numpy.testing.assert_allclose(record.signals["torque"], [-0.25 * KLBF * FEET, 1.5 * KLBF * FEET])
                self.assertNotIn("hold text", "\n".join(record.remarks))

    def test_a_unit_that_is_wrong(self):
        """Most values out of range: refused, for the unit must be wrong."""
        self.refused(["hook_load", "4 of 4 values", "is the unit right?"], table(), MAP.replace("klbf", "MN"))
        with self.assertRaisesRegex(RecordError, "60 of 61 values are out of the range of top_drive_speed .* c/s"):
            read_record(os.path.join(CASES, "23_units_and_tables/01_rpm_c_per_s.xml"))

    def test_one_row_in_a_published_file(self):
        record = read_record(os.path.join(CASES, "04_nulls_taken_for_numbers/null_9999_25.csv"), os.path.join(CASES, "04_nulls_taken_for_numbers/map.yaml"))
        self.assertEqual([59], list(numpy.flatnonzero(numpy.isnan(record.signals["hook_load"]))))
        record = read_record(os.path.join(CASES, "04_nulls_taken_for_numbers/hk_null_curve.xml"))
        self.assertEqual([60], list(numpy.flatnonzero(numpy.isnan(record.signals["hook_load"]))))
        self.assertLess(numpy.nanmax(record.signals["hook_load"]), 230e3)


class Units(Folder):
    """Kind 06."""

    def test_every_spelling_has_its_size(self):
        for quantity, value, words in (
                ("force", 4448.2216152605, "klbf klb klbs KLBS Klb kip kips 1000lbf k-lbs K-LB klb_f klbs. kpounds"), ("force", 4.4482216152605, "lbf lb LBS pounds"),
                ("force", 9806.65, "tf kkgf tonne tonnes t te tonne.f Mgf 1000_kgf metric_ton"), ("force", 1e4, "kdaN KDN"), ("force", 10.0, "daN DAN"), ("force", 1e3, "kN KN kn"),
                ("force", 8896.443230521, "tonfUS TONFUS short_ton ston ton(US) UStonf"), ("force", 9964.01641818352, "tonfUK long_ton ton(UK)"),
                ("torque", 1355.8179483314004, "kft.lbf kft_lb kft-lb kft-lbs klbf.ft kft*lbf KFT.LBF ft-klbf 1000_ft_lbf kft·lbf kip-ft ft-kips K-FT-LB"),
                ("torque", 1.3558179483314004, "ft.lbf ft-lb ft_lbs lbf-ft lb-ft ftlb foot-pounds"), ("torque", 1e3, "kN.m kNm KN-M kN*m kN_m"), ("torque", 10.0, "daN.m"),
                ("pressure", 6894.757293168362, "psi PSI psig psi(g) lbf/in2 lb/in²"), ("pressure", 1e5, "bar BAR barg bar(g)"), ("pressure", 1e3, "kPa KPA"), ("pressure", 98066.5, "kgf/cm2 kg/cm2 kgf/cm² KSC"),
                ("angular speed", 2 * math.pi / 60, "rpm RPM rev/min c/min r/min 1/min /min r.p.m. rev_per_min"), ("angular speed", 2 * math.pi, "c/s rev/s Hz"),
                ("flow", 3.785411784e-3 / 60, "gpm GPM gal/min galUS/min gal_per_min USGPM US_gpm gpm(US) US-gal/min"), ("flow", 4.54609e-3 / 60, "galUK/min igpm gal(UK)/min"), ("flow", 1 / 60, "m3/min m³/min M3/MIN kL/min"), ("flow", 1e-3 / 60, "dm3/min L/min l/min lpm LPM"),
                ("flow", 0.158987294928 / 60, "bbl/min bpm stb/min"), ("length", 0.3048, "ft feet FT Feet '"), ("length", 1.0, "m M metres"),
                ("speed", 0.3048 / 3600, "ft/h ft/hr ft_per_hr fph"), ("speed", 1 / 3600, "m/h m/hr"), ("time", 60.0, "min MIN minutes"), ("time", 1.0, "s sec S")):
            for word in words.split():
                self.assertAlmostEqual(1.0, factor_of(quantity, word) / value, places=12, msg="%s %s" % (quantity, word))

    def test_ambiguous_and_unknown_units_are_refused_with_the_choices(self):
        for quantity, word, said in (("force", "tonf", "tonfUS (2000 lbf), tonfUK (2240 lbf) or 1000 kgf (tf)"), ("force", "ton", "tonfUS"), ("force", "TONS", "tonfUS"),
                                     ("force", "mn", "MN or N"), ("pressure", "mPa", "MPa or Pa"), ("force", "Mlbf", "klbf"), ("force", "psi", "not known for a force"),
                                     ("torque", "A", "not known for a torque; allowed: N.m"), ("flow", "spm", "not known for a flow"), ("length", "", "(none)")):
            with self.assertRaises(UnitError, msg=word) as caught:
                factor_of(quantity, word)
            self.assertIn(said, str(caught.exception))

    def test_no_spelling_means_two_sizes(self):
        for quantity in QUANTITIES:
            for spelling, factor in units()[quantity].items():
                self.assertEqual(factor, factor_of(quantity, spelling), spelling)

    def test_files_of_the_kind(self):
        self.assertAlmostEqual(22581.6 * 9.80665, read_record(os.path.join(CASES, "06_units/volve_kkgf.xml")).at("hook_load", 0.0), delta=30.0)
        self.assertAlmostEqual(2214.501, read_record(os.path.join(CASES, "06_units/unit_HKLD_daN.xml")).at("hook_load", 0.0))
        with self.assertRaisesRegex(RecordError, r"map_tonf.yaml:5: hook_load.unit: unit tonf is ambiguous"):
            read_record(os.path.join(CASES, "06_units/ustons.csv"), os.path.join(CASES, "06_units/map_tonf.yaml"))
        self.refused("the map says kN, the file klbf", table(header=("T", "H (klbf)", "B")), MAP.replace("column: H, unit: klbf", "column: H (klbf), unit: kN"))


class Dates(Folder):
    """Kind 07."""

    def dated(self, times, entry, header="T"):
        return self.read(table(times=times, header=(header, "H", "B")), MAP.replace("{column: T, unit: s}", entry))

    def test_as_rigs_write_them(self):
        for form in ("%m/%d/%Y %I:%M:%S %p", "%d.%m.%Y %H:%M:%S", "%d-%b-%Y %H:%M:%S", "%Y%m%d%H%M%S", "%y%m%d %H%M%S", "%b %d %Y %H:%M:%S.%f", "%H:%M:%S"):
            self.right(self.dated([datetime.datetime(2017, 7, 31, 22, 59, row[0]).strftime(form) for row in ROWS], '{column: T, format: "%s"}' % form))
        for form in ("%Y-%m-%dT%H:%M:%SZ", "%Y/%m/%d %H:%M:%S", "%Y-%m-%d %H:%M:%S.000", "%Y-%m-%dT%H:%M:%S+02:00"):
            self.right(self.dated([datetime.datetime(2017, 7, 31, 22, 59, row[0]).strftime(form) for row in ROWS], "{column: T, unit: date}"))

    def test_over_midnight_and_in_two_columns(self):
        two = [(datetime.datetime(2017, 7, 31, 23, 59, 50) + datetime.timedelta(seconds=row[0])) for row in ROWS]
        self.right(self.dated([when.strftime("%Y/%m/%d,%H:%M:%S") for when in two], "{column: [D, C], unit: date}", "D,C"))
        self.right(self.dated([when.strftime("%m/%d/%Y,%I:%M:%S %p") for when in two], '{column: [D, C], format: "%m/%d/%Y %I:%M:%S %p"}', "D,C"))
        with self.assertRaisesRegex(RecordError, "r.csv:4: the time goes back .*dates where it goes over midnight"):
            self.dated([when.strftime("%H:%M:%S") for when in two], '{column: T, format: "%H:%M:%S"}')

    def test_what_is_no_date_is_shown(self):
        for times, said in ((["07/31/2017 11:59:%02d PM" % row[0] for row in ROWS], "r.csv:2: T: 07/31/2017 11:59:00 PM is not a date with a time"),
                            (["23:59:%02d" % row[0] for row in ROWS], "r.csv:2: T: 23:59:00 is not a date with a time"), (["2020-11-%02dZ" % (1 + row[0]) for row in ROWS], "2020-11-01Z"),
                            (["2017-02-30T00:00:%02d" % row[0] for row in ROWS], "2017-02-30T00:00:00"), (STAMPS[:2] + ["2024-05-01T10:00:10"] + STAMPS[3:], "has no time zone"),
                            (["5" for _ in ROWS], "r.csv:2: T: 5 is not a date")):
            with self.assertRaises(RecordError) as caught:
                self.dated(times, "{column: T, unit: date}")
            self.assertIn(said, str(caught.exception))
        for case in ("us.csv map.yaml", "pason.csv mapP.yaml"):
            with self.assertRaisesRegex(RecordError, ":2: .*format: "):
                read_record(*(os.path.join(CASES, "07_dates", name) for name in case.split()))
        with self.assertRaisesRegex(RecordError, "25_date_only.csv:2: Time: 2020-11-02Z is not a date"):
            read_record(os.path.join(CASES, "23_units_and_tables/25_date_only.csv"), os.path.join(CASES, "23_units_and_tables/map.yaml"))
        self.assertEqual(121, len(read_record(os.path.join(CASES, "07_dates/pason.csv")).time))

    def test_a_time_that_no_record_has(self):
        with self.assertRaisesRegex(RecordError, "data row 61: its time is .* days after the row before it"):
            read_record(os.path.join(CASES, "23_units_and_tables/17c_far_time.xml"))
        self.refused("days after", table().replace("15,203", "1e15,203"), MAP)

    def test_seconds_and_back(self):
        self.assertEqual((1714557605.25, True), seconds_of("2024-05-01T10:00:05.25Z"))
        self.assertEqual((1714557605.0, True), seconds_of("2024-05-01 12:00:05+0200"))
        self.assertEqual("2024-05-01T10:00:05Z", written(1714557605.0))
        for text in ("", "2024", "2024-05-01", "10:00:05", "2024-13-01T00:00:00", "nan", "9" * 400):
            self.assertIsNone(seconds_of(text))

    def test_a_time_that_comes_twice(self):
        twice = table().replace("10,202.5,29", "5,201,29.5\n10,202.5,29")
        self.right(self.read(twice, MAP))
        self.assertNotIn("time as the row before", "\n".join(self.read(twice, MAP).remarks))
        self.right(self.read(twice.replace("5,201,29.5\n10", "5,207,29.5\n10"), MAP), ["1 rows have the same time as the row before; where values differ, the first is used (first: "])
        self.right(self.read(table().replace("5,201,29.5", "5,,29.5\n5,201,"), MAP))


class Encodings(Folder):
    """Kind 18."""

    def test_one_decoder(self):
        text = table().replace("T,H,B", "T,H,B,°").replace("\n", ",x\n").replace("°,x", "°")
        for encoding in ("utf-8", "utf-8-sig", "utf-16", "latin-1", "cp1252"):
            self.right(self.read(text, MAP, encoding=encoding))
        self.assertIn("latin-1", "\n".join(self.read(text, MAP, encoding="latin-1").remarks))
        with open(os.path.join(self.folder, "z.csv"), "wb") as out:
            out.write(b"T,H\n\0\0\0\n")
        with self.assertRaises(RecordError):
            read_record(os.path.join(self.folder, "z.csv"))


class OtherFiles(Folder):
    def test_what_is_no_text(self):
        packed = io.BytesIO()
        with zipfile.ZipFile(packed, "w") as archive:
            archive.writestr("a", "b")
        for data in (packed.getvalue(), bytes(range(256)), b"\xff\xfe\x00", b"\0" * 100):
            path = os.path.join(self.folder, "x.csv")
            with open(path, "wb") as out:
                out.write(data)
            with self.assertRaises(RecordError) as caught:
                read_record(path)
            self.assertNotIn("\n", str(caught.exception))


if __name__ == "__main__":
    unittest.main()
