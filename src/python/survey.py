"""Surveys by minimum curvature: between two stations the hole is an arc of a circle. Positions are (east, north, up) [m] from the rotary
table, angles in radians, inclination from vertical down, azimuth clockwise from north. Needs no ROS.
"""
import csv
import math

import numpy

NEEDED = ("md_m", "inclination_deg", "azimuth_deg")
TIE_IN = ("east_m", "north_m", "tvd_m")
POINT_SPACING = 0.5  # along a survey, of the chords that stand for its arcs [m]; 0.2 mm off an arc of 10 deg/30 m


class SurveyError(Exception):
    """What is wrong with a survey, in one line."""


def direction(inclination, azimuth):
    """The unit vector down the hole; of arrays, a row each."""
    side = numpy.sin(inclination)
    return numpy.stack([side * numpy.sin(azimuth), side * numpy.cos(azimuth), -numpy.cos(inclination)], axis=-1)


def angle_between(one, other):
    """Of unit vectors or rows of them [rad]; exact for small angles too."""
    return 2.0 * numpy.arctan2(numpy.linalg.norm(one - other, axis=-1), numpy.linalg.norm(one + other, axis=-1))


class Survey:
    """`md` strictly increasing [m]; `start`: where the first station lies."""

    def __init__(self, md, inclination, azimuth, start=(0.0, 0.0, 0.0)):
        self.md = numpy.asarray(md, dtype=float)
        if len(self.md) < 2 or not (numpy.diff(self.md) > 0.0).all():
            raise SurveyError("needed: two stations or more whose measured depth increases")
        self.tangents = direction(numpy.asarray(inclination, dtype=float), numpy.asarray(azimuth, dtype=float))
        self.doglegs = angle_between(self.tangents[:-1], self.tangents[1:])
        self.positions = numpy.empty_like(self.tangents)
        self.positions[0] = start
        for i, dogleg in enumerate(self.doglegs):
            self.positions[i + 1] = self.positions[i] + chord(self.tangents[i], self.tangents[i + 1], dogleg, self.md[i + 1] - self.md[i])

    def at(self, md):
        """Position and tangent; beyond its ends, of the end."""
        md = min(max(md, self.md[0]), self.md[-1])
        i = min(int(numpy.searchsorted(self.md, md, side="right")) - 1, len(self.md) - 2)
        length, dogleg = md - self.md[i], self.doglegs[i]
        share = length / (self.md[i + 1] - self.md[i])
        if dogleg < 1e-12:
            tangent = self.tangents[i]
        else:
            tangent = (math.sin((1.0 - share) * dogleg) * self.tangents[i] + math.sin(share * dogleg) * self.tangents[i + 1]) / math.sin(dogleg)
        return self.positions[i] + chord(self.tangents[i], tangent, share * dogleg, length), tangent

    def distances(self, points):
        """From each point to the nearest place of the survey [m]."""
        count = int(math.ceil((self.md[-1] - self.md[0]) / POINT_SPACING)) + 1
        track = numpy.array([self.at(md)[0] for md in numpy.union1d(numpy.linspace(self.md[0], self.md[-1], count), self.md)])
        starts, steps = track[:-1], numpy.diff(track, axis=0)
        lengths = (steps**2).sum(axis=1)
        found = []
        for point in numpy.asarray(points, dtype=float):
            share = numpy.clip(((point - starts) * steps).sum(axis=1) / lengths, 0.0, 1.0)
            found.append(numpy.linalg.norm(point - starts - share[:, None] * steps, axis=1).min())
        return numpy.array(found)


def chord(tangent, next_tangent, dogleg, length):
    """From one end of an arc to the other."""
    ratio = 1.0 if dogleg < 1e-9 else 2.0 / dogleg * math.tan(0.5 * dogleg)
    return 0.5 * length * ratio * (tangent + next_tangent)


def read_survey(file):
    """A CSV as the scenes' are: md_m, inclination_deg, azimuth_deg, and perhaps north_m, east_m, tvd_m of the first station. A first station
    below 0 without these is refused."""
    try:
        with open(file, newline="", encoding="utf-8-sig") as text:
            rows = list(csv.DictReader(line for line in text if line.strip() and not line.startswith("#")))
    except (OSError, UnicodeDecodeError) as error:
        raise SurveyError("%s: %s" % (file, getattr(error, "strerror", None) or "is no text"))
    rows = [{(name or "").strip(): cell for name, cell in row.items() if isinstance(cell, str)} for row in rows]
    try:
        md, inclination, azimuth = ([float(row[name]) for row in rows] for name in NEEDED)
        start = [float(rows[0][name]) for name in TIE_IN] if rows and all(name in rows[0] for name in TIE_IN) else None
    except (KeyError, ValueError) as error:
        raise SurveyError("%s: %s, needed: numbers in the columns %s" % (file, error, ", ".join(NEEDED)))
    if start is None and md and md[0] > 0.0:
        raise SurveyError("%s: begins at %g m, needed: a first station at 0, or its north_m, east_m and tvd_m" % (file, md[0]))
    east, north, tvd = start or (0.0, 0.0, 0.0)
    try:
        return Survey(md, numpy.radians(inclination), numpy.radians(azimuth), (east, north, -tvd))
    except SurveyError as error:
        raise SurveyError("%s: %s" % (file, error))
