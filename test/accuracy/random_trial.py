# SPDX-License-Identifier: BSD-3-Clause
"""Scenes drawn at random (random_scenes.py), each played together with two finer models of it by `drill verify`: is it right, and does it warn?

- right: no three seconds of an output that is needed are further off than the tolerance; also: how many of these stand under a warning
- warned: some are, and a warning had begun by the end of the first of them
- missed: some are, and none had
- unknown: the finer models do not know themselves well enough there

With a companion the error that it measured is compared with the true one, by windows of 3 s where both are above a fifth of the
tolerance. Its cost is compared with that of free nodes by steps of 10 ms without a companion.
"""
import concurrent.futures
import json
import math
import os
import subprocess

import random_scenes
import yaml

KINDS = ('right', 'warned', 'missed', 'unknown')
FREE = ['--level', 'beam3d', '--step', '0.01', '--set', 'numerics.companion=none']


class Trial:
    """One scene's first line, what `drill verify` found of it, and how many times faster than real time it runs without them, and by FREE; or why there is nothing."""

    def __init__(self, args, folder, number):
        self.number = number
        line, scene = random_scenes.drawn(args.seed, number)
        self.what, _, seconds = line[2:].rpartition('; for ')
        path = os.path.join(folder, 'random_%s_%s' % (args.seed, number))
        with open(path + '.yaml', 'w') as file:
            file.write(line + '\n' + yaml.safe_dump(scene, default_flow_style=None, width=150))
        length = ['--duration', seconds.split()[0]]
        options = length + ['--set', 'numerics.tolerance=%g' % args.tolerance, '--set', 'numerics.companion=' + args.companion]
        self.found = self.play([args.drill, 'verify', path + '.yaml', '--json', path + '.verify.json'] + options, path + '.verify.json', (0, 1))
        self.speed, self.free_speed = (self.speed_of([args.drill, 'run', path + '.yaml', '--json', path + '.json'] + how, path + '.json')
                                       for how in (options, length + FREE))

    def speed_of(self, command, out):
        done = self.play(command, out, (0,))
        return done['real_time_factor'] if done else float('nan')

    def play(self, command, out, good):
        done = subprocess.run(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, universal_newlines=True, check=False)
        if done.returncode not in good:
            self.problem = (done.stderr.strip().splitlines() or ['exit status %d' % done.returncode])[-1]
            return None
        with open(out) as file:
            return json.load(file)

    @property
    def kind(self):
        return self.found['verdict'] if self.found else 'failed'

    @property
    def right_under_a_warning(self):
        return self.kind == 'right' and self.found['warned_from'] is not None

    def worst(self):
        """The output that is furthest off, and by how much of its range."""
        needed = {name: found for name, found in self.found['outputs'].items() if found['needed']}
        name = max(needed, key=lambda output: needed[output]['worst'])
        return name, needed[name]['worst']

    def ratios(self, tolerance):
        """Measured over true error, by windows of needed outputs."""
        out = []
        for found in self.found['outputs'].values() if self.found else ():
            pairs = zip(found['off'], found['measured']) if found['needed'] else ()
            out += [measured / off for off, measured in pairs if measured is not None and min(off, measured) > 0.2 * tolerance]
        return out

    def row(self):
        if not self.found:
            return '| %s | %s | failed: %s | - | - | - | - |' % (self.number, self.what, self.problem)
        name, worst = self.worst()

        def at(time):
            return '-' if time is None else '%.0f' % time
        return '| %s | %s | %s | %.1f | %s | %s | %.0f |' % (self.number, self.what, self.kind, 100.0 * worst, name.replace('_', ' '), at(self.found['warned_from']), self.speed)


def quantile(values, share):
    return sorted(values)[min(len(values) - 1, int(share * len(values)))]


def summary(trials, tolerance):
    counts = {kind: sum(t.kind == kind for t in trials) for kind in KINDS + ('failed',)}
    speeds = [t.speed for t in trials if t.speed == t.speed]
    lines = ['%d scenes: %s; of the right ones under a warning: %d.' % (len(trials), ', '.join('%d %s' % (n, kind) for kind, n in counts.items() if n),
                                                                        sum(t.right_under_a_warning for t in trials)),
             'Simulated over processor time, geometric mean: %.0f; not below that of free nodes by 10 ms without a companion in %d.'
             % (math.exp(sum(map(math.log, speeds)) / len(speeds)), sum(t.speed >= t.free_speed for t in trials)) if speeds else '']
    ratios = [ratio for t in trials for ratio in t.ratios(tolerance)]
    if ratios:
        lines.append('Measured over true error, %d windows: 5 %% below %.2f, half below %.2f, 5 %% above %.2f.'
                     % (len(ratios), quantile(ratios, 0.05), quantile(ratios, 0.5), quantile(ratios, 0.95)))
    return lines


def run(args, folder):
    """Exit status, and the table's name."""
    os.makedirs(folder, exist_ok=True)
    with concurrent.futures.ThreadPoolExecutor(args.jobs) as pool:
        trials = list(pool.map(lambda number: Trial(args, folder, number), range(args.random)))
    lines = ['Seed %s, tolerance %g %%, companion: %s.' % (args.seed, 100.0 * args.tolerance, args.companion), '',
             '| no. | scene | verdict | worst 3 s [% of range] | of | warned from [s] | times real time |', '| --- | --- | --- | --- | --- | --- | --- |']
    lines += [t.row() for t in trials] + [''] + summary(trials, args.tolerance)
    print('\n'.join(lines))
    with open(os.path.join(args.out, 'random.md'), 'w') as out:
        out.write('\n'.join(lines) + '\n')
    return (1 if any(t.kind in ('missed', 'failed') for t in trials) else 0), ['random.md']
