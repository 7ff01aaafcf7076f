"""What tells that a reference is stale: a short run of its scene, recorded with it, and run again each time.

Stale is a reference whose scene would come out otherwise today, however the sources are spelled. The run is by the reference's own method with
a tight tolerance on the coarsest mesh, for the scene's first seconds. Measured with 2 s by ida at 1e-7: other rounding (a scene's number changed in
its twelfth digit) changes no output by more than 4e-5 of its scale, 1 % more of stiffness, damping or friction some by 3e-4 or more.
"""
import numpy

import measure

DURATION = 2.0     # [s]
EVERY = 0.1        # [s]
STEP = 0.005       # [s]
TOLERANCE = 1e-7   # of ida
ALLOWED = 2e-4     # of an output's scale in the recorded run
DIGITS = 9


def options(scene, integrator):
    words = ['--duration', repr(min(DURATION, scene.duration)), '--every', repr(EVERY), '--integrator', integrator, '--step', repr(STEP),
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


def complaint(scene, now, recorded):
    """None, or why the reference cannot be used and what to do."""
    renew = 'make it again with ./test/benchmark/run --full --scene %s' % scene.name
    if recorded is None:
        return '%s: its reference has no fingerprint; %s' % (scene.name, renew)
    output, much = difference(now, recorded)
    if much <= ALLOWED:
        return None
    return ('%s: its reference is stale: %s of its first %g s now differs by %.1e of its scale from what was recorded with it, %.0e is allowed; %s'
            % (scene.name, output, min(DURATION, scene.duration), much, ALLOWED, renew))
