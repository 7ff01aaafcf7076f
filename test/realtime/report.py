# SPDX-License-Identifier: BSD-3-Clause
"""Tables of runs in real time, for the terminal and for README.md."""
import os
import platform


def table(head, rows):
    lines = [head, ['---'] * len(head)] + [[str(c) for c in row] for row in rows]
    return '\n'.join('| %s |' % ' | '.join(line) for line in lines)


def percent(share):
    return '%.6g %%' % (100.0 * float(share))


def lost(run):
    """Snapshots that the node left out, and stamps that never reached the subscriber, of all topics that come with every frame."""
    return int(run['last']['unpublished_frames']), sum(missing for _, missing in run['topics'].values())


def cpu_per_frame(run):
    """Microseconds of each kind of thread."""
    return {kind: 1e6 * seconds / run['frames'] for kind, seconds in run['cpu'].items()}


def histogram(text):
    """{bin: number} of a histogram in the diagnostics."""
    return {bin_.strip(): int(number) for bin_, number in (part.rsplit(':', 1) for part in text.split(','))}


def histograms(runs):
    rows = []
    for run in runs:
        for what, key in (('lateness', 'latenesses'), ('frame time', 'frame_times')):
            rows.append([run['name'], what] + list(histogram(run['last'][key]).values()))
    return table(['scheduling', 'frames by'] + list(histogram(runs[0]['last']['latenesses'])), rows)


def extremes(runs):
    rows = []
    for run in runs:
        last = run['last']
        for what, key, longest in (('lateness', 'lateness', 'longest_lateness_ms'), ('frame time', 'frame_time', 'longest_frame_ms')):
            values = ['%.3g' % float(last['%s_p%s_ms' % (key, p)]) for p in ('50', '99', '99.9', '99.99')]
            rows.append([run['name'], what, percent(last[key + '_share_below_1_ms']), percent(last[key + '_share_below_period'])] + values +
                        ['%.3g' % float(last[longest])])
    return table(['scheduling', 'of', 'below 1 ms', 'below the period', '50 % [ms]', '99 %', '99.9 %', '99.99 %', 'longest'], rows)


def costs(runs):
    rows = []
    for run in runs:
        cpu = cpu_per_frame(run)
        others = cpu.get('ros', 0.0)
        node, subscriber = lost(run)
        rows.append([run['name'], run['frames'], node, subscriber, run['last']['pictures_left_out'], '%.3g' % float(run['last']['dropped_seconds'])] +
                    ['%.0f' % value for value in (cpu['simulation'], cpu['publishing'], others, cpu['publishing'] + others)])
    return table(['scheduling', 'frames', 'snapshots lost', 'stamps missing at the subscriber', 'pictures left out', 'time dropped [s]',
                  'CPU a frame [us]: simulation', 'publishing', 'roscpp\'s threads', 'the last two'], rows)


def phases(runs):
    rows = []
    for run in runs:
        for phase, first, last, between in run['phases']:
            factor = (float(last['simulated_time']) - float(first['simulated_time'])) / max(1, len(between))
            rows.append([run['name'], phase, '%.3f' % factor, '%.2f' % (float(last['dropped_seconds']) - float(first['dropped_seconds'])),
                         'yes' if any(values['slow'] for values in between) else 'no'])
    return table(['scheduling', 'phase', 'real-time factor', 'time dropped [s]', 'diagnostics report it'], rows)


def setting(args, runs):
    last = runs[0]['last']
    kept = ' and '.join('%.2f' % run['stolen'] for run in runs)
    return ('%s, %g Hz, %g minutes each; level %s, %s nodes, step %s s, %s; %d processors, Linux %s, load at the start %.1f. '
            'The host kept the processors for others for %s s.' % (
                os.path.basename(args.scene), args.rate, args.minutes, last['level'], last['nodes'], last['step'], last['integrator'],
                os.cpu_count(), platform.release(), args.load, kept))


def whole(args, runs):
    parts = [setting(args, runs), extremes(runs), 'How many frames:', histograms(runs), costs(runs)]
    if args.hog:
        parts += ['With %d busy loops a processor in the middle third:' % args.loops, phases(runs)]
        parts += ['%s: truth at %.3f s equals that of a lockstep run with the same commands: %s.' % (
            run['name'], 1e-9 * run['stamp'], 'yes' if not run['differs'] else 'NO, in ' + ', '.join(run['differs'])) for run in runs]
    return '\n\n'.join(parts) + '\n'
