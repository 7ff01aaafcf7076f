#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Every README of the package tells what is there: its blocks equal what commands print and files hold, its links, paths and commands
lead somewhere, and together they name the whole interface, every room and every picture.

Usage: test_readme.py PATH_TO_DRILL [--write [README ...]]; with --write, fills the blocks instead, of all or of those named.
A block stands between `<!-- begin: SOURCE -->` and `<!-- end -->`; SOURCE is a command or a file, seen from the package's root.
"""
import functools
import glob
import os
import re
import subprocess
import sys
import tempfile
import unittest

SOURCE = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
BLOCK = re.compile(r'(<!-- begin: (.+?) -->\n)(.*?)(<!-- end -->)', re.DOTALL)
FENCES = {'.py': '```python\n%s```\n', '.md': '%s'}
TREES = ('config', 'include', 'launch', 'msg', 'src', 'srv', 'test')  # paths in the texts that start so are files of the package
STRANGERS = ('.', 'dask-scheduler', 'dask-worker', 'export', 'rosbag', 'rosdep', 'rostopic')  # quoted commands of others that nothing here can check
LONGEST_FRONT_PAGE = 150  # lines of the first README that a reader takes in
drill_program = None


def read(*path):
    with open(os.path.join(SOURCE, *path)) as text:
        return text.read()


def readmes():
    """All of them, as paths from the package's root."""
    found = ['README.md'] + [path for tree in TREES for path in glob.glob(os.path.join(SOURCE, tree, '**', 'README.md'), recursive=True)]
    return [os.path.relpath(os.path.join(SOURCE, path), SOURCE) for path in found]


@functools.lru_cache(None)
def output_of(*words):
    """What a command of the package prints."""
    program = drill_program if words[0] == 'drill' else os.path.join(SOURCE, words[0])
    return subprocess.run([program] + list(words[1:]), cwd=SOURCE, stdout=subprocess.PIPE, check=True, universal_newlines=True,
                          timeout=60, env={**os.environ, 'COLUMNS': '80'}).stdout


def content(source):
    """What belongs into the block."""
    words = source.split()
    if len(words) == 1 and '.' in os.path.basename(source):
        return FENCES[os.path.splitext(source)[1]] % read(source)
    output = output_of(*words)
    return output.strip() + '\n' if source.startswith('drill reference') else '```\n%s\n```\n' % output.strip()


def write(names):
    for name in names:
        text = BLOCK.sub(lambda block: block.group(1) + content(block.group(2)) + block.group(4), read(name))
        with open(os.path.join(SOURCE, name), 'w') as out:
            out.write(text)


def own_words(text):
    """The text without what the blocks hold."""
    return BLOCK.sub('', text)


def anchors(text):
    """What a link can name behind `#`: the headings, as GitHub spells them."""
    headings = re.findall(r'^#+ (.+)$', re.sub(r'^```.*?^```', '', text, flags=re.DOTALL | re.MULTILINE), re.MULTILINE)
    return [re.sub(r'[^\w\- ]', '', heading.lower()).replace(' ', '-') for heading in headings]


def quoted(text):
    """Inline code, and the lines of shell examples without their comments."""
    shell = '\n'.join(re.findall(r'^```sh\n(.*?)^```', text, re.DOTALL | re.MULTILINE))
    lines = [re.sub(r'(^|\s)#.*', '', line).strip(' &') for line in shell.splitlines()]
    rest = re.sub(r'^```.*?^```', '', text, flags=re.DOTALL | re.MULTILINE)
    return [line for line in lines if line], re.findall(r'`([^`\n]+)`', rest)


