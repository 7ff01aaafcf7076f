# SPDX-License-Identifier: BSD-3-Clause
"""The web server: the page's files and a web socket, for this machine and for those who know the token in the address."""
import asyncio
import hmac
import json
import os

from aiohttp import WSMsgType, web
from drill_rig_sim.web.chart_library import chart_library

PERIOD = 0.1           # between messages to the pages [s]
MOST_WAITING = 200     # messages for a page that does not read; then it is closed, and comes back by itself
MOST_PAGES = 20
LONGEST = 1 << 14      # message of a page [B]
ICON = "/favicon.ico"  # browsers ask for it where the page of a refusal names none
FOLDER = os.path.join(os.path.dirname(os.path.abspath(__file__)), "page")
TYPES = {".html": "text/html", ".js": "text/javascript", ".css": "text/css", ".svg": "image/svg+xml"}
POLICY = "default-src 'none'; script-src 'self'; style-src 'self' 'unsafe-inline'; img-src 'self' data:; connect-src 'self'"
HEADERS = {"Cache-Control": "no-store", "Referrer-Policy": "no-referrer", "X-Content-Type-Options": "nosniff", "X-Frame-Options": "DENY",
           "Content-Security-Policy": POLICY}


class Page:
    """One page that is open: its socket, and the messages that wait for it."""

    def __init__(self, socket):
        self.socket, self.waiting = socket, asyncio.Queue(MOST_WAITING)

    def send(self, text):
        try:
            self.waiting.put_nowait(text)
        except asyncio.QueueFull:
            asyncio.ensure_future(self.socket.close())

    async def write(self):
        while not self.socket.closed:
            await self.socket.send_str(await self.waiting.get())


class Server:
    """`orders`: what pages may ask for (orders.py)."""

    def __init__(self, feed, orders, token, port):
        self.feed, self.orders, self.token, self.pages = feed, orders, token, set()
        self.hosts = {"%s:%d" % (name, port) for name in ("127.0.0.1", "localhost")}
        self.files = {name: os.path.join(FOLDER, name) for name in os.listdir(FOLDER)}
        self.files["chart.js"] = chart_library()

    def application(self):
        app = web.Application(middlewares=[self.guard])
        app.router.add_get("/{token}/socket", self.socket)
        app.router.add_get("/{token}/", self.file)
        app.router.add_get("/{token}/{name}", self.file)
        app.cleanup_ctx.append(self.ticking)
        app.on_shutdown.append(self.close)
        return app

    # --- who may

    @web.middleware
    async def guard(self, request, handler):
        """The host by which it was called keeps pages of other names out, that lead here by a changed name server."""
        if request.headers.get("Host", "") not in self.hosts:
            return refused("this server answers at 127.0.0.1 and localhost only")
        if request.path == ICON:
            return web.Response(status=204, headers=HEADERS)
        token = request.path.split("/")[1]
        if not hmac.compare_digest(token.encode("utf-8", "replace"), self.token.encode()):
            return refused("the address has no valid token: open the address that drill web has printed")
        return await handler(request)

    def is_foreign(self, request):
        return request.headers.get("Origin", "") not in {"http://" + host for host in self.hosts}

    # --- what they get

    async def file(self, request):
        name = request.match_info.get("name", "index.html")
        if name not in self.files:
            raise web.HTTPNotFound(text="there is no %s\n" % name)
        with open(self.files[name], encoding="utf-8") as text:
            return web.Response(text=text.read(), content_type=TYPES.get(os.path.splitext(name)[1], "text/plain"), headers=HEADERS)

    async def socket(self, request):
        if self.is_foreign(request):
            return refused("a page of another origin may not connect")
        if len(self.pages) >= MOST_PAGES:
            return refused("%d pages are open, which is the most" % MOST_PAGES)
        socket = web.WebSocketResponse(heartbeat=10.0, max_msg_size=LONGEST, compress=False)
        await socket.prepare(request)
        page = Page(socket)
        for message in self.feed.whole():
            page.send(json.dumps(message))
        writer = asyncio.ensure_future(page.write())
        self.pages.add(page)
        try:
            async for message in socket:
                if message.type == WSMsgType.TEXT:
                    await self.take(page, message.data)
        finally:
            self.pages.discard(page)
            self.orders.left(page)
            writer.cancel()
        return socket

    async def take(self, page, text):
        """A page's order; it is answered where something is to be said."""
        try:
            order = json.loads(text)
        except ValueError:
            order = None
        answer = await self.orders.take(page, order) if isinstance(order, dict) else "no JSON object"
        if answer:
            page.send(json.dumps({"type": "answer", "text": answer}))

    # --- time

    async def ticking(self, _):
        tasks = [asyncio.ensure_future(self.every_period(take)) for take in (self.orders.tick, self.feed.take)]
        yield
        for task in tasks:
            task.cancel()

    async def every_period(self, take):
        """Sends what it gives to the pages. The dead-man has a task of its own: no failure of what is shown ends it."""
        while True:
            texts = [json.dumps(message) for message in take()]
            for page in tuple(self.pages):
                for text in texts:
                    page.send(text)
            await asyncio.sleep(PERIOD)

    async def close(self, _):
        for page in tuple(self.pages):
            await page.socket.close(code=1001)


def refused(text):
    return web.Response(status=403, text=text + "\n", headers=HEADERS)
