#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""drill plot, but for the runner in front of it: what is drawn of a run, that the page needs nothing else, and what is refused."""
import io
import math
import os
import re
import tempfile
import unittest
import unittest.mock
from contextlib import redirect_stderr, redirect_stdout

import numpy
from drill_rig_sim import plot_command, plot_logs, plot_well
from drill_rig_sim.score import score
from drill_rig_sim.score_runs import Run
from drill_rig_sim.survey import Survey

DEGREE = math.pi / 180.0


def run_of(sliding=False, drilled=5.0, inclination=30.0 * DEGREE, **more):
    """100 s in which the bit goes down steadily by so much [m]; the hole leads east."""
    time = numpy.arange(0.0, 100.05, 0.1)
    depth = 1000.0 + drilled * time / 100.0
    way = depth - 1000.0
    columns = {"time": time, "hole_depth": depth, "bit_depth": depth, "wob": numpy.full_like(time, 50e3), "torque": 5e3 + 100.0 * numpy.sin(time),
               "top_drive_speed": numpy.full_like(time, 0.0 if sliding else 10.0), "bit_speed": numpy.full_like(time, 20.0), "hook_load": numpy.full_like(time, 900e3),
               "bit_east": way * math.sin(inclination), "bit_north": 0.0 * way, "bit_up": -way * math.cos(inclination), "inclination": 0.0 * way + inclination,
               "azimuth": 0.0 * way + 90.0 * DEGREE, "toolface": 0.3 + 0.1 * numpy.sin(time), "in_slips": (time > 90.0).astype(float)}
    columns.update(more)
    return Run(columns, name="made up")


def curves(figure):
    """The data of every curve by the label of its scale."""
    return {panel.get_xlabel(): panel.lines[0].get_xdata() for panel in figure.axes if panel.lines and panel.get_xlabel()}


class Logs(unittest.TestCase):
    def tearDown(self):
        plot_logs.plt.close("all")

    def test_a_time_log_shows_what_there_is_in_the_trades_units(self):
        drawn = curves(plot_logs.time_log(run_of()))
        self.assertAlmostEqual(50.0, drawn["WOB [kN]"].mean())
        self.assertAlmostEqual(10.0 * 30.0 / math.pi, drawn["top drive [rpm]"].mean())
        self.assertAlmostEqual(900.0, drawn["hook load [kN]"].mean())
        self.assertNotIn("stand pipe [bar]", drawn)
        self.assertIn("stand pipe [bar]", curves(plot_logs.time_log(run_of(stand_pipe_pressure=numpy.full(1001, 1e7)))))

    def test_a_depth_log_is_of_means_by_depth(self):
        figure = plot_logs.depth_log(run_of())
        drawn = curves(figure)
        self.assertAlmostEqual(5.0 / 100.0 * 3600.0, numpy.median(drawn["ROP [m/h]"]), places=6)
        self.assertAlmostEqual(30.0, drawn["inclination [deg]"].mean())
        top, bottom = figure.axes[0].get_ylim()[::-1]
        self.assertTrue(1000.0 <= top < 1000.2 and 1004.8 < bottom <= 1005.1, (top, bottom))

    def test_depth_goes_downwards(self):
        begin, end = plot_logs.depth_log(run_of()).axes[0].get_ylim()
        self.assertGreater(begin, end)

    def test_a_vertical_hole_has_no_azimuth(self):
        self.assertTrue(numpy.isnan(curves(plot_logs.depth_log(run_of(inclination=0.001)))["azimuth [deg]"]).all())

    def test_bands_are_in_all_tracks_and_none_hides_another(self):
        time = numpy.arange(0.0, 100.05, 0.1)
        figure = plot_logs.time_log(run_of(sliding=True, accuracy_warning=(time > 5.0).astype(float)))
        tracks = figure.axes[:figure.tracks]
        self.assertGreater(len(tracks), 2)
        for track in tracks:
            # a polygon, or from matplotlib 3.9 on a rectangle
            boxes = [patch.get_path().get_extents(patch.get_patch_transform()) for patch in track.patches]
            widths = sorted((box.x0.round(2), box.x1.round(2)) for box in boxes)
            self.assertEqual([(0.0, 0.06), (0.0, 1.0), (0.94, 1.0)], widths)
        self.assertEqual(["in slips", "slide", "accuracy warning"], [text.get_text() for text in figure.legends[0].get_texts()])

    def test_the_largest_hook_load_is_on_the_sheet_and_a_cut_curve_has_its_extreme(self):
        load = numpy.full(1001, 500e3)
        load[500] = 555e3
        figure = plot_logs.time_log(run_of(hook_load=load))
        self.assertIn("largest hook load 555.0 kN at 50 s", [text.get_text() for text in figure.texts])
        self.assertIn("555 \u25b6", [text.get_text() for panel in figure.axes for text in panel.texts])

    def test_nothing_drilled_is_no_depth_log(self):
        self.assertIsNone(plot_logs.depth_log(run_of(drilled=0.01)))

    def test_a_bit_that_stands_has_no_specific_energy(self):
        scores = score(run_of(drilled=1e-4), bit_diameter=0.2)
        self.assertIsNone(scores["energy"])
        self.assertIn("energy: less than 0.18 m/h was drilled on bottom", scores["left_out"])

    def test_scales_have_a_least_span_and_are_not_spoilt_by_a_jerk(self):
        self.assertAlmostEqual(5.0, numpy.ptp(plot_logs.limits(numpy.full(100, 90.0) + 1e-9 * numpy.arange(100), 5.0)))
        jerk = numpy.full(1000, 90.0)
        jerk[3] = 1e6
        self.assertLess(plot_logs.limits(jerk, 5.0)[1], 100.0)
        self.assertLessEqual(plot_logs.limits(numpy.linspace(10.0, 100.0, 50), 1.0)[0], 0.0)


