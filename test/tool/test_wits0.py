#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""WITS level 0: records of known values, and a server whose clients are slow, deaf, loud or gone. Needs no node."""
import math
import socket
import time
import unittest

import rospy
from drill_rig_sim import wits0
from drill_rig_sim.msg import MwdSurvey, MwdToolface, RigState

PATIENCE = 30.0  # wall seconds that anything may take on a loaded machine


def stamped(message, seconds=86400.0 + 3723.5):
    message.header.stamp = rospy.Time.from_sec(seconds)
    return message


class Records(unittest.TestCase):
    def test_the_general_record(self):
        state = stamped(RigState(bit_depth=729.0, hole_depth=730.0, block_height=34.1234, rop=0.01, hook_load=325e3, surface_wob=75e3, tared=True,
                                 torque=6290.0, top_drive_speed=2.0 * math.pi, stand_pipe_pressure=14.4e6, flow=0.045, stroke_rate=1.75))
        self.assertEqual("&&\r\n0105000102\r\n0106010203\r\n0108729.000\r\n0110730.000\r\n011234.123\r\n011336.000\r\n011432.500\r\n01167.500\r\n"
                         "01186.290\r\n012060\r\n012114400.000\r\n0123105\r\n01302700.000\r\n!!\r\n", wits0.general_record(state).decode())

    def test_the_date_of_time_0_can_be_set(self):
        state = stamped(RigState())
        for text, there in (("2024-02-28", "240229"), ("1999-12-31T23:00:00Z", "000102"), (wits0.START_DATE, "000102")):
            shown = wits0.general_record(state, wits0.start_date_of(text)).decode()
            self.assertIn("\n0105%s\r" % there, shown)
        for bad in ("2023-02-29", "1969-12-31", "2200-01-01", "2024-05-17T06:30:00+02:00", "2024-5-17", "", "17.05.2024"):
            with self.assertRaisesRegex(ValueError, "a UTC date from 1970 to 2199"):
                wits0.start_date_of(bad)

    def test_stamps_of_wall_time_are_dates(self):
        state = stamped(RigState())
        state.header.stamp = rospy.Time(1714521600)
        self.assertIn("\n0105240501\r\n0106000000\r", wits0.general_record(state).decode())

    def test_no_weight_before_it_is_tared(self):
        self.assertNotIn("\n0116", wits0.general_record(stamped(RigState())).decode())

    def test_the_survey_record(self):
        survey = stamped(MwdSurvey(md=712.25, inclination=math.radians(51.0), azimuth=math.radians(297.0)))
        self.assertEqual("&&\r\n0705000102\r\n0706010203\r\n0708712.250\r\n071351.000\r\n0715297.000\r\n!!\r\n", wits0.survey_record(survey).decode())

    def test_toolfaces_by_their_reference(self):
        toolface = stamped(MwdToolface(toolface=math.radians(-90.0)))
        self.assertIn("\r\n0717270.000\r\n", wits0.toolface_record(toolface).decode())
        toolface.reference = MwdToolface.MAGNETIC
        self.assertIn("\r\n0716270.000\r\n", wits0.toolface_record(toolface).decode())


class Clients(unittest.TestCase):
    def setUp(self):
        self.said = []
        self.server = wits0.Server("127.0.0.1", 0, self.said.append)
        self.addCleanup(self.server.close)

    def until(self, condition, what):
        deadline = time.monotonic() + PATIENCE
        while not condition():
            self.assertLess(time.monotonic(), deadline, what)
            time.sleep(0.005)

    def client(self, small=False):
        """Connected and known to the server."""
        connection = socket.socket()
        self.addCleanup(connection.close)
        if small:
            connection.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4096)
        connection.settimeout(PATIENCE)
        known = len(self.server.clients)
        connection.connect(("127.0.0.1", self.server.port))
        self.until(lambda: len(self.server.clients) > known, "the server knows the client")
        return connection

    @staticmethod
    def read(connection, size):
        data = b""
        while len(data) < size:
            part = connection.recv(65536)
            if not part:
                break
            data += part
        return data

    def records(self, count, begin=0):
        return [wits0.record(1, 0.0, [(8, "%d" % i), (41, 500 * "x")]) for i in range(begin, begin + count)]

    def test_every_client_gets_every_record(self):
        clients = [self.client(), self.client()]
        records = self.records(20)
        for record in records:
            self.server.send(record)
        for connection in clients:
            self.assertEqual(b"".join(records), self.read(connection, sum(map(len, records))))

    def test_nobody_there(self):
        for record in self.records(1000):
            self.server.send(record)
        self.assertEqual(0, self.server.dropped)

    def test_a_client_that_never_reads_loses_records_and_holds_up_nobody(self):
        deaf, good = self.client(small=True), self.client()
        number, begin = 0, time.monotonic()
        while not self.server.dropped and time.monotonic() - begin < PATIENCE:
            records = self.records(50, number)
            number += 50
            for record in records:
                self.server.send(record)
            self.assertEqual(b"".join(records), self.read(good, sum(map(len, records))))
        self.assertGreater(self.server.dropped, 0)
        self.assertLessEqual(max(len(client.waiting) for client in self.server.clients), wits0.MOST_WAITING)
        self.assertEqual(1, sum("does not read" in text for text in self.said))
        dropped = self.server.dropped
        begin = time.monotonic()
        for record in self.records(1000, number):  # send() never waits
            self.server.send(record)
        self.assertLess(time.monotonic() - begin, PATIENCE)
        self.assertGreater(self.server.dropped, dropped)
        # what it gets when it wakes up after all are whole records
        deaf.settimeout(1.0)
        heard = b""
        try:
            while True:
                heard += deaf.recv(65536)
        except socket.timeout:
            pass
        self.assertEqual(heard.count(b"&&\r\n"), heard.count(b"!!\r\n"))
        self.assertTrue(heard.endswith(b"!!\r\n"))
        deaf.close()
        self.until(lambda: any("records were dropped" in text for text in self.said), "its end is told with the count")

    def test_a_client_that_talks_is_not_listened_to(self):
        loud, good = self.client(), self.client()
        loud.settimeout(0.2)
        sent = 0
        begin = time.monotonic()
        try:
            while time.monotonic() - begin < 2.0:
                sent += loud.send(b"&&\r\n0108999\r\n!!\r\n\x00\xff" * 4096)
        except socket.timeout:
            pass  # no client reads as fast
        self.assertGreater(sent, 0)
        record = self.records(1)[0]
        self.server.send(record)
        self.assertEqual(record, self.read(good, len(record)))
        self.assertEqual(2, len(self.server.clients))

    def test_clients_come_and_go(self):
        for _ in range(5):
            self.client().close()
            self.server.send(self.records(1)[0])
            self.until(lambda: not self.server.clients, "the server forgets who is gone")

    def test_there_is_room_for_so_many(self):
        clients = [self.client() for _ in range(wits0.MOST_CLIENTS)]
        one_more = socket.create_connection(("127.0.0.1", self.server.port), PATIENCE)
        self.addCleanup(one_more.close)
        self.assertEqual(b"", one_more.recv(1))
        self.assertIn("is refused", self.said[-1])
        clients[0].close()
        self.until(lambda: len(self.server.clients) < wits0.MOST_CLIENTS, "room")
        self.client()

    def test_an_address_in_use(self):
        self.assertRaises(OSError, wits0.Server, "127.0.0.1", self.server.port)


if __name__ == "__main__":
    unittest.main()
