#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""A campaign's results' file: rows, readers, full disks and locks, and the page made of it."""
import io
import re
import sqlite3
import unittest
from contextlib import redirect_stderr, redirect_stdout
from unittest import mock

import test_campaign_parts  # skips where there is no Dask
from drill_rig_sim.campaign import command
from drill_rig_sim.campaign.results import Locked, Results, ResultsError
from test_campaign_parts import drill_campaign


class File(test_campaign_parts.Folder):
    ROW = ("k1", [1.0], "good", "", {"x": 2.0}, 0.1, "w")

    def about(self, planned):
        return {"planned": planned, "name": "n", "factors": ["f"], "outputs": ["x"]}

    def test_rows_come_back_in_the_plans_order_once_each(self):
        results = Results(self.place("r.sqlite"))
        self.addCleanup(results.close)
        results.describe(**self.about(["k2", "k1", "k3"]))
        results.add([self.ROW, ("k2", [2.0], "cpu", "long", {}, 9.0, "w")])
        results.add([("k1", [1.0], "good", "", {"x": 5.0}, 0.1, "w")])
        self.assertEqual([("k2", {}), ("k1", {"x": 2.0})], [(row["key"], row["outputs"]) for row in results.rows()])
        self.assertEqual({"k1", "k2"}, results.done())
        results.write_csv(self.place("r.csv"))
        with open(self.place("r.csv"), encoding="utf-8") as text:
            self.assertEqual("number,f,status,reason,x\n0,2.0,cpu,long,\n1,1.0,good,,2.0\n", text.read().replace("\r", ""))
        results.forget_bad(["k1", "k2"])
        self.assertEqual({"k1"}, results.done())

    def test_the_end_tells_the_first_reason_of_each_kind(self):
        results = Results(self.place("r.sqlite"))
        self.addCleanup(results.close)
        results.describe(**self.about(["k1", "k2", "k3", "k4"]))
        results.add([self.ROW, *(("k%d" % k, [2.0], status, "why %d" % k, {}, 9.0, "w") for k, status in ((2, "judge"), (3, "cpu"), (4, "cpu")))])
        out = io.StringIO()
        with redirect_stdout(out):
            self.assertEqual(1, command.print_outcome(results, 4))
        self.assertEqual("4 of 4 runs are in the results: 2 cpu, 1 good, 1 judge\ncpu, first run 2: why 3\njudge, first run 1: why 2\n", out.getvalue())

    def test_what_is_left_is_told_once_a_run_is_done(self):
        out = io.StringIO()
        progress = command.Progress(2, out)
        progress.tell()
        self.assertIn(", ? to go", out.getvalue())
        progress.count("good")
        progress.tell()
        self.assertRegex(out.getvalue(), r"1 of 2 done, 0 of them bad, .*, 0:00:0\d to go")

    def test_one_writes_and_others_read(self):
        results = Results(self.place("r.sqlite"))
        self.addCleanup(results.close)
        results.describe(**self.about(["k1"]))
        with self.assertRaisesRegex(ResultsError, "another campaign is writing it"):
            Results(self.place("r.sqlite"))
        results.add([self.ROW])
        self.assertEqual(1, len(list(Results(self.place("r.sqlite"), write=False).rows())))

    def test_a_full_disk_is_told_in_one_line(self):
        results = Results(self.place("r.sqlite"))
        self.addCleanup(results.close)
        results.describe(**self.about(["k1"]))
        pages = results.data.execute("pragma page_count").fetchone()[0]
        results.data.execute("pragma max_page_count = %d" % pages)
        kept = command.Kept(results, command.Progress(2, io.StringIO()))
        kept.take("k1", [1.0], ("good", "", {"x": 2.0}, 0.1, "w"))
        kept.keep()
        kept.take("k2", [1.0], ("controller", 20000 * "why ", {}, 0.1, "w"))
        with self.assertRaisesRegex(ResultsError, "^%s: database or disk is full$" % re.escape(results.file)):
            kept.keep()
        self.assertEqual((1, {"k1"}), (kept.number, results.done()))

    def test_results_wait_while_another_program_holds_the_file(self):
        results = Results(self.place("r.sqlite"))
        self.addCleanup(results.close)
        results.describe(**self.about(["k1", "k2"]))
        other = sqlite3.connect(self.place("r.sqlite"))
        self.addCleanup(other.close)
        other.execute("begin immediate")
        told = io.StringIO()
        kept = command.Kept(results, command.Progress(2, io.StringIO()))
        with mock.patch.object(command, "KEEP_EVERY", 0.0), mock.patch.object(command, "SHORT_PATIENCE", 0.1), redirect_stderr(told):
            for key in ("k1", "k2"):
                kept.take(key, [1.0], ("good", "", {"x": 2.0}, 0.1, "w"))
        self.assertEqual("drill_campaign: %s: another program reads or writes it and holds it locked: results are written later\n" % results.file, told.getvalue())
        with self.assertRaises(Locked):
            kept.keep(patience=0.1)
        other.rollback()
        kept.keep()
        self.assertEqual((2, {"k1", "k2"}), (kept.number, results.done()))

    def test_a_locked_file_is_told_in_one_line(self):
        Results(self.place("r.sqlite")).close()
        other = sqlite3.connect(self.place("r.sqlite"))
        self.addCleanup(other.close)
        other.execute("begin exclusive")
        with mock.patch("drill_rig_sim.campaign.results.PATIENCE", 0.1):
            for words in ((self.plan(), "--results", self.place("r.sqlite")), ("export", self.place("r.sqlite"))):
                status, _, told = drill_campaign(*words)
                self.assertEqual(2, status)
                self.assertRegex(told, "^drill_campaign: %s: .*locked.*\n$" % re.escape(self.place("r.sqlite")))

    def test_a_scheduler_beyond_tls_needs_certificates(self):
        status, _, told = drill_campaign(self.plan(), "--results", self.place("r.sqlite"), "--scheduler", "tls://127.0.0.1:8786")
        self.assertEqual(3, status)
        self.assertRegex(told, r"^drill_campaign: tls://127.0.0.1:8786: there are no certificates, needed: .*; 0 runs are done, the same command continues\n")

    def test_what_is_no_results_file(self):
        with open(self.place("text"), "w", encoding="utf-8") as out:
            out.write("no database\n" * 100)
        other = sqlite3.connect(self.place("other"))
        other.execute("create table t (x)")
        other.execute("pragma user_version = 7")
        other.commit()
        other.close()
        for name in ("text", "other", "no/such/folder"):
            with self.assertRaises(ResultsError) as told:
                Results(self.place(name))
            self.assertIn(name, str(told.exception))
        self.assertEqual(2, drill_campaign("report", self.place("nowhere.sqlite"))[0])

    def test_the_page_holds_all(self):
        status, _, told = drill_campaign(self.plan(), "--results", self.place("r.sqlite"), "--workers", "1")
        self.assertEqual(0, status, told)
        status, page, _ = drill_campaign("report", self.place("r.sqlite"))
        self.assertEqual((0, self.place("r.html")), (status, page.strip()))
        with open(page.strip(), encoding="utf-8") as text:
            text = text.read()
        self.assertEqual(3, text.count("data:image/png;base64,"))
        self.assertEqual([], re.findall(r"(?:src|href)=\"(?!data:)", text))
        self.assertIn("drill_campaign scene r.sqlite --run 5", text)
        for command_line in ("roslaunch $PWD/run_3.launch rviz:=true", "drill_campaign play r.sqlite --run 3 --csv run_3.csv"):
            self.assertIn(command_line, text)


if __name__ == "__main__":
    unittest.main()
