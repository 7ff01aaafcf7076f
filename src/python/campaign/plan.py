# SPDX-License-Identifier: BSD-3-Clause
"""Reads a campaign's plan: a Plan, or a PlanError that names file, line and key."""
import os

from drill_rig_sim.campaign import plan_checks
from drill_rig_sim.campaign.blueprint import SEED, Blueprint, SourceError, source_at
from drill_rig_sim.campaign.designs import KINDS, DesignError, Factor, rows_of
from drill_rig_sim.campaign.measures import split
from drill_rig_sim.campaign.plan_text import plan_of
from drill_rig_sim.campaign.scene_text import SceneTextError, survey_file
from drill_rig_sim.lockstep import Refused
from drill_rig_sim.sim import found
from drill_rig_sim.text_file import TextError, read_text

KEYS = ("name", "scene", "duration", "rate", "every", "from", "seed", "controller", "factors", "sample", "judge", "outputs", "bounds", "audit", "report")
FACTOR_KEYS = ("name", "key", "keys", "values", "from", "to", "log", "times")
NUMBERED = ("latin_hypercube", "sobol", "saltelli")
JUDGE = ("plan", "bit_diameter", "wob", "wob_band", "toolface", "toolface_band")  # as drill score's function has them
MOST_RUNS = 10**6


class Plan:
    """`blueprint` of a run; `rows` of values, one a run, of the factors `names`; `sample`: kind, runs, steps, seed; `report`: what the page shows; `audit`: which
    share of the runs is verified, None where the plan does not say. `places`: the entries where factors' keys stand, by key, and the controller's class; `outputs`:
    the entries of the outputs, by name."""

    def __init__(self, blueprint, names, rows, sample, report, audit, file, places, outputs):
        self.blueprint, self.names, self.rows, self.sample, self.report, self.audit = blueprint, names, rows, sample, report, audit
        self.file, self.places, self.outputs = file, places, outputs
        self.text = read_text(file)


def read_plan(file):
    top = plan_of(file)
    entries = top.mapping(KEYS, needed=("scene", "factors", "sample", "outputs"))
    base = os.path.dirname(os.path.abspath(file))
    factors, keys, places = factors_of(entries["factors"])
    blueprint = blueprint_of(entries, base, keys, places, os.path.splitext(os.path.basename(file))[0])
    sample = sample_of(entries["sample"], factors)
    try:
        rows = rows_of(factors, **sample)
    except DesignError as error:
        entries["sample"].fail(str(error))
    if len(rows) > MOST_RUNS:
        entries["sample"].fail("these are %d runs, allowed: up to %d" % (len(rows), MOST_RUNS))
    report = report_of(entries.get("report"), [factor.name for factor in factors], list(blueprint.outputs))
    places = {**dict(places), **({plan_checks.CLASS: entries["controller"].mapping()["class"]} if "controller" in entries else {})}
    audit = entries["audit"].number(0.0, most=1.0) if "audit" in entries else None
    return Plan(blueprint, [factor.name for factor in factors], rows, sample, report, audit, file, places, entries["outputs"].mapping())


def factors_of(entry):
    """Factors, their keys as the blueprint has them, and each key with its entry."""
    factors, keys, places = [], [], []
    for item in entry.sequence():
        parts = item.mapping(FACTOR_KEYS, needed=("name",))
        if ("key" in parts) == ("keys" in parts):
            item.fail("needs key or keys, not both")
        name = parts["name"].text()
        if name in [factor.name for factor in factors]:
            parts["name"].fail("%s: there is one of this name" % name)
        named = [(one.text(), one) for one in ([parts["key"]] if "key" in parts else parts["keys"].sequence())]
        if SEED in dict(named):
            plan_checks.check_seed(item, parts)
        factors.append(range_of(item, name, parts))
        times = "times" in parts and parts["times"].yes()
        if times and (factors[-1].unit or any(split(value)[1] for value in factors[-1].values or ())):
            parts["times"].fail("multiplies the scene's value, needed: numbers without units")
        keys.append((name, [key for key, _ in named], times))
        places += named
    return factors, keys, places


def range_of(item, name, parts):
    if "values" in parts:
        for other in ("from", "to", "log"):
            if other in parts:
                parts[other].fail("is given together with values, allowed: values, or from and to")
        return Factor(name, values=[one.plain() for one in parts["values"].sequence()])
    for needed in ("from", "to"):
        if needed not in parts:
            item.fail("needs values, or from and to")
    log = "log" in parts and parts["log"].yes()
    low, unit = parts["from"].measure(beyond=0.0 if log else None)
    return Factor(name, low=low, high=parts["to"].measure(beyond=low, unit=unit)[0], log=log, unit=unit)


