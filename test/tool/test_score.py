#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Scores of made-up runs that are known in closed form. Usage: test_score.py [PATH_TO_DRILL], from an environment that finds drill_rig_sim."""
import contextlib
import csv
import io
import itertools
import json
import math
import os
import subprocess
import sys
import tempfile
import unittest

import numpy
from drill_rig_sim import score_command
from drill_rig_sim.score import score
from drill_rig_sim.score_runs import FLAGS, Run, RunError, read_run
from drill_rig_sim.survey import Survey, SurveyError, read_survey

AREA = 0.25 * math.pi * 0.2**2  # of the bit below
RATE = 0.01                     # it drills at [m/s]
drill_program = None


def columns(seconds=100.0, every=0.1, start=1000.0):
    """Off bottom for the first tenth, then 10 kN, 500 N m and 10 rad/s on bottom, vertically down; sliding, toolface 20 deg."""
    time = numpy.arange(0.0, seconds + 0.5 * every, every)
    drilling = time > 0.1 * seconds + 0.5 * every
    hole = start + RATE * numpy.maximum(time - 0.1 * seconds, 0.0)
    zero, one = numpy.zeros_like(time), numpy.ones_like(time)
    made = {"time": time, "hole_depth": hole, "bit_depth": numpy.where(drilling, hole + 0.002, start - 0.5), "wob": 10e3 * drilling,
            "torque": 600.0 * one, "top_drive_speed": zero, "bit_torque": 500.0 * drilling, "bit_speed": 10.0 * one, "inclination": zero,
            "azimuth": zero, "toolface": math.radians(20.0) * one, "bit_east": zero, "bit_north": zero, "bit_up": -hole, "in_slips": zero,
            "motor_stalled": zero}
    made.update({flag: zero for flag in FLAGS})
    return made


def turned(made, inclination, azimuth=0.0):
    """The hole follows these angles, functions of the measured depth."""
    depth = made["hole_depth"]
    made["inclination"] = numpy.vectorize(inclination)(depth) if callable(inclination) else inclination + 0.0 * depth
    made["azimuth"] = azimuth + 0.0 * depth
    return made


