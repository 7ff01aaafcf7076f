# SPDX-License-Identifier: BSD-3-Clause
"""WITS level 0 (Wellsite Information Transfer Specification 1.1, 1991): records as ASCII lines RRIIvalue, record and item, between && and !!,
and a server that sends them to its clients. Needs no ROS.
"""
import math
import selectors
import socket
import threading
import time
from datetime import datetime, timezone

from drill_rig_sim.tables import SIGNALS

MOST_CLIENTS = 16        # at a time; more are turned away
MOST_WAITING = 1 << 16   # for a client that does not read [B]; what is beyond is dropped, records whole
READ_AT_ONCE = 4096      # of what clients send, which is ignored [B]
READ_PAUSE = 0.02        # after that [s]

KILO_DECANEWTON = 1e4    # the specification's metric unit of force [N]
START_DATE = "2000-01-01T00:00:00Z"  # of simulated time 0, as drill run --witsml has it
WALL_TIME = 1e9          # a stamp from here on is wall time since 1970, the date itself [s]


def start_date_of(text):
    """Seconds since 1970 of a date as 2024-05-17 or 2024-05-17T06:30:00Z, by UTC, of the years 1970 to 2199. A ValueError for any other text."""
    for form in ("%Y-%m-%d", "%Y-%m-%dT%H:%M:%SZ"):
        try:
            date = datetime.strptime(text, form)
        except ValueError:
            continue
        if 1970 <= date.year < 2200 and date.strftime(form) == text:
            return date.replace(tzinfo=timezone.utc).timestamp()
    raise ValueError("must be a UTC date from 1970 to 2199, such as 2024-05-17 or 2024-05-17T06:30:00Z (got %r)" % text)


def whole(value):
    return "%d" % round(value)


def decimal(value):
    return "%.3f" % value


# of record 01, general, by time: by quantity the factor to the specification's metric unit, and how it is written
WRITTEN = {
    "length": (1.0, decimal),                       # m
    "penetration": (3600.0, decimal),               # m/h
    "force": (1.0 / KILO_DECANEWTON, decimal),      # kDN
    "torque": (1e-3, decimal),                      # kN m
    "rotation": (30.0 / math.pi, whole),            # rpm, a whole number
    "pressure": (1e-3, decimal),                    # kPa
    "strokes": (60.0, whole),                       # strokes a minute, a whole number
    "flow": (60000.0, decimal)}                     # L/min
# item, field of RigState and the two, in the order of the items
GENERAL = sorted((row.item, row.field, *WRITTEN[row.quantity]) for row in SIGNALS if row.item)


def record(number, stamp, items, start=start_date_of(START_DATE)):
    """A record with its date and time, YYMMDD and HHMMSS of the stamp [s], and items [(item, text)]. `start`: the date of simulated time 0, since 1970 [s]."""
    moment = time.gmtime(stamp if stamp >= WALL_TIME else start + stamp)
    lines = [(5, time.strftime("%y%m%d", moment)), (6, time.strftime("%H%M%S", moment))] + list(items)
    return ("&&\r\n" + "".join("%02d%02d%s\r\n" % (number, item, text) for item, text in lines) + "!!\r\n").encode("ascii")


def general_record(state, start=start_date_of(START_DATE)):
    """Record 01 of a RigState."""
    return record(1, state.header.stamp.to_sec(), [(item, write(getattr(state, field) * factor)) for item, field, factor, write in GENERAL
                                                   if field != "surface_wob" or state.tared], start)


def survey_record(survey, start=start_date_of(START_DATE)):
    """Record 07 of a MwdSurvey: measured depth [m], inclination and corrected azimuth [deg], for north is true north here."""
    return record(7, survey.header.stamp.to_sec(), [(8, decimal(survey.md)), (13, decimal(math.degrees(survey.inclination))),
                                                    (15, decimal(math.degrees(survey.azimuth)))], start)


def toolface_record(toolface, start=start_date_of(START_DATE)):
    """Record 07 of a MwdToolface: gravity (17) or magnetic (16) toolface, 0 to 360 [deg]."""
    item = 17 if toolface.reference == toolface.GRAVITY else 16
    return record(7, toolface.header.stamp.to_sec(), [(item, decimal(math.degrees(toolface.toolface) % 360.0))], start)


