# SPDX-License-Identifier: BSD-3-Clause
"""Level auto on the operations matrix: does it meet the tolerances asked for, and what does it cost beside the cheapest setting by hand that does.

Only cells count whose reference knows its own error to a third of the tolerance. By hand: a search over level, mesh and step, cheapest first, up to
the first that meets the tolerance, or until they cost as much as auto did. Levels that do not represent what auto is asked for are left out.
"""
import collections
import math

import matrix

TOLERANCES = (0.05, 0.02, 0.01, 0.002)
FIXED = matrix.Numerics(level='beam3d')  # what costs are over: free nodes, steps of 10 ms
LEVELS = {'hybrid': 0.54, 'beam3d': 1.0}  # and about what they cost beside beam3d
MESHES = {(9.51, None): 0.6, (None, None): 1.0, (None, 2.4): 1.5, (2.4, None): 2.2}  # longest elements, and those where friction pushes the pipe [m]
STEPS = (0.05, 0.02, 0.01, 0.005, 0.0025)  # whole ones in the runs' 0.1 s [s]


def by_hand():
    """Settings, cheapest first."""
    found = [(share * finer / step, matrix.Numerics(length, step, None, level, pushed))
             for level, share in LEVELS.items() for (length, pushed), finer in MESHES.items() for step in STEPS]
    return [numerics for _, numerics in sorted(found, key=lambda pair: pair[0])]


DEARER = 3  # settings of the search, whose order is a guess, that cost more than auto: no cheaper one is expected


def cheapest(settings, autos, judged):
    """The first of the settings that is right and costs less than auto, whose own counted work by tolerance is `autos`: its work and name by
    tolerance; else auto's own. `judged(numerics, tolerances)`: verdicts on one run."""
    found, dearer = {}, collections.Counter()
    for numerics in settings:
        left = [t for t in autos if t not in found and dearer[t] < DEARER]
        if not left:
            break
        for tolerance, verdict in zip(left, judged(numerics, left)):
            if verdict.cost >= autos[tolerance]:
                dearer[tolerance] += 1
            elif verdict.kind == 'right':
                found[tolerance] = verdict.cost, str(numerics)
    return {tolerance: found.get(tolerance, (work, 'auto')) for tolerance, work in autos.items()}


def geometric_mean(numbers):
    return math.exp(sum(math.log(number) for number in numbers) / len(numbers)) if numbers else float('nan')


def number(value):
    return '%.2f' % value if value == value else '-'


class Row:
    """A tolerance's verdicts and their cost over others'."""

    def __init__(self, tolerance, verdicts, fixed):
        self.tolerance = tolerance
        self.counted = verdicts
        self.kinds = {kind: sum(v.kind == kind for v in self.counted) for kind in ('right', 'warned', 'missed')}
        self.cost = geometric_mean([v.cost / fixed[v.cell.name] for v in self.counted if v.cell.name in fixed])
        self.over_hand = []

    def autos(self):
        """Work of auto where it is right, by cell."""
        return {v.cell: v.cost for v in self.counted if v.kind == 'right'}

    def compare(self, hand):
        """`hand`: cheapest work by cell's name and tolerance."""
        self.over_hand = [v.cost / hand[v.cell.name, self.tolerance] for v in self.counted if v.kind == 'right']

    def line(self):
        share = '%.0f %%' % (100.0 * self.kinds['right'] / len(self.counted)) if self.counted else '-'
        words = ['%g %%' % (100.0 * self.tolerance), '%d' % len(self.counted)] + ['%d' % count for count in self.kinds.values()]
        words += [share, number(self.cost), number(geometric_mean(self.over_hand)), number(max(self.over_hand, default=float('nan')))]
        return '| %s |' % ' | '.join(words)


def table(rows):
    head = ['tolerance', 'cells known to a third of it', 'within', 'warned', 'missed', 'share within', 'cost', 'over the cheapest by hand', 'at most']
    return '\n'.join(['| %s |' % ' | '.join(head), '|%s' % (' --- |' * len(head))] + [row.line() for row in rows]) + '\n'


def search(rows, judge, each):
    """Cheapest work by hand, by cell's name and tolerance, where auto is right. `each(function, cells)`: results by name, in parallel."""
    wanted = collections.defaultdict(dict)
    for row in rows:
        for cell, work in row.autos().items():
            wanted[cell][row.tolerance] = work

    def of(cell):
        found = cheapest(by_hand(), wanted[cell], lambda numerics, tolerances: judge(cell, numerics, tolerances))
        told = ['%.2f to %g (%s)' % (wanted[cell][t] / work, t, name) for t, (work, name) in found.items()]
        return found, '%-45s auto over the cheapest: %s' % (cell.name, '; '.join(told))
    return {(name, tolerance): work for name, found in each(of, list(wanted)).items() for tolerance, (work, _) in found.items()}


def play(todo, own, judge_all, judge, each, searches):
    """The table. `own(cell)`: error of its reference, a share of matrix.BOUND, infinite where there is none; `judge_all(cells, numerics, tolerance)`:
    verdicts; `judge(cell, numerics, tolerances)`: verdicts on one run of a cell."""
    wanted = {cell: [t for t in TOLERANCES if own(cell) * matrix.BOUND <= matrix.KNOWN * t] for cell in todo}
    wanted = {cell: tolerances for cell, tolerances in wanted.items() if tolerances}
    fixed = {v.cell.name: v.cost for v in judge_all(list(wanted), FIXED, matrix.BOUND) if v.cost == v.cost}
    rows = []
    for t in TOLERANCES:
        verdicts = judge_all([cell for cell in wanted if t in wanted[cell]], matrix.Numerics(level='auto', tolerance=t), t)
        rows.append(Row(t, verdicts, fixed))
        print(rows[-1].line(), flush=True)
    if searches:
        hand = search(rows, judge, each)
        for row in rows:
            row.compare(hand)
    return table(rows)
