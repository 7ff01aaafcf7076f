# SPDX-License-Identifier: BSD-3-Clause
"""One run of a blueprint in this process, and what is asked of it."""
import math

import numpy
from drill_rig_sim.campaign.blueprint import USER_ERRORS, error_line
from drill_rig_sim.control import drive
from drill_rig_sim.lockstep import series
from drill_rig_sim.score import score
from drill_rig_sim.score_runs import run_of_record, run_of_states
from drill_rig_sim.sim import Simulator

STATISTICS = {
    "mean": lambda values, weights: numpy.average(values, weights=weights),
    "deviation": lambda values, weights: math.sqrt(numpy.average((values - numpy.average(values, weights=weights))**2, weights=weights)),
    "least": lambda values, weights: values.min(), "largest": lambda values, weights: values.max(),
    "first": lambda values, weights: values[0], "last": lambda values, weights: values[-1]}
ZEROED = {"readings": ("surface_wob", "differential_pressure"), "truth": ("surface_wob",), "bit": ()}  # nan until they have been zeroed
TEMPERATURES = ("flow_line_temperature", "bottom_hole_temperature")  # 0 without mud.temperature
SIDES = ("readings", "truth", "bit")


class Unjudged(Exception):
    """A run went to its end, but an output cannot be determined: which, and why."""


class Played:
    """A run that is over. `t` [s]; readings(name), truth(name), bit(name): a number each, by the fields of RigState and BitTruth, nan where a reading
    has not been zeroed (ZEROED); `run`: as drill score takes it;
    `whole`: that from its beginning on, with what does not count; `scores`: drill score's; `done`: whether the controller reports it (None without one)."""

    def __init__(self, blueprint, record, states, done):
        self.done, self._record, self._states = done, record, states
        t = record.t if states is None else series(states, "t")
        self.counted = t > blueprint.begin
        if not self.counted.sum() > 1:
            raise Unjudged("the run ended at %g s, with fewer than two rows after `from`, %g s" % (t[-1] if len(t) else 0.0, blueprint.begin))
        self.whole = run_of_record(record, blueprint.name) if states is None else run_of_states(states, blueprint.name)
        self.t = t[self.counted]
        self.run = type(self.whole)({name: values[self.counted] for name, values in self.whole.columns.items()}, self.whole.source, blueprint.name)
        self._judge = blueprint.judge_files()
        self._scores = None

    @property
    def scores(self):
        if self._scores is None:
            self._scores = score(self.run, **self._judge)
        return self._scores

    def readings(self, name):
        return self._side("readings", name)

    def truth(self, name):
        return self._side("truth", name)

    def bit(self, name):
        return self._side("bit", name)

    def _side(self, side, name):
        values = self._numbers(side, name)
        if name in TEMPERATURES:
            return numpy.where(values == 0.0, numpy.nan, values)
        return numpy.where(self._numbers("readings", "tared"), values, numpy.nan) if name in ZEROED[side] else values

    def _numbers(self, side, name):
        if self._states is not None:
            return series(self._states, side + "." + name)[self.counted].astype(float)
        return getattr(self._record, side)[name][self.counted].astype(float)

    def output(self, asked):
        """By a path of drill score's (wob.mean), a statistic over time (mean.readings.surface_wob), or a function of this run. A number, or None."""
        if callable(asked):
            return number(asked(self))
        first, _, rest = asked.partition(".")
        if first in STATISTICS:
            side, _, name = rest.partition(".")
            values = self._side(side, name)
            known = ~numpy.isnan(values)
            return number(STATISTICS[first](values[known], numpy.gradient(self.t)[known])) if known.any() else None
        value = self.scores
        for name in asked.split("."):
            value = None if value is None else value[name]
        return number(value)


def number(value):
    """As JSON has them; what is no finite number is None."""
    try:
        value = None if value is None else float(value)
    except (TypeError, ValueError):
        raise Unjudged("returns %.60r, needed: a number or None" % (value,)) from None
    return value if value is not None and math.isfinite(value) else None


def play(blueprint, row, rig=None):
    """The run of a row of factors' values."""
    rig = rig or simulator(blueprint, row)
    every = round(blueprint.every * rig.rate)
    if blueprint.controller is None:
        return Played(blueprint, rig.record(blueprint.duration, every), None, None)
    law = blueprint.controller.load()(**blueprint.parameters_of(row))
    states = drive(rig, law, blueprint.duration, telemetry=rig)
    return Played(blueprint, None, states, bool(law.done))


def simulator(blueprint, row):
    return Simulator(blueprint.written(row), rate=blueprint.rate, seed=blueprint.seed_of(row), play_program=blueprint.controller is None)


def outputs_of(blueprint, played):
    """Numbers by the outputs' names."""
    return {name: output_of(name, what, played) for name, what in blueprint.outputs.items()}


def output_of(name, what, played):
    try:
        return played.output(what if isinstance(what, str) else what.load())
    except Unjudged as problem:
        raise Unjudged("%s: %s" % (name, problem)) from None
    except MemoryError:
        raise
    except USER_ERRORS as error:
        raise Unjudged("%s: %s" % (name, error_line(error, "" if isinstance(what, str) else what.module))) from error
