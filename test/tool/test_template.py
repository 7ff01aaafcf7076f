#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""config/scenes/template.yaml has every key of a scene once in its place, with what `drill reference` says of it, and is a valid scene.

Usage: test_template.py PATH_TO_DRILL [--write]; with --write, fills in the lines that begin with ## instead.
"""
import os
import re
import subprocess
import sys
import textwrap
import unittest

SOURCE = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
TEMPLATE = os.path.join(SOURCE, 'config', 'scenes', 'template.yaml')
WIDTH = 150
KEY = re.compile(r'(#?)( *)(- )?(\w+):')
LISTS = ('sections', 'formation', 'string', 'program', 'operations')
# blocks whose keys are explained once for several
PATTERNS = ((r'well\.survey\.columns\.\w+$', 'well.survey.columns.*'), (r'instruments\.surface\.(?!hook_load|stand_pipe_pressure)\w+$', 'instruments.surface.*'))
# of these the template has another value than the default
OTHERWISE = ('joints', 'joint_length', 'static', 'bend_deg', 'bit_depth', 'ramp', 'top_drive_speed_rpm', 'flow', 'block_velocity', 'hole_depth', 'tool_joint_diameter',
             'squeeze_film_damping', 'sensor_offset')
# keys of every gauge, explained at the first
OF_EVERY_GAUGE = ('instruments.surface.hook_load', 'instruments.surface.stand_pipe_pressure', 'instruments.surface.*')
drill_program = None


def drill(*words):
    return subprocess.run([drill_program] + list(words), cwd=SOURCE, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)


def reference():
    """{block: {key: its line}} of `drill reference`."""
    table, block = {}, None
    for line in drill('reference').stdout.splitlines():
        heading = re.match(r'### (.*)', line)
        row = re.match(r'\| `(\w+)` \| (.*?) \| (.*?) \| (.*?) \| (.*) \|$', line)
        if heading:
            block = '' if heading.group(1) == 'Top level' else heading.group(1).strip('`')
            table[block] = {}
        elif row:
            key, unit, default, allowed, meaning = [part.strip() for part in row.groups()]
            default = 'required' if default == '**required**' else default and 'default ' + default
            table[block][key] = '; '.join(part for part in (unit, default, allowed, meaning) if part and part != '-')
    return table


def block_of(path):
    """How the reference calls the block at a path of names."""
    name = '.'.join(part + '[]' if part in LISTS else part for part in path)
    for pattern, block in PATTERNS:
        name = re.sub(pattern, block, name)
    return name


def walk(lines):
    """(number of the line, indentation, block, key) of each key in block style, of those that are off too."""
    path = []  # (indentation, name)
    for number, line in enumerate(lines):
        found = KEY.match(line)
        if not found or line.startswith('##'):
            continue
        # a # stands in the place of the first blank; without one behind it the key is one of the top level
        off, blanks, dash, key = found.groups()
        indent = len(off + blanks + (dash or '')) if blanks or not off else 0
        path = [part for part in path if part[0] < indent]
        yield number, indent, block_of([name for _, name in path]), key
        path.append((indent, key))


def explained(lines):
    """The template's lines with what the reference says above the first line of each key; keys and blocks that it does not know are left alone."""
    table, out, done = reference(), [], set()
    lines = [line for line in lines if not line.startswith('##')]
    found = {number: (indent, block, key) for number, indent, block, key in walk(lines)}
    for number, line in enumerate(lines):
        if number in found:
            indent, block, key = found[number]
            text = table.get(block, {}).get(key)
            if text and (block, key) not in done:
                done.add((block, key))
                out += textwrap.wrap(text, WIDTH - 10 - indent, initial_indent='## ' + ' ' * indent, subsequent_indent='## ' + ' ' * (indent + 2),
                                     break_long_words=False, break_on_hyphens=False)
        out.append(line)
    return out


def same(text, default):
    """As the word, or as the number in any spelling."""
    try:
        return float(text) == float(default)
    except ValueError:
        return text == default


def read():
    with open(TEMPLATE, encoding='utf-8') as file:
        return file.read().splitlines()


class Template(unittest.TestCase):
    def test_lines_are_those_of_the_reference(self):
        self.assertEqual(explained(read()), read(), 'fill it in by test/tool/test_template.py DRILL --write')

    def test_every_key_is_there(self):
        seen = {(block, key) for _, _, block, key in walk(read())}
        missing = [(block, key) for block, keys in reference().items() for key in keys if (block, key) not in seen]
        self.assertEqual([], [pair for pair in missing if not (pair[0] in OF_EVERY_GAUGE and any((block, pair[1]) in seen for block in OF_EVERY_GAUGE))])
        self.assertGreater(len(seen), 200)

    def test_no_key_is_unknown(self):
        table = reference()
        self.assertEqual([], [(block, key) for _, _, block, key in walk(read()) if key not in table.get(block, {})])

    def test_it_is_a_scene(self):
        done = drill('check', 'config/scenes/template.yaml')
        self.assertEqual(0, done.returncode, done.stdout)

    def test_numbers_are_the_defaults(self):
        table, lines = reference(), read()
        for number, _, block, key in walk(lines):
            default = re.search(r'(^|; )default ([^;]+)', table[block][key])
            value = re.match(r' *(?:- )?\w+: ([^#{[]+)$', lines[number])
            as_default = '0: the default' in table[block][key]
            if value and default and not lines[number].startswith('#') and key not in OTHERWISE and not as_default:
                self.assertTrue(same(value.group(1).strip(), default.group(2).split(',')[0]), '%s: %s' % (key, table[block][key]))


if __name__ == '__main__':
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    if sys.argv[1] == '--help':
        print(__doc__)
        sys.exit(0)
    drill_program = os.path.abspath(sys.argv.pop(1))
    if sys.argv[1:] == ['--write']:
        text = '\n'.join(explained(read())) + '\n'
        with open(TEMPLATE, 'w', encoding='utf-8') as template:
            template.write(text)
    else:
        unittest.main()
