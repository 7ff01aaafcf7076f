#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What wits0_server sends, against the topics it is made of; a client that never reads holds up neither the rig nor another client."""
import math
import re
import select
import socket
import xmlrpc.client

import rosgraph
from drill_rig_sim.msg import MwdSurvey, MwdToolface, RigState
from rig_test import PATIENCE, Rig, flow, rospy, run, turn, unittest, wait_until, winch

RECORD = re.compile(rb"&&\r\n((?:\d{4}-?[\d.]+\r\n)+)!!\r\n")


class Listener:
    """A client; its records as {item: text}, apart by record."""

    def __init__(self, port):
        self.connection = socket.create_connection(("127.0.0.1", port), PATIENCE)
        self.data = b""

    def until(self, condition):
        """The records, once condition(records) holds."""
        while not condition(self.records()):
            part = self.connection.recv(65536)
            assert part, "the server has gone"
            self.data += part
        return self.records()

    def records(self):
        found = []
        for match in RECORD.finditer(self.data):
            lines = match.group(1).decode().split("\r\n")[:-1]
            numbers = {line[:2] for line in lines}
            assert len(numbers) == 1, lines
            found.append((int(numbers.pop()), {int(line[2:4]): line[4:] for line in lines}))
        return found


class Wits0(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.rig = Rig()
        cls.port = wait_until(lambda: rospy.get_param("/rig/wits0_server/port", 0), "the server listens")
        cls.states = cls.rig.collect("rig_state", RigState)
        topics = {"/rig/rig_state", "/rig/downhole/mwd", "/rig/downhole/toolface"}
        wait_until(lambda: topics <= cls.heard_by_the_server(), "the server hears the rig")

    @staticmethod
    def heard_by_the_server():
        """Topics of the rig that the server is connected to."""
        master = rosgraph.Master(rospy.get_name())
        _, _, connections = xmlrpc.client.ServerProxy(master.lookupNode("/rig/rig_simulator")).getBusInfo(rospy.get_name())
        return {c[4] for c in connections if c[1] == "/rig/wits0_server"}

    def setUp(self):
        self.rig.must(self.rig.reset_well("", 0.0))
        self.client = Listener(self.port)
        self.addCleanup(self.client.connection.close)
        wait_until(self.is_known, "the server knows the client")

    def is_known(self):
        """Whether the next records came to the client."""
        self.rig.advance(100)
        readable, _, _ = select.select([self.client.connection], [], [], 0.5)
        return bool(readable)

    def test_the_general_record_is_a_rig_state(self):
        self.rig.must(self.rig.tare())
        first = self.rig.advance(100, winch=winch(-0.004), top_drive=turn(6.0), mud_pump=flow(0.02)).header.stamp
        last = self.rig.advance(2900).header.stamp
        records = self.client.until(lambda records: sum(number == 1 for number, _ in records) >= 30)
        states = {tuple(self.expected(m)): m for m in self.states.wait_until(lambda m: m and m[-1].header.stamp >= last)}
        matched = [states[tuple(items[item] for item in sorted(items))] for number, items in records
                   if number == 1 and tuple(items[item] for item in sorted(items)) in states]
        self.assertGreaterEqual(len(matched), 30, "each is a state of the rig")
        self.assertTrue(any(m.header.stamp > first and m.rop > 0.0 and m.surface_wob > 1e3 for m in matched))
        steps = {round((b.header.stamp - a.header.stamp).to_sec(), 6) for a, b in zip(matched, matched[1:]) if a.header.stamp > first}
        self.assertEqual({1.0}, steps)

    @staticmethod
    def expected(state):
        """The texts of a record's items in their order, worked out from the message."""
        moment = rospy.Time.to_sec(state.header.stamp)
        clock = "%02d%02d%02d" % (moment // 3600, moment // 60 % 60, moment % 60)
        kdn = 1e-4
        numbers = [state.bit_depth, state.hole_depth, state.block_height, state.rop * 3600.0, state.hook_load * kdn]
        numbers += [state.surface_wob * kdn] if state.tared else []
        numbers += [state.torque / 1e3]
        return (["000101", clock] + ["%.3f" % number for number in numbers] + ["%d" % round(state.top_drive_speed * 60.0 / (2.0 * math.pi))] +
                ["%.3f" % (state.stand_pipe_pressure / 1e3), "%d" % round(60.0 * state.stroke_rate), "%.3f" % (state.flow * 60000.0)])

    def test_surveys_and_toolfaces(self):
        surveys, toolfaces = self.rig.collect("downhole/mwd", MwdSurvey), self.rig.collect("downhole/toolface", MwdToolface)
        self.rig.advance(1000, mud_pump=flow(0.02))
        survey, toolface = surveys.wait(1)[0], toolfaces.wait(1)[0]
        self.assertEqual(MwdToolface.GRAVITY, toolface.reference)
        records = self.client.until(lambda records: any(8 in items for number, items in records if number == 7) and
                                    any(17 in items for number, items in records if number == 7))
        found = [items for number, items in records if number == 7 and 8 in items][0]
        self.assertEqual(["%.3f" % survey.md, "%.3f" % math.degrees(survey.inclination), "%.3f" % math.degrees(survey.azimuth)],
                         [found[8], found[13], found[15]])
        found = [items for number, items in records if number == 7 and 17 in items][0]
        self.assertEqual("%.3f" % (math.degrees(toolface.toolface) % 360.0), found[17])
        for topic in (surveys, toolfaces):
            topic.subscriber.unregister()

    def test_these_items_and_no_others(self):
        self.rig.must(self.rig.tare())
        self.rig.advance(300)
        records = self.client.until(lambda records: any(16 in items for _, items in records))
        self.assertEqual([5, 6, 8, 10, 12, 13, 14, 16, 18, 20, 21, 23, 30], sorted([items for number, items in records if number == 1][-1]))

    def test_a_client_that_never_reads_holds_up_nobody(self):
        deaf = socket.socket()
        self.addCleanup(deaf.close)
        deaf.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 2048)
        deaf.connect(("127.0.0.1", self.port))
        deaf.sendall(b"&&\r\n0108123\r\n!!\r\n" * 1000)
        before = len(self.client.records())
        self.rig.advance(20000)  # 200 s
        records = self.client.until(lambda records: len(records) >= before + 150)
        self.assertGreaterEqual(len(records), before + 150)
        self.assertNotIn("123", [items.get(8) for _, items in records])
        Listener(self.port).connection.close()  # others still come in


if __name__ == "__main__":
    run(Wits0)
