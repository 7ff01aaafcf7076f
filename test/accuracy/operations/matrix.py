# SPDX-License-Identifier: BSD-3-Clause
"""Runs cells of the operations matrix, with the default numerics and with a reference's, and says how far they are apart.

A run that is wrong is warned where its `accuracy_warnings` came before the error passed the bound, else missed.
Error of an output: root mean square of the difference to the reference, over the largest of its range, a tenth of its level and what its
instrument resolves; where a cell is irregular, of mean, deviation and extrema instead of the series, and of the hook load's period where the
reference has one. Shares of the bound: 1 is 2 %.
An output of a reference is known where its own error is below a third of the bound (KNOWN). That error is what the next two coarser numerics
tell of it (own_errors).
Warnings go by windows of three seconds instead: the worst of them is reported too (worst_window).
The default's runs of a minute and less keep an energy balance too: CLOSURE and DISSIPATION are what it may miss and what the method may take.
"""
import hashlib
import json
import os
import subprocess
import sys

import numpy
import yaml

sys.path.append(os.path.join(os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__)))), 'benchmark'))
import weights  # noqa: E402

WEIGHTS = weights.load()  # of counted work
BOUND = 0.02
INCLINATION_BOUND = 0.1  # [deg]
FLOORS = {'hook_load': 1e3, 'torque': 100.0, 'wob': 1e3, 'bit_speed': 0.1, 'pressure': 1e5, 'position': 0.01}  # N, N m, N, rad/s, Pa, m
COLUMNS = {'pressure': 'reading_stand_pipe_pressure'}
KEPT = ['time', 'hook_load', 'torque', 'wob', 'bit_speed', 'reading_stand_pipe_pressure', 'bit_east', 'bit_north', 'bit_up', 'inclination']
JOINT = 9.5
CLOSURE, DISSIPATION = 0.005, 0.05  # of the throughput; the second by magnitudes, account by account
BALANCED = 60.0  # a balance doubles the cost: not of longer runs [s]
WINDOW = 3.0  # [s]
WINDOWS = 10  # of an irregular stretch; its extrema are means over them
COMES_BACK, STILL, NEARLY, RETURNS = 0.5, 0.3, 0.65, 3  # autocorrelation of a reference that has a period, of a run that is held against it; first peak over highest; how often


class Numerics:
    """Length of elements [m], also where friction pushes the pipe, step [s], method, level and tolerance; None: the default's."""

    def __init__(self, length=None, step=None, method=None, level=None, pushed=None, tolerance=None):
        self.length, self.step, self.method, self.level, self.pushed, self.tolerance = length, step, method, level, pushed, tolerance

    def options(self):
        pairs = (('--element-length', self.length), ('--step', self.step), ('--integrator', self.method), ('--level', self.level))
        words = [word for option, value in pairs if value is not None for word in (option, value if isinstance(value, str) else '%.6g' % value)]
        for key, value in (('pushed_element_length', self.pushed), ('tolerance', self.tolerance)):
            words += [] if value is None else ['--set', 'numerics.%s=%.6g' % (key, value)]
        return words

    def __str__(self):
        return ', '.join(word.split('.', 1)[1] if word.startswith('numerics.') else word for word in self.options()[1::2]) or 'default'


KNOWN = 1.0 / 3.0  # of the bound: where a reference's own error is below that, its cell counts
# Elements a joint, and steps: what a cell can afford is its reference; the next two tell its error. Quarters first, finer where they leave the
# cell undecided.
LADDER = tuple(Numerics(JOINT / parts * 1.001, step, 'trbdf2', 'beam3d') for parts, step in ((16, 0.000625), (8, 0.00125), (4, 0.0025), (2, 0.005), (1, 0.01), (1, 0.02)))
QUARTERS = 2  # of the ladder
NODE_STEPS = 4e5  # of TR-BDF2 in a second of processor time, about


def seconds_of(cell, numerics):
    return cell.length() / numerics.length * cell.what.duration / numerics.step / NODE_STEPS


