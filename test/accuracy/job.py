# SPDX-License-Identifier: BSD-3-Clause
"""What a run of the main job shows: its data, its checks against sums by hand, and the shape of the drilled path."""
import csv
import json
import os

import numpy
import yaml

GRAVITY = 9.80665
TONNE = 1000.0 * GRAVITY  # [N]


class Check:
    """A figure of ours beside what it must be; `published` is the paper's, where it has one. tolerance None: reported, not judged."""

    def __init__(self, name, unit, ours, expected, tolerance, published=None):
        self.name, self.unit, self.ours, self.expected, self.tolerance, self.published = name, unit, ours, expected, tolerance, published

    @property
    def holds(self):
        return bool(self.tolerance is None or abs(self.ours - self.expected) <= self.tolerance)

    @property
    def difference(self):
        """Of ours from what is expected, relative."""
        return None if self.expected is None else abs(self.ours / self.expected - 1.0)

    @property
    def bound(self):
        """Of the relative difference."""
        return None if self.tolerance is None else self.tolerance / abs(self.expected)

    def cells(self):
        """case, ours, expected, relative difference, bound; - where there is none."""
        def shown(value, form):
            return '-' if value is None else form % value
        return [self.name, ('%.4g %s' % (self.ours, self.unit)).strip(), shown(self.expected, '%.4g'), shown(self.difference, '%.1e'),
                shown(self.bound, '%.1e')]

    def __str__(self):
        return ', '.join(self.cells()) + ('' if self.holds else '  FAILED')


class AtLeast(Check):
    """A figure with a lower limit."""

    def __init__(self, name, unit, ours, least):
        super().__init__(name, unit, ours, None, None)
        self.least = least

    def cells(self):
        return super().cells()[:-1] + ['at least %g' % self.least if self.least > 0.0 else '-']

    @property
    def holds(self):
        return self.ours >= self.least


class Sign(Check):
    """A figure of which theory tells the sign alone: +1 or -1."""

    def __init__(self, name, unit, ours, sign):
        super().__init__(name, unit, ours, None, None)
        self.sign = sign

    def cells(self):
        return super().cells()[:-1] + ['above 0' if self.sign > 0 else 'below 0']

    @property
    def holds(self):
        return bool(self.sign * self.ours > 0.0)


def table(name):
    """A CSV file with a header as a dict of arrays."""
    with open(name) as text:
        header = next(csv.reader(text))
        rows = numpy.atleast_2d(numpy.loadtxt(text, delimiter=','))
    return {key: rows[:, i] for i, key in enumerate(header)}


class Helix:
    """A wobble about a straight line: fits the line, and the pitch as the strongest period of the two lateral offsets."""

    def __init__(self, points, expected_pitch=None):
        centre = points.mean(axis=0)
        axis = numpy.linalg.svd(points - centre, full_matrices=False)[2][0]
        self.axis = axis if axis @ (points[-1] - points[0]) > 0 else -axis
        up = numpy.array([0.0, 0.0, 1.0])
        high = up - (up @ self.axis) * self.axis
        high /= numpy.linalg.norm(high)
        right = numpy.cross(self.axis, high)
        self.along = (points - centre) @ self.axis
        self.along -= self.along[0]
        self.high, self.right = (self._without_drift((points - centre) @ d) for d in (high, right))
        self.pitch = self._pitch(expected_pitch)
        self.radius = numpy.sqrt(numpy.mean(self.high ** 2 + self.right ** 2))

    def _without_drift(self, offset):
        """Takes out the slow bend of the hole, which is no wobble."""
        return offset - numpy.polyval(numpy.polyfit(self.along, offset, 3), self.along)

    def _pitch(self, expected):
        """Period of the largest Fourier amplitude; near `expected` if that is given."""
        def power(k):
            wave = numpy.exp(-2j * numpy.pi * k * self.along) * numpy.hanning(len(self.along))
            return abs(numpy.sum(wave * (self.high + 1j * self.right))) ** 2 + abs(numpy.sum(wave * (self.high - 1j * self.right))) ** 2
        length = self.along[-1]
        if expected:
            low, high = 0.7 / expected, 1.4 / expected
        else:
            low, high = 3.0 / length, 0.5 * (len(self.along) - 1) / length
        coarse = numpy.arange(low, high, 0.2 / length)
        best = coarse[int(numpy.argmax([power(k) for k in coarse]))]
        fine = numpy.linspace(best - 0.2 / length, best + 0.2 / length, 81)
        return 1.0 / fine[int(numpy.argmax([power(k) for k in fine]))]