class Scores(unittest.TestCase):
    def near(self, expected, found, relative=1e-9):
        self.assertAlmostEqual(expected, found, delta=relative * max(1.0, abs(expected)))

    def score(self, made, **options):
        return score(Run(made), **options)

    def test_metres_and_rates(self):
        found = self.score(columns())["drilling"]
        self.near(100.0, found["duration_s"])
        self.near(90.0, found["on_bottom_s"])
        self.near(0.9, found["drilled_m"])
        self.near(36.0, found["rop_on_bottom_m_h"])
        self.near(32.4, found["rop_m_h"])

    def test_a_reset_drills_nothing(self):
        made = columns()
        for name in ("hole_depth", "bit_depth"):
            made[name] = numpy.where(made["time"] > 55.05, made[name] - 0.3, made[name])
        scores = self.score(made)
        self.near(0.9 - RATE * 0.1, scores["drilling"]["drilled_m"])
        self.assertIn("path: the hole became shallower by a reset, so it is not one hole", scores["left_out"])

    def test_weight_by_time(self):
        made = columns()
        made["wob"] = numpy.where(made["time"] > 55.05, 14e3, made["wob"])  # half of the time on bottom
        found = self.score(made, wob=10e3)["wob"]
        self.near(12e3, found["mean"])
        self.near(2e3, found["deviation"])
        self.assertEqual((10e3, 14e3), (found["least"], found["largest"]))
        self.assertEqual(1e3, found["band"])
        self.near(0.5, found["share_in_band"])
        self.near(1.0, self.score(made, wob=10e3, wob_band=4e3)["wob"]["share_in_band"])
        self.assertNotIn("share_in_band", self.score(made)["wob"])

    def test_rows_at_unequal_times_are_weighed_by_them(self):
        made = {name: values[[0, 10, 100, 101, 1000]] for name, values in columns().items()}
        found = self.score(made)["drilling"]
        self.near(90.0, found["on_bottom_s"])
        made["wob"] = numpy.array([0.0, 0.0, 0.0, 1e3, 2e3])
        self.near((0.1 * 1e3 + 89.9 * 2e3) / 90.0, self.score(made)["wob"]["mean"])

    def test_toolface_on_the_circle(self):
        made = columns()
        made["toolface"] = numpy.radians(numpy.where(made["time"] > 55.05, 170.0, -170.0))
        found = self.score(made, toolface=math.radians(165.0), toolface_band=math.radians(10.0))["toolface"]
        self.near(90.0, found["sliding_s"])
        self.near(180.0, abs(found["mean_deg"]))
        self.near(math.degrees(math.sqrt(-2.0 * math.log(math.cos(math.radians(10.0))))), found["deviation_deg"])
        self.near(0.5, found["share_in_band"])

    def test_turning_is_no_sliding_and_rocking_is(self):
        made = columns()
        made["top_drive_speed"] = 5.0 + 0.0 * made["time"]
        scores = self.score(made)
        self.assertIsNone(scores["toolface"])
        self.assertIn("toolface: the run never slides (on bottom, top drive below 1 rpm)", scores["left_out"])
        made["top_drive_speed"] = 2.0 * numpy.sin(2.0 * math.pi * made["time"] / 5.0)
        self.near(90.0, self.score(made)["toolface"]["sliding_s"])

    def test_stick_slip_of_a_sine(self):
        made = columns()
        made["bit_speed"] = 10.0 + 4.0 * numpy.sin(2.0 * math.pi * made["time"] / 2.0)  # whole periods in a window, peaks on rows
        found = self.score(made)["stick_slip"]
        self.assertEqual(9, found["windows"])
        self.near(0.4, found["mean"])
        made["bit_speed"] = numpy.where(made["time"] > 50.05, 10.0 - 10.0 * numpy.cos(math.pi * made["time"]), 10.0)
        found = self.score(made)["stick_slip"]
        self.near(1.0, found["largest"])
        self.near(5.0 / 9.0, found["share_at_1"])
        self.near(5.0 / 9.0, found["mean"])

    def test_a_bit_that_stands_has_no_stick_slip_index(self):
        made = columns()
        made["bit_speed"] = 0.0 * made["time"]
        scores = self.score(made)
        self.assertIsNone(scores["stick_slip"])
        self.assertTrue(any("turning bit" in reason for reason in scores["left_out"]))
        self.assertTrue(any("0.5 s at most" in reason for reason in self.score(columns(every=1.0))["left_out"]))

    def test_specific_energy_is_teales(self):
        found = self.score(columns(), bit_diameter=0.2)["energy"]
        teale = 10e3 / AREA + 10.0 * 500.0 / (AREA * RATE)  # 2 pi N is the speed in rad/s
        self.assertEqual("bit", found["at"])
        self.near(1e-6 * teale, found["mse_mpa"])
        self.near(10e3 / AREA / teale, found["thrust_share"])
        made = columns()
        del made["bit_torque"], made["bit_speed"]
        made["top_drive_speed"] = 8.0 + 0.0 * made["time"]
        found = self.score(made, bit_diameter=0.2)["energy"]
        self.assertEqual("surface", found["at"])
        self.near(1e-6 * (10e3 / AREA + 8.0 * 600.0 / (AREA * RATE)), found["mse_mpa"])

    def test_connections_stalls_and_limits(self):
        made = columns()
        time = made["time"]
        up = (time > 30.05) & (time < 70.05)  # off bottom
        made["bit_depth"] = numpy.where(up, made["hole_depth"] - 5.0, made["bit_depth"])
        made["in_slips"] = 1.0 * (((time > 35.05) & (time < 45.05)) | ((time > 50.05) & (time < 70.05)))
        made["motor_stalled"] = 1.0 * (((time > 80.05) & (time < 82.05)) | (time > 97.05))
        made["buckled"] = 1.0 * ((time > 20.05) & (time < 25.05))
        scores = self.score(made)
        self.assertEqual(2, scores["connections"]["number"])
        self.near(15.0, scores["connections"]["in_slips_s"])
        self.near(40.1, scores["connections"]["weight_to_weight_s"])  # of rows: the last on bottom to the first
        self.assertEqual(2, scores["stalls"]["number"])
        self.near(5.0, scores["stalls"]["s"])
        self.assertEqual(1, scores["limits"]["buckled"]["number"])
        self.near(5.0, scores["limits"]["buckled"]["s"])
        self.assertEqual({"number": 0, "s": 0.0}, scores["limits"]["slack_line"])

    def test_doglegs_of_an_arc_and_tortuosity_beyond_the_plans(self):
        made = turned(columns(seconds=10000.0, every=1.0), lambda md: math.radians(3.0) * max(0.0, md - 1000.0) / 30.0)  # 90 m
        scores = self.score(made)["path"]
        self.near(3.0, scores["dogleg_mean_deg_30m"])
        self.near(3.0, scores["dogleg_largest_deg_30m"])
        self.assertIsNone(scores["tortuosity_deg_30m"])
        plan = Survey([0.0, 1000.0, 1100.0], numpy.radians([0.0, 0.0, 100.0 * 2.0 / 30.0]), [0.0, 0.0, 0.0])
        self.near(1.0, self.score(made, plan=plan)["path"]["tortuosity_deg_30m"], 1e-6)

    def test_a_hole_of_about_a_metre_has_two_stations_or_no_dogleg(self):
        found = [self.score(turned(columns(seconds=seconds, every=1.0), 0.1))["path"]["dogleg_mean_deg_30m"] for seconds in (110.0, 111.0, 112.0, 113.0, 120.0)]
        self.assertEqual([None, None, None], found[:3])
        self.near(0.0, found[-1], 1e-6)

    def test_distance_from_a_parallel_plan(self):
        made = columns(seconds=1000.0)
        made["bit_east"] = 3.0 + 0.0 * made["time"]
        made["bit_north"] = numpy.where(made["hole_depth"] > 1004.5 + 1e-6, 4.0, 0.0)
        plan = Survey([0.0, 2000.0], [0.0, 0.0], [0.0, 0.0])
        found = self.score(made, plan=plan)["path"]
        self.near(5.0, found["distance_end_m"])
        self.near(5.0, found["distance_largest_m"])
        self.assertTrue(3.9 < found["distance_mean_m"] < 4.1, found)
        beyond = self.score(made, plan=Survey([0.0, 1005.0], [0.0, 0.0], [0.0, 0.0]))
        self.assertIsNone(beyond["path"]["distance_end_m"])
        self.assertTrue(any("not all within the plan's" in reason for reason in beyond["left_out"]))

    def test_a_run_off_bottom_has_no_scores_of_drilling(self):
        made = columns()
        made["bit_depth"] = made["hole_depth"] - 10.0
        scores = self.score(made, bit_diameter=0.2)
        self.assertEqual((None, None, None), (scores["wob"], scores["energy"], scores["drilling"]["rop_on_bottom_m_h"]))
        self.assertIn("wob: the bit was never on bottom", scores["left_out"])

    def test_runs_that_are_none(self):
        for change in ({"time": numpy.zeros(1001)}, {"wob": math.nan * numpy.zeros(1001)}):
            self.assertRaises(RunError, Run, {**columns(), **change})
        made = columns()
        del made["wob"]
        with self.assertRaisesRegex(RunError, "has no wob"):
            Run(made)