def reference_rung(cell, budget):
    return next((rung for rung in range(QUARTERS, len(LADDER) - 3) if seconds_of(cell, LADDER[rung]) <= budget), len(LADDER) - 3)


class Run:
    """Series of a run by output, or why there is none."""

    def __init__(self, table, summary, failure=None):
        self.table, self.summary, self.failure = table, summary, failure


def scene_text(cell):
    return yaml.safe_dump(cell.scene(), default_flow_style=None, width=200)


def fingerprint(cell):
    """Of all that a reference depends on but the program itself."""
    what = cell.what
    return hashlib.sha256(repr((scene_text(cell), what.duration, what.every)).encode()).hexdigest()[:16]


def run(drill, cell, numerics, folder, energy=False):
    name = os.path.join(folder, '%s.%s' % (cell.file, str(numerics).replace(', ', '_')))
    scene, series, summary = name + '.yaml', name + '.csv', name + '.json'
    with open(scene, 'w') as file:
        file.write(scene_text(cell))
    command = [drill, 'run', scene, '--duration', '%g' % cell.what.duration, '--every', '%g' % cell.what.every, '--csv', series, '--readings',
               '--json', summary] + (['--energy'] if energy else []) + numerics.options()
    done = subprocess.run(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, universal_newlines=True, check=False)
    if done.returncode:
        return Run(None, {}, (done.stderr.strip().splitlines() or ['exit status %d' % done.returncode])[-1])
    with open(summary) as file:
        told = json.load(file)
    with open(series) as file:
        names = file.readline().strip().split(',')
        columns = dict(zip(names, numpy.atleast_2d(numpy.genfromtxt(file, delimiter=',')).T))
    return Run({name: columns[name] for name in KEPT}, told)


def values(table, output):
    if output == 'position':
        return numpy.column_stack([table['bit_east'], table['bit_north'], table['bit_up']])
    return numpy.asarray(table[COLUMNS.get(output, output)])[:, None]


def size(vector):
    return float(numpy.linalg.norm(vector))


def statistics(y):
    """Mean, deviation, least and largest; a row each."""
    windows = numpy.array_split(y, WINDOWS)
    return [numpy.mean(y, axis=0), numpy.std(y, axis=0), numpy.mean([w.min(axis=0) for w in windows], axis=0),
            numpy.mean([w.max(axis=0) for w in windows], axis=0)]


def top_of(y, k):
    """Where the parabola through sample k, a peak, and its neighbours is highest [samples]."""
    return k + 0.5 * (y[k - 1] - y[k + 1]) / (y[k - 1] - 2.0 * y[k] + y[k + 1])


def period(time, y, comes_back=COMES_BACK):
    """By the first peak of the autocorrelation that is nearly its highest, after it first fell below 0, and by the peaks that follow it a period
    apart, which are surer; nan where it does not come back RETURNS times, as waves do that die out."""
    y = y - numpy.mean(y)
    lags = len(y) // 2
    if lags < 3 or not y.any():
        return float('nan')
    like = numpy.array([numpy.mean(y[:len(y) - k] * y[k:]) for k in range(lags)]) / numpy.mean(y * y)
    below = numpy.flatnonzero(like < 0.0)
    rest = numpy.arange(below[0] if len(below) else lags, lags - 1)
    peaks = [k for k in rest if like[k] >= like[k - 1] and like[k] > like[k + 1] and like[k] >= comes_back]
    highest = max((like[k] for k in peaks), default=0.0)
    returns = []  # lag over how many periods it is [samples]
    for k in peaks:
        if (abs(k - (len(returns) + 1) * returns[-1]) < 0.2 * returns[-1]) if returns else like[k] >= NEARLY * highest:
            returns.append(top_of(like, k) / (len(returns) + 1))
    return returns[-1] * (time[1] - time[0]) if len(returns) >= RETURNS else float('nan')


def parts(time, irregular):
    """Which samples are compared one by one, and which by statistics."""
    begins, ends = irregular or (time[-1], time[-1])
    return time <= begins + 1e-6, (time > begins + 1e-6) & (time <= ends + 1e-6)


