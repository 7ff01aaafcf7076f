# SPDX-License-Identifier: BSD-3-Clause
"""Surveys by minimum curvature: between two stations the hole is an arc of a circle. Positions are (east, north, up) [m] from the rotary
table, angles in radians, inclination from vertical down, azimuth clockwise from north. Needs no ROS.
"""
import math
import os

import numpy
from drill_rig_sim.refusal import Refusal
from drill_rig_sim.text_file import report

POINT_SPACING = 0.5  # along a survey, of the chords that stand for its arcs [m]; 0.2 mm off an arc of 10 deg/30 m


class SurveyError(Refusal):
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


def read_survey(file, columns="", pass_over=False, plan=False):
    """A survey's file, read by the same code and rules as a scene's survey (scene/survey_file.h). `columns`: a map of its columns, a YAML file with
    the keys of a scene's well.survey; `pass_over`: stations without a value and repeated ones are passed over and reported; `plan`: of a file with a plan
    beside the drilled well the plan is read. Raises SurveyError with the first problem, as `file:LINE: column: problem`."""
    try:
        from drill_rig_sim import _sim  # pylint: disable=import-outside-toplevel
        from drill_rig_sim.lockstep import Refused  # pylint: disable=import-outside-toplevel
    except ImportError as error:
        raise SurveyError("surveys are read by the Python module sim, which is not built (it needs pybind11-dev): %s" % error)
    try:
        md, inclination, azimuth, start, remarks = _sim.read_survey(os.fspath(file), os.fspath(columns), pass_over, plan)
    except Refused as refusal:
        raise SurveyError(str(refusal).splitlines()[0])
    report(remarks)
    return Survey(md, inclination, azimuth, start)
