# SPDX-License-Identifier: BSD-3-Clause
"""A live node as a source: its topics by rospy, taken as bytes. A node or a ROS master that ends and comes back is joined again."""
import collections
import struct
import threading
import time

import rosgraph
import rospy
from diagnostic_msgs.msg import DiagnosticArray
from drill_rig_sim.web.news import STATE, STATE_KIND, TOPICS, TRUTH, TRUTH_KIND, News, margin_of

EVERY = {"trajectory": 1.0, "drillstring_state": 0.5}  # these may come often: read so often at most [wall s]
BEHIND = 1.0    # so late, what is shown is not the present, and no law may go by it [s]
TOO_LATE = 5.0  # so late, what waits to be read is given up: the topics are subscribed to anew [s]
FRESH = 2.0     # a topic that has been silent for longer says nothing about another [s]
WATCH = 1.0     # between looks at the master [s]
SILENT = 1.5    # without a message for this time, the node counts as lost [s]


class NodeSource:
    """Topics of the process' ROS namespace. `on_state`: called with each message of rig_state, as bytes, in rospy's thread; None: not needed.
    `on_join`: called whenever a master has been joined. `node`: how this process' node is called."""
    live = True

    def __init__(self, name, node="drill_web"):
        self.name, self.node, self.on_state, self.on_join = name, node, None, None
        self._lock, self._states, self._truth, self._raw, self._read_at = threading.Lock(), [], [], {}, {}
        self._margin = None  # pull to yield that the feed has not taken yet [N]
        self._master, self._subscribers, self._came, self._joined = None, [], None, False
        self._seen = collections.deque(maxlen=600)  # wall time and stamp of each drillstring_state: a topic so slow that nothing waits in it
        self.newest = 0.0                           # stamp of the latest rig_state that was read [s]
        self._problem, self.last = "", None  # last: the latest RigState
        self._lost = False                   # the node has gone since the latest rig_state
        self._thread = threading.Thread(target=self._watch, daemon=True)

    def start(self):
        self._thread.start()

    # --- joining

    def _watch(self):
        while True:
            pid = master_pid()
            if pid is not None and pid != self._master:
                self._join()
            elif self._joined and self.lag() > TOO_LATE:
                rospy.logwarn("drill web was too slow: readings of a few seconds are missing")
                self._join()
            self._master = pid
            time.sleep(WATCH)

    def _join(self):
        if not self._joined:
            rospy.init_node(self.node, anonymous=True, disable_signals=True, disable_rostime=True)
            self._joined = True
        for subscriber in self._subscribers:
            subscriber.unregister()
        self._subscribers = [self._subscribe(STATE, self._take_state), self._subscribe(TRUTH, self._take_truth),
                             *(self._subscribe(topic, self._take, topic) for topic in TOPICS),
                             rospy.Subscriber("/diagnostics", DiagnosticArray, self._take_diagnostics, queue_size=10)]
        if self.on_join is not None:
            self.on_join()

    @staticmethod
    def _subscribe(topic, take, *words):
        return rospy.Subscriber(topic, rospy.AnyMsg, take, *words, queue_size=None if take.__name__ != "_take" else 1,
                                buff_size=1 << 20, tcp_nodelay=True)

    # --- in rospy's threads

    def _take_state(self, message):
        if not is_of(message, STATE_KIND):
            self._problem = "the node is of another version: its rig_state has other fields"
            return
        self._came, self._problem, self._lost = time.monotonic(), "", False
        before, self.newest = self.newest, stamp_of(message._buff)  # pylint: disable=protected-access
        with self._lock:
            if self.newest < before:
                self._seen.clear()  # another run
            self._states.append(message._buff)  # pylint: disable=protected-access
        follow = self.on_state
        if follow is not None:
            follow(message._buff)  # pylint: disable=protected-access

    def _take_truth(self, message):
        if is_of(message, TRUTH_KIND):
            with self._lock:
                self._truth.append(message._buff)  # pylint: disable=protected-access

    def _take(self, message, topic):
        if is_of(message, TOPICS[topic][1]):
            with self._lock:
                if topic == "drillstring_state":
                    self._seen.append((time.monotonic(), stamp_of(message._buff)))  # pylint: disable=protected-access
                self._raw[topic] = message._buff  # pylint: disable=protected-access

    def _take_diagnostics(self, message):
        margin = margin_of(message, rospy.get_namespace())
        if margin is not None:
            with self._lock:
                self._margin = margin

    def lag(self):
        """How late rig_state is read [wall s]: since when a later stamp has been seen on a slower topic. Bytes that wait in a socket do not show it."""
        now = time.monotonic()
        with self._lock:
            later = [wall for wall, stamp in self._seen if stamp > self.newest]
        return now - later[0] if later and later[-1] > now - FRESH else 0.0

    # --- for the feed

    def poll(self):
        now = time.monotonic()
        with self._lock:
            states, self._states, truth, self._truth = self._states, [], self._truth, []
            due = [topic for topic in self._raw if now >= self._read_at.get(topic, 0.0)]
            margin, self._margin = self._margin, None
            raw = {topic: self._raw.pop(topic) for topic in sorted(due, key=list(TOPICS).index)}
        self._read_at.update({topic: now + EVERY.get(topic, 0.0) for topic in raw})
        last = STATE_KIND().deserialize(states[-1]) if states else None
        self.last = last or self.last
        latest = {TOPICS[topic][0]: TOPICS[topic][1]().deserialize(data) for topic, data in raw.items()}
        return News(states, truth, last, {**latest, **({} if margin is None else {"margin": margin})})

    def _is_connected(self):
        """Whether a node is there: a paused one is silent too."""
        return bool(self._subscribers) and any(one.socket is not None for one in self._subscribers[0].impl.connections)

    def status(self):
        """Whether messages come, and why they do not."""
        silent = None if self._came is None else time.monotonic() - self._came
        why = self._problem
        if self._master is None:
            why = "no ROS master at %s" % rosgraph.get_master_uri()
        elif not why and not self._is_connected():
            why = "no node publishes %s" % (rospy.resolve_name(STATE) if self._joined else STATE)
            self._lost = True
        lag = self.lag()
        if not why and lag > BEHIND:
            why = "readings are %.0f s late" % lag
        is_new = silent is not None and silent < SILENT and not self._lost
        return {"silent": silent, "heard": is_new and lag <= BEHIND, "why": why or ("waiting for the node's first data" if self._lost else "")}


def is_of(message, kind):
    """Whether an AnyMsg is of this version of a type."""
    return message._connection_header["md5sum"] == kind._md5sum  # pylint: disable=protected-access


def stamp_of(data):
    """Of a message with a header, as bytes [s]."""
    seconds, nanoseconds = struct.unpack_from("<II", data, 4)
    return seconds + 1e-9 * nanoseconds


def master_pid():
    """Of the ROS master; None where there is none."""
    try:
        return rosgraph.Master("/drill_web").getPid()
    except (OSError, rosgraph.MasterException):
        return None
