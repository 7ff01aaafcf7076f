#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""drill live, but for the runner in front of it: a simulated rig's own WITS stream and a bag come back; gaps, slips, bad rows and the feed's end are reported."""
import io
import os
import signal
import tempfile
import threading
import types
import unittest
from contextlib import redirect_stderr, redirect_stdout

import numpy
import rosbag
import rospy
import yaml
from drill_rig_sim import live_command, wits0
from drill_rig_sim.field.feed_row import Row
from drill_rig_sim.field.live import MOST_REFUSED, Live, Rows
from drill_rig_sim.field.replay import play
from drill_rig_sim.field.table import RecordError
from drill_rig_sim.field.wits_feed import Stream
from drill_rig_sim.msg import RigState
from drill_rig_sim.sim import Simulator

SOURCE = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
FOLDER = tempfile.TemporaryDirectory()
QUICK = os.path.join(FOLDER.name, "quick.yaml")  # without a companion
with open(os.path.join(SOURCE, "config/scenes/quick.yaml"), encoding="utf-8") as quick, open(QUICK, "w", encoding="utf-8") as alone:
    alone.write(quick.read() + "\nnumerics: {companion: none}\n")
PLAYED = ("block_height", "top_drive_speed", "flow", "hook_load", "torque", "stand_pipe_pressure", "bit_depth", "hole_depth")


def moved(rig, seconds):
    """States of a rig whose block goes up, stands and goes down again, a second apart."""
    states = [rig.state]
    for velocity, until in ((0.0, 5.0), (0.05, 25.0), (0.0, 35.0), (-0.05, seconds)):
        rig.winch(velocity)
        states += list(rig.frames(until - (len(states) - 1), every=round(rig.rate)))
    return states


class Recorded(unittest.TestCase):
    """With the states of one run."""

    @classmethod
    def setUpClass(cls):
        cls.states = moved(Simulator(QUICK), 50.0)

    def rows(self, every=1, count=None):
        return [Row("record %d" % (k + 1), state.t, {name: getattr(state, name) for name in PLAYED}) for k, state in enumerate(self.states[:count:every])]

    def live(self, rows, scene=QUICK):
        """Lines, and by signal the residuals of the rows that were played, by self.rig."""
        said, off = [], {}

        def show(time, row):
            for name, (measured, simulated) in row.items():
                off.setdefault(name, []).append((time, measured - simulated))
        self.rig = Simulator(scene)
        live = Live("feed", self.rig, rows[:6], said.append, show)
        for row in rows[6:]:
            live.take(row)
        live.finish()
        return said, {name: numpy.array(values) for name, values in off.items()}


