#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Records of rigs as logs of WITSML and LAS: what such a file says of itself is obeyed or refused. See test_record.py."""
import html
import math
import os
import unittest

from drill_rig_sim.field.record import RecordError, read_record
from record_folder import CASES, KLBF, ROWS, STAMPS, Folder


def witsml(rows=None, names="TIME,HKLD,BLOCKCOMP,GAS", units="s,klbf,ft,%", log="", data="", index="date time", index_curve="TIME", version="1.4.1.1", well="w"):
    rows = rows or ["%s,%g,%g,0.1" % (stamp, row[1], row[2]) for stamp, row in zip(STAMPS, ROWS)]
    lists = "<mnemonicList>%s</mnemonicList><unitList>%s</unitList>" % (names, units) if version == "1.4.1.1" else ""
    return ('<?xml version="1.0"?>\n<logs xmlns="http://www.witsml.org/schemas/%s" version="%s"><log uidWell="%s" uidWellbore="b">\n'
            "<nameWell>w</nameWell><nameWellbore>b</nameWellbore><name>n</name><indexType>%s</indexType><indexCurve>%s</indexCurve>%s\n<logData>%s%s</logData>%s</log></logs>\n" %
            ("1series" if version == "1.4.1.1" else "131", version, well, index, index_curve, log, lists, "".join("\n<data>%s</data>" % row for row in rows), data))


