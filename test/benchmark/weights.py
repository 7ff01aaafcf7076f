# SPDX-License-Identifier: BSD-3-Clause
"""What counted work weighs: instructions a node, counted once by callgrind (run --weights) and kept in weights.json.

Counted work of a run = nodes x (residuals x w_residual + tangents x w_tangent + solves x w_solve + substitutions x w_substitution
+ steps x w_step + frames x w_frame). A tangent comes with its residual: w_tangent is what it costs beyond that. Free and guided nodes
(numerics.level) have kernels' weights of their own; of a run whose level changes their mean numbers count. A step and a frame cost every node about
the same (memories, the accuracy watch, what is shown). Instructions do not depend on what else the machine does.
"""
import datetime
import json
import os
import re
import subprocess

HERE = os.path.dirname(os.path.abspath(__file__))
FILE = os.path.join(HERE, 'weights.json')
KERNELS = ('residual', 'tangent', 'solve', 'substitution')
CALLS = 50
FRAME = 0.01  # of the offline runner, or a step that is longer [s]
# the widest kernel that valgrind knows, with the settings that the weights are of
SETTINGS = ('numerics.kernel=avx2', 'numerics.level=beam3d', 'numerics.step=0.01')
STEPS = (0.01, 0.0025)  # that tell a step from a frame [s]


class Weights:
    def __init__(self, table, whole=None):
        self.table = table  # by element: instructions a node of each kernel
        self.whole = whole or {'step': 0.0, 'frame': 0.0}  # a node

    def of_kernels(self, element, summary):
        """Instructions of a run's kernels."""
        guided = summary.get('guided_nodes', 0.0)
        kinds = ((summary['nodes'] - guided, self.table.get(element) or self.table['corotational']), (guided, self.table.get('guided', {})))
        return sum(n * summary[kernel + 's'] * w[kernel] for n, w in kinds if n > 0.0 for kernel in KERNELS)

    def of(self, element, summary):
        """Instructions of a run. A step that was rejected is a step."""
        steps = summary['steps'] + summary['rejected_steps']
        return self.of_kernels(element, summary) + summary['nodes'] * (steps * self.whole['step'] + frames(summary) * self.whole['frame'])


def frames(summary):
    return summary['simulated_s'] / max(FRAME, summary['step'])


def load():
    with open(FILE) as file:
        content = json.load(file)
    return Weights(content['instructions_per_node'], content['beside_kernels'])


def collected(command, folder, *options):
    """What a command prints, and its instructions."""
    log = os.path.join(folder, 'callgrind.log')
    output = subprocess.run(['valgrind', '--tool=callgrind', '--callgrind-out-file=/dev/null', '--log-file=' + log] + list(options) + command,
                            stdout=subprocess.PIPE, check=True, universal_newlines=True).stdout
    with open(log) as file:
        return output, int(re.search(r'Collected : (\d+)', file.read()).group(1))


def instructions(kernels_program, scene, kernel, settings, folder):
    """A call's instructions per node."""
    nodes, count = collected([kernels_program, scene.path, kernel, str(CALLS)] + list(settings), folder, '--toggle-collect=*benchmark_%s*' % kernel)
    return count / (CALLS * int(nodes))


def second_of(drill_program, scene, step, folder):
    """Instructions of a run's second second, and its summary with the counts of that second."""
    runs, summaries = [], []
    for duration in ('1', '2'):
        file = os.path.join(folder, 'weights.json')
        command = [drill_program, 'run', scene.path, '--duration', duration, '--json', file]
        for setting in SETTINGS + ('numerics.step=%g' % step,):
            command += ['--set', setting]
        runs.append(collected(command, folder)[1])
        with open(file) as summary:
            summaries.append(json.load(summary))
    counts = [kernel + 's' for kernel in KERNELS] + ['steps', 'rejected_steps', 'simulated_s']
    return runs[1] - runs[0], dict(summaries[1], **{name: summaries[1][name] - summaries[0][name] for name in counts})


def beside_kernels(seconds, weights):
    """What a step and a frame cost a node beyond the kernels. `seconds`: of two lengths of step, each instructions and summary."""
    (rest, steps, all_frames), (other_rest, other_steps, other_frames) = (
        ((count - weights.of_kernels('corotational', summary)) / summary['nodes'], summary['steps'] + summary['rejected_steps'], frames(summary))
        for count, summary in seconds)
    step = (rest * other_frames - other_rest * all_frames) / (steps * other_frames - other_steps * all_frames)
    return {'step': step, 'frame': (rest - step * steps) / all_frames}


def measure(programs, scene, elements, folder, machine):
    """Counts, and writes weights.json. `programs`: benchmark_kernels and drill."""
    table = {}
    for element in list(elements) + ['guided']:
        settings = SETTINGS + ({'corotational': (), 'guided': ('numerics.level=axial_torsional',)}.get(element, ('numerics.element=' + element,)))
        counted = {kernel: instructions(programs[0], scene, kernel, settings, folder) for kernel in KERNELS}
        counted['tangent'] -= counted['residual']
        table[element] = {kernel: round(count) for kernel, count in counted.items()}
        print('%s: instructions a node: %s' % (element, table[element]), flush=True)
    whole = beside_kernels([second_of(programs[1], scene, step, folder) for step in STEPS], Weights(table))
    whole = {what: round(count) for what, count in whole.items()}
    print('beside the kernels, instructions a node: %s' % whole, flush=True)
    with open(FILE, 'w') as out:
        json.dump({'date': datetime.date.today().isoformat(), 'machine': machine, 'scene': scene.name, 'instructions_per_node': table, 'beside_kernels': whole}, out, indent=2)
        out.write('\n')