class Feed(Recorded):
    def test_a_run_comes_back_as_a_replay_of_the_whole_would(self):
        for every in (1, 5):
            rows = self.rows(every)
            whole = play(Simulator(QUICK), Rows("record", rows, 0.0)).table()
            said, off = self.live(rows)
            self.assertEqual([], said)
            self.assertEqual([row.time for row in rows], list(off["hook_load"][:, 0]))
            rms = numpy.sqrt((off["hook_load"][:, 1]**2).mean())
            self.assertLess(rms, 1.5 * max(whole["hook_load"]["unresolved_rms"], whole["hook_load"]["rms"]), every)
            self.assertLess(numpy.abs(off["bit_depth"][:, 1]).max(), 0.05, every)

    def test_a_gap_is_bridged(self):
        rows = self.rows()
        said, off = self.live(rows[:20] + rows[32:])
        self.assertEqual(["a gap of 13 s from 19.0 s on: bridged by straight lines"], said)
        self.assertLess(numpy.abs(off["bit_depth"][:, 1]).max(), 0.05)

    def test_a_slip_of_depth_stays_in_the_bit_depth_alone(self):
        rows = [row if row.time < 30.0 else row._replace(values={**row.values, "bit_depth": row.values["bit_depth"] + 2.0, "hole_depth": row.values["hole_depth"] + 2.0})
                for row in self.rows()]
        said, off = self.live(rows)
        self.assertEqual(1, len(said), said)
        self.assertRegex(said[0], r"at 30.0 s the bit depth changes by (1.9|2.0). m while the block does not|at 30.0 s the bit depth changes by .* taken as a slip")
        late = off["bit_depth"][off["bit_depth"][:, 0] > 35.0, 1]
        self.assertLess(numpy.abs(late - 2.0).max(), 0.05)
        _, plain = self.live(self.rows())
        # it waits until the slip is certain, and then knows more rows, so that the block's way between two of them may differ
        numpy.testing.assert_allclose(off["hook_load"][:, 1], plain["hook_load"][:, 1], atol=1e3)

    def test_rows_that_cannot_be(self):
        rows = self.rows()
        bad = [rows[20]._replace(place="record 99", time=3.0), rows[20]._replace(place="record 98", values={**rows[20].values, "block_height": numpy.nan}),
               rows[20]._replace(place="record 97", time=1e9)]
        said, off = self.live(rows[:20] + bad + rows[20:])
        self.assertEqual(["record 99 is refused: its time is 3 s, that of the row before 19 s; needed: later by up to a day",
                          "record 98 is refused: has no block_height",
                          "record 97 is refused: its time is 1e+09 s, that of the row before 19 s; needed: later by up to a day"], said)
        self.assertEqual(len(rows), len(off["hook_load"]))

    def test_a_connection_is_waited_for_and_made(self):
        """The crew's own connection in a rig without a crew: these rows have no residual, bit and hole end where they did."""
        with open(os.path.join(SOURCE, "config/scenes/stands.yaml"), encoding="utf-8") as text:
            scene = yaml.safe_load(text)
        scene["start"]["block_height"], scene["numerics"] = 3.0, {**scene.get("numerics", {}), "companion": "none"}
        files = {name: os.path.join(FOLDER.name, name + ".yaml") for name in ("off", "auto")}
        for name, file in files.items():
            with open(file, "w", encoding="utf-8") as out:
                yaml.safe_dump({**scene, "connections": name}, out)
        rig = Simulator(files["auto"])
        self.states = [rig.state]
        rig.pump(0.03)
        rig.rotate(rpm=100.0)
        rig.winch(-0.03)
        self.states += self.driven(rig, 240.0)
        said, off = self.live(self.rows(), files["off"])
        made = [line for line in said if "accuracy" not in line]
        self.assertEqual(1, len(made), said)
        self.assertRegex(made[0], r"^connection at [\d.]+ s: .*3 joints added")
        self.assertAlmostEqual(rig.state.truth.bit_depth, self.rig.state.truth.bit_depth, delta=0.02)
        self.assertAlmostEqual(rig.state.truth.hole_depth, self.rig.state.truth.hole_depth, delta=0.02)
        loads = off["hook_load"][:, 1]
        self.assertTrue(40 < numpy.isnan(loads).sum() < 120, numpy.isnan(loads).sum())
        self.assertLess(numpy.nanmax(numpy.abs(loads)), 1e4)
        self.assertLess(numpy.sqrt(numpy.nanmean(loads**2)), 4e3)

    @staticmethod
    def driven(rig, seconds):
        """States a second apart, with the set points given each second anew: a connection ends with the brake set."""
        for state in rig.frames(seconds, every=round(rig.rate)):
            yield state
            rig.pump(0.03)
            rig.winch(-0.03)
            rig.rotate(rpm=100.0)

    def test_a_feed_that_ends_in_the_slips(self):
        rows = self.rows()
        for k in range(1, 13):  # the block goes up and the bit stays
            rows.append(rows[-1]._replace(time=rows[-1].time + 1.0, place="record %d" % (len(rows) + 1), values={
                **rows[-1].values, "block_height": rows[-1].values["block_height"] + 1.0}))
        said, off = self.live(rows)
        self.assertRegex("\n".join(said), r"ends while pipe is handled: not played from 5\d\.0 s on")
        self.assertLess(off["hook_load"][-1, 0], 52.0)

    def test_a_feed_that_makes_no_sense_is_given_up(self):
        rows = self.rows()
        with self.assertRaisesRegex(RecordError, "feed: %d rows in sequence were refused; last: record 12: has no bit_depth" % MOST_REFUSED):
            self.live(rows[:11] + MOST_REFUSED * [rows[11]._replace(values={"block_height": 10.0})])

    def test_a_long_feed_forgets_its_rows(self):
        """What is kept does not change what is played, by more than the gauge of the hook load says of the lines."""
        rows, rest = self.rows(), []
        for k in range(1, 200):  # it stands
            rest.append(rows[-1]._replace(time=rows[-1].time + k))
        live = Live("feed", Simulator(QUICK), rows[:6], self.fail, lambda time, row: None)
        for row in rows[6:] + rest:
            live.take(row)
        self.assertLess(len(live.rows), 130)
        self.assertLess(len(live.times), 130 * 20)
        live.finish()
        self.assertAlmostEqual(rows[-1].values["block_height"], live.rig.state.block_height, delta=0.02)