def scale_of(b, output):
    level = 0.0 if output == 'position' else 0.1 * float(numpy.mean(numpy.abs(b)))  # where the bit is has no level
    return max(size(numpy.ptp(b, axis=0)), level, FLOORS[output])


def worst_window(table, reference):
    """The largest error over three seconds of an output that warnings go by, as a share of the bound; by the series also where a cell is irregular."""
    time = numpy.asarray(reference['time'])
    windows = [mask for mask in (numpy.floor(time / WINDOW) == k for k in range(int(time[-1] / WINDOW))) if mask.any()]
    worst = 0.0
    for output in FLOORS:
        if output == 'position':
            continue
        a, b = values(table, output), values(reference, output)
        squares = numpy.sum((a - b) ** 2, axis=1)
        worst = max([worst] + [float(numpy.sqrt(numpy.mean(squares[mask]))) / scale_of(b, output) for mask in windows])
    return worst / BOUND


def error(table, reference, output, irregular):
    a, b = values(table, output), values(reference, output)
    scale = scale_of(b, output)
    one_by_one, counted = parts(numpy.asarray(reference['time']), irregular)
    squares = [numpy.mean(numpy.sum((a - b)[one_by_one] ** 2, axis=1))]
    if counted.any():
        squares.append(numpy.mean([size(p - q) ** 2 for p, q in zip(statistics(a[counted]), statistics(b[counted]))]))
    return float(numpy.sqrt(max(squares))) / scale


def period_error(table, reference, irregular):
    """Of the hook load's; 0 where the reference has none."""
    time = numpy.asarray(reference['time'])
    counted = parts(time, irregular)[1]
    if not counted.any() or numpy.ptp(reference['hook_load'][counted]) < FLOORS['hook_load']:
        return 0.0
    wanted = period(time[counted], numpy.asarray(reference['hook_load'])[counted])
    ours = period(time[counted], numpy.asarray(table['hook_load'])[counted], STILL)
    if wanted != wanted:
        return 0.0
    return abs(ours - wanted) / wanted if ours == ours else 1.0


def errors(table, reference, irregular):
    """By output, as shares of their bounds."""
    if len(table['time']) != len(reference['time']):
        raise ValueError('series of other lengths')
    out = {output: error(table, reference, output, irregular) / BOUND for output in FLOORS}
    out['period'] = period_error(table, reference, irregular) / BOUND
    compared = numpy.logical_or(*parts(numpy.asarray(reference['time']), irregular))
    out['inclination'] = float(numpy.degrees(numpy.max(numpy.abs(table['inclination'] - reference['inclination'])[compared]))) / INCLINATION_BOUND
    return out


class Reference:
    """What a cell is compared with: series, and their own errors by output as shares of the bound."""

    def __init__(self, table, own, numerics, made_of):
        self.table, self.own, self.numerics, self.made_of = table, own, numerics, made_of

    def save(self, path):
        # places change by metres and are wanted to a tenth of a millimetre: single precision of their changes
        kept = {name: (self.table[name] - self.table[name][0]).astype(numpy.float32) for name in KEPT}
        first = numpy.array([self.table[name][0] for name in KEPT])
        numpy.savez_compressed(path, first=first, own=json.dumps(self.own), numerics=self.numerics, made_of=self.made_of, **kept)

    @staticmethod
    def load(path):
        with numpy.load(path) as file:
            table = {name: file[name].astype(float) + first for name, first in zip(KEPT, file['first'])}
            return Reference(table, json.loads(str(file['own'])), str(file['numerics']), str(file['made_of']))


SAFETY = 1.25  # with three numerics (Roache, J. Fluids Eng. 116 (1994) 405-413: the grid convergence index)
ORDER = 2.0  # elements and steps are halved from rung to rung; the coarsest has the next one's elements, which as a rule makes r smaller


