#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What `drill web` makes of messages: logs that keep peaks, alarms that stay, activity, sheets, what pages may ask for. No master, no browser."""
import asyncio
import io
import math
import time
import types
import unittest

import numpy
import rospy
import skips
from drill_rig_sim.lockstep import Refused
from drill_rig_sim.msg import DrillstringState, RigState, RigTruth
from drill_rig_sim.units import SHOWN
from drill_rig_sim.web import fields, shapes
from drill_rig_sim.web.alarms import Alarms
from drill_rig_sim.web.bins import Bins
from drill_rig_sim.web.broomstick import points, scene_at, ways_of
from drill_rig_sim.web.feed import Feed
from drill_rig_sim.web.news import News
from drill_rig_sim.web.node_source import NodeSource
from drill_rig_sim.web.orders import Orders, number_of
from drill_rig_sim.web.packed import Packed
from drill_rig_sim.web.run_log import RunLog


def state(t, **members):
    """A RigState at a time [s]."""
    message = RigState()
    message.header.frame_id = "rig_floor"
    message.header.stamp.secs, message.header.stamp.nsecs = int(t), round(1e9 * (t - int(t)))
    message.tared = True
    for name, value in members.items():
        setattr(message, name, value)
    return message


def packed(message):
    buffer = io.BytesIO()
    message.serialize(buffer)
    return buffer.getvalue()


def log_of(*states):
    log = RunLog()
    log.take([packed(one) for one in states])
    return log


class Messages(unittest.TestCase):
    def test_members_are_those_of_the_message(self):
        states = [state(3.25, hook_load=4e5, in_slips=True, stand_count=7, current_operation="drill" * n, hole_depth=812.5) for n in range(4)]
        rows = Packed(RigState, ("hook_load", "in_slips", "stand_count", "hole_depth")).rows([packed(one) for one in states])
        self.assertEqual([tuple(row) for row in rows], [(3.25, 4e5, True, 7, 812.5)] * 4)

    def test_what_lies_behind_a_text_cannot_be_read(self):
        with self.assertRaisesRegex(KeyError, "operation_number"):
            Packed(RigState, ("operation_number",))

    def test_every_field_is_in_the_message_and_has_a_unit(self):
        Packed(RigState, fields.SEEN)
        for field in fields.FIELDS:
            self.assertIn(field.quantity, SHOWN)
            self.assertIn(field.track, ("", *dict(fields.TRACKS)))
        for *pair, _ in fields.NUMBERS:
            self.assertTrue(set(pair) <= {"", *fields.NAMES})
        self.assertEqual(8, len(fields.NUMBERS))

    def test_faults_under_way_are_sent_when_they_change(self):
        truth = RigTruth(active_faults=["stuck_pipe", "sensor_bias of hook_load"], active_fault_depths=[812.5, math.nan])
        news = [[packed(RigTruth())], [packed(RigTruth()), packed(truth)], [packed(truth)], [packed(RigTruth())]]
        feed = Feed(types.SimpleNamespace(name="rig", live=True, status=lambda: {}, poll=lambda: News([], news.pop(0), None, {})), False, "si")
        found = [[one["entries"] for one in feed.take() if one["type"] == "faults"] for _ in range(4)]
        entries = [{"text": "stuck pipe", "depth": 812.5}, {"text": "sensor bias of hook load", "depth": None}]
        self.assertEqual(found, [[], [entries], [], [[]]])

    def test_what_has_no_zero_is_empty(self):
        rows = Packed(RigState, fields.SEEN).rows([packed(state(1.0, surface_wob=5.0, tared=tared, in_slips=slips))
                                                   for tared, slips in ((True, False), (False, False), (True, True))])
        columns = fields.columns_of(rows)
        numpy.testing.assert_array_equal(columns["wob"], [5.0, math.nan, math.nan])
        numpy.testing.assert_array_equal(columns["differential"], [0.0, math.nan, math.nan])