class Command(Recorded):
    def command(self, *words):
        out, err = io.StringIO(), io.StringIO()
        with redirect_stdout(out), redirect_stderr(err):
            status = live_command.main(list(words))
        return status, out.getvalue(), err.getvalue()


class Bag(Command):
    def bag(self, *names):
        """The states as rigs of these namespaces would send them."""
        file = os.path.join(FOLDER.name, "_".join(names).replace("/", "") + ".bag")
        with rosbag.Bag(file, "w") as bag:
            for state in self.states:
                message = RigState(**{name: getattr(state, name) for name in PLAYED})
                message.header.stamp = rospy.Time.from_sec(1000.0 + state.t)
                for name in names:
                    bag.write(name + "/rig_state", message, message.header.stamp)
        return file

    def test_a_bag_is_played_as_its_stream_would(self):
        csv = os.path.join(FOLDER.name, "bag.csv")
        status, out, err = self.command(self.bag("/rig"), QUICK, "--csv", csv)
        self.assertEqual((0, ""), (status, err))
        rows = numpy.genfromtxt(csv, delimiter=",", names=True)
        self.assertEqual([state.t - self.states[0].t for state in self.states], list(rows["time"]))
        _, off = self.live(self.rows())
        numpy.testing.assert_allclose(rows["measured_hook_load"] - rows["simulated_hook_load"], off["hook_load"][:, 1], atol=1.0)
        self.assertRegex(out, r"(?m)^bit depth +-?[\d.]+ +[\d.]+ +[\d.]+ +51 m$")

    def test_every_and_namespace(self):
        file = self.bag("/one", "/two")
        status, _, err = self.command(file, QUICK)
        self.assertEqual(2, status)
        self.assertIn("/one", err)
        status, out, err = self.command(file, QUICK, "--namespace", "/two", "--every", "5")
        self.assertEqual((0, ""), (status, err))
        self.assertRegex(out, r"(?m)^hook load .* 11 kN$")

    def test_another_bag(self):
        file = os.path.join(FOLDER.name, "text.bag")
        with open(file, "w", encoding="utf-8") as text:
            text.write("no bag\n")
        status, _, err = self.command(file, QUICK)
        self.assertEqual(2, status)
        self.assertTrue(err.startswith("drill live: %s: " % file) and err.count("\n") == 1, err)


class Interrupted(unittest.TestCase):
    def test_ctrl_c_waits_until_a_row_is_taken(self):
        done = []
        with self.assertRaises(KeyboardInterrupt):
            with live_command.uninterrupted():
                signal.raise_signal(signal.SIGINT)
                done.append("the row")
            done.append("the next row")
        self.assertEqual(["the row"], done)
        with self.assertRaises(KeyboardInterrupt):  # as before it
            signal.raise_signal(signal.SIGINT)

    def test_without_it_nothing_is_raised(self):
        with live_command.uninterrupted():
            pass


