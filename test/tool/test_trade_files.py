#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Small files as data systems of the trade write them, each with known values: they are read right, or refused in one line. Kinds are in test_record_variants.py and test_survey.py."""
import datetime
import math
import os
import sys
import unittest

import numpy

sys.dont_write_bytecode = True
sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from drill_rig_sim.survey import SurveyError, direction, read_survey  # noqa: E402
from record_folder import FEET, KLBF, Folder  # noqa: E402

SECONDS, LOADS, BLOCKS, DEPTHS = (0, 5, 10, 15, 20, 25), (200.0, 201.5, 202.0, 203.25, 204.0, 205.0), (60.0, 61.0, 62.0, 63.5, 64.0, 65.0), (1000.0, 999.7, 999.4, 999.0, 998.8, 998.5)
BEGIN = datetime.datetime(2024, 5, 21, 9, 59, 50)  # [s], [klbf], [ft], [m]
SINCE_1970 = 1716285590.0
LAS = "~V\nVERS. 2.0:\nWRAP. NO:\n~W\nSTRT.S 0:\nSTOP.S 25:\nSTEP.S 0:\nNULL. -999.25:\n~C\n%s~A\n%s"
PLAIN = "Time (s),Hook Load (klbf),Block Height (ft)\n"


def rows(form, times="", load=1.0, block=1.0, depth=1.0):
    """A line of each row by a format with %(t)s, %(h)s, %(b)s and %(d)s; `times`: of the dates, "": seconds."""
    found = []
    for t, h, b, d in zip(SECONDS, LOADS, BLOCKS, DEPTHS):
        when = (BEGIN + datetime.timedelta(seconds=t)).strftime(times) if times else str(t)
        found.append(form % {"t": when, "s": t, "h": "%.10g" % (load * h), "b": "%.10g" % (block * b), "d": "%.10g" % (depth * d)} + "\n")
    return "".join(found)


