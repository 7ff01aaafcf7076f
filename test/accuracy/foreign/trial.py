# SPDX-License-Identifier: BSD-3-Clause
"""Scenes from outside, by an author without knowledge of the rules of level auto nor the operations matrix: is the default right, or does it say in time that it
may not be?

Each is played by the default and by two references (free nodes, TR-BDF2; 2.5 ms on quarter joints, and 5 ms on half joints). Of every output and
every three seconds the root mean square of the difference is taken over the output's scale: its range, a tenth of its level, or what an instrument
resolves, whichever is most. The reference's own error is taken to be a third of the references' difference.

- right: no three seconds are further off than the tolerance, 2 %
- warned: some are, and a warning had begun by the end of the first of them
- missed: some are, and none had
- undecided: the reference does not know itself to a third of that there
"""
import concurrent.futures
import csv
import json
import os
import re
import subprocess

import examples
import numpy

HERE = os.path.dirname(os.path.abspath(__file__))
WINDOW, AVERAGED = 3.0, 50  # [s], rows
RESOLVED = {'hook_load': 1e3, 'torque': 100.0, 'wob': 1e3, 'bit_speed': 0.1, 'rop': 1e-5}
FREE = ['--level', 'beam3d', '--integrator', 'trbdf2']
REFERENCES = {'fine': FREE + ['--step', '0.0025', '--element-length', '2.38'], 'coarse': FREE + ['--step', '0.005', '--element-length', '4.75']}


class Scene:
    def __init__(self, path):
        with open(path) as text:
            first = text.readline()
        self.path, self.name = path, os.path.basename(path)[:-len('.yaml')]
        self.what, self.seconds = re.match(r'# (.*); for ([0-9.]+) s', first).groups()


def play(drill, scene, kind, folder, tolerance):
    """Writes series and summary of a run; the error's line, or None."""
    name = os.path.join(folder, '%s.%s' % (scene.name, kind))
    done = subprocess.run([drill, 'run', scene.path, '--duration', scene.seconds, '--every', '0.02', '--csv', name + '.csv', '--json', name + '.json']
                          + REFERENCES.get(kind, ['--set', 'numerics.tolerance=%g' % tolerance]), stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, universal_newlines=True, check=False)
    return (done.stderr.strip().splitlines() or ['failed'])[-1] if done.returncode else None


def series(scene, kind, folder):
    with open(os.path.join(folder, '%s.%s.csv' % (scene.name, kind))) as file:
        names = next(csv.reader(file))
        return dict(zip(names, numpy.loadtxt(file, delimiter=',').T))


def smooth(column, output):
    """A rate of penetration is a mean, here of the last second: where the rock changes it jumps, and when it does to the frame is nothing."""
    if output != 'rop':
        return column
    sums = numpy.cumsum(numpy.concatenate([numpy.zeros(1), column]))
    first = numpy.maximum(0, numpy.arange(1, len(sums)) - AVERAGED)
    return (sums[1:] - sums[first]) / (numpy.arange(1, len(sums)) - first)


def off(a, b, output):
    """Of a from b, a number for every WINDOW seconds."""
    rows = min(len(a['time']), len(b['time']))
    x, y, window = smooth(a[output][:rows], output), smooth(b[output][:rows], output), (b['time'][:rows] / WINDOW).astype(int)
    scale = max(numpy.ptp(y), 0.1 * numpy.mean(numpy.abs(y)), RESOLVED[output])
    return numpy.array([numpy.sqrt(numpy.mean((x - y)[window == k] ** 2)) / scale for k in range(window[-1] + 1)])


class Verdict:
    def __init__(self, scene, folder, tolerance):
        ours, fine, coarse = (series(scene, kind, folder) for kind in ('default', 'fine', 'coarse'))
        with open(os.path.join(folder, scene.name + '.default.json')) as file:
            warnings = json.load(file)['accuracy_warnings']
        errors = {output: off(ours, fine, output) for output in RESOLVED}
        known = {output: off(coarse, fine, output) / 3.0 for output in RESOLVED}
        self.scene, self.tolerance = scene, tolerance
        self.output = max(errors, key=lambda output: errors[output].max())
        self.worst = errors[self.output].max()
        self.wrong_from = min((WINDOW * numpy.argmax(e > tolerance) for e in errors.values() if e.max() > tolerance), default=None)
        self.warned_from = min((w['since'] for w in warnings), default=None)
        self.of_limits = bool(warnings) and not any(examples.is_measured(w['text']) for w in warnings)  # of the model, not of the numerics
        self.kind = self.judge(errors, known)

    def judge(self, errors, known):
        if self.wrong_from is None:
            return 'right'
        if self.warned_from is not None and self.warned_from <= self.wrong_from + WINDOW:
            return 'warned'
        first = int(self.wrong_from / WINDOW)
        unknown = any(known[output][first] > self.tolerance / 3.0 for output, e in errors.items() if e[first] > self.tolerance)
        return 'undecided' if unknown else 'missed'

    def row(self):
        def at(time):
            return '-' if time is None else '%.0f' % time
        return '| %s | %s | %.1f | %s | %s | %s |' % (self.scene.what, self.kind, 100.0 * self.worst, self.output.replace('_', ' '), at(self.wrong_from),
                                                     at(self.warned_from))


def under_a_warning(verdicts):
    """How many of the right ones, and how many of these only because the model has a limit there: another output may be wrong."""
    warned = [v for v in verdicts if v.kind == 'right' and v.warned_from is not None]
    return 'of the right ones under a warning: %d, of which %d only of a limit of the model' % (len(warned), sum(v.of_limits for v in warned))


def run(args, folder):
    """Exit status, and the table's name."""
    os.makedirs(folder, exist_ok=True)
    places = sorted(os.listdir(os.path.join(HERE, 'scenes')))
    scenes = [Scene(os.path.join(HERE, 'scenes', name)) for name in places if args.cells in name]
    kinds = ['default'] + ([] if args.reuse else list(REFERENCES))
    with concurrent.futures.ThreadPoolExecutor(args.jobs) as pool:
        problems = [p for p in pool.map(lambda job: play(args.drill, *job, folder, args.tolerance), [(s, k) for s in scenes for k in kinds]) if p]
    for problem in problems:
        print('run: ' + problem)
    if problems:
        return 3, []
    verdicts = [Verdict(scene, folder, args.tolerance) for scene in scenes]
    counts = ', '.join('%d %s' % (sum(v.kind == kind for v in verdicts), kind) for kind in ('right', 'warned', 'missed', 'undecided'))
    lines = ['| scene | verdict | worst 3 s [%% of scale] | of | off by %g %% from [s] | warned from [s] |' % (100.0 * args.tolerance)]
    lines += ['| --- | --- | --- | --- | --- | --- |']
    lines += [verdict.row() for verdict in verdicts] + ['', '%d scenes: %s; %s.' % (len(verdicts), counts, under_a_warning(verdicts))]
    print('\n'.join(lines))
    table = 'foreign.md' if args.tolerance == 0.02 else 'foreign_%g.md' % args.tolerance
    with open(os.path.join(args.out, table), 'w') as out:
        out.write('\n'.join(lines) + '\n')
    return (1 if any(v.kind == 'missed' for v in verdicts) else 0), [table]
