# SPDX-License-Identifier: BSD-3-Clause
"""The points of the charts: method x step x element length, levels and variable steps, each run once."""
import csv
import json
from concurrent.futures import ThreadPoolExecutor

import drill
import measure
import scenes

# tried beside the scene's numerics.newton_tolerance, of the methods that iterate [m, rad]
ITERATED = ('bdf2', 'implicit_euler', 'trbdf2', 'generalised_alpha')
LOOSE_NEWTON = 1e-4
LOOSEST_NEWTON = 1e-3
TIGHT_NEWTON = 1e-8
REFERENCE_METHOD = 'ida'
MESH_BY_THE_HOLE = 0.0  # numerics.element_length: the program chooses
LOOSE_REFERENCE = (1e-4, 1e-3)  # numerics.reference_tolerance of the method that chooses its own steps
BEAM, HYBRID, AXIAL, AUTO = 'beam3d', 'hybrid', 'axial_torsional', 'auto'  # numerics.level
CHEAP_LEVELS = (HYBRID, AXIAL)
VARIABLE = 0.0  # numerics.step: as numerics.tolerance allows
VARIABLE_METHOD = 'bdf2'
TOLERANCES = (0.05, 0.02, 0.01, 0.005, 0.002)  # of variable steps
DEFAULT_TOLERANCE = 0.02  # numerics.tolerance
AUTO_TOLERANCES = (0.05, 0.01, 0.002)  # beside it
LEAST_ON_JOINTS = 0.01  # below it an element a joint is the error
FIELDS = ('scene', 'level', 'method', 'element', 'step', 'element_length', 'newton_tolerance', 'tolerance', 'default', 'error', 'cpu_s_per_s', 'work_per_s', 'nodes', 'guided_nodes', 'steps', 'residuals',
          'tangents', 'solves', 'substitutions', 'newton_iterations', 'rejected_steps', 'warned') + tuple('error_' + o for o in measure.OUTPUTS) + ('error_period', 'failure')


def mesh(length):
    return 'mesh by the hole' if length == MESH_BY_THE_HOLE else '%g m' % length


def percent(share):
    """Two digits."""
    return '%.2g %%' % (100.0 * share)


class Point:
    def __init__(self, scene, method, element, step, length, default=False, newton=None, tolerance=None, level=BEAM):
        self.scene = scene
        self.method = method
        self.element = element
        self.step = step
        self.length = length
        self.default = default
        self.newton = newton  # numerics.newton_tolerance; None: the scene's
        self.tolerance = tolerance  # numerics.tolerance of variable steps, numerics.reference_tolerance of others; None: the scene's
        self.level = level
        self.errors = None    # by output; None: the run failed
        self.failure = ''
        self.coarse = False   # a mesh of fewer nodes than the default's here, or a level that is right in some holes only: see mark_coarse()
        self.summary = {}
        self.cpu = self.work = float('nan')  # per simulated second: [s], [instructions]

    @property
    def name(self):
        words = (self.scene.name, self.method, self.element, '%g' % self.step, '%g' % self.length) + ((self.level,) if self.level != BEAM else ())
        return '_'.join(words + (('newton_%g' % self.newton,) if self.newton else ()) + (('tolerance_%g' % self.tolerance,) if self.tolerance else ()))

    @property
    def error(self):
        return self.errors['all'] if self.errors else float('nan')

    @property
    def counted(self):
        """Whether its counted work is its work. The reference's method is left out: of its work much is counted nowhere (factorisations,
        a larger system), while it is charged with solves that it does not make."""
        return bool(self.errors) and self.method != REFERENCE_METHOD

    @property
    def competes(self):
        """Whether the verdict compares the default with it. A mesh coarser than the default's and a level of guided pipe do not: they could not be
        the default, for in other holes they are wrong (the operations matrix and its variants, test/accuracy/README.md). Level auto does."""
        return self.counted and not self.coarse

    @property
    def warned(self):
        """Whether the run itself said that its figures are in doubt."""
        return bool(self.summary.get('accuracy_warnings'))

    def options(self):
        if self.default:
            return []
        words = ['--level', self.level, '--integrator', self.method, '--step', repr(self.step), '--element-length', repr(self.length)]
        if self.element != drill.ELEMENTS[0]:
            words += ['--set', 'numerics.element=' + self.element]
        if self.newton:
            words += ['--set', 'numerics.newton_tolerance=%g' % self.newton]
        if self.tolerance:
            words += ['--set', 'numerics.%s=%g' % ('tolerance' if self.step == VARIABLE else 'reference_tolerance', self.tolerance)]
        if self.step > self.scene.every:
            words += ['--every', repr(self.step)]
        return words

    def label(self):
        if self.level == AUTO:
            return 'auto to %g' % self.tolerance
        words = [] if self.level == BEAM else [self.level]
        if self.step == VARIABLE:
            words.append('variable steps to %g' % self.tolerance)
        else:
            words += [self.method, '%g ms' % (1e3 * self.step)]
        words.append(mesh(self.length))
        if self.element != drill.ELEMENTS[0]:
            words.append(self.element)
        if self.newton:
            words.append('Newton to %g' % self.newton)
        if self.tolerance and self.step != VARIABLE:
            words.append('tolerance %g' % self.tolerance)
        return ', '.join(words)

    def compute(self, program, reference, weights):
        """Runs it; a failure is kept, not raised."""
        try:
            series, self.summary = program.run(self.name + ('_default' if self.default else ''), self.scene, self.options())
            self.errors = measure.errors(series, reference, self.scene)
        except (drill.Failed, ValueError) as failure:
            self.failure = str(failure)
            return self
        simulated = self.summary['simulated_s']
        self.cpu = self.summary['cpu_s'] / simulated
        self.work = weights.of(self.element, self.summary) / simulated
        return self

    def row(self):
        values = {'scene': self.scene.name, 'level': self.level, 'method': self.method, 'element': self.element, 'step': self.step,
                  'element_length': self.length, 'newton_tolerance': self.newton or '', 'tolerance': self.tolerance or '', 'default': int(self.default),
                  'error': self.error, 'cpu_s_per_s': self.cpu, 'work_per_s': self.work, 'warned': int(self.warned), 'failure': self.failure}
        values.update({field: self.summary[field] for field in FIELDS if field not in values and field in self.summary})
        values.update({'error_' + output: error for output, error in (self.errors or {}).items() if output != 'all'})
        return ['%.6g' % values[field] if isinstance(values.get(field), float) else values.get(field, '') for field in FIELDS]


