# SPDX-License-Identifier: BSD-3-Clause
"""Puts the sources of the manual together: the pages written by hand, and those made from programs, messages and files.

Usage: prepare.py FOLDER, or prepare.py --headers: the headers of the laws, which doxygen reads.
In a page written by hand `<!-- include: SOURCE -->` stands for a table of the package (.md) or what a command of it prints.
"""
import glob
import os
import re
import sys
import xml.etree.ElementTree

import python_api
from pages import PACKAGE, workplace

PAGES = os.path.join(PACKAGE, 'src', 'manual')
INCLUDE = re.compile(r'^<!-- include: (.+?) -->$', re.MULTILINE)
LINK = re.compile(r'\[([^\]]*)\]\([^)]*\)')
# rooms of the headers that hold laws, and what is left out of them
LAWS = ('well', 'contact', 'string', 'rig', 'hydraulics', 'model/forces', 'accuracy')
NO_LAWS = ('lists.h', '_text.h')  # the latter are templates with macros, which Breathe cannot read
# of a header: neither its namespace, which every other header declares too, nor its macros
SECTIONS = ('briefdescription detaileddescription typedef enum var func innerclass public-type public-attrib public-static-attrib public-func '
            'public-static-func')
# programs whose --help is shown, from the package's root
PROGRAMS = ('launch/demo', 'test/run', 'src/manual/run')


def headers(room):
    found = sorted(glob.glob(os.path.join(PACKAGE, 'include', 'drill_rig_sim', room, '*.h')))
    return [path for path in found if not path.endswith(NO_LAWS)]


def read(*path):
    with open(os.path.join(PACKAGE, *path), encoding='utf-8') as file:
        return file.read()


def included(source, place):
    """The text of an include; links lead out of the manual there, so only their words are left."""
    if ' ' not in source and source.endswith('.md'):
        return LINK.sub(r'\1', read(source))
    return '```text\n%s```\n' % place.run(source)


def page(title, text, *parts):
    return '# %s\n\n%s\n\n%s' % (title, text, '\n'.join(parts))


def scene_reference(place):
    text = re.sub('^### ', '## ', place.run('drill reference'), flags=re.MULTILINE)
    return page('Keys of a scene', 'Made from `drill reference`. {repo}`config/scenes/template.yaml` has every key in its place.', text)


def commands(place):
    names = re.findall(r'^  (\w+)  ', place.run('drill --help').split('Subcommands:')[1], re.MULTILINE)
    lines = ['drill --help'] + ['drill %s --help' % name for name in names] + [os.path.join(PACKAGE, name) + ' --help' for name in PROGRAMS]
    parts = ['## `%s`\n\n```text\n%s```\n' % (os.path.relpath(line.split(' --')[0], PACKAGE) if line.startswith('/') else line.rsplit(' ', 1)[0],
                                            place.run(line)) for line in lines]
    return page('Commands', 'Made from what each command prints for `--help`.', *parts)


def definitions(folder, title):
    parts = ['## %s\n\n```text\n%s```\n' % (os.path.splitext(name)[0], read(folder, name)) for name in sorted(os.listdir(os.path.join(PACKAGE, folder)))
             if name.endswith('.' + folder)]
    return page(title, 'Made from the files in {repo}`%s`. SI units and radians throughout.' % folder, *parts)


def launch_arguments():
    root = xml.etree.ElementTree.fromstring(read('launch', 'rig.launch'))
    rows = ['| `%s` | `%s` | %s |' % (arg.get('name'), arg.get('default') or '""', arg.get('doc').replace('|', '\\|')) for arg in root.findall('arg')]
    return page('Arguments of rig.launch', 'Made from {repo}`launch/rig.launch`.', '| argument | default | meaning |\n| --- | --- | --- |', *rows)


def laws_in_cpp(room):
    parts = ['## %s\n\n```{doxygenfile} %s\n:no-link:\n:sections: %s\n```\n' % (
        os.path.basename(path), os.path.relpath(path, os.path.join(PACKAGE, 'include')), SECTIONS)
             for path in headers(room)]
    return page('Headers of %s' % room, 'Made from the headers in {repo}`include/drill_rig_sim/%s` by Doxygen.' % room, *parts)


def write(folder, name, text):
    path = os.path.join(folder, name)
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path, 'w', encoding='utf-8') as out:
        out.write(text)


def prepare(folder):
    place = workplace('reference')
    for path in glob.glob(os.path.join(PAGES, '**', '*.md'), recursive=True):
        name = os.path.relpath(path, PAGES)
        if name != 'README.md':
            write(folder, name, INCLUDE.sub(lambda found: included(found.group(1), place), read(path)))
    made = {'scene': scene_reference(place), 'commands': commands(place), 'messages': definitions('msg', 'Messages'),
            'services': definitions('srv', 'Services'), 'launch': launch_arguments(), 'python': python_api.page()}
    made.update({'laws_' + room.replace('/', '_'): laws_in_cpp(room) for room in LAWS if headers(room)})
    for name, text in made.items():
        write(folder, 'reference/%s.md' % name, text)


if __name__ == '__main__':
    if sys.argv[1:] == ['--headers']:
        print(' '.join(path for law_room in LAWS for path in headers(law_room)))
    elif len(sys.argv) == 2:
        prepare(os.path.abspath(sys.argv[1]))
    else:
        sys.exit(__doc__)
