# SPDX-License-Identifier: BSD-3-Clause
"""What is fitted to: a record in time, played to a scene, or a table of weights by depth and motion. Each predicts numbers for values of the scene's keys."""
import copy
import math
import multiprocessing
import os
import time
from concurrent.futures import ProcessPoolExecutor

import numpy
from drill_rig_sim.campaign.blueprint import Blueprint
from drill_rig_sim.campaign.played import simulator
from drill_rig_sim.campaign.refusal_of_user import line_of_user
from drill_rig_sim.campaign.scene_text import SceneText, SceneTextError, survey_file
from drill_rig_sim.field.course import scatter
from drill_rig_sim.field.follow import rows_at_turns
from drill_rig_sim.field.motions import MOTIONS, WAYS, drag_of_unknown_speeds, shown
from drill_rig_sim.field.pipe import compared, standstills
from drill_rig_sim.field.record import COMPARED
from drill_rig_sim.field.replay import check, over_gaps, play
from drill_rig_sim.field.start import on_hook, start_keys
from drill_rig_sim.field.window import inside
from drill_rig_sim.lockstep import Refused
from drill_rig_sim.text_file import TextError, read_text

FED = ("block_height", "block_velocity", "hook_load", "top_drive_speed", "flow")  # signals of a record that are played to the rig
START = ("start.bit_depth", "start.block_height")  # of a table's row
LONG = 2.0  # of a point, from which on processes of their own are worth their start [s]


class ModelError(Exception):
    """Why nothing can be fitted, in one line."""


class Period:
    """Of a record, from `begin` to `end` [s], without what is `left_out`, (begin, end) [s]; `start_from`: as of start_keys()."""

    def __init__(self, begin=-math.inf, end=math.inf, left_out=(), start_from=""):
        self.begin, self.end, self.left_out, self.start_from = begin, end, left_out, start_from


class RecordModel:
    """`observed`: signal after signal, by the record's rows. `place`: where in the record each is, 0..1. `groups`: the signal of each; `axis`: name and values of what they
    are plotted over. `noise`: by signal the standard deviation of the record's noise. The scene is started where the record begins, by the rules of drill replay."""

    def __init__(self, file, scene, survey, parameters, record, signals=(), period=Period()):
        self.record, hung_lines = on_hook(record, period.begin, period.end)
        check(self.record)
        keys, lines = start_keys(scene, self.record, period.start_from)
        self.remarks = record.remarks + ["%s: %s" % (record.name, line) for line in over_gaps(self.record)] + lines + hung_lines
        keys["numerics.companion"] = "none"  # a fit compares many runs with one record: their own errors are not measured
        self.names = [name for name in COMPARED if name in record and (not signals or name in signals)]
        if not self.names:
            raise ModelError("%s: has no numbers to compare in: %s" % (record.name, ", ".join(signals)))
        self.begin = [value for key, value in keys.items() if not any(key in p.keys for p in parameters)]
        self.blueprint = Blueprint(file, scene, survey, [(p.name, p.keys, p.times) for p in parameters if p.signal is None] +
                                   [(key, [key], False) for key in keys if not any(key in p.keys for p in parameters)])
        passed = inside(self.record.signals["time"], period.left_out)
        self.observed = numpy.concatenate(list(self.comparable(passed).values()))
        self.noise = {name: scatter(values[numpy.isfinite(values)]) for name, values in self.record.signals.items() if name in self.names}
        self.signals = self.groups = self.kinds = numpy.repeat(self.names, len(self.record.time))
        self.errors = 0.0
        self.axis = "time", numpy.tile(self.record.signals["time"], len(self.names))
        self.place = numpy.tile(self.record.time / self.record.time[-1], len(self.names))

    def comparable(self, passed):
        """What was recorded, by signal: not a number in rows that are `passed`, where pipe is added or taken away, and of the hook load where the block starts, stops or
        turns back, which is reported."""
        stands = standstills(self.record)
        found = {name: numpy.where(passed, numpy.nan, values) for name, values in compared(self.record, self.names, stands).items()}
        if "hook_load" in found:
            rows = [k for k in rows_at_turns(self.record, stands) if numpy.isfinite(found["hook_load"][k])]
            found["hook_load"][rows] = numpy.nan
            self.remarks += ["%s: hook_load of %d rows is left out, where the block starts, stops or turns back between rows" % (self.record.name, len(rows))] if rows else []
        return found

    def tasks(self, points):
        return [(self.blueprint, self.record, self.names, [*point, *self.begin]) for point in points]

    def replicas(self, point, count):
        """Tasks of a point whose record has noise added to what the rig is fed with, as much as it has already; the same each time."""
        chance = numpy.random.default_rng(1)
        return [(self.blueprint, self.noisier(chance), self.names, [*point, *self.begin]) for _ in range(count)]

    def noisier(self, chance):
        record = copy.copy(self.record)
        record.signals = dict(record.signals)
        for name in FED:
            if name in record:
                values = record.signals[name]
                record.signals[name] = values + scatter(values[numpy.isfinite(values)]) * chance.normal(size=len(values))
        return record

    @staticmethod
    def join(answers, points):
        """Of the tasks' answers a prediction a point."""
        return answers[:points]


