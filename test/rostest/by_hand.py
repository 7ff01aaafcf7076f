# SPDX-License-Identifier: BSD-3-Clause
"""Geometry that the tests work out by themselves: a well's path by minimum curvature, rotations, scenes as they are written."""
import math
import os

import yaml
from rig_test import PACKAGE_DIR

GRAVITY = 9.80665


def scene(name):
    with open(os.path.join(PACKAGE_DIR, "test", "scenes", name)) as file:
        return yaml.safe_load(file)


def add(a, b, share=1.0):
    return tuple(x + share * y for x, y in zip(a, b))


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def length(a):
    return math.sqrt(dot(a, a))


def distance(a, b):
    return length(add(a, b, -1.0))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def angle_between(a, b):
    return math.atan2(length(cross(a, b)), dot(a, b))


def xyz(message):
    """Of a point or a vector."""
    return (message.x, message.y, message.z)


def rotated(q, v):
    """The vector in the axes that the quaternion (w, x, y, z) turns from: v + 2 u x (u x v + w v)."""
    w, u = q[0], q[1:]
    return add(v, cross(u, add(cross(u, v), v, w)), 2.0)


def quaternion(message):
    return (message.w, message.x, message.y, message.z)


def product(p, q):
    return (p[0] * q[0] - dot(p[1:], q[1:]),) + add(add(cross(p[1:], q[1:]), q[1:], p[0]), p[1:], q[0])


def turn_between(p, q):
    """The rotation vector in world axes [rad] that leads from attitude p to q, the shorter way."""
    d = product(q, (p[0], -p[1], -p[2], -p[3]))
    if d[0] < 0.0:
        d = tuple(-x for x in d)
    size = length(d[1:])
    return tuple(2.0 * math.atan2(size, d[0]) / size * x for x in d[1:]) if size > 0.0 else (0.0, 0.0, 0.0)


def tangent(inclination, azimuth):
    """x east, y north, z up."""
    return (math.sin(inclination) * math.sin(azimuth), math.sin(inclination) * math.cos(azimuth), -math.cos(inclination))


class Well:
    """A scene's stations; the path by the ratio factor of minimum curvature, 2 / dogleg tan(dogleg / 2)."""

    def __init__(self, written):
        self.stations = [(md, tangent(math.radians(i), math.radians(a))) for md, i, a in written["well"]["stations"]]

    def at(self, md):
        """Place and direction at a measured depth; straight up above the first station."""
        place = (0.0, 0.0, 0.0)
        for (lower, t1), (upper, t2) in zip(self.stations, self.stations[1:]):
            dogleg = angle_between(t1, t2)
            share = min(1.0, (md - lower) / (upper - lower))
            here = t2 if share == 1.0 else self.between(t1, t2, dogleg, share)
            part = dogleg * share
            factor = 1.0 if abs(part) < 1e-9 else 2.0 / part * math.tan(0.5 * part)
            place = add(place, add(t1, here), 0.5 * (upper - lower) * share * factor)
            if share < 1.0:
                return place, here
        return place, self.stations[-1][1]

    @staticmethod
    def between(t1, t2, dogleg, share):
        if dogleg < 1e-9:
            return t1
        a, b = math.sin((1.0 - share) * dogleg), math.sin(share * dogleg)
        return tuple((a * x + b * y) / math.sin(dogleg) for x, y in zip(t1, t2))
