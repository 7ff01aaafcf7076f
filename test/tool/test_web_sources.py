#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Bags and time series as sources of `drill web`, and the page as one file with a run inside. No master, no browser."""
import json
import os
import re
import tempfile
import unittest
import unittest.mock

import numpy
import rospy
import skips
from diagnostic_msgs.msg import DiagnosticArray, DiagnosticStatus, KeyValue
from drill_rig_sim.msg import RigLimits
from drill_rig_sim.score_runs import Run, RunError
from drill_rig_sim.survey import Survey
from drill_rig_sim.web import offline
from drill_rig_sim.web.bag_source import BagSource
from drill_rig_sim.web.feed import Feed
from drill_rig_sim.web.series_source import SeriesSource
from std_msgs.msg import String
from test_web import state

try:
    import rosbag
except ImportError:
    rosbag = None


def drilled_run(**more):
    """100 s of drilling 2 m straight down from 1000 m."""
    time = numpy.arange(0.0, 100.05, 0.1)
    depth = 1000.0 + 0.02 * time
    steady = {"wob": 5e4, "torque": 5e3, "rop": 0.02, "top_drive_speed": 10.0, "hook_load": 9e5, "bit_east": 3.0, "bit_north": 4.0}
    columns = {name: numpy.full_like(time, value) for name, value in steady.items()}
    columns.update(time=time, hole_depth=depth, bit_depth=depth, bit_up=-depth)
    return Run({**columns, **more}, name="made_up.csv")


def taken(source):
    feed = Feed(source, False, "si")
    feed.take()
    return feed


