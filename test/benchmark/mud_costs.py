# SPDX-License-Identifier: BSD-3-Clause
"""What each law of the mud costs: instructions a step by callgrind, and their share of a frame with all nodes free and on the cheapest level."""
import os

import laws
import yaml

SCENE = os.path.join(laws.SOURCE, 'config/campaigns/mud.yaml')  # 2.5 km
DURATION = 12.0  # [s], while the pump starts and the bit is off bottom
LEVELS = ('beam3d', 'axial_torsional')
FRAME = ((None, 'Simulator::frame('),)
MUD = ((None, 'advance_mud('), (None, 'advance_cuttings('), (None, 'advance_temperature('))
# (row, the keys of `mud` that it has); a key without a value takes all defaults
ROWS = (('two volumes, one loss coefficient', ()),
        ('pressure losses by section', ('rheology',)),
        ('the same with cuttings', ('rheology', 'cuttings')),
        ('the same with temperature', ('rheology', 'temperature')),
        ('the same with pressure waves', ('rheology', 'pressure_waves')),
        ('all', ('rheology', 'cuttings', 'temperature', 'pressure_waves')))


def scene_with(options):
    """The scene with only these options of its mud, each with its own or the default keys."""
    with open(SCENE, encoding='utf-8') as file:
        scene = yaml.safe_load(file)
    mud = scene['mud']
    scene['mud'] = {key: value for key, value in mud.items() if key not in ROWS[-1][1]}
    scene['mud'].update({key: mud.get(key, {}) for key in options})
    if not options:
        del scene['string'][0]['nozzles']  # they have no effect then, and are refused
    return scene


def measure(drill, folder):
    """By row and level: instructions a step of the mud and of a whole frame."""
    path = os.path.join(folder, 'mud_costs.yaml')
    found = {}
    for row, options in ROWS:
        with open(path, 'w', encoding='utf-8') as file:
            yaml.safe_dump(scene_with(options), file)
        for level in LEVELS:
            rows, summary = laws.run(drill, path, DURATION, folder, level)
            found[row, level] = [laws.count(rows, pieces) / summary['steps'] for pieces in (MUD, FRAME)]
    return found


def text(found):
    head = ['instructions a step of 10 ms'] + ['share of a frame, `%s`' % level for level in LEVELS]
    rows = ['| mud, 2.5 km | %s |' % ' | '.join(head), '| --- ' * (len(head) + 1) + '|']
    for row, _ in ROWS:
        mud = found[row, LEVELS[0]][0]
        shares = ['%.2f %%' % (100.0 * found[row, level][0] / found[row, level][1]) for level in LEVELS]
        rows.append('| %s | %.0f | %s |' % (row, mud, ' | '.join(shares)))
    return '\n'.join(rows) + '\n'
