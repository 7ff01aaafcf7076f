# SPDX-License-Identifier: BSD-3-Clause
"""Pareto front of cost against error, and what it says of the default; and whether the default's own error is as small as it should be."""
import math

GEOMETRIC_MEAN_LIMIT = 1.5  # of the default's cost over the best method's at the same error
SCENE_LIMIT = 4.0           # in one scene


def front(points):
    """The points (error, cost) that no other beats in both, by rising error."""
    best = []
    for error, cost in sorted(points):
        if not best or cost < best[-1][1]:
            best.append((error, cost))
    return best


def cost_at(points, error):
    """Cost of the best at this error: log-log between the front's points. Beyond its cheapest point nothing gets cheaper; nan where no
    point is as accurate."""
    best = front(points)
    if not best or error < best[0][0]:
        return math.nan
    for (e0, c0), (e1, c1) in zip(best, best[1:]):
        if error < e1:
            if e0 <= 0.0:
                return c0
            share = math.log(error / e0) / math.log(e1 / e0)
            return c0 * (c1 / c0) ** share
    return best[-1][1]


def geometric_mean(values):
    return math.exp(sum(math.log(value) for value in values) / len(values))


class SceneVerdict:
    """`points`, `default`: (error, cost). Errors below `floor`, the reference's own, say nothing: they count as the floor.
    `largest_error`: that the default may have, whatever it costs; None: any. `coarse`: (error, cost) on meshes too coarse to compete: what
    the default's mesh costs where they would do, told and not judged."""

    def __init__(self, name, points, default, floor=0.0, largest_error=None, coarse=()):
        def floored(point):
            return max(point[0], floor), point[1]
        self.name = name
        self.largest_error = largest_error
        self.own_error = default[0]
        self.error, self.cost = floored(default)
        self.best = cost_at([floored(p) for p in points] + [floored(default)], self.error)
        self.ratio = self.cost / self.best
        self.ratio_on_any_mesh = self.cost / cost_at([floored(p) for p in (*points, *coarse, default)], self.error)

    @property
    def cheap_enough(self):
        return self.ratio <= SCENE_LIMIT

    @property
    def near_enough(self):
        return self.largest_error is None or self.own_error <= self.largest_error


class Verdict:
    """`scenes`: SceneVerdict each; `failed`: names of scenes in which the default gave no result."""

    def __init__(self, scenes, failed=()):
        self.scenes = scenes
        self.complaints = ['%s: the default failed' % name for name in failed]
        self.mean = self.mean_on_any_mesh = math.nan
        if scenes:
            self.mean = geometric_mean([s.ratio for s in scenes])
            self.mean_on_any_mesh = geometric_mean([s.ratio_on_any_mesh for s in scenes])
        if not self.mean <= GEOMETRIC_MEAN_LIMIT:
            self.complaints.append('the default costs %.2f times the best method at the same error in geometric mean, %.1f is allowed'
                                   % (self.mean, GEOMETRIC_MEAN_LIMIT))
        for s in scenes:
            if not s.near_enough:
                self.complaints.append('%s: the error of the default is %.1e, %.1e is allowed' % (s.name, s.own_error, s.largest_error))
            if not s.cheap_enough:
                self.complaints.append('%s: the default costs %.1f times the best method at the same error, %.0f is allowed'
                                       % (s.name, s.ratio, SCENE_LIMIT))

    @property
    def holds(self):
        return not self.complaints