class Job:
    """One finished run in `folder`."""

    def __init__(self, scene_file, folder):
        with open(scene_file) as text:
            self.scene = yaml.safe_load(text)
        survey = os.path.join(os.path.dirname(scene_file), self.scene['well']['survey'])
        with open(survey) as text:
            rows = [line for line in text if not line.startswith('#')]
        self.survey = numpy.array([[float(cell) for cell in row.split(',')] for row in rows[1:]])
        with open(os.path.join(folder, 'summary.json')) as text:
            self.summary = json.load(text)
        self.series = table(os.path.join(folder, 'series.csv'))
        self.path = table(os.path.join(folder, 'path.csv'))
        raw = table(os.path.join(folder, 'raw_path.csv'))
        self.raw = numpy.column_stack([raw['east'], raw['north'], raw['up']])
        self.mean = self.summary['mean_last_quarter']
        self.start_depth = float(self.scene['well']['hole_depth'])

        program = self.scene['program']
        self.rotary = [step['top_drive_speed_rpm'] for step in program if 'top_drive_speed_rpm' in step][-1] / 60.0  # [rev/s]
        self.feed = -[step['block_velocity'] for step in program if 'block_velocity' in step][-1]                    # [m/s]
        self.drilled = self.drilled_nodes()
        if len(self.drilled['md']) < 10 or len(self.raw) < 200:
            raise SystemExit('run: the job drilled too little for the pictures')
        self.raw_helix = Helix(self.raw[-min(len(self.raw), 4000):], self.feed / self.rotary)
        self.corrected_points = numpy.column_stack([self.drilled[key] for key in ('east', 'north', 'up')])
        # the last metres only: the first one remembers the tag, and over 30 m the assembly's drift hides a wobble of 30 um
        self.corrected_helix = Helix(self.corrected_points[self.drilled['md'] > max(self.start_depth + 1.0, self.drilled['md'][-1] - 4.0)])

    def drilled_nodes(self):
        """The corrected nodes below the old bottom; the last row, the newly drilled interval's bottom, is left out."""
        fresh = self.path['md'][:-1] > self.start_depth + 1e-6
        return {key: values[:-1][fresh] for key, values in self.path.items()}

    def raw_tangents(self):
        """Unit chords of the raw path and where they stand along it [m]."""
        chords = numpy.diff(self.raw, axis=0)
        lengths = numpy.linalg.norm(chords, axis=1)
        good = lengths > 1e-6
        return chords[good] / lengths[good, None], numpy.cumsum(lengths)[good]

    def tangent_swing_deg(self):
        """Mean angle between the raw path's tangents and their mean direction."""
        tangents = self.raw_tangents()[0]
        mean = tangents.mean(axis=0)
        mean /= numpy.linalg.norm(mean)
        return numpy.degrees(numpy.mean(numpy.arccos(numpy.clip(tangents @ mean, -1.0, 1.0))))

    def inclination_at(self, md):
        """Of the hole [rad]: the survey, then the drilled path; vertical above the table."""
        mds = numpy.concatenate([self.survey[:, 0], self.drilled['md']])
        inclinations = numpy.concatenate([numpy.radians(self.survey[:, 1]), self.drilled['inclination']])
        return numpy.interp(md, mds, inclinations, left=0.0)

    def soft_string_hook_load(self):
        """Weight of string and block by a sum along the well, less the weight on bit: rotating, so friction takes no axial part."""
        m = self.mean
        mud = self.scene['mud']['density']
        parts = self.scene['string']
        above = m['hole_depth']  # measured depth of the part's lower end
        top = -(self.start_height() - (m['hole_depth'] - self.scene['start']['bit_depth']))
        total = 0.0
        for part in parts:
            length = part.get('length', part.get('joints', 1) * part['joint_length'] if part.get('joints') not in (None, 'fill') else None)
            length = above - top if length is None else length
            linear_mass = part.get('linear_mass', part.get('mass', 0.0) / length)
            middles = above - (numpy.arange(1000) + 0.5) * length / 1000.0
            buoyant = numpy.where(middles > 0.0, 1.0 - mud / part.get('density', 7850.0), 1.0)
            total += linear_mass * GRAVITY * length * numpy.mean(buoyant * numpy.cos(self.inclination_at(middles)))
            above -= length
        hoisting = self.scene['rig']['hoisting']
        rail = hoisting.get('rail_friction', 0.03)  # the block goes down, and its rail carries this share of it
        return total + GRAVITY * hoisting['block_mass'] * (1.0 - rail) - m['wob']

    def start_height(self):
        return self.scene['start']['block_height']

    def wob_of_rock_law(self):
        """The weight that the formation's law asks for at the run's own rate of penetration."""
        layer = self.scene['formation'][0]
        speed = self.mean['bit_speed_rpm'] * 2.0 * numpy.pi / 60.0
        rate = self.mean['rop'] / (layer['drillability'] * speed ** layer.get('speed_exponent', 1.0))
        return rate ** (1.0 / layer.get('weight_exponent', 1.0)) + layer.get('threshold', 0.0)

    def drift_rates(self):
        """Turn of the corrected path per 30 m [deg]: inclination, azimuth. The first metre, which remembers the tag, is left out."""
        rates = []
        later = self.drilled['md'] > min(self.start_depth + 1.0, self.drilled['md'][-10])
        for key in ('inclination', 'azimuth'):
            angle = numpy.degrees(numpy.unwrap(self.drilled[key]))
            rates.append(30.0 * numpy.polyfit(self.drilled['md'][later], angle[later], 1)[0])
        return rates

    def first_turn(self):
        """Turn of the corrected path from the survey's end over the first metre drilled [deg]: inclination, azimuth."""
        md = self.drilled['md']
        near = numpy.abs(md - self.start_depth - 1.0) < 0.5
        return [numpy.degrees(numpy.mean(numpy.unwrap(self.drilled[key][near]))) - self.survey[-1, column]
                for column, key in ((1, 'inclination'), (2, 'azimuth'))]

    def aliased_pitch(self):
        """Period that a helix of the raw pitch seems to have when it is looked at once every correction interval [m]."""
        interval = numpy.median(numpy.diff(self.drilled['md']))
        turns = interval / self.raw_helix.pitch
        return interval / max(abs(turns - round(turns)), 1e-9)

    def checks(self, least_real_time_factor=0.0):
        m = self.mean
        depth = [numpy.degrees(numpy.mean(self.drilled[key])) for key in ('inclination', 'azimuth')]
        soft, law = self.soft_string_hook_load(), self.wob_of_rock_law()
        pitch = self.feed / self.rotary
        drift = self.drift_rates()
        drilled = self.drilled['md'][-1] - self.start_depth
        return [
            Check('rate of penetration = feed', 'm/h', 3600.0 * m['rop'], 3600.0 * self.feed, 0.005 * 3600.0 * self.feed, '32.7 m/h'),
            Check('hook load = soft-string sum - WOB', 't', m['hook_load'] / TONNE, soft / TONNE, 0.01 * soft / TONNE, '34 t'),
            Check('WOB = rock law at this ROP', 'kN', m['wob'] / 1e3, law / 1e3, 0.02 * law / 1e3),
            Check('mean inclination of the drilled path', 'deg', depth[0], 51.0, 0.3, '51 deg'),
            Check('mean azimuth of the drilled path', 'deg', depth[1], 297.0, 1.0, '297 deg'),
            Check('pitch of the raw helix', 'mm', 1e3 * self.raw_helix.pitch, 1e3 * pitch, 0.02 * 1e3 * pitch),
            Check('swing of the raw tangents', 'deg', self.tangent_swing_deg(), 1.0, 0.3),
            Check('radius of the raw helix', 'um', 1e6 * self.raw_helix.radius, None, None),
            Check('pitch of the corrected (aliased) helix', 'm', self.corrected_helix.pitch, self.aliased_pitch(), 0.05 * self.aliased_pitch()),
            Check('radius of the corrected (aliased) helix', 'um', 1e6 * self.corrected_helix.radius, None, None),
            Check('top-drive torque', 'kN m', m['torque'] / 1e3, None, None),
            Check('bit torque', 'kN m', m['bit_torque'] / 1e3, None, None),
            Check('bit speed', 'rad/s', m['bit_speed_rpm'] * 2.0 * numpy.pi / 60.0, None, None),
            # no stabiliser near the bit: its gauge lies on the low side, where side cutting drops the hole, and where the bit that turns
            # clockwise climbs to the right
            Sign('drift of inclination', 'deg/30 m', drift[0], -1),
            Sign('drift of azimuth', 'deg/30 m', drift[1], +1),
            Check('drilled', 'm', drilled, None, None, '30 m'),
            AtLeast('real-time factor (CPU time, one core)', '', self.summary['real_time_factor'], least_real_time_factor),
        ]