def played(task):
    """A point's prediction; Refused where the scene cannot be played so."""
    blueprint, record, names, point = task
    replay = play(simulator(blueprint, point), record)
    return numpy.concatenate([replay.simulated[name] for name in names])


def play_record(task):
    """On a worker: a point's prediction; not a number where the scene cannot be played so."""
    try:
        return played(task)
    except Refused:
        return numpy.full(len(task[2]) * len(task[1].time), numpy.nan)


class TableModel:
    """Rows: depth [m] and weights by MOTIONS [N], [N m], nan where there is none, as the scene's gauge shows them: with the friction of rail and sheaves. One rig's
    scene whose hole is the whole of the survey; the bit hangs at each depth."""

    def __init__(self, file, scene, survey, parameters, depths, weights, remarks=(), errors=0.0, ways=None):
        """`file`: of the scene, in refusals. `errors`: standard deviation of the loads by row, which is known beside their scatter [N]. `ways`: of WAYS those that are known, by row, nan where they are not."""
        keys = [(p.name, p.keys, p.times) for p in parameters if p.signal is None]
        self.blueprint, self.with_block = (Blueprint(file, scene, survey, keys + [(key, [key], False) for key in START[:count]]) for count in (1, 2))
        self.depths, self.motions, self.remarks, self.noise = depths, list(weights), list(remarks), {}
        self.observed = numpy.concatenate([weights[motion] for motion in self.motions])
        self.weighed = numpy.flatnonzero(numpy.isfinite(self.observed))
        self.groups = numpy.repeat(self.motions, len(depths))
        self.signals = numpy.array([MOTIONS[motion][0] for motion in self.groups])
        self.kinds = numpy.where(numpy.char.startswith(self.groups.astype(str), "slips"), "empty block", self.signals)  # it knows no friction of the string
        self.errors = numpy.where(self.signals == "hook_load", numpy.tile(numpy.broadcast_to(errors, len(depths)), len(self.motions)), 0.0)
        self.ways = numpy.array([(ways or {}).get(name, numpy.full(len(depths), numpy.nan)) for name in WAYS])
        self.axis = "depth", numpy.tile(depths, len(self.motions))
        self.place = numpy.concatenate([places_of(depths, weights[motion]) for motion in self.motions])

    def tasks(self, points):
        depths = self.axis[1]
        return [(self.hangs_so(point, depths[k], height), self.groups[k], tuple(ways)) for point in points for k in self.weighed
                for *ways, height in [self.ways[:, k % len(self.depths)]]]

    def hangs_so(self, point, depth, height):
        """(Blueprint, row) of scenes in which the string hangs so: with the block where it was, which the scene may refuse, then with the block where the scene has it."""
        return [(self.with_block, [*point, depth, height])] * bool(numpy.isfinite(height)) + [(self.blueprint, [*point, depth])]

    def drag_remarks(self, point):
        """A line, where the mud's drag at a point of the parameters may matter and the speed of a weight that was picked up or slacked off is not known."""
        unknown = [k for k in self.weighed if self.groups[k] in ("pick_up", "slack_off") and not numpy.isfinite(self.ways[0, k % len(self.depths)])]
        return drag_of_unknown_speeds(self.blueprint.written([*point, self.axis[1][unknown].max()])) if unknown else []

    def join(self, answers, points):
        found = numpy.full((points, len(self.observed)), numpy.nan)
        found[:, self.weighed] = numpy.reshape(answers, (points, -1))
        return found