class Witsml(Folder):
    """Kinds 02, 03, 05, 08 and the null values of 04."""

    def xml(self, **options):
        columns = options.pop("columns", None)
        return self.read(witsml(**options), columns, name="r.xml")

    def test_a_log(self):
        self.right(self.xml())
        self.right(self.read(witsml(), name="log.txt"))
        record = self.xml(rows=["2024-05-01T10:00:00.000Z,200,30,0.1", "2024-05-01T10:00:05Z,,29.5,0.1", "2024-05-01T12:00:10+02:00,201.5,29,"])
        self.assertEqual([0.0, 5.0, 10.0], list(record.time))
        self.assertTrue(math.isnan(record.signals["hook_load"][1]))
        self.assertAlmostEqual(1714557600.0, record.begin)

    def test_what_the_file_says_of_its_index(self):
        self.refused("its index is measured depth, and none of its curves is a time (DEPT", witsml(index="measured depth", index_curve="DEPT", names="DEPT,HKLD,BLOCKCOMP,GAS"), name="r.xml")
        self.refused("its index is vertical depth", witsml(index="vertical depth", index_curve="X", names="X,HKLD,BLOCKCOMP,GAS"), name="r.xml")
        self.right(self.xml(index="measured depth", index_curve="DEPT", names="DEPT,HKLD,BLOCKCOMP,TIME", units="m,klbf,ft,s",
                            rows=["%d,%g,%g,%s" % (100 + t, h, b, stamp) for stamp, (t, h, b) in zip(STAMPS, ROWS)]))
        for unit, factor in (("s", 1), ("min", 60), ("ms", 0.001), ("h", 3600), ("d", 86400)):
            self.right(self.xml(index="elapsed time", units=unit + ",klbf,ft,%", rows=["%.17g,%g,%g,0" % (t / factor, h, b) for t, h, b in ROWS]))
        self.right(self.xml(log="<direction>decreasing</direction>", rows=["%s,%g,%g,0.1" % (stamp, h, b) for stamp, (_, h, b) in reversed(list(zip(STAMPS, ROWS)))]))
        self.refused("the time goes back", witsml(rows=["%s,%g,%g,0.1" % (stamp, h, b) for stamp, (_, h, b) in reversed(list(zip(STAMPS, ROWS)))]), name="r.xml")
        with self.assertRaisesRegex(RecordError, "depth_log.xml: its index is measured depth"):
            read_record(os.path.join(CASES, "02_depth_log_taken_for_time/depth_log.xml"))

    def test_nulls_and_delimiters(self):
        cell = ["%s,%s,%g,0.1" % (stamp, "%s" if k == 1 else "%g" % row[1], row[2]) for k, (stamp, row) in enumerate(zip(STAMPS, ROWS))]
        for null, said in (("-1", "<nullValue>-1</nullValue>"), ("-1.000", "<nullValue>-1</nullValue>"), ("777", "<logCurveInfo><mnemonic>HKLD</mnemonic><unit>klbf</unit><nullValue>777</nullValue></logCurveInfo>"),
                           ("777", "<nullValue>0</nullValue><logCurveInfo><mnemonic>HKLD</mnemonic><nullValue>777.0</nullValue></logCurveInfo>"), ("NULL", "<nullValue>NULL</nullValue>")):
            record = self.xml(log=said, rows=[row % null if "%s" in row else row for row in cell])
            self.assertTrue(math.isnan(record.signals["hook_load"][1]), said)
        for sign in (";", "|", "\t", "~", "::"):
            self.right(self.xml(log="<dataDelimiter>%s</dataDelimiter>" % sign, rows=[sign.join((stamp, "%g" % h, "%g" % b, "1,5")) for stamp, (_, h, b) in zip(STAMPS, ROWS)]))
        self.refused(["r.xml:5: data row 1 has 1 values, there are 4 curves"], witsml(log="<dataDelimiter>;</dataDelimiter>"), name="r.xml")

    def test_texts_in_quotes_and_signs_about_the_delimiter(self):
        self.right(self.xml(names="TIME,HKLD,ACT,BLOCKCOMP", units="s,klbf,,ft", rows=['%s,%g,"drill, ahead",%g' % (stamp, h, b) for stamp, (_, h, b) in zip(STAMPS, ROWS)]))
        bars = ["|".join((stamp, "%g" % h, "%g" % b, "1")) for stamp, (_, h, b) in zip(STAMPS, ROWS)]
        self.right(self.xml(log="<dataDelimiter> | </dataDelimiter>", rows=bars))
        self.right(self.xml(log="<dataDelimiter>|</dataDelimiter>", names="TIME|HKLD|BLOCKCOMP|GAS", units="s|klbf|ft|%", rows=bars))
        for cell in ("-999.25", "NULL", ""):
            rows = ["%s,%g,%g,0" % (stamp if k != 1 else cell, h, b) for k, (stamp, (_, h, b)) in enumerate(zip(STAMPS, ROWS))]
            self.assertEqual([0.0, 10.0, 15.0], list(self.xml(rows=rows).time), cell)

    def test_index_and_units_that_the_file_says_twice(self):
        rows = ["%g,%s,%g,0" % (h, stamp, b) for stamp, (_, h, b) in zip(STAMPS, ROWS)]
        for curve in ("Time", "", "RIGTIME"):
            self.right(self.xml(index_curve=curve, names="HKLD,TIME,BLOCKCOMP,GAS", units="klbf,s,ft,%", rows=rows))
        self.right(self.xml(index_curve="", names="HKLD,T1,BLOCKCOMP,GAS", units="klbf,s,ft,%", rows=rows, log="<logCurveInfo><mnemonic>T1</mnemonic><typeLogData>date time</typeLogData></logCurveInfo>"))
        other = "<logCurveInfo><mnemonic>HKLD</mnemonic><unit>%s</unit></logCurveInfo>"
        self.right(self.xml(log=other % "kN"), ["HKLD: its unit is klbf in unitList, kN in logCurveInfo: unitList is used"])
        self.assertNotIn("logCurveInfo", "\n".join(self.xml(log=other % "1000 lbf").remarks))
        seconds = ["%g,%g,%g,0" % row for row in ROWS]
        self.right(self.xml(index="elapsed time", units=",klbf,ft,%", log='<startIndex uom="s">0</startIndex>', rows=seconds))
        self.refused("TIME: the time has no unit", witsml(index="elapsed time", units=",klbf,ft,%", rows=seconds), name="r.xml")
        self.right(self.xml(log="<direction>Decreasing</direction>", rows=["%s,%g,%g,0" % (stamp, h, b) for stamp, (_, h, b) in reversed(list(zip(STAMPS, ROWS)))]))

    def test_a_curve_of_time_that_the_map_names(self):
        options = {"index": "measured depth", "index_curve": "DEPT", "names": "DEPT,HKLD,BLOCKCOMP,CLK", "units": "m,klbf,ft,"}
        rows = ["%d,%g,%g,%s" % (100 + t, h, b, stamp) for stamp, (t, h, b) in zip(STAMPS, ROWS)]
        columns = "time: {column: CLK, unit: date}\nhook_load: {column: HKLD}\nblock_height: {column: BLOCKCOMP}\n"
        self.right(self.xml(rows=rows, columns=columns, **options))
        self.refused("DEPT: the map says s, the file m", witsml(rows=rows, **options), columns.replace("CLK, unit: date", "DEPT, unit: s"), name="r.xml")
        self.right(self.read(las(curves="DEPT.M : d\nHKLD.KLBF : h\nBLOCKCOMP.FT : b\nCLK.S : t\n", rows=["%g %g %g %g" % (100 + t, h, b, t) for t, h, b in ROWS]),
                             columns.replace(", unit: date", ""), name="r.las"))
        minutes = las(curves="TIME.M : t\nHKLD.KLBF : h\nBPOS.FT : b\n", rows=["%.17g %g %g" % (t / 60, h, b) for t, h, b in ROWS])
        self.right(self.read(minutes, "time: {column: TIME, unit: min}\nhook_load: {column: HKLD}\nblock_height: {column: BPOS}\n", name="r.las"))

    def test_later_data_without_names_have_those_of_the_first(self):
        infos = "".join("<logCurveInfo><mnemonic>%s</mnemonic><unit>%s</unit></logCurveInfo>" % curve for curve in (("BLOCKCOMP", "ft"), ("HKLD", "klbf"), ("TIME", "s"), ("GAS", "%")))
        rows = ["%s,%g,%g,0.1" % (stamp, h, b) for stamp, (_, h, b) in zip(STAMPS, ROWS)]
        self.right(self.xml(log=infos, rows=rows[:2], data="<logData>%s</logData>" % "".join("<data>%s</data>" % row for row in rows[2:])))

    def test_encodings(self):
        """Also where the declaration is wrong, as of a text that a program wrote in another encoding than its own."""
        text = witsml(log="<description>\u00b0</description>")
        for declared, encoding in (("", "utf-8"), (' encoding="UTF-16"', "utf-8"), (' encoding="UTF-16"', "utf-16"), (' encoding="ISO-8859-1"', "latin-1"), ("", "utf-8-sig"), ("", "utf-16")):
            self.right(self.read(text.replace('"1.0"', '"1.0"' + declared, 1), name="r.xml", encoding=encoding))
        self.right(self.read(text, name="r.xml", encoding="latin-1"), ["is not UTF-8; read as latin-1"])
        self.right(self.read("\n " + text, name="r.xml"))

    def test_several_parts_are_joined_by_the_index(self):
        rows = ["%s,%g,%g,0.1" % (stamp, h, b) for stamp, (_, h, b) in zip(STAMPS, ROWS)]
        more = "<logData><mnemonicList>TIME,HKLD,BLOCKCOMP,GAS</mnemonicList><unitList>s,klbf,ft,%%</unitList>%s</logData>"
        data = lambda these: "".join("<data>%s</data>" % row for row in these)
        self.right(self.xml(rows=rows[:2], data=more % data(rows[2:])))
        self.right(self.xml(rows=rows[2:], data=more % data(rows[:2])))
        self.right(self.xml(rows=rows[:3], data=more % data(rows[2:])))  # the row between stands in both
        kilonewton = more.replace("klbf", "kN") % data("%s,%.9g,%g,0.1" % (stamp, h * KLBF / 1e3, b) for stamp, (_, h, b) in list(zip(STAMPS, ROWS))[2:])
        self.right(self.xml(rows=rows[:2], data=kilonewton))
        other = "<logData><mnemonicList>TIME,SPP</mnemonicList><unitList>s,bar</unitList>%s</logData>" % data("%s,100" % stamp for stamp in STAMPS)
        record = self.xml(data=other)
        self.right(record)
        self.assertAlmostEqual(1e7, record.at("stand_pipe_pressure", 7.0))
        self.assertEqual(121, len(read_record(os.path.join(CASES, "03_later_logdata_dropped/two_logdata.xml")).time))

    def test_several_logs_and_files(self):
        one = witsml(names="TIME,HKLD", units="s,klbf", rows=["%s,%g" % (stamp, row[1]) for stamp, row in zip(STAMPS, ROWS)])
        two = witsml(names="TIME,BLOCKCOMP", units="s,ft", rows=["%s,%g" % (stamp, row[2]) for stamp, row in zip(STAMPS, ROWS)])
        log = lambda text: text[text.index("<log "):text.index("</logs>")]
        self.right(self.read(one.replace("</logs>", log(two) + "</logs>"), name="r.xml"))
        self.right(read_record([self.file("a.xml", one), self.file("b.xml", two)]))
        csv = self.file("c.csv", "DateTime,BPOS (ft)\n" + "".join("%s,%g\n" % (stamp, row[2]) for stamp, row in zip(STAMPS, ROWS)))
        self.right(read_record([self.file("a.xml", one), csv]))
        self.refused("holds logs of 2 wellbores (v/b, w/b)", one.replace("</logs>", log(two.replace('uidWell="w"', 'uidWell="v"')) + "</logs>"), name="r.xml")
        depth = log(witsml(index="measured depth", index_curve="DEPT", names="DEPT,ROP", units="m,m/h", rows=["1,2", "2,3"]))
        self.right(self.read(witsml().replace("</logs>", depth + "</logs>"), name="r.xml"), ["log 2 is skipped: its index is measured depth"])
        with self.assertRaisesRegex(RecordError, "some of its tables have dates, others seconds"):
            read_record([self.file("a.xml", one), self.file("d.csv", "Time (s),BPOS (ft)\n0,1\n5,2\n")])

    def test_which_wellbore_a_log_is_of(self):
        """A log without uids is of the well of its names; several files of other wells are joined, which is reported."""
        rows = ["%s,%g,%g,0.1" % (stamp, h, b) for stamp, (_, h, b) in zip(STAMPS, ROWS)]
        log = lambda text: text[text.index("<log", text.index("<logs") + 5):text.index("</logs>")]
        later = witsml(rows=rows[2:])
        for other in (later.replace(' uidWell="w" uidWellbore="b"', ""), later.replace(' uidWell="w" uidWellbore="b"', "").replace("<nameWell>w<", "<nameWell> W<")):
            self.right(self.read(witsml(rows=rows[:2]).replace("</logs>", log(other) + "</logs>"), name="r.xml"))
        files = self.file("a.xml", witsml(rows=rows[:2])), self.file("b.xml", later.replace("<nameWell>w<", "<nameWell>v<"))
        self.right(read_record(files), ["a.xml is of well w/b, ", "b.xml of v/b; they are joined as one well"])
        self.right(read_record([self.file("a.xml", witsml(rows=rows[:2])), self.file("d.las", las("TIME. : t\nHKLD.klbf : h\nBPOS.FT : b\n", ["%s %g %g" % (stamp, h, b) for stamp, (_, h, b) in list(
            zip(STAMPS, ROWS))[2:]]).replace("~CURVE", " WELL. v-2 : name\n~CURVE"))]), ["d.las of v-2; they are joined as one well"])
        mixed = read_record([self.file("a.xml", witsml(rows=rows[:2])), self.file("c.csv", "DateTime,HKLD (klbf),BPOS (ft)\n" + "\n".join(row[:-4].replace("Z", "") for row in rows[2:]) + "\n")])
        self.right(mixed, ["a.xml have a time zone, those of ", "c.csv have none and are taken as UTC"])

    def test_answers_of_servers_and_rows_in_one_element(self):
        rows = ["%s,%g,%g,0.1" % (stamp, h, b) for stamp, (_, h, b) in zip(STAMPS, ROWS)]
        answer = '<?xml version="1.0"?><e:Envelope xmlns:e="http://schemas.xmlsoap.org/soap/envelope/"><e:Body><XMLout>%s</XMLout></e:Body></e:Envelope>'
        self.right(self.read(answer % html.escape(witsml()), name="r.xml"))
        self.refused("its root is Envelope, and it holds no log", answer % html.escape(witsml()[:300]), name="r.xml")
        self.right(self.xml(rows=["\n".join(rows)]))
        self.right(self.xml(rows=["\n  %s\n" % row for row in rows]))
        self.refused("data row 1 has 16 values", witsml(rows=[" ; ".join(rows).replace(" ; ", ",")]), name="r.xml")

    def test_index_types_and_units_as_programs_write_them(self):
        for kind in ("datetime", "Date Time", "time"):
            self.right(self.xml(index=kind))
        infos = "".join("<logCurveInfo><mnemonic>%s</mnemonic><unit>%s</unit></logCurveInfo>" % curve for curve in (("HKLD", "klbf"), ("BLOCKCOMP", "ft"), ("TIME", "s")))
        self.right(self.read(witsml(log=infos).replace("<unitList>s,klbf,ft,%</unitList>", "<unitList/>"), name="r.xml"))

    def test_version_1311(self):
        curves = "".join("<logCurveInfo><mnemonic>%s</mnemonic><unit>%s</unit><columnIndex>%d</columnIndex></logCurveInfo>" % curve
                         for curve in (("BLOCKCOMP", "ft", 3), ("TIME", "s", 1), ("GAS", "%", 4), ("HKLD", "klbf", 2)))
        self.right(self.xml(version="1.3.1.1", log=curves))
        plain = "".join("<logCurveInfo><mnemonic>%s</mnemonic><unit>%s</unit></logCurveInfo>" % curve for curve in (("TIME", "s"), ("HKLD", "klbf"), ("BLOCKCOMP", "ft"), ("GAS", "%")))
        self.right(self.xml(version="1.3.1.1", log=plain))
        with_a_gap = "".join("<logCurveInfo><mnemonic>%s</mnemonic><unit>%s</unit><columnIndex>%d</columnIndex></logCurveInfo>" % curve
                             for curve in (("BLOCKCOMP", "ft", 4), ("TIME", "s", 1), ("HKLD", "klbf", 2)))
        self.right(self.xml(version="1.3.1.1", log=with_a_gap, rows=["%s,%g,7,%g" % (stamp, h, b) for stamp, (_, h, b) in zip(STAMPS, ROWS)]))
        self.refused("HKLD and BLOCKCOMP have the same columnIndex 2", witsml(version="1.3.1.1", log=curves.replace(">3<", ">2<").replace('>4<', '>3<').replace("BLOCKCOMP", "X").replace(
            "HKLD", "BLOCKCOMP").replace(">X<", ">HKLD<")), name="r.xml")
        self.refused("a log names no curves", witsml(version="1.3.1.1"), name="r.xml")
        for name in ("v1311", "decreasing"):
            record = read_record(os.path.join(CASES, "08_witsml_shapes/%s.xml" % name))
            self.assertEqual((121, 120.0), (len(record.time), record.time[-1]))
            self.assertAlmostEqual(221450.1, record.at("hook_load", 0.0))

    def test_a_map_of_its_mnemonics(self):
        columns = "time: {column: TIME, unit: date}\nhook_load: {column: ZZ1}\nblock_height: {column: ZZ2, unit: ft}\n"
        self.right(self.xml(names="TIME,ZZ1,ZZ2,GAS", columns=columns))
        self.refused("there is no column ZZ2; columns: TIME, HKLD, BLOCKCOMP, GAS", witsml(), columns, name="r.xml")
        record = read_record(os.path.join(CASES, "05_columns_ignored_for_xml/wits_names.xml"), os.path.join(CASES, "05_columns_ignored_for_xml/map_wits.yaml"))
        self.assertAlmostEqual(221450.1, record.at("hook_load", 0.0))
        self.assertAlmostEqual(99.7, record.at("bit_depth", 0.0))

    def test_a_curve_of_an_unknown_unit_is_left_out_and_reported(self):
        record = self.xml(units="s,stone,ft,%")
        self.assertNotIn("hook_load", record)
        self.assertIn("hook_load is left out: HKLD: unit stone is not known for a force", "\n".join(record.remarks))

    def test_what_is_no_log(self):
        for text, said in (("<logs>", "is not valid XML"), ("<logs/>", "holds no log"), (witsml(names="TIME,HKLD"), "mnemonicList has 2 names, unitList 4 units"),
                           (witsml().replace("<logs", '<!DOCTYPE x [<!ENTITY e SYSTEM "file:///etc/passwd">]><logs', 1), "document type definition")):
            self.refused(said, text, name="r.xml")
        bomb = '<!DOCTYPE x [<!ENTITY a "%s">%s]>' % ("A" * 100, "".join('<!ENTITY %s "%s">' % (chr(98 + k), ("&%s;" % chr(97 + k)) * 100) for k in range(8)))
        self.refused("r.xml", witsml().replace("<logs", bomb + "<logs", 1).replace("TIME,HKLD", "TIME,&i;", 1), name="r.xml")


