# SPDX-License-Identifier: BSD-3-Clause
"""What pages are sent, as dicts: all of it to a new page, then what has changed."""
import time

from drill_rig_sim.units import SHOWN, SYSTEMS
from drill_rig_sim.web import shapes
from drill_rig_sim.web.broomstick import Broomstick, ways_of
from drill_rig_sim.web.fields import DEPTH_TRACKS, FIELDS, NUMBERS, TRACKS
from drill_rig_sim.web.law_points import LAW_POINTS
from drill_rig_sim.web.news import TRUTH_KIND
from drill_rig_sim.web.run_log import RunLog, shown

SLOW = 1.0          # between sheets, strings and wells [wall s]
RARE = 10.0         # between looks for weights [wall s]
SPEED_OVER = 3.0    # wall time over which the speed of the simulation and the share of a core are measured [s]


class Feed:
    """`source`: gives messages and its status (node_source, bag_source). `control`: whether pages may command."""

    def __init__(self, source, control, units):
        self.source, self.control, self.units = source, control, units
        self.log, self.kept, self.described = RunLog(), {}, {}
        self.parts, self.scene, self.plan, self.path = [], [], shapes.path_of([]), shapes.path_of([])
        self.path_begin = 0.0  # measured depth of the first point of the path [m]
        self.alarm_revision, self.slow_at, self.sheet_of = -1, 0.0, None
        self.broomstick, self.broomstick_revision, self.scene_text, self.weights_at = Broomstick(), 0, "", 0.0
        self.marks = []  # of wall time, simulated time, processor time

    def hello(self):
        fields = [{"name": f.name, "label": f.label, "quantity": f.quantity, "track": f.track, "scale": f.scale} for f in FIELDS]
        units = {quantity: [unit._asdict() for unit in shown] for quantity, shown in SHOWN.items()}
        return {"type": "hello", "fields": fields, "tracks": TRACKS, "numbers": NUMBERS, "depth_tracks": DEPTH_TRACKS, "units": units,
                "law_points": [point._asdict() for point in LAW_POINTS], "systems": SYSTEMS, "system": self.units, "control": self.control, "source": self.source.name, "live": self.source.live}

    def whole(self):
        """For a page that has just been opened."""
        return [self.hello(), *self.described.values(), *self.logs(whole=True), self.alarms(), self.sheets(), *self.kept.values()]

    def take(self):
        """Takes what the source has; what pages are to be sent now."""
        news = self.source.poll()
        changed = [message for topic in news.latest for message in self._describe(topic, news.latest[topic])]
        if news.truth:
            self.log.take_truth(news.truth)
            changed += self._faults_if_changed(TRUTH_KIND().deserialize(news.truth[-1]))
        run = self.log.run
        if news.states:
            self.log.take(news.states)
        if news.rows is not None:
            self.log.take_rows(news.rows)
        if self.log.run != run:
            self.marks, self.weights_at = [], 0.0
        return [*changed, *self.logs(), *self._alarms_if_changed(), *self._slowly(), *self._broomstick_if_changed(), self.state(news.last)]

    def logs(self, whole=False):
        found = ((name, getattr(self.log, name).change(whole)) for name in ("time", "depth"))
        return [{"type": "bins", "log": name, "run": self.log.run, **change} for name, change in found if change is not None]

    def alarms(self):
        self.alarm_revision = (self.log.run, self.log.alarms.revision)
        return {"type": "alarms", "entries": self.log.alarms.shown()}

    def _alarms_if_changed(self):
        return [self.alarms()] if self.alarm_revision != (self.log.run, self.log.alarms.revision) else []

    def sheets(self):
        activity = self.log.activity
        return {"type": "sheets", "intervals": activity.intervals, "connections": activity.connections(),
                "slides": activity.sheet(self.log.time) if self.log.time.first is not None else []}

    def _slowly(self):
        """Once a second: what is long."""
        now = time.monotonic()
        if now < self.slow_at:
            return []
        self.slow_at = now + SLOW
        present = (self.log.run, self.log.last["stamp"] if self.log.last is not None else None)
        if present == self.sheet_of:
            return []
        self.sheet_of = present
        return [self.sheets(), *self._weights(now)]

    def _weights(self, now):
        """Of the run, now and then: they take some milliseconds to find."""
        if now < self.weights_at:
            return []
        self.weights_at = now + RARE
        self.described["weights"] = {"type": "weights", "points": self.log.weights.find()}
        return [self.described["weights"]]

    def _broomstick_if_changed(self):
        if self.broomstick.revision == self.broomstick_revision:
            return []
        self.broomstick_revision = self.broomstick.revision
        self.described["broomstick"] = self.broomstick.message
        return [self.broomstick.message]

    def work_out(self):
        """Begins the broomstick chart; why it cannot be, or ""."""
        if not self.scene_text or self.log.last is None:
            return "the broomstick needs the topic scene and a rig_state"
        return self.broomstick.begin(self.scene_text, float(self.log.last["hole_depth"]), ways_of(self.log.weights.find()))

    def state(self, last):
        """`last`: the latest RigState, or None where none is new."""
        if last is not None:
            self.kept["set_points"] = {"type": "set_points", **shapes.set_points_of(last), "operation": last.current_operation,
                                       "progress": last.operation_progress, "stand_count": last.stand_count}
        state = self.log.take_state() or {}
        return {**self.kept.get("set_points", {}), **state, "type": "state", "status": self.source.status(), **self.rates(state.get("t"))}

    def rates(self, now):
        """Simulated seconds per wall second, and this process' share of a core."""
        mark = (time.monotonic(), now, time.process_time())
        self.marks = [one for one in self.marks if one[0] > mark[0] - SPEED_OVER] + [mark]
        wall, before, cpu = self.marks[0]
        if mark[0] - wall < 0.5 or now is None or before is None:
            return {"speed": None, "cpu": None}
        return {"speed": (now - before) / (mark[0] - wall), "cpu": (mark[2] - cpu) / (mark[0] - wall)}

    def _faults_if_changed(self, truth):
        places = zip(truth.active_faults, truth.active_fault_depths)
        found = {"type": "faults", "entries": [{"text": word.replace("_", " "), "depth": shown(depth)} for word, depth in places]}
        if found == self.described.get("faults", {"type": "faults", "entries": []}):
            return []
        self.described["faults"] = found
        return [found]

    # --- what is latched, or comes now and then

    def _describe(self, topic, message):
        """Messages for the pages; they are kept for those that come later."""
        found = getattr(self, "_" + topic)(message)
        for one in found:
            self.described[one["type"]] = one
        return found

    def _limits(self, message):
        return [{"type": "limits", **shapes.limits_of(message)}]

    def _description(self, message):
        self.parts, self.plan = shapes.parts_of(message), shapes.path_of(message.plan)
        self.log.bit_diameter = next((part["diameter"] for part in self.parts[:1]), None)
        return [{"type": "parts", "parts": self.parts}, *self._well()]

    @staticmethod
    def _margin(pull_to_yield):
        return [{"type": "margin", "pull_to_yield": pull_to_yield}]

    def _scene(self, message):
        self.scene_text, self.scene = message.data, shapes.parts_of_scene(message.data)
        return []

    def _trajectory(self, message):
        self.path = shapes.path_of([pose.pose.position for pose in message.poses])
        return self._well()

    def _drilled(self, path_and_begin):
        path, self.path_begin = path_and_begin
        self.path = shapes.thinned(path)
        return self._well()

    def _planned(self, path):
        self.plan = shapes.thinned(path)
        return self._well()

    def _well(self):
        return [{"type": "well", **shapes.well_of(self.path, self.plan, self.path_begin)}]

    def _string(self, message):
        return [{"type": "string", **shapes.string_of(message, shapes.Strength(self.parts, self.scene))}]