class Surveys(unittest.TestCase):
    def test_a_quarter_circle(self):
        radius = 200.0
        quarter = Survey([0.0, 0.5 * math.pi * radius], [0.0, 0.5 * math.pi], [0.0, 0.0])
        numpy.testing.assert_allclose(quarter.positions[-1], (0.0, radius, -radius), atol=1e-9)
        position, tangent = quarter.at(0.25 * math.pi * radius)
        side = math.sqrt(0.5)
        numpy.testing.assert_allclose(position, (0.0, radius * (1.0 - side), -radius * side), atol=1e-9)
        numpy.testing.assert_allclose(tangent, (0.0, side, -side), atol=1e-12)
        numpy.testing.assert_allclose(quarter.distances([(0.0, radius, 0.0), (7.0, 0.0, 0.0)]), (radius, 7.0), atol=1e-3)

    def test_files(self):
        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(folder, "plan.csv")
            for text, complaint in (("md_m,inclination_deg\n0,1\n", ":1: azimuth_deg: "), ("md_m,inclination_deg,azimuth_deg\n0,x,0\n9,0,0\n", ":2: inclination_deg: "),
                                    ("md_m,inclination_deg,azimuth_deg\n5,0,0\n9,0,0\n", ":2: .*north_m"),
                                    ("md_m,inclination_deg,azimuth_deg\n0,0,0\n0,0,0\n", ":3: station 2: md"), ("", "is empty"),
                                    ("md_m,inclination_deg,azimuth_deg\n0,0,0\n9,nan,0\n", ":3: inclination_deg"),
                                    ("md_m,inclination_deg,azimuth_deg\n0,0,0,0,297,0\n9,0,0,0,297,0\n", ":2: has 6 cells"),
                                    ("md_m,inclination_deg,azimuth_deg,azimuth_deg\n0,0,1,2\n9,0,1,2\n", ":1: azimuth_deg: ")):
                with open(file, "w") as out:
                    out.write(text)
                with self.assertRaisesRegex(SurveyError, complaint):
                    read_survey(file)
            with open(file, "w") as out:
                out.write("# a tie-in\nmd_m,inclination_deg,azimuth_deg,north_m,east_m,tvd_m\n500,0,0,1,2,490\n600,0,0,,,\n")
            numpy.testing.assert_allclose(read_survey(file).positions, ((2.0, 1.0, -490.0), (2.0, 1.0, -590.0)))
            self.assertRaises(SurveyError, read_survey, os.path.join(folder, "none.csv"))