def las(curves="TIME.S : time\nHKLD.KLBF : hook load\nBPOS.FT : block\n", rows=None, wrap="NO", null="-999.25", version="2.0"):
    rows = rows or ["%g  %g  %g" % row for row in ROWS]
    return ("~VERSION INFORMATION\n VERS.  %s : CWLS\n WRAP.  %s : one line\n~WELL\n STRT.S 0 : start\n NULL.  %s : null\n# a comment\n~CURVE\n%s~PARAMETER\n~ASCII LOG DATA\n%s\n" %
            (version, wrap, null, curves, "\n".join(rows)))


UUID = "uuid='5d8c5d0e-0000-0000-0000-000000000000' schemaVersion='2.0'"


def channel(name, unit, inside="", kind="double"):
    return "<Channel %s><Mnemonic>%s</Mnemonic><DataType>%s</DataType><Uom>%s</Uom>%s</Channel>" % (UUID, name, kind, unit, inside)


def index(kind="date time", unit="s", direction="increasing", name="TIME"):
    return "<Index><IndexType>%s</IndexType><Uom>%s</Uom><Direction>%s</Direction><Mnemonic>%s</Mnemonic></Index>" % (kind, unit, direction, name)


def channel_set(rows, head=None, channels=None):
    """Of rows of JSON."""
    channels = channels or channel("HKLD", "klbf") + channel("BPOS", "ft")
    return "<ChannelSet %s>%s%s\n<Data><Data>[%s]</Data></Data></ChannelSet>" % (UUID, head or index(), channels, ",\n".join(rows))


