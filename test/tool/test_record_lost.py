#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Records with values that no gauge measured: zeros of a gauge that was lost, one value over minutes, a single value far above all others. Ordinary ones are not reported."""
import io
import unittest
from contextlib import redirect_stderr, redirect_stdout

import numpy
from drill_rig_sim import weights_command
from record_folder import Folder

NAMES = "Time (s),Block (m),Bit Depth (m),Hole Depth (m),Hook Load (kN),Torque (kN.m),SPP (bar),RPM (rpm),Flow In (L/min)"
BLOCK, BIT, LOAD, TORQUE, PRESSURE = 1, 2, 4, 5, 6
SPAN = 30  # rows of a move


def trip(stands=4, seed=1, digits=1):
    """Rows every 5 s of pipe that is lifted and lowered at 0.2 m/s and turned while it comes up, with a connection after each stand."""
    chance, rows, bit, time = numpy.random.default_rng(seed), [], 2000.0, 0.0
    for _ in range(stands):
        for direction, hung in ((1, True), (0, True), (-1, False), (0, False)):  # a stand up; slips; the empty block down
            for k in range(SPAN):
                block = 1.0 + (k if direction > 0 else SPAN - 1 - k if direction < 0 else SPAN - 1 if hung else 0)
                bit -= 1.0 if direction > 0 and k else 0.0
                load = (900.0 if direction > 0 else 850.0) if hung else 250.0
                turned = 60.0 if direction > 0 else 0.0
                rows.append([time, block, bit, 2500.0, round(load + chance.normal(0.0, 3.0), digits), round(9.0 + chance.normal(0.0, 0.3), 2) if turned else 0.0,
                             round(150.0 + chance.normal(0.0, 1.0)) if turned else 0.0, turned, 1800.0 if turned else 0.0])
                time += 5.0
    return numpy.array(rows)


def text_of(rows, names=NAMES):
    return names + "\n" + "".join(",".join("" if numpy.isnan(cell) else "%.9g" % cell for cell in row) + "\n" for row in rows)


