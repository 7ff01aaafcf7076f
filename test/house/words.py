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
    r'\bcame loose\b': 'broke free',
    r'\bis no block\b': 'is a value, not a section',
    r'\bso many joints\b': 'that number of joints',
    r'\bis good\\n': 'OK',
}
# a line of C++ or Python counts by its texts between quotes
QUOTED = re.compile(r'"(?:[^"\\]|\\.)*"|\'(?:[^\'\\]|\\.)*\'')
TEXTS = ('.md', '.rst', '.msg', '.srv', '.action', '.launch', '.yaml', '.xml')
SOURCES = ('.cpp', '.h', '.py')
# comments of these headers are not held to it yet
NOT_LOOKED_AT = tuple('include/drill_rig_sim/%s/' % room for room in ('model', 'string', 'contact'))
NAMES = ('untold',)  # fields of files that programs of users read


def looked_at(file, text):
    """(number, what counts of the line) of a file's lines."""
    if file.endswith('CHANGELOG.rst'):
        text = re.split(r'^\d+\.\d+\.\d+.*$', text, flags=re.MULTILINE)[0]
    for number, line in enumerate(text.splitlines(), 1):
        if file.endswith(TEXTS) or (file.startswith('include/') and file.endswith('.h')):
            yield number, line
        elif file.endswith(SOURCES):
            yield number, ' '.join(quoted for quoted in QUOTED.findall(line) if quoted[1:-1] not in NAMES)


def faults(texts):
    """One line for each phrase that is never right in {file: text}, files named from the top of the package. Old entries of the changelog stay."""
    lines = []
    for file, text in sorted(texts.items()):
        if file.startswith(NOT_LOOKED_AT):
            continue
        for number, line in looked_at(file, text):
            for expression, instead in NEVER.items():
                found = re.search(expression, line)
                if found:
                    lines.append('%s:%d: "%s": %s' % (file, number, found.group(), instead))
    return lines