def log_of(*sets, well="b"):
    return ('<?xml version="1.0"?>\n<Log xmlns="http://www.energistics.org/energyml/data/witsmlv2" xmlns:eml="http://www.energistics.org/energyml/data/commonv2" %s>'
            "<eml:Citation><eml:Title>n</eml:Title></eml:Citation>%s<Wellbore><eml:ContentType>x</eml:ContentType><eml:Title>%s</eml:Title></Wellbore></Log>\n" % (UUID, "".join(sets), well))


class Channels(Folder):
    """WITSML 2.0: channel sets with data as JSON."""
    DATED = ['[["%s"],[%g,%g]]' % (stamp, h, b) for stamp, (_, h, b) in zip(STAMPS, ROWS)]

    def of(self, *sets):
        return self.read(log_of(*sets), name="r.xml")

    def test_what_is_read(self):
        self.right(self.of(channel_set(self.DATED)))
        self.assertAlmostEqual(1714557600.0, self.of(channel_set(self.DATED)).begin)
        self.right(self.of(channel_set(['["%s",%g,%g]' % (stamp, h, b) for stamp, (_, h, b) in zip(STAMPS, ROWS)])))
        self.right(self.of(channel_set(['[["%s"],[[%g,[1]],%g]]' % (stamp, h, b) for stamp, (_, h, b) in zip(STAMPS, ROWS)])))
        self.right(self.of(channel_set(["[[%.17g],[%g,%g]]" % (t / 60, h, b) for t, h, b in ROWS], index("elapsed time", "min"))))
        self.right(self.of(channel_set(self.DATED[::-1], index(direction="decreasing"))))
        self.right(self.of(channel_set(self.DATED[:2]), channel_set(self.DATED[2:])))
        self.right(self.of(channel_set(['[[%d,"%s"],[%g,%g]]' % (100 + k, stamp, h, b) for k, (stamp, (_, h, b)) in enumerate(zip(STAMPS, ROWS))],
                                       index("measured depth", "m", name="DEPTH") + index())))
        self.right(self.of(channel_set(['[[%d],["%s",%g,%g]]' % (100 + k, stamp, h, b) for k, (stamp, (_, h, b)) in enumerate(zip(STAMPS, ROWS))],
                                       index("measured depth", "m", name="DEPTH"), channel("DateTime", "", kind="date time") + channel("HKLD", "klbf") + channel("BPOS", "ft"))))

    def test_channels_with_data_of_their_own(self):
        def alone(name, unit, place):
            data = ",".join('["%s",%g]' % (stamp, row[place]) for stamp, row in zip(STAMPS, ROWS))
            return channel(name, unit, index() + "<Data><Data>[%s]</Data></Data>" % data)
        self.right(self.of(alone("HKLD", "klbf", 1) + alone("BPOS", "ft", 2)))
        self.right(self.of("<ChannelSet %s>%s%s</ChannelSet>" % (UUID, index(), alone("HKLD", "klbf", 1) + alone("BPOS", "ft", 2))))

    def test_nulls_and_units_of_energistics(self):
        record = self.of(channel_set([self.DATED[0], self.DATED[1].replace("201", "null"), self.DATED[2].replace("202.5", "-999.25"), self.DATED[3].replace("203", "NaN")]))
        self.assertEqual([False, True, True, True], [math.isnan(load) for load in record.signals["hook_load"]])
        for name, unit, signal, si in (("MFIA", "gal[US]/min", "flow", 3.785411784e-3 / 60), ("MFIA", "gal[UK]/min", "flow", 4.54609e-3 / 60), ("HKLD", "tonf[US]", "hook_load", 8896.443230521),
                                       ("HKLD", "10 kN", "hook_load", 1e4), ("DBTM", "ft[US]", "bit_depth", 1200 / 3937), ("RPMA", "rev/min", "top_drive_speed", math.pi / 30),
                                       ("TQA", "1000 lbf.ft", "torque", 1355.8179483314), ("SPPA", "kpsi", "stand_pipe_pressure", 6894757.293168362)):
            record = self.of(channel_set(['[["%s"],[20,30]]' % stamp for stamp in STAMPS], channels=channel(name, unit) + channel("BPOS", "ft")))
            self.assertAlmostEqual(1.0, record.signals[signal][0] / (20.0 * si), places=9, msg=unit)

    def test_what_is_refused(self):
        for said, sets in ((["its index is measured depth", "none of its channels is a time (DEPTH, HKLD, BPOS)"], channel_set(["[[1],[2,3]]"], index("measured depth", "m", name="DEPTH"))),
                           (["data row 2 must be an array", "1 indices and one of 2 values"], channel_set([self.DATED[0], '[["%s"],[1]]' % STAMPS[1]])),
                           ("Data is not valid JSON", channel_set(["1,2"]).replace("[1,2]", "1,2")), ("must be an array of", channel_set(['{"a": 1}'])),
                           ("its data are in another file, a.h5", channel_set([]).replace("<Data>[]</Data>", "<FileUri>a.h5</FileUri>")),
                           ("it holds no log of WITSML 1.3.1.1, 1.4.1.1 or 2.0 with data", "<ChannelSet>%s</ChannelSet>" % index()),
                           ("unit tonf is ambiguous", channel_set(self.DATED, channels=channel("HKLD", "tonf") + channel("BPOS", "tonf")))):
            if "tonf" in said:
                self.assertIn(said, "\n".join(self.of(sets).remarks))
            else:
                self.refused(said, log_of(sets), name="r.xml")
        two = log_of(channel_set(self.DATED), well="b") + log_of(channel_set(self.DATED), well="c").partition("\n")[2]
        self.refused("holds logs of 2 wellbores (b, c)", "<all>%s</all>" % two.partition("\n")[2], name="r.xml")