class Lost(Folder):
    def told(self, rows):
        """(record, lines) of rows."""
        record = self.read(text_of(rows))
        return record, [line.partition(": ")[2] for line in record.remarks]

    def test_ordinary_ones(self):
        for digits in (2, 1, 0, -1):
            self.assertEqual([], self.told(trip(digits=digits))[1], digits)
        tared = trip()
        tared[tared[:, LOAD] < 500.0, LOAD] = 0.0  # the gauge is zeroed with the empty block
        self.assertEqual([], self.told(tared)[1])

    def test_a_hook_load_of_zero_under_a_moving_string(self):
        rows = trip()
        rows[3:25, LOAD] = 0.0
        record, lines = self.told(rows)
        self.assertIn("hook_load: 22 rows of exactly 0, while the block moves the string, are no measurements (first: ", lines[0])
        self.assertIn("r.csv:5)", lines[0])
        self.assertTrue(numpy.isnan(record.signals["hook_load"][3:25]).all())
        self.assertEqual(len(rows) - 22, numpy.isfinite(record.signals["hook_load"]).sum())

    def test_while_it_drills(self):
        """A hook load of 0, one that stays the same and one with a wrong digit, a row a second, while 1 m is drilled in 100 s."""
        def drilled(load):
            chance = numpy.random.default_rng(2)
            return [[k, 20.0 - 0.01 * k, 2499.0 + 0.01 * k, 2499.0 + 0.01 * k, load(k, round(800.0 + chance.normal(0.0, 2.0), 1)), round(9.0 + chance.normal(0.0, 0.3), 2), 150 + k % 3, 60.0, 1800.0]
                    for k in range(120)]
        self.assertEqual([], self.told(drilled(lambda k, load: load))[1])
        self.assertIn("hook_load: 70 rows of exactly 0, while", self.told(drilled(lambda k, load: 0.0 if 20 <= k < 90 else load))[1][0])
        self.assertIn("hook_load: it is the same to the last digit in 90 rows, over 89 s", self.told(drilled(lambda k, load: 801.0 if 20 <= k < 110 else load))[1][0])
        self.assertIn("hook_load: 1 single values are 3.", self.told(drilled(lambda k, load: 3.5 * load if k == 40 else load))[1][0])

    def test_a_signal_falls_to_nothing_while_what_goes_with_it_stays(self):
        flow, speed = 8, 7
        for column, null, name in ((flow, 0.0, "flow"), (flow, -1.0, "flow"), (PRESSURE, 0.0, "stand_pipe_pressure"), (speed, -1.0, "top_drive_speed"), (speed, 0.0, "top_drive_speed"),
                                   (TORQUE, 0.001, "torque")):
            rows = trip()
            rows[8:10, column] = null
            record, lines = self.told(rows)
            self.assertRegex(lines[0], "(%s: 2 rows in which it falls to nothing and comes back, while [a-z_]* stays as it is, are no measurements|Flow In .*: 2 values of -1)" % name)
            self.assertEqual(["%s: 2 of 480 rows hold no measurement" % name], [line.partition("measurement")[0] + "measurement" for line in lines[1:]])
            self.assertTrue(numpy.isnan(record.signals[name][8:10]).all())
            self.assertEqual(len(rows) - 2, numpy.isfinite(record.signals[name]).sum())

    def test_what_a_rig_does_stays(self):
        """Pumps that stop, a top drive that stops with its torque or turns free."""
        flow, speed = 8, 7
        for columns, first, last in (((flow, PRESSURE), 8, 20), ((speed, TORQUE), 8, 10), ((TORQUE,), 8, 20), ((speed,), 8, 20)):
            rows = trip(stands=2)
            for column in columns:
                rows[first:last, column] = 0.0
            lines = [line for line in self.told(rows)[1] if "falls to nothing" in line]
            self.assertEqual([], lines, columns)

    def test_what_swings_through_nothing_stays(self):
        """A torque that rings when the top drive starts, and a top drive that swings after it: rows near 0 are true."""
        for column, values in ((TORQUE, (0.1, 2.6, 0.0, 1.9, 0.9)), (7, (20.0, 58.0, 0.0, 61.0, 25.0))):
            rows = trip()
            rows[8:13, column] = values
            self.assertEqual([], [line for line in self.told(rows)[1] if "falls to nothing" in line])

    def test_zeros_of_the_slips_stay(self):
        """A gauge that is zeroed with the empty block, and lost for a while at the next stand: the zeros in the slips stay."""
        rows = trip()
        rows[rows[:, LOAD] < 500.0, LOAD] = 0.0
        rows[4 * SPAN:4 * SPAN + 12, LOAD] = 0.0
        record, lines = self.told(rows)
        self.assertIn("hook_load: ", lines[0])
        self.assertEqual(0.0, record.signals["hook_load"][2 * SPAN + 5])
        self.assertTrue(numpy.isnan(record.signals["hook_load"][4 * SPAN + 5]))
        rows[4 * SPAN:4 * SPAN + 12, LOAD] = 900.0
        rows[4 * SPAN:4 * SPAN + 2, LOAD] = 0.0  # read too late
        self.assertEqual([], self.told(rows)[1])

    def test_zeros_of_the_block_and_of_depths(self):
        """Ten rows at 0, faster than a block goes there; deeper than a bit jumps; at the begin too."""
        for column, name, thing in ((BLOCK, "block_height", "block"), (BIT, "bit_depth", "bit")):
            for begin in (20, 0) if column == BIT else (20,):
                rows = trip()
                rows[:, 0] /= 5.0
                rows[begin:begin + 10, column] = 0.0
                record, lines = self.told(rows)
                self.assertIn("%s: 10 rows of exactly 0, to which no %s goes between rows, are no measurements (first: " % (name, thing), lines[0])
                self.assertTrue(numpy.isnan(record.signals[name][begin:begin + 10]).all())

    def test_zeros_of_a_block_that_would_be_slow(self):
        """Rows 5 s apart: the bit stays where it is, on the hook. In the slips the block may have gone to 0."""
        for begin, lost in ((5, True), (4 * SPAN - 10, False)):
            rows = trip()
            rows[begin:begin + 7, BIT] = rows[begin - 1, BIT]
            rows[begin - 1:begin + 7, BLOCK] = 8.0
            rows[begin:begin + 6, BLOCK] = 0.0
            record = self.told(rows)[0]
            self.assertEqual(lost, bool(numpy.isnan(record.signals["block_height"][begin:begin + 6]).all()))

    def test_one_value_over_minutes(self):
        for column, name in ((LOAD, "hook_load"), (TORQUE, "torque")):
            rows = trip()
            rows[2:SPAN, column] = rows[2, column]
            lines = self.told(rows)[1]
            self.assertEqual(1, len(lines), lines)
            self.assertIn("%s: it is the same to the last digit in 28 rows, over 135 s in which the string moves 27 m (first: " % name, lines[0])
            self.assertIn("r.csv:4); check its gauge", lines[0])
            self.assertEqual(rows[2, column], rows[20, column])

    def test_a_single_value(self):
        for column, name, factor in ((LOAD, "hook_load", 3.5), (TORQUE, "torque", 3.5), (PRESSURE, "stand_pipe_pressure", 3.5)):
            rows = trip()
            rows[10, column] *= factor
            record, lines = self.told(rows)
            self.assertTrue(any(line.startswith("%s: 1 single values are 3." % name) and "r.csv:12); check their digits" in line for line in lines), lines)
            self.assertFalse(numpy.isnan(record.signals[name][10]))
        rows = trip()
        rows[2 * SPAN + 10, LOAD] = 900.0  # the string's load for a row, among those of the empty block
        self.assertEqual([], self.told(rows)[1])

    def drilled(self, column, value, first=100, last=140):
        """(record, lines) of 20 min in which 4.8 m are drilled, a row every 5 s, with a value in 40 rows of a column."""
        chance = numpy.random.default_rng(3)
        rows = numpy.array([[5.0 * k, 25.0 - 0.02 * k, 1500.0 + 0.02 * k, 1500.0 + 0.02 * k, round(900.0 + chance.normal(0.0, 5.0), 1), round(8.0 + chance.normal(0.0, 0.3), 2),
                             round(150.0 + chance.normal(0.0, 1.0), 1), round(120.0 + chance.normal()), round(2000.0 + chance.normal(0.0, 10.0))] for k in range(240)])
        rows[first:last, column] = value
        return self.told(rows)

    def test_values_near_nothing_that_are_none(self):
        names = {BLOCK: "block_height", BIT: "bit_depth", 3: "hole_depth", LOAD: "hook_load", TORQUE: "torque", PRESSURE: "stand_pipe_pressure", 7: "top_drive_speed", 8: "flow"}
        self.assertEqual([], self.drilled(BLOCK, 0.0, 0, 0)[1])
        for column, values in ((BLOCK, (0.0, 1.0, -1.0, -0.5, 1e-4)), (BIT, (0.0, 1.0, -0.5, 1e-4)), (3, (0.0, 1.0, -1.0)), (LOAD, (0.0, 1.0, 1e-4, -1.0, -0.5)), (TORQUE, (-1.0, -0.5)), (7, (-1.0,)),
                               (PRESSURE, (-1.0, -0.5)), (8, (-1.0, -0.5))):
            for value in values:
                for first, last in ((100, 140), (200, 240)):
                    with self.subTest(names[column], value=value, first=first):
                        record, lines = self.drilled(column, value, first, last)
                        lost = numpy.isnan(record.signals[names[column]])
                        self.assertEqual((40, 40), (lost.sum(), lost[first:last].sum()))
                        self.assertTrue(any("first: " in line and "r.csv:%d)" % (first + 2) in line for line in lines), lines)

    def test_a_small_value_that_is_one_stays(self):
        """The gauge of a pump's flow that shows -1 and 1 at rest; a block that stays at 1 m."""
        rows = trip()
        still = numpy.flatnonzero(rows[:, 8] == 0.0)
        rows[still[::2], 8], rows[still[1::2], 8] = -1.0, 1.0
        record, lines = self.told(rows)
        self.assertEqual([], lines)
        self.assertTrue(numpy.isfinite(record.signals["flow"]).all())
        self.assertTrue(numpy.isfinite(self.told(trip())[0].signals["block_height"]).all())

    def test_nothing_for_long_while_the_bit_moves(self):
        for column, value, name, other in ((TORQUE, 0.0, "torque", "top_drive_speed"), (7, 0.0, "top_drive_speed", "torque"),
                                           (8, 0.0, "flow", "stand_pipe_pressure"), (PRESSURE, 0.0, "stand_pipe_pressure", "flow")):
            record, lines = self.drilled(column, value, 200, 240)
            self.assertIn("%s: it is nothing from 1000 s on, for 195 s in which the bit moves 0.78 m and %s stays" % (name, other), lines[-1])
            self.assertTrue(numpy.isfinite(record.signals[name]).all())

    def test_a_hook_load_of_nothing_without_a_bit_depth(self):
        """While pump and top drive run, the string does not stand in the slips."""
        names = ",".join(name for name in NAMES.split(",") if "Depth" not in name)
        for load, speed, reported in ((0.0, 120.0, True), (1.0, 120.0, True), (1e-4, 120.0, True), (0.0, 0.0, False), (850.0, 120.0, False)):
            rows = [[5.0 * k, 25.0 - 0.02 * k, load if 100 <= k < 140 else 900.0 + k % 7, 8.0 + 0.1 * (k % 4), 150.0, speed if 100 <= k < 140 else 120.0, 2000.0] for k in range(240)]
            lines = self.read(text_of(numpy.array(rows), names)).remarks
            self.assertEqual(reported, any("hook_load: it is nothing from 500 s on, for 195 s in which the block moves 0.78 m and top_drive_speed and flow stay" in line for line in lines), lines)

    def test_remarks_of_a_refused_record(self):
        """Each in a line before the refusal, but for what is in that already."""
        rows = trip()
        rows[3, TORQUE] = numpy.nan
        out, told = io.StringIO(), io.StringIO()
        with redirect_stdout(out), redirect_stderr(told):
            status = weights_command.main([self.file("r.csv", text_of(rows, NAMES.replace("(kN)", "(furlong)")))])
        lines = told.getvalue().splitlines()
        self.assertEqual((2, 2), (status, len(lines)), lines)
        self.assertRegex(lines[0], "^drill weights: .*r.csv: torque: 1 of 480 rows hold no measurement$")
        self.assertIn("has no hook_load; needed: block_height, bit_depth and hook_load; hook_load is left out", lines[1])


if __name__ == "__main__":
    unittest.main()
