# SPDX-License-Identifier: BSD-3-Clause
"""The field case: pick-up, slack-off and rotating weights of a well at 26 depths (../shared/data/field_torque_and_drag).

Three numbers are calibrated on the upper half of the depths by least squares: the tare (all that hangs above the rotary table), the friction
of casing and that of open hole. With them the lower half is predicted, by `drill static` and by the soft string of soft_string.py.
"""
import concurrent.futures
import csv
import json
import os
import re
import subprocess

import numpy
import yaml

from job import Check
from soft_string import GRAVITY, Hole, SoftString

SOURCE = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
DATA = os.path.join(SOURCE, '../shared/data/field_torque_and_drag')
INCH, FOOT, POUND = 0.0254, 0.3048, 0.45359237
KLBF = 1000.0 * POUND * GRAVITY  # [N]
PER_FOOT = POUND / FOOT  # lb/ft in kg/m
STEEL = 7850.0
MUD = 9.0 * POUND / (231.0 * INCH ** 3)  # 9.0 ppg [kg/m3]
MOTIONS = (('pick-up', 'up', 1, 'PickUp_Klbs'), ('slack-off', 'down', -1, 'Slackoff_Klbs'), ('rotating', 'rotate', 0, 'Rotating_Klbs'))
COLLAR = 154.0  # of 8 in x 3 in collars; the file's 1267 is a slip [lb/ft]
PIPES = {  # mass of the drill pipe [lb/ft]
    'as listed': 19.5,
    'with its tool joints': 20.85,  # 19.50 is a nominal weight; API RP 7G, grade E with NC50 of 6 3/8 in x 3 3/4 in
}
GOAL = 3.0  # rms of the lower half [klbf]
BESIDE = 0.5  # how much worse than the soft string it may be [klbf]
BLOCK_HEIGHT = 1.0  # pipe above the table, taken off again [m]


def table(name):
    with open(os.path.join(DATA, name), encoding='utf-8-sig') as text:
        return list(csv.DictReader(text))


class Field:
    """The data in SI."""

    def __init__(self):
        rows = table('ActualTnD.csv')
        self.feet = [float(row['MD_ft']) for row in rows]
        self.depths = [FOOT * feet for feet in self.feet]
        self.measured = numpy.array([[float(row[motion[3]]) for motion in MOTIONS] for row in rows]) * KLBF
        self.half = len(rows) // 2
        self.stations = [[float(row['MD_ft']) * FOOT, float(row['Incl_deg']), float(row['Azi_deg'])] for row in table('survey_b7cd4f7.csv')]
        self.stations.append([self.stations[-1][0] + 10.0] + self.stations[-1][1:])  # the bit hangs free at the last depth too
        casing, open_hole = table('borehole.csv')
        self.shoe = float(casing['Bottom_MD_ft']) * FOOT
        self.diameters = [float(casing['Casing_ID_in']) * INCH, float(open_hole['Hole_ID_in']) * INCH]
        self.parts = [{key: float(row[name]) * unit for key, name, unit in (
            ('outer', 'OD_in', INCH), ('inner', 'ID_in', INCH), ('length', 'Length_ft', FOOT), ('mass', 'Weight_lbft', PER_FOOT))}
            for row in table('bha_components.csv')]
        self.parts[0]['mass'] = COLLAR * PER_FOOT

    def masses(self, pipe):
        return [part['mass'] for part in self.parts[:-1]] + [pipe * PER_FOOT]

    def scene(self, pipe):
        """The bit is the lowest foot of the collars. The data say nothing of joints: NC50 of 6 3/8 in, heavyweight pipe 6 1/2 in."""
        collar, heavy, drill = self.masses(pipe)

        def part(k, name, kind, joints, joint_length, mass, **more):
            return dict({'name': name, 'type': kind, 'joints': joints, 'joint_length': joint_length, 'outer_diameter': self.parts[k]['outer'],
                         'inner_diameter': self.parts[k]['inner'], 'linear_mass': mass}, **more)
        string = [{'name': 'bit', 'type': 'bit', 'length': FOOT, 'mass': FOOT * collar, 'diameter': self.diameters[1]},
                  part(0, 'collar', 'collar', 2, 0.5 * (self.parts[0]['length'] - FOOT), collar),
                  part(1, 'hwdp', 'pipe', 33, self.parts[1]['length'] / 33.0, heavy, tool_joint_diameter=6.5 * INCH),
                  part(2, 'drill_pipe', 'pipe', 'fill', 9.5, drill, tool_joint_diameter=6.375 * INCH)]
        sections = [{'to': end, 'diameter': diameter, 'friction': 0.2}
                    for end, diameter in zip((self.shoe, self.stations[-1][0]), self.diameters)]
        return {'name': 'field', 'well': {'stations': self.stations, 'sections': sections},
                'formation': [{'to_tvd': 10000.0, 'drillability': 1.0e-8}], 'mud': {'density': MUD}, 'string': string,
                'start': {'bit_depth': self.depths[-1], 'block_height': BLOCK_HEIGHT}}


