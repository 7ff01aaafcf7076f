#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""drill replay, but for the runner in front of it: records are read as they are, a record that the simulator made comes back, what cannot be played is told."""
import io
import itertools
import json
import math
import os
import re
import tempfile
import unittest
from contextlib import redirect_stderr, redirect_stdout
from types import SimpleNamespace
from unittest.mock import patch

import numpy
import yaml
from drill_rig_sim import replay_command
from drill_rig_sim.field.course import Course, half_band
from drill_rig_sim.field.follow import Follow
from drill_rig_sim.field.pipe import Slip, check_directions, first_hung, pipe_events, standstills
from drill_rig_sim.field.record import RecordError, read_record
from drill_rig_sim.field.replay import Warnings, beyond_limits, check, check_start, play, ratio_of_units
from drill_rig_sim.field.window import between, moment, stretches
from drill_rig_sim.sim import Simulator

SOURCE = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
QUICK = os.path.join(SOURCE, "config/scenes/quick.yaml")
STANDS = os.path.join(SOURCE, "config/scenes/stands.yaml")


class Folder(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def file(self, name, text):
        path = os.path.join(self.folder, name)
        with open(path, "w", encoding="utf-8") as out:
            out.write(text)
        return path


DEPTHS = """time: {column: t, unit: s}
block_height: {column: b, unit: m}
bit_depth: {column: d, unit: m}
hook_load: {column: h, unit: N}
"""


class StiffRig:
    """Of a law that is only looked at: lines that do not stretch."""
    joint_length, wave_impedance, block_mass, drum_height, block_acceleration = 9.5, 1e5, 2e4, 0.0, 0.5

    class state:
        class truth:
            block_height = 10.0

    @staticmethod
    def drum_heights(heights, _):
        return heights


class Connections(Folder):
    def record(self, bit, block):
        rows = ["%g,%.6f,%.6f,1" % (k, b, d) for k, (b, d) in enumerate(zip(block, bit))]
        return read_record(self.file("r.csv", "t,b,d,h\n" + "\n".join(rows) + "\n"), self.file("m.yaml", DEPTHS))

    def test_where_pipe_was_added(self):
        """Drilled to 103 m, lifted by one, hung off in 20 s, the block up by 28.5 m in 30 s, taken up, drilled on; the bit's gauge moves by a centimetre."""
        block = numpy.concatenate((numpy.linspace(5.0, 2.0, 30), numpy.linspace(2.0, 3.0, 10), numpy.full(20, 3.0), numpy.linspace(3.0, 31.5, 31), numpy.full(10, 31.5), numpy.linspace(31.5, 28.0, 30)))
        bit = numpy.concatenate((numpy.linspace(100.0, 103.0, 30), numpy.linspace(103.0, 102.0, 10), numpy.full(61, 102.0), numpy.linspace(102.0, 105.5, 30)))
        noise = 0.003 * numpy.random.default_rng(2).uniform(-1.0, 1.0, (2, len(bit)))
        (one,) = standstills(self.record(bit + noise[0], block + noise[1]))
        self.assertAlmostEqual(28.5, one.length, delta=0.02)
        self.assertTrue(39 <= one.begin <= 41 and 99 <= one.end <= 101, (one.begin, one.end))
        self.assertEqual((60, 90), (one.left, one.back))
        self.assertEqual({"joints": 3, "remove": False}, one.connection(9.5))
        self.assertEqual({"joints": 2, "remove": False}, one.connection(13.9))
        with self.assertRaisesRegex(ValueError, "28.5. m of pipe were added; needed: whole joints .*joint_length 20 m"):
            one.connection(20.0)

    def test_a_trip_out_a_row_a_minute_and_a_block_that_comes_back(self):
        out = standstills(self.record([300.0, 281.0, 281.0, 262.0], [2.0, 21.0, 2.0, 21.0]))
        self.assertEqual([{"joints": 2, "remove": True}], [one.connection(9.5) for one in out])
        there_and_back = standstills(self.record(numpy.full(30, 300.0), numpy.concatenate((numpy.full(10, 5.0), numpy.full(10, 12.0), numpy.full(10, 5.0)))))
        self.assertEqual([None], [one.connection(9.5) for one in there_and_back])
        self.assertEqual([], standstills(self.record(numpy.linspace(100.0, 120.0, 50), numpy.linspace(25.0, 5.0, 50))))

    def test_a_stand_that_was_drilled_down_with_the_next(self):
        """The crew's own connection, read from its record, in a rig that has no crew: the bit goes where it went, and loads are those that were recorded."""
        with open(STANDS, encoding="utf-8") as text:
            scene = yaml.safe_load(text)
        scene["start"]["block_height"] = 3.0
        scene["instruments"]["surface"]["hook_load"]["noise"] = 100.0
        still = self.file("off.yaml", yaml.safe_dump(scene))
        rig, rows = Simulator(self.file("auto.yaml", yaml.safe_dump({**scene, "connections": "auto"}))), []
        for state in itertools.chain([rig.state], rig.frames(240.0, every=100)):
            rows.append([state.t, state.block_height, state.top_drive_speed, state.flow, state.hook_load, state.torque, state.bit_depth])
            rig.pump(0.03)
            rig.winch(-0.03)
            rig.rotate(rpm=100.0)
        names = "time,reading_block_height,top_drive_speed,reading_flow,reading_hook_load,reading_torque,reading_bit_depth"
        record = read_record(self.file("r.csv", "\n".join([names, *(",".join("%.9g" % cell for cell in row) for row in rows)]) + "\n"))
        followed = Simulator(still)
        replay = play(followed, record)
        self.assertEqual(1, len([line for line in replay.remarks if "accuracy" not in line]), replay.remarks)
        self.assertIn("3 joints added", replay.remarks[0])
        self.assertAlmostEqual(rig.state.truth.bit_depth, followed.state.truth.bit_depth, delta=0.02)
        self.assertAlmostEqual(rig.state.truth.hole_depth, followed.state.truth.hole_depth, delta=0.02)
        left_out = numpy.isnan(replay.recorded["hook_load"])
        self.assertTrue(40 < left_out.sum() < 120, left_out.sum())
        table = replay.table()
        self.assertLess(abs(table["hook_load"]["mean"]), 300.0)
        self.assertLess(table["hook_load"]["rms"], 1500.0)
        self.assertLess(abs(table["torque"]["mean"]), 0.02 * table["torque"]["range"])  # the string rings when it is turned anew, not at the same instants

    def test_a_record_that_ends_in_the_slips(self):
        block = numpy.concatenate((numpy.linspace(20.0, 18.0, 20), numpy.linspace(18.0, 30.3, 12)))
        law = Follow(self.record(numpy.concatenate((numpy.linspace(279.0, 281.0, 20), numpy.full(12, 281.0))), block), StiffRig())
        self.assertEqual([], law.connections)
        self.assertAlmostEqual(-2.0, law.course[-1] - law.course[0], delta=5e-3)

    def test_a_depth_tracking_that_slips(self):
        bit = numpy.concatenate((numpy.linspace(300.0, 302.0, 20), numpy.linspace(307.0, 308.0, 20)))
        block = numpy.concatenate((numpy.linspace(20.0, 18.0, 20), numpy.linspace(18.0, 17.0, 20)))
        (slip,) = pipe_events(self.record(bit, block))
        self.assertIsInstance(slip, Slip)
        self.assertEqual(20, slip.row)
        self.assertAlmostEqual(5.0, slip.length, delta=0.01)
        drift = numpy.linspace(300.0, 310.0, 200)  # a depth that is corrected little by little
        self.assertEqual({Slip}, {type(event) for event in pipe_events(self.record(drift, 20.0 - 0.8 * (drift - 300.0)))})
        self.assertEqual([], standstills(self.record(drift, 20.0 - 0.8 * (drift - 300.0))))

    def test_a_depth_that_drifts_while_the_bit_creeps(self):
        for creep in (0.002, -0.002, 0.01):
            bit = 300.0 + creep * numpy.arange(400)
            events = pipe_events(self.record(bit, 20.0 + 0.011 * numpy.arange(400)))
            self.assertEqual({Slip}, {type(event) for event in events})
            self.assertAlmostEqual((creep + 0.011) * 400, sum(event.length for event in events), delta=0.6)

    def test_a_bit_that_goes_up_and_down_with_the_block(self):
        block = 20.0 - 0.1 * numpy.arange(40)
        check_directions(self.record(300.0 - (block - 20.0), block))
        for bit in (block, 300.0 + block, 300.0 + 0.9 * block):
            with self.assertRaisesRegex(RecordError, "bit_depth rises and falls with block_height, by 3.90 m"):
                check_directions(self.record(bit, block))

    def test_a_record_that_begins_in_the_slips(self):
        away = self.record(numpy.concatenate((numpy.full(20, 300.0), numpy.linspace(300.0, 302.0, 20))),
                           numpy.concatenate((numpy.linspace(10.0, 28.0, 15), numpy.full(5, 28.0), numpy.linspace(28.0, 26.0, 20))))
        self.assertTrue(19 <= first_hung(away) <= 21, first_hung(away))
        self.assertEqual(0, first_hung(self.record(numpy.linspace(300.0, 302.0, 40), numpy.linspace(10.0, 8.0, 40))))

    def test_a_connection_that_the_rig_cannot_make(self):
        block, bit = numpy.concatenate((numpy.full(10, 2.0), numpy.full(10, 40.0))), numpy.full(20, 299.7)
        # the time that a connection may take is played to its end, half an hour otherwise
        patient = [patch("drill_rig_sim.field.%s.PATIENCE" % module, 60.0) for module in ("follow", "replay")]
        with patient[0], patient[1], self.assertRaisesRegex(RecordError, "at 9.0 s the scene's rig refuses the connection of the record: connection: the block would"):
            play(Simulator(STANDS), self.record(bit, block))


class Replays(Folder):
    def recorded(self, seconds=45.0):
        """A record that the simulator made: the block is lowered, turning begins, the bit comes to bottom."""
        rig, rows = Simulator(QUICK), []
        for state in itertools.chain([rig.state], rig.frames(seconds, every=20)):
            rows.append([state.t, state.block_height, state.top_drive_speed, state.flow, state.hook_load, state.torque, state.stand_pipe_pressure, state.bit_depth])
            rig.pump(0.02)
            rig.winch(-0.01)
            rig.rotate(rpm=min(60.0, 3.0 * state.t))
        names = "time,reading_block_height,top_drive_speed,reading_flow,reading_hook_load,reading_torque,reading_stand_pipe_pressure,reading_bit_depth"
        return self.file("r.csv", "\n".join([names, *(",".join("%.9g" % cell for cell in row) for row in rows)]) + "\n")

    def drill_replay(self, *words):
        out, told = io.StringIO(), io.StringIO()
        with redirect_stdout(out), redirect_stderr(told):
            status = replay_command.main(list(words))
        return status, out.getvalue(), told.getvalue()

    def test_a_simulated_record_comes_back(self):
        names = {key: os.path.join(self.folder, "out." + key) for key in ("json", "csv", "png")}
        status, out, told = self.drill_replay(self.recorded(), QUICK, "--json", names["json"], "--csv", names["csv"], "--plots", names["png"])
        self.assertEqual((0, ""), (status, told))
        with open(names["json"], encoding="utf-8") as text:
            table = json.load(text)
        # what is between rows of 0.2 s is not in the record: the start is smeared
        self.assertEqual({"hook_load", "torque", "stand_pipe_pressure"}, set(table))
        for signal, share in (("hook_load", 0.06), ("torque", 0.06), ("stand_pipe_pressure", 0.02)):
            self.assertLess(table[signal]["rms"], share * table[signal]["range"], signal)
            self.assertLess(abs(table[signal]["mean"]), 0.01 * table[signal]["range"], signal)
        self.assertGreater(os.path.getsize(names["png"]), 10000)
        data = numpy.genfromtxt(names["csv"], delimiter=",", names=True)
        self.assertAlmostEqual(table["torque"]["rms"], math.sqrt(numpy.mean((data["recorded_torque"] - data["simulated_torque"])**2)), delta=1e-3)
        self.assertIn("hook load", out)

    def test_the_block_by_its_velocity(self):
        columns = self.file("m.yaml", "time: {column: t, unit: s}\nblock_velocity: {column: v, unit: ft/min}\nhook_load: {column: h, unit: N}\n")
        law = Follow(read_record(self.file("v.csv", "t,v,h\n0,-10,1\n60,-10,1\n"), columns), StiffRig())
        self.assertAlmostEqual(-10.0 * 0.3048, law.course[-2] - law.course[0], places=6)

    def test_a_block_that_stops_does_not_come_back(self):
        """A gauge with noise, and cubics without overshoot: friction acts to the side of the last way."""
        jitter = 1e-3 * numpy.random.default_rng(1).normal(size=400)
        height = numpy.concatenate((numpy.linspace(20.0, 18.0, 200), numpy.full(200, 18.0))) + jitter
        band = half_band(height, height)
        self.assertTrue(2e-3 < band < 5e-3, band)
        course = Course(numpy.arange(400.0), height, band)(0.05 * numpy.arange(7900))
        self.assertLessEqual(numpy.diff(course).max(), 1e-12)
        self.assertLess(abs(course[-1] - 18.0), 2e-3)

    def test_a_block_that_starts_with_the_record(self):
        """Within the first row, as fast as the drawworks can, and in a course from rest: what the string rings by it comes back."""
        with open(STANDS, encoding="utf-8") as text:
            scene = yaml.safe_load(text)
        path = self.file("still.yaml", yaml.safe_dump({**scene, "instruments": {"surface": {"hook_load": {"place": "block"}}}}))
        rig, rows = Simulator(path), []
        for state in itertools.chain([rig.state], rig.frames(15.0, every=100)):
            rows.append([state.t, state.block_height, state.hook_load, state.bit_depth])
            rig.winch(0.4)
        file = self.file("s.csv", "\n".join([self.ROWS, *(",".join("%.9g" % cell for cell in row) for row in rows)]) + "\n")
        replay = play(Simulator(path), read_record(file))
        self.assertNotIn("could not follow", " ".join(replay.remarks))
        self.assertLess(abs(replay.residual("hook_load")).max(), 15e3)  # 31 kN where the block was taken to move before the first row
        self.assertLess(replay.table()["hook_load"]["rms"], 1.3 * replay.unresolved[0])

    def test_the_first_row_by_the_dead_line(self):
        """On the first centimetre the sheaves' friction turns round: the reading falls by a tenth while the load rises. It was taken for a block that bounces, 100 kN off."""
        scene, file = self.hoisted("dead_line", 1.0, seconds=20.0)
        replay = play(Simulator(scene), read_record(file))
        self.assertLess(replay.recorded["hook_load"][1], 0.96 * replay.recorded["hook_load"][0])
        self.assertLess(abs(replay.residual("hook_load")).max(), 8e3)

    def test_hook_load_after_the_brake(self):
        """Of the same scene; the gauge of the block's height goes back and forth by some tenths of a millimetre, as the block does not. How abruptly it stopped is
        not in a record of a row a second: a part of the friction of its rail (5.2 kN) remains unknown."""
        rig, rows = Simulator(QUICK), []
        for state in itertools.chain([rig.state], rig.frames(40.0, every=100)):
            rows.append([state.t, state.block_height, state.top_drive_speed, state.flow, state.hook_load])
            rows[-1][1] += 4e-4 * (-1.0)**len(rows)
            rig.winch(-0.01 if state.t < 20.0 else 0.0)
        names = "time,reading_block_height,top_drive_speed,reading_flow,reading_hook_load"
        file = self.file("b.csv", "\n".join([names, *(",".join("%.9g" % cell for cell in row) for row in rows)]) + "\n")
        replay = play(Simulator(QUICK), read_record(file))
        self.assertLess(abs(replay.residual("hook_load")[replay.time > 25.0]).max(), 2000.0)

    with open(os.path.join(SOURCE, "test/field/hoist.yaml"), encoding="utf-8") as text:
        HOIST = yaml.safe_load(text)
    ROWS = "time,reading_block_height,reading_hook_load,reading_bit_depth"

    def hoisted(self, place, step, gauge=lambda height: height, seconds=60.0):
        """A scene of a long string that is hoisted from rest to 0.165 m/s, and its record with a row each `step` [s]: a gauge that shows the block's height otherwise shifts the bit."""
        scene = self.file("hoist.yaml", yaml.safe_dump({**self.HOIST, "instruments": {"surface": {"hook_load": {"place": place}}}}))
        rig, rows = Simulator(scene), []
        for state in itertools.chain([rig.state], rig.frames(seconds, every=10)):
            shown = gauge(state.block_height)
            rows.append([state.t, shown, state.hook_load, state.bit_depth + state.block_height - shown])
            rig.winch(0.165 * min(1.0, 0.1 * state.t))
        rows = rows[::round(step / 0.1)]
        return scene, self.file("h.csv", "\n".join([self.ROWS, *(",".join("%.9g" % cell for cell in row) for row in rows)]) + "\n")

    def test_a_block_that_bounces_on_its_lines_comes_back(self):
        """A follower of the block made it ring more and more, 104 kN off. Exact rows, dead line, 5 s between rows, a gauge of 1 cm and one with 1 cm of noise."""
        chance = numpy.random.default_rng(7)
        for place, step, gauge, most in (("block", 1.0, lambda h: h, 2e3), ("dead_line", 1.0, lambda h: h, 2e3), ("block", 5.0, lambda h: h, 6e3),
                                         ("block", 1.0, lambda h: round(h, 2), 4e3), ("block", 1.0, lambda h: h + 0.01 * chance.normal(), 8e3)):
            scene, file = self.hoisted(place, step, gauge)
            replay = play(Simulator(scene), read_record(file))
            table = replay.table()["hook_load"]
            self.assertLess(table["rms"], most, (place, step, table))
            self.assertTrue(0.1e3 < table["unresolved_rms"] < 4.0 * most, (place, step, table))
            self.assertLess(table["largest"], 1.5 * table["unresolved_largest"], (place, step, table))

    def test_a_part_that_starts_where_the_record_does(self):
        """--from into the middle: refused, for the bit is elsewhere, and the option that helps is named; then played from there, without a stretch."""
        scene, file = self.hoisted("block", 1.0)
        status, _, told = self.drill_replay(file, scene, "--from", "40")
        self.assertEqual((2, 1), (status, told.count("\n")), told)
        self.assertIn("--start record", told)
        names = [os.path.join(self.folder, name) for name in ("all.csv", "part.csv")]
        status, _, told = self.drill_replay(file, scene, "--from", "40", "--to", "58", "--leave-out", "50:55", "--start", "record", "--csv", names[0])
        self.assertEqual(0, status, told)
        self.assertIn("started where the record begins: start.bit_depth 26", told)
        data = numpy.genfromtxt(names[0], delimiter=",", names=True)
        self.assertEqual((40.0, 58.0), (data["time"][0], data["time"][-1]))
        self.assertEqual([50.0, 51.0, 52.0, 53.0, 54.0, 55.0], list(data["time"][numpy.isnan(data["recorded_hook_load"])]))
        for words, said in ((("--from", "1e9"), "has 0 rows"), (("--leave-out", "0:1e9", "--start", "record"), "no row is left to compare"),
                            (("--start", "record", "--plots", os.path.join(self.folder, "a.what")), "a.what: "), (("--from", "noon"), "--from: 'noon' is neither"), (("--to", "2024-05-01T10:00:00Z"), "has no dates"),
                            (("--leave-out", "9:3"), "A before B"), (("--leave-out", "9"), "--leave-out")):
            status, _, told = self.drill_replay(file, scene, *words)
            self.assertEqual((2, 1), (status, told.count("\n")), told)
            self.assertIn(said, told)

    def test_a_part_that_begins_while_the_string_turns(self):
        """Pump and top drive are at the record's values from its first row on."""
        picture = os.path.join(self.folder, "part.csv")
        status, _, told = self.drill_replay(self.recorded(), QUICK, "--from", "24", "--to", "29", "--start", "record", "--csv", picture)
        self.assertEqual(0, status, told)
        self.assertRegex(told, "begins with the top drive at 60.. rpm and the pump at 0.02 m3/s: played for 30 s before it")
        data = numpy.genfromtxt(picture, delimiter=",", names=True)
        self.assertLess(abs(data["recorded_stand_pipe_pressure"] / data["simulated_stand_pipe_pressure"] - 1.0).max(), 0.01)
        self.assertLess(abs(numpy.mean(data["recorded_torque"] - data["simulated_torque"])), 0.05 * numpy.mean(data["recorded_torque"]))

    def test_a_scene_with_a_crew_and_without_a_start(self):
        scene, file = self.hoisted("block", 1.0, seconds=20.0)
        auto = self.file("auto.yaml", yaml.safe_dump({**self.HOIST, "connections": "auto", "start": {"block_height": 20.0}}))
        status, _, told = self.drill_replay(file, auto)
        self.assertEqual(0, status, told)
        self.assertIn("connections: auto of the scene is switched off", told)
        self.assertIn("start.bit_depth 2614.00 m, start.block_height 1.30 m", told)
        self.assertEqual(0, self.drill_replay(file, scene)[0])

    def test_dates(self):
        columns = self.file("d.yaml", "time: {column: t, unit: date}\nblock_height: {column: b, unit: m}\nhook_load: {column: h, unit: N}\n")
        record = read_record(self.file("d.csv", "t,b,h\n2024-05-01T10:00:00Z,10,1\n2024-05-01T10:00:10Z,9,1\n2024-05-01T10:00:20Z,8,1\n2024-05-01T10:00:30Z,7,1\n"), columns)
        self.assertEqual(10.0, moment("2024-05-01T12:00:10+02:00", record, "--from"))
        self.assertEqual([(10.0, 20.0)], stretches(["2024-05-01T10:00:10Z..2024-05-01T10:00:20Z"], record))
        part = between(record, 10.0, 25.0)
        self.assertEqual(([0.0, 10.0], [10.0, 20.0], 10.0), (list(part.time), list(part.signals["time"]), part.begin - record.begin))
        self.assertEqual(9.0, part.at("block_height", 0.0))

    def test_accuracy_warnings_are_passed_on(self):
        scene, file = self.hoisted("block", 1.0, seconds=10.0)
        coarse = self.file("coarse.yaml", yaml.safe_dump({**self.HOIST, "needs": ["hook_load", "direction"], "numerics": {"level": "axial_torsional"}}))
        _, out, told = self.drill_replay(file, coarse)
        self.assertRegex(told, "accuracy warning, .* does not represent direction")
        self.assertIn("error of the simulation not measured: numerics.level is set by hand and numerics.companion is not\n", out)
        self.assertNotIn("accuracy warning", self.drill_replay(file, scene)[2])

    def test_accuracy_warnings_show_how_long_they_were_set(self):
        warnings = Warnings()
        for time, text in enumerate(["", "a 1 %", "a 2 %", "", "a 3 %", "b", "b"]):
            warnings.look(SimpleNamespace(state=SimpleNamespace(truth=SimpleNamespace(accuracy_warning=text != "")), accuracy_warning=text), float(time))
        self.assertEqual(["accuracy warning, 1.0 s between 1.0 and 4.0 s: a 1 %", "accuracy warning, 5.0 to 6.0 s: b"], warnings.lines())

    def test_the_error_that_the_companion_measures_is_shown(self):
        _, file = self.hoisted("block", 1.0, seconds=10.0)
        names, beside = os.path.join(self.folder, "errors.json"), self.file("beside.yaml", yaml.safe_dump({**self.HOIST, "numerics": {"tolerance": 0.05}}))
        _, out, _ = self.drill_replay(file, beside, "--json", names)
        shown = re.search(r"measured error of the simulation, largest of 3 s: hook load (\S+) % of the range\n", out)
        self.assertTrue(shown and 0.0 < float(shown.group(1)) < 5.0, out)
        with open(names, encoding="utf-8") as text:
            self.assertAlmostEqual(0.01 * float(shown.group(1)), json.load(text)["hook_load"]["measured_error"], delta=0.002)

    def test_what_looks_like_another_unit_is_reported(self):
        columns = self.file("u.yaml", "time: {column: t, unit: s}\nblock_height: {column: b, unit: m}\nflow: {column: q, unit: m3/s}\ntop_drive_speed: {column: w, unit: rpm}\n")
        record = read_record(self.file("u.csv", "t,b,q,w\n0,10,0.01,90\n1,10,0.08,270\n2,10,0.08,270\n"), columns)
        flow, rotation = sorted(beyond_limits(record, Simulator(QUICK)))
        self.assertIn("flow is up to 4800 L/min, beyond the 3600 L/min of the scene's rig in 2 rows (first: at 1.0 s); is the unit right?", flow)
        self.assertIn("top_drive_speed is up to 270 rpm, beyond the 220 rpm", rotation)
        load = numpy.linspace(2e5, 3e5, 20)
        self.assertIn("of kgf to lbf; is the unit right?", ratio_of_units(2.2046 * load, load)[0])
        for factor in (0.97, 1.02, 1.1, 1.5):
            self.assertEqual([], ratio_of_units(factor * load, load))

    def test_what_cannot_be_played_is_told(self):
        columns = self.file("m.yaml", "time: {column: t, unit: s}\nblock_height: {column: b, unit: m}\nhook_load: {column: h, unit: N}\nbit_depth: {column: d, unit: m}\n")
        with self.assertRaisesRegex(RecordError, "begins with the bit at 30.*the scene at"):
            check_start(read_record(self.file("r.csv", "t,b,h,d\n0,10,1,30\n1,9,1,31\n"), columns), Simulator(QUICK))
        with self.assertRaisesRegex(RecordError, "the block is at up to 65.60 m, the crown of the scene's mast at 46.00 m; is the unit of block_height right"):
            check_start(read_record(self.file("r.csv", "t,b,h,d\n0,65.6,1,100\n1,65.5,1,100.1\n"), columns), Simulator(QUICK))
        with self.assertRaisesRegex(RecordError, "at 2.0 s bit_depth jumps by -27"):
            standstills(read_record(self.file("r.csv", "t,b,h,d\n0,10,1,100\n1,9,1,101\n2,12,1,74\n3,11,1,75\n"), columns))
        long = read_record(self.file("r.csv", "t,b,h,d\n0,10,1,30\n1,9,1,31\n172801,9,1,31\n172802,8,1,32\n"), columns)
        with self.assertRaisesRegex(RecordError, "has a gap of 2 days from 1.0 s on"):
            check(long)
        check(between(long, 172801.0, math.inf))
        columns = self.file("n.yaml", "time: {column: t, unit: s}\nhook_load: {column: h, unit: N}\n")
        status, out, told = self.drill_replay(os.path.join(self.folder, "r.csv"), QUICK, "--columns", columns)
        self.assertEqual((2, ""), (status, out))
        self.assertIn("needs block_height or block_velocity", told)
        self.assertEqual(2, self.drill_replay(self.recorded(1.0), "/nowhere.yaml")[0])

    def test_rows_closer_than_frames(self):
        """A spreadsheet's days taken for seconds are refused; rows of a millisecond are played."""
        text = "Time (s),Hook Load (kN),Block Height (m)\n"
        days = read_record(self.file("r.csv", text + "".join("%.9f,221,%g\n" % (45433.4 + k / 86400.0, 20.0 - 0.001 * k) for k in range(40))))
        with self.assertRaisesRegex(RecordError, "lasts 0.000451 s; needed: 0.1 s or more; is the unit of the time right"):
            check(days)
        fast = self.file("f.csv", text + "".join("%.3f,221,%g\n" % (0.001 * k, 20.0 - 0.00002 * abs(k - 100)) for k in range(200)))
        status, out, said = self.drill_replay(fast, QUICK)
        self.assertEqual(0, status, said)
        self.assertIn("hook load", out)

    def test_why_a_signal_is_missing(self):
        """The column was there: the refusal says why it was not read."""
        for heads, said in (("Hook Load (tonf),Block Height (m)", "holds nothing to compare; needed: hook_load or torque or stand_pipe_pressure; hook_load is left out: Hook Load (tonf): unit tonf is ambiguous"),
                            ("Hook Load (kN),Block Height (dm)", "needs block_height or block_velocity; block_height is left out: Block Height (dm): unit dm is not known"),
                            ("Load at the Hook (kN),Block Height (m)", "holds nothing to compare; needed: hook_load or torque or stand_pipe_pressure; no column is recognised as ")):
            with self.subTest(heads):
                with self.assertRaises(RecordError) as caught:
                    check(read_record(self.file("r.csv", "Time (s),%s\n0,200,10\n1,200,9\n" % heads)))
                self.assertIn(said, str(caught.exception))
                self.assertNotIn("\n", str(caught.exception))


if __name__ == "__main__":
    unittest.main()
