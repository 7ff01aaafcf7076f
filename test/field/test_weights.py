#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""drill weights: which moves of a time log are steady, and that what drill calibrate finds of them is what the simulator made the log with."""
import importlib.util
import json
import os
import sys
import tempfile
import unittest
import unittest.mock

if not importlib.util.find_spec("scipy"):
    print("skipped: SciPy is not installed (python3-scipy: ./test/run --campaigns)")
    sys.exit(77)
import made_weights
import numpy
import yaml
from called import called
from drill_rig_sim import calibrate_command, weights_command


class Simulated(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = folder.name
        cls.scene = made_weights.write_scene(cls.folder)
        cls.record = made_weights.write_record(cls.folder, cls.scene)
        cls.table = os.path.join(cls.folder, "weights.csv")
        cls.moves_file = os.path.join(cls.folder, "moves.json")
        cls.status, cls.out, cls.told = called(weights_command.main, cls.record, "--csv", cls.table, "--json", cls.moves_file)

    def test_the_moves_are_found(self):
        self.assertEqual((0, ""), (self.status, self.told), self.out)
        with open(self.moves_file, encoding="utf-8") as text:
            moves = json.load(text)
        found = [move["motion"] for move in moves]
        for motion, least in (("pick_up", 1), ("slack_off", 2), ("rotating_after_down", 1), ("slips_up", 1)):
            self.assertGreaterEqual(found.count(motion), least, self.out)
        self.assertNotIn("rotating_after_up", found)
        for move in moves:
            self.assertLess(move["deviation"], 12e3, move)  # 2 kN of noise, and what rings
            self.assertGreaterEqual(move["count"], 4)
        weights = {motion: numpy.mean([move["load"] for move in moves if move["motion"] == motion]) for motion in found}
        self.assertLess(weights["slack_off"], weights["pick_up"])
        self.assertLess(weights["slack_off"], weights["rotating_after_down"])  # both with the dead line's friction of the way down

    def test_friction_and_block_come_back(self):
        fit = {"scene": "scene.yaml", "table": {"file": "weights.csv"}, "held_out": 0.0, "parameters": [
            {"name": "friction", "key": "well.sections[0].friction", "start": 0.35, "from": 0.0, "to": 0.8},
            {"name": "block", "key": "rig.hoisting.block_mass", "start": 15000.0, "from": 5000.0, "to": 40000.0}]}
        file, answer = os.path.join(self.folder, "fit.yaml"), os.path.join(self.folder, "fit.json")
        with open(file, "w", encoding="utf-8") as out:
            yaml.safe_dump(fit, out)
        status, out, told = called(calibrate_command.main, file, "--json", answer)
        self.assertEqual(0, status, told)
        with open(answer, encoding="utf-8") as text:
            (friction, sure), (block, _) = ((entry["value"], entry["half_width_95"]) for entry in json.load(text)["parameters"])
        self.assertAlmostEqual(made_weights.FRICTION, friction, delta=0.02, msg=out)
        self.assertTrue(1e-3 < sure < 0.05, out)
        self.assertAlmostEqual(1.0, block / made_weights.BLOCK, delta=0.01, msg=out)
        self.applied(answer)

    def applied(self, result):
        """What was found predicts the table, of which no motion is off by more than its band on the whole."""
        data, answer = os.path.join(self.folder, "data.yaml"), os.path.join(self.folder, "applied.json")
        with open(data, "w", encoding="utf-8") as out:
            yaml.safe_dump({"scene": "scene.yaml", "table": {"file": "weights.csv"}}, out)
        status, out, told = called(calibrate_command.main, data, "--apply", result, "--json", answer, "--plots", os.path.join(self.folder, "applied.svg"))
        self.assertEqual(0, status, told)
        self.assertIn("depth [m]", out)
        with open(answer, encoding="utf-8") as text:
            found = json.load(text)
        self.assertEqual({"pick_up", "slack_off", "rotating_after_down", "slips_up"}, set(found["summary"]))
        rows = sum(said["rows"] for said in found["summary"].values())
        self.assertGreaterEqual(sum(said["within"] * said["rows"] for said in found["summary"].values()) / rows, 0.8, out)


class Turned(unittest.TestCase):
    def test_friction_comes_back_of_a_string_that_turns_as_it_moves(self):
        """At two ratios of speed and rotation."""
        motions = [{"do": "rotate", "speed_rpm": 60.0, "ramp": 5.0, "time": 20.0}, {"do": "pick_up", "distance": 14.0, "speed": 0.2}, {"do": "wait", "time": 5.0},
                   {"do": "slack_off", "distance": 14.0, "speed": 0.2}, {"do": "rotate", "speed_rpm": 30.0, "ramp": 5.0, "time": 20.0},
                   {"do": "pick_up", "distance": 14.0, "speed": 0.4}, {"do": "slack_off", "distance": 14.0, "speed": 0.4}]
        with tempfile.TemporaryDirectory() as folder, unittest.mock.patch.dict(made_weights.SCENE, operations=motions):
            record, table, answer = made_weights.write_record(folder, made_weights.write_scene(folder)), os.path.join(folder, "w.csv"), os.path.join(folder, "fit.json")
            status, out, told = called(weights_command.main, record, "--csv", table)
            self.assertEqual(0, status, told)
            self.assertEqual((2, 2), (out.count("rotating_up "), out.count("rotating_down ")), out)
            fit = {"scene": "scene.yaml", "table": {"file": "w.csv"}, "held_out": 0.0,
                   "parameters": [{"name": "friction", "key": "well.sections[0].friction", "start": 0.35, "from": 0.0, "to": 0.8}]}
            with open(os.path.join(folder, "fit.yaml"), "w", encoding="utf-8") as text:
                yaml.safe_dump(fit, text)
            status, out, told = called(calibrate_command.main, os.path.join(folder, "fit.yaml"), "--json", answer)
            self.assertEqual(0, status, told)
            with open(answer, encoding="utf-8") as text:
                self.assertAlmostEqual(made_weights.FRICTION, json.load(text)["parameters"][0]["value"], delta=0.02, msg=out)


class Made(unittest.TestCase):
    """Rows that are written by hand: 0.2 m/s, a row a second."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def written(self, parts, hole=1100.0, held=(), signs=(1.0, 1.0), depth=1000.0, names="time,reading_block_height,top_drive_speed,reading_flow,reading_hook_load,reading_bit_depth,reading_hole_depth"):
        """A record of parts (seconds, block's speed, rotation, flow, hook load) and a file for the moves. The bit is at `depth` [m] and moves with the block, but in the parts
        that are `held`. `signs`: of the block's height and the bit's depth as they are written."""
        rows, height, time = [], 5.0, 0.0
        for number, (seconds, speed, turning, flow, load) in enumerate(parts):
            for _ in range(seconds):
                rows.append([time, signs[0] * height, turning, flow, load, signs[1] * depth, hole])
                time, height, depth = time + 1.0, height + speed, depth - (0.0 if number in held else speed)
        file, table = os.path.join(self.folder, "r.csv"), os.path.join(self.folder, "t.json")
        with open(file, "w", encoding="utf-8") as out:
            out.write("\n".join([names, *(",".join("%.9g" % cell for cell in row[:len(names.split(","))]) for row in rows)]) + "\n")
        return file, table

    def found(self, parts, *words, **more):
        """(motions and loads, what was reported)."""
        file, table = self.written(parts, **more)
        status, _, told = called(weights_command.main, file, "--json", table, *words)
        if status:
            return status, told
        with open(table, encoding="utf-8") as text:
            return [(move["motion"], round(move["load"])) for move in json.load(text)], told

    UP, DOWN, STOP, TURN = (60, 0.2, 0.0, 0.0, 9e5), (60, -0.2, 0.0, 0.0, 7e5), (20, 0.0, 0.0, 0.0, 8e5), (60, 0.0, 6.0, 0.0, 8e5)

    def test_each_motion(self):
        self.assertEqual(([("pick_up", 900000), ("rotating_after_up", 800000), ("slack_off", 700000), ("rotating_after_down", 800000)]),
                         self.found([self.STOP, self.UP, self.STOP, self.TURN, self.STOP, self.DOWN, self.STOP, self.TURN])[0])

    def test_a_string_that_turns_as_it_moves(self):
        up, down = (60, 0.2, 6.0, 0.0, 83e4), (60, -0.2, 6.0, 0.0, 78e4)
        moves, told = self.found([self.STOP, self.UP, self.STOP, up, self.TURN, down, self.TURN])
        self.assertEqual([("pick_up", 900000), ("rotating_up", 830000), ("rotating_after_up", 800000), ("rotating_down", 780000), ("rotating_after_down", 800000)], moves)
        self.assertNotIn("no steady", told)
        faster = [(8, 0.1 + 0.237 * (k % 2), 6.0, 0.0, 9e5) for k in range(10)]  # a speed of the block that changes all the time
        slower = [(4, 0.2, 6.0 + 3.0 * (k % 2), 0.0, 9e5) for k in range(20)]    # the same of the rotation
        for parts in (faster, slower, [(12, 0.2, 6.0, 0.0, 9e5)]):               # too short
            self.assertEqual(2, self.found([self.STOP, *parts, self.STOP])[0], parts)

    def test_a_record_without_rotation(self):
        _, told = self.found([self.STOP, self.UP, self.STOP], names="time,reading_block_height,unknown,reading_flow,reading_hook_load,reading_bit_depth,reading_hole_depth")
        self.assertIn("has no top_drive_speed: the string counts as not turned, and moves with rotation are among pick_up and slack_off", told)

    def test_what_is_no_steady_move(self):
        for parts in ([self.STOP], [self.STOP, (12, 0.2, 0.0, 0.0, 9e5), self.STOP],  # too short
                      [self.STOP, (60, -0.005, 6.0, 0.02, 8e5), self.STOP]):           # drills, see below
            status, told = self.found(parts, hole=1000.0 if parts[1:2] and parts[1][1] == -0.005 else 1100.0)
            self.assertEqual((2, 1), (status, told.count("\n")), told)
            self.assertIn("holds no steady pick-up", told)
        steps = [(8, 0.1 + 0.237 * (k % 2), 0.0, 0.0, 9e5) for k in range(10)]  # a speed that changes all the time
        self.assertEqual(2, self.found(steps)[0])

    def test_times_of_a_display(self):
        """A row each 5 s, with values that a display took up to 0.8 s before its time and 0.3 s after it: the speed of an even block seems to change by a third. A block that
        stops nearly every 10 s is not even."""
        def displayed(seed, shift=0.0):
            chance = numpy.random.default_rng(seed)

            def change(rows):
                cells = numpy.array(rows, float)
                taken = numpy.arange(5.0, len(cells) - 5.0, 5.0) + shift
                taken += chance.uniform(-0.8, 0.3, len(taken))
                values = numpy.array([numpy.interp(taken, cells[:, 0], column) for column in cells.T]).T
                return [["%g" % (5 * k), *("%.9g" % cell for cell in row[1:])] for k, row in enumerate(values)]
            return change
        parts = [self.STOP, self.UP, self.STOP, self.TURN, self.STOP, self.DOWN, self.STOP, self.TURN]
        wanted = [("pick_up", 900000), ("rotating_after_up", 800000), ("slack_off", 700000), ("rotating_after_down", 800000)]
        for seed in range(8):
            moves, told = self.changed(parts, displayed(seed, 0.4 * seed))
            self.assertEqual((wanted, False), (moves, "no steady" in told), told)
            steps = [(10, speed, 0.0, 0.0, 9e5) for _ in range(6) for speed in (0.05, 0.35)]
            status, told = self.changed([self.STOP, *steps, self.STOP], displayed(seed))
            self.assertEqual((2, 2), (status, told.count("\n")), told)
            self.assertIn("hook_load: it is the same to the last digit in", told)
            self.assertIn("no steady pick_up was found in 1 moves, the longest of 1", told)
            self.assertIn("needed after the start of a move: an even speed for 5 s and 4 rows with a hook load", told)

    def test_an_uneven_load_is_reported(self):
        def ringing(rows):
            return [[*row[:4], "%g" % (float(row[4]) + (2e4 if float(row[4]) == 7e5 else 1e3) * (-1)**k), *row[5:]] for k, row in enumerate(rows)]
        parts = [self.STOP, self.UP, self.STOP, self.TURN, self.STOP, self.DOWN, self.STOP, self.TURN]
        said = "the load of 1 moves varies more than 3 times as much as usual (first: slack_off at "
        self.assertIn(said, self.changed(parts, ringing)[1])
        self.assertNotIn("varies more", self.found(parts)[1])

    def changed(self, parts, change, **more):
        """(motions and loads, what was reported) of rows written by hand that `change` makes of them (a list of lists of cells)."""
        file, table = self.written(parts, **more)
        with open(file, encoding="utf-8") as text:
            header, *rows = text.read().splitlines()
        with open(file, "w", encoding="utf-8") as out:
            out.write("\n".join([header, *map(",".join, change([row.split(",") for row in rows]))]) + "\n")
        status, _, told = called(weights_command.main, file, "--json", table)
        if status:
            return status, told
        with open(table, encoding="utf-8") as text:
            return [(move["motion"], round(move["load"])) for move in json.load(text)], told

    def test_a_hook_load_that_is_recorded_less_often_than_the_block(self):
        def emptied(every, column):
            return lambda rows: [[*row[:column], "" if bool(k % every) == (every != 30) else row[column], *row[column + 1:]] for k, row in enumerate(rows)]
        parts = [self.STOP, self.UP, self.STOP, self.DOWN, self.STOP, self.TURN]
        for every in (3, 9, 30):  # measured in every third, every ninth row; missing in every thirtieth
            moves, told = self.changed(parts, emptied(every, 4))
            self.assertEqual([("pick_up", 900000), ("slack_off", 700000), ("rotating_after_down", 800000)], moves, told)
            self.assertIn("rows hold no measurement", told)
        status, told = self.changed(parts, emptied(60, 4))
        self.assertEqual((2, 2), (status, told.count("\n")), told)
        self.assertIn("drill weights: %s: hook_load: 236 of 240 rows hold no measurement\n" % os.path.join(self.folder, "r.csv"), told)  # a remark, before the refusal
        self.assertIn("236 of 240 rows hold no hook_load", told)

    def test_signals_in_rows_of_their_own(self):
        def apart(rows):
            return [[cell if place == 0 or place % 3 == k % 3 else "" for place, cell in enumerate(row)] for k, row in enumerate(rows)]
        moves, told = self.changed([self.STOP, self.UP, self.STOP, self.DOWN, self.STOP, self.TURN], apart)
        self.assertEqual([("pick_up", 900000), ("slack_off", 700000), ("rotating_after_down", 800000)], moves, told)

    def test_the_last_way_of_the_block_in_a_gap(self):
        """After a pick-up the block comes down in a gap; it comes back so far that the way is not clear."""
        parts = [self.STOP, self.UP, self.STOP, self.DOWN, self.TURN]
        moves, told = self.changed(parts, lambda rows: rows[:100] + rows[160:])
        self.assertEqual(["pick_up", "rotating_after_down"], [move[0] for move in moves], told)
        moves, told = self.changed(parts, lambda rows: rows[:100] + [[row[0], "%.9g" % (float(rows[99][1]) - 0.3), *row[2:5], "%.9g" % (float(rows[99][5]) + 0.3), row[6]]
                                                                     for row in rows[160:]])
        self.assertEqual(["pick_up"], [move[0] for move in moves], told)
        self.assertIn("1 moves are left out: in a gap before them the block moved by an unknown distance", told)

    def test_pipe_that_is_taken_away_in_a_gap(self):
        """In 200 s without rows the bit comes up by 6 m, and a stand is taken away."""
        def cut(rows):
            return rows[:100] + [["%g" % (float(row[0]) + 200.0), "%.9g" % (float(row[1]) - 14.0), *row[2:5], "%.9g" % (float(row[5]) - 6.0), row[6]] for row in rows[100:]]
        moves, told = self.changed([self.STOP, self.UP, self.STOP, self.STOP, self.UP, self.STOP, self.TURN], cut)
        self.assertEqual(["pick_up", "pick_up", "rotating_after_up"], [move[0] for move in moves], told)
        self.assertIn("a gap of 201 s", told)
        moves, told = self.changed([self.STOP, self.UP, self.STOP, self.STOP, self.UP, self.STOP, self.TURN], lambda rows: [[*row[:5], "%.9g" % (float(row[5]) - 6.0 * (k >= 100)), row[6]]
                                                                                                                     for k, row in enumerate(rows)])
        self.assertEqual(["pick_up", "pick_up", "rotating_after_up"], [move[0] for move in moves], told)  # a slip of the depth tracking

    def test_the_last_row_of_a_move_is_at_rest(self):
        """A row may hold where the block stops and the load that it then has."""
        moves, told = self.found([self.STOP, self.UP, (20, 0.0, 0.0, 0.0, 8e5), self.DOWN, self.STOP])
        self.assertEqual([("pick_up", 900000), ("slack_off", 700000)], moves, told)

    def test_a_wrong_unit_of_the_block(self):
        for factor in (3.28084, 0.3048):
            status, told = self.changed([self.STOP, self.UP, self.STOP, self.DOWN], lambda rows, factor=factor: [[row[0], "%.9g" % (factor * float(row[1])), *row[2:]] for row in rows])
            self.assertEqual((2, 1), (status, told.count("\n")), told)
            self.assertIn("block_height changes by %.3g m for each metre of bit_depth" % factor, told)

    def test_flow_and_parts(self):
        parts = [self.STOP, self.UP, self.STOP, (60, -0.2, 0.0, 0.02, 7e5), self.STOP]
        moves, told = self.found(parts)
        self.assertEqual(2, len(moves))
        self.assertIn("the pump ran in 1 of 2 moves", told)
        self.assertEqual(["pick_up"], [move[0] for move in self.found(parts, "--no-flow")[0]])
        self.assertEqual(["slack_off"], [move[0] for move in self.found(parts, "--from", "85")[0]])
        self.assertEqual(["slack_off"], [move[0] for move in self.found(parts, "--leave-out", "0:80")[0]])

    def test_the_empty_block(self):
        """At a speed that is not even; in a record that holds the depth and in one that does not; of a bit's depth that stands while the string moves."""
        alone = [(8, speed, 0.0, 0.0, 2e5) for speed in (0.6, 1.0, 0.7)]
        parts = [self.STOP, self.UP, self.STOP, self.DOWN, (20, 0.0, 0.0, 0.0, 7e5), *alone, self.STOP]
        moves, told = self.found(parts, held=(5, 6, 7))
        self.assertEqual(("slips_up", 200000), moves[-1])
        self.assertEqual("", told)
        moves, told = self.found([*parts, self.UP], held=())
        self.assertEqual(["pick_up", "slack_off", "pick_up"], [move[0] for move in moves])
        self.assertIn("the block never moves with the string in the slips", told)
        moves, told = self.found([self.STOP, self.UP, self.STOP, (30, -0.2, 0.0, 0.0, 9e5), self.STOP], held=(3,))
        self.assertEqual([("pick_up", 900000)], moves)
        self.assertIn("1 moves are left out, with the load of the string: the block moves, but the bit's depth does not change (first: at 1", told)
        moves, told = self.found([self.STOP, self.UP, self.STOP, self.DOWN, self.STOP, self.UP, self.STOP, (60, -0.2, 0.0, 0.0, 2e5)])
        self.assertEqual(["pick_up", "slack_off", "pick_up"], [move[0] for move in moves])
        self.assertIn("1 moves are left out, with less than half of the usual load", told)

    def test_a_spike_of_the_hole_s_depth(self):
        drilled = [self.STOP, self.TURN, self.STOP]
        file, table = self.written(drilled, hole=1000.0)
        with open(file, encoding="utf-8") as text:
            lines = text.read().splitlines()
        lines[3] = lines[3].replace(",1000,1000", ",1000,9000")
        with open(file, "w", encoding="utf-8") as out:
            out.write("\n".join(lines) + "\n")
        self.assertEqual(2, called(weights_command.main, file, "--json", table)[0])

    def test_a_wrong_sign_is_refused(self):
        parts = [self.STOP, self.UP, self.STOP, self.DOWN]
        for signs, depth, said in (((-1.0, 1.0), 1000.0, "bit_depth rises and falls with block_height, by 2"), ((1.0, -1.0), 60.0, "bit_depth is negative, -5"),
                                   ((-1.0, -1.0), 60.0, "bit_depth is negative, -5"), ((1.0, -1.0), 1000.0, "values are out of the range of bit_depth on a rig")):
            status, told = self.found(parts, signs=signs, depth=depth)
            self.assertEqual((2, 1), (status, told.count("\n")), told)
            self.assertIn(said, told)

    def test_what_a_record_must_hold(self):
        names = "time,reading_block_height,top_drive_speed,reading_flow,reading_hook_load"
        status, told = self.found([self.STOP, self.UP], names=names)
        self.assertEqual(2, status)
        self.assertIn("r.csv: has no bit_depth; needed: block_height, bit_depth and hook_load", told)
        moves, told = self.found([self.STOP, self.UP, self.STOP, self.DOWN], names=names + ",reading_bit_depth")
        self.assertEqual([("pick_up", 900000), ("slack_off", 700000)], moves)
        self.assertIn("has no hole_depth", told)
        for header, said in (("HKLD (ton)", "HKLD (ton): unit ton is ambiguous; allowed: tonfUS"), ("HKLD (furlong)", "unit furlong is not known for a force"),
                             ("HKLD", "HKLD is left out: it has no unit")):
            status, told = self.found([self.STOP, self.UP], names="time (s),BPOS (m),RPM (rpm),FLOWIN (m3/s),%s,DBTM (m)" % header)
            self.assertEqual((2, 1), (status, told.count("\n")), told)
            self.assertIn(said, told)


if __name__ == "__main__":
    unittest.main()
