# SPDX-License-Identifier: BSD-3-Clause
"""The pictures of the main job; the paper's figures stand beside ours where it states one."""
import os

import matplotlib
matplotlib.use('Agg')
import matplotlib.pyplot as pyplot  # noqa: E402 (the backend comes first)
import numpy  # noqa: E402

from job import TONNE  # noqa: E402

OURS, SEED, RAW = '#1f5fa8', '#c0392b', '#d9822b'
pyplot.rcParams.update({'font.size': 9, 'axes.grid': True, 'grid.alpha': 0.3, 'figure.figsize': (8.0, 4.5), 'savefig.bbox': 'tight',
                        'svg.hashsalt': 'drill_rig_sim'})


def save(figure, folder, name):
    """As SVG, and as PNG for a quick look; returns the names."""
    figure.tight_layout()
    for ending in ('svg', 'png'):
        figure.savefig(os.path.join(folder, name + '.' + ending), dpi=110)
    pyplot.close(figure)
    return [name + '.svg', name + '.png']


def room_above(axes):
    """A legend that hides no line."""
    low, high = axes.get_ylim()
    axes.set_ylim(low, high + 0.25 * (high - low))
    axes.legend(loc='upper right', ncol=2)


def loads(job, folder):
    series = job.series
    figure, (hook, torque, rate) = pyplot.subplots(3, 1, sharex=True, figsize=(8.0, 6.5))
    hook.plot(series['time'], series['hook_load'] / TONNE, color=OURS, linewidth=0.8, label='drill_rig_sim')
    hook.axhline(34.0, color=SEED, linestyle='--', label='published: 34 t while drilling')
    hook.set_ylabel('hook load [t]')
    hook.legend(loc='upper right')
    hook.set_ylim(32.0, 44.0)
    torque.plot(series['time'], series['torque'] / 1e3, color=OURS, linewidth=0.8, label='top drive')
    torque.plot(series['time'], series['bit_torque'] / 1e3, color=RAW, linewidth=0.8, label='bit')
    torque.set_ylabel('torque [kN m]')
    room_above(torque)
    rate.plot(series['time'], 3600.0 * series['rop'], color=OURS, linewidth=0.8, label='drill_rig_sim')
    rate.axhline(32.7, color=SEED, linestyle='--', label='published: 32.7 m/h')
    rate.set_ylabel('rate of penetration [m/h]')
    rate.set_xlabel('time [s]')
    rate.legend(loc='lower right')
    hook.set_title('The main job at 53 rpm: the bit tags at 250 s')
    return save(figure, folder, 'hook_load_and_torque')


def projections(job, folder):
    d = job.drilled
    figure, (plan, section) = pyplot.subplots(1, 2, figsize=(9.0, 4.2))
    origin = numpy.array([d['east'][0], d['north'][0], d['up'][0]])
    length = d['md'][-1] - d['md'][0]
    inclination, azimuth = numpy.radians([51.0, 297.0])
    straight = numpy.outer([0.0, length], [numpy.sin(inclination) * numpy.sin(azimuth), numpy.sin(inclination) * numpy.cos(azimuth),
                                           -numpy.cos(inclination)])
    offset = job.corrected_points - origin
    plan.plot(straight[:, 0], straight[:, 1], color=SEED, linestyle='--', label='published: 297 deg')
    plan.plot(offset[:, 0], offset[:, 1], color=OURS, label='drill_rig_sim')
    plan.set_xlabel('east [m]')
    plan.set_ylabel('north [m]')
    plan.set_title('horizontal projection')
    section.plot(numpy.hypot(straight[:, 0], straight[:, 1]), -straight[:, 2], color=SEED, linestyle='--', label='published: 51 deg')
    section.plot(offset[:, :2] @ straight[1, :2] / numpy.hypot(*straight[1, :2]), -offset[:, 2], color=OURS, label='drill_rig_sim')
    section.set_xlabel('along 297 deg [m]')
    section.set_ylabel('deeper [m]')
    section.invert_yaxis()
    section.set_title('vertical projection')
    for axes in (plan, section):
        axes.set_aspect('equal')
        axes.legend()
    return save(figure, folder, 'projections')


