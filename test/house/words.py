# SPDX-License-Identifier: BSD-3-Clause
"""Phrases that are never right in a text of this package, and where they stand: a plain word exists for each."""
import re

# expression: what to write instead
NEVER = {
    r'\b(whoever|somebody|nobody|anybody)\b': 'what it is (a subscriber, a node, a caller), or the passive voice',
    r'\b(tells|told|says) so\b|\bsay so\b': 'reports it, warns of it',
    r'\buntold\b|\bwent untold\b': 'without a warning, not determined',
    r'\btold of\b': 'warned of',
    r'\bstanding topic': 'latched topic, topic of a state',
    r'\bwhat it bears\b|\bbears straight\b': 'critical buckling load, limit',
    r'\bkeeps? of (its|his) word\b': 'accuracy, measured error',
    r'\b(came|come|comes|breaks|broke|break) loose\b': 'breaks free',
    r'\btaken in parts\b': 'was rejected and subdivided',
    r'\bis no block\b': 'is a value, not a section',
    r'\bso many joints\b': 'that number of joints',
    r'\bis good\\n': 'OK',
}
TEXTS = ('.md', '.rst', '.msg', '.srv', '.action', '.launch', '.yaml', '.xml', '.cpp', '.h', '.py')
NAME = re.compile(r'\buntold\b')  # of a field of files that programs of users read
OF_THE_CHECK = ('test/house/words.py', 'test/tool/test_house.py')


def looked_at(file, text):
    """(number, line) of a file whose words are looked at, without names that stay."""
    if file.endswith('CHANGELOG.rst'):
        text = re.split(r'^\d+\.\d+\.\d+.*$', text, flags=re.MULTILINE)[0]
    if file.endswith(TEXTS) and file not in OF_THE_CHECK:
        for number, line in enumerate(text.splitlines(), 1):
            yield number, NAME.sub('', line) if file.endswith('.py') else line


def faults(texts):
    """One line for each phrase that is never right in {file: text}, files named from the top of the package. Old entries of the changelog stay."""
    lines = []
    for file, text in sorted(texts.items()):
        for number, line in looked_at(file, text):
            for expression, instead in NEVER.items():
                found = re.search(expression, line)
                if found:
                    lines.append('%s:%d: "%s": %s' % (file, number, found.group(), instead))
    return lines
