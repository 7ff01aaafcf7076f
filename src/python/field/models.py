"""What is fitted to: a record in time, played to a scene, or a table of weights by depth and motion. Each predicts numbers for values of the scene's keys."""
import multiprocessing
import os
import time
from concurrent.futures import ProcessPoolExecutor

import numpy
from drill_rig_sim.campaign.blueprint import Blueprint
from drill_rig_sim.campaign.played import simulator
from drill_rig_sim.campaign.runner import one_line
from drill_rig_sim.campaign.scene_text import SceneText, SceneTextError, survey_file
from drill_rig_sim.field.pipe import clock, compared, first_hung, standstills
from drill_rig_sim.field.record import COMPARED
from drill_rig_sim.field.replay import check, play
from drill_rig_sim.field.start import start_keys
from drill_rig_sim.field.window import between
from drill_rig_sim.lockstep import Refused
from drill_rig_sim.text_file import TextError, read_text

MOTIONS = {"pick_up": "up", "slack_off": "down", "rotating": "rotate"}  # columns of a table, and what drill static calls it
LONG = 2.0  # of a point, from which on processes of their own are worth their start [s]


class ModelError(Exception):
    """Why nothing can be fitted, in one line."""


class RecordModel:
    """`observed`: signal after signal, by the record's rows. `place`: where in the record each is, 0..1. `groups`: the signal of each; `axis`: name and values of what they
    are plotted over. The scene is started where the record begins, by the rules of drill replay."""

    def __init__(self, scene, survey, parameters, record, signals=()):
        check(record)
        first = first_hung(record)
        self.record = between(record, record.time[first], numpy.inf) if first else record
        keys, lines = start_keys(scene, self.record)
        self.remarks = record.remarks + lines + (["%s: begins with the string in the slips: fitted from %.1f s on" % (record.name, clock(record, first))] if first else [])
        self.names = [name for name in COMPARED if name in record and (not signals or name in signals)]
        if not self.names:
            raise ModelError("%s: holds no number of what is to be fitted: %s" % (record.name, ", ".join(signals)))
        self.begin = [value for key, value in keys.items() if not any(key in p.keys for p in parameters)]
        self.blueprint = Blueprint(record.name, scene, survey, [(p.name, p.keys, p.times) for p in parameters if p.signal is None] +
                                   [(key, [key], False) for key in keys if not any(key in p.keys for p in parameters)])
        self.observed = numpy.concatenate(list(compared(self.record, self.names, standstills(self.record)).values()))
        self.signals = self.groups = numpy.repeat(self.names, len(self.record.time))
        self.axis = "time", numpy.tile(self.record.signals["time"], len(self.names))
        self.length = self.record.time[-1]  # [s]
        self.place = numpy.tile(self.record.time / self.length, len(self.names))

    def tasks(self, points):
        return [(self.blueprint, self.record, self.names, [*point, *self.begin]) for point in points]

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
    """Rows: depth [m] and weights by MOTIONS [N], as the scene's gauge shows them: with the friction of rail and sheaves. One rig's scene whose hole is the whole of the survey; the bit hangs at each depth."""

    def __init__(self, scene, survey, parameters, depths, weights, remarks=()):
        keys = [(p.name, p.keys, p.times) for p in parameters if p.signal is None]
        self.blueprint = Blueprint("table", scene, survey, keys + [("bit", ["start.bit_depth"], False)])
        self.depths, self.motions, self.remarks = depths, list(weights), list(remarks)
        self.observed = numpy.concatenate([weights[motion] for motion in self.motions])
        self.signals, self.groups = numpy.repeat("hook_load", len(self.observed)), numpy.repeat(self.motions, len(depths))
        self.axis = "depth", numpy.tile(depths, len(self.motions))
        self.length = 1.0
        order = (numpy.argsort(numpy.argsort(depths)) + 0.5) / len(depths)
        self.place = numpy.tile(order, len(self.motions))

    def tasks(self, points):
        return [(self.blueprint, [*point, depth], MOTIONS[motion]) for point in points for motion in self.motions for depth in self.depths]

    def join(self, answers, points):
        return numpy.reshape(answers, (points, -1))


def hung(task):
    """What the scene's gauge of the hook load shows at a depth in a motion; Refused where there is no equilibrium."""
    from drill_rig_sim.sim import static
    blueprint, row, motion = task
    return static(blueprint.written(row), motion)["hook_load_gauge"]


def hang_string(task):
    """On a worker: the hook load of a depth and motion; not a number where there is no equilibrium."""
    try:
        return hung(task)
    except Refused:
        return numpy.nan


class Evaluator:
    """Runs a model's tasks here, on processes of this machine, or on the workers of a Dask cluster. `workers`: of processes; None: one for each core where a point takes long."""

    def __init__(self, model, workers=None, scheduler=None, tell=lambda points: None):
        """`tell`: is given how many points are done, whenever there are more."""
        self.model, self.function, self.tell = model, play_record if isinstance(model, RecordModel) else hang_string, tell
        self.workers, self.pool, self.client, self.open, self.done = workers, None, None, [], 0.0
        if scheduler:
            from drill_rig_sim.campaign import engine  # needs Dask
            self.client, self.open = engine.connect(scheduler, 0, 0)

    def __call__(self, points):
        tasks, began = self.model.tasks(points), time.monotonic()
        answers = []
        for answer in self.answers(tasks):
            answers.append(answer)
            self.done += len(points) / len(tasks)
            self.tell(self.done)
        if self.workers is None:
            self.workers = cores() if (time.monotonic() - began) / len(points) > LONG else 1
        return self.model.join(answers, len(points))

    def answers(self, tasks):
        """In the order of the tasks."""
        if self.client is not None:
            return iter(self.client.gather(self.client.map(self.function, tasks, pure=False, batch_size=1000)))
        if (self.workers or 1) < 2 or len(tasks) < 2:
            return map(self.function, tasks)
        if self.pool is None:
            self.pool = ProcessPoolExecutor(self.workers, multiprocessing.get_context("spawn"))
        return self.pool.map(self.function, tasks)

    def why(self, point):
        """Why a point's first task cannot be played."""
        try:
            (played if isinstance(self.model, RecordModel) else hung)(self.model.tasks([point])[0])
        except Refused as error:
            return one_line(error, self.model.blueprint)
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
