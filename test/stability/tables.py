# SPDX-License-Identifier: BSD-3-Clause
"""The stability map as Markdown tables."""
import os

AXES = {'contact_stiffness': 'contact stiffness [N/m^1.5]', 'bristle_stiffness': 'bristle stiffness (sticking friction) [N/m]',
        'stribeck_speed': 'Stribeck speed [m/s]', 'element_length': 'element length [m]', 'lateral_damping': 'lateral damping of the mud [N s/m per m]'}
USUAL = {'contact_stiffness': '5e+07', 'bristle_stiffness': '5e+06', 'stribeck_speed': '0.05', 'element_length': '4.75', 'lateral_damping': '20'}
CASES = {'turns': 'turns of the top drive', 'sticking': 'sticking on a slope of 20 deg', 'buckling': 'slack-off to a coil and back', 'impact': 'bit on hard rock at 2 m/s',
         'slow drilling': 'slow drilling, 0.35 mm/s'}


def kept(row):
    """What README.md beside this promises of this row came true."""
    return row['kept'] == 'yes'


def unique(values):
    return list(dict.fromkeys(values))


def who(row):
    return row['method'] if row['element'] in ('corotational', '-') else '%s, %s' % (row['method'], row['element'])


def table(head, lines):
    return '\n'.join('| ' + ' | '.join(line) + ' |' for line in [head, ['---'] * len(head)] + lines) + '\n'


def milliseconds(row):
    """The largest step without halving, in brackets the one with."""
    figure = float(row['figure'])
    plain = '%g' % (1e3 * figure) if figure else '-'
    if 'by halving ' in row['text']:
        plain += ' (%g)' % (1e3 * float(row['text'].split('by halving ')[1].split()[0]))
    if not row['verdict'].startswith('passes') and not figure:
        return plain if '(' in plain else row['verdict']
    return plain


def maps(rows):
    out = []
    for axis in unique(row['case'] for row in rows if row['group'] == 'map'):
        mine = [row for row in rows if row['group'] == 'map' and row['case'] == axis]
        values = unique(row['value'] for row in mine)
        lines = []
        for name in unique(who(row) for row in mine):
            cells = {row['value']: milliseconds(row) for row in mine if who(row) == name}
            lines.append(['`%s`' % name] + [cells.get(value, '') for value in values])
        head = [AXES[axis]] + ['**%s**' % value if value == USUAL[axis] else value for value in values]
        out.append(table(head, lines))
    return '\n'.join(out)


def verdict_cell(row):
    if row['verdict'] == 'too slow':
        return 'too slow (%s)' % row['text'].split('; ')[-1]
    if row['group'] == 'turns':
        figure = '%.0e drift, %s' % (float(row['figure']), row['case'].split()[0])
    elif row['group'] == 'sticking':
        figure = '%.2g um in %s s' % (float(row['figure']), row['case'].split()[0])
    elif row['group'] == 'buckling':
        figure = '%.2g mm left' % float(row['figure'])
    elif row['group'] == 'impact':
        figure = 'peak %.2f of reference' % float(row['figure'])
    else:
        figure = '%.2f m in %s h' % (float(row['figure']), row['case'].split()[0])
    step = [part for part in row['text'].split('; ') if part.startswith('step ')]
    if not step:
        return row['verdict']
    return '%s (%s)' % (row['verdict'], '; '.join([figure, step[0]]))


def methods(rows):
    """Cases that every method runs."""
    lines = []
    names = unique(who(row) for row in rows if row['group'] in CASES)
    for name in names:
        mine = {row['group']: row for row in rows if row['group'] in CASES and who(row) == name}
        lines.append(['`%s`' % name] + [verdict_cell(mine[group]) if group in mine else '' for group in CASES])
    return table(['method'] + list(CASES.values()), lines)


def default(rows):
    """What was seen of the default, and of the other elements, in words."""
    lines = []
    for row in rows:
        if row['group'] in ('full turn', 'wells') or (row['group'] in CASES and row['promise'] == 'passes'):
            lines.append([row['case'] + ('' if row['group'] != 'full turn' else ', `%s`' % row['element']), row['verdict'], row['text']])
    short = [row for row in rows if row['group'] == 'short steps']
    if short:
        bad = [row for row in short if not row['verdict'].startswith('passes')]
        lines.append(['steps of 0.1 and 0.01 ms, along the axes', 'passes' if not bad else bad[0]['verdict'], '%d of %d pass' % (len(short) - len(bad), len(short))])
    corners = [row for row in rows if row['group'] == 'corners']
    if corners:
        bad = [row for row in corners if not row['verdict'].startswith('passes')]
        halved = sum(row['verdict'] == 'passes by halving' for row in corners)
        lines.append(['every other corner of the promised range, step %s s' % corners[0]['figure'], 'passes' if not bad else bad[0]['verdict'],
                      '%d of %d pass, %d of them by halving' % (len(corners) - len(bad), len(corners), halved)])
    return table(['case', 'verdict', 'seen'], lines)


def levels(rows):
    """Of levels and variable steps, what was seen along the axes."""
    lines = []
    for name in unique(row['case'] for row in rows if row['group'] == 'levels'):
        mine = [row for row in rows if row['group'] == 'levels' and row['case'] == name]
        bad = [row for row in mine if not row['verdict'].startswith('passes')]
        halved = sum(row['verdict'] == 'passes by halving' for row in mine)
        seen = '%d of %d pass, %d of them by halving' % (len(mine) - len(bad), len(mine), halved)
        lines.append([name, 'passes' if not bad else bad[0]['verdict'], seen + ''.join('; %s: %s' % (row['value'], row['text']) for row in bad)])
    return table(['level and steps', 'verdict', 'seen'], lines)


def index3(rows):
    mine = [row for row in rows if row['group'] == 'index 3']
    steps = unique(row['value'] for row in mine)
    lines = []
    for name in unique(row['case'] for row in mine):
        cells = {row['value']: row for row in mine if row['case'] == name}
        lines.append([name] + ['%.0e' % float(cells[step]['figure']) if not cells[step]['verdict'].startswith('fails: not') else cells[step]['verdict']
                               for step in steps])
    return table(['step [s]'] + steps, lines)


def outside(rows):
    lines = [[row['case'], '`%s`' % row['method'], row['verdict'], row['text']] for row in rows if row['group'] == 'outside']
    return table(['asked for', 'method', 'outcome', 'message'], lines)


def write(rows, folder):
    """Writes the tables; returns their names."""
    names = []
    for make in (maps, methods, default, levels, index3, outside):
        name = make.__name__ + '.md'
        with open(os.path.join(folder, name), 'w') as out:
            out.write(make(rows))
        names.append(name)
    return names
