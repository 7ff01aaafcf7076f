#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The whole interface against test/interface_contract.yaml: names, types, directions, latching."""
import io
import os
import socket
import urllib.parse
import xmlrpc.client

import rosgraph
import rosgraph.network
import yaml
from rig_test import PACKAGE_DIR, PATIENCE, Rig, rospy, run, unittest

NODE = "/rig/rig_simulator"
OF_EVERY_NODE = {"/rosout"}


def absolute(name):
    return name if name.startswith("/") else "/rig/" + name


class Contract(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        Rig()
        with open(os.path.join(PACKAGE_DIR, "test", "interface_contract.yaml")) as file:
            cls.contract = yaml.safe_load(file)
        cls.master = rosgraph.Master(rospy.get_name())
        cls.publications, cls.subscriptions, cls.services = (
            {name for name, nodes in group if NODE in nodes} for group in cls.master.getSystemState())
        cls.types = dict(cls.master.getTopicTypes())

    def test_publishes_exactly_the_topics(self):
        self.assertEqual({absolute(name) for name in self.contract["publishes"]}, self.publications - OF_EVERY_NODE)

    def test_subscribes_to_exactly_these(self):
        self.assertEqual({absolute(name) for name in self.contract["subscribes"]}, self.subscriptions - {"/clock"})

    def test_topics_have_their_types(self):
        for group in ("publishes", "subscribes"):
            for name, kind in self.contract[group].items():
                self.assertEqual(kind, self.types[absolute(name)], name)

    def test_serves_exactly_the_services(self):
        of_roscpp = {NODE + "/get_loggers", NODE + "/set_logger_level"}
        self.assertEqual({absolute(name) for name in self.contract["serves"]}, self.services - of_roscpp)

    def test_services_have_their_types(self):
        for name, kind in self.contract["serves"].items():
            self.assertEqual(kind, self.probe(absolute(name))["type"], name)

    def probe(self, service):
        """The header that a service answers a probe with."""
        uri = urllib.parse.urlparse(self.master.lookupService(service))
        with socket.create_connection((uri.hostname, uri.port), PATIENCE) as connection:
            rosgraph.network.write_ros_handshake_header(
                connection, {"probe": "1", "md5sum": "*", "callerid": rospy.get_name(), "service": service})
            return rosgraph.network.read_ros_handshake_header(connection, io.BytesIO(), 2048)

    def test_what_is_said_once_is_latched_and_nothing_else(self):
        latched = {absolute(name) for name in self.contract["latched"]}
        for name in self.contract["publishes"]:
            header = self.publisher_header(absolute(name), self.types[absolute(name)])
            self.assertEqual("1" if absolute(name) in latched else "0", header.get("latching", "0"), name)

    def publisher_header(self, topic, kind):
        """The header that the node answers a subscription with."""
        api = xmlrpc.client.ServerProxy(self.master.lookupNode(NODE))
        _, _, (_, host, port) = api.requestTopic(rospy.get_name(), topic, [["TCPROS"]])
        with socket.create_connection((host, port), PATIENCE) as connection:
            rosgraph.network.write_ros_handshake_header(
                connection, {"topic": topic, "md5sum": "*", "type": kind, "callerid": rospy.get_name()})
            return rosgraph.network.read_ros_handshake_header(connection, io.BytesIO(), 2048)


if __name__ == "__main__":
    run(Contract)