def complaint(command):
    """What is wrong with a quoted command, None: nothing."""
    words = [word.strip('\'"') for word in command.split()]
    while re.match(r'[A-Z_]+=', words[0]):
        words.pop(0)
    name = words[0]
    if name == 'roslaunch':
        words = [word for word in words if word != '--ros-args']
        launch = read('launch', words[2]) if words[1] == 'drill_rig_sim' else ''
        unknown = [word for word in words[3:] if '<arg name="%s"' % word.split(':=')[0] not in launch]
        return 'no such argument: %s' % unknown if unknown or not launch else None
    if name == 'rosservice':
        known = words[2].split('/')[-1] in re.findall(r'^  ([/\w]+):', read('test', 'interface_contract.yaml'), re.MULTILINE)
        return None if known else 'no such service'
    if name == 'python3':
        return None if os.path.isfile(os.path.join(SOURCE, words[1])) else 'no such file'
    if name == 'rosrun':
        return None if os.access(os.path.join(SOURCE, 'src/tools', words[2]), os.X_OK) else 'no such program'
    if name in STRANGERS:
        return None
    if name != 'drill' and not os.access(os.path.join(SOURCE, name), os.X_OK):
        return 'no such command'
    helps = [name]
    if name == 'drill' and len(words) > 1 and not words[1].startswith('-'):
        if not re.search(r'^  %s ' % re.escape(words[1]), output_of('drill', '--help'), re.MULTILINE):
            return 'no such subcommand'
        helps.append(words[1])
    told = output_of(*helps, '--help')
    options = [word.split('=')[0] for word in words[1:] if re.match(r'--?[A-Za-z]', word)]
    unknown = [option for option in options if not re.search(r'(^|[\s,\[])%s\b' % re.escape(option), told)]
    return 'no such option: %s' % unknown if unknown else None