class Logs(unittest.TestCase):
    def test_no_peak_is_lost(self):
        keys = numpy.arange(0.0, 1000.0, 0.01)
        values = numpy.sin(keys)
        values[12345], values[77777] = 90.0, -80.0
        bins = Bins(["a"], 0.25, most=100)
        for part in numpy.array_split(numpy.arange(len(keys)), 77):
            bins.add(keys[part], {"a": values[part]})
        self.assertLessEqual(len(bins.low), 100)
        self.assertEqual(bins.width, 16.0)
        self.assertEqual(numpy.nanmax(bins.high), 90.0)
        self.assertEqual(numpy.nanmin(bins.low), -80.0)
        self.assertEqual(bins.high[int(keys[12345] // bins.width)], 90.0)
        self.assertAlmostEqual(float(bins.sum.sum()), float(values.sum()), places=6)
        self.assertEqual(bins.count.sum(), len(keys))

    def test_each_step_has_what_falls_into_it(self):
        bins = Bins(["a", "b"], 1.0)
        bins.add([10.2, 10.7, 13.5], {"a": [1.0, 3.0, 5.0], "b": [math.nan, 2.0, math.nan]})
        change = bins.change()
        self.assertEqual((change["from"], change["width"], change["new"]), (10, 1.0, True))
        self.assertEqual(change["signals"]["a"], [[1.0, None, None, 5.0], [2.0, None, None, 5.0], [3.0, None, None, 5.0]])
        self.assertEqual(change["signals"]["b"][1], [2.0, None, None, None])
        self.assertIsNone(bins.change())
        bins.add([13.6], {"a": [9.0], "b": [1.0]})
        self.assertEqual({"width": 1.0, "from": 13, "new": False, "signals": {"a": [[5.0], [7.0], [9.0]], "b": [[1.0], [1.0], [1.0]]}}, bins.change())

    def test_a_new_run_begins_where_time_goes_back_or_the_epoch_changes(self):
        log = log_of(state(5.0), state(6.0), state(0.5))
        self.assertEqual((log.run, log.time.first), (2, 2))
        log.take([packed(state(0.6, epoch=1))])
        self.assertEqual(log.run, 3)
        log.take([packed(state(0.7, epoch=1)), packed(state(0.8, epoch=2))])
        self.assertEqual(log.run, 4)

    def test_the_state_has_the_extremes_since_the_last_time(self):
        log = log_of(state(1.0, torque=1e3), state(1.01, torque=9e3), state(1.02, torque=2e3))
        self.assertEqual(log.take_state()["values"]["torque"], [2e3, 1e3, 9e3])
        log.take([packed(state(1.03, torque=3e3))])
        self.assertEqual(log.take_state()["values"]["torque"], [3e3, 3e3, 3e3])

    def test_depth_log_holds_new_hole(self):
        log = RunLog()
        log.bit_diameter = 0.2
        log.take([packed(state(t, hole_depth=100.0 + 0.05 * max(t - 5.0, 0.0), rop=0.05 * (t > 5.0), surface_wob=3e4)) for t in range(1, 31)])
        self.assertEqual((round(log.depth.first * log.depth.width, 6), len(log.depth.low)), (100.0, 13))
        area = 0.25 * math.pi * 0.2**2
        mse = log.depth.mean()[:, log.depth.names.index("mse")]
        self.assertEqual(numpy.isfinite(mse).tolist(), [False] * 5 + [True] * 8)  # the reading of the rate is a mean over 10 s
        self.assertAlmostEqual(mse[-1], 3e4 / area, places=3)


class Alarm(unittest.TestCase):
    def take(self, alarms, begin, *on):
        alarms.take(numpy.arange(begin, begin + len(on)), {"slack_line": numpy.array(on, dtype=bool)}, ["slack_line"])

    def test_a_short_red_one_stays_until_it_is_acknowledged(self):
        alarms = Alarms()
        self.take(alarms, 0.0, 0, 1, 0)
        entry = alarms.shown()[0]
        self.assertEqual((entry["from"], entry["to"], entry["acknowledged"], entry["rank"]), (1.0, 1.0, False, "red"))
        self.assertTrue(alarms.acknowledge(entry["number"]))
        self.assertTrue(entry["acknowledged"])
        self.assertFalse(alarms.acknowledge(entry["number"]))
        self.assertFalse(alarms.acknowledge(99))

    def test_one_that_lasts_has_no_end(self):
        alarms = Alarms()
        self.take(alarms, 0.0, 0, 1)
        self.take(alarms, 2.0, 1, 1)
        self.assertIsNone(alarms.entries[0]["to"])
        self.take(alarms, 4.0, 0, 0)
        self.assertEqual(alarms.entries[0]["to"], 4.0)

    def test_it_comes_again(self):
        alarms = Alarms()
        self.take(alarms, 0.0, 1, 0)
        self.take(alarms, 5.0, 1, 0)
        self.assertEqual([(one["times"], one["to"]) for one in alarms.entries], [(2, 5.0)])
        self.take(alarms, 50.0, 1, 0)
        self.assertEqual(len(alarms.entries), 2)

    def test_a_caution_that_comes_again_and_again_is_one(self):
        alarms = Alarms()
        for begin in (0.0, 2.0, 4.0, 30.0):
            alarms.take(numpy.array([begin, begin + 1.0]), {"winch_limited": numpy.array([True, False])}, ["winch_limited"])
        self.assertEqual([("amber", 0.0, 4.0, 3), ("amber", 30.0, 30.0, 1)], [(one["rank"], one["from"], one["to"], one["times"]) for one in alarms.entries])


DRILLS = {"rop": 0.01, "top_drive_speed": 6.0, "flow": 0.03}


class Sheets(unittest.TestCase):
    def run_of(self, *pieces):
        """Pieces of seconds and members, in the order of time; the hole grows by its rate of penetration. `off`: bottom [m]."""
        log, now, depth = RunLog(), 0.0, 100.0
        for seconds, given in pieces:
            members = dict(given)
            off, states = members.pop("off", 0.0), []
            for _ in range(int(10 * seconds)):
                now, depth = now + 0.1, depth + 0.1 * members.get("rop", 0.0)
                states.append(packed(state(now, **{**members, "hole_depth": depth, "bit_depth": depth - off})))
            log.take(states)
        return log

    def test_connection_from_weight_to_weight(self):
        up = {"off": 5.0, "flow": 0.03}
        before, after = {"stand_count": 10}, {"stand_count": 11}
        log = self.run_of((60, {**DRILLS, **before}), (20, {**up, **before}), (90, {"off": 5.0, "in_slips": True, **before}), (25, {**up, **after}),
                          (30, {**DRILLS, **after}))
        found = log.activity.connections()
        self.assertEqual(len(found), 1)
        self.assertAlmostEqual(found[0]["in_slips"], 90.0, delta=0.3)
        self.assertAlmostEqual(found[0]["weight_to_weight"], 135.0, delta=0.5)
        self.assertAlmostEqual(found[0]["depth"], 100.6, delta=0.01)

    def test_pipe_taken_away_is_no_connection(self):
        log = self.run_of((30, {"off": 50.0, "stand_count": 10, "block_velocity": 0.3}), (60, {"off": 50.0, "in_slips": True, "stand_count": 10}),
                          (30, {"off": 80.0, "stand_count": 9, "block_velocity": 0.3}))
        self.assertEqual(log.activity.connections(), [])
        self.assertEqual([one["kind"] for one in log.activity.intervals], ["trip", "connection", "trip"])

    def test_slide_sheet(self):
        log = self.run_of((100, DRILLS), (50, {**DRILLS, "top_drive_speed": 0.0, "surface_wob": 4e4}), (100, DRILLS))
        rows = log.activity.sheet(log.time)
        self.assertEqual([row["kind"] for row in rows], ["rotary", "slide", "rotary"])
        self.assertAlmostEqual(rows[1]["depth_to"] - rows[1]["depth_from"], 0.5, delta=0.01)
        self.assertAlmostEqual(rows[1]["rop"], 0.01, delta=1e-3)
        self.assertAlmostEqual(rows[1]["wob"], 4e4, delta=500.0)

    def test_a_change_that_comes_in_small_pieces(self):
        """As a node's readings come: none of the pieces is so long as a change has to last."""
        log = self.run_of(*[(0.2, {"off": 5.0, "flow": 0.03})] * 100, *[(0.2, DRILLS)] * 100, *[(0.2, {**DRILLS, "rop": 0.0})] * 10, *[(0.2, DRILLS)] * 10)
        self.assertEqual([(one["kind"], round(one["from"])) for one in log.activity.intervals], [("circulate", 0), ("rotary", 20)])

    def test_a_short_change_is_none(self):
        log = self.run_of((20, DRILLS), (2, {**DRILLS, "rop": 0.0}), (20, DRILLS))
        self.assertEqual([one["kind"] for one in log.activity.intervals], ["rotary"])

    def test_kinds(self):
        cases = ((DRILLS, "rotary"), ({**DRILLS, "top_drive_speed": 0.0}, "slide"), ({"off": 5.0, "block_velocity": -0.2}, "trip"),
                 ({"off": 5.0, "flow": 0.03, "top_drive_speed": 6.0}, "circulate"), ({"in_slips": True}, "connection"), ({"off": 5.0}, "other"))
        for members, kind in cases:
            self.assertEqual([one["kind"] for one in self.run_of((10, members)).activity.intervals], [kind])


class Shapes(unittest.TestCase):
    plan = numpy.array([[0.0, 0.0, 0.0], [0.0, 0.0, 100.0], [50.0, 0.0, 200.0]])

    def test_deviation_from_plan(self):
        away = shapes.offsets(numpy.array([[3.0, 4.0, 50.0], [25.0, 2.0, 150.0], [60.0, 0.0, 220.0]]), self.plan)
        self.assertEqual([round(value, 6) for value in away[0]], [5.0, 3.0, 4.0])
        self.assertEqual([round(value, 6) for value in away[1]], [2.0, -2.0, 0.0])  # it goes east: north is left
        self.assertTrue(numpy.isnan(away[2]).all())  # beyond the end of the plan

    def test_well(self):
        well = shapes.well_of(self.plan[:2], self.plan)
        self.assertAlmostEqual(well["azimuth"], math.pi / 2)
        self.assertEqual(well["plan"]["section"], [0.0, 0.0, 50.0])
        self.assertEqual(well["deviation"]["distance"], [0.0, 0.0])
        self.assertIsNone(shapes.well_of(self.plan[:0], self.plan[:0])["deviation"])

    def test_string_with_its_bounds(self):
        message = DrillstringState(md=[100.0, 90.0, 80.0], from_bit=[0.0, 10.0, 20.0], tension=[-5e4, -1e4, 3e4], torque=[0.0, 1e3, 2e3],
                                   contact_force=[100.0, 200.0, 0.0], buckling_factor=[0.5, 0.1, 0.0])
        parts = [{"length": 15.0, "diameter": 0.2, "bore": 0.0}, {"length": 0.0, "diameter": 0.1, "bore": 0.0}]
        found = shapes.string_of(message, shapes.Strength(parts, [{"yield_strength": 1e9, "make_up_torque": 5e3}, {}]))
        self.assertEqual(found["critical"], [-1e5, -1e5, None])
        self.assertEqual(found["side"], [10.0, 20.0, 0.0])
        self.assertEqual(found["make_up"], [5e3, 5e3, None])
        self.assertEqual(found["yield"][0], float("%.6g" % (1e9 * 0.25 * math.pi * 0.04)))
        self.assertEqual(found["yield"][2], float("%.6g" % (7.24e8 * 0.25 * math.pi * 0.01)))

    def test_a_scene_that_cannot_be_read(self):
        for text in ("", "string: 3", "string: [3]", "{"):
            self.assertEqual(shapes.parts_of_scene(text), [])


class Stick(unittest.TestCase):
    scene = {"name": "s", "well": {"stations": [[0, 0, 0], [300, 0, 0], [600, 40, 0]], "hole_depth": 600.0,
                                   "sections": [{"to": 600.0, "diameter": 0.2159, "friction": 0.25}]},
             "formation": [{"to_tvd": 10000.0, "drillability": 1e-8}], "start": {"bit_depth": 599.0, "block_height": 20.0, "weight_on_bit": 5.0},
             "numerics": {"level": "axial_torsional"}, "instruments": {"surface": {"hook_load": {"place": "block"}}},
             "string": [{"name": "bit", "type": "bit", "length": 0.3, "mass": 40.0, "diameter": 0.2159},
                        {"name": "pipe", "type": "pipe", "joints": "fill", "joint_length": 9.5, "outer_diameter": 0.127, "inner_diameter": 0.1086,
                         "linear_mass": 31.9}]}

    def test_scene_at(self):
        changed = scene_at(self.scene, 300.0, 1.5)
        self.assertEqual(changed["start"], {"bit_depth": 300.0, "block_height": 20.0, "weight_on_bit": 0.0, "torque_on_bit": 0.0})
        self.assertEqual((changed["well"]["sections"][0]["friction"], self.scene["well"]["sections"][0]["friction"]), (0.375, 0.25))
        self.assertEqual(self.scene["well"]["stations"], changed["well"]["stations"])

    def test_a_hole_that_became_deeper_goes_on_straight(self):
        deeper = scene_at(self.scene, 699.0, 1.0)["well"]
        self.assertEqual(([600, 40, 0], [700.0, 40, 0], 700.0, 700.0), (*deeper["stations"][-2:], deeper["hole_depth"], deeper["sections"][0]["to"]))
        self.assertEqual((3, 600.0), (len(self.scene["well"]["stations"]), self.scene["well"]["sections"][0]["to"]))

    def test_weights_part_with_depth_and_friction(self):
        try:
            from drill_rig_sim.sim import static  # noqa: F401  pylint: disable=unused-import
        except ImportError:
            self.skipTest("the Python module sim is not built")
        loads = {(one["factor"], one["motion"], round(one["depth"])): one["load"] for one in points(self.scene, 600.0)}
        deep = round(599.0)
        self.assertGreater(loads[1.0, "up", deep], loads[1.0, "rotate", deep])
        self.assertGreater(loads[1.0, "rotate", deep], loads[1.0, "down", deep])
        self.assertGreater(loads[1.5, "up", deep], loads[1.0, "up", deep])
        self.assertGreater(loads[1.0, "up", deep], loads[1.0, "up", round(0.55 * 599.0)])
        self.assertNotIn(None, loads.values())

    def test_the_curves_have_the_drag_of_the_mud_as_the_measured_weights_have(self):
        weights = [{"motion": "up", "speed": speed, "rotation": 0.001, "flow": 0.0} for speed in (0.3, 0.4, 0.9)]
        weights += [{"motion": "rotate", "speed": 1e-4, "rotation": 6.0, "flow": 0.03}]
        ways = ways_of(weights)
        self.assertEqual({"up": {"speed": 0.4, "rotation": 0.0, "flow": 0.0}, "rotate": {"speed": 0.0, "rotation": 6.0, "flow": 0.03}}, ways)
        try:
            from drill_rig_sim.sim import static  # noqa: F401  pylint: disable=unused-import
        except ImportError:
            self.skipTest("the Python module sim is not built")
        scene = {**self.scene, "mud": {"viscosity": 0.1}}
        still, moved = ({one["motion"]: one["load"] for one in points(scene, 600.0, known) if one["factor"] == 1.0 and one["depth"] == 599.0}
                        for known in ({}, ways))
        self.assertGreater(moved["up"], still["up"] + 2e3)
        self.assertEqual(still["down"], moved["down"])  # not measured
        self.assertLess(moved["rotate"], still["rotate"])  # the pump lifts


class Hands:
    """Takes orders down."""

    def __init__(self):
        self.orders = []

    def __getattr__(self, name):
        return lambda *words: self.orders.append(name) or ""


class Lag(unittest.TestCase):
    """Readings that wait in a socket are late, and must not be shown as the present."""

    def source(self, state_at, *strings):
        source = NodeSource("rig")
        for kind, topic, stamp in [(DrillstringState, "drillstring_state", one) for one in strings]:
            message = kind()
            message.header.stamp = rospy.Time.from_sec(stamp)
            source._take(self.any(message), topic)  # pylint: disable=protected-access
        source._take_state(self.any(state(state_at)))  # pylint: disable=protected-access
        return source

    @staticmethod
    def any(message):
        return types.SimpleNamespace(_buff=packed(message), _connection_header={"md5sum": message._md5sum})  # pylint: disable=protected-access

    def test_in_time(self):
        self.assertEqual(self.source(5.0, 4.9, 5.0).lag(), 0.0)

    def test_late(self):
        source = self.source(5.0, 5.0, 6.0)
        time.sleep(0.1)
        self.assertGreater(source.lag(), 0.09)
        source._take_state(self.any(state(6.1)))  # pylint: disable=protected-access
        self.assertEqual(source.lag(), 0.0)

    def test_another_run(self):
        source = self.source(100.0, 99.9, 100.0)
        source._take_state(self.any(state(0.1)))  # pylint: disable=protected-access
        self.assertEqual(source.lag(), 0.0)

    def test_another_version(self):
        source = NodeSource("rig")
        message = self.any(state(1.0))
        message._connection_header["md5sum"] = "x"  # pylint: disable=protected-access
        source._take_state(message)  # pylint: disable=protected-access
        self.assertEqual(source.poll().states, [])

    def test_a_node_that_has_gone_is_heard_again_with_its_first_message_only(self):
        """Another node may come before the last message is old: until it sends, what is shown is the old one's."""
        source = NodeSource("rig")
        source._master = 1  # pylint: disable=protected-access
        for connected, came, heard, why in ((True, True, True, ""), (False, False, False, "no node publishes rig_state"),
                                            (True, False, False, "waiting for the node's first data"), (True, True, True, "")):
            source._is_connected = lambda connected=connected: connected  # pylint: disable=protected-access
            if came:
                source._take_state(self.any(state(1.0)))  # pylint: disable=protected-access
            status = source.status()
            self.assertEqual((status["heard"], status["why"]), (heard, why))


class Order(unittest.TestCase):
    def answer(self, hands, **order):
        return asyncio.run(Orders(Feed(None, False, "si"), hands).take("page", order))

    def test_read_only(self):
        for kind in ("hold", "set", "call", "start_law"):
            self.assertEqual(self.answer(None, type=kind), "read-only: start drill web with --control")
        self.assertEqual(self.answer(None, type="acknowledge"), "no such alarm")

    def test_control(self):
        hands = Hands()
        self.assertEqual(self.answer(hands, type="hold", velocity=0.1), "")
        self.assertEqual(hands.orders, ["hold"])
        for kind in ("__init__", "join", None, 3, ["hold"]):
            self.assertRegex(self.answer(hands, type=kind), "^unknown command: ")

    def test_numbers(self):
        self.assertEqual(number_of({"a": 2}, "a", 0, 3), 2.0)
        for bad in (None, "2", True, math.nan, math.inf, 4, -1, [1]):
            with self.assertRaisesRegex(Refused, "^a must be a number from 0 to 3$"):
                number_of({"a": bad}, "a", 0, 3)


if __name__ == "__main__":
    skips.main()