METRIC = {"load": KLBF / 1e4, "block": FEET}
RECORDS = {
    "Pason, metric": "YYYY/MM/DD,HH:MM:SS,Hole Depth (metres),Bit Depth (metres),Hook Load (kDaN),Block Height (metres),Rotary RPM (RPM),Standpipe Pressure (kPa),"
                     "Convertible Torque (kN.m),Total Pump Output (m^3/min)\n" + rows("%(t)s,1001,%(d)s,%(h)s,%(b)s,60,10000,5,2", "%Y/%m/%d,%H:%M:%S", **METRIC),
    "Pason, oilfield": "YYYY/MM/DD,HH:MM:SS,Bit Depth (feet),Hook Load (klbs),Block Height (feet),Rotary RPM (RPM),Standpipe Pressure (psi),Convertible Torque (kft_lb),"
                       "Total Pump Output (gal_per_min)\n" + rows("%(t)s,%(d)s,%(h)s,%(b)s,60,1450.3773773,3.6878107,528.3441046", "%Y/%m/%d,%H:%M:%S", depth=1 / FEET),
    "units in brackets below the names": "Time,Bit Depth,Hook Load,Block Position,Top Drive RPM,Top Drive Torque,Pump Pressure,Flow In\n,(ft),(klbf),(ft),(rpm),(kft-lbf),(psi),(gpm)\n" +
                                         rows("%(t)s,%(d)s,%(h)s,%(b)s,60,3.6878107,1450.3773773,528.3441046", "%Y-%m-%d %H:%M:%S", depth=1 / FEET),
    "Pason, names over two lines": "Date,Time,Bit,Hook,Block,Rotary,Standpipe,Convertible,Flow\n,,Depth,Load,Height,RPM,Pressure,Torque,In\nYYYY/MM/DD,HH:MM:SS,ft,klb,ft,rpm,psi,kft-lb,gpm\n" +
                                   rows("%(t)s,%(d)s,%(h)s,%(b)s,60,1450.3773773,3.6878107,528.3441046", "%Y/%m/%d,%H:%M:%S", depth=1 / FEET),
    "seconds of 1970": PLAIN + rows("%(t)s,%(h)s,%(b)s", "%s"),
    "minutes": PLAIN.replace("Time (s)", "Elapsed Time (min)") + "".join("%.17g,%s\n" % (t / 60, line.split(",", 1)[1]) for t, line in zip(SECONDS, rows("%(t)s,%(h)s,%(b)s").splitlines())),
    "German": "Datum;Zeit;Hook Load (t);Block Height (m)\n" + rows("%(t)s;%(h)s;%(b)s", "%d.%m.%Y;%H:%M:%S", load=KLBF / 9806.65, block=FEET).replace(".", ",").replace("21,05,2024", "21.05.2024"),
    "German names": "Datum;Uhrzeit;Hakenlast [t];Hakenhöhe [m];Meißelteufe [m];Drehzahl [U/min];Drehmoment [kNm];Pumpendruck [bar];Spülrate [l/min]\n" +
                    rows("%(t)s;%(h)s;%(b)s;%(d)s;60;5;100;2000", "%d.%m.%Y;%H:%M:%S", load=KLBF / 9806.65, block=FEET).replace(".", ",").replace("21,05,2024", "21.05.2024"),
    "French names": "Horodatage;Poids au crochet (kkg);Hauteur crochet (m);Profondeur outil (m);Vitesse de rotation (tr/min);Couple (daN.m);Pression refoulement (barg);Débit entrée (l/min)\n" +
                    rows("%(t)s;%(h)s;%(b)s;%(d)s;60;500;100;2000", "%Y-%m-%d %H:%M:%S", load=KLBF / 9806.65, block=FEET).replace(".", ","),
    "Spanish names": "Fecha y hora;Carga en el gancho (klb);Posición del bloque (pies);Profundidad de la barrena (m);RPM superficie;Torque superficie (kN.m);Presión de bombas (kPag);"
                     "Caudal entrada (L/min)\n" + rows("%(t)s;%(h)s;%(b)s;%(d)s;60;5;10000;2000", "%Y-%m-%d %H:%M:%S").replace(".", ","),
    "Portuguese names": "Data;Hora;Carga no gancho (klbf);Altura do bloco (ft);Profundidade da broca (m);RPM;Pressão de bombeio (psig);Vazão de entrada (L/min)\n" +
                        rows("%(t)s;%(h)s;%(b)s;%(d)s;60;1450,3773773;2000", "%Y-%m-%d;%H:%M:%S").replace(".", ","),
    "Russian names": "Дата;Время;Вес на крюке, тс;Положение талблока, м;Положение долота, м;Обороты ротора, об/мин;Момент на роторе, кН·м;Давление на стояке, МПа;Расход на входе, л/с\n" +
                     rows("%(t)s;%(h)s;%(b)s;%(d)s;60;5;10;33.333333333", "%d.%m.%Y;%H:%M:%S", load=KLBF / 9806.65, block=FEET).replace(".", ",").replace("21,05,2024", "21.05.2024"),
    "ISO 8601 with a decimal comma": "Time;Hook Load (klbf);Block Height (ft)\n" + rows("%(t)s,000Z;%(h)s;%(b)s", "%Y-%m-%dT%H:%M:%S"),
    "ISO 8601 with an offset": "Time,Hook Load (klbf),Block Height (ft)\n" + rows("%(t)s.000000 +00:00,%(h)s,%(b)s", "%Y-%m-%d %H:%M:%S"),
    "a hook load of three columns": "Time (s),Hookload Max (klbf),Hookload Min (klbf),Hookload Avg (klbf),Block Height (ft)\n" + rows("%(t)s,999,1,%(h)s,%(b)s"),
    "flow out beside flow in": "Time (s),Hook Load (klbf),Block Height (ft),Flow Out (gpm),Flow In (gpm)\n" + rows("%(t)s,%(h)s,%(b)s,9,528.3441046"),
    "remarks with % and //": "% of rig 7\n// exported\n" + PLAIN + rows("%(t)s,%(h)s,%(b)s"),
    "an average at the end": PLAIN + rows("%(t)s,%(h)s,%(b)s") + "Average,202.6,62.6\n",
    "the header again": PLAIN + rows("%(t)s,%(h)s,%(b)s").replace("15,", PLAIN + "15,"),
    "aligned columns": "Time      HookLoad  BlockHt\n(s)       (klbf)    (ft)\n" + rows("%(s)-9d %(h)-9s %(b)s"),
    "a block in millimetres": PLAIN.replace("(ft)", "(mm)") + rows("%(t)s,%(h)s,%(b)s", block=304.8),
    "LAS by seconds": LAS % ("TIME.S : t\nHKLD.KLB : h\nBPOS.F : b\nDBTM.M : d\n", rows("%(t)s %(h)s %(b)s %(d)s")),
    "LAS by hours": LAS % ("TIME.HOURS : t\nHKLD.1000 LBF : h\nBPOS.FEET : b\n", "".join("%.17g %s\n" % (t / 3600, line.split(" ", 1)[1]) for t, line in zip(SECONDS, rows("%(t)s %(h)s %(b)s").splitlines()))),
    "LAS with a date and a time": LAS % ("DATE. : d\nTIME. : t\nHKLD.KLBF : h\nBPOS.FT : b\n", rows("%(t)s %(h)s %(b)s", "%d-%b-%Y %H:%M:%S")),
    "LAS with a date and a time without signs": LAS % ("DATE.YYYYMMDD : d\nTIME.HHMMSS : t\nHKLD.KLBF : h\nBPOS.FT : b\n", rows("%(t)s %(h)s %(b)s", "%Y%m%d %H%M%S")),
    "two figures of the year, by the header": "Date (YYMMDD),Time (HHMMSS),Hook Load (klbf),Block Height (ft)\n" + rows("%(t)s,%(h)s,%(b)s", "%y%m%d,%H%M%S"),
    "LAS by depth with a time": LAS % ("DEPT.M : d\nETIM.MS : t\nHKLD.KLBF : h\nBPOS.FT : b\n", rows("%(d)s %(t)s000 %(h)s %(b)s")),
}
OTHERS = {"top_drive_speed": 2.0 * math.pi, "stand_pipe_pressure": 1e7, "torque": 5000.0, "flow": 2.0 / 60.0}
NOT_RECORDS = {
    "month first": ("DATE,TIME,HKLD,BPOS\n,,klb,ft\n" + rows("%(t)s,%(h)s,%(b)s", "%m/%d/%Y,%H:%M:%S"), "05/21/2024 09:59:50 is not a date with a time of day"),
    "time of the day alone": ("Time,Hook Load (klbf),Block Height (ft)\n" + rows("%(t)s,%(h)s,%(b)s", "%H:%M:%S"), "09:59:50 is not a date"),
    "days of a spreadsheet": ("Time,Hook Load (klbf),Block Height (ft)\n" + rows("45433.4%(t)s,%(h)s,%(b)s"), "the time has no unit and is not a date"),
    "the clock is set back": ("Time,Hook Load (klbf),Block Height (ft)\n" + rows("%(t)s,%(h)s,%(b)s", "%Y-%m-%d %H:%M:%S").replace("10:00:10", "09:00:10"), "the time goes back"),
    "pounds called klbf": (PLAIN + rows("%(t)s,%(h)s,%(b)s", load=1e3), "is the unit right?"),
    "a time that lost its zero": ("Date (YYYYMMDD),Time (HHMMSS),Hook Load (klbf),Block Height (ft)\n" + rows("%(t)s,%(h)s,%(b)s", "%Y%m%d,%H%M%S").replace(",09", ",9"), "unit HHMMSS is not known for a time"),
    "by depth": (LAS.replace("STRT.S", "STRT.M") % ("DEPT.M : d\nROP.M/HR : r\nHKLD.KLBF : h\n", rows("%(t)s 10 %(h)s")), "none of its curves is a time"),
    "two wells by their titles": ("Well: A-1\n" + PLAIN + "".join(rows("%(t)s,%(h)s,%(b)s").splitlines(True)[:3]) + "Well: B-2\n" + PLAIN + "".join(rows("%(t)s,%(h)s,%(b)s").splitlines(True)[3:]),
                                  "r.csv:6: is of B-2, the lines above of A-1; needed: one well in a file"),
    "two wells by comments": ("# Well Name = A-1\n" + PLAIN + rows("%(t)s,%(h)s,%(b)s") + "# Well Name = B-2\n30,206,66\n", "is of B-2"),
    "numbers of WITS": ("0105,0106,0108,0112,0114\n" + rows("%(t)s,%(d)s,%(b)s,%(h)s", "%y%m%d,%H%M%S"), "no column is recognised as the time"),
}

