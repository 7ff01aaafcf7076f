"""Level auto on the operations matrix: does it meet the tolerances asked for, and what does it cost beside the cheapest setting by hand that does.

Only cells count whose reference knows its own error to a third of the tolerance. By hand: a search over level, mesh and step, cheapest first, up to
the first that meets the tolerance.
"""
import math

import matrix

TOLERANCES = (0.05, 0.02, 0.01, 0.002)
FIXED = matrix.Numerics(level='beam3d')  # what costs are over: free nodes, steps of 10 ms
LEVELS = {'axial_torsional': 0.27, 'hybrid': 0.54, 'beam3d': 1.0}  # and about what they cost beside beam3d
MESHES = {(9.51, None): 0.6, (None, None): 1.0, (None, 2.4): 1.5, (2.4, None): 2.2}  # longest elements, and those where friction pushes the pipe [m]
STEPS = (0.04, 0.02, 0.01, 0.005, 0.0025)  # [s]


def by_hand():
    """Settings, cheapest first."""
    found = [(share * finer / step, matrix.Numerics(length, step, None, level, pushed))
             for level, share in LEVELS.items() for (length, pushed), finer in MESHES.items() for step in STEPS]
    return [numerics for _, numerics in sorted(found, key=lambda pair: pair[0])]


def cheapest(settings, tolerances, judged):
    """Counted work of the first of the settings that is right, by tolerance. `judged(numerics, tolerance)`: a run's verdict."""
    found = {}
    for numerics in settings:
        for tolerance in tolerances:
            if tolerance not in found:
                verdict = judged(numerics, tolerance)
                if verdict.kind == 'right':
                    found[tolerance] = verdict.cost
        if len(found) == len(tolerances):
            break
    return found


def geometric_mean(numbers):
    return math.exp(sum(math.log(number) for number in numbers) / len(numbers)) if numbers else float('nan')


def number(value):
    return '%.2f' % value if value == value else '-'


class Row:
    """A tolerance's verdicts and their cost over others'."""

    def __init__(self, tolerance, verdicts, fixed, hand):
        self.tolerance = tolerance
        self.counted = verdicts
        self.kinds = {kind: sum(v.kind == kind for v in self.counted) for kind in ('right', 'warned', 'silent')}
        self.cost = geometric_mean([v.cost / fixed[v.cell.name] for v in self.counted if v.cell.name in fixed])
        self.over_hand = [v.cost / hand[v.cell.name, tolerance] for v in self.counted if v.kind == 'right' and (v.cell.name, tolerance) in hand]

    def line(self):
        share = '%.0f %%' % (100.0 * self.kinds['right'] / len(self.counted)) if self.counted else '-'
        words = ['%g %%' % (100.0 * self.tolerance), '%d' % len(self.counted)] + ['%d' % count for count in self.kinds.values()]
        words += [share, number(self.cost), number(geometric_mean(self.over_hand)), number(max(self.over_hand, default=float('nan')))]
        return '| %s |' % ' | '.join(words)


def table(rows):
    head = ['tolerance', 'cells known to a third of it', 'within', 'warned', 'silent', 'share within', 'cost', 'over the cheapest by hand', 'at most']
    return '\n'.join(['| %s |' % ' | '.join(head), '|%s' % (' --- |' * len(head))] + [row.line() for row in rows]) + '\n'


def search(wanted, judge, each):
    """Cheapest work by hand, by cell's name and tolerance. `wanted`: tolerances by cell; `each(function, cells)`: results by name, in parallel."""
    def of(cell):
        found = cheapest(by_hand(), wanted[cell], lambda numerics, tolerance: judge(cell, numerics, tolerance))
        return found, '%-45s by hand: %s' % (cell.name, ', '.join('%g: %.3g' % pair for pair in found.items()) or 'nothing')
    found = each(of, list(wanted))
    return {(name, tolerance): cost for name, costs in found.items() for tolerance, cost in costs.items()}


def play(todo, own, judge_all, judge, each, searches):
    """The table. `own(cell)`: error of its reference, a share of matrix.BOUND, infinite where there is none; `judge_all(cells, numerics, tolerance)`:
    verdicts; `judge` of one cell."""
    wanted = {cell: [t for t in TOLERANCES if own(cell) * matrix.BOUND <= matrix.KNOWN * t] for cell in todo}
    wanted = {cell: tolerances for cell, tolerances in wanted.items() if tolerances}
    fixed = {v.cell.name: v.cost for v in judge_all(list(wanted), FIXED, matrix.BOUND) if v.cost == v.cost}
    hand = search(wanted, judge, each) if searches else {}
    rows = []
    for t in TOLERANCES:
        verdicts = judge_all([cell for cell in wanted if t in wanted[cell]], matrix.Numerics(level='auto', tolerance=t), t)
        rows.append(Row(t, verdicts, fixed, hand))
        print(rows[-1].line(), flush=True)
    return table(rows)