class Soft:
    name = 'soft string'
    failed = ()

    def __init__(self, field, pipe):
        self.shoe = field.shoe
        hole = Hole(field.stations)
        parts = list(zip([part['length'] for part in field.parts], field.masses(pipe)))
        self.strings = {depth: SoftString(hole, parts, depth, 1.0 - MUD / STEEL) for depth in field.depths}

    def loads(self, depths, friction):
        """Of the string, a row a depth, a column a motion [N]. `friction`: (cased, open)."""
        return numpy.array([[self.strings[depth].hook_load(lambda md: friction[0] if md < self.shoe else friction[1], sense)
                             for _, _, sense, _ in MOTIONS] for depth in depths])


class Ours:
    name = 'drill_rig_sim'

    def __init__(self, drill, scene, place):
        self.drill, self.place = drill, place
        self.in_air = GRAVITY * scene['string'][-1]['linear_mass'] * BLOCK_HEIGHT
        self.failed = []  # what was asked for where there was no answer
        with open(place, 'w') as out:
            yaml.safe_dump(scene, out)

    def load(self, depth, motion, friction):
        command = [self.drill, 'static', self.place, '--motion', motion, '--set', 'start.bit_depth=%r' % depth]
        for k in (0, 1):
            command += ['--set', 'well.sections[%d].friction=%r' % (k, float(friction[k]))]
        done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, universal_newlines=True)
        if done.returncode == 3:  # no equilibrium
            self.failed.append('%s at %.0f ft, friction %.3f and %.3f: %s' % (motion, depth / FOOT, *friction, done.stderr.strip()))
            return numpy.nan
        if done.returncode != 0:
            raise RuntimeError(' '.join(command) + ': ' + done.stderr.strip())
        return float(re.search(r'of the string +(\S+) N', done.stdout).group(1)) - self.in_air

    def loads(self, depths, friction):
        """As of Soft; not a number where the statics fail."""
        wanted = [(depth, motion, friction) for depth in depths for _, motion, _, _ in MOTIONS]
        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            return numpy.array(list(pool.map(lambda ask: self.load(*ask), wanted))).reshape(-1, len(MOTIONS))


def calibrate(loads, measured):
    """Tare [N] and frictions (cased, open), and the standard errors of the three, by Gauss and Newton on what `loads(friction)` says."""
    friction, step = numpy.array([0.2, 0.3]), 0.01
    for _ in range(15):
        base = loads(friction)
        slopes = [((loads(friction + step * one) - base) / step).ravel() for one in numpy.eye(2)]
        matrix, rest = numpy.stack([numpy.ones(base.size)] + slopes, axis=1), (measured - base).ravel()
        known = numpy.isfinite(matrix.sum(axis=1) + rest)
        matrix, rest = matrix[known], rest[known]
        solution = numpy.linalg.lstsq(matrix, rest, rcond=None)[0]
        change = numpy.maximum(friction + solution[1:], 0.0) - friction
        friction = friction + change
        if numpy.abs(change).max() < 1e-4:
            scatter = numpy.sum((rest - matrix @ solution) ** 2) / (len(rest) - 3)
            return solution[0], friction, numpy.sqrt(scatter * numpy.diag(numpy.linalg.inv(matrix.T @ matrix)))
    raise RuntimeError('the field case: no best friction found, last %s' % friction)


def rms(values):
    return float(numpy.sqrt(numpy.nanmean(numpy.square(values))))


def judge(model, pipe, field):
    """What is reported of a model: calibrated on the upper half, and for comparison on all depths."""
    upper, lower = slice(0, field.half), slice(field.half, None)
    tare, friction, errors = calibrate(lambda f: model.loads(field.depths[upper], f), field.measured[upper])
    loads = model.loads(field.depths, friction) + tare
    off = (loads - field.measured) / KLBF
    whole_tare, whole, _ = calibrate(lambda f: model.loads(field.depths, f), field.measured)
    whole_off = (model.loads(field.depths, whole) + whole_tare - field.measured) / KLBF
    return {'pipe': pipe, 'model': model.name, 'tare': tare / KLBF, 'friction': list(friction), 'errors': [errors[0] / KLBF] + list(errors[1:]),
            'loads': (loads / KLBF).tolist(), 'upper': rms(off[upper]), 'lower': rms(off[lower]),
            'motions': [rms(off[lower, k]) for k in range(len(MOTIONS))], 'whole': {
                'tare': whole_tare / KLBF, 'friction': list(whole), 'all': rms(whole_off), 'lower': rms(whole_off[lower])},
            'solved': int(numpy.isfinite(loads).sum()), 'failed': list(model.failed)}


