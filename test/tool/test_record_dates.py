#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Dates and times of records, in the forms of programs, loggers and countries: each is read right, or refused with a hint that fits. See test_record_variants.py."""
import datetime
import unittest

from drill_rig_sim.field.dates import seconds_of
from record_folder import MAP, ROWS, Folder
from test_record_variants import DATED, dates, table

DAYS = ["%.8f" % (45413.5 + row[0] / 86400) for row in ROWS]  # of a spreadsheet

READ = {
    "ctime": table(header=DATED, times=dates("%a %b %d %H:%M:%S %Y")),
    "ctime with a zone": table(header=DATED, times=dates("%a %b %d %H:%M:%S UTC %Y")),
    "month by name first": table(header=DATED, times=dates('"%b %d, %Y %I:%M:%S %p"')),
    "of a mail": table(header=DATED, times=dates('"%a, %d %b %Y %H:%M:%S +0000"')),
    "month by name, points": table(header=DATED, times=dates("%d. %b. %Y %H:%M:%S")),
    "month by name, no signs": table(header=DATED, times=dates("%d%b%Y %H:%M:%S")),
    "day of the year": table(header=DATED, times=dates("%Y/%j %H:%M:%S")),
    "day of the year, ISO 8601": table(header=DATED, times=dates("%Y-%jT%H:%M:%SZ")),
    "day of the year, no signs": table(header=DATED, times=dates("%Y%jT%H%M%S")),
    "day of the year, colons": table(header=DATED, times=dates("%Y:%j:%H:%M:%S")),
    "day of the year beside the time": table(header=("Date,Time", *DATED[1:]), times=dates("%Y-%j,%H:%M:%S")),
    "12 hours, points": table(header=DATED, times=dates("%Y-%m-%d %I:%M:%S a.m.")),
    "a line below": table(header=DATED, times=dates("%Y-%m-%d_%H:%M:%S")),
    "milliseconds after a colon": table(header=DATED, times=dates("%Y-%m-%d %H:%M:%S:000")),
    "a day at midnight beside the time": table(header=("Date,Time", *DATED[1:]), times=dates("%Y-%m-%d 00:00:00,%H:%M:%S")),
    "a day beside a time of no day": table(header=("Date,Time", *DATED[1:]), times=dates("%Y-%m-%dT00:00:00,1899-12-30 %H:%M:%S")),
    "24:00:05": table(header=DATED, times=["2024-05-21 23:59:55", "2024-05-21 24:00:00", "2024-05-21 24:00:05", "2024-05-22 00:00:10"]),
}
REFUSED = {
    "days of a spreadsheet": (table(header=DATED, times=DAYS), "(first: 45413.50000000, as a spreadsheet's days since 1899-12-30); needed: a map, --columns, {column: DateTime, unit: d}"),
    "days of a spreadsheet as dates": (table(header=("Time (date)", *DATED[1:]), times=DAYS), "as a spreadsheet's days since 1899-12-30); needed: a map, --columns, {column: Time (date), unit: d}"),
    "time of a spreadsheet": (table(header=("Date,Time", *DATED[1:]), times=["45413,%.8f" % (0.5 + row[0] / 86400) for row in ROWS]), "(first: 0.50000000, as a share of a day); needed: a map"),
    "WITS's date and time": (table(header=("Date,Time", *DATED[1:]), times=dates("%y%m%d,%H%M%S")), 'allowed: a format in a map: {column: [Date, Time], unit: date, format: "%y%m%d %H%M%S"}'),
    "a date without signs": (table(header=DATED, times=dates("%Y%m%d%H%M%S")), 'allowed: a format in a map: {column: DateTime, unit: date, format: "%Y%m%d%H%M%S"}'),
    "day of the year first": (table(header=DATED, times=dates("%j/%Y %H:%M:%S")), 'format: "%j/%Y %H:%M:%S"}'),
    "day of the year alone": (table(header=DATED, times=["2024/122"] * 4), "2024/122 is not a date with a time of day; allowed: ISO 8601"),
    "time before the date": (table(header=DATED, times=dates("%H:%M:%S %d.%m.%Y")), 'format: "%H:%M:%S %d.%m.%Y"}'),
    "points in the time": (table(header=DATED, times=dates("%d.%m.%Y %H.%M.%S")), 'format: "%d.%m.%Y %H.%M.%S"}'),
    "Chinese": (table(header=DATED, times=dates("%Y\u5e74%m\u6708%d\u65e5 %H:%M:%S")), 'format: "%Y\u5e74%m\u6708%d\u65e5 %H:%M:%S"}'),
    "25:00:05": (table(header=DATED, times=dates("%Y-%m-%d 25:%M:%S")), "2024-05-21 25:59:50 is not a date"),
}


