#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The committed tables have the columns, row names and wording that tables.py writes today; their figures are not looked at."""
import glob
import os
import re
import sys
import unittest

HERE = os.path.dirname(os.path.abspath(__file__))
sys.dont_write_bytecode = True
sys.path.insert(0, HERE)
import tables  # noqa: E402

RENEW = 'make the tables again with ./test/stability/run --update-readme'
# a case of each group that every method runs, as the program behind ./test/stability/run writes it
CASES = {'turns': '1 turns of the top drive', 'sticking': '1 s on a slope of 20 deg', 'buckling': 'slack-off to a coil and back',
         'impact': 'bit on hard rock at 2 m/s', 'slow drilling': '1 h at 0.35 mm/s'}


def row(group, case, **more):
    return dict({'group': group, 'case': case, 'value': '', 'method': 'bdf2', 'element': 'corotational', 'promise': 'passes', 'verdict': 'passes',
                 'kept': 'yes', 'figure': '0.01', 'unit': '', 'text': 'step 0.01 s; and more'}, **more)


def rows():
    out = [row('map', axis, value=tables.USUAL[axis], text='by halving 0.1 s; more') for axis in tables.AXES]
    out += [row(group, case) for group, case in CASES.items()]
    out += [row('full turn', 'three turns of the string'), row('short steps', 'element_length'), row('corners', 'a', verdict='passes by halving')]
    out += [row('levels', 'hybrid', value='mud.lateral_damping=0')]
    out += [row('index 3', 'index 3', value='0.001', figure='1'), row('outside', 'step 0', promise='diagnostic')]
    return out


def without_numbers(text):
    """The text with `#` for every number."""
    return re.sub(r'(?<![\w])[-+]?\d[\d.]*(e[-+]?\d+)?', '#', text)


def format_strings():
    """All that the program and tables.py can say, with `#` for every number."""
    text = ''
    for path in glob.glob(os.path.join(HERE, '*.cpp')) + [os.path.join(HERE, 'tables.py')]:
        with open(path) as file:
            text += re.sub(r'"\s*\n\s*"', '', file.read())
    return without_numbers(re.sub(r'%[-+.\d]*l*[a-z]', '#', text))


def cells(text):
    """Rows of cells with `#` for every number."""
    return [[without_numbers(cell.strip()) for cell in line.strip('|\n').split('|')] for line in text.splitlines() if line.startswith('| ')]


def committed(name):
    with open(os.path.join(HERE, 'pictures', name + '.md')) as text:
        return cells(text.read())


class Tables(unittest.TestCase):
    def test_columns(self):
        for make in (tables.methods, tables.default, tables.levels, tables.outside):
            self.assertEqual(committed(make.__name__)[0], cells(make(rows()))[0], '%s.md: %s' % (make.__name__, RENEW))
        self.assertEqual(committed('index3')[0][0], cells(tables.index3(rows()))[0][0], RENEW)
        heads = [[line[0] for line in table if line[0] in tables.AXES.values()] for table in (committed('maps'), cells(tables.maps(rows())))]
        self.assertEqual(heads[0], heads[1], RENEW)

    def test_row_names_of_the_default(self):
        names = [line[0] for line in committed('default')]
        self.assertEqual([], [line[0] for line in cells(tables.default(rows())) if line[0] not in names], 'default.md: ' + RENEW)

    def test_wording_of_sums(self):
        told = [line[2] for line in committed('default') if ' pass' in line[2]]
        self.assertEqual(told, [line[2] for line in cells(tables.default(rows())) if ' pass' in line[2]], 'default.md: ' + RENEW)

    def test_wording_of_what_was_seen(self):
        known = format_strings()
        seen = [part for line in committed('default')[2:] if line[1].startswith('passes') for part in line[2].split('; ') if ' pass' not in part]
        self.assertGreater(len(seen), 20)
        self.assertEqual([], [part for part in seen if part.strip('; ') not in known], 'default.md: ' + RENEW)

    def test_wording_of_methods(self):
        ours, theirs = (next(line for line in table if line[0] == '`bdf2`') for table in (committed('methods'), cells(tables.methods(rows()))))
        for mine, wanted in zip(ours, theirs):
            self.assertEqual(mine.replace('passes by halving', 'passes'), wanted, 'methods.md: ' + RENEW)


if __name__ == '__main__':
    unittest.main()
