"""Runs the cells of the operations matrix, with the default numerics and with a reference's, and says how far they are apart.

Error of an output: root mean square of the difference to the reference, over the largest of its range, a tenth of its level and what its
instrument resolves; after a bifurcation (a cell's `chaotic_from`) of mean, deviation and extrema instead of the series. A cell counts where
the reference's own error, its difference to the next coarser numerics, is below a third of the bound.
"""
import json
import os
import subprocess

import numpy
import yaml

BOUND = 0.02
INCLINATION_BOUND = 0.1  # [deg]
FLOORS = {'hook_load': 1e3, 'torque': 100.0, 'wob': 1e3, 'bit_speed': 0.1, 'pressure': 1e5, 'position': 0.01}  # N, N m, N, rad/s, Pa, m
COLUMNS = {'pressure': 'reading_stand_pipe_pressure'}
JOINT = 9.5
# (elements a joint, parts of the default step), finest first; what a cell can afford is its reference
LADDER = ((8, 4), (4, 2), (2, 1), (1, 1))
NODE_STEPS = 6e5  # a second of processor time, about


class Numerics:
    """Length of elements [m] and step [s]; None: the default's."""

    def __init__(self, length=None, step=None):
        self.length, self.step = length, step

    def options(self):
        return (['--element-length', '%.6g' % self.length] if self.length else []) + (['--step', '%.6g' % self.step] if self.step else [])

    def tag(self):
        return '%s_%s' % ('%.4g' % self.length if self.length else 'default', '%.4g' % self.step if self.step else 'default')


def of_ladder(rung, default_step=0.01):
    parts, steps = LADDER[rung]
    return Numerics(JOINT / parts * 1.001, default_step / steps)


def seconds_of(cell, rung):
    parts, steps = LADDER[rung]
    return cell.length() / JOINT * parts * cell.what.duration * 100.0 * steps / NODE_STEPS


def reference_rung(cell, budget):
    """The finest rung within so many seconds of processor time, the last but one at worst: the next coarser tells its error."""
    for rung in range(len(LADDER) - 1):
        if seconds_of(cell, rung) <= budget:
            return rung
    return len(LADDER) - 2


class Run:
    """Series of a run by output, or why there is none."""

    def __init__(self, table, summary, failure=None):
        self.table, self.summary, self.failure = table, summary, failure


def run(drill, cell, numerics, folder, reuse):
    name = os.path.join(folder, '%s.%s' % (cell.file, numerics.tag()))
    scene, series, summary = name + '.yaml', name + '.csv', name + '.json'
    text = yaml.safe_dump(cell.scene(), default_flow_style=None, width=200)
    old = None
    if os.path.exists(scene):
        with open(scene) as file:
            old = file.read()
    if not (reuse and old == text and os.path.exists(summary) and os.path.getsize(summary)):
        with open(scene, 'w') as file:
            file.write(text)
        done = subprocess.run([drill, 'run', scene, '--duration', '%g' % cell.what.duration, '--every', '0.05', '--csv', series, '--readings', '--energy',
                               '--json', summary] + numerics.options(), stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, universal_newlines=True,
                              cwd=folder, check=False)
        if done.returncode:
            said = (done.stderr.strip().splitlines() or ['exit status %d' % done.returncode])[-1]
            with open(summary, 'w') as file:
                json.dump({'failure': said}, file)
    with open(summary) as file:
        told = json.load(file)
    if 'failure' in told:
        return Run(None, told, told['failure'])
    with open(series) as file:
        names = file.readline().strip().split(',')
        table = numpy.loadtxt(file, delimiter=',', ndmin=2)
    return Run(dict(zip(names, table.T)), told)


def values(table, output):
    if output == 'position':
        return numpy.column_stack([table['bit_east'], table['bit_north'], table['bit_up']])
    return numpy.asarray(table[COLUMNS.get(output, output)])[:, None]


def size(vector):
    return float(numpy.linalg.norm(vector))


def error(table, reference, output, chaotic_from):
    a, b = values(table, output), values(reference, output)
    level = 0.0 if output == 'position' else 0.1 * float(numpy.mean(numpy.abs(b)))  # where the bit is has no level
    scale = max(size(numpy.ptp(b, axis=0)), level, FLOORS[output])
    time = numpy.asarray(reference['time'])
    part = time <= (chaotic_from if chaotic_from is not None else time[-1]) + 1e-6
    squares = [numpy.mean(numpy.sum((a - b)[part] ** 2, axis=1))]
    if not part.all():
        squares.append(numpy.mean([size(f(a[~part], axis=0) - f(b[~part], axis=0)) ** 2 for f in (numpy.mean, numpy.std, numpy.min, numpy.max)]))
    return float(numpy.sqrt(max(squares))) / scale


def inclination_error(table, reference):
    """Of the hole's end [deg]."""
    return float(numpy.degrees(numpy.max(numpy.abs(table['inclination'] - reference['inclination']))))


def errors(mine, reference, cell):
    """By output, as shares of their bounds."""
    out = {output: error(mine.table, reference.table, output, cell.what.chaotic_from) / BOUND for output in FLOORS}
    out['inclination'] = inclination_error(mine.table, reference.table) / INCLINATION_BOUND
    return out


class Verdict:
    def __init__(self, cell):
        self.cell = cell
        self.kind = 'undecided'
        self.worst, self.by = float('nan'), ''     # of the run, as a share of its bound
        self.own, self.own_by = float('nan'), ''   # of the reference
        self.note = ''
        self.cpu = float('nan')


def worst_of(shares):
    by = max(shares, key=shares.get)
    return shares[by], by


def judge(cell, mine, reference, coarser):
    out = Verdict(cell)
    if reference.failure or coarser.failure:
        out.note = 'reference: ' + (reference.failure or coarser.failure)
        return out
    own = errors(coarser, reference, cell)
    out.own, out.own_by = worst_of(own)
    if mine.failure:
        out.kind, out.note = 'silent', mine.failure
        return out
    out.cpu = mine.summary['cpu_s']
    shares = errors(mine, reference, cell)
    out.worst, out.by = worst_of(shares)
    # an output whose reference is not known well enough counts only where it is wrong by far more than that
    beyond = [name for name in shares if shares[name] > 1.0 and shares[name] > 3.0 * own[name]]
    if beyond:
        out.worst, out.by = worst_of({name: shares[name] for name in beyond})
        out.kind = 'warned' if mine.summary.get('accuracy_warning') else 'silent'
    elif out.own <= 1.0 / 3.0 or out.worst <= 1.0 and out.own <= 1.0:
        out.kind = 'right' if out.worst <= 1.0 else 'undecided'
    return out