def own_errors(fine, middle, coarse, irregular):
    """Of the finest of three runs, by output, as shares of their bounds: where the differences shrink from one pair to the next by a factor r of at
    least two, the rest of their geometric series, d/(r - 1), times SAFETY; r not above 2^ORDER. Else the last difference itself."""
    last, before = errors(middle, fine, irregular), errors(coarse, middle, irregular)
    out = {}
    for name, difference in last.items():
        shrinks = min(before[name] / difference, 2.0 ** ORDER) if difference > 0.0 else 1.0
        out[name] = min(difference, SAFETY * difference / (shrinks - 1.0)) if shrinks >= 2.0 else difference
    return out


def make_reference(drill, cell, folder, budget):
    """Or None, and why."""
    rung = reference_rung(cell, budget)
    runs = [run(drill, cell, numerics, folder) for numerics in LADDER[rung:rung + 3]]
    while not any(done.failure for done in runs):
        own = own_errors(*(done.table for done in runs), cell.irregular())
        if max(own.values()) <= KNOWN or rung == 0 or seconds_of(cell, LADDER[rung - 1]) > budget:
            return Reference(runs[0].table, own, str(LADDER[rung]), fingerprint(cell)), ''
        rung -= 1
        runs = [run(drill, cell, LADDER[rung], folder)] + runs[:2]
    return None, next(done.failure for done in runs if done.failure)


class Verdict:
    """`kind`: right, warned, missed or undecided. `worst`: of the run's errors, as a share of its bound, `by` which output; `own`: of the
    reference's."""

    def __init__(self, cell, kind, note=''):
        self.cell, self.kind, self.note = cell, kind, note
        self.worst, self.by = float('nan'), ''
        self.own, self.own_by = float('nan'), ''
        self.window = float('nan')  # worst_window()
        self.cost = float('nan')  # counted work: instructions, as test/benchmark counts them
        self.closure = self.dissipation = float('nan')  # of the energy balance, shares of the throughput

    def balances(self):
        """Also where nothing was counted."""
        return not (self.closure > CLOSURE or self.dissipation > DISSIPATION)


def worst_of(shares):
    by = max(shares, key=shares.get)
    return shares[by], by


def within(shares, tolerance):
    """Shares of the bounds that belong to another tolerance."""
    return {name: share * BOUND / tolerance for name, share in shares.items()}


def right_until(since, cell, table, reference, outputs, tolerance=BOUND):
    """Whether these outputs would be within their bounds had the run been right from `since` [s] on."""
    regular = cell.irregular()
    time = numpy.asarray(reference.table['time'])
    before = time < (since if regular is None else min(since, regular[0]))
    cut = {name: numpy.where(before, column, reference.table[name]) for name, column in table.items()}
    shares = within(errors(cut, reference.table, regular), tolerance)
    return all(shares[name] <= 1.0 for name in outputs)


def shares_of_energy(accounts):
    """What the balance misses and what the method takes, over the throughput; of nothing where there is no balance."""
    if not accounts:
        return float('nan'), float('nan')
    taken = sum(abs(value) for name, value in accounts.items() if name.startswith('numerical_') and name not in ('numerical_share', 'numerical_of_losses'))
    return accounts['closure'], taken / accounts['throughput']


def judge(cell, mine, reference, tolerance=BOUND):
    out = Verdict(cell, 'undecided')
    if mine.failure:
        out.kind, out.note = 'missed', mine.failure
        return out
    shares = within(errors(mine.table, reference.table, cell.irregular()), tolerance)
    own = within(reference.own, tolerance)
    out.worst, out.by = worst_of(shares)
    out.own, out.own_by = worst_of(own)
    out.window = worst_window(mine.table, reference.table) * BOUND / tolerance
    out.cost = WEIGHTS.of('corotational', mine.summary)
    out.closure, out.dissipation = shares_of_energy(mine.summary.get('energy'))
    warnings = mine.summary['accuracy_warnings']
    out.note = warnings[0]['text'] if warnings else ''
    wrong = {name: share for name, share in shares.items() if share > 1.0 and own[name] <= KNOWN * max(1.0, share)}
    if wrong:
        out.worst, out.by = worst_of(wrong)
        out.kind = 'warned' if warnings and right_until(warnings[0]['since'], cell, mine.table, reference, wrong, tolerance) else 'missed'
    elif out.own <= KNOWN:
        out.kind = 'right'
    return out
