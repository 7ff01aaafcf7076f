# SPDX-License-Identifier: BSD-3-Clause
"""The assembly's rotary tendency: short runs of the main job's scene with one thing changed."""
import os
import subprocess

from job import Job

DEPTH = 740.0  # [m]
VARIANTS = [
    ('as in the scene', []),
    ('no side cutting (0.02 in the scene)', ['string[0].side_cutting=0']),
    ('side cutting 0.1, a bit that steers well', ['string[0].side_cutting=0.1']),
    ('no stabiliser blades (301.6 mm in the scene)', ['string[3].blade_diameter=0.2032']),
    ('stabiliser blades 311.2 mm, full gauge', ['string[3].blade_diameter=0.3112']),
    ('straight motor (bend 1.25 deg in the scene)', ['string[1].bend_deg=0']),
    ('no squeeze film (5e5 of the bit, 5e4 N s/m of the blades in the scene)', ['string[0].squeeze_film_damping=0', 'string[3].squeeze_film_damping=0']),
    ('wall ten times as stiff (5e7 N/m^1.5 in the scene, 2e10 under gauge and blades)', ['contact.stiffness=5e8', 'contact.assembly_stiffness=2e11']),
    ('wall as soft under gauge and blades as elsewhere', ['contact.assembly_stiffness=5e7']),
]
HEAD = ['variant', 'inclination: first metre [deg]', 'then [deg/30 m]', 'azimuth: first metre [deg]', 'then [deg/30 m]', 'WOB [kN]', 'torque [kN m]']


def drilled(drill, scene, settings, place, reuse):
    """The job with these settings of the scene, or None if the run failed."""
    summary = os.path.join(place, 'summary.json')
    if reuse and os.path.exists(summary) and os.path.getsize(summary) > 0:  # empty: the run was broken off
        return Job(scene, place)
    os.makedirs(place, exist_ok=True)
    command = [drill, 'run', scene, '--until-depth', str(DEPTH), '--csv', os.path.join(place, 'series.csv'),
               '--json', summary, '--path', os.path.join(place, 'path.csv'),
               '--raw-path', os.path.join(place, 'raw_path.csv'), '--set', 'numerics.companion=none']
    for setting in settings:
        command += ['--set', setting]
    return Job(scene, place) if subprocess.call(command, stdout=subprocess.DEVNULL) == 0 else None


def cells(job):
    """What is reported of a run: turn of the path, means and standard deviations while drilling."""
    if job is None:
        return ['the run failed'] + [''] * (len(HEAD) - 2)
    late = job.series['time'] > job.series['time'][-1] - 0.75 * (job.series['time'][-1] - 250.0)
    told = []
    for turn, rate in zip(job.first_turn(), job.drift_rates()):
        told += ['%+.2f' % turn, '%+.2f' % rate]
    for key in ('wob', 'torque'):
        values = job.series[key][late] / 1e3
        told.append('%.1f +- %.1f' % (values.mean(), values.std()))
    return told


def report(drill, scene, folder, reuse):
    """Writes tendency.md; returns its name. `reuse`: takes what earlier runs left."""
    lines = ['| ' + ' | '.join(HEAD) + ' |', '| ' + ' | '.join(['---'] * len(HEAD)) + ' |']
    for name, settings in VARIANTS:
        place = os.path.join(folder, 'tendency', ''.join(letter if letter.isalnum() else '_' for letter in name))
        lines.append('| %s | ' % name + ' | '.join(cells(drilled(drill, scene, settings, place, reuse))) + ' |')
        print(lines[-1], flush=True)
    with open(os.path.join(folder, 'tendency.md'), 'w') as out:
        out.write('\n'.join(lines) + '\n')
    return 'tendency.md'
