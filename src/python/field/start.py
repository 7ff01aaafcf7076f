# SPDX-License-Identifier: BSD-3-Clause
"""A scene as the start of a replay: begun where the record begins, without a crew that makes connections of its own."""
import math

import yaml

from drill_rig_sim.campaign.blueprint import Blueprint
from drill_rig_sim.campaign.refusal_of_user import line_of_user
from drill_rig_sim.campaign.scene_text import SceneTextError
from drill_rig_sim.field.pipe import clock, first_hung
from drill_rig_sim.field.record import RecordError
from drill_rig_sim.field.window import between
from drill_rig_sim.lockstep import Failed, Refused
from drill_rig_sim.sim import Simulator
from drill_rig_sim.text_file import stands_for

FROM = ("scene", "record")  # where the start is taken from


def on_hook(record, begin=-math.inf, end=math.inf):
    """The part of a record between two times in it [s] that begins where the string hangs on the hook; and lines on it."""
    part = between(record, begin, end)
    first = first_hung(part)
    if not first:
        return part, []
    return between(part, part.time[first], math.inf), ["%s: begins with the string in the slips: played from %.1f s on" % (part.name, clock(part, first))]


def start_keys(scene, record, start_from=""):
    """Values of the scene's keys that make it begin where the record does, and lines on them. `start_from`: of FROM; "": the scene, or the record where the
    scene's text has no start.bit_depth."""
    tree = yaml.safe_load(scene) or {}
    values, lines = {}, []
    if tree.get("connections") == "auto":
        values["connections"] = "off"
        lines.append("connections: auto of the scene is switched off: connections are made where the record has them")
    given = "bit_depth" in (tree.get("start") or {})
    if "bit_depth" in record and (start_from == "record" or not (given or start_from)):
        values["start.bit_depth"] = depth = float(record.at("bit_depth", 0.0))
        if "block_height" in record:
            values["start.block_height"] = float(record.at("block_height", 0.0))
        if "hole_depth" in record:
            values["well.hole_depth"] = max(depth, float(record.at("hole_depth", 0.0)))
        lines.append("the scene is started where the record begins: %s" % ", ".join("%s %.2f m" % (key, value) for key, value in values.items() if key != "connections"))
    return values, ["%s: %s" % (record.name, line) for line in lines]


def simulator_of(file, scene, survey, values):
    """The rig of a scene's text with these values; Refused with one line that names the scene's file, and the survey's."""
    if not values:
        return Simulator(file)
    try:
        blueprint = Blueprint(file, scene, survey, [(key, [key], False) for key in values])
    except SceneTextError as error:
        raise RecordError("%s: %s" % (file, error))
    try:
        return Simulator(stands_for(blueprint.written(list(values.values())), file))
    except Failed:
        raise
    except Refused as error:
        raise Refused(line_of_user(error, blueprint, list(values.values()), file))
