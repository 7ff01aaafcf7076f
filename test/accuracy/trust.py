# SPDX-License-Identifier: BSD-3-Clause
"""What the cases say of each subject that test/accuracy/README.md says how far to trust: the largest difference among the subject's cases."""
import re

# a subject of the page, the groups of its cases and what their names hold
SUBJECTS = [
    ('places along a surveyed well', 'surveys', ''),
    ('weights and torque along the string', 'torque_and_drag', '^(?!.*soft string of the tests)'),
    ('periods of waves', 'vibrations', r'period \[s\]|wave \[s\]|mode'),
    ('stick-slip', 'stick_slip|stick_slip_well_a', '^(?!.*as published)(?!.*wave model)'),
    ('stick-slip as published', 'stick_slip_well_a', 'as published'),
    ('weight and torque on the bit in steady drilling', 'detournay', ''),
    ('whirl', 'whirl', ''),
    ('build rate of a bent motor', 'bent_motor', 'build rate at'),
    ('side force at the wall of the default', 'bent_motor', "default's wall"),
    ('slides drilled', 'sliding', ''),
    ('critical load of buckling', 'buckling|beams', 'sinusoidal|column|critical weight'),
    ('helix of buckled pipe', 'buckling', 'helix'),
    ('beams bent far', 'beams', 'tip [xyz]'),
    ('energy that the balance misses, of its throughput', 'energy|energy_small', 'closure'),
    ('energy that the integration takes out, of the throughput', 'energy|energy_small', 'numerical dissipation'),
    ("energy that the path's correction brings or takes, of the throughput", 'energy|energy_small', 'correction of the path'),
]


def shown(value, unit):
    return ('%g %s' % (float('%.2g' % value), unit)).strip()


def difference(line):
    """Size of a case's difference, its bound and their unit: percent of what is published, or the case's own unit where it is absolute."""
    cell, bound = line.cells[3].split(), float(line.cells[4])
    if cell[-1] == 'abs':
        unit = re.search(r'\[([^]]+)\]$', line.cells[0])
        return abs(float(cell[0])), bound, unit.group(1) if unit else ''
    return 100.0 * abs(float(cell[0])), 100.0 * bound, '%'


def rows(lines):
    """A row for each subject and unit: subject, number of cases, largest difference, its bound and its case. Bands, which hold or not,
    are left out."""
    out = []
    for subject, groups, name in SUBJECTS:
        mine = [line for line in lines if re.fullmatch(groups, line.group) and re.search(name, line.cells[0])]
        assert mine, 'no case of any kind for "%s"' % subject
        judged = [(difference(line), line.cells[0]) for line in mine if not line.skipped and float(line.cells[4]) > 0.0]
        if not judged:
            out.append([subject, '0', 'no data', '', ''])
        for unit in dict.fromkeys(unit for (_, _, unit), _ in judged):
            alike = [(size, bound, case) for (size, bound, its), case in judged if its == unit]
            size, bound, case = max(alike)
            out.append([subject, str(len(alike)), shown(size, unit), shown(bound, unit), case])
    return out


def write(lines, place):
    with open(place, 'w') as out:
        out.write('| subject | cases | largest difference | allowed there | case |\n| --- | --- | --- | --- | --- |\n')
        for row in rows(lines):
            out.write('| ' + ' | '.join(row) + ' |\n')
