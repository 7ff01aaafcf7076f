# SPDX-License-Identifier: BSD-3-Clause
"""What a page of the manual shows and runs: its blocks, and a folder of its own in which they are run. Needs no Sphinx.

A page is Markdown with these blocks, each between fences of three backticks:

    {file} NAME            a file that the reader writes
    {command} LINE         a command whose output is shown; the option `:status: 2` where it has to fail so
    {picture} FILE LINE    a picture that a command draws; without a command one of the package, from its root
    {shell}                commands of a session that are not run when the manual is built, only by test/manual/test_pages.py
"""
import os
import re
import subprocess

PACKAGE = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
SEEN = ('build', 'config', 'launch', 'test')  # folders of the package that a page's commands see from where they run
FENCE = re.compile(r'^```\{(file|command|picture|shell)\}[ \t]*(.*?)\n(.*?)^```$', re.DOTALL | re.MULTILINE)
LONGEST = 300.0  # that a command may take [s]


class Block:
    """`kind`, `argument` (name or command), `status` that the command has to end with, and the `content`."""

    def __init__(self, kind, argument, content):
        self.kind, self.argument = kind, argument.strip()
        option = re.match(r':status: *(\d+)\n', content)
        self.status = int(option.group(1)) if option else 0
        self.content = content[option.end():] if option else content


def blocks(text):
    """The blocks of a page in their order."""
    return [Block(*found) for found in FENCE.findall(text)]


def environment():
    """Where `drill` is found, and what it prints is as wide as a page."""
    programs = os.path.join(PACKAGE, 'build', 'devel', 'lib', 'drill_rig_sim')
    return {**os.environ, 'PATH': programs + os.pathsep + os.environ['PATH'], 'COLUMNS': '80'}


def workplace(page):
    """The folder of a page while the manual is made. It lies outside of the package: its links back would make a loop, in which roslaunch and rosrun,
    which look for programs below the package, would search without end."""
    return Workplace(os.path.join(os.environ['MANUAL_WORK'], page.replace('/', '_')))


class Workplace:
    """A folder in which a page's commands see the package as from its root, and which keeps what they write."""

    def __init__(self, folder):
        os.makedirs(folder, exist_ok=True)
        self.folder = folder
        for name in SEEN:
            link = os.path.join(folder, name)
            if not os.path.islink(link):
                os.symlink(os.path.join(PACKAGE, name), link)

    def write(self, name, content):
        with open(os.path.join(self.folder, name), 'w', encoding='utf-8') as out:
            out.write(content)

    def run(self, command, status=0):
        """What a command prints, errors with it. Raises ValueError where it ends otherwise than with `status`, or not at all."""
        try:
            done = subprocess.run(['bash', '-c', command], cwd=self.folder, env=environment(), stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                  text=True, timeout=LONGEST, check=False)
        except subprocess.TimeoutExpired as error:
            raise ValueError('%s: took longer than %g s' % (command, LONGEST)) from error
        if done.returncode != status:
            raise ValueError('%s: exit status %d, expected %d: %s' % (command, done.returncode, status, done.stdout.strip()))
        return done.stdout


def script(text):
    """All that a page shows, as one session of bash that ends at the first command that goes wrong."""
    lines = ['set -e -o pipefail']
    for block in blocks(text):
        if block.kind == 'file':
            lines.append("cat >'%s' <<'END_OF_FILE'\n%sEND_OF_FILE" % (block.argument, block.content))
        elif block.kind == 'shell':
            lines.append(block.content)
        elif block.kind == 'picture':
            lines.append('%s\n[ -s %s ]' % (block.argument.partition(' ')[2], block.argument.split()[0]))
        elif block.status:
            lines.append('status=0; %s || status=$?; [ $status = %d ]' % (block.argument, block.status))
        else:
            lines.append(block.argument)
    return '\n'.join(lines) + '\n'