def sample_of(entry, factors):
    parts = entry.mapping(("kind", "runs", "steps", "seed"), needed=("kind",))
    kind = parts["kind"].choice(tuple(KINDS))
    wanted = "runs" if kind in NUMBERED else "steps"
    other = "steps" if wanted == "runs" else "runs"
    if other in parts:
        parts[other].fail("%s has %s" % (kind, wanted))
    if wanted not in parts and (kind in NUMBERED or any(factor.values is None for factor in factors)):
        entry.fail("%s needs %s" % (kind, wanted))
    return {"kind": kind, "runs": parts["runs"].whole(1, MOST_RUNS) if "runs" in parts else 0, "steps": parts["steps"].whole(1, 10000) if "steps" in parts else 0,
            "seed": parts["seed"].whole() if "seed" in parts else 0}


def blueprint_of(entries, base, keys, places, name):
    scene_file = file_of(entries["scene"], base, "config/scenes")
    scene = read(entries["scene"], scene_file)
    survey = survey_of(entries["scene"], scene, scene_file)
    plan_checks.check_keys(places, scene, survey is not None, "controller" in entries)
    controller, parameters = controller_of(entries.get("controller"), base, places, {key for _, named, times in keys if times for key in named})
    numbers = {name: entries[key].number(least, beyond) for key, name, least, beyond in
               (("duration", "duration", None, 0.0), ("rate", "rate", 1.0, None), ("every", "every", None, 0.0), ("from", "begin", 0.0, None)) if key in entries}
    bounds = entries["bounds"].mapping(("cpu", "wall", "memory")) if "bounds" in entries else {}
    judge = judge_of(entries.get("judge"), base)
    blueprint = Blueprint(entries["name"].text() if "name" in entries else name, scene, survey, keys, controller, parameters,
                          seed=entries["seed"].whole() if "seed" in entries else 0, outputs=outputs_of(entries["outputs"], base), judge=judge,
                          **numbers, **{key: bound.number(beyond=0.0) for key, bound in bounds.items()})
    plan_checks.check_times(entries, blueprint)
    return blueprint


def survey_of(entry, scene, scene_file):
    """The text of the survey that a scene names, None where it names none."""
    try:
        file = survey_file(scene, scene_file)
    except SceneTextError as error:
        return entry.fail(str(error))
    return None if file is None else read(entry, file)


def controller_of(entry, base, places, multiplied):
    if entry is None:
        return None, {}
    parts = entry.mapping(("class", "parameters"), needed=("class",))
    source = source_of(parts["class"], base)
    given = parts["parameters"].mapping() if "parameters" in parts else {}
    plan_checks.check_parameters(parts["class"], source.load(), given, places, multiplied)
    return source, {name: value.plain() for name, value in given.items()}


def source_of(entry, base):
    """file.py:Name from the plan's folder, or package.module:Name."""
    where = entry.text()
    module, colon, name = where.rpartition(":")
    if not colon or not name.isidentifier():
        entry.fail("is %s, needed: FILE.py:NAME or PACKAGE.MODULE:NAME" % where)
    try:
        source = source_at(where, base)
        source.load()
        return source
    except (OSError, UnicodeDecodeError) as error:
        return entry.fail("%s: %s" % (os.path.join(base, module), getattr(error, "strerror", None) or error))
    except SourceError as error:
        return entry.fail("%s: %s" % (where, error))


def outputs_of(entry, base):
    found_outputs = {name: source_of(value, base) if ":" in value.text() else value.text() for name, value in entry.mapping().items()}
    return found_outputs if found_outputs else entry.fail("needs one or more")


def judge_of(entry, base):
    if entry is None:
        return {}
    parts = entry.mapping(JUDGE)
    return {name: read(value, file_of(value, base, "config/surveys")) if name == "plan" else value.number() for name, value in parts.items()}


def report_of(entry, factors, outputs):
    """The map's two factors and output, for each value of another factor if `each` is given; and by which output runs are worst: by default the first of each,
    the largest."""
    parts = entry.mapping(("map", "each", "worst")) if entry is not None else {}
    shown = {"map": factors[:2] + outputs[:1] if len(factors) > 1 else [], "each": None, "worst": outputs[0], "least": False}
    if "each" in parts:
        shown["each"] = parts["each"].choice(factors)
    if "map" in parts:
        words = parts["map"].sequence()
        if len(words) != 3:
            parts["map"].fail("needed: two factors and an output")
        shown["map"] = [words[0].choice(factors), words[1].choice(factors), words[2].choice(outputs)]
    if "worst" in parts:
        worst = parts["worst"].mapping(("output", "least"), needed=("output",))
        shown["worst"], shown["least"] = worst["output"].choice(outputs), "least" in worst and worst["least"].yes()
    return shown


def file_of(entry, base, folder):
    """From the plan's folder, else as a node finds it."""
    beside = os.path.join(base, entry.text())
    if os.path.isfile(beside) and not os.path.samefile(beside, entry.file):
        return beside
    try:
        return found(entry.text(), folder)
    except Refused as error:
        return entry.fail(str(error))


def read(entry, file):
    try:
        return read_text(file)
    except TextError as error:
        return entry.fail(str(error))