class Files(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def file(self, name):
        return os.path.join(self.folder, name)

    def series(self):
        made = columns()
        with open(self.file("run.csv"), "w", newline="") as out:
            writer = csv.writer(out)
            writer.writerow(made)
            writer.writerows(zip(*[[repr(float(v)) for v in values] for values in made.values()]))
        return self.file("run.csv")

    def test_a_time_series_comes_back(self):
        run = read_run(self.series())
        self.assertEqual("truth", run.source)
        for name, values in columns().items():
            numpy.testing.assert_array_equal(values, run[name])

    def test_of_a_series_that_begins_again_the_last_run_is_judged(self):
        run = read_run(self.changed(lambda rows: rows[:1] + rows[201:502] + rows[301:402] + rows[1:]))
        for name, values in columns().items():
            numpy.testing.assert_array_equal(values, run[name])
        self.assertIn("2 earlier runs of the file, to 40 s: time goes back to 0 s there; only the rows after it are scored", score(run)["left_out"])
        self.assertEqual("", read_run(self.series()).earlier)
        self.assertRaisesRegex(RunError, "whose time increases", read_run, self.changed(lambda rows: rows[:300] + rows[295:]))

    def test_of_a_bag_over_a_restart_the_last_run_is_judged(self):
        for topics in (("rig_state", "truth/rig_state", "truth/bit"), ("rig_state", "downhole/mwd", "downhole/toolface")):
            file = self.bag({"/rig/": topics}, runs=(60, 101))
            scores, alone = score(file, bit_diameter=0.2), score(self.bag({"/rig/": topics}), bit_diameter=0.2)
            self.assertEqual("1 earlier run of the file, to 60 s: time goes back to 1 s there; only the rows after it are scored", scores["left_out"].pop(0))
            self.assertEqual(alone, scores)

    def bag(self, topics, zeroed_at=0.0, runs=(101,)):
        """Messages of a node with the made-up run, a second apart. `zeroed_at`: when surface WOB was zeroed [s]. `runs`: numbers of messages of several runs."""
        import rosbag
        import rospy
        from drill_rig_sim.msg import BitTruth, MwdSurvey, MwdToolface, RigState, RigTruth
        made = columns(every=1.0)
        file = self.file("run.bag")
        with rosbag.Bag(file, "w") as bag:
            for i, time in itertools.chain(*(enumerate(made["time"][:count]) for count in runs)):
                row = {name: float(values[i]) for name, values in made.items()}
                tared = bool(time - made["time"][0] >= zeroed_at)
                state, truth = (kind(surface_wob=row["wob"] if tared else 0.0, tared=tared) for kind in (RigState, RigTruth))
                for message, name in itertools.product((state, truth), ("hole_depth", "bit_depth", "torque", "top_drive_speed")):
                    setattr(message, name, row[name])
                bit = BitTruth(wob=row["wob"], torque=row["bit_torque"], speed=row["bit_speed"], toolface=row["toolface"])
                bit.position.z = row["bit_up"]
                survey = MwdSurvey(md=900.0 + time, inclination=math.radians(0.1 * time))
                for name, message in (("rig_state", state), ("truth/rig_state", truth), ("truth/bit", bit), ("downhole/mwd", survey),
                                      ("downhole/toolface", MwdToolface(toolface=row["toolface"]))):
                    message.header.stamp = rospy.Time.from_sec(1.0 + time)
                    for prefix in topics:
                        if name in topics[prefix]:
                            bag.write(prefix + name, message, message.header.stamp)
        return file

    def test_a_bag_is_judged_by_its_truth(self):
        file = self.bag({"/rig/": ("rig_state", "truth/rig_state", "truth/bit")})
        scores = score(file, bit_diameter=0.2)
        self.assertEqual("truth", scores["source"])
        self.assertAlmostEqual(36.0, scores["drilling"]["rop_on_bottom_m_h"], places=6)
        self.assertAlmostEqual(1e-6 * (10e3 / AREA + 10.0 * 500.0 / (AREA * RATE)), scores["energy"]["mse_mpa"], places=6)
        self.assertAlmostEqual(20.0, scores["toolface"]["mean_deg"], places=6)

    def test_a_bag_without_truth_is_judged_by_its_readings(self):
        scores = score(self.bag({"/rig/": ("rig_state", "downhole/mwd", "downhole/toolface")}), bit_diameter=0.2)
        self.assertEqual(("readings", "surface"), (scores["source"], scores["energy"]["at"]))
        self.assertAlmostEqual(10e3, scores["wob"]["mean"], places=6)
        self.assertAlmostEqual(3.0, scores["path"]["dogleg_mean_deg_30m"], places=6)
        self.assertIsNone(scores["stalls"])
        self.assertNotIn("buckled", scores["limits"])

    def test_weight_before_its_zero_is_no_weight(self):
        topics = {"/rig/": ("rig_state",)}
        late = score(self.bag(topics, 60.0), bit_diameter=0.2)
        self.assertAlmostEqual(10e3, late["wob"]["mean"], places=6)
        self.assertAlmostEqual(0.0, late["wob"]["deviation"], places=6)
        self.assertIn("wob: 49.0 s on bottom before surface WOB was zeroed", late["left_out"])
        self.assertIn("energy: surface WOB was not zeroed in all of the drilling", late["left_out"])
        never = score(self.bag(topics, 1e9), bit_diameter=0.2)
        self.assertEqual((None, None), (never["wob"], never["energy"]))
        self.assertIn("wob: surface WOB was never zeroed", never["left_out"])
        with contextlib.redirect_stdout(io.StringIO()):
            self.assertEqual(0, score_command.main([self.file("run.bag"), "--json=" + self.file("s.json"), "--plots=" + self.file("s.png"), "--bit-diameter=0.2"]))

    def changed(self, change):
        """The time series with other rows: change(rows), the first its names."""
        with open(self.series()) as text:
            rows = list(csv.reader(text))
        with open(self.file("changed.csv"), "w", newline="") as out:
            csv.writer(out).writerows(change(rows))
        return self.file("changed.csv")

    def test_empty_cells_of_readings(self):
        for column in ("reading_surface_wob", "reading_rop"):
            run = read_run(self.changed(lambda rows, name=column: [row + [name if i == 0 else "" if i < 5 else "2.5"] for i, row in enumerate(rows)]))
            self.assertEqual((4, 2.5), (int(numpy.isnan(run[column]).sum()), run[column][-1]))
            self.assertEqual(score(read_run(self.series()))["wob"], score(run)["wob"])
        self.assertRaisesRegex(RunError, "changed.csv:2: .*: an empty cell is not a finite number", read_run, self.changed(lambda rows: [rows[0], rows[1][:-1] + [""], *rows[2:]]))

    def test_of_several_rigs_one_is_asked_for(self):
        file = self.bag({"/a/": ("rig_state",), "/b/": ("rig_state", "truth/rig_state")})
        with self.assertRaisesRegex(RunError, "has several rigs, needed: --namespace with one of a, b"):
            read_run(file)
        self.assertEqual(("readings", "truth"), (read_run(file, "a").source, read_run(file, "/b").source))
        with self.assertRaisesRegex(RunError, "of the namespace c"):
            read_run(file, "c")

    def test_the_command_writes_table_json_and_page(self):
        said = io.StringIO()
        with contextlib.redirect_stdout(said):
            status = score_command.main([self.series(), "--bit-diameter=0.2", "--wob=10e3", "--toolface=25", "--json=" + self.file("s.json"),
                                         "--plots=" + self.file("s.png")])
        self.assertEqual(0, status)
        self.assertRegex(said.getvalue(), r"rate of penetration on bottom +36.00 m/h\n")
        with open(self.file("s.json")) as text:
            found = json.load(text)
        self.assertEqual(score(self.file("run.csv"), bit_diameter=0.2, wob=10e3, toolface=math.radians(25.0)), found)
        self.assertEqual(1.0, found["toolface"]["share_in_band"])
        with open(self.file("s.png"), "rb") as picture:
            self.assertEqual(b"\x89PNG", picture.read(4))

    def test_bad_inputs_are_told_in_one_line(self):
        with open(self.file("words.csv"), "w") as out:
            out.write("time,wob\n0,much\n")
        series = self.series()
        for words in ([self.file("none.csv")], [self.file("words.csv")], [series, "--plan=" + series], [series, "--json=" + series],
                      [series, "--plots=" + self.file("page.what")], [series, "--json=" + self.file("no/where.json")], [self.file("none.bag")]):
            said = io.StringIO()
            with contextlib.redirect_stderr(said), contextlib.redirect_stdout(io.StringIO()):
                self.assertEqual(2, score_command.main(words), words)
            self.assertRegex(said.getvalue(), r"^drill score: .+\n$", words)
        self.assertEqual("truth", read_run(series).source)  # still what it was

    def test_the_runner_starts_it(self):
        if drill_program is None:
            self.skipTest("no runner given")
        done = subprocess.run([drill_program, "score", self.series(), "--toolface", "-5", "--wob=10e3", "--json", self.file("s.json")],
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE, universal_newlines=True, env={"PATH": "/usr/bin:/bin"}, check=False)
        self.assertEqual((0, ""), (done.returncode, done.stderr))
        self.assertIn("drilled", done.stdout)
        with open(self.file("s.json")) as text:
            self.assertAlmostEqual(-5.0, json.load(text)["toolface"]["set_point_deg"])
        for words, complaint in ((["none.csv"], "none.csv: cannot be read .No such file"), ([self.series(), "--wob-band", "3"], "--wob-band: needs --wob")):
            done = subprocess.run([drill_program, "score", *words], stdout=subprocess.PIPE, stderr=subprocess.PIPE, universal_newlines=True, check=False)
            self.assertEqual((2, ""), (done.returncode, done.stdout))
            self.assertRegex(done.stderr, r"^drill score: .*%s.*\n$" % complaint)

    def test_a_runner_on_its_own_says_what_is_missing(self):
        if drill_program is None:
            self.skipTest("no runner given")
        with open(drill_program, "rb") as program, open(self.file("drill"), "wb") as alone:
            alone.write(program.read())
        os.chmod(self.file("drill"), 0o755)
        done = subprocess.run([self.file("drill"), "score", self.series()], stdout=subprocess.PIPE, stderr=subprocess.PIPE, universal_newlines=True, check=False)
        self.assertEqual(2, done.returncode)
        self.assertRegex(done.stderr, r"^drill score: .*score_command.py is missing; .*\n$")


if __name__ == "__main__":
    drill_program = os.path.abspath(sys.argv.pop(1)) if len(sys.argv) > 1 and os.path.isfile(sys.argv[1]) else None
    unittest.main()