def places_of(depths, weights):
    """Of each weight in the order of the depths, 0 to 1: the shallowest one is at 0. nan where there is none."""
    there = numpy.flatnonzero(numpy.isfinite(weights))
    found = numpy.full(len(depths), numpy.nan)
    found[there[numpy.argsort(depths[there], kind="stable")]] = numpy.concatenate(([0.0], (numpy.arange(1, len(there)) + 0.5) / max(len(there), 1)))[:len(there)]
    return found


def hung(task):
    """What the scene's gauge of hook load or torque shows at a depth in a motion; Refused where there is no equilibrium."""
    hangs, column, ways = task
    for blueprint, row in hangs[:-1]:
        try:
            return shown(blueprint.written(row), column, *ways)
        except Refused:
            pass
    blueprint, row = hangs[-1]
    return shown(blueprint.written(row), column, *ways)


def hang_string(task):
    """On a worker: the weight or torque of a depth and motion; not a number where there is no equilibrium."""
    try:
        return hung(task)
    except Refused:
        return numpy.nan


class Evaluator:
    """Runs a model's tasks here, on processes of this machine, or on the workers of a Dask cluster. `workers`: of processes; None: one for each core where a point takes long."""

    def __init__(self, model, workers=None, scheduler=None, tell=lambda points: None):
        """`tell`: called with the number of points done, whenever there are more."""
        self.model, self.function, self.tell = model, play_record if isinstance(model, RecordModel) else hang_string, tell
        self.workers, self.pool, self.client, self.open, self.done = workers, None, None, [], 0.0
        if scheduler:
            from drill_rig_sim.campaign import engine  # needs Dask
            self.client, self.open = engine.connect(scheduler, 0, 0)

    def __call__(self, points):
        began = time.monotonic()
        answers = self.run(self.model.tasks(points), len(points))
        if self.workers is None:
            self.workers = cores() if (time.monotonic() - began) / len(points) > LONG else 1
        return self.model.join(answers, len(points))

    def replicas(self, point, count):
        """As of a Problem."""
        return self.run(self.model.replicas(point, count), count)

    def run(self, tasks, points):
        """Answers to tasks, each of one or more points."""
        answers = []
        for answer in self.answers(tasks):
            answers.append(answer)
            self.done += points / len(tasks)
            self.tell(self.done)
        return answers

    def answers(self, tasks):
        """In the order of the tasks."""
        if self.client is not None:
            return iter(self.client.gather(self.client.map(self.function, tasks, pure=False, batch_size=1000)))
        if (self.workers or 1) < 2 or len(tasks) < 2:
            return map(self.function, tasks)
        if self.pool is None:
            self.pool = ProcessPoolExecutor(self.workers, multiprocessing.get_context("spawn"))
        return self.pool.map(self.function, tasks)

    def why(self, point, number=None):
        """Why a point's first task cannot be played, or of a table that of a number that was observed."""
        is_record = isinstance(self.model, RecordModel)
        place = 0 if number is None or is_record else int(numpy.searchsorted(self.model.weighed, number))
        task = self.model.tasks([point])[place]
        blueprint, row = (task[0], task[3]) if is_record else task[0][-1]
        try:
            (played if is_record else hung)(task)
        except Refused as error:
            return line_of_user(error, blueprint, row, blueprint.name)
        return "no equilibrium"

    def close(self):
        if self.pool is not None:
            self.pool.shutdown(cancel_futures=True)
        for thing in [self.client] * (self.client is not None) + self.open:
            thing.close()


def cores():
    """That this process may use."""
    return len(os.sched_getaffinity(0))


def scene_and_survey(file):
    """Texts of a scene's file and of the survey's that it names."""
    try:
        scene = read_text(file)
        SceneText(scene, [])
        survey = survey_file(scene, file)
        return scene, None if survey is None else read_text(survey)
    except (TextError, SceneTextError) as error:
        raise ModelError(str(error))
