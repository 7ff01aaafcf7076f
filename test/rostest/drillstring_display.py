#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The display Drillstring with config/rviz/rig.rviz against the running node, under a virtual X server: what is to be seen at two window sizes, a node
that is killed and comes back, messages that cannot be drawn, subscriptions of what is shown alone. Screenshots stay in the
build folder as display_*_seen.png."""
import copy
import os
import signal
import xmlrpc.client

import rosgraph
from drill_rig_sim.msg import DrillstringState, RigDescription
from geometry_msgs.msg import PoseStamped
from nav_msgs.msg import Path
from rig_test import PACKAGE_DIR, PATIENCE, Rig, rospy, run, time, unittest, wait_until
from rviz_window import FOLDER, Window
from string_picture import all_seen, is_string, measured

CONFIG = os.path.join(PACKAGE_DIR, "config", "rviz", "rig.rviz")
VIEW = (20, 66, 570, 766)  # of a window of 1280x800, where the string is drawn: the legend is to its right, then the console
MIDDLE = 402  # of the picture, in that view
TOPICS = ["/rig/drillstring_state", "/rig/rig_description", "/rig/trajectory"]
LEGEND = (594, 76, 814, 456)


def who_hears(topic):
    """Names of the nodes that subscribe to it."""
    return dict(rosgraph.Master(rospy.get_name()).getSystemState()[1]).get(topic, [])


class DrillstringDisplay(unittest.TestCase):
    def setUp(self):
        self.rig = Rig()
        self.rig.must(self.rig.reset_well("bohai.yaml", 0.0))

    def test_one_window_through_all(self):
        """What is seen and heard at first, messages that cannot be drawn, a node that is killed and comes back, the end."""
        window, hears = self.opened("display_1280", "rig.rviz")
        window.wait_until(measured, all_seen)
        window.view = LEGEND
        legend = window.wait_until(measured, lambda seen: seen["writing"] > 300)
        self.assertGreater(legend["string"], 2000)  # its bar
        window.view = VIEW
        wait_until(lambda: all(hears(topic) for topic in TOPICS), "rviz hears " + ", ".join(TOPICS))
        self.refuses_bad_messages(window)
        self.shows_a_node_that_comes_back(window)
        self.assertNotIn(window.close(), (134, 139), "rviz crashed before SIGTERM ended it")

    def test_all_is_seen_at_1920x1080(self):
        with open(CONFIG) as f:
            config = f.read().replace("Width: 1280", "Width: 1920").replace("Height: 800", "Height: 1080")
        file = os.path.join(FOLDER, "display_1920.rviz")
        with open(file, "w") as f:
            f.write(config)
        window = Window(self, "display_1920", file, 1920, 1080, (20, 66, 1230, 1040))
        window.wait_until(measured, all_seen)

    def shows_a_node_that_comes_back(self, window):
        node = xmlrpc.client.ServerProxy(rosgraph.Master(rospy.get_name()).lookupNode("/rig/rig_simulator"))
        os.kill(node.getPid(rospy.get_name())[2], signal.SIGKILL)
        time.sleep(2)
        self.assertTrue(window.runs())
        rig = Rig()  # roslaunch has started another
        wait_until(lambda: self.answers(rig), "the node is back")
        # another rig, and another picture: the string is upright, and the camera has gone to its bit, so that all of it is in the middle
        window.wait_until(lambda picture: [x - MIDDLE for x, _ in picture.places(is_string)],
                          lambda places: len(places) > 1000 and min(places) > -100 and max(places) < 100)

    @staticmethod
    def answers(rig):
        try:
            return rig.reset_well("quick.yaml", 0.0).success
        except rospy.ServiceException:
            return False

    def refuses_bad_messages(self, window):
        good = rospy.wait_for_message("/rig/drillstring_state", DrillstringState, PATIENCE)
        short, infinite = copy.deepcopy(good), copy.deepcopy(good)
        short.torque = short.torque[1:]
        infinite.position[3].x = float("inf")
        rig = RigDescription()
        rig.header.frame_id, rig.part_name, rig.station_md = "rig_floor", ["half a part"], [1.0]
        path = Path(poses=[PoseStamped()])  # with a quaternion of zeros
        for topic, kind, messages in (("drillstring_state", DrillstringState, [short, infinite, DrillstringState()]),
                                      ("rig_description", RigDescription, [rig, RigDescription()]), ("trajectory", Path, [path, Path()])):
            publisher = rospy.Publisher("/rig/" + topic, kind, queue_size=10)
            wait_until(lambda: publisher.get_num_connections() > 0, "rviz hears another publisher")  # noqa: B023
            for message in 5 * messages:
                publisher.publish(message)
                time.sleep(0.1)
            publisher.unregister()
        window.wait_until(measured, all_seen)

    def opened(self, name, config):
        """A window, and what tells whether its rviz hears a topic: those of windows before are still known to the master."""
        before = {topic: who_hears(topic) for topic in TOPICS + ["/tf"]}
        window = Window(self, name, config, 1280, 800, VIEW)
        return window, lambda topic: any(node.startswith("/rviz") and node not in before[topic] for node in who_hears(topic))

    def test_hears_nothing_that_is_not_shown(self):
        with open(CONFIG) as f:
            config = f.read()
        shown = "Enabled: true\n      Value: true\n      Topic"
        self.assertIn(shown, config)
        file = os.path.join(FOLDER, "display_off.rviz")
        with open(file, "w") as f:
            f.write(config.replace(shown, shown.replace("true", "false")))
        window, hears = self.opened("display_off", file)
        wait_until(lambda: hears("/tf"), "rviz runs")
        time.sleep(3)
        for topic in TOPICS:
            self.assertFalse(hears(topic), topic)
        window.end()


if __name__ == "__main__":
    run(DrillstringDisplay)
