#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""drill calibrate --apply: what a fit found predicts the record of another well within its band; parts of a record; what is refused."""
import importlib.util
import json
import os
import sys
import tempfile
import unittest

if not importlib.util.find_spec("scipy"):
    print("skipped: SciPy is not installed (python3-scipy: ./test/run --campaigns)")
    sys.exit(77)
import made_record
import numpy
import yaml
from called import called
from drill_rig_sim import calibrate_command


def calibrate(*words):
    """Without its progress."""
    status, out, told = called(calibrate_command.main, *words)
    return status, out, "".join(line for line in told.splitlines(True) if "points tried" not in line)


class Applied(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        """A fit of one well, and the record of a deeper one that is drilled faster."""
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = folder.name
        made_record.write_record(cls.folder, made_record.rows_of(made_record.write_scene(cls.folder)), 11)
        cls.result = cls.path("fit.json")
        status, _, told = calibrate(made_record.write_fit(cls.folder), "--json", cls.result)
        assert (status, told) == (0, ""), told
        rows = made_record.rows_of(made_record.write_scene(cls.folder, "other.yaml", 160.0), 60.0, 0.012, 70.0)
        made_record.write_record(cls.folder, rows, 12, "other.csv")

    @classmethod
    def path(cls, name):
        return os.path.join(cls.folder, name)

    def data(self, **more):
        """Path of a file that names the other well's scene and record."""
        with open(self.path("data.yaml"), "w", encoding="utf-8") as out:
            yaml.safe_dump({"scene": "other.yaml", "record": "other.csv", "leave_out": ["0:6"], **more}, out)
        return self.path("data.yaml")

    def test_another_well_is_predicted_within_the_band(self):
        answer, picture = self.path("applied.json"), self.path("applied.png")
        status, out, told = calibrate(self.data(), "--apply", self.result, "--json", answer, "--plots", picture)
        self.assertEqual((0, ""), (status, told))
        self.assertIn("of 270 rows within the band", out)
        self.assertIn("30 rows are shown", out)
        self.assertNotRegex(out, r"\de[-+]\d|-0\.?0* ")  # a torque of 1e-32 kN m is 0.000
        with open(answer, encoding="utf-8") as text:
            found = json.load(text)
        self.assertEqual({"hook_load", "torque", "stand_pipe_pressure"}, set(found["summary"]))
        for signal, noise in zip(("hook_load", "torque", "stand_pipe_pressure"), made_record.NOISE):
            said, rows = found["summary"][signal], found["rows"][signal]
            self.assertGreaterEqual(said["within"], 0.9, (signal, said))
            self.assertTrue(1.7 < numpy.median(rows["band_95"]) / noise < 3.0, signal)
            self.assertTrue((numpy.array(rows["confidence_95"]) < rows["band_95"]).all())
            self.assertGreaterEqual(min(rows["time"]), 6.0)
        self.assertGreater(os.path.getsize(picture), 10000)

    def test_a_signal_that_is_wholly_held_out_has_an_unknown_band(self):
        rows = made_record.rows_of(self.path("scene.yaml"), 40.0)
        rows[:-30, made_record.NAMES.index("reading_torque")] = numpy.nan
        made_record.write_record(self.folder, rows, 13, "late.csv")
        picture, answer = self.path("late.svg"), self.path("late.json")
        fit = made_record.write_fit(self.folder, "late.yaml", record="late.csv", parameters=[made_record.FIT["parameters"][0]])
        status, out, told = calibrate(fit, "--plots", picture, "--json", answer)
        self.assertEqual(0, status, told)
        self.assertRegex(out, r"torque \[kN m\] +- +[\d.]+ +[\d.]+\n")
        self.assertGreater(os.path.getsize(picture), 10000)
        status, out, told = calibrate(fit, "--apply", answer, "--json", self.path("late_applied.json"))
        self.assertEqual(0, status, told)
        self.assertIn("torque [kN m]: the band of 30 rows is unknown; off by", out)
        self.assertIn("the band is unknown where it depends on values that the fit's data do not determine: the scatter of torque", told)
        with open(self.path("late_applied.json"), encoding="utf-8") as text:
            said = json.load(text)["summary"]
        self.assertEqual([None, True], [said["torque"]["within"], said["hook_load"]["within"] > 0.8])

    def test_a_wrong_parameter_leaves_the_band(self):
        with open(self.result, encoding="utf-8") as text:
            tree = json.load(text)
        tree["parameters"][0]["value"] += 3000.0  # the tare
        with open(self.path("wrong.json"), "w", encoding="utf-8") as out:
            json.dump(tree, out)
        answer = self.path("off.json")
        self.assertEqual(0, calibrate(self.data(signals=["hook_load"]), "--apply", self.path("wrong.json"), "--json", answer)[0])
        with open(answer, encoding="utf-8") as text:
            said = json.load(text)["summary"]
        self.assertEqual({"hook_load"}, set(said))
        self.assertLess(said["hook_load"]["within"], 0.1)
        self.assertAlmostEqual(-3000.0, said["hook_load"]["mean"], delta=150.0)

    def test_what_the_fit_was_not_told_makes_the_band_unknown(self):
        with open(self.result, encoding="utf-8") as text:
            tree = json.load(text)
        tree["covariance"][3] = [0.0, 0.0, 0.0, None]
        for row in tree["covariance"][:3]:
            row[3] = 0.0
        with open(self.path("untold.json"), "w", encoding="utf-8") as out:
            json.dump(tree, out)
        status, out, told = calibrate(self.data(signals=["stand_pipe_pressure"], to=30.0), "--apply", self.path("untold.json"))
        self.assertEqual(0, status)
        self.assertIn("unknown", out)
        self.assertEqual("drill calibrate: the band is unknown where it depends on values that the fit's data do not determine: pressure\n", told)

    def test_a_signal_that_the_fit_did_not_have_is_refused(self):
        with open(self.result, encoding="utf-8") as text:
            tree = json.load(text)
        del tree["rms"]["torque"]
        with open(self.path("fewer.json"), "w", encoding="utf-8") as out:
            json.dump(tree, out)
        status, _, told = calibrate(self.data(signals=["hook_load", "torque"], to=30.0), "--apply", self.path("fewer.json"))
        self.assertEqual((2, 1), (status, told.count("\n")), told)
        self.assertIn("fewer.json: torque: the fit had no such data, allowed: ", told)

    def test_what_is_refused(self):
        for name, text in (("text.json", "{"), ("list.json", "[1]"), ("old.json", '{"parameters": [{"name": "a", "value": 1}], "covariance": [[1]], "rms": {}}')):
            with open(self.path(name), "w", encoding="utf-8") as out:
                out.write(text)
        for more, result, said in (({}, "no.json", "No such file"), ({}, "text.json", "text.json: is not valid JSON"), ({}, "list.json", "list.json: is not what"), ({}, "old.json", "KeyError: 'keys'"),
                                   ({"scene": "bare.yaml"}, "fit.json", "bare.yaml: parameters of the fit: formation[0].drillability"),
                                   ({"to": 1.0, "from": 2.0}, "fit.json", "has 0 rows"), ({"leave_out": "0:1000"}, "fit.json", "leave no number to compare"),
                                   ({"from": "noon"}, "fit.json", "data.yaml:1: from: 'noon' is neither"), ({"leave_out": ["9:3"]}, "fit.json", "A before B"),
                                   ({"start": "there"}, "fit.json", "allowed: scene, record")):
            with open(self.path("other.yaml"), encoding="utf-8") as text:
                scene = yaml.safe_load(text)
            with open(self.path("bare.yaml"), "w", encoding="utf-8") as out:
                yaml.safe_dump({key: value for key, value in scene.items() if key != "formation"}, out)
            status, _, told = calibrate(self.data(**more), "--apply", self.path(result))
            self.assertEqual((2, 1), (status, told.count("\n")), told)
            self.assertIn(said, told)

    def test_a_fit_takes_a_part_from_where_the_record_is(self):
        fit = made_record.write_fit(self.folder, "part.yaml", **{"from": 40.0, "to": 80.0, "leave_out": ["0:50"], "start": "record", "held_out": 0.0,
                                                                 "parameters": [made_record.FIT["parameters"][0], made_record.FIT["parameters"][3]]})
        answer = self.path("part.json")
        status, _, told = calibrate(fit, "--json", answer)
        self.assertEqual(0, status, told)
        self.assertIn("the scene is started where the record begins", told)
        with open(answer, encoding="utf-8") as text:
            found = json.load(text)
        rows = found["residuals"]["hook_load"]
        self.assertEqual((40.0, 80.0), (rows["time"][0], rows["time"][-1]))
        measured = [time for time, value in zip(rows["time"], rows["residual"]) if value is not None]
        self.assertAlmostEqual(50.2, measured[0])
        self.assertAlmostEqual(1.0, found["parameters"][1]["value"] / made_record.PRESSURE, delta=0.01)


if __name__ == "__main__":
    unittest.main()
