#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The server of `drill web`: who may open the page and its socket, what it sends, what happens when a page falls silent. No master, no browser."""
import asyncio
import json
import logging
import os
import subprocess
import sys
import tempfile
import unittest
import unittest.mock

import skips
from drill_rig_sim.web.feed import Feed
from drill_rig_sim.web import hands as hands_module
from drill_rig_sim.web.hands import ALIVE, HELD, Hands
from drill_rig_sim.web.news import News
from drill_rig_sim.web.orders import Orders
from drill_rig_sim.web.streams import FOREIGN, Streams
from test_web import packed, state

try:
    import aiohttp
    from aiohttp import web
    from drill_rig_sim.web import server
    from drill_rig_sim.web import chart_library as chart_library_module
    from drill_rig_sim.web.chart_library import NoLibrary
    from drill_rig_sim.web_command import listening
except ImportError:
    aiohttp = None

TOKEN = "right"
logging.getLogger("asyncio").setLevel(logging.ERROR)  # not how long each step takes on a loaded machine


class Source:
    """Gives what it was given."""
    name, live, on_state, on_join, last = "rig", True, None, None, None

    def __init__(self):
        self.states = []

    def poll(self):
        states, self.states = self.states, []
        return News([packed(one) for one in states], [], states[-1] if states else None, {})

    @staticmethod
    def status():
        return {"heard": True, "silent": 0.0, "why": ""}


class Mute(Streams):
    """Publishes into a list."""

    def __init__(self):
        super().__init__()
        self.published = []

    def publish(self, name, message):
        self.published.append((name, message))


class Running:
    """A server on a free port, with a client."""

    def __init__(self, control=False):
        self.source = Source()
        self.streams = Mute()
        self.hands = Hands(self.source, lambda: [], self.streams) if control else None
        self.feed = Feed(self.source, control, "si")

    async def __aenter__(self):
        library = tempfile.NamedTemporaryFile("w", suffix=".js", delete=False)
        library.write("window.Chart = 1;")
        library.close()
        os.environ["DRILL_RIG_SIM_CHART_JS"] = self.library = library.name
        sock = listening(0)
        self.port = sock.getsockname()[1]
        self.runner = web.AppRunner(server.Server(self.feed, Orders(self.feed, self.hands), TOKEN, self.port).application())
        await self.runner.setup()
        await web.SockSite(self.runner, sock).start()
        self.client = aiohttp.ClientSession()
        return self

    async def __aexit__(self, *_):
        await self.client.close()
        await self.runner.cleanup()
        os.unlink(self.library)

    def address(self, path=TOKEN + "/"):
        return "http://127.0.0.1:%d/%s" % (self.port, path)

    async def status(self, path, **headers):
        async with self.client.get(self.address(path), headers=headers) as answer:
            return answer.status, await answer.text()

    def connect(self, path=TOKEN + "/socket", origin=None):
        return self.client.ws_connect(self.address(path), origin=origin or "http://127.0.0.1:%d" % self.port)


async def messages_until(socket, kind):
    """Messages of a page up to the first of a kind, by their kinds."""
    found = {}
    while kind not in found:
        message = json.loads((await asyncio.wait_for(socket.receive(), 10.0)).data)
        found[message["type"]] = message
    return found


@unittest.skipIf(aiohttp is None, "python3-aiohttp is not installed")
class Doors(unittest.IsolatedAsyncioTestCase):
    async def test_the_page_and_its_files(self):
        async with Running() as running:
            status, text = await running.status(TOKEN + "/")
            self.assertEqual(status, 200)
            for name in ("main.js", "style.css", "layout.css", "chart.js"):
                self.assertIn('"%s"' % name, text)
                self.assertEqual((await running.status(TOKEN + "/" + name))[0], 200, name)
            for name in ("no.js", "..%2Fserver.py", "%2Fetc%2Fpasswd"):
                self.assertEqual((await running.status(TOKEN + "/" + name))[0], 404, name)

    async def test_a_wrong_token_is_refused(self):
        async with Running() as running:
            for path in ("", "wrong/", "wrong/main.js", "righ/", "rightt/", "%C3%A4/", "wrong/socket"):
                status, text = await running.status(path)
                self.assertEqual(status, 403, path)
                self.assertRegex(text, "^the address has no valid token: .*\n$")
            with self.assertRaises(aiohttp.WSServerHandshakeError) as refusal:
                await running.connect("wrong/socket")
            self.assertEqual(refusal.exception.status, 403)

    async def test_a_foreign_origin_is_refused(self):
        async with Running() as running:
            for origin in ("http://example.org", "https://127.0.0.1:%d" % running.port, "http://127.0.0.1:1", "null"):
                with self.assertRaises(aiohttp.WSServerHandshakeError) as refusal:
                    await running.connect(origin=origin)
                self.assertEqual(refusal.exception.status, 403, origin)
            self.assertEqual((await running.status(TOKEN + "/socket"))[0], 403)

    async def test_a_foreign_host_is_refused(self):
        async with Running() as running:
            self.assertEqual((await running.status(TOKEN + "/", Host="rebound.example.org"))[0], 403)
            self.assertEqual((await running.status(TOKEN + "/", Host="localhost:%d" % running.port))[0], 200)

    async def test_an_icon_that_a_browser_asks_for_is_no_refusal(self):
        async with Running() as running:
            self.assertEqual((await running.status("favicon.ico"))[0], 204)
            self.assertEqual((await running.status("favicon.ico", Host="rebound.example.org"))[0], 403)


