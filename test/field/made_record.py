# SPDX-License-Identifier: BSD-3-Clause
"""A record that the simulator made: a bit is brought to bottom and drills, smoothly; its gauges are noisy and the hook load has a tare. What made it is known."""
import itertools
import math
import os

import numpy
import yaml
from drill_rig_sim.sim import Simulator

SOURCE = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
QUICK = os.path.join(SOURCE, "config/scenes/quick.yaml")
TARE, TORQUE, ROCK = 2000.0, 0.3, 1.0  # [N]; of the bit's friction; of the scene's drillability
NOISE = (300.0, 30.0, 2e4)  # of hook load [N], torque [N m], pressure [Pa]
NAMES = ("time", "reading_block_height", "top_drive_speed", "reading_flow", "reading_hook_load", "reading_torque", "reading_stand_pipe_pressure",
         "reading_bit_depth")
FIT = {"scene": "scene.yaml", "record": "record.csv", "leave_out": ["0:6"], "held_out": 0.2, "parameters": [
    {"name": "tare", "signal": "hook_load", "start": 0.0},
    {"name": "bit's friction", "key": "string[bit].torque.kinetic", "start": 0.2, "from": 0.05, "to": 0.4},
    {"name": "rock", "key": "formation[0].drillability", "times": True, "start": 1.5, "from": 0.2, "to": 5.0},
    {"name": "pressure", "key": "rig.mud_pump.pressure_coefficient", "start": 3.0e9, "from": 1.0e9, "to": 1.0e10}]}
PRESSURE = 4.0e9
TRUTH = (TARE, TORQUE, ROCK, PRESSURE)


def write_scene(folder, name="scene.yaml", depth=100.0):
    """quick.yaml by steps of 10 ms, which are enough for what is slow, and cheap; its well to a depth [m]. Its path."""
    with open(QUICK, encoding="utf-8") as text:
        scene = yaml.safe_load(text)
    scene.pop("program")
    scene["well"] = {"stations": [[0.0, 0.0, 0.0], [depth, 0.0, 0.0]], "hole_depth": depth, "sections": [{"to": depth, "diameter": 0.2159, "friction": 0.25}]}
    scene["start"]["bit_depth"] = depth - 0.3
    scene["numerics"] = {"level": "axial_torsional", "step": 0.01}
    scene["string"][0]["torque"]["kinetic"] = TORQUE
    scene["rig"] = {"mud_pump": {"pressure_coefficient": PRESSURE}}
    scene["formation"][0]["drillability"] = 1.3e-7
    path = os.path.join(folder, name)
    with open(path, "w", encoding="utf-8") as out:
        yaml.safe_dump(scene, out)
    return path


def rows_of(scene, seconds=90.0, feed=0.01, rpm=60.0):
    """Without noise: an array, a row each 0.2 s, in the columns NAMES."""
    rig, rows = Simulator(scene), []
    for s in itertools.chain([rig.state], rig.frames(seconds, every=20)):
        rows.append([s.t, s.block_height, s.top_drive_speed, s.flow, s.hook_load, s.torque, s.stand_pipe_pressure, s.bit_depth])
        ramp = 0.5 - 0.5 * math.cos(math.pi * min(s.t / 20.0, 1.0))
        rig.pump(0.02 * ramp)
        rig.winch(-feed * ramp)
        rig.rotate(rpm=rpm * ramp)
    return numpy.array(rows)


def write_record(folder, rows, seed, name="record.csv"):
    noisy = rows.copy()
    noisy[:, 4:7] += numpy.random.default_rng(seed).normal(size=(len(rows), 3)) * NOISE
    noisy[:, 4] += TARE
    with open(os.path.join(folder, name), "w", encoding="utf-8") as out:
        out.write(",".join(NAMES) + "\n")
        out.writelines(",".join("%.9g" % cell for cell in row) + "\n" for row in noisy)


def write_fit(folder, name="fit.yaml", **more):
    path = os.path.join(folder, name)
    with open(path, "w", encoding="utf-8") as out:
        yaml.safe_dump({**FIT, **more}, out, sort_keys=False)
    return path
