# SPDX-License-Identifier: BSD-3-Clause
"""What Sphinx makes of the blocks of pages.py, and the role `repo`, a file of the package that must be there."""
import os
import shutil

from docutils import nodes
from docutils.parsers.rst import Directive, directives
from pages import PACKAGE, workplace

QUICK = 'MANUAL_QUICK' in os.environ  # no commands are run: their output and pictures are left out
LANGUAGES = {'.py': 'python', '.yaml': 'yaml', '.cpp': 'cpp', '.launch': 'xml', '.test': 'xml', '.txt': 'text', '.csv': 'text'}


class OfPage(Directive):
    """A block whose commands run in the folder of its page."""

    def workplace(self):
        return workplace(self.state.document.settings.env.docname)

    def shown(self, text, language):
        literal = nodes.literal_block(text, text)
        literal['language'] = language
        literal['force'] = True
        return literal


class File(OfPage):
    has_content, required_arguments = True, 1

    def run(self):
        name = self.arguments[0]
        text = '\n'.join(self.content) + '\n'
        self.workplace().write(name, text)
        literal = self.shown(text, LANGUAGES.get(os.path.splitext(name)[1], 'text'))
        holder = nodes.container('', literal_block=True, classes=['literal-block-wrapper'])
        holder += nodes.caption('', name)
        holder += literal
        return [holder]


class Command(OfPage):
    required_arguments, final_argument_whitespace = 1, True
    option_spec = {'status': directives.nonnegative_int}

    def run(self):
        command = self.arguments[0]
        if QUICK:
            return [self.shown('$ ' + command, 'console')]
        try:
            output = self.workplace().run(command, self.options.get('status', 0))
        except ValueError as error:
            return [self.state.document.reporter.warning(str(error), line=self.lineno)]
        return [self.shown('$ %s\n%s' % (command, output), 'console')]


class Picture(OfPage):
    required_arguments, final_argument_whitespace = 1, True

    def run(self):
        file, _, command = self.arguments[0].partition(' ')
        env, place = self.state.document.settings.env, self.workplace()
        if command and QUICK:
            return []
        try:
            if command:
                place.run(command)
            name = '_pictures/%s_%s' % (env.docname.replace('/', '_'), os.path.basename(file))
            os.makedirs(os.path.join(env.srcdir, '_pictures'), exist_ok=True)
            shutil.copy(os.path.join(place.folder, file), os.path.join(env.srcdir, name))
        except (OSError, ValueError) as error:
            return [self.state.document.reporter.warning(str(error), line=self.lineno)]
        return [nodes.image('', uri='/' + name, alt=command or file)]


class Shell(OfPage):
    has_content = True

    def run(self):
        return [self.shown('\n'.join(self.content), 'bash')]


def repo(name, rawtext, text, lineno, inliner, options=None, content=()):  # pylint: disable=unused-argument,too-many-arguments
    """A file or folder of the package, named from its root."""
    if not os.path.exists(os.path.join(PACKAGE, text)):
        problem = inliner.reporter.warning('there is no %s' % text, line=lineno)
        return [inliner.problematic(rawtext, rawtext, problem)], [problem]
    return [nodes.literal(rawtext, text, classes=['repo'])], []


def setup(app):
    app.add_directive('file', File)
    app.add_directive('command', Command)
    app.add_directive('picture', Picture)
    app.add_directive('shell', Shell)
    app.add_role('repo', repo)
    return {'parallel_read_safe': True}
