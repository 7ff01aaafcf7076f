#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The form of the manual's pages: what they lead to is there, a law has all its parts, lengths are what a reader takes in. Needs no package."""
import glob
import importlib
import os
import re
import sys
import tempfile
import unittest

SOURCE = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
PAGES = os.path.join(SOURCE, 'src', 'manual')
sys.dont_write_bytecode = True
sys.path[:0] = [PAGES, os.path.join(SOURCE, 'test', 'tool')]
import pages  # noqa: E402
import prepare  # noqa: E402
import test_readme  # noqa: E402

MADE = ('scene', 'commands', 'messages', 'services', 'launch', 'python') + tuple('laws_' + room.replace('/', '_') for room in prepare.LAWS)
MOST_WORDS, MOST_CELL_WORDS = 90, 25
PARTS_OF_A_LAW = (':label: ', '| symbol | meaning | unit |', '- Valid: ', '- Source: ', '- File: {repo}`')


def read(name):
    with open(os.path.join(PAGES, name), encoding='utf-8') as file:
        return file.read()


def names():
    """All pages written by hand, from the folder of the manual."""
    found = glob.glob(os.path.join(PAGES, '**', '*.md'), recursive=True)
    return sorted(os.path.relpath(path, PAGES) for path in found if os.path.basename(path) != 'README.md')


def prose(text):
    """Without blocks."""
    return re.sub(r'^```.*?^```$', '', text, flags=re.DOTALL | re.MULTILINE)


def paragraphs(text):
    """(paragraph, words) of what is neither table, list nor heading."""
    for paragraph in re.split(r'\n\s*\n', prose(text)):
        if paragraph.strip() and not re.match(r'\s*(\||- |\d+\. |#|<)', paragraph):
            yield paragraph.strip(), len(paragraph.split())


class Pages(unittest.TestCase):
    def test_links_lead_to_pages(self):
        count = 0
        for name in names():
            for target in re.findall(r'\]\(([^)#:]+)(?:#[^)]*)?\)', prose(read(name))):
                count += 1
                path = os.path.normpath(os.path.join(os.path.dirname(name), target))
                made = path.startswith('reference/') and os.path.splitext(os.path.basename(path))[0] in MADE
                self.assertTrue(made or os.path.isfile(os.path.join(PAGES, path)), '%s: %s' % (name, target))
        self.assertGreater(count, 30)

    def test_every_page_is_in_a_list_of_contents(self):
        listed = set()
        for name in names():
            for block in re.findall(r'```\{toctree\}\n(.*?)```', read(name), re.DOTALL):
                listed.update(os.path.normpath(os.path.join(os.path.dirname(name), line)) for line in block.split('\n') if re.match(r'[\w/]+$', line))
        self.assertEqual([], [name for name in names() if name[:-3] not in listed | {'index'}])
        self.assertEqual([], [name for name in MADE if 'reference/' + name not in listed and prepare.headers(name[5:].replace('_', '/'))])

    def test_files_that_are_named_exist(self):
        for name in names():
            for file in re.findall(r'\{repo\}`([^`%]+)`', read(name)) + [source for source in prepare.INCLUDE.findall(read(name)) if ' ' not in source]:
                self.assertTrue(os.path.exists(os.path.join(SOURCE, file)), '%s: %s' % (name, file))

    def test_there_are_guides(self):
        self.assertGreaterEqual(len([name for name in names() if name.startswith('how_to/')]), 21)

    def test_lengths(self):
        for name in names():
            for paragraph, words in paragraphs(read(name)):
                self.assertLessEqual(words, MOST_WORDS, '%s: %s' % (name, paragraph))
            for row in re.findall(r'^\|.*\|$', prose(read(name)), re.MULTILINE):
                for cell in row.split('|'):
                    self.assertLessEqual(len(cell.split()), MOST_CELL_WORDS, '%s: %s' % (name, cell))

    def test_each_law_has_all_its_parts(self):
        labels = []
        for name in names():
            if not name.startswith('theory/'):
                continue
            for section in re.split(r'^## ', read(name), flags=re.MULTILINE)[1:]:
                if '```{math}' in section:
                    labels += re.findall(r':label: (\S+)', section)
                    self.assertEqual(section.count('```{math}'), section.count(':label: '), '%s: %s' % (name, section[:40]))
                    self.assertEqual([], [part for part in PARTS_OF_A_LAW if part not in section], '%s: %s' % (name, section[:40]))
        self.assertGreater(len(labels), 45)
        self.assertEqual(len(labels), len(set(labels)))

    def test_yaml_of_a_page_can_be_read(self):
        yaml = importlib.import_module('yaml')
        for name in names():
            for text in re.findall(r'^```yaml\n(.*?)^```$', read(name), re.DOTALL | re.MULTILINE):
                self.assertTrue(yaml.safe_load(text), name)

    def test_commands_of_drill_take_their_options(self):
        if not test_readme.drill_program:
            self.skipTest('no drill')
        for name in names():
            for text in re.findall(r'^```bash\n(.*?)^```$', read(name), re.DOTALL | re.MULTILINE):
                for line in [re.sub(r'\s#.*', '', line).strip() for line in text.splitlines()]:
                    if line.split()[0] in ('drill', 'roslaunch'):
                        self.assertIsNone(test_readme.complaint(line), '%s: %s' % (name, line))

    def test_front_page_has_short_paragraphs(self):
        with open(os.path.join(SOURCE, 'README.md'), encoding='utf-8') as file:
            text = test_readme.own_words(file.read())
        for paragraph in re.split(r'\n\s*\n|\n- ', prose(text)):
            if not paragraph.strip().startswith('|'):
                self.assertLessEqual(len(paragraph.split()), MOST_WORDS, paragraph)


class Blocks(unittest.TestCase):
    TEXT = 'a\n```{file} b.py\nprint(1)\n```\n```{command} python3 b.py\n```\n```{command} false\n:status: 1\n```\n```{shell}\necho 2\n```\n'

    def test_blocks_in_order(self):
        found = pages.blocks(self.TEXT)
        self.assertEqual([('file', 'b.py', 0), ('command', 'python3 b.py', 0), ('command', 'false', 1), ('shell', '', 0)],
                         [(block.kind, block.argument, block.status) for block in found])
        self.assertEqual('print(1)\n', found[0].content)

    def test_script(self):
        with tempfile.TemporaryDirectory() as folder:
            place = pages.Workplace(folder)
            place.write('session', pages.script(self.TEXT))
            self.assertEqual('1\n2\n', place.run('bash session'))
            place.write('session', pages.script(self.TEXT.replace('false', 'true')))
            with self.assertRaisesRegex(ValueError, 'exit status 1, expected 0'):
                place.run('bash session')


if __name__ == '__main__':
    if len(sys.argv) > 1:
        test_readme.drill_program = os.path.abspath(sys.argv.pop(1))
    unittest.main()