@unittest.skipIf(aiohttp is None, "python3-aiohttp is not installed")
class Socket(unittest.IsolatedAsyncioTestCase):
    async def test_a_page_gets_the_run_and_what_is_new(self):
        async with Running() as running:
            running.source.states = [state(1.0, hook_load=4e5), state(1.1, hook_load=9e5), state(1.2, hook_load=4e5)]
            await asyncio.sleep(0.3)
            async with running.connect() as socket:
                found = await messages_until(socket, "state")
                self.assertFalse(found["hello"]["control"])
                self.assertEqual(found["bins"]["signals"]["hook_load"][2], [9e5])
                self.assertEqual(found["state"]["values"]["hook_load"][0], 4e5)
                running.source.states = [state(1.3, hook_load=5e5)]
                self.assertEqual((await messages_until(socket, "bins"))["bins"]["signals"]["hook_load"][2][-1], 5e5)

    async def test_read_only(self):
        async with Running() as running, running.connect() as socket:
            for order in ('{"type": "hold", "velocity": 1}', '{"type": "call", "service": "pause"}'):
                await socket.send_str(order)
                self.assertEqual((await messages_until(socket, "answer"))["answer"]["text"], "read-only: start drill web with --control")
            for order in ("", "[]", "nonsense", "3"):
                await socket.send_str(order)
                self.assertEqual((await messages_until(socket, "answer"))["answer"]["text"], "no JSON object")

    async def test_alarms_are_acknowledged_for_all(self):
        async with Running() as running:
            running.source.states = [state(1.0, slack_line=True), state(2.0)]
            async with running.connect() as one, running.connect() as other:
                entry = {}
                while not entry:
                    entry = ((await messages_until(one, "alarms"))["alarms"]["entries"] or [{}])[0]
                self.assertFalse(entry["acknowledged"])
                await one.send_str(json.dumps({"type": "acknowledge", "number": entry["number"]}))
                while not entry["acknowledged"]:
                    entry = ((await messages_until(other, "alarms"))["alarms"]["entries"] or [entry])[0]