@unittest.skipIf(rosbag is None, "python3-rosbag is not installed")
class Bags(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.file = os.path.join(folder.name, "run.bag")

    def write(self, *messages):
        """Topic, message, time [s]."""
        with rosbag.Bag(self.file, "w") as bag:
            for topic, message, time in messages:
                bag.write(topic, message, rospy.Time.from_sec(time))

    def test_a_bag(self):
        physics = DiagnosticStatus(name="rig/rig_simulator: physics", hardware_id="rig/rig_simulator", values=[KeyValue(key="pull_to_yield", value="9e5")])
        self.write(("/rig/rig_limits", RigLimits(max_hook_load=2e6), 0.5), ("/diagnostics", DiagnosticArray(status=[physics]), 3.5),
                   ("/diagnostics", DiagnosticArray(), 3.9),
                   *(("/rig/rig_state", state(t, hook_load=1e5 * t, slack_line=t == 3.0), t) for t in (1.0, 2.0, 3.0, 4.0)))
        feed = taken(BagSource(self.file))
        found = {message["type"]: message for message in feed.whole()}
        self.assertEqual(found["limits"]["hook_load"], 2e6)
        self.assertEqual(found["margin"]["pull_to_yield"], 9e5)
        self.assertEqual(found["bins"]["signals"]["hook_load"][2][::4], [1e5, 2e5, 3e5, 4e5])
        self.assertEqual([one["flag"] for one in found["alarms"]["entries"]], ["slack_line"])
        self.assertFalse(found["hello"]["live"])

    def test_the_last_run_of_a_bag(self):
        """Time goes back where the node was started again; the bag is in the order of its recording."""
        self.write(*(("/rig/rig_state", state(t), t) for t in (1.0, 2.0, 3.0, 0.5, 1.5)))
        log = taken(BagSource(self.file)).log
        self.assertEqual((log.run, log.time.first, float(log.last["stamp"])), (2, 2, 1.5))

    def test_what_is_refused(self):
        self.write(("/rig/scene", String("a"), 1.0))
        with self.assertRaisesRegex(RunError, "has no rig_state"):
            BagSource(self.file)
        self.write(("/rig/rig_state", String("a"), 1.0))
        with self.assertRaisesRegex(RunError, "/rig/rig_state is of another version of drill_rig_sim/RigState"):
            BagSource(self.file)
        with open(self.file, "w", encoding="utf-8") as out:
            out.write("no bag")
        with self.assertRaisesRegex(RunError, "run.bag: "):
            BagSource(self.file)

    def test_several_rigs(self):
        self.write(("/a/rig_state", state(1.0), 1.0), ("/b/rig_state", state(1.0, hook_load=7.0), 1.0))
        with self.assertRaisesRegex(RunError, "--namespace with one of a, b"):
            BagSource(self.file)
        self.assertEqual(float(taken(BagSource(self.file, "b")).log.last["hook_load"]), 7.0)


class Series(unittest.TestCase):
    def test_a_series(self):
        feed = taken(SeriesSource(drilled_run()))
        self.assertEqual(len(feed.log.time.low), 401)
        self.assertAlmostEqual(feed.log.depth.width * len(feed.log.depth.low), 2.0, delta=0.2)
        self.assertEqual([one["kind"] for one in feed.log.activity.intervals], ["rotary"])
        self.assertAlmostEqual(feed.log.time.mean()[0, feed.log.time.names.index("wob")], 5e4)

    def test_deviation_from_a_plan(self):
        plan = Survey([0.0, 2000.0], [0.0, 0.0], [0.0, 0.0])
        deviation = taken(SeriesSource(drilled_run(), plan)).described["well"]["deviation"]
        self.assertEqual({round(value, 6) for value in deviation["distance"]}, {5.0})
        self.assertAlmostEqual(deviation["depth"][0], 1000.0, delta=0.1)
        self.assertAlmostEqual(deviation["depth"][-1], 1002.0, delta=0.1)

    def test_a_connection_without_a_count_of_stands(self):
        slips = (numpy.arange(0.0, 100.05, 0.1) > 40.0) & (numpy.arange(0.0, 100.05, 0.1) < 60.0)
        feed = taken(SeriesSource(drilled_run(in_slips=slips.astype(float))))
        self.assertEqual([round(one["in_slips"]) for one in feed.log.activity.connections()], [20])


    def test_pipe_that_is_removed_is_no_connection_where_stands_are_counted(self):
        """A stand is added, one removed and one added again, all between drilling and drilling."""
        time = numpy.arange(0.0, 100.05, 0.1)
        slips, stands = numpy.zeros(len(time)), numpy.full(len(time), 30.0)
        for begin, change in ((20.0, 1), (40.0, -1), (60.0, 1)):
            slips[(time > begin) & (time < begin + 10.0)] = 1.0
            stands[time > begin + 5.0] += change
        feed = taken(SeriesSource(drilled_run(in_slips=slips, stand_count=stands)))
        self.assertEqual([20, 60], [round(one["time"]) for one in feed.log.activity.connections()])


class Offline(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        library = os.path.join(folder.name, "chart.js")
        with open(library, "w", encoding="utf-8") as out:
            out.write("window.Chart = '</script>';")
        environment = unittest.mock.patch.dict(os.environ, DRILL_RIG_SIM_CHART_JS=library)
        environment.start()
        self.addCleanup(environment.stop)

    def test_the_page_needs_no_other_file(self):
        page = offline.page_of(SeriesSource(drilled_run()), "si")
        self.assertEqual(re.findall(r'(?:src|href)="(?!data:)[^"]*"', page), [])
        self.assertNotRegex(page, r"(?m)^(?:import|export) ")
        self.assertEqual(len(re.findall("</script>", page)), 3)
        messages = json.loads(re.search(r'id="run">(.*?)</script>', page, re.DOTALL).group(1))
        self.assertEqual(messages[0]["type"], "hello")
        self.assertEqual(messages[-1]["type"], "state")
        self.assertAlmostEqual(messages[-1]["t"], 100.0)

    def test_a_name_cannot_end_the_script(self):
        run = drilled_run()
        run.title = "</script><!--<b>"
        page = offline.page_of(SeriesSource(run), "si")
        self.assertEqual(len(re.findall("</script>", page)), 3)
        self.assertNotIn("<!--<b>", page)

    def test_each_module_stands_after_what_it_needs(self):
        order = offline.in_order("main.js")
        self.assertEqual(len(order), len(set(order)))
        self.assertEqual(sorted(order), sorted(name for name in os.listdir(offline.FOLDER) if name.endswith(".js")))
        for name in order:
            for _, other in offline.IMPORT.findall(offline.read(name)):
                self.assertLess(order.index(other), order.index(name))

    def test_what_is_imported_is_exported(self):
        for name in offline.in_order("main.js"):
            for names, other in offline.IMPORT.findall(offline.read(name)):
                exported = offline.EXPORTED.findall(offline.read(other))
                for one in re.findall(r"\w+", names):
                    self.assertIn(one, exported, "%s of %s" % (one, name))
                    self.assertGreater(len(re.findall(r"\b%s\b" % one, offline.read(name))), 1, "%s is not used by %s" % (one, name))

    def test_numbers_are_json(self):
        page = offline.page_of(SeriesSource(drilled_run()), "oilfield")  # its flow is not known
        self.assertNotIn("NaN", re.search(r'id="run">(.*?)</script>', page, re.DOTALL).group(1))


if __name__ == "__main__":
    skips.main()