STATIONS = ((0.0, 0.0, 0.0), (100.0, 0.0, 0.0), (200.0, 10.0, 45.0), (300.0, 20.5, 60.25))


def stations(sign=",", md=1.0, angle=1.0, before="", after="", decimal="."):
    return "".join(before + sign.join("%.12g" % value for value in (md * depth, angle * inclination, angle * azimuth)).replace(".", decimal) + after + "\n" for depth, inclination, azimuth in STATIONS)


def xml(station, namespace="http://www.witsml.org/schemas/1series", name="trajectory", md=1.0, angle=1.0):
    return '<%s xmlns="%s">%s</%s>' % (name, namespace, "".join(station % (md * depth, angle * inclination, angle * azimuth) for depth, inclination, azimuth in STATIONS), name)


STATION = '<trajectoryStation><md uom="m">%.12g</md><incl uom="dega">%.12g</incl><azi uom="dega">%.12g</azi></trajectoryStation>'
STATION_2 = '<TrajectoryStation><MD uom="m">%.12g</MD><TypeTrajStation>magnetic MWD</TypeTrajStation><Incl uom="dega">%.12g</Incl><Azi uom="dega">%.12g</Azi></TrajectoryStation>'
VERSION_2 = {"namespace": "http://www.energistics.org/energyml/data/witsmlv2", "name": "Trajectory"}
SURVEYS = {
    "metres": "MD (m),Inc (deg),Azi (deg)\n" + stations(),
    "feet": "Measured Depth (ft),Inclination (°),Azimuth (°)\n" + stations(md=1 / FEET),
    "US survey feet": "MD (US ft),Inc (deg),Azi (deg)\n" + stations(md=3937 / 1200),
    "kilometres": "MD (km),Inc (deg),Azi (deg)\n" + stations(md=1e-3),
    "radians": "MD (m),Inc (rad),Azi (rad)\n" + stations(angle=math.pi / 180),
    "gons": "MD (m),Inc (gon),Azi (gon)\n" + stations(angle=10 / 9),
    "decimal commas": "MD (m);Inc (deg);Azi (deg)\n" + stations(";", decimal=","),
    "names over two lines": "Measured,Incl.,Azim.\nDepth,,\n(m),(deg),(deg)\n" + stations(),
    "names over two lines, a grid's north": "Measured;Inclination;Azimuth\nDepth;Angle;Grid\nft;deg;deg\n" + stations(";", md=1 / FEET),
    "aligned": "   MD      Inc     Azi\n  (m)     (deg)   (deg)\n" + stations("   "),
    "others beside them": "No.,Date,MD (m),Inc (deg),Azi (deg),DLS (deg/30m),TF\n" + stations(before="1,2024-05-21,", after=",1,HS"),
    "WITSML 1.4.1.1": xml(STATION),
    "WITSML 1.3.1.1 in feet": xml(STATION.replace('"m"', '"ft"'), "http://www.witsml.org/schemas/131", md=1 / FEET),
    "WITSML 1.4.1.1 in radians": xml(STATION.replace("dega", "rad"), angle=math.pi / 180),
    "WITSML 2.0": xml(STATION_2, **VERSION_2),
    "WITSML 2.0 in US survey feet": xml(STATION_2.replace('"m"', '"ft[US]"'), md=3937 / 1200, **VERSION_2),
}
NOT_SURVEYS = {
    "no unit of depth": ("MD,Inc,Azi\n" + stations(), "the header gives no unit"), "grads": ("MD (m),Inc (grad),Azi (grad)\n" + stations(), "ambiguous, allowed: gon or deg"),
    "from the bottom up": ("MD (m),Inc (deg),Azi (deg)\n300,0,0\n200,0,0\n0,0,0\n", "from the bottom up"), "negative depths": ("MD (m),Inc (deg),Azi (deg)\n" + stations(md=-1.0), "md -100 m is out of range, allowed: 0 to 20000 m"),
    "no unit of WITSML": (xml(STATION.replace(' uom="m"', "")), "md: has no unit (uom)"), "positions alone": ("TVD (m),N/S (m),E/W (m)\n0,0,0\n", "no line names measured depth, inclination and azimuth"),
}