class Client:
    def __init__(self, connection, address):
        self.connection, self.address = connection, "%s:%d" % address[:2]
        self.waiting = bytearray()
        self.dropped = 0  # records


class Server:
    """Sends every record to every client. send() never waits; a thread does the rest. `say(text)` is called when a client connects, leaves or misses records."""

    def __init__(self, host, port, say=lambda text: None):
        """Port 0: any that is free. Throws OSError where it cannot listen."""
        self.say = say
        self.lock = threading.Lock()  # of the clients and what waits for them
        self.clients = []
        self.dropped = 0  # records, of all clients that there were
        self.listener = socket.create_server((host, port))
        self.listener.setblocking(False)
        self.port = self.listener.getsockname()[1]
        self.wake, self.woken = socket.socketpair()
        self.wake.setblocking(False)
        self.closing = False
        self.thread = threading.Thread(target=self.run, name="wits0", daemon=True)
        self.thread.start()

    def send(self, data):
        """A whole record."""
        with self.lock:
            for client in self.clients:
                if len(client.waiting) + len(data) <= MOST_WAITING:
                    client.waiting += data
                else:
                    client.dropped += 1
                    self.dropped += 1
                    if client.dropped == 1:
                        self.say("%s does not read: records are dropped" % client.address)
        self.wake_up()

    def close(self):
        self.closing = True
        self.wake_up()
        self.thread.join()

    def wake_up(self):
        try:
            self.wake.send(b"x")
        except OSError:
            pass  # the thread is awake, or has ended and closed its sockets

    # --- the thread

    def run(self):
        with selectors.DefaultSelector() as selector:
            while not self.closing:
                self.watch(selector)
                ready = selector.select()
                heard = False
                for key, events in ready:
                    if key.data is None:
                        self.come_or_wake(key.fileobj)
                    elif events & selectors.EVENT_READ:
                        heard = self.listen_to(key.data) or heard
                    if key.data is not None and events & selectors.EVENT_WRITE:
                        self.write_to(key.data)
                if heard:
                    time.sleep(READ_PAUSE)  # a client that sends much is read that often
        for thing in [client.connection for client in self.clients] + [self.listener, self.wake, self.woken]:
            thing.close()

    def watch(self, selector):
        """Whom to wait for: those who have something waiting may become writable."""
        for key in list(selector.get_map().values()):
            selector.unregister(key.fileobj)
        selector.register(self.listener, selectors.EVENT_READ)
        selector.register(self.woken, selectors.EVENT_READ)
        with self.lock:
            for client in self.clients:
                selector.register(client.connection, selectors.EVENT_READ | (selectors.EVENT_WRITE if client.waiting else 0), client)

    def come_or_wake(self, which):
        if which is self.woken:
            self.woken.recv(READ_AT_ONCE)
            return
        try:
            connection, address = self.listener.accept()
        except OSError:  # gone again
            return
        if len(self.clients) >= MOST_CLIENTS:
            self.say("%s:%d is refused: there are already %d clients" % (*address[:2], MOST_CLIENTS))
            connection.close()
            return
        connection.setblocking(False)
        connection.setsockopt(socket.SOL_SOCKET, socket.SO_SNDBUF, MOST_WAITING)  # else the kernel keeps megabytes that are not read
        with self.lock:
            self.clients.append(Client(connection, address))
        self.say("%s:%d has come" % address[:2])

    def listen_to(self, client):
        """Reads and ignores. False: the client is gone."""
        try:
            if client.connection.recv(READ_AT_ONCE):
                return True
        except BlockingIOError:
            return False
        except OSError:
            pass
        self.forget(client)
        return False

    def write_to(self, client):
        with self.lock:
            try:
                sent = client.connection.send(client.waiting)
                del client.waiting[:sent]
                return
            except BlockingIOError:
                return
            except OSError:
                pass
        self.forget(client)

    def forget(self, client):
        with self.lock:
            if client not in self.clients:
                return
            self.clients.remove(client)
        client.connection.close()
        self.say("%s has gone%s" % (client.address, "; %d records were dropped" % client.dropped if client.dropped else ""))
