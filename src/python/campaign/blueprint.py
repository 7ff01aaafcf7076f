# SPDX-License-Identifier: BSD-3-Clause
"""What a run is made of, whole: the scene's text and the files that it names, controller and functions as sources. It goes to the workers and needs
nothing that lies on a disk of theirs but the installed package."""
import atexit
import hashlib
import json
import os
import shutil
import tempfile
import traceback

from drill_rig_sim.campaign.scene_text import SceneText, Times, survey_of_well

SEED = "seed"               # a factor's key that is none of the scene
CONTROLLER = "controller."  # before the controller's parameters
PARTS = ("name", "scene", "survey", "factors", "controller", "parameters", "duration", "rate", "every", "begin", "seed", "outputs", "judge", "cpu", "wall", "memory")

USER_ERRORS = (Exception, SystemExit)  # of a user's code: sys.exit() in it ends its run, not the campaign


class SourceError(Exception):
    """Why there is no such class or function, in one line."""


class Source:
    """Of a class or function, `where` as in laws.py:Steady or package.module:Steady: a file's text comes along."""

    def __init__(self, where, text=None):
        self.where, self.text = where, text
        self.module, _, self.name = where.rpartition(":")

    def parts(self):
        """By the names of its arguments."""
        return {"where": self.where, "text": self.text}

    def load(self):
        """The object; a SourceError where there is none."""
        try:
            if self.text is None:
                import importlib
                scope = vars(importlib.import_module(self.module))
            else:
                scope = {"__name__": "drill_campaign_" + hashlib.sha256(self.text.encode()).hexdigest()[:12]}
                exec(compile(self.text, self.module, "exec"), scope)  # pylint: disable=exec-used
        except USER_ERRORS as error:
            raise SourceError(error_line(error, self.module)) from error
        if self.name not in scope:
            raise SourceError("%s has no %s" % (self.module, self.name))
        return scope[self.name]


def source_at(where, folder=""):
    """Of FILE.py:NAME, from this folder, or PACKAGE.MODULE:NAME. OSError and UnicodeDecodeError where the file cannot be read."""
    file = where.rpartition(":")[0]
    if not file.endswith(".py"):
        return Source(where)
    with open(os.path.join(folder, file), encoding="utf-8") as text:
        return Source(where, text.read())


class Blueprint:
    """Made by plan.py. `factors`: name, keys and whether it multiplies. Times in s, CPU and wall; memory in bytes beyond what a runner has at its start."""

    def __init__(self, name, scene, survey, factors, controller=None, parameters=None, duration=60.0, rate=100.0, every=0.1, begin=0.0, seed=0, outputs=None,
                 judge=None, cpu=600.0, wall=3600.0, memory=2e9):
        self.name, self.scene, self.survey = name, scene, survey    # texts
        self.factors = factors                                      # [(name, keys, times)]
        self.controller, self.parameters = controller, parameters or {}
        self.duration, self.rate, self.every, self.begin, self.seed = duration, rate, every, begin, seed
        self.outputs = outputs or {}                                # name: path or Source
        self.judge = judge or {}                                    # of drill score
        self.cpu, self.wall, self.memory = cpu, wall, memory
        self.survey_key = survey_of_well(scene, name)[0]
        self.template = SceneText(scene, [key for _, keys, _ in factors for key in keys if in_scene(key)] + ([self.survey_key] if survey is not None else []))
        self.folder = None

    def parts(self):
        """All of it as JSON has it; of_parts() makes it again."""
        outputs = {name: what.parts() if isinstance(what, Source) else what for name, what in self.outputs.items()}
        return {**{name: getattr(self, name) for name in PARTS}, "controller": self.controller and self.controller.parts(), "outputs": outputs}

    @staticmethod
    def of_parts(parts):
        outputs = {name: Source(**what) if isinstance(what, dict) else what for name, what in parts["outputs"].items()}
        return Blueprint(**{**parts, "controller": parts["controller"] and Source(**parts["controller"]), "outputs": outputs})

    def values_by_key(self, row):
        """Of a row of factors' values."""
        return {key: Times(value) if times else value for (_, keys, times), value in zip(self.factors, row) for key in keys}

    def scene_of(self, row, survey="survey.csv"):
        """The scene's text for a row, with this for its survey's file."""
        return self.template.with_values(self.values_with_survey(row, survey))

    def values_with_survey(self, row, survey="survey.csv"):
        """Of a row by key, with this for the survey's file."""
        return {**self.values_by_key(row), self.survey_key: survey}

    def seed_of(self, row):
        return int(self.values_by_key(row).get(SEED, self.seed))

    def parameters_of(self, row):
        """The controller's, those that are factors among them: set_points.weight goes into the mapping set_points."""
        parameters = json.loads(json.dumps(self.parameters))
        for key, value in self.values_by_key(row).items():
            if key.startswith(CONTROLLER):
                place, *names = key[len(CONTROLLER):].split(".")[::-1]
                at = parameters
                for name in names[::-1]:
                    at = at.setdefault(name, {})
                at[place] = float(value) * at[place] if isinstance(value, Times) else value
        return parameters

    def key_of(self, row, identity):
        """Hash of all that makes a run's results: scene, factors, seed, controller, outputs, and the build and kernel of `identity`."""
        parts = [self.scene_of(row), self.survey, self.seed_of(row), self.controller and (self.controller.where, self.controller.text), self.parameters_of(row),
                 self.duration, self.rate, self.every, self.begin, {name: (what.where, what.text) if isinstance(what, Source) else what for name, what in
                 self.outputs.items()}, self.judge, identity]
        return hashlib.sha256(json.dumps(parts, sort_keys=True).encode()).hexdigest()[:32]

    def written(self, row):
        """A file with the scene for a row, in a folder of this process's."""
        if self.survey is not None:
            self.file("survey.csv", self.survey)
        return self.file("scene.yaml", self.scene_of(row))

    def judge_files(self):
        """The options of drill score, its plan as a file."""
        return {**self.judge, **({"plan": self.file("plan.csv", self.judge["plan"])} if "plan" in self.judge else {})}

    def file(self, name, text):
        if self.folder is None:
            self.folder = tempfile.mkdtemp(prefix="drill_campaign_")
            atexit.register(shutil.rmtree, self.folder, ignore_errors=True)
        path = os.path.join(self.folder, name)
        with open(path, "w", encoding="utf-8") as out:
            out.write(text)
        return path

    def __getstate__(self):
        return {**self.__dict__, "folder": None}


def error_line(error, file=""):
    """An error of the user's code in one line: the place in the user's file, else the place of the error."""
    frames = traceback.extract_tb(error.__traceback__)
    at = ([frame for frame in frames if frame.filename == file] or frames)[-1]
    if isinstance(error, SyntaxError):
        return "%s, line %s: %s: %s" % (os.path.basename(error.filename or ""), error.lineno, type(error).__name__, error.msg)
    return "%s, line %d: %s: %s" % (os.path.basename(at.filename), at.lineno, type(error).__name__, " ".join(str(error).split()))


def in_scene(key):
    return key != SEED and not key.startswith(CONTROLLER)
