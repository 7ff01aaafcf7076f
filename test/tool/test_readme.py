#!/usr/bin/python3
"""The README tells what is there: its blocks equal what commands print and files hold, its tables name the whole interface.

Usage: test_readme.py PATH_TO_DRILL [--write]; with --write, fills the blocks instead.
A block stands between `<!-- begin: SOURCE -->` and `<!-- end -->`; SOURCE is a command of the repository or a file.
"""
import os
import re
import subprocess
import sys
import unittest

SOURCE = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
README = os.path.join(SOURCE, 'README.md')
BLOCK = re.compile(r'(<!-- begin: (.+?) -->\n)(.*?)(<!-- end -->)', re.DOTALL)
FENCES = {'.py': '```python\n%s```\n', '.md': '%s'}
drill_program = None


def read(*path):
    with open(os.path.join(SOURCE, *path)) as text:
        return text.read()


def content(source):
    """What belongs into the block."""
    words = source.split()
    if len(words) == 1 and '.' in os.path.basename(source):
        return FENCES[os.path.splitext(source)[1]] % read(source)
    program = drill_program if words[0] == 'drill' else os.path.join(SOURCE, words[0])
    output = subprocess.run([program] + words[1:], cwd=SOURCE, stdout=subprocess.PIPE, check=True, universal_newlines=True,
                            timeout=60).stdout
    return output.strip() + '\n' if source == 'drill reference' else '```\n%s```\n' % output


def write():
    text = BLOCK.sub(lambda block: block.group(1) + content(block.group(2)) + block.group(4), read('README.md'))
    with open(README, 'w') as out:
        out.write(text)


class Readme(unittest.TestCase):
    maxDiff = None

    def test_blocks_equal_their_sources(self):
        blocks = BLOCK.findall(read('README.md'))
        self.assertGreater(len(blocks), 5)
        for _, source, inside, _ in blocks:
            self.assertEqual(inside, content(source), '%s: fill the block by test/tool/test_readme.py DRILL --write' % source)

    def test_links_lead_to_files(self):
        for target in re.findall(r'\]\(([^)#]+)\)', read('README.md')):
            self.assertTrue(os.path.exists(os.path.join(SOURCE, target)), target)

    def test_the_whole_interface_is_named(self):
        text = read('README.md')
        names = re.findall(r'^  ([/\w]+):', read('test', 'interface_contract.yaml'), re.MULTILINE)
        self.assertGreater(len(names), 30)
        names += ['~' + name for name in re.findall(r'read\.\w+\("(\w+)"', read('src', 'ros', 'parameters.cpp'))]
        self.assertEqual([], [name for name in names if '`%s`' % name not in text])

    def test_defaults_of_parameters(self):
        rows = [[cell.strip() for cell in line.split('|')[1:4]] for line in read('README.md').splitlines() if line.startswith('| `~')]
        told = {}
        for names, defaults, _ in rows:
            for name, default in zip(re.findall(r'`~(\w+)`', names), defaults.split(',')):
                told[name] = default.strip(' `')
        declared = re.findall(r'^  double (\w+) = ([-+.\de]+);', read('include', 'drill_rig_sim', 'ros', 'parameters.h'), re.MULTILINE)
        self.assertGreater(len(declared), 7)
        for name, default in declared:
            if told[name] != '~rate':
                self.assertEqual(float(told[name]), float(default), name)


if __name__ == '__main__':
    drill_program = os.path.abspath(sys.argv.pop(1))
    if sys.argv[1:] == ['--write']:
        write()
    else:
        unittest.main()