class Readmes(unittest.TestCase):
    maxDiff = None

    def each(self):
        self.assertGreater(len(readmes()), 7)
        return [(name, read(name)) for name in readmes()]

    def test_blocks_equal_their_sources(self):
        count = 0
        for name, text in self.each():
            self.assertEqual(text.count('<!-- begin:'), len(BLOCK.findall(text)))
            for _, source, inside, _ in BLOCK.findall(text):
                count += 1
                self.assertEqual(inside, content(source), '%s: fill the block by test/tool/test_readme.py DRILL --write' % source)
        self.assertGreater(count, 15)

    def test_links_lead_to_files_and_headings(self):
        for name, text in self.each():
            for target, anchor in re.findall(r'\]\(([^)#:]*)(?:#([^)]*))?\)', text):
                path = os.path.normpath(os.path.join(SOURCE, os.path.dirname(name), target)) if target else os.path.join(SOURCE, name)
                self.assertTrue(os.path.exists(path), '%s: %s' % (name, target))
                if anchor:
                    self.assertIn(anchor, anchors(read(path)), '%s: %s' % (name, target))

    def test_commands_exist_and_take_their_options(self):
        count = 0
        for name, text in self.each():
            shell, inline = quoted(own_words(text))
            for command in shell + [code for code in inline if re.match(r'(\./|drill |ros(launch|service|topic) |[A-Z_]+=\S+ \./)', code)]:
                count += 1
                self.assertIsNone(complaint(command), '%s: %s' % (name, command))
        self.assertGreater(count, 20)

    def test_paths_exist(self):
        for name, text in self.each():
            shell, inline = quoted(own_words(text))
            for word in {word.strip('\'"') for code in shell + inline for word in code.split()}:
                if re.fullmatch(r'(\./)?(%s)/[\w./-]*' % '|'.join(TREES), word):
                    self.assertTrue(os.path.exists(os.path.join(SOURCE, word)), '%s: %s' % (name, word))

    def test_every_readme_picture_and_table_is_led_to(self):
        shown = set()
        for name, text in self.each():
            for target in re.findall(r'\]\(([^)#:]+)', text):
                shown.add(os.path.normpath(os.path.join(os.path.dirname(name), target)))
            shown.update(source for _, source, _, _ in BLOCK.findall(text))
        pictures = [os.path.relpath(path, SOURCE) for path in glob.glob(os.path.join(SOURCE, 'test', '*', 'pictures', '*'))]
        self.assertGreater(len(pictures), 20)
        self.assertEqual([], [path for path in readmes()[1:] + pictures if path not in shown])

    def test_columns_of_the_time_series(self):
        with tempfile.TemporaryDirectory() as folder:
            series = os.path.join(folder, 'series.csv')
            output_of('drill', 'run', os.path.join('config', 'scenes', 'quick.yaml'), '--duration', '0.05', '--csv', series)
            with open(series) as file:
                self.assertIn('`%s`' % file.readline().strip(), read('src', 'tools', 'README.md'))

    def test_the_front_page_is_short(self):
        self.assertLessEqual(len(read('README.md').splitlines()), LONGEST_FRONT_PAGE)

    def test_the_front_page_has_the_figures_of_the_random_scenes(self):
        found = re.search(r'^\d+ scenes: [^;]*', read('test', 'accuracy', 'pictures', 'random.md'), re.MULTILINE).group()
        table = {kind: number for number, kind in re.findall(r'(\d+) (\w+)', found)}
        page = re.search(r'Of (\d+) \[random scenes\]\([^)]*\), (\d+) were right, (\d+) warned of, (\d+) warned of too late, (\d+) not decidable', read('README.md'))
        self.assertEqual(tuple(table.get(kind, '0') for kind in ('scenes', 'right', 'warned', 'missed', 'unknown')), page.groups())

    def test_every_room_is_named_and_includes_only_rooms_above_it(self):
        told = re.findall(r'^\| `(\w+)/` \|', read('include', 'drill_rig_sim', 'README.md'), re.MULTILINE)
        rooms = set()
        for place in (os.path.join('include', 'drill_rig_sim'), 'src'):
            for path in glob.glob(os.path.join(SOURCE, place, '*', '**', '*.[ch]*'), recursive=True):
                room = os.path.relpath(path, os.path.join(SOURCE, place)).split(os.sep)[0]
                rooms.add(room)
                if room == 'manual':  # texts, in no room
                    continue
                self.assertIn(room, told)
                included = re.findall(r'^#include [<"]([\w./]+)', read(path), re.MULTILINE)
                for name in [file.split('/')[1] for file in included if file.startswith('drill_rig_sim/') and file.count('/') > 1]:
                    self.assertIn(name, told[:told.index(room) + 1], path)
                self.assertFalse(room not in ('ros', 'rviz') and [file for file in included if file.startswith(('ros/', 'std_msgs/', 'tf2'))], path)
                self.assertFalse(room not in ('solve', 'reference', 'compared') and
                                 [file for file in included if re.match('(sundials|nvector|sunmatrix|sunlinsol|arkode|ida|kinsol)/', file)], path)
        self.assertGreater(len(rooms), 10)

    def test_the_whole_interface_is_named(self):
        text = read('msg', 'README.md')
        names = re.findall(r'^  ([/\w]+):', read('test', 'interface_contract.yaml'), re.MULTILINE)
        self.assertGreater(len(names), 30)
        names += ['~' + name for name in re.findall(r'read\.\w+\("(\w+)"', read('src', 'ros', 'parameters.cpp'))]
        self.assertEqual([], [name for name in names if '`%s`' % name not in text])

    def test_defaults_of_parameters(self):
        rows = [[cell.strip() for cell in line.split('|')[1:4]] for line in read('msg', 'README.md').splitlines() if line.startswith('| `~')]
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
    if sys.argv[1:] in ([], ['--help']):
        print(__doc__)
        sys.exit(0 if sys.argv[1:] else 2)
    drill_program = os.path.abspath(sys.argv.pop(1))
    if sys.argv[1:2] == ['--write']:
        write([os.path.relpath(path, SOURCE) for path in sys.argv[2:]] or readmes())
    else:
        unittest.main()
