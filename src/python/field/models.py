"""What is fitted to: a record in time, played to a scene, or a table of weights by depth and motion. Each predicts numbers for values of the scene's keys."""
import numpy
from drill_rig_sim.campaign.blueprint import Blueprint
from drill_rig_sim.campaign.played import simulator
from drill_rig_sim.campaign.runner import one_line
from drill_rig_sim.campaign.scene_text import SceneText, SceneTextError, survey_file
from drill_rig_sim.field.pipe import compared, standstills
from drill_rig_sim.field.replay import COMPARED, check, play
from drill_rig_sim.lockstep import Refused
from drill_rig_sim.text_file import TextError, read_text

MOTIONS = {"pick_up": "up", "slack_off": "down", "rotating": "rotate"}  # columns of a table, and what drill static calls it


class ModelError(Exception):
    """Why nothing can be fitted, in one line."""


class RecordModel:
    """`observed`: signal after signal, by the record's rows. `place`: where in the record each is, 0..1."""

    def __init__(self, scene, survey, parameters, record, signals=()):
        check(record)
        self.record, self.remarks = record, record.remarks
        self.names = [name for name in COMPARED if name in record and (not signals or name in signals)]
        self.blueprint = Blueprint(record.name, scene, survey, [(p.name, p.keys, p.times) for p in parameters if p.signal is None])
        self.observed = numpy.concatenate(list(compared(record, self.names, standstills(record)).values()))
        self.signals = numpy.repeat(self.names, len(record.time))
        self.length = record.time[-1]  # [s]
        self.place = numpy.tile(record.time / self.length, len(self.names))

    def tasks(self, points):
        return [(self.blueprint, self.record, self.names, point) for point in points]

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
        self.signals = numpy.repeat("hook_load", len(self.observed))
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
    """Runs a model's tasks here, or on the workers of drill_campaign's engine."""

    def __init__(self, model, workers=1, scheduler=None):
        self.model, self.function = model, play_record if isinstance(model, RecordModel) else hang_string
        self.client, self.open = None, []
        if workers != 1 or scheduler:
            from drill_rig_sim.campaign import engine  # needs Dask
            self.client, self.open = engine.connect(scheduler, 0, workers)

    def __call__(self, points):
        tasks = self.model.tasks(points)
        answers = [self.function(task) for task in tasks] if self.client is None else self.client.gather(self.client.map(self.function, tasks, pure=False, batch_size=1000))
        return self.model.join(answers, len(points))

    def why(self, point):
        """Why a point's first task cannot be played."""
        try:
            (played if isinstance(self.model, RecordModel) else hung)(self.model.tasks([point])[0])
        except Refused as error:
            return one_line(error, self.model.blueprint)
        return "no equilibrium"

    def close(self):
        for thing in [self.client] * (self.client is not None) + self.open:
            thing.close()


def scene_and_survey(file):
    """Texts of a scene's file and of the survey's that it names."""
    try:
        scene = read_text(file)
        SceneText(scene, [])
        survey = survey_file(scene, file)
        return scene, None if survey is None else read_text(survey)
    except (TextError, SceneTextError) as error:
        raise ModelError(str(error))
