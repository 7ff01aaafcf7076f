# SPDX-License-Identifier: BSD-3-Clause
"""What is seen before a campaign runs, so that it is refused by the plan's line: factors' keys, times, the controller and its parameters, and by the rig of one of
the first runs the checks that need a rig."""
import inspect
import re

from drill_rig_sim.campaign import played
from drill_rig_sim.campaign.blueprint import CONTROLLER, USER_ERRORS, error_line, in_scene
from drill_rig_sim.campaign.outputs import check
from drill_rig_sim.campaign.plan_text import PlanError
from drill_rig_sim.campaign.runner import one_line
from drill_rig_sim.campaign.scene_text import SceneText, SceneTextError, survey_of_well
from drill_rig_sim.control import frames_of
from drill_rig_sim.lockstep import Refused
from drill_rig_sim.sim import build

TRIED = 10  # of the first runs, whether one can be built
CLASS = CONTROLLER + "class"  # in a plan's places
NEEDED = ("period", "done", "step")  # of a law

# --- only by the plan


def check_seed(item, parts):
    """Of the factor that is the seed."""
    if "values" not in parts or ("times" in parts and parts["times"].yes()):
        item.fail("a seed needs values, whole numbers")
    for one in parts["values"].sequence():
        one.whole()


def check_keys(places, scene, has_survey, has_controller):
    """Each factor's key is one, and no two lead to the same place. `places`: keys with their entries."""
    of_scene, others = [survey_of_well(scene, "the scene")[0]] if has_survey else [], []
    for key, entry in places:
        if in_scene(key):
            of_scene.append(key)
            try:
                SceneText(scene, of_scene)
            except SceneTextError as error:
                entry.fail(str(error))
            continue
        if key.startswith(CONTROLLER) and not has_controller:
            entry.fail("%s: the plan has no controller" % key)
        for other in others:
            if (key + ".").startswith(other + ".") or (other + ".").startswith(key + "."):
                entry.fail("%s and %s are the same key" % (other, key))
        others.append(key)


def check_times(entries, blueprint):
    """Of the run: whole frames, and what counts is not after its end."""
    if not blueprint.begin < blueprint.duration:
        entries["from"].fail("is %g, needed: a number below the duration, %g" % (blueprint.begin, blueprint.duration))
    for name in ("every", "duration"):
        frames = getattr(blueprint, name) * blueprint.rate
        if round(frames) < 1 or abs(frames - round(frames)) > 1e-6 * frames:
            where = entries.get(name) or entries.get("rate") or entries["scene"]
            where.fail("%s, %g s, is not a whole number of frames of %g s" % (name, getattr(blueprint, name), 1.0 / blueprint.rate))


def check_parameters(entry, law, given, places, multiplied):
    """That a controller's class takes the plan's parameters, and has all that it needs. `given`: entries by name; `multiplied`: keys of factors that multiply."""
    if not callable(law):
        entry.fail("is no class")
    values = {name: value.plain() for name, value in given.items()}
    named = dict(given)
    for key, place in places:
        if key.startswith(CONTROLLER):
            names = key[len(CONTROLLER):].split(".")
            check_place(place, names, values, key in multiplied)
            named.setdefault(names[0], place)
    try:
        wanted = inspect.signature(law).parameters.values()
    except (TypeError, ValueError):
        return  # has no check of its own
    allowed = [one.name for one in wanted if one.kind in (one.POSITIONAL_OR_KEYWORD, one.KEYWORD_ONLY)]
    for name, place in named.items():
        if name not in allowed and not any(one.kind == one.VAR_KEYWORD for one in wanted):
            place.fail("%s has no parameter %s, allowed: %s" % (entry.text(), name, ", ".join(allowed) or "none"))
    missing = [one.name for one in wanted if one.name in allowed and one.default is one.empty and one.name not in named]
    if missing:
        entry.fail("%s needs the parameter %s" % (entry.text(), ", ".join(missing)))


def check_place(entry, names, values, multiplied):
    """That a factor's value can go into the parameters there."""
    for name in names[:-1]:
        values = values.setdefault(name, {})
        if not isinstance(values, dict):
            entry.fail("the parameter %s has no keys" % name)
    if multiplied and not isinstance(values.get(names[-1]), (int, float)):
        entry.fail("the plan gives no number for it, which could be multiplied")


# --- by the first runs


def first_rig(plan):
    """Build and kernel, by the rig of one of the first runs; that one can be built with its controller and that outputs are there is seen too."""
    for row in plan.rows[:TRIED]:
        try:
            rig = played.simulator(plan.blueprint, row)
            check_outputs(plan, rig)
            check_law(plan, row)
            return [build(), rig.kernel]
        except (Refused, SceneTextError) as error:
            refusal = one_line(error, plan.blueprint)
            entry = entry_of(plan, row, refusal)
        except LawError as error:
            refusal, entry = str(error), plan.places[CLASS]
    text = "%s: %s" % ("the only run is refused" if len(plan.rows) == 1 else "each of the first %d runs is refused, the last" % len(plan.rows[:TRIED]), refusal)
    if entry is not None:
        entry.fail(text)
    raise PlanError("%s: %s" % (plan.file, text))


class LawError(Exception):
    """Why a controller cannot be made of a run's parameters."""


def entry_of(plan, row, refusal):
    """The plan's entry of the factor whose value is refused, None where it is none of them: the one that stands on the line that the refusal names."""
    keys = [key for key in plan.places if refusal.startswith(key + ": ")]
    line = re.match(r"scene\.yaml:(\d+): ", refusal)
    if line:
        keys = plan.blueprint.template.keys_on(int(line.group(1)), plan.blueprint.values_with_survey(row))
        keys = [key for key in keys if re.search(r"\b%s\b" % re.escape(key.split(".")[-1]), refusal)] or keys
    return plan.places.get(keys[0]) if keys else None


def check_outputs(plan, rig):
    """That each output by a path is one."""
    for name, what in plan.blueprint.outputs.items():
        problem = check(what, rig) if isinstance(what, str) else ""
        if problem:
            plan.outputs[name].fail(problem)


def check_law(plan, row):
    """That a run's controller can be made, and is a law."""
    blueprint = plan.blueprint
    if blueprint.controller is None:
        return
    try:
        law = blueprint.controller.load()(**blueprint.parameters_of(row))
        missing = [name for name in NEEDED if not hasattr(law, name)]
    except USER_ERRORS as error:
        raise LawError(error_line(error, blueprint.controller.module)) from error
    where = plan.places[CLASS]
    if missing or not callable(law.step):
        where.fail("%s has no %s; a law needs period [s], done and step(readings)" % (where.text(), ", ".join(missing) or "step(readings)"))
    try:
        frames_of(law.period, blueprint.rate)
    except (TypeError, ValueError) as error:
        where.fail("%s: %s" % (where.text(), error if isinstance(error, ValueError) else "its period is %r, needed: a number [s]" % (law.period,)))
