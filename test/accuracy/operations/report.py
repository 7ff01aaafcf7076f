# SPDX-License-Identifier: BSD-3-Clause
"""The operations matrix as a command: makes references, judges, writes table and chart."""
import collections
import os
import sys
from concurrent.futures import ThreadPoolExecutor

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, HERE)

import automatic  # noqa: E402 (they lie beside this file)
import cells  # noqa: E402
import matrix  # noqa: E402

REFERENCES = os.path.join(HERE, 'references')
KINDS = ('right', 'warned', 'missed', 'undecided')
LEAST_RIGHT, MOST_UNDECIDED = 0.85, 0.20  # of the decided, of all
COLOURS = {'right': '#2e8b57', 'warned': '#d9822b', 'missed': '#c0392b', 'undecided': '#9a9a9a'}
# What the default, the first, is beside: free nodes by fixed steps; None: the mesh by the hole.
VARIANTS = (matrix.Numerics(),) + tuple(matrix.Numerics(length, step, method, 'beam3d') for method, step, length in (
    ('bdf2', 0.01, None), ('bdf2', 0.01, 9.51), ('bdf2', 0.01, 4.755), ('bdf2', 0.005, None), ('trbdf2', 0.02, None), ('trbdf2', 0.01, None),
    ('generalised_alpha', 0.01, None)))

LEVELS = tuple(matrix.Numerics(level=level) for level in ('beam3d', 'hybrid', 'axial_torsional'))
WIDER = 2.5  # bounds: 5 %


def path_of(cell):
    return os.path.join(REFERENCES, cell.file + '.npz')


def in_parallel(jobs, function, todo):
    """The longest first; tells each result's line as it comes."""
    def told(cell):
        result, line = function(cell)
        print(line, flush=True)
        return result
    todo = sorted(todo, key=lambda cell: -cell.length() * cell.what.duration)
    with ThreadPoolExecutor(jobs) as pool:
        return dict(zip([cell.name for cell in todo], pool.map(told, todo)))


def make_references(drill, todo, folder, jobs, budget):
    """False: some could not be made."""
    os.makedirs(REFERENCES, exist_ok=True)

    def make(cell):
        reference, why = matrix.make_reference(drill, cell, folder, budget)
        if reference is None:
            return False, '%-45s no reference: %s' % (cell.name, why)
        reference.save(path_of(cell))
        return True, '%-45s reference by %s, own error %.2f of the bound (%s)' % ((cell.name, reference.numerics) + matrix.worst_of(reference.own))
    return all(in_parallel(jobs, make, todo).values())


def own_error(cell):
    """Of the cell's reference, a share of the bound; infinite where there is none of this scene."""
    if not os.path.exists(path_of(cell)):
        return float('inf')
    reference = matrix.Reference.load(path_of(cell))
    return matrix.worst_of(reference.own)[0] if reference.made_of == matrix.fingerprint(cell) else float('inf')


def judge_run(drill, cell, folder, numerics, tolerances, energy=False):
    """Verdicts on one run."""
    if not os.path.exists(path_of(cell)):
        return [matrix.Verdict(cell, 'undecided', 'no reference') for _ in tolerances]
    reference = matrix.Reference.load(path_of(cell))
    if reference.made_of != matrix.fingerprint(cell):
        return [matrix.Verdict(cell, 'undecided', 'the reference is of another scene') for _ in tolerances]
    mine = matrix.run(drill, cell, numerics, folder, energy and cell.what.duration <= matrix.BALANCED)
    return [matrix.judge(cell, mine, reference, tolerance) for tolerance in tolerances]


def judge_all(drill, todo, folder, jobs, numerics, energy=False, tolerance=matrix.BOUND):
    def one(cell):
        verdict, = judge_run(drill, cell, folder, numerics, [tolerance], energy)
        return verdict, line_of(verdict)
    verdicts = in_parallel(jobs, one, todo)
    return [verdicts[cell.name] for cell in todo]


def line_of(v):
    return '%-45s %-9s %s' % (v.cell.name, v.kind, v.note or 'worst %.2f of the bound (%s), reference %.2f (%s)' % (v.worst, v.by, v.own, v.own_by))


def counts(verdicts):
    return collections.Counter(v.kind for v in verdicts)


