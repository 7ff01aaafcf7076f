# SPDX-License-Identifier: BSD-3-Clause
"""What `drill web` starts: a page about a rig, live or from a bag, for a browser on this machine. The runner has checked the command line."""
import argparse
import os
import re
import secrets
import signal
import socket
import sys

from drill_rig_sim.refusal import Refusal
from drill_rig_sim.score_command import BAD_INPUT, FAILED, GOOD
from drill_rig_sim.units import SYSTEMS


NAME = re.compile(r"/?[A-Za-z]\w*(/\w+)*/?")  # of a ROS namespace


def options_of(words):
    parser = argparse.ArgumentParser(prog="drill web", description=__doc__)
    parser.add_argument("run", nargs="?")
    parser.add_argument("--namespace")
    parser.add_argument("--port", type=int, default=0)
    parser.add_argument("--control", action="store_true")
    parser.add_argument("--units", choices=SYSTEMS, default="si")
    return parser.parse_args(words)


def source_of(options):
    """A bag, or a live node whose namespace becomes the process'."""
    if options.run and options.control:
        raise Refusal("--control: a bag cannot be commanded")
    if options.run:
        from drill_rig_sim.web.bag_source import BagSource
        return BagSource(options.run, options.namespace)
    namespace = options.namespace or "rig"
    if not NAME.fullmatch(namespace):
        raise Refusal("--namespace: '%s' is not allowed, needed: a ROS namespace as rig" % namespace)
    namespace = namespace.strip("/")
    os.environ["ROS_NAMESPACE"] = "/" + namespace  # before rospy is imported
    from drill_rig_sim.web.node_source import NodeSource
    return NodeSource(namespace)


def listening(port):
    """A socket on this machine's own address."""
    found = socket.socket()
    found.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
    found.bind(("127.0.0.1", port))
    return found


def server_of(options, port, token):
    from drill_rig_sim.web.feed import Feed
    from drill_rig_sim.web.orders import Orders
    from drill_rig_sim.web.server import Server
    source = source_of(options)
    feed, hands = Feed(source, options.control, options.units), None
    if options.control:
        from drill_rig_sim.web.hands import Hands
        hands = Hands(source, lambda: feed.scene, parts=lambda: feed.parts)
    server = Server(feed, Orders(feed, hands), token, port)
    if source.live:
        source.start()
    else:
        feed.take()
    return server


def serve(options):
    from aiohttp import web
    token = secrets.token_urlsafe(16)
    sock = listening(options.port)
    port = sock.getsockname()[1]
    application = server_of(options, port, token).application()
    print("drill web: http://127.0.0.1:%d/%s/ (%s)" % (port, token, "with control" if options.control else "read-only"), flush=True)
    signal.signal(signal.SIGTERM, signal.default_int_handler)
    web.run_app(application, sock=sock, print=None, access_log=None, shutdown_timeout=1.0)


def main(words):
    options = options_of(words)
    try:
        serve(options)
    except Refusal as error:
        print("drill web: %s" % error, file=sys.stderr)
        return BAD_INPUT
    except ImportError as error:
        print("drill web: %s; the page needs Debian's python3-aiohttp and python3-rospy" % error, file=sys.stderr)
        return FAILED
    except OSError as error:
        print("drill web: port %d: %s" % (options.port, error.strerror or error), file=sys.stderr)
        return FAILED
    return GOOD


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
