#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Statics of the operations matrix and of two long wells: in each motion the string has an equilibrium, with its weight on bit, or is said to
buckle. A handful by default; --all: every distinct well, string, weight and motion of the matrix, as a table with processor time.

test_statics.py DRILL [--all]. Exit status: 0 all as they should be, 1 some are not.
"""
import os
import re
import resource
import subprocess
import sys
import tempfile

import yaml

HERE = os.path.dirname(os.path.abspath(__file__))
sys.dont_write_bytecode = True
sys.path.insert(0, os.path.join(HERE, 'operations'))
import cells  # noqa: E402

MOTIONS = [('--motion', word) for word in ('none', 'up', 'down', 'rotate')]
LONG = [os.path.join(HERE, '../operations/scenes', name) for name in ('extended_reach_12_km.yaml', 'horizontal_5_km.yaml')]


def moved(speed, rpm):
    return ('--speed', '%g' % speed, '--rpm', '%g' % rpm)


COMBINED = [moved(0.1, 120.0), moved(-0.1, 120.0), moved(0.3, 60.0), moved(-0.3, 60.0)]
FEW = {'J 2 km / 5 in / rotate 120': MOTIONS + [moved(-0.1, 120.0)], 'J 2 km / 4 in / rotate 120': MOTIONS, 'S 2 km / 5 in, motor / drill sliding': MOTIONS,
       'horizontal 1.2 km / 5 in, motor / drill sliding': MOTIONS, 'horizontal 3 km / 5 in, motor / drill sliding': [('--motion', 'down')],
       'extended 5 km / 5 in / drill rotating': [('--motion', 'down')], 'extended 5 km / 5 in, motor / slide 25 min': [('--motion', 'down'), ('--motion', 'up')]}


def program_of(cell):
    """Motions that a cell's program has."""
    found, speed, rpm = [], 0.0, 0.0
    for line in cell.what.program:
        speed, rpm = line.get('block_velocity', speed), line.get('top_drive_speed_rpm', rpm)
        if speed or rpm:
            found.append(moved(speed, rpm))
    return found


def every_distinct():
    """Cells that begin alike are one, with the motions of all."""
    alike = {}
    for cell in cells.CELLS:
        what = cell.what
        key = (cell.well, cell.string, what.weight or -what.off, what.layers)
        motions = alike.setdefault(key, (cell, list(MOTIONS)))[1]
        motions += [m for m in program_of(cell) if m not in motions]
    return list(alike.values())


def few():
    named = {cell.name: cell for cell in cells.CELLS}
    return [(named[name], motions) for name, motions in FEW.items()]


def solve(drill, scene, motion):
    """Processor seconds, and what came out."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run([drill, 'static', scene] + list(motion), stdout=subprocess.PIPE, stderr=subprocess.PIPE, universal_newlines=True, check=False)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime, done


def verdict(done, weight):
    """Text, and whether it is as it should be."""
    if done.returncode == 3 and 'it buckles' in done.stderr:
        return 'none: ' + done.stderr.strip().split('static: ')[-1], True
    found = dict(re.findall(r'^(hook load|torque|weight on bit|buckling) +(-?[\d.]+)', done.stdout, re.MULTILINE))
    if done.returncode or len(found) != 4:
        return 'status %d: %s' % (done.returncode, done.stderr.strip()), False
    hook, torque, wob, buckling = (float(found[key]) for key in ('hook load', 'torque', 'weight on bit', 'buckling'))
    held = abs(wob - (weight or 0.0)) <= max(1.0, 0.01 * (weight or 0.0))
    return '%.1f kN, %.2f kN m, %.1f kN on bit, %.2f of its buckling load%s' % (hook / 1e3, torque / 1e3, wob / 1e3, buckling, '' if held else ': WEIGHT'), held


def main():
    drill, all_of_them = sys.argv[1], '--all' in sys.argv[2:]
    wrong = 0
    with tempfile.TemporaryDirectory() as folder:
        jobs = [(path, os.path.basename(path), motion, None) for path in LONG for motion in MOTIONS + COMBINED]
        for cell, motions in every_distinct() if all_of_them else few():
            path = os.path.join(folder, cell.file + '.yaml')
            with open(path, 'w') as file:
                yaml.safe_dump(cell.scene(), file, default_flow_style=None, width=200)
            jobs += [(path, cell.name, motion, cell.what.weight) for motion in motions]
        for path, name, motion, weight in jobs:
            seconds, done = solve(drill, path, motion)
            text, right = verdict(done, weight)
            wrong += not right
            if all_of_them or not right:
                print('| %s | %s | %.2f s | %s%s |' % (name, ' '.join(motion), seconds, '' if right else 'WRONG ', text), flush=True)
    print('%d statics, %d wrong' % (len(jobs), wrong))
    return wrong > 0


if __name__ == '__main__':
    sys.exit(main())
