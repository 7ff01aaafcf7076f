#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Time series and strings as editors and spreadsheets leave them: drill score and drill plot read them by the rules of other tables, or refuse them by file, row and column.
Usage: test_run_files.py PATH_TO_DRILL"""
import json
import os
import subprocess
import sys
import unittest

import numpy
from drill_rig_sim import plot_well
from drill_rig_sim.score_runs import NEEDED, RunError, last_run, read_run
from in_folder import InFolder

ROWS = [(0.1 * k, 100.0 + 0.001 * k, 100.0 + 0.001 * k, 10e3, 600.0, 9.5) for k in range(300)]
STRING = "md,tension,true_axial_force,torque,bending_moment,contact_force\n0,5,5,1,0,2.5\n100,3,3,1,0,2.5\n"
drill_program = None


def series(sign=",", decimal="."):
    return "".join(sign.join(cells) + "\n" for cells in [NEEDED] + [[("%.9g" % number).replace(".", decimal) for number in row] for row in ROWS])


class RunFiles(InFolder):
    def test_of_a_series_whose_rig_was_reset_the_last_run_is_judged(self):
        time, epochs = numpy.arange(5.0), numpy.array([0, 0, 1, 2, 2])
        self.assertEqual((3, "2 earlier runs of the file, to 2 s: the rig was reset or restored there; only the rows after it are scored"), last_run(time, epochs))
        self.assertEqual((0, ""), last_run(time, 0 * epochs))

    def test_what_is_read(self):
        for what, text, encoding in (("as it is", series(), "utf-8"), ("mark", series(), "utf-8-sig"), ("UTF-16", series(), "utf-16"), ("ends of lines", series().replace("\n", "\r\n"), "utf-8"),
                                     ("an empty line", series() + "\n", "utf-8"), ("a spreadsheet", series(";", ","), "utf-8"), ("tabs", series("\t"), "utf-8"), ("comment", "# °\n" + series(), "latin-1")):
            with self.subTest(what):
                run = read_run(self.file("run.csv", text, encoding))
                self.assertEqual([list(column) for column in zip(*((float("%.9g" % number) for number in row) for row in ROWS))], [list(run[name]) for name in NEEDED])

    def test_what_is_refused_by_row_and_column(self):
        for text, said in ((series().replace("10000,600", "nan,600", 3), "run.csv:2: wob: nan is not a finite number"), (series().replace("10000,600", "10000,inf", 1), "run.csv:2: torque: inf"),
                           (series().replace("10000,600", ",600", 1), "run.csv:2: wob: an empty cell"), (series().replace("10000,600", "much,600", 1), "run.csv:2: wob: much is not a finite number"),
                           (series().replace("10000,600", "600", 1), "run.csv:2: has 5 cells, the header 6"), (series().replace("wob", "torque"), "there are 2 columns torque"),
                           (series().replace("wob", "weight"), "has no wob"), ("", "is empty"), (",".join(NEEDED) + "\n", "two rows or more"), (series() + "\0", "NUL")):
            with self.assertRaises(RunError, msg=said) as caught:
                read_run(self.file("run.csv", text))
            self.assertIn(said, str(caught.exception))
            self.assertNotIn("\n", str(caught.exception))

    def test_strings(self):
        for text, encoding in ((STRING, "utf-8-sig"), (STRING, "utf-16"), (STRING.replace(",", ";").replace(".", ","), "utf-8"), ("# °\n" + STRING, "latin-1")):
            columns = plot_well.read_string(self.file("s.csv", text, encoding))
            self.assertEqual(([0.0, 100.0], [2.5, 2.5]), (list(columns["md"]), list(columns["contact_force"])))
        for text, said in ((STRING.replace("100,3", "100,nan"), "s.csv:3: tension: nan is not a finite number"), (STRING.replace(",2.5", ""), "has 5 cells"), (STRING.replace("tension", "t"), "no column tension"),
                           (STRING.split("\n", 1)[0], "has no rows")):
            with self.assertRaises(plot_well.StringError) as caught:
                plot_well.read_string(self.file("s.csv", text))
            self.assertIn(said, str(caught.exception))

    def test_the_commands(self):
        """Infinite or missing numbers reach no table and no JSON."""
        good, bad = self.file("good.csv", series(), "utf-16"), self.file("bad.csv", series().replace("10000,600", "nan,600", 1))
        scores = os.path.join(self.folder, "s.json")
        for words, status in ((["score", good, "--json", scores], 0), (["score", bad, "--json", os.path.join(self.folder, "no.json")], 2), (["plot", bad], 2)):
            done = subprocess.run([drill_program, *words], stdout=subprocess.PIPE, stderr=subprocess.PIPE, universal_newlines=True, timeout=600)
            self.assertEqual((status, 1 if status else 0), (done.returncode, len(done.stderr.splitlines())), done.stderr)
        with open(scores, encoding="utf-8") as text:
            self.assertAlmostEqual(0.299, json.load(text, parse_constant=self.fail)["drilling"]["drilled_m"], places=6)
        self.assertFalse(os.path.exists(os.path.join(self.folder, "no.json")))


if __name__ == "__main__":
    drill_program = os.path.abspath(sys.argv.pop(1))
    unittest.main()
