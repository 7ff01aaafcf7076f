# SPDX-License-Identifier: BSD-3-Clause
"""The benchmark's scenes: what is run, how its error is measured, and what is known of it.

Where a scene bifurcates (stick-slip, bounce, whirl, buckling) two exact solutions part from one another exponentially: from `trace_until`
on, mean, deviation, extrema and period are compared, not the time series.
"""
import os

import yaml

HERE = os.path.dirname(os.path.abspath(__file__))
STEPS = (0.04, 0.02, 0.01, 0.005, 0.0025, 0.00125)  # [s]
SHORT_STEPS = (4e-4, 2e-4)              # of a method that is stable at short steps only [s]
REFERENCE_STEPS = (0.005,)                    # of a method that chooses its own: at their ends friction's memory and the hole move on [s]
LENGTHS = (9.5, 4.75)                         # longest element [m]; a joint of pipe is 9.3 to 9.5 m, an element no longer
FINE_LENGTH = 2.375                           # of the default's method beside those [m]


class Scene:
    def __init__(self, name, title, duration, trace_until=None, period_of=None, every=0.02, steps=STEPS, lengths=LENGTHS,
                 reference_length=1.1875, reference_step=6.25e-4, reference_tolerance=1e-7, fingerprint_until=2.0,
                 largest_error=None, why_so_large=''):
        self.name = name
        self.title = title
        self.duration = duration          # [s]
        self.trace_until = duration if trace_until is None else trace_until  # time series compared up to here, statistics after [s]
        self.period_of = period_of        # output whose period is compared; None: the scene has none
        self.every = every                # samples [s]; every step divides it
        self.steps = steps
        self.lengths = lengths
        self.reference_length = reference_length
        self.reference_step = reference_step          # [s]
        self.reference_tolerance = reference_tolerance
        self.fingerprint_until = fingerprint_until  # what tells that the reference is stale goes on past the event that the scene is about [s]
        self.largest_error = largest_error  # that the default may have here; None: none is judged
        self.why_so_large = why_so_large  # what makes the default's error, so that this is the limit

    @property
    def path(self):
        return os.path.join(HERE, 'scenes', self.name + '.yaml')

    def steps_of(self, method):
        return {'explicit': SHORT_STEPS, 'ida': REFERENCE_STEPS}.get(method, self.steps)

    def lengths_of(self, method):
        return self.lengths[:1] if method == 'ida' else self.lengths

    def numbers(self):
        """What the scene's file and its survey say, without how they say it: what the reference was made of."""
        with open(self.path) as file:
            content = yaml.safe_load(file)
        survey = content.get('well', {}).get('survey')
        if not survey:
            return [content]
        with open(os.path.join(os.path.dirname(self.path), survey)) as file:
            rows = [line.strip() for line in file if line.strip() and not line.startswith('#')]
        return [content, rows]


ALL = (
    Scene('axial_wave', 'axial wave after a winch step', 3.0, reference_length=4.75,
          largest_error=0.01, why_so_large='steps for a tolerance of 0.02 damp the quicker waves'),
    Scene('torque_release', 'torque wind-up and release', 6.0, fingerprint_until=4.5,  # let go at 4 s
          largest_error=0.08, why_so_large='pipe that quivers between its walls moves the inclination by 0.02 deg, the hook load by 0.1 kN: ranges here are hardly more'),
    Scene('build_trip', 'picking up and slacking off through a build', 4.6, fingerprint_until=3.0,  # goes down from 2.5 s on
          largest_error=0.03, why_so_large='friction that turns round joint by joint: the reference is sure to 0.01 only'),
    Scene('drilling', 'drilling on bottom', 60.0, trace_until=4.0, period_of='bit_inclination', every=0.1, steps=(0.05,) + STEPS[1:5],
          reference_tolerance=1e-6, fingerprint_until=12.5,  # leaves a node of hole after 0.1 m, at 11 s
          largest_error=0.03, why_so_large='small vibrations of the hook load, for which the elements are too long'),
    Scene('stick_slip', 'stick-slip in a 3 km vertical well', 18.0, trace_until=8.0, period_of='bit_speed', steps=STEPS[:5],
          reference_length=4.75, fingerprint_until=5.0,  # the bit lets go at 3.4 s
          largest_error=0.002, why_so_large='torsional waves are long and slow: mesh and step are fine for them'),
    Scene('tagging', 'bit bounce on tagging at 0.3 m/s', 3.0, trace_until=1.5, reference_length=4.75,
          largest_error=0.006, why_so_large='steel hardly damps the waves of an impact, and the steps between impacts blur them'),
    Scene('buckling', 'helical buckling under slack-off', 5.0, trace_until=2.0, lengths=(9.5, 4.75, 2.375),
          largest_error=0.04, why_so_large='half joints bend less easily than the helix of slim pipe; quarters are within the own error of the reference'),
    Scene('sliding', 'sliding with the bent motor', 15.0,
          largest_error=0.02, why_so_large='friction holds the string and the feed is slow: what is left is the mesh'),
)
# what --fast runs: cheap, one smooth and one with impacts
FAST = (
    Scene('axial_wave', 'axial wave after a winch step', 1.0, steps=(0.04, 0.02, 0.01, 0.005), lengths=(9.5,), reference_length=9.5),
    Scene('tagging', 'bit bounce on tagging at 0.3 m/s', 1.0, trace_until=0.8, steps=(0.04, 0.02, 0.01, 0.005), lengths=(9.5,),
          reference_length=9.5),
)