class Files(Folder):
    def test_records(self):
        for what, text in RECORDS.items():
            with self.subTest(what):
                record = self.read(text)
                self.assertEqual(list(SECONDS), [round(time, 6) for time in record.time])
                self.assertIn(record.begin, (None, SINCE_1970))
                for signal, values in (("hook_load", [KLBF * load for load in LOADS]), ("block_height", [FEET * block for block in BLOCKS]), ("bit_depth", DEPTHS)):
                    if signal in record or signal != "bit_depth":
                        numpy.testing.assert_allclose(record.signals[signal], values, rtol=1e-6)
                for signal, value in OTHERS.items():
                    if signal in record:
                        numpy.testing.assert_allclose(record.signals[signal], value, rtol=1e-6)
                self.assertEqual("Pason" in what, {"torque", "flow", "bit_depth"} <= set(record.signals) and "Rotary" in text)

    def test_what_is_reported(self):
        """RPM is its own unit; a flow that does not say which is that into the well; texts between the rows and after them."""
        header = "Time (s),Hook Load (klbf),Block Height (ft),Surface RPM,Flow (L/min)\n"
        lines = rows("%(t)s,%(h)s,%(b)s,60,1200").splitlines(True)
        record = self.read(header + "".join(lines[:3]) + "\nPage 1 of 2\n\f\n" + header + "".join(lines[3:]) + "\nEnd of file\n")
        self.assertEqual(list(SECONDS), list(record.time))
        numpy.testing.assert_allclose(record.signals["hook_load"], [KLBF * load for load in LOADS])
        numpy.testing.assert_allclose(record.signals["top_drive_speed"], 2.0 * math.pi)
        numpy.testing.assert_allclose(record.signals["flow"], 0.02)
        for said in ("top_drive_speed: Surface RPM has no unit and is read as rpm", "Flow (L/min) is read as the flow into the well",
                     "2 lines of text between the rows or after them are skipped (first: line 6: Page 1 of 2)", "1 lines repeat the names of the columns"):
            self.assertIn(said, "\n".join(record.remarks))

    def test_what_no_rig_has(self):
        """In range of the gauges, but as in another unit."""
        header = "Time (s),Hook Load (%s),Block Height (%s),SPP (%s),Flow (gpm)\n"
        lines = rows("%(t)s,%(h)s,%(b)s,2900,500")
        for units, said in ((("lbf", "ft", "psi"), "hook_load: its largest value is 912 N, less than a block weighs; is its unit right?"),
                            (("klbf", "m", "psi"), None), (("klbf", "ft", "Pa"), "stand_pipe_pressure: its largest value is 2.9e+03 Pa, while the pump runs"), (("klbf", "ft", "psi"), None)):
            found = "\n".join(self.read(header % units + lines).remarks)
            self.assertEqual(said is not None, "is its unit right" in found, found)
            self.assertIn(said or "", found)
        self.assertIn("flow: its largest value is 0.139 m3/s, more than the pumps of a rig deliver", "\n".join(self.read(header % ("klbf", "ft", "psi") + lines.replace(",500", ",2200")).remarks))
        self.assertIn("block_height: its largest value is 66 m, higher than masts are", "\n".join(self.read(header % ("klbf", "m", "psi") + lines.replace(",65,", ",66,")).remarks))
        self.refused('format: "%y-%m-%d %H:%M:%S" or "%d-%m-%y %H:%M:%S"', "Time,Hook Load (klbf),Block Height (ft)\n" + rows("%(t)s,%(h)s,%(b)s", "%d-%m-%y %H:%M:%S"))

    def test_what_is_no_record(self):
        for what, (text, said) in NOT_RECORDS.items():
            with self.subTest(what):
                self.refused(said, text)

    def test_surveys(self):
        for what, text in SURVEYS.items():
            with self.subTest(what):
                survey = read_survey(self.file("survey.csv", text))
                self.assertEqual([station[0] for station in STATIONS], [round(md, 6) for md in survey.md])
                numpy.testing.assert_allclose(survey.tangents, [direction(*map(math.radians, station[1:])) for station in STATIONS], atol=1e-9)

    def test_what_is_no_survey(self):
        for what, (text, said) in NOT_SURVEYS.items():
            with self.subTest(what), self.assertRaises(SurveyError) as caught:
                read_survey(self.file("survey.csv", text))
            self.assertIn(said, str(caught.exception))
            self.assertNotIn("\n", str(caught.exception))


if __name__ == "__main__":
    unittest.main()