class Wits(Command):
    def sent(self, states):
        """WITS as the node's server writes it."""
        for state in states:
            yield wits0.general_record(types.SimpleNamespace(**{field: getattr(state, field) for _, field, _, _ in wits0.GENERAL}, tared=state.tared,
                                                             header=types.SimpleNamespace(stamp=types.SimpleNamespace(to_sec=lambda t=state.t: t))))

    def test_a_stream_by_tcp(self):
        """Of a server that ends once all was read."""
        server = wits0.Server("127.0.0.1", 0, lambda text: arrived.set() if "has come" in text else None)
        arrived = threading.Event()

        def send():
            arrived.wait(30.0)
            for data in self.sent(self.states):
                server.send(data)
            while any(client.waiting for client in server.clients):
                threading.Event().wait(0.05)
            server.close()
        sender = threading.Thread(target=send)
        sender.start()
        with tempfile.TemporaryDirectory() as folder:
            csv = os.path.join(folder, "live.csv")
            status, out, err = self.command("127.0.0.1:%d" % server.port, QUICK, "--csv", csv)
            sender.join()
            self.assertEqual(0, status, err)
            rows = numpy.genfromtxt(csv, delimiter=",", names=True)
        self.assertEqual("", err)
        self.assertEqual(len(self.states), len(rows))
        numpy.testing.assert_allclose(rows["measured_hook_load"], [state.hook_load for state in self.states], atol=5.1)
        sent = Stream("metric", self.fail).take(b"".join(self.sent(self.states)))  # as rounded
        sent = [row._replace(time=row.time - sent[0].time) for row in sent]
        whole = play(Simulator(QUICK), Rows("record", sent, 0.0)).table()["hook_load"]
        off = rows["measured_hook_load"] - rows["simulated_hook_load"]
        self.assertLess(numpy.sqrt((off**2).mean()), 1.5 * max(whole["unresolved_rms"], whole["rms"]))
        self.assertRegex(out, r"(?m)^hook load +-?[\d.]+ +[\d.]+ +[\d.]+ +51 kN$")

    def test_units_of_fps(self):
        (row,) = Stream("fps", self.fail).take(b"&&\r\n0105240517\r\n0106063000\r\n01081000\r\n011250\r\n0114200\r\n011810\r\n0120120\r\n01213000\r\n0130500\r\n!!\r\n")
        self.assertEqual(1715927400.0, row.time)
        for name, value in (("bit_depth", 304.8), ("block_height", 15.24), ("hook_load", 889644.3), ("torque", 13558.18), ("top_drive_speed", 12.56637),
                            ("stand_pipe_pressure", 20684272.0), ("flow", 0.0315451)):
            self.assertAlmostEqual(1.0, row.values[name] / value, places=6, msg=name)

    def test_bad_records(self):
        said = []
        stream = Stream("metric", said.append)
        head = b"&&\r\n0105240517\r\n0106063000\r\n"
        self.assertEqual([], stream.take(b"noise\r\n&&\r\n0708712.0\r\n!!\r\n" + b"&&\r\n0105240532\r\n0106063000\r\n!!\r\n" + head + b"what\r\n!!\r\n" + head))
        (row,) = stream.take(head + b"0112abc\r\n011430.5\r\n0108-999.25\r\n0120999\r\n!!\r\n")
        self.assertEqual(["record 1 is refused: date and time (0105, 0106) must be YYMMDD and HHMMSS (got '240532', '063000')",
                          "record 2 is refused: 'what' is not an item of record 01",
                          "record 3 is refused: it has no end (!!)",
                          "record 4: item 0112 is left out: 'abc' is not a number",
                          "record 4: item 0120 is left out: top_drive_speed must be between -50 and 50 rad/s (got 104.615)"], said)
        self.assertEqual(305000.0, row.values["hook_load"])
        self.assertTrue(all(numpy.isnan(row.values[name]) for name in ("block_height", "bit_depth", "top_drive_speed")))

    def test_no_feed(self):
        status, _, err = self.command("127.0.0.1:1", QUICK)
        self.assertEqual((2, "drill live: 127.0.0.1:1: Connection refused\n"), (status, err))
        status, _, err = self.command("missing.bag", QUICK)
        self.assertEqual((2, "drill live: missing.bag: No such file or directory\n"), (status, err))


if __name__ == "__main__":
    unittest.main()
