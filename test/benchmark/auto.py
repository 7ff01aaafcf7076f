# SPDX-License-Identifier: BSD-3-Clause
"""Level auto beside the points by hand: what it keeps of its tolerance in each scene, and what it costs over the cheapest that is as accurate."""
import os

import points as points_of
import verdict

KNOWN = 1.0 / 3.0  # of tolerance or error, the larger, that a reference's own error may be for auto to be judged by it
EQUAL = 1.01  # errors that differ by less are equal
FIXED = 0.01  # step of the run by hand beside it: free nodes, the default's mesh [s]
HEAD = ('scene', 'tolerance', 'error', 'the run warns', 'its work / the cheapest\'s at no more error', 'which that is', 'its work / that of free nodes by 10 ms')


def cheapest(points, error, floor=0.0):
    """Of all meshes, levels and steps, auto's own among them, the point of least work whose error is no larger. Errors below the reference's own,
    `floor`, say nothing: they count as the floor."""
    return min((p for p in points if p.counted and p.error <= max(EQUAL * error, floor)), key=lambda p: p.work)


def is_fixed(p):
    return (p.level, p.method, p.step, p.length, p.newton, p.tolerance) == (points_of.BEAM, points_of.VARIABLE_METHOD, FIXED, points_of.MESH_BY_THE_HOLE, None, None)


class Row:
    """A run of auto in its scene."""

    def __init__(self, point, points, floor=0.0):
        self.point = point
        self.floor = floor
        self.over_cheapest = self.over_fixed = float('nan')
        if not point.errors:
            return
        self.rival = cheapest(points, point.error, floor)
        self.over_cheapest = point.work / self.rival.work
        fixed = next((p for p in points if is_fixed(p)), None)
        if fixed and fixed.errors:
            self.over_fixed = point.work / fixed.work

    @property
    def judged(self):
        return self.floor <= KNOWN * max(self.point.tolerance, self.point.error)

    @property
    def within(self):
        return self.point.error <= self.point.tolerance

    def line(self):
        scene, tolerance = self.point.scene.title, '%g %%' % (100.0 * self.point.tolerance)
        if not self.point.errors:
            return '| %s | %s | failed: %s | | | | |' % (scene, tolerance, self.point.failure)
        return '| %s | %s | %s | %s | %.2f | %s | %.2f |' % (scene, tolerance, points_of.percent(self.point.error), 'yes' if self.point.warned else 'no', self.over_cheapest,
                                                           'itself' if self.rival is self.point else self.rival.label(), self.over_fixed)


def rows(by_scene, floors):
    """`by_scene`: points by the scene's name; `floors`: errors of the references."""
    return [Row(p, points, floors[name]) for name, points in by_scene.items() for p in sorted(points, key=lambda p: -(p.tolerance or 0.0)) if p.level == points_of.AUTO]


def means(found):
    """A line a tolerance."""
    lines = []
    for tolerance in sorted({row.point.tolerance for row in found}, reverse=True):
        of = [row for row in found if row.point.tolerance == tolerance and row.point.errors]
        if not of:
            continue
        judged = [row for row in of if row.judged]
        lines.append('To %g %%: within it in %d of the %d scenes whose reference is accurate enough; in geometric mean over all %.2f times the cheapest\'s work, %.2f times that of free nodes by 10 ms.'
                     % (100.0 * tolerance, sum(row.within for row in judged), len(judged), *(verdict.geometric_mean(ratios) for ratios in ([row.over_cheapest for row in of], [row.over_fixed for row in of]))))
    return lines


def text(found):
    lines = ['| %s |' % ' | '.join(HEAD), '|%s' % (' --- |' * len(HEAD))] + [row.line() for row in found]
    return '\n'.join(lines + ([''] if found else []) + ['- %s' % line for line in means(found)]) + '\n'


def write(by_scene, floors, folder):
    """auto.md; returns its name."""
    with open(os.path.join(folder, 'auto.md'), 'w') as out:
        out.write(text(rows(by_scene, floors)))
    return ['auto.md']
