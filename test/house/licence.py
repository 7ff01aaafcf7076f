#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Which sources do not name their licence. `licence.py` by itself writes the missing lines."""
import os
import subprocess

LINE = 'SPDX-License-Identifier: BSD-3-Clause'


def sign_of(file, text):
    """How a comment begins in a source; empty for what is none."""
    if file.endswith(('.cpp', '.h', '.js')):
        return '//'
    if file.endswith('.py') or text.startswith('#!') or os.path.basename(file) == 'CMakeLists.txt':
        return '#'
    return ''


def lacks(file, text):
    return sign_of(file, text) != '' and LINE not in '\n'.join(text.split('\n', 2)[:2])


def with_line(file, text):
    """The text with its licence, below the line that names its interpreter."""
    line = '%s %s\n' % (sign_of(file, text), LINE)
    if text.startswith('#!'):
        first, rest = text.split('\n', 1)
        return first + '\n' + line + rest
    return line + text


def faults(texts):
    """A line for each source of {file: text} without its licence."""
    return ['%s:1: no line "%s"; ./test/house/licence.py writes it' % (file, LINE) for file in sorted(texts) if lacks(file, texts[file])]


def main():
    """Writes the lines into all sources that git knows of."""
    source = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
    names = subprocess.run(['git', '-C', source, 'ls-files'], stdout=subprocess.PIPE, text=True, check=True).stdout.split('\n')
    for file in names:
        path = os.path.join(source, file)
        if not file.startswith(('include/', 'src/', 'launch/', 'test/', 'CMakeLists.txt', '.ci/')) or '/cases/' in file and not file.endswith(('.cpp', '.h', '.py')):
            continue
        if not os.path.isfile(path) or os.path.islink(path):
            continue
        try:
            with open(path, encoding='utf-8') as read:
                text = read.read()
        except UnicodeDecodeError:
            continue
        if lacks(file, text):
            with open(path, 'w', encoding='utf-8') as out:
                out.write(with_line(file, text))


if __name__ == '__main__':
    main()