def percent(share):
    return '%.2g' % (100.0 * share) if share == share else '-'


def table(verdicts):
    rows = ['| cell | verdict | largest error, bound 1 | of | reference\'s own | balance misses [%] | method takes [%] |',
            '| --- | --- | --- | --- | --- | --- | --- |']
    rows += ['| %s | %s | %.2f | %s | %.2f | %s | %s |' % (v.cell.name, v.kind, v.worst, v.by.replace('_', ' '), v.own, percent(v.closure),
                                                        percent(v.dissipation)) for v in verdicts]
    return '\n'.join(rows) + '\n'


def table_by_operation(verdicts):
    """A row each, with its cell that is nearest to the bound or farthest beyond, of those that are decided."""
    rows = ['| operation | cells | %s | largest error, bound 1 | of | in |' % ' | '.join(KINDS), '| --- | --- |%s --- | --- | --- |' % (' --- |' * len(KINDS))]
    for operation in cells.OPERATIONS:
        mine = [v for v in verdicts if v.cell.operation == operation]
        if not mine:
            continue
        told = counts(mine)
        worst = max((v for v in mine if v.kind != 'undecided' and v.worst == v.worst), key=lambda v: v.worst, default=None)
        words = ['%.2f' % worst.worst, worst.by.replace('_', ' '), '%s, %s' % (worst.cell.well, worst.cell.string)] if worst else ['-'] * 3
        rows.append('| %s |' % ' | '.join([operation, '%d' % len(mine)] + ['%d' % told[kind] for kind in KINDS] + words))
    return '\n'.join(rows) + '\n'


def summary_line(verdicts):
    told = counts(verdicts)
    under_a_warning = [v for v in verdicts if v.kind == 'right' and v.note != '']
    off = sum(v.window > 1.0 for v in under_a_warning)
    return '%d cells: %s; of the right ones under a warning: %d, of which %d are beyond the bound for three seconds' % (
        len(verdicts), ', '.join('%d %s' % (told[kind], kind) for kind in KINDS), len(under_a_warning), off)


def variants_table(results):
    """results: (numerics, verdicts); cost over the first's, of the cells that both ran."""
    rows = ['| method | step | longest element | right | warned | missed | undecided | cost |', '| --- | --- | --- | --- | --- | --- | --- | --- |']
    first = {v.cell.name: v.cost for v in results[0][1] if v.cost == v.cost}
    for numerics, verdicts in results:
        told, both = counts(verdicts), [v for v in verdicts if v.cell.name in first and v.cost == v.cost]
        cost = sum(v.cost for v in both) / sum(first[v.cell.name] for v in both)
        words = [numerics.method or 'the default', '%g ms' % (1e3 * numerics.step) if numerics.step else 'variable',
                 '%.3g m' % numerics.length if numerics.length else 'by the hole']
        rows.append('| %s | %.2f |' % (' | '.join(words + ['%d' % told[kind] for kind in KINDS]), cost))
    return '\n'.join(rows) + '\n'


def levels_table(results):
    """results: (numerics, verdicts); the first is the finest level. Near: of the decided those whose errors are all within 5 %."""
    rows = ['| level | right | warned | missed | undecided | within 5 % | largest missed error | cost |', '| --- | --- | --- | --- | --- | --- | --- | --- |']
    dearest = {v.cell.name: v.cost for v in results[0][1]}
    for numerics, verdicts in results:
        told, decided = counts(verdicts), [v for v in verdicts if v.kind != 'undecided']
        near = sum(v.worst <= WIDER for v in decided)
        missed = max((v.worst for v in decided if v.kind == 'missed'), default=0.0)
        both = [v for v in verdicts if v.cost == v.cost and dearest[v.cell.name] == dearest[v.cell.name]]
        cost = sum(v.cost for v in both) / sum(dearest[v.cell.name] for v in both)
        cells = ['%d' % told[kind] for kind in KINDS] + ['%d of %d' % (near, len(decided)), '%.1f %%' % (100.0 * matrix.BOUND * missed) if missed else '-']
        rows.append('| `%s` | %s | %.2f |' % (numerics, ' | '.join(cells), cost))
    return '\n'.join(rows) + '\n'