@unittest.skipIf(aiohttp is None, "python3-aiohttp is not installed")
class DeadMan(unittest.IsolatedAsyncioTestCase):
    async def held(self, running, socket):
        await socket.send_str('{"type": "hold", "velocity": 0.2, "press": 1}')
        await messages_until(socket, "law")
        for _ in range(50):
            if running.streams.published:
                break
            await asyncio.sleep(0.02)
        name, message = running.streams.published[0]
        self.assertEqual((name, message.block_velocity, message.brake), ("winch", 0.2, False))

    def brakes(self, running):
        return [message for name, message in running.streams.published if name == "winch" and message.brake]

    async def test_silence_sets_the_brake(self):
        async with Running(control=True) as running, running.connect() as socket:
            await self.held(running, socket)
            self.assertFalse(self.brakes(running))
            await asyncio.sleep(HELD + 0.5)
            self.assertTrue(self.brakes(running))
            found = await messages_until(socket, "answer")
            self.assertIn("dead-man", found["answer"]["text"])
            self.assertEqual(1, found["press_ended"]["press"])

    async def test_a_press_that_has_ended_moves_nothing(self):
        """The page hangs, the bridge sets the brake, the page comes back and goes on as before: its button may be let go long since."""
        async with Running(control=True) as running, running.connect() as socket:
            await self.held(running, socket)
            await asyncio.sleep(HELD + 0.3)
            del running.streams.published[:]
            await socket.send_str('{"type": "hold", "velocity": 0.2, "press": 1}')
            await asyncio.sleep(0.3)
            self.assertEqual({(name, message.brake) for name, message in running.streams.published}, {("winch", True)})
            await socket.send_str('{"type": "hold", "velocity": 0.2, "press": 2}')
            await asyncio.sleep(0.3)
            self.assertEqual(running.streams.published[-1][1].block_velocity, 0.2)

    async def test_a_failure_of_what_is_shown_leaves_the_dead_man(self):
        async with Running(control=True) as running, running.connect() as socket:
            running.source.poll = None
            await self.held(running, socket)
            await asyncio.sleep(HELD + 0.5)
            self.assertTrue(self.brakes(running))

    async def test_a_closed_page_sets_the_brake(self):
        async with Running(control=True) as running:
            async with running.connect() as socket:
                await self.held(running, socket)
            await asyncio.sleep(0.2)
            self.assertTrue(self.brakes(running))

    async def test_letting_go_sets_the_brake(self):
        async with Running(control=True) as running, running.connect() as socket:
            await self.held(running, socket)
            await socket.send_str('{"type": "release"}')
            await asyncio.sleep(0.3)
            self.assertTrue(self.brakes(running))

    async def test_set_points_are_repeated_while_a_page_is_alive(self):
        async with Running(control=True) as running, running.connect() as socket:
            await socket.send_str('{"type": "set", "rpm": 6.0}')
            await asyncio.sleep(1.0)
            self.assertGreater(len(running.streams.published), 5)
            self.assertEqual({(name, message.speed) for name, message in running.streams.published}, {("top_drive", 6.0)})
            await asyncio.sleep(ALIVE)
            count = len(running.streams.published)
            await asyncio.sleep(0.5)
            self.assertEqual(count, len(running.streams.published))

    async def test_another_controller_is_left_the_rig(self):
        async with Running(control=True) as running, running.connect() as socket:
            await socket.send_str('{"type": "set", "rpm": 6.0}')
            running.source.last = state(1.0)  # in force is another speed
            await asyncio.sleep(FOREIGN + 0.5)
            self.assertEqual(running.streams.kept, {})
            self.assertIn("another controller", (await messages_until(socket, "answer"))["answer"]["text"])

    async def test_wrong_orders(self):
        async with Running(control=True) as running, running.connect() as socket:
            cases = (({"type": "hold", "velocity": "up"}, "velocity must be a number"), ({"type": "hold", "velocity": 0.1}, "press must be a number"),
                     ({"type": "set", "flow": -1}, "flow must be a number from 0"),
                     ({"type": "call", "service": "shutdown"}, "no such service: shutdown"), ({"type": "start_law"}, "needed: weight, rop"))
            for order, text in cases:
                await socket.send_str(json.dumps(order))
                self.assertIn(text, (await messages_until(socket, "answer"))["answer"]["text"])
            self.assertEqual(running.streams.published, [])


@unittest.skipIf(aiohttp is None, "python3-aiohttp is not installed")
class Bound(unittest.TestCase):
    """How long the brake may take after a page's last order, by a clock of the test: no load of the machine counts."""
    now = 0.0

    def test_the_brake_is_set_with_the_first_period_beyond(self):
        streams = Mute()
        hands = Hands(Source(), lambda: [], streams)
        with unittest.mock.patch.object(hands_module.time, "monotonic", lambda: self.now):
            for order in range(5):
                self.now = 0.15 * order
                hands.hold("page", {"velocity": 0.2, "press": 1})
            last, notes = self.now, []
            while not notes:
                self.assertFalse(any(message.brake for _, message in streams.published))
                self.now += server.PERIOD
                notes = [message["text"] for message in hands.tick() if message["type"] == "answer"]
        self.assertTrue(streams.published[-1][1].brake)
        self.assertLessEqual(self.now - last, HELD + server.PERIOD + 1e-9)
        self.assertRegex(notes[0], "^dead-man: brake set %.2f s after the page's last command" % (self.now - last))


@unittest.skipIf(aiohttp is None, "python3-aiohttp is not installed")
class Command(unittest.TestCase):
    def refused(self, *words, **environment):
        done = subprocess.run([sys.executable, "-m", "drill_rig_sim.web_command", *words], capture_output=True, text=True, timeout=60,
                              env={**os.environ, **environment}, check=False)
        self.assertRegex(done.stderr, "^drill web: .*\n$")
        self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
        return done.returncode, done.stderr

    def test_what_is_refused(self):
        cases = ((("--control", "a.bag"), 2, "--control: a bag cannot be commanded"), (("--namespace", "a b"), 2, "'a b' is not allowed"),
                 (("/no/such.bag",), 2, "/no/such.bag"))
        for words, status, said in cases:
            code, text = self.refused(*words)
            self.assertEqual(code, status, text)
            self.assertIn(said, text)

    def test_a_missing_library(self):
        nowhere = unittest.mock.patch.dict(os.environ, DRILL_RIG_SIM_CHART_JS="")
        with nowhere, unittest.mock.patch.object(chart_library_module, "FILES", ("/no/chart.js",)):
            with self.assertRaisesRegex(NoLibrary, "libjs-chart.js"):
                chart_library_module.chart_library()


if __name__ == "__main__":
    skips.main()