class Dates(Folder):
    """Kind 07."""

    def test_what_is_read(self):
        self.all_right(READ)

    def test_what_is_refused(self):
        self.all_refused(REFUSED)

    def test_a_number_that_the_map_calls_a_date(self):
        self.refused("T: 45413.50000000 is not a date with a time of day, but a spreadsheet's days since 1899-12-30; needed: a map, --columns, {column: T, unit: d}",
                     table(header=("T", "H", "B"), times=DAYS), MAP.replace("unit: s", "unit: date"))
        self.assertIn("its rows are 5.79e-05 s apart; check the unit of the time", "\n".join(self.read(table(header=("T", "H", "B"), times=DAYS), MAP).remarks))

    def test_the_last_row_first(self):
        """As histories of a data base list them; rows that go back elsewhere are refused."""
        lines = table(header=DATED, times=dates("%Y-%m-%d %H:%M:%S")).splitlines()
        self.right(self.read("\n".join([lines[0], *lines[:0:-1]]) + "\n"), ["its rows begin with the last one in time and are read in the order of time"])
        self.refused("the time goes back", "\n".join([lines[0], *lines[:1:-1], lines[1], lines[4]]) + "\n")

    def test_clocks_that_are_changed(self):
        """In spring an hour is missing, in autumn one comes again; of a gap of another length, and of times without a date, nothing is said."""
        def of(first, second, form="2024-03-10 %s"):
            rows = [form % ("0%d:59:%02d" % (first, k)) for k in (40, 45, 50, 55)] + [form % ("0%d:00:%02d" % (second, k)) for k in (0, 5, 10, 15)]
            return ("T,Hook Load (klbf),Block Height (ft)\n" + "".join("%s,200,30\n" % row for row in rows)).replace("T,", "Time,")
        said = ", the hour by which clocks are put forward; are the times those of one zone?"
        self.assertIn("a gap of 3605 s from 15 s on" + said, "\n".join(self.read(of(1, 3)).remarks))
        self.assertNotIn("clocks", "\n".join(self.read(of(1, 4)).remarks))
        self.refused("needed: times with their zone, such as 01:30:00-05:00; this is the hour by which clocks are put back", of(1, 1))
        self.refused("needed: time that increases, dates where it goes over midnight", of(3, 1))

    def test_months_in_other_languages(self):
        """Short and long, with accents and points; of Finnish, whose names begin as those of other months, none."""
        names = {1: "Januar janvier enero gennaio jan.", 2: "Februar février févr. fev febbraio", 3: "März Mär. mars marzo março maart", 4: "avril avr. abril abr", 5: "Mai mayo maggio mei mai.",
                 6: "Juni juin junio giugno", 7: "Juli juillet juil. julio luglio", 8: "août agosto ago", 9: "septembre setembro set. settembre", 10: "Oktober Okt. octubre outubro ottobre",
                 11: "novembre noviembre", 12: "Dezember Dez. décembre diciembre desember"}
        for month, texts in names.items():
            for name in texts.split():
                expected = datetime.datetime(2026, month, 21, 10, 3, 5, tzinfo=datetime.timezone.utc).timestamp()
                for form in ("21. %s 2026 10:03:05", "21 %s 2026 10:03:05", "21-%s-2026 10:03:05", "21. %s 2026, 10:03:05 Uhr"):
                    self.assertEqual(expected, (seconds_of(form % name) or [None])[0], form % name)
        for text in ("21 marraskuu 2026 10:03:05", "21 Monat 2026 10:03:05", "21. 2026 10:03:05"):
            self.assertIsNone(seconds_of(text), text)
        self.assertEqual(seconds_of("2026-05-21 22:03:05"), seconds_of("21/05/2026 10:03:05 p. m.", "%d/%m/%Y %I:%M:%S %p"))

    def test_dates_of_many_forms(self):
        for text in ("Sat Nov 28 10:03:00 2026", "Saturday, 28 November 2026 10:03:00", "2026/332 10:03:00", "2026-332T10:03:00Z", "2026332T100300", "20261128_100300", "28-Nov-2026, 10:03",
                     "Nov 28, 2026 10:03:00 a.m.", "2026-11-28 10:02:60", "2026:332:10:03:00"):
            self.assertEqual(datetime.datetime(2026, 11, 28, 10, 3, tzinfo=datetime.timezone.utc).timestamp(), (seconds_of(text) or [None])[0], text)
        for text in ("Sat Nov 28 10:03:00", "2026-366T10:03:00", "2026-000T10:03:00", "2026-11-28 13:00:00 p.m.", "2026-11-28 24:60:00", "2026-02-30 10:00:00", "28 Nowhere 2026 10:00:00"):
            self.assertIsNone(seconds_of(text), text)


if __name__ == "__main__":
    unittest.main()
