# SPDX-License-Identifier: BSD-3-Clause
"""The reference of the Python modules, from their docstrings; nothing is imported."""
import ast
import os

from pages import PACKAGE

# what users import, in the order in which they meet it
MODULES = ('rig', 'sim', 'lockstep', 'law', 'control', 'topics', 'score', 'score_runs', 'recorder', 'survey', 'units')


def public(body, kinds):
    return [node for node in body if isinstance(node, kinds) and not node.name.startswith('_')]


def text_of(node):
    return ast.get_docstring(node) or ''


def as_block(text):
    """A docstring in Markdown: its paragraphs as they are, indented lines as code."""
    lines, in_code = [], False
    for line in text.splitlines():
        if line.startswith('    ') != in_code and line.strip():
            lines.append('```' if in_code else '```python')
            in_code = not in_code
        lines.append(line[4:] if in_code else line)
    return '\n'.join(lines + ['```'] * in_code)


def signature(node):
    arguments = ast.unparse(node.args)
    return '%s(%s)' % (node.name, arguments.replace('self, ', '').replace('self', ''))


def members(node):
    rows = ['| `%s` | %s |' % (signature(method).replace('|', '\\|'), ' '.join(text_of(method).split()).replace('|', '\\|'))
            for method in public(node.body, ast.FunctionDef) if text_of(method)]
    return '| method | |\n| --- | --- |\n%s\n' % '\n'.join(rows) if rows else ''


def module(name):
    with open(os.path.join(PACKAGE, 'src', 'python', name + '.py'), encoding='utf-8') as file:
        tree = ast.parse(file.read())
    parts = ['## drill_rig_sim.%s\n\n%s\n' % (name, as_block(text_of(tree)))]
    for node in public(tree.body, ast.ClassDef):
        bases = ', '.join(ast.unparse(base) for base in node.bases)
        parts.append('### class %s%s\n\n%s\n\n%s' % (node.name, '(%s)' % bases if bases else '', as_block(text_of(node)), members(node)))
    functions = [node for node in public(tree.body, ast.FunctionDef) if text_of(node)]
    if functions:
        parts.append('### functions of %s\n\n%s' % (name, members(ast.Module(body=functions, type_ignores=[]))))
    return '\n'.join(parts)


def page():
    return '# Python\n\nMade from the docstrings in {repo}`src/python`.\n\n%s' % '\n'.join(module(name) for name in MODULES)
