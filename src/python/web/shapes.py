# SPDX-License-Identifier: BSD-3-Clause
"""Messages that describe a rig, as the page takes them: plain dicts in SI units."""
import math

import numpy
import yaml
from drill_rig_sim.tables import TOP_DRIVE_MODES
from drill_rig_sim.web.bins import numbers

MOST_POINTS = 600  # of a path
MODES = tuple(word.upper() for word in TOP_DRIVE_MODES)
RUN_STATES = ("RUNNING", "PAUSED", "WAITING", "FAILED")


def set_points_of(state):
    """Those in force, of RigState."""
    return {"block_velocity": state.winch.block_velocity, "brake": state.winch.brake, "mode": MODES[min(state.top_drive.mode, len(MODES) - 1)],
            "rpm": state.top_drive.speed, "torque_limit": state.top_drive.torque_limit, "flow": state.mud_pump.flow}


def limits_of(message):
    return {"hook_load": message.max_hook_load, "torque": message.max_top_drive_torque, "rpm": message.max_top_drive_speed, "flow": message.max_flow,
            "pressure": message.relief_pressure, "block_lowest": message.lowest_block_height, "block_highest": message.highest_block_height,
            "trip_hook_load": message.trip_hook_load, "block_speed": message.max_block_speed}


def parts_of(message):
    """Of the string, bit first."""
    return [{"name": name, "length": length, "joint": joint, "diameter": diameter, "bore": bore}
            for name, length, joint, diameter, bore in zip(message.part_name, message.part_length, message.part_joint_length,
                message.part_diameter, message.part_bore)]


def path_of(points):
    """East, north and depth of points of a message, rows."""
    return thinned(numpy.array([(p.x, p.y, -p.z) for p in points], dtype=float).reshape(-1, 3))


def thinned(table):
    """At most MOST_POINTS of a path, the last one always."""
    if len(table) > MOST_POINTS:
        table = table[numpy.unique(numpy.linspace(0, len(table) - 1, MOST_POINTS).astype(int))]
    return table


def offsets(path, plan):
    """From each point to the plan [m]: distance, and its share to the right and upwards, seen along the plan; nan beyond the ends of the plan."""
    starts, steps = plan[:-1], numpy.diff(plan, axis=0)
    lengths = (steps**2).sum(axis=1)
    found = []
    for point in path:
        share = ((point - starts) * steps).sum(axis=1) / lengths
        away = point - starts - numpy.clip(share, 0.0, 1.0)[:, None] * steps
        n = int(numpy.argmin((away**2).sum(axis=1)))
        away = point - starts - share[:, None] * steps if n in (0, len(lengths) - 1) else away  # at the ends the plan goes on
        beyond = (n == len(lengths) - 1 and share[n] > 1.0 + 0.1 / math.sqrt(lengths[n])) or (n == 0 and share[0] < 0.0)
        found.append((math.nan,) * 3 if beyond else (float(numpy.linalg.norm(away[n])), *sides(away[n], steps[n])))
    return numpy.array(found, dtype=float).reshape(-1, 3)


def sides(away, along):
    """How far right and up, seen along a direction; near vertical, right is east and up is north. Axes: east, north, down."""
    level = math.hypot(along[0], along[1])
    if level < 0.02 * numpy.linalg.norm(along):
        return float(away[0]), float(away[1])
    right = numpy.array((along[1], -along[0], 0.0)) / level
    up = numpy.cross(along / numpy.linalg.norm(along), right)
    up = up if up[2] < 0.0 else -up
    return float(away @ right), float(away @ up)


def well_of(path, plan, begin=0.0):
    """Drilled path and plan with the section plane through the end of the plan (else of the path), and deviation against measured depth, which is
    `begin` at the first point."""
    target = (plan if len(plan) else path)[-1] if len(plan) or len(path) else numpy.zeros(3)
    azimuth = math.atan2(target[0], target[1])
    drawn = {"azimuth": azimuth, "path": table_of(path, azimuth), "plan": table_of(plan, azimuth), "deviation": None}
    if len(plan) > 1 and len(path):
        depths = begin + numpy.concatenate([[0.0], numpy.cumsum(numpy.linalg.norm(numpy.diff(path, axis=0), axis=1))])
        away = offsets(path, plan)
        drawn["deviation"] = {"depth": numbers(depths), **{name: numbers(away[:, n]) for n, name in enumerate(("distance", "right", "up"))}}
    return drawn


def table_of(points, azimuth):
    across = points[:, 0] * math.sin(azimuth) + points[:, 1] * math.cos(azimuth)
    return {"east": numbers(points[:, 0]), "north": numbers(points[:, 1]), "depth": numbers(points[:, 2]), "section": numbers(across)}


def parts_of_scene(text):
    """The list `string` of a scene's text; [] where it cannot be read."""
    try:
        scene = yaml.safe_load(text)
    except yaml.YAMLError:
        return []
    parts = scene.get("string") if isinstance(scene, dict) else None
    return [part for part in parts if isinstance(part, dict)] if isinstance(parts, list) else []


class Strength:
    """Yield load and make-up torque along a string, by RigDescription and the scene's parts, which may say more."""
    yield_strength = 7.24e8  # where the scene does not say it: grade G-105 [Pa]

    def __init__(self, parts, scene):
        lengths = [part["length"] if part["length"] > 0.0 else math.inf for part in parts]
        self.ends = numpy.cumsum(lengths)
        area = [0.25 * math.pi * (part["diameter"]**2 - part["bore"]**2) for part in parts]
        said = [scene[n] if n < len(scene) else {} for n in range(len(parts))]
        self.yield_load = [number(one.get("yield_strength"), self.yield_strength) * a for one, a in zip(said, area)]
        self.make_up = [number(one.get("make_up_torque"), 0.0) or math.nan for one in said]

    def at(self, from_bit):
        """(yield loads, make-up torques) at these distances from the bit; nan: not known."""
        if not len(self.ends):
            return numpy.full((2, len(from_bit)), numpy.nan)
        part = numpy.minimum(numpy.searchsorted(self.ends, from_bit), len(self.ends) - 1)
        return numpy.array(self.yield_load)[part], numpy.array(self.make_up)[part]


def number(value, otherwise):
    return float(value) if isinstance(value, (int, float)) else otherwise


def string_of(message, strength):
    """Of DrillstringState: forces along the string with what bounds them, by measured depth, the bit first."""
    md, from_bit, tension, factor = (numpy.array(values) for values in (message.md, message.from_bit, message.tension, message.buckling_factor))
    length = numpy.gradient(from_bit) if len(from_bit) > 1 else numpy.ones(len(from_bit))
    with numpy.errstate(divide="ignore", invalid="ignore"):
        critical = numpy.where((factor > 0.02) & (tension < 0.0), tension / factor, numpy.nan)
        side = numpy.array(message.contact_force) / length
    yields, make_up = strength.at(from_bit)
    columns = {"md": md, "tension": tension, "critical": critical, "yield": yields, "torque": message.torque, "make_up": make_up, "side": side}
    return {"t": message.header.stamp.to_sec(), **{name: numbers(values) for name, values in columns.items()}}