class Las(Folder):
    def log(self, columns=None, **options):
        return self.read(las(**options), columns, name="r.las")

    def test_a_time_goes_before_a_date_without_one(self):
        """DATE in days is the same in all rows."""
        rows = "".join("210524 %d %g %g\n" % row for row in ROWS)
        self.right(self.read("~V\nVERS. 2.0:\nWRAP. NO:\n~W\nNULL. -999.25:\n~C\nDATE.D:\nTIME.S:\nHKLD.klbf:\nBPOS.ft:\n~A\n" + rows, name="r.las"))

    def test_a_log_by_time(self):
        self.right(self.log())
        self.right(self.read(las(), name="r.txt"))
        self.right(self.log(version="1.2"))
        self.right(self.log(wrap="YES", rows=[line for t, h, b in ROWS for line in ("%g" % t, "%g" % h, "%g" % b)]))
        self.right(self.log(curves="ETIM .MIN 00 : elapsed\nHKLD .KLB : hook load\nBPOS .FT : block\n", rows=["%.17g %g %g" % (t / 60, h, b) for t, h, b in ROWS]))
        self.right(self.log(curves="DATETIME. : date\nHKLD.klbf : x\nBPOS.ft : x\n", rows=["%s %g %g" % (stamp, h, b) for stamp, (_, h, b) in zip(STAMPS, ROWS)]))

    def test_as_programs_write_it(self):
        dated = "TIME. : t\nHKLD.klbf : x\nBPOS.ft : x\n"
        two = "DATE. : d\nTIME.HH:MM:SS : t\nHKLD.klbf : x\nBPOS.ft : x\n"
        rows = [(stamp[:10], stamp[11:19], h, b) for stamp, (_, h, b) in zip(STAMPS, ROWS)]
        self.all_right((("commas", las(rows=["%g,%g,%g" % row for row in ROWS])), ("DLM", las(version="2.0 : v\n DLM. COMMA", rows=["%g, %g, %g" % row for row in ROWS])),
                        ("tabs", las(version="2.0 : v\n DLM. TAB", rows=["%g\t%g\t%g" % row for row in ROWS])), ("no blanks", las(curves="TIME.S:\nHKLD.KLBF:load\nBPOS.FT:\n")), ("an end of DOS", las() + "\x1a"), ("more colons", las(version="2.0 : LAS: 2", null="-999 : no: value")),
                        ("no colons", las(curves="TIME.S\nHKLD.KLBF\nBPOS.FT\n")),
                        ("colons", las(curves="TIME.S : Time: of day\nHKLD.KLBF 45 66 : Hook: load (avg: 5 s)\nBPOS.FT : 10:20\n")),
                        ("a unit with a blank", las(curves="TIME.S : t\nHKLD.1000 lbf : h\nBPOS.FT : b\n")), ("brackets", las(curves="TIME.[s] : t\nHKLD.(klbf) : h\nBPOS.[ft] : b\n")),
                        ("the unit of STRT", las(curves="TIME. : t\nHKLD.KLBF : h\nBPOS.FT : b\n")), ("other sections", las().replace("~PARAMETER", "~OTHER\n a: 3.5 b\n~PARAMETER\n~Other\nx")),
                        ("blanks before", las().replace("~", " ~")), ("small letters", las().replace("~C", "~c").replace("~A", "~a")), ("names after ~A", las().replace("~ASCII LOG DATA", "~A TIME HKLD BPOS")),
                        ("a blank in the date", las(curves=dated, rows=["%s %s %g %g" % row for row in rows])), ("quotes", las(curves=dated, rows=['"%s %s" %g %g' % row for row in rows])),
                        ("date and time", las(curves=two, rows=["%s %s %g %g" % row for row in rows]))), name="r.las")
        self.refused('format: "%d/%m/%Y %H:%M:%S" or "%m/%d/%Y %H:%M:%S"', las(curves=two, rows=["01/05/2024 %s %g %g" % row[1:] for row in rows]), name="r.las")
        self.refused("TIME: unit M is not known for a time", las(curves="TIME.M : t\nHKLD.KLBF : h\n", rows=["0 1", "5 1"]), name="r.las")
        self.refused("there is a second section ~A", las() + "~A\n", name="r.las")

    def test_by_depth(self):
        curves = "DEPT.M : depth\nHKLD.KLBF : hook load\nBPOS.FT : block\n"
        self.refused("its index is DEPT [M], and none of its curves is a time (DEPT, HKLD, BPOS)", las(curves=curves), name="r.las")
        self.right(self.log(curves=curves.replace("BPOS.FT : block\n", "BPOS.FT : block\nTIME.S : time\n"), rows=["%g %g %g %g" % (100 + t, h, b, t) for t, h, b in ROWS]))

    def test_nulls_maps_and_what_is_refused(self):
        self.assertTrue(math.isnan(self.log(null="-1.00", rows=["0 200 30", "5 -1 29", "10 1 1"]).signals["hook_load"][1]))
        self.right(self.log("time: {column: TIME, unit: s}\nhook_load: {column: HL}\nblock_height: {column: BPOS}\n", curves="TIME.S : t\nHL.KLBF : h\nBPOS.FT : b\n"))
        for text, said in ((las(version="4.0"), "is LAS 4.0; allowed: 1.2, 2.0 and 3.0"), (las().replace("~ASCII LOG DATA", "~OTHER"), "has no section ~A"),
                           (las(rows=["0 200 30", "5 201"]), "r.las:15: has 2 values, there are 3 curves"), (las(wrap="YES", rows=["0 200", "30", "5"]), "the last row has 1 values"),
                           ("x\n" + las(), "r.las:1: is before the first section")):
            self.refused(said, text, name="r.las")

    def test_the_last_row_first(self):
        """As the file says by STRT and STOP, or by STEP."""
        back, dated = ["%g %g %g" % row for row in ROWS[::-1]], ["%s %g %g" % (stamp, h, b) for stamp, (_, h, b) in list(zip(STAMPS, ROWS))[::-1]]
        ends = " STRT.S 15 : start\n STOP.S 0 : stop\n"
        self.right(self.read(las(rows=back).replace(" STRT.S 0 : start\n", ends), name="r.las"))
        self.right(self.read(las(rows=back).replace("STRT.S 0", "STRT.S 15 :\n STEP.S -5"), name="r.las"))
        self.right(self.read(las(curves="TIME. : t\nHKLD.klbf : x\nBPOS.ft : x\n", rows=dated).replace("STRT.S 0 : start", "STRT. %s : x\n STOP. %s : y" % (STAMPS[3], STAMPS[0])), name="r.las"))
        self.right(self.read(las().replace(" STRT.S 0 : start\n", ends), name="r.las"), ["STRT is 15, TIME of the first row 0: the rows are used"])
        self.refused("the time goes back to 10 s", las(rows=back), name="r.las")


