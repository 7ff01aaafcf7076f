#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""A run of five stands, a slide and a trip, drawn by drill plot: what a driller opens its page for. In Chromium too with DRILL_RIG_SIM_BROWSER=1, with
pictures in the folder DRILL_RIG_SIM_PICTURES. Usage: test_plot_run.py PATH_TO_DRILL"""
import json
import os
import re
import subprocess
import sys
import tempfile
import unittest

import numpy
import skips
from drill_rig_sim.score_runs import read_run
from drill_rig_sim.web.chart_library import has_chart_library

SOURCE = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
SCENE = os.path.join(SOURCE, "test", "scenes", "five_stands.yaml")
PLAN = "md_m,inclination_deg,azimuth_deg\n0,0,0\n100,0,45\n250,30,45\n320,30,45\n460,38,50\n"
SHEETS = ("time_log", "depth_log", "well", "broomstick", "tally", "slides")
drill_program = None


class FiveStands(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        if not has_chart_library():
            raise unittest.SkipTest("libjs-chart.js is not installed")
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.csv, plan, cls.out = (os.path.join(folder.name, name) for name in ("run.csv", "plan.csv", "out"))
        with open(plan, "w", encoding="utf-8") as text:
            text.write(PLAN)
        cls.drill("run", SCENE, "--csv", cls.csv)
        cls.drill("plot", cls.csv, "--plan", plan, "--scene", SCENE, "--out", cls.out)
        cls.page = os.path.join(cls.out, "web.html")
        with open(cls.page, encoding="utf-8") as text:
            messages = json.loads(re.search(r'id="run">(.*?)</script>', text.read(), re.DOTALL).group(1).replace(r"<\/", "</"))
        cls.messages = {message["type"]: message for message in messages if message["type"] != "bins"}
        cls.time_log, cls.depth_log = (next(one for one in messages if one["type"] == "bins" and one["log"] == log) for log in ("time", "depth"))

    @staticmethod
    def drill(*words):
        done = subprocess.run([drill_program, *words], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
        if done.returncode != 0:
            raise AssertionError(done.stdout)

    def test_nine_connections_of_nine(self):
        """Five while drilling, four on the way in; the four stands that the trip takes away are none."""
        connections = self.messages["sheets"]["connections"]
        self.assertEqual(list(range(1, 10)), [one["number"] for one in connections])
        self.assertEqual(5 * [True] + 4 * [False], [one["weight_to_weight"] is not None for one in connections])
        for one in connections:
            self.assertGreater(one["in_slips"], 30.0)  # the rig's own time
            self.assertLess(one["in_slips"], 80.0)

    def test_the_slide(self):
        slides = [row for row in self.messages["sheets"]["slides"] if row["kind"] == "slide"]
        self.assertEqual(1, len(slides))
        self.assertAlmostEqual(9.0, slides[0]["depth_to"] - slides[0]["depth_from"], delta=0.5)

    def test_the_largest_hook_load_is_on_the_sheet(self):
        largest = max(read_run(self.csv)["hook_load"])
        high = [value for value in self.time_log["signals"]["hook_load"][2] if value is not None]
        self.assertAlmostEqual(1.0, max(high) / largest, places=5)
        with open(os.path.join(self.out, "time_log.svg"), encoding="utf-8") as picture:
            self.assertEqual(["%.1f" % (1e-3 * largest)], re.findall(r"<!-- largest hook load ([0-9.]+) kN at [0-9]+ s -->", picture.read()))

    def test_deviation_from_plan_by_depth(self):
        """The hole goes on straight at 30 deg from 300 m; the plan builds from 320 m on: nearly a circle of 140 m / 8 deg = 1003 m, low by 127 m^2/(2 x 1003 m)
        = 8.0 m at 447 m, and turns right by 5 deg sin(34 deg) over 140 m: 127^2/140/2 x 0.0488 = 2.8 m to the left."""
        away = self.messages["well"]["deviation"]
        depth, low, left = numpy.array(away["depth"], float), -numpy.array(away["up"], float), -numpy.array(away["right"], float)
        self.assertLess(abs(low[depth < 320.0]).max(), 0.05)
        self.assertTrue((numpy.diff(low[depth > 330.0]) > 0.0).all())
        self.assertAlmostEqual(8.0, low[-1], delta=0.5)
        self.assertAlmostEqual(2.8, left[-1], delta=0.5)
        self.assertAlmostEqual(447.0, depth[-1], delta=0.5)

    def test_specific_energy_by_the_bit_of_the_scene(self):
        energy = [value for value in self.depth_log["signals"]["mse"][2] if value is not None]
        self.assertGreater(len(energy), 20)
        self.assertGreater(min(energy), 0.0)

    def test_weights_of_the_run_are_on_the_broomstick(self):
        """Each within 2 % of what drill static says at its depth, by the friction of the scene."""
        theory = self.messages["broomstick"]["points"]
        self.assertEqual([], [one for one in theory if one["load"] is None])
        weights = self.messages["weights"]["points"]
        self.assertTrue({"up", "down"} <= {one["motion"] for one in weights}, weights)
        self.assertGreaterEqual(len(weights), 6)
        for one in weights:
            curve = sorted((point["depth"], point["load"]) for point in theory if point["factor"] == 1.0 and point["motion"] == one["motion"])
            self.assertAlmostEqual(1.0, one["load"] / numpy.interp(one["depth"], *zip(*curve)), delta=0.02, msg=one)

    def test_pages_in_chromium(self):
        if not os.environ.get("DRILL_RIG_SIM_BROWSER"):
            self.skipTest("the page in Chromium is tested by ./test/run --browser")
        sys.path.insert(0, os.path.join(SOURCE, "test", "rostest"))
        from browser import Page, blank_charts, chrome, on_paper, paper, picture, resize
        browser = chrome(1280, 800)
        self.addCleanup(browser.quit)
        page = Page(browser, "file://" + self.page)
        page.wait_text("#link", "^recorded$")
        self.assertEqual("0", page.one("#span").get_attribute("value"))  # the whole run
        for theme, width, height in (("light", 1280, 800), ("dark", 1920, 1080), ("light", 390, 844)):
            resize(browser, width, height, mobile=width < 500)
            while page.text("#theme") != theme:
                page.click("#theme")
            for sheet in SHEETS:
                page.click("#tab_" + sheet)
                picture(browser, "run_%s_%s_%d" % (sheet, theme, width))
        self.assertEqual(9, len(browser.find_elements("css selector", "#connections tbody tr")))
        self.assertRegex(page.text("#well_summary"), "low")
        self.assertFalse(page.one("#work_out").is_displayed())
        self.assertEqual([], page.errors())
        page.click("#tab_time_log")
        resize(browser, 1280, 800)
        with on_paper(browser):
            self.assertEqual([], [name for name in (".ends .low", ".ends .high") if not page.one("#time_log " + name).is_displayed()])
            self.assertFalse(page.one("#time_log button:not(.low, .high)").is_displayed())
            self.assertEqual([], blank_charts(browser))
            self.assertTrue(page.one("#broomstick canvas").is_displayed())
        self.assertFalse(page.one("#broomstick canvas").is_displayed())
        pdf = paper(browser)
        self.assertTrue(pdf.startswith(b"%PDF"))
        folder = os.environ.get("DRILL_RIG_SIM_PICTURES")
        if folder:
            with open(os.path.join(folder, "run_print.pdf"), "wb") as out:
                out.write(pdf)


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    drill_program = os.path.abspath(sys.argv.pop(1))
    skips.main()
