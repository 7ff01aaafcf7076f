# SPDX-License-Identifier: BSD-3-Clause
"""How fast the program is on this machine, by kernel: a table of figures of one core, each the least of rounds in which the kernels take turns.

Bare pipe and its linear system are timed by benchmark_speed, whole rigs by the offline runner (`cpu_s` of its summaries, without the start).
"""
import collections
import json
import os
import subprocess

import measure as measures
from drill import read_series

SOURCE = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
PIPE = os.path.join(SOURCE, 'test/benchmark/speed/hanging_pipe.yaml')
BOHAI = os.path.join(SOURCE, 'config/scenes/bohai.yaml')
FIVE = os.path.join(SOURCE, 'test/operations/scenes/horizontal_5_km.yaml')
TWELVE = os.path.join(SOURCE, 'test/operations/scenes/extended_reach_12_km.yaml')
ROUNDS = 3
OUTPUTS = ('hook_load', 'torque', 'wob', 'bit_speed')
PIPES = ((75, []), (300, ['numerics.element_length=2.44']), (1000, ['string[1].joint_length=7.3', 'numerics.element_length=0.7301']))
Rig = collections.namedtuple('Rig', 'name path level step duration')  # [s]
RIGS = (Rig('Bohai, beam3d', BOHAI, 'beam3d', 0.01, 20.0), Rig('5 km, beam3d', FIVE, 'beam3d', 0.01, 5.0), Rig('12.4 km, beam3d', TWELVE, 'beam3d', 0.01, 2.0),
        Rig('12.4 km, axial_torsional', TWELVE, 'axial_torsional', 0.01, 5.0))
MINUTE = 60.0  # in it the rigs with guided pipe begin to turn, drill (5 km) and go down [s]
HYBRIDS = (Rig('5 km, hybrid by 20 ms', FIVE, 'hybrid', 0.02, MINUTE), Rig('12.4 km, hybrid by 50 ms', TWELVE, 'hybrid', 0.05, MINUTE))
REFERENCE = ['--level', 'beam3d', '--integrator', 'trbdf2', '--step', '0.005', '--element-length', '4.76']  # of the hybrids' errors


class Failed(Exception):
    """A program that ended without a result."""


def output(words):
    done = subprocess.run(words, stdout=subprocess.PIPE, stderr=subprocess.PIPE, universal_newlines=True)
    if done.returncode != 0:
        raise Failed(done.stderr.strip() or '%s: exit status %d' % (words[0], done.returncode))
    return done.stdout


def measure_pipes(programs):
    """{elements: {kernel: row of benchmark_speed}}"""
    bench = os.path.join(programs, 'benchmark_speed')
    return {elements: {row['kernel']: row for row in json.loads(output([bench, PIPE] + settings))} for elements, settings in PIPES}


def options_of(rig, kernel):
    return ['--duration', repr(rig.duration), '--level', rig.level, '--element-length', '9.5', '--step', repr(rig.step), '--set', 'numerics.kernel=' + kernel]


def measure_rigs(drill, kernels, folder, say):
    """{rig: {kernel: summary of the quickest run}}, an element a joint."""
    summary = os.path.join(folder, 'speed.json')
    found = {rig.name: {} for rig in RIGS + HYBRIDS}
    for rig in RIGS + HYBRIDS:
        for _ in range(ROUNDS):
            for kernel in kernels:
                output([drill, 'run', rig.path, '--json', summary] + options_of(rig, kernel))
                with open(summary) as file:
                    told = json.load(file)
                if kernel not in found[rig.name] or told['cpu_s'] < found[rig.name][kernel]['cpu_s']:
                    found[rig.name][kernel] = told
        say(rig.name)
    return found


def error_of(drill, rig, folder):
    """(error, output) of the worst output of a hybrid against free nodes, root mean square over the reference's range."""
    series = []
    for name, options in (('hybrid', options_of(rig, 'auto')), ('reference', ['--duration', repr(rig.duration)] + REFERENCE)):
        table = os.path.join(folder, 'speed_%s.csv' % name)
        output([drill, 'run', rig.path, '--csv', table] + options)
        series.append(read_series(table))
    run, reference = series[0], measures.at_times(series[1], series[0]['time'])
    return max((measures.trace_error(run, reference, name, rig.duration), name) for name in OUTPUTS)


def of_elements(told):
    """[us an element and step]"""
    return 1e6 * told['cpu_s'] / told['steps'] / (told['nodes'] - 1)


def rows(pipes, rigs, kernels):
    """(what, {kernel: figure}, digits)"""
    solve = {kernel: pipes[300][kernel]['factor_and_solve_ns'] for kernel in kernels}
    best_solve = min(solve.values())
    table = [('factor and solve, ns a node', solve, 0),
             ('solve again, another right side, ns a node', {k: pipes[300][k]['substitution_ns'] for k in kernels}, 0)]
    for elements, _ in PIPES:
        table.append(('hanging pipe of %d elements, 1 ms, us an element and step' % elements, {k: pipes[elements][k]['step_us'] for k in kernels}, 2))
    table.append(('hanging pipe of 300: the step over the best factor and solve', {k: 1e3 * pipes[300][k]['step_us'] / best_solve for k in kernels}, 1))
    beams = [rig.name for rig in RIGS if rig.level == 'beam3d']
    for name in beams:
        table.append((name + ', us an element and step', {k: of_elements(rigs[name][k]) for k in kernels}, 2))
    table.append(('12.4 km, beam3d: the step over the best factor and solve', {k: 1e3 * of_elements(rigs['12.4 km, beam3d'][k]) / best_solve for k in kernels}, 1))
    table.append(('beam3d: dearest over cheapest element, 80 to 1300 of them',
                  {k: max(of_elements(rigs[n][k]) for n in beams) / min(of_elements(rigs[n][k]) for n in beams) for k in kernels}, 2))
    guided = '12.4 km, axial_torsional'
    table.append(('guided node, us a step', {k: 1e6 * rigs[guided][k]['cpu_s'] / rigs[guided][k]['steps'] / rigs[guided][k]['nodes'] for k in kernels}, 3))
    for rig in RIGS + HYBRIDS:
        table.append((rig.name + ', times real time', {k: rigs[rig.name][k]['real_time_factor'] for k in kernels}, 0))
    return table


def text(table, errors, kernels, about):
    lines = ['| one core | ' + ' | '.join(kernels) + ' |', '| --- ' * (len(kernels) + 1) + '|']
    for what, figures, digits in table:
        lines.append('| %s | %s |' % (what, ' | '.join('%.*f' % (digits, figures[kernel]) for kernel in kernels)))
    lines += ['', 'Of the hybrids the worst output over a minute, against free nodes of half joints by TR-BDF2 of 5 ms: ' +
              '; '.join('%s %.2g %% (%s)' % (name, 100.0 * error, of.replace('_', ' ')) for name, (error, of) in errors.items()) + '.']
    lines += ['', '%s, %s %s.' % (about['cpu'], about['compiler'], about['flags'])]
    return '\n'.join(lines) + '\n'


def measure(drill, folder, about, say):
    """The table as text."""
    pipes = measure_pipes(os.path.dirname(drill))
    kernels = list(pipes[300])
    say('linear systems and bare pipe, by ' + ', '.join(kernels))
    table = rows(pipes, measure_rigs(drill, kernels, folder, say), kernels)
    errors = {rig.name: error_of(drill, rig, folder) for rig in HYBRIDS}
    say('errors of the hybrids')
    return text(table, errors, kernels, about)
