"""What a run is made of, whole: the scene's text and the files that it names, controller and functions as sources. It goes to the workers and needs
nothing that lies on a disk of theirs but the installed package."""
import atexit
import hashlib
import json
import os
import shutil
import tempfile

from drill_rig_sim.campaign.scene_text import SceneText, Times

SEED = "seed"               # a factor's key that is none of the scene
CONTROLLER = "controller."  # before the controller's parameters


class Source:
    """Of a class or function, `where` as in laws.py:Steady or package.module:Steady: a file's text comes along."""

    def __init__(self, where, text=None):
        self.where, self.text = where, text
        self.module, _, self.name = where.rpartition(":")

    def load(self):
        """The object."""
        if self.text is None:
            import importlib
            return getattr(importlib.import_module(self.module), self.name)
        scope = {"__name__": "drill_campaign_" + hashlib.sha256(self.text.encode()).hexdigest()[:12]}
        exec(compile(self.text, self.module, "exec"), scope)  # pylint: disable=exec-used
        return scope[self.name]


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
        self.template = SceneText(scene, [key for _, keys, _ in factors for key in keys if in_scene(key)] + (["well.survey"] if survey is not None else []))
        self.folder = None

    def values_by_key(self, row):
        """Of a row of factors' values."""
        return {key: Times(value) if times else value for (_, keys, times), value in zip(self.factors, row) for key in keys}

    def scene_of(self, row, survey="survey.csv"):
        """The scene's text for a row, with this for its survey's file."""
        return self.template.with_values({**self.values_by_key(row), "well.survey": survey})

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
        """What drill score is told, its plan as a file."""
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


def in_scene(key):
    return key != SEED and not key.startswith(CONTROLLER)