def directions(job, folder):
    d = job.drilled
    tangents, along = job.raw_tangents()
    md = d['md'][-1] - along[-1] + along
    raw = {'inclination': numpy.degrees(numpy.arccos(-tangents[:, 2])),
           'azimuth': numpy.degrees(numpy.arctan2(tangents[:, 0], tangents[:, 1])) % 360.0}
    figure, axes = pyplot.subplots(2, 1, sharex=True, figsize=(8.0, 5.5))
    for ax, key, published in zip(axes, ('inclination', 'azimuth'), (51.0, 297.0)):
        drilling = md > job.start_depth + 0.1  # before that the bit finds its place
        ax.plot(md[drilling], raw[key][drilling], color=RAW, linewidth=0.3, alpha=0.6, label='raw path, last metres')
        ax.plot(d['md'], numpy.degrees(d[key]), color=OURS, linewidth=1.0, label='corrected path')
        ax.axhline(published, color=SEED, linestyle='--', label='published mean: %g deg' % published)
        ax.set_ylabel(key + ' [deg]')
        low, high = ax.get_ylim()
        ax.set_ylim(low, high + 0.35 * (high - low))
        legend = ax.legend(loc='upper right', ncol=3)
        for line in legend.get_lines():
            line.set(linewidth=1.5, alpha=1.0)
    axes[1].set_xlabel('measured depth [m]')
    axes[0].set_title('Direction of the drilled path')
    return save(figure, folder, 'inclination_and_azimuth')


def helix(job, folder):
    raw, corrected = job.raw_helix, job.corrected_helix
    last = raw.along > raw.along[-1] - 0.06
    figure, ((side, end), (far, swing)) = pyplot.subplots(2, 2, figsize=(10.0, 7.0))
    side.plot(1e3 * (raw.along[last] - raw.along[last][0]), 1e6 * raw.high[last], color=RAW, label='towards the high side')
    side.plot(1e3 * (raw.along[last] - raw.along[last][0]), 1e6 * raw.right[last], color=OURS, label='to the right')
    side.set_xlabel('along the hole [mm]')
    side.set_ylabel('off the axis [um]')
    side.set_title('raw path: a helix of pitch %.2f mm (%.2f by hand)' % (1e3 * raw.pitch, 1e3 * job.feed / job.rotary))
    room_above(side)
    end.plot(1e6 * raw.right[last], 1e6 * raw.high[last], color=RAW, linewidth=0.8, label='raw, radius %.0f um' % (1e6 * raw.radius))
    end.plot(1e6 * corrected.right[-60:], 1e6 * corrected.high[-60:], color=OURS, marker='.', linewidth=0.8, label='corrected nodes')
    end.set_xlabel('right [um]')
    end.set_ylabel('high [um]')
    end.set_title('the same, looking down the hole')
    end.set_aspect('equal', adjustable='datalim')
    end.legend(loc='upper right', framealpha=1.0)
    tail = corrected.along > corrected.along[-1] - 3.0
    far.plot(corrected.along[tail], 1e6 * corrected.high[tail], color=RAW, marker='.', label='towards the high side')
    far.plot(corrected.along[tail], 1e6 * corrected.right[tail], color=OURS, marker='.', label='to the right')
    far.set_xlabel('along the hole [m]')
    far.set_ylabel('off the axis [um]')
    far.set_title('corrected path: aliased long helix, pitch %.2f m (%.2f by aliasing)' % (corrected.pitch, job.aliased_pitch()))
    room_above(far)
    tangents, along = job.raw_tangents()
    mean = tangents.mean(axis=0)
    mean /= numpy.linalg.norm(mean)
    angle = numpy.degrees(numpy.arccos(numpy.clip(tangents @ mean, -1.0, 1.0)))
    recent = along > along[-1] - 0.5
    swing.plot(along[recent] - along[recent][0], angle[recent], color=RAW, linewidth=0.8)
    swing.axhspan(0.7, 1.3, color='0.85', zorder=0, label='expected: 0.7 to 1.3 deg')
    swing.set_xlabel('along the hole [m]')
    swing.set_ylabel('tangent off the axis [deg]')
    swing.set_ylim(bottom=0.0)
    swing.set_title('swing of the raw tangents: mean %.2f deg' % job.tangent_swing_deg())
    swing.legend(loc='lower right')
    return save(figure, folder, 'helix')


def figures_table(job, folder):
    """The figures side by side, as Markdown."""
    with open(os.path.join(folder, 'figures.md'), 'w') as out:
        out.write('| case | ours | expected | relative difference | bound | published |\n| --- | --- | --- | --- | --- | --- |\n')
        for check in job.checks():
            out.write('| ' + ' | '.join(check.cells() + [check.published or '-']) + ' |\n')
    return ['figures.md']


def draw(job, folder):
    """Draws everything into `folder`; returns the files' names."""
    names = []
    for picture in (loads, projections, directions, helix, figures_table):
        names += picture(job, folder)
    return names
