"""What residuals, tangents, solves and substitutions weigh: instructions a node and call, counted once by callgrind (run --weights) and kept in weights.json.

Counted work of a run = nodes x (residuals x w_residual + tangents x w_tangent + solves x w_solve +
substitutions x w_substitution). A tangent comes with its residual: w_tangent
is what it costs beyond that. Free and guided nodes (numerics.level) have weights of their own; of a run whose level changes their mean numbers count. Instructions do not depend on what else the machine does.
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


class Weights:
    def __init__(self, table):
        self.table = table  # by element: instructions a node of each kernel

    def of(self, method, element, counted, nodes):
        """Instructions of a run."""
        guided = counted.get('guided_nodes', 0.0)
        kinds = ((nodes - guided, self.table.get(element) or self.table['corotational']), (guided, self.table.get('guided', {})))
        return sum(n * counted[kernel + 's'] * w[kernel] for n, w in kinds if n > 0.0 for kernel in KERNELS)


def load():
    with open(FILE) as file:
        return Weights(json.load(file)['instructions_per_node'])


def instructions(kernels_program, scene, kernel, settings, folder):
    """A call's instructions per node."""
    log = os.path.join(folder, 'callgrind.log')
    output = subprocess.run(['valgrind', '--tool=callgrind', '--callgrind-out-file=/dev/null', '--log-file=' + log,
                             '--toggle-collect=*benchmark_%s*' % kernel, kernels_program, scene.path, kernel, str(CALLS)] + list(settings),
                            stdout=subprocess.PIPE, check=True, universal_newlines=True).stdout
    with open(log) as file:
        collected = int(re.search(r'Collected : (\d+)', file.read()).group(1))
    return collected / (CALLS * int(output))


def measure(kernels_program, scene, elements, folder, machine):
    """Counts, and writes weights.json."""
    table = {}
    for element in list(elements) + ['guided']:
        settings = {'corotational': [], 'guided': ['numerics.level=axial_torsional']}.get(element, ['numerics.element=' + element])
        counted = {kernel: instructions(kernels_program, scene, kernel, settings, folder) for kernel in KERNELS}
        counted['tangent'] -= counted['residual']
        table[element] = {kernel: round(count) for kernel, count in counted.items()}
        print('%s: instructions a node: %s' % (element, table[element]), flush=True)
    with open(FILE, 'w') as out:
        json.dump({'date': datetime.date.today().isoformat(), 'machine': machine, 'scene': scene.name, 'instructions_per_node': table}, out, indent=2)
        out.write('\n')