def grid(scene, methods, elements, default_method, default_step, default_length):
    """The default, level auto. Every method x step x element length with the default's element; with the default's method also the other elements; and
    settings coarser and finer than the default's by fixed steps: longer and shorter ones are among the scene's."""
    out = [Point(scene, default_method, drill.ELEMENTS[0], VARIABLE, default_length, default=True, tolerance=DEFAULT_TOLERANCE, level=AUTO)]
    for element in elements:
        for method in methods if element == drill.ELEMENTS[0] else [default_method]:
            for length in scene.lengths_of(method):
                out += [Point(scene, method, element, step, length) for step in scene.steps_of(method)]
    out += coarser_and_finer(scene, methods, default_method, default_step, default_length)
    return out + levels(scene, default_length) if VARIABLE_METHOD in methods else out


def coarser_and_finer(scene, methods, default_method, default_step, default_length):
    """The default's mesh with other methods; ends of Newton's iteration, of the default's method and of the others; finer meshes; loose tolerances of the reference's method."""
    def point(method, step, length=default_length, **tolerances):
        return Point(scene, method, drill.ELEMENTS[0], step, length, **tolerances)
    coarse_steps = [step for step in scene.steps if step >= default_step]
    near_steps = [step for step in scene.steps if step >= 0.5 * default_step]
    out = []
    if default_length not in scene.lengths:
        out += [point(method, step) for method in methods if method in ITERATED for step in near_steps]
    out += [point(default_method, step, newton=LOOSE_NEWTON) for step in scene.steps]
    out += [point(default_method, step, newton=LOOSEST_NEWTON) for step in coarse_steps]
    out.append(point(default_method, default_step, newton=TIGHT_NEWTON))
    out += [point(method, step, newton=LOOSE_NEWTON) for method in methods if method in ITERATED and method != default_method for step in coarse_steps]
    if scene.reference_length < scenes.FINE_LENGTH and scenes.FINE_LENGTH not in scene.lengths:
        out += [point(default_method, step, scenes.FINE_LENGTH) for step in near_steps]
    if REFERENCE_METHOD in methods:
        out += [point(REFERENCE_METHOD, step, tolerance=tolerance) for step in scenes.REFERENCE_STEPS for tolerance in LOOSE_REFERENCE]
    return out


def levels(scene, default_length):
    """Variable steps, of the full string and of the cheap levels; these with fixed steps too; and level auto, which chooses all by itself."""
    def point(level, length, step=VARIABLE, tolerance=None):
        return Point(scene, VARIABLE_METHOD, drill.ELEMENTS[0], step, length, tolerance=tolerance, level=level)
    out = [point(level, default_length, tolerance=tolerance) for level in (BEAM,) + CHEAP_LEVELS for tolerance in TOLERANCES]
    if default_length == MESH_BY_THE_HOLE:
        out += [point(level, scenes.LENGTHS[0], tolerance=tolerance) for level in (BEAM, HYBRID) for tolerance in TOLERANCES if tolerance >= LEAST_ON_JOINTS]
    out += [point(level, default_length, step) for level in CHEAP_LEVELS for step in scene.steps]
    return out + [point(AUTO, default_length, tolerance=tolerance) for tolerance in AUTO_TOLERANCES]


def mark_coarse(points):
    """Of one scene's points, computed. What auto chooses is up to it."""
    default = next(p for p in points if p.default)
    for p in points:
        p.coarse = p.level in CHEAP_LEVELS or p.level != AUTO and p.summary.get('nodes', 0) < default.summary.get('nodes', 0)


def compute(all_points, program, references, weights, jobs, say):
    """Runs the points, `jobs` at a time, dear ones first so that the last ones to end are short."""
    ordered = sorted(all_points, key=lambda p: p.step * p.length / p.scene.duration)
    done = 0
    with ThreadPoolExecutor(jobs) as pool:
        for point in pool.map(lambda p: p.compute(program, references[p.scene.name], weights), ordered):
            done += 1
            if done % 25 == 0 or done == len(ordered):
                say('%d of %d points' % (done, len(ordered)))
            if point.failure:
                say('%s: %s: failed: %s' % (point.scene.name, point.label(), point.failure))


def write_csv(path, all_points):
    with open(path, 'w', newline='') as out:
        writer = csv.writer(out)
        writer.writerow(FIELDS)
        for point in all_points:
            writer.writerow(point.row())


def write_machine(path, machine):
    with open(path, 'w') as out:
        json.dump(machine, out, indent=2)
        out.write('\n')
