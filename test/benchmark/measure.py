# SPDX-License-Identifier: BSD-3-Clause
"""How far a run is from the reference: one relative error per output and one for the scene.

Scale of an output: its range in the reference over the whole run, at least the floor below (what the field's instruments resolve), so that
an output that the scene does not move counts little, and round-off in it nothing.
Error of an output up to the scene's `trace_until`: root mean square of the difference to the reference, over its scale. After it: root mean
square of the differences of mean, standard deviation, least and greatest value, over the scale. Where a scene has both, their root mean
square. A scene's period is one more output; its error is relative. Error of the scene: root mean square over its outputs.
"""
import numpy

COLUMNS = ('time', 'hook_load', 'torque', 'wob', 'bit_speed', 'bit_east', 'bit_north', 'bit_up', 'bit_inclination')
# floors: N, N m, N, rad/s, m, rad
OUTPUTS = {'hook_load': 1e3, 'torque': 100.0, 'wob': 1e3, 'bit_speed': 0.1, 'bit_position': 0.01, 'bit_inclination': 1.75e-3}


def values(series, output):
    """One row per sample; the bit's position has three columns."""
    if output == 'bit_position':
        return numpy.column_stack([series['bit_east'], series['bit_north'], series['bit_up']])
    return numpy.asarray(series[output])[:, None]


def scale(reference, output):
    y = values(reference, output)
    return max(float(numpy.linalg.norm(numpy.ptp(y, axis=0))), OUTPUTS[output])


def rms(x):
    return float(numpy.sqrt(numpy.mean(numpy.square(x))))


def trace_error(run, reference, output, until):
    part = numpy.asarray(reference['time']) <= until + 1e-6
    difference = (values(run, output) - values(reference, output))[part]
    return rms(numpy.linalg.norm(difference, axis=1)) / scale(reference, output)


def statistics_error(run, reference, output, since):
    part = numpy.asarray(reference['time']) > since + 1e-6
    a, b = values(run, output)[part], values(reference, output)[part]
    differences = [numpy.linalg.norm(f(a, axis=0) - f(b, axis=0)) for f in (numpy.mean, numpy.std, numpy.min, numpy.max)]
    return rms(differences) / scale(reference, output)


def period(time, y):
    """Mean time between upward crossings of the middle of the range, each after the signal was in the lowest quarter; nan below two."""
    low, high = numpy.min(y), numpy.max(y)
    crossings, armed = [], False
    for i in range(1, len(y)):
        armed = armed or y[i - 1] < low + 0.25 * (high - low)
        middle = 0.5 * (low + high)
        if armed and y[i - 1] < middle <= y[i]:
            crossings.append(time[i - 1] + (middle - y[i - 1]) / (y[i] - y[i - 1]) * (time[i] - time[i - 1]))
            armed = False
    if len(crossings) < 2:
        return float('nan')
    return (crossings[-1] - crossings[0]) / (len(crossings) - 1)


def period_error(run, reference, output, since):
    part = numpy.asarray(reference['time']) > since + 1e-6
    ours, wanted = (period(numpy.asarray(s['time'])[part], values(s, output)[part][:, 0]) for s in (run, reference))
    if not numpy.isfinite(wanted):
        raise ValueError('the reference has no period in %s' % output)
    return abs(ours - wanted) / wanted if numpy.isfinite(ours) else 1.0


def at_times(series, time):
    """The samples at these times: all of the series or every n-th, from the first to the last."""
    every, rest = divmod(len(series['time']) - 1, max(len(time) - 1, 1))
    part = {name: numpy.asarray(column)[::every] for name, column in series.items()} if rest == 0 and every > 0 else {'time': numpy.array([])}
    if len(part['time']) != len(time) or numpy.max(numpy.abs(part['time'] - time)) > 1e-6:
        raise ValueError('run and reference are not sampled at equal times')
    return part


def errors(run, reference, scene):
    """Error by output, and the scene's as 'all'. `run` and `reference`: columns by name; a run of long steps may have every n-th sample only."""
    reference = at_times(reference, run['time'])
    out = {}
    for output in OUTPUTS:
        parts = [trace_error(run, reference, output, scene.trace_until)]
        if scene.trace_until < scene.duration:
            parts.append(statistics_error(run, reference, output, scene.trace_until))
        out[output] = rms(parts)
    if scene.period_of:
        out['period'] = period_error(run, reference, scene.period_of, scene.trace_until)
    out['all'] = rms(list(out.values()))
    return out
