# SPDX-License-Identifier: BSD-3-Clause
"""The examples that are shipped: scenes of config/scenes with a program, and the controllers of launch/*.launch. For which share of their time does a warning stand, and why?

--companion coarser plays them with `level: auto` beside a companion with elements and steps twice as long, and reports how long that one would have done: the share
of time in which its difference to the run is within half of the tolerance.
"""
import collections
import concurrent.futures
import importlib
import os
import re
import sys
import time
import xml.etree.ElementTree

import yaml

SOURCE = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
# what is played, and for how long at most [s]: the launch files' timeout, and until the main job has drilled some metres
PROGRAMS = {'quick': 180.0, 'oilfield': 300.0, 'bohai': 600.0}
CONTROLLERS = {'autodriller': 3600.0, 'slide_steering': 3600.0, 'rss_steering': 6000.0, 'stands': 6000.0, 'stick_slip': 3600.0}
COARSER = 0.85     # error of a coarser companion over its difference to the run (accuracy/measured_error.h)
MEASURED = ': measured error'
TOLERANCE = 0.02   # numerics.tolerance of all of them


def controller_of(name):
    """The law of a launch file, with its settings, plan and orders."""
    from drill_rig_sim import control
    from drill_rig_sim.survey import read_survey
    node = xml.etree.ElementTree.parse(os.path.join(SOURCE, 'launch', name + '.launch')).getroot().find('node')
    values = yaml.safe_load(node.find('rosparam').text)
    settings = dict(values['settings'])
    for parameter in node.findall('param'):
        if parameter.get('name') == 'plan':
            settings['plan'] = read_survey(parameter.get('value').replace('$(dirname)', os.path.join(SOURCE, 'launch')))
    law = getattr(importlib.import_module('drill_rig_sim.' + name), ''.join(word.capitalize() for word in name.split('_')))
    return control.Ordered(law(**settings), values.get('orders', []))


def is_measured(warning):
    """Whether a warning is of a measured error; the others are of limits of the model."""
    return MEASURED in warning


def reason(warning):
    """A warning's words without its numbers."""
    output, measured, _ = warning.partition(MEASURED)
    return 'measured error of the ' + output if measured else re.sub(r'[0-9][0-9.e+-]*', 'N', warning.partition(';')[0])


def scene_beside(name, companion, folder):
    """The scene's file; with a companion that is asked for, a copy of it with `level: auto`."""
    path = os.path.join(SOURCE, 'config/scenes', name + '.yaml')
    if companion is None:
        return path
    with open(path) as text:
        scene = yaml.safe_load(text)
    scene['numerics'] = {'level': 'auto', 'companion': companion}
    if 'survey' in scene['well']:
        scene['well']['survey'] = os.path.join(os.path.dirname(path), scene['well']['survey'])
    copy = os.path.join(folder, name + '.yaml')
    with open(copy, 'w') as out:
        yaml.safe_dump(scene, out)
    return copy


class Example:
    """A run, and how long each warning stood in it [s], by its words without numbers."""

    def __init__(self, name, companion, folder):
        from drill_rig_sim import control
        from drill_rig_sim.sim import Simulator
        self.name, self.warned, self.coarse = name, collections.Counter(), 0.0
        rig = Simulator(scene_beside(name, companion, folder), play_program=name in PROGRAMS)
        begin = time.process_time()
        if name in PROGRAMS:
            for _ in range(int(10.0 * PROGRAMS[name])):
                rig.step(frames=10)
                self.look(rig, 0.1)
        else:
            law = controller_of(name)
            for _ in control.driven(rig, law, CONTROLLERS[name], rig):
                self.look(rig, law.period)
        self.seconds, self.measured = rig.state.t, rig.not_measured
        self.speed = self.seconds / (time.process_time() - begin)

    def look(self, rig, period):
        if rig.accuracy_warning:
            self.warned[reason(rig.accuracy_warning)] += period
        errors = rig.measured_errors
        if errors and max(errors.values()) <= 0.5 * COARSER * TOLERANCE:
            self.coarse += period

    def share(self):
        return sum(self.warned.values()) / self.seconds

    def row(self):
        why = '; '.join('%s (%.0f s)' % (text, seconds) for text, seconds in self.warned.most_common(3)) or '-'
        return '| %s | %.0f | %.1f | %s | %s | %.0f |' % (self.name, self.seconds, 100.0 * self.share(), why, self.measured or 'yes', self.speed)

    def coarse_row(self):
        return '| %s | %.0f | %.0f | %.0f |' % (self.name, self.seconds, 100.0 * self.coarse / self.seconds, self.speed)


def played(job):
    return Example(*job)


def run(args, folder):
    """Exit status, and the table's name."""
    sys.path[:0] = [os.path.join(SOURCE, 'build/devel/lib/python3/dist-packages')]
    os.makedirs(folder, exist_ok=True)
    names = [name for name in (*PROGRAMS, *CONTROLLERS) if args.cells in name]
    with concurrent.futures.ProcessPoolExecutor(args.jobs) as pool:
        found = list(pool.map(played, [(name, args.companion, folder) for name in names]))
    if args.companion == 'coarser':
        lines = ['| example, with `level: auto` | simulated [s] | elements and steps twice as long would do [% of the time] | times real time, the two together |', '| --- | --- | --- | --- |']
        lines += [example.coarse_row() for example in found]
    else:
        lines = ['| example | simulated [s] | under a warning [% of the time] | why | error measured | times real time |', '| --- | --- | --- | --- | --- | --- |']
        lines += [example.row() for example in found]
    print('\n'.join(lines))
    table = 'examples_coarser.md' if args.companion == 'coarser' else 'examples.md'
    with open(os.path.join(args.out, table), 'w') as out:
        out.write('\n'.join(lines) + '\n')
    return (1 if args.companion is None and any(example.share() > 0.1 for example in found) else 0), [table]
