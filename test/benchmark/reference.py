# SPDX-License-Identifier: BSD-3-Clause
"""References: made by --full, kept in reference/ as NAME.csv.gz with NAME.json beside it: a hash of the scene's numbers and a fingerprint.

A reference is the finest run that can be had; its own error is what a tolerance ten times (or a step twice) as large, the interval twice as
long at whose ends friction's memory and the hole move on, and elements twice as long change in it, measured as the runs' errors are.
"""
import gzip
import hashlib
import io
import json
import os
from concurrent.futures import ThreadPoolExecutor

import numpy

import drill
import fingerprint
import measure

class Missing(Exception):
    """No reference, or one of another scene."""


class Stale(Exception):
    """References of a mechanics or of settings that are not today's; the message has a line for each."""


def settings(scene):
    return {'duration': scene.duration, 'every': scene.every}


def scene_hash(scene):
    return hashlib.sha256(json.dumps([scene.numbers(), settings(scene)], sort_keys=True).encode()).hexdigest()[:16]


def options(recipe):
    words = ['--level', 'beam3d', '--integrator', recipe['integrator'], '--step', repr(recipe['step']), '--element-length', repr(recipe['element_length'])]
    for key, value in recipe.get('set', {}).items():
        words += ['--set', '%s=%s' % (key, value)]
    return words


def recipes(scene, known):
    """What to try, best first: the reference and, for its own error, coarser ones by name."""
    out = []
    fine = scene.reference_length
    if 'ida' in known:
        base = {'integrator': 'ida', 'step': scene.reference_step, 'element_length': fine, 'set': {'numerics.reference_tolerance': scene.reference_tolerance}}
        out.append((base, {'tolerance': dict(base, set={'numerics.reference_tolerance': 10.0 * scene.reference_tolerance}),
                           'interval': dict(base, step=2.0 * scene.reference_step), 'element length': dict(base, element_length=2.0 * fine)}))
    for stand_in in ('trbdf2', 'bdf2'):
        if stand_in in known:
            base = {'integrator': stand_in, 'step': scene.reference_step, 'element_length': fine}
            out.append((base, {'step': dict(base, step=2.0 * scene.reference_step), 'element length': dict(base, element_length=2.0 * fine)}))
    return out


def make(program, scene, known, cpu_limit, say):
    """Makes a reference and its own error. Recipes that fail are said in it."""
    failed = {}
    for recipe, coarser in recipes(scene, known):
        name = '%s_%s' % (scene.name, recipe['integrator'])
        try:
            series, summary = program.run('reference_' + name, scene, options(recipe), cpu_limit)
        except drill.Failed as failure:
            failed[recipe['integrator']] = str(failure)
            say('%s: no reference by %s: %s' % (scene.name, recipe['integrator'], failure))
            continue
        own = {}
        for what, other in coarser.items():
            try:
                run, _ = program.run('reference_%s_%s' % (name, what.replace(' ', '_')), scene, options(other), cpu_limit)
                own[what] = measure.errors(run, series, scene)
            except drill.Failed as failure:
                own[what] = str(failure)
        return series, {'scene': scene.name, 'scene_hash': scene_hash(scene), 'recipe': recipe,
                        'fingerprint': fingerprint.take(program, scene, recipe['integrator']), 'own_error': own, 'failed': failed, 'cpu_s': summary['cpu_s'], 'nodes': summary['nodes'], 'steps': summary['steps']}
    raise Missing('%s: no method could make a reference: %s' % (scene.name, failed))


def own_error(note):
    """One number: the largest of the changes."""
    return max([error['all'] for error in note['own_error'].values() if isinstance(error, dict)], default=float('nan'))


def save(folder, scene, series, note):
    os.makedirs(folder, exist_ok=True)
    text = io.StringIO()
    text.write(','.join(measure.COLUMNS) + '\n')
    for row in zip(*(series[name] for name in measure.COLUMNS)):
        text.write(','.join('%.11g' % value for value in row) + '\n')
    with open(os.path.join(folder, scene.name + '.csv.gz'), 'wb') as out:
        with gzip.GzipFile(fileobj=out, mode='wb', mtime=0, filename='') as packed:  # equal data, equal file
            packed.write(text.getvalue().encode())
    write_note(folder, scene, note)


def read_note(folder, scene):
    with open(os.path.join(folder, scene.name + '.json')) as file:
        return json.load(file)


def write_note(folder, scene, note):
    with open(os.path.join(folder, scene.name + '.json'), 'w') as out:
        json.dump(note, out, indent=1, sort_keys=True)
        out.write('\n')


def load(folder, scene):
    """The reference and its note. Raises Missing where there is none for this scene, Stale where it would be made otherwise today."""
    try:
        note = read_note(folder, scene)
        with gzip.open(os.path.join(folder, scene.name + '.csv.gz'), 'rt') as file:
            names = file.readline().strip().split(',')
            table = numpy.loadtxt(file, delimiter=',')
    except (OSError, ValueError) as problem:
        raise Missing('%s: no reference: %s; make it with --full' % (scene.name, problem))
    if note['scene_hash'] != scene_hash(scene):
        raise Missing('%s: the scene has changed since its reference was made; make it again with --full' % scene.name)
    if note['recipe'] not in [recipe for recipe, _ in recipes(scene, (note['recipe']['integrator'],))]:
        raise Stale('%s: its reference is stale: it was not made with the step, element length and tolerance of today\'s scenes.py; %s'
                    % (scene.name, fingerprint.renewal(scene)))
    return dict(zip(names, table.T)), note


def check(program, made, jobs):
    """`made`: reference and note by scene. Raises Stale for those that would come out otherwise today."""
    def one(item):
        scene, (_, note) = item
        return fingerprint.complaint(scene, fingerprint.take(program, scene, note['recipe']['integrator']), note.get('fingerprint'))
    with ThreadPoolExecutor(jobs) as pool:
        complaints = [complaint for complaint in pool.map(one, made.items()) if complaint]
    if complaints:
        raise Stale('\n'.join(complaints))


def record_fingerprint(program, folder, scene):
    """Beside a reference that is known to be what --full would make today: the fingerprint and the scene's hash anew."""
    note = read_note(folder, scene)
    note.update(scene_hash=scene_hash(scene), fingerprint=fingerprint.take(program, scene, note['recipe']['integrator']))
    write_note(folder, scene, note)