def chart(verdicts, path):
    import matplotlib
    matplotlib.use('Agg')
    from matplotlib import pyplot
    figure, axes = pyplot.subplots(figsize=(8.0, 4.5))
    for kind in KINDS:
        mine = [(k, v.worst) for k, v in enumerate(sorted(verdicts, key=lambda v: v.worst)) if v.kind == kind and v.worst == v.worst]
        if mine:
            axes.plot(*zip(*[(k, max(worst, 1e-3)) for k, worst in mine]), 'o', markersize=4, color=COLOURS[kind], label='%d %s' % (len(mine), kind))
    axes.axhline(1.0, color='black', linewidth=0.8)
    axes.set(yscale='log', xlabel='cells, by their largest error', ylabel='largest error over its bound (2 %)')
    axes.grid(alpha=0.3)
    axes.legend()
    figure.tight_layout()
    figure.savefig(path, dpi=110)
    pyplot.close(figure)


def write(name, text, out):
    with open(os.path.join(out, name), 'w') as file:
        file.write(text)
    return name


def play(args, out):
    """Exit status, and the names of what was written to `out`."""
    folder = os.path.join(out, 'runs')
    os.makedirs(folder, exist_ok=True)
    todo = [cell for cell in cells.CELLS if args.cells in cell.name and (not args.fast or cell.name in cells.FAST)]
    if not todo:
        print('run: no cell has %r in its name' % args.cells, file=sys.stderr)
        return 2, []
    if args.full and not make_references(args.drill, todo, folder, args.jobs, args.budget):
        return 3, []
    for asked, compared, name, as_table in ((args.variants, VARIANTS, 'variants.md', variants_table), (args.levels, LEVELS, 'levels.md', levels_table)):
        if not asked:
            continue
        short = [cell for cell in todo if cell.what.duration <= matrix.BALANCED]
        results = [(numerics, judge_all(args.drill, short, folder, args.jobs, numerics)) for numerics in compared]
        for numerics, verdicts in results:
            print('%s: %s' % (numerics, summary_line(verdicts)))
        return 0, [write(name, as_table(results), out)]
    if args.auto:
        return 0, [write('auto.md', play_automatic(args, todo, folder), out)]
    verdicts = judge_all(args.drill, todo, folder, args.jobs, matrix.Numerics(), energy=True)
    print(summary_line(verdicts))
    names = [write('operations.md', summary_line(verdicts) + '.\n\n' + table(verdicts), out),
             write('operations_by_kind.md', table_by_operation(verdicts) + '\n' + summary_line(verdicts) + '.\n', out)]
    if not args.no_pictures:
        chart(verdicts, os.path.join(out, 'operations.png'))
        names.append('operations.png')
    return (0 if holds(verdicts, whole=len(todo) == len(cells.CELLS)) else 1), names


def play_automatic(args, todo, folder):
    short = [cell for cell in todo if cell.what.duration <= matrix.BALANCED]
    return automatic.play(
        short, own_error, lambda todo, numerics, tolerance: judge_all(args.drill, todo, folder, args.jobs, numerics, tolerance=tolerance),
        lambda cell, numerics, tolerances: judge_run(args.drill, cell, folder, numerics, tolerances),
        lambda function, todo: in_parallel(args.jobs, function, todo), args.search)


def holds(verdicts, whole):
    """No cell missed, none right whose energy leaks; of the whole matrix enough right and decided. Says what does not hold."""
    told, good = counts(verdicts), True
    leaking = [v for v in verdicts if v.kind == 'right' and not v.balances()]
    for v in leaking:
        print('%s: energy balance misses %s %% of the throughput, the method takes %s %%' % (v.cell.name, percent(v.closure), percent(v.dissipation)))
    if whole:
        decided = len(verdicts) - told['undecided']
        good = told['right'] >= LEAST_RIGHT * decided and told['undecided'] <= MOST_UNDECIDED * len(verdicts)
        print('of the %d decided %.0f %% are right (at least %.0f), %.0f %% of all undecided (at most %.0f)' % (
            decided, 100.0 * told['right'] / max(decided, 1), 100.0 * LEAST_RIGHT, 100.0 * told['undecided'] / len(verdicts), 100.0 * MOST_UNDECIDED))
    return good and not leaking and not told['missed']