def work_out(drill, folder):
    """All models with both weights of the pipe."""
    field = Field()
    results = []
    for name, pipe in PIPES.items():
        place = os.path.join(folder, 'field_%s.yaml' % name.replace(' ', '_'))
        for model in (Ours(drill, field.scene(pipe), place), Soft(field, pipe)):
            results.append(judge(model, name, field))
    return {'feet': field.feet, 'half': field.half, 'measured': (field.measured / KLBF).tolist(), 'results': results}


def write(told, folder):
    """field.md for README.md here."""
    head = ['drill pipe', 'model', 'tare [klbf]', 'friction cased', 'open hole', 'rms of the upper half, calibrated [klbf]',
            'of the lower half, predicted'] + [motion[0] for motion in MOTIONS] + ['within %g' % GOAL, 'if all depths calibrate: lower half']
    with open(os.path.join(folder, 'field.md'), 'w') as out:
        out.write('| %s |\n|%s\n' % (' | '.join(head), ' --- |' * len(head)))
        for row in told['results']:
            cells = ['%s, %g lb/ft' % (row['pipe'], PIPES[row['pipe']]), row['model'], '%.1f +- %.1f' % (row['tare'], row['errors'][0])]
            cells += ['%.2f +- %.2f' % (row['friction'][k], row['errors'][k + 1]) for k in (0, 1)]
            cells += ['%.2f' % value for value in [row['upper'], row['lower']] + row['motions']]
            cells += ['yes' if row['lower'] <= GOAL else '**no**', '%.2f' % row['whole']['lower']]
            out.write('| ' + ' | '.join(cells) + ' |\n')
    return ['field.md']


def checks(told):
    """Ours beside the soft string: the data judge both alike, so what is ours alone to answer for is the difference."""
    out = []
    for ours, soft in zip(told['results'][::2], told['results'][1::2]):
        name = 'field case, pipe %s' % ours['pipe']
        out.append(Check(name + ': lower half, rms beside the soft string\'s', 'klbf', ours['lower'], soft['lower'], BESIDE))
        out.append(Check(name + ': statics that are solved', '', ours['solved'], numpy.size(told['measured']), 0.0))
    return out


def draw(told, folder):
    """field_case.svg and .png: measured and predicted weights, and what is left, for each weight of the pipe."""
    from figures import OURS, RAW, SEED, pyplot, save
    depth, measured = numpy.array(told['feet']), numpy.array(told['measured'])
    figure, panels = pyplot.subplots(1, 1 + len(PIPES), figsize=(13.0, 5.5), sharey=True)
    border = 0.5 * (depth[told['half'] - 1] + depth[told['half']])
    for row in told['results']:
        style = '-' if row['model'] == Ours.name else '--'
        loads = numpy.array(row['loads'])
        rest = panels[1 + list(PIPES).index(row['pipe'])]
        for k, color in enumerate((SEED, OURS, RAW)):
            if row['pipe'] == next(iter(PIPES)):
                panels[0].plot(loads[:, k], depth, style, color=color, linewidth=1.0, label='%s, %s' % (MOTIONS[k][0], row['model']))
            rest.plot(loads[:, k] - measured[:, k], depth, style, color=color, linewidth=1.0)
        rest.set_title('predicted - measured, pipe %s' % row['pipe'])
    for k, color in enumerate((SEED, OURS, RAW)):
        panels[0].plot(measured[:, k], depth, 'o', color=color, markersize=3.0)
    for axes in panels:
        axes.axhspan(depth[0], border, color='0.9', zorder=0)
        axes.set_xlabel('[klbf]')
    for axes in panels[1:]:
        axes.axvspan(-GOAL, GOAL, color='0.6', alpha=0.25, zorder=0)
        axes.set_xlim(-13.0, 13.0)
    panels[0].invert_yaxis()
    panels[0].set_ylabel('depth of the bit [ft]; grey: calibrated')
    panels[0].set_title('hook load, pipe %s; dots: measured' % next(iter(PIPES)))
    panels[0].legend(loc='lower left', fontsize=7)
    return save(figure, folder, 'field_case')


def run(drill, folder, reuse, pictures, names):
    """0: the checks hold, 1: one does not, 77: there is no data. Adds what it wrote to `names`."""
    if not os.path.isdir(DATA):
        print('field case, skipped: ../shared/data is absent')
        return 77
    place = os.path.join(folder, 'field.json')
    if not reuse:
        with open(place, 'w') as out:
            json.dump(work_out(drill, folder), out, indent=1)
    with open(place) as text:
        told = json.load(text)
    names += write(told, folder)
    if pictures:
        names += draw(told, folder)
    for row in told['results']:
        print('field case, pipe %s, %s: tare %.2f klbf, friction %.3f cased, %.3f open, rms %.2f klbf in the upper half, %.2f predicted in the '
              'lower' % (row['pipe'], row['model'], row['tare'], *row['friction'], row['upper'], row['lower']))
        for line in row['failed']:
            print('  failed: ' + line)
    judged = checks(told)
    print('case, ours, expected, relative difference, bound')
    for check in judged:
        print(check)
    return 0 if all(check.holds for check in judged) else 1
