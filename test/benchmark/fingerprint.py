# SPDX-License-Identifier: BSD-3-Clause
"""What tells that a reference is stale: a short run of its scene, recorded with it, and run again each time.

Stale is a reference whose scene would come out otherwise today, however the sources are spelled. The run is by the reference's own method with
a tight tolerance on the coarsest mesh, until past the event that the scene is about, and by the scalar kernel, which rounds alike on every
machine. Measured by ida at 1e-7: other rounding (the mud's density changed in its eleventh or twelfth digit) changes no output by more than 6e-5
of its scale, but of sliding, whose bit starts from rest, by 1e-2; 1 % more of stiffness, damping or friction changes some by 3e-4 or more within
2 s.
"""
import numpy

import measure

EVERY = 0.1        # [s]
STEP = 0.005       # [s]
TOLERANCE = 1e-7   # of ida
ALLOWED = 2e-4     # of an output's scale in the recorded run
DIGITS = 9


def seconds(scene):
    return min(scene.fingerprint_until, scene.duration)


def options(scene, integrator):
    words = ['--set', 'numerics.kernel=scalar', '--duration', repr(seconds(scene)), '--every', repr(EVERY), '--level', 'beam3d', '--integrator', integrator, '--step', repr(STEP),
             '--element-length', repr(max(scene.lengths))]
    return words + (['--set', 'numerics.reference_tolerance=%g' % TOLERANCE] if integrator == 'ida' else [])


def take(program, scene, integrator):
    """Columns by name, each as a line of numbers."""
    series, _ = program.run('fingerprint_' + scene.name, scene, options(scene, integrator))
    return {name: ' '.join('%.*g' % (DIGITS, value) for value in column) for name, column in series.items()}


def difference(now, recorded):
    """The output that differs most, and by how much of its scale; what cannot be compared differs by infinity."""
    now, recorded = ({name: numpy.array(line.split(), float) for name, line in series.items()} for series in (now, recorded))
    if now.keys() != recorded.keys() or any(len(now[name]) != len(recorded[name]) for name in now):
        return 'number of samples', float('inf')
    worst = {output: float(numpy.max(numpy.linalg.norm(measure.values(now, output) - measure.values(recorded, output), axis=1))
                           / measure.scale(recorded, output)) for output in measure.OUTPUTS}
    name = max(worst, key=lambda output: worst[output] if worst[output] == worst[output] else float('inf'))
    return name, worst[name]


def renewal(scene):
    """What to do about a stale reference."""
    return 'make it again with ./test/benchmark/run --full --scene %s' % scene.name


def complaint(scene, now, recorded):
    """None, or why the reference cannot be used and what to do."""
    if recorded is None:
        return '%s: its reference has no fingerprint; %s' % (scene.name, renewal(scene))
    covered = float(recorded['time'].split()[-1])
    if abs(covered - seconds(scene)) > 1e-6:
        return '%s: its reference is stale: its fingerprint covers %g s, now %g s are wanted; %s' % (scene.name, covered, seconds(scene), renewal(scene))
    output, much = difference(now, recorded)
    if much <= ALLOWED:
        return None
    return ('%s: its reference is stale: %s of its first %g s now differs by %.1e of its scale from what was recorded with it, %.0e is allowed; %s'
            % (scene.name, output, seconds(scene), much, ALLOWED, renewal(scene)))
