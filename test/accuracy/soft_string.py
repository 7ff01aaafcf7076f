# SPDX-License-Identifier: BSD-3-Clause
"""Torque and drag of a soft string: no bending stiffness, no clearance. Knows nothing of the simulator.

Johancsik, Friesen and Dawson 1984, as vectors: the side force on a piece of length h is what weight w h and tension T leave across the hole,
    |(w h)_across + T k h|   (k: curvature of the hole, towards the centre of its circle),
and up the hole tension grows by w h cos I, and by friction times the side force, + when it is pulled, - when it is lowered, 0 when it turns.
Axes: east, north, up [m]; t points down the hole.
"""
import bisect
import math

import numpy

GRAVITY = 9.80665
PIECE = 0.5  # longest piece [m]


class Hole:
    """Stations (measured depth [m], inclination, azimuth [deg]) joined by circular arcs (minimum curvature)."""

    def __init__(self, stations):
        self.md = [row[0] for row in stations]
        inclination, azimuth = (numpy.radians([row[k] for row in stations]) for k in (1, 2))
        self.tangents = numpy.stack([numpy.sin(inclination) * numpy.sin(azimuth), numpy.sin(inclination) * numpy.cos(azimuth),
                                     -numpy.cos(inclination)], axis=1)

    def at(self, md):
        """Tangent t and curvature dt/ds [1/m]."""
        i = min(max(bisect.bisect_right(self.md, md) - 1, 0), len(self.md) - 2)
        length = self.md[i + 1] - self.md[i]
        a, b = self.tangents[i], self.tangents[i + 1]
        turn = math.atan2(numpy.linalg.norm(numpy.cross(a, b)), a @ b)
        if turn < 1e-9:
            return a, numpy.zeros(3)
        there = turn * (md - self.md[i]) / length
        tangent = (math.sin(turn - there) * a + math.sin(there) * b) / math.sin(turn)
        return tangent, (math.cos(there) * b - math.cos(turn - there) * a) / math.sin(turn) * turn / length


class SoftString:
    """A string in a hole, its lower end at `depth` [m]. `parts`: (length [m], mass per length in air [kg/m]) from the bit up, the last one
    reaching the surface; `buoyancy`: weight in mud over weight in air."""

    def __init__(self, hole, parts, depth, buoyancy):
        self.pieces = []  # from the bit up: measured depth, weight along the hole, then side force squared as a + 2 b T + c T^2
        left = depth
        for length, mass in parts[:-1] + [(math.inf, parts[-1][1])]:
            length = min(length, left)
            count = math.ceil(length / PIECE)
            for k in range(count):
                self._add(hole, left - (k + 0.5) * length / count, length / count, GRAVITY * mass * buoyancy)
            left -= length

    def _add(self, hole, md, length, weight):
        tangent, curvature = hole.at(md)
        load = numpy.array([0.0, 0.0, -weight * length])
        along = load @ tangent
        across, bend = load - along * tangent, curvature * length
        self.pieces.append((md, along, across @ across, across @ bend, bend @ bend))

    def hook_load(self, friction, sense):
        """[N]; `friction`: a function of measured depth; `sense`: 1 pulled up, -1 lowered, 0 turning."""
        tension = 0.0
        for md, along, a, b, c in self.pieces:
            side = math.sqrt(max(0.0, a + tension * (2.0 * b + tension * c)))
            tension += along + sense * friction(md) * side
        return tension