class Well(unittest.TestCase):
    def tearDown(self):
        plot_logs.plt.close("all")

    def test_from_above_and_in_section(self):
        above, section = plot_well.path(run_of(drilled=20.0)).axes
        self.assertAlmostEqual(20.0 * math.sin(30.0 * DEGREE), above.lines[0].get_xdata()[-1], places=1)
        self.assertAlmostEqual(20.0 * math.cos(30.0 * DEGREE), section.lines[0].get_ydata()[-1], places=1)
        self.assertIn("towards 90 deg", section.get_title())

    def test_a_plan_beside_it(self):
        plan = Survey([0.0, 100.0], [30.0 * DEGREE] * 2, [90.0 * DEGREE] * 2)
        labels = [line.get_label() for line in plot_well.path(run_of(drilled=20.0), plan).axes[0].lines]
        self.assertIn("plan", labels)

    def test_a_dial_of_what_is_slid_alone(self):
        self.assertIsNone(plot_well.toolface_dial(run_of()))
        figure = plot_well.toolface_dial(run_of(sliding=True))
        self.assertAlmostEqual(0.3, figure.axes[0].collections[0].get_offsets()[:, 0].mean(), delta=0.02)


class Command(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        self.csv = os.path.join(self.folder, "run.csv")
        run = run_of(sliding=True)
        with open(self.csv, "w") as text:
            text.write(",".join(run.columns) + "\n")
            text.writelines(",".join(map(str, row)) + "\n" for row in zip(*run.columns.values()))

    def plot(self, *words):
        out, said = io.StringIO(), io.StringIO()
        with redirect_stdout(out), redirect_stderr(said):
            status = plot_command.main(list(words))
        return status, out.getvalue().strip(), said.getvalue().strip()

    def test_the_page_of_drill_web_with_the_run_inside(self):
        library = os.path.join(self.folder, "chart.js")
        with open(library, "w") as out:
            out.write("window.Chart = 1;")
        with unittest.mock.patch.dict(os.environ, DRILL_RIG_SIM_CHART_JS=library):
            self.assertEqual(0, self.plot(self.csv)[0])
        with open(os.path.join(self.folder, "run_plots", "web.html")) as file:
            self.assertIn("window.Chart = 1;", file.read())

    def test_pictures_and_a_page_that_holds_them_with_the_file_s_name_alone_as_titles(self):
        status, page, said = self.plot(self.csv)
        self.assertEqual((0, "", os.path.join(self.folder, "run_plots", "index.html")), (status, said, page))
        with open(page) as file:
            text = file.read()
        self.assertEqual(4, text.count("data:image/png;base64,"))
        self.assertEqual([], re.findall(r"(?:src|href)=\"(?!data:|#)", text))
        for name in ("time_log", "depth_log", "well", "toolface"):
            for kind in ("png", "svg"):
                self.assertGreater(os.path.getsize(os.path.join(self.folder, "run_plots", "%s.%s" % (name, kind))), 5000)
        sections = re.findall(r"<section><h2 id=\"\w+\">([^<]+)</h2>\n<img [^>]*></section>", text)
        self.assertEqual(["Time log", "Depth log", "Well", "Toolface"], sections)  # on paper a heading stays with its picture
        self.assertTrue("@media screen and (prefers-color-scheme:dark)" in text and "section{break-inside:avoid}" in text)
        self.assertIn("rate of penetration", text)
        self.assertTrue("<h1>run.csv</h1>" in text and "<title>run.csv</title>" in text)
        self.assertTrue("<pre>%s, by its truth" % self.csv in text)  # which of all such names it is
        for name, title in (("time_log", "time log: run.csv"), ("depth_log", "depth log: run.csv"), ("well", "well: run.csv")):
            with open(os.path.join(self.folder, "run_plots", name + ".svg")) as picture:
                drawn = picture.read()
            self.assertTrue("<!-- %s -->" % title in drawn, title)
            self.assertFalse(self.folder in drawn)

    def test_names_are_not_markup(self):
        odd = os.path.join(self.folder, "<b>&.csv")
        os.rename(self.csv, odd)
        with open(self.plot(odd, "--out", os.path.join(self.folder, "out"))[1]) as file:
            self.assertNotIn("<b>&", file.read())

    def test_forces_along_the_string_at_its_end(self):
        string = os.path.join(self.folder, "profile.csv")
        with open(string, "w") as text:
            text.write("time,md,from_bit,east,north,up,tension,true_axial_force,torque,bending_moment,contact_force,contact_side_deg\n")
            for time in (1.0, 2.0):
                text.writelines("%g,%g,0,0,0,0,%g,0,0,0,0,0\n" % (time, 100.0 * k, 1e3 * time * k) for k in range(3))
        columns = plot_well.read_string(string)
        self.assertEqual(([0.0, 100.0, 200.0], [0.0, 2e3, 4e3]), (list(columns["md"]), list(columns["tension"])))
        self.assertEqual(0, self.plot(self.csv, "--string", string)[0])
        self.assertTrue(os.path.exists(os.path.join(self.folder, "run_plots", "string.svg")))

    def test_what_is_refused(self):
        for words in (["/nowhere.csv"], [self.csv, "--plan", "/nowhere.csv"], [self.csv, "--string", self.csv]):
            status, out, said = self.plot(*words)
            self.assertEqual((2, "", 1), (status, out, said.count("\n") + 1), said)
        with open(os.path.join(self.folder, "file"), "w"):
            pass
        self.assertEqual(3, self.plot(self.csv, "--out", os.path.join(self.folder, "file", "below"))[0])


if __name__ == "__main__":
    unittest.main()
