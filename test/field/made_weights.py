# SPDX-License-Identifier: BSD-3-Clause
"""A time log that the simulator made: a string is picked up, slacked off, turned, and a stand is added. Friction and block are known, the gauges are noisy."""
import itertools
import os

import yaml
from drill_rig_sim.sim import Simulator

FRICTION, BLOCK = 0.25, 17500.0  # [-], [kg]
NAMES = "time,reading_block_height,top_drive_speed,reading_flow,reading_hook_load,reading_torque,reading_bit_depth,reading_hole_depth"
SCENE = {
    "name": "weights", "well": {"stations": [[0, 0, 0], [300, 0, 0], [900, 40, 60], [1800, 40, 60]], "hole_depth": 1600.0,
                                "sections": [{"to": 1800, "diameter": 0.2159, "friction": FRICTION}]},
    "formation": [{"to_tvd": 5000, "drillability": 1.0e-9}], "mud": {"density": 1150}, "contact": {"static_ratio": 1.0}, "needs": ["hook_load", "torque"],
    "string": [{"name": "bit", "type": "bit", "length": 0.3, "mass": 40, "diameter": 0.2159},
               {"name": "collar", "type": "collar", "joints": 9, "joint_length": 9.4, "outer_diameter": 0.165, "inner_diameter": 0.0714, "linear_mass": 136},
               {"name": "drill_pipe", "type": "pipe", "joints": "fill", "joint_length": 9.5, "outer_diameter": 0.127, "inner_diameter": 0.1086, "linear_mass": 31.9,
                "tool_joint_diameter": 0.168}],
    "rig": {"hoisting": {"block_mass": BLOCK, "connection_time": 60}},
    "start": {"bit_depth": 1500.0, "block_height": 8.0}, "numerics": {"tolerance": 0.05},
    "instruments": {"surface": {"hook_load": {"place": "dead_line", "noise": 2000.0, "rate": 10}, "torque": {"noise": 100.0, "rate": 10}}},
    "operations": [{"do": "pick_up", "distance": 14.0, "speed": 0.2}, {"do": "wait", "time": 5.0}, {"do": "slack_off", "distance": 14.0, "speed": 0.2},
                   {"do": "rotate", "speed_rpm": 60.0, "ramp": 5.0, "time": 40.0}, {"do": "rotate", "speed_rpm": 0.0, "ramp": 5.0, "time": 5.0},
                   {"do": "pick_up", "distance": 5.0, "speed": 0.2}, {"do": "connection"}, {"do": "slack_off", "distance": 12.0, "speed": 0.2}]}


def write_scene(folder):
    """Its path."""
    path = os.path.join(folder, "scene.yaml")
    with open(path, "w", encoding="utf-8") as out:
        yaml.safe_dump(SCENE, out, sort_keys=False)
    return path


def write_record(folder, scene, step=1.0, longest=900.0):
    """A row each `step` [s]. Its path."""
    rig, path = Simulator(scene, seed=3, play_program=True), os.path.join(folder, "record.csv")
    with open(path, "w", encoding="utf-8") as out:
        out.write(NAMES + "\n")
        for state in itertools.chain([rig.state], rig.frames(longest, every=round(step * rig.rate))):
            row = (state.t, state.block_height, state.top_drive_speed, state.flow, state.hook_load, state.torque, state.bit_depth, state.hole_depth)
            out.write(",".join("%.9g" % cell for cell in row) + "\n")
            if state.t > 1.0 and not state.current_operation:
                break
    return path