def las3(curves="TIME.S : time {F}\nHKLD.klbf : hook load {F}\nBPOS.FT : block {F} | Mud[1]\n", rows=None, delimiter="COMMA", more="", ends="0 : {F}\nSTOP.S 15"):
    rows = rows or ["%g,%g,%g" % row for row in ROWS]
    return ("~Version\nVERS. 3.0 : CWLS LOG ASCII STANDARD\nWRAP. NO : x\nDLM. %s : x\n~Well\nSTRT.S %s :\nNULL. -999.25 :\n~Parameter\nMUD. GEL : mud {S}\n"
            "~Curve\n%s~ASCII | Curve\n%s\n%s" % (delimiter, ends, curves, "\n".join(rows), more))


class Las3(Folder):
    def test_what_is_read(self):
        log = ("~Curve", "~Log_Definition"), ("~ASCII | Curve", "~Log_Data | Log_Definition")
        runs = ("~Curve", "~Log_Definition[1]"), ("~ASCII | Curve", "~Log_Data[1] | Log_Definition[1]")
        second = "~Log_Definition[2]\nTIME.S :\nHKLD.klbf :\nBPOS.FT :\n~Log_Data[2] | Log_Definition[2]\n10,202.5,29\n15,203,28\n"
        whole = "DATE_TIME. : t {YYYY-MM-DD hh:mm:ss}\nHKLD.klbf : {F}\nBPOS.FT : {F}\n"
        apart = "DATE. : d {MM/DD/YYYY}\nTIME. : t {hh:mm:ss}\nHKLD.klbf : {F}\nBPOS.FT : {F}\n"
        self.all_right((("commas", las3()), ("blanks", las3(delimiter="SPACE", rows=["%g  %g  %g" % row for row in ROWS])),
                        ("tabs", las3(delimiter="TAB", rows=["%g\t%g\t%g" % row for row in ROWS])),
                        ("the last row first", las3(rows=["%g,%g,%g" % row for row in ROWS[::-1]], ends="15 :\nSTOP.S 0")),
                        ("log data", replaced(las3(), log)), ("two runs", replaced(las3(rows=["0,200,30", "5,201,29.5"], more=second), runs)),
                        ("no name of the definition", las3().replace("~ASCII | Curve", "~ASCII")),
                        ("dates", las3(whole, ["2024-05-01 10:00:%02d,%g,%g" % row for row in ROWS])), ("date and time", las3(apart, ["05/01/2024,10:00:%02d,%g,%g" % row for row in ROWS])),
                        ("texts with the delimiter", las3(curves="TIME.S :\nACT. : {S}\nHKLD.klbf :\nBPOS.FT :\n", rows=['%g,"in, slips",%g,%g' % row for row in ROWS])),
                        ("other data", las3(more="~Core_Definition\nTOP.M : {F}\n~Core_Data | Core_Definition\n1\n2\n"))), name="r.las")
        self.assertTrue(math.isnan(self.read(las3(rows=["0,200,30", "5,,29.5", "10,202.5,29"]), name="r.las").signals["hook_load"][1]))

    def test_what_is_refused(self):
        self.refused("has no section of a log with its curves", las3().replace("~ASCII | Curve", "~Core_Data | Curve"), name="r.las")
        self.refused("its index is DEPT [M], and none of its curves is a time", las3("DEPT.M :\nHKLD.klbf :\nBPOS.FT :\n"), name="r.las")
        self.refused("has 2 values, there are 3 curves", las3(rows=["0,200,30", "5,201"]), name="r.las")


def replaced(text, pairs):
    for old, new in pairs:
        text = text.replace(old, new)
    return text


if __name__ == "__main__":
    unittest.main()
