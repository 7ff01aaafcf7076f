# SPDX-License-Identifier: BSD-3-Clause
"""Lengths of files and functions, and which are too long to be seen whole."""
import ast

import licence
import tokens

MOST_FILE_LINES = 400
MOST_FUNCTION_LINES = 60
MOST_COLUMNS = 130  # of C++
CPP = ('.cpp', '.h')
# what may be longer, 'file' or 'file:function', and why
ALLOWED = {}


def lines_of(text):
    """Lines of a file but the one of its licence."""
    return text.count('\n') + (not text.endswith('\n') and text != '') - (licence.LINE in text[:200])


def is_python(file, text):
    return file.endswith('.py') or (text.startswith('#!') and 'python' in text.split('\n', 1)[0])


def is_cpp(file):
    return file.endswith(CPP)


def python_functions(text):
    """(name, first line, lines) of each function, from its `def` on."""
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef)):
            yield node.name, node.lineno, node.end_lineno - node.lineno + 1


class CppScanner:
    """Finds functions by their brackets: good for the style of this code, no parser. One inside a function counts with that function."""

    def __init__(self, text):
        self.source = tokens.Source(text)
        self.tokens = self.source.tokens
        for token in self.tokens:
            if token.kind == 'operator' and token.text in '()[]{}' and token.partner is None:
                raise ValueError('line %d: %s has no partner' % (self.source.line_of(token.start), token.text))

    def functions(self):
        """(name, first line, lines) of each function, from its declaration's first line to the closing brace."""
        return self.in_scope(0, len(self.tokens))

    def is_operator(self, i, *texts):
        return 0 <= i < len(self.tokens) and self.tokens[i].kind == 'operator' and self.tokens[i].text in texts

    def in_scope(self, i, end):
        """Functions of a namespace, a class or a file: tokens i to end."""
        start = i
        while i < end:
            if self.is_operator(i, '(', '['):
                yield from self.lambdas(i, self.tokens[i].partner)
                i = self.tokens[i].partner
            elif self.is_operator(i, ';') or (self.is_operator(i, ':') and self.source.is_at(i - 1, 'public', 'protected', 'private')):
                start = i + 1
            elif self.is_operator(i, '{'):
                close, kind = self.tokens[i].partner, self.kind_of_block(start, i)
                if kind == 'scope':
                    yield from self.in_scope(i + 1, close)
                elif kind == 'function':
                    yield self.measured(self.name(start, i), start, close)
                elif kind == 'value':
                    yield from self.lambdas(i, close)
                if kind != 'value':
                    start = close + 1
                i = close
            i += 1

    def head(self, start, brace):
        """Indices of a declaration's tokens: without template parameters, alignas() and what stands in brackets."""
        kept, i = [], start
        while i < brace:
            if self.tokens[i].text == 'template' and self.is_operator(i + 1, '<'):
                i = self.end_of_angle(i + 1)
            elif self.tokens[i].text == 'alignas':
                i = self.tokens[i + 1].partner
            else:
                kept.append(i)
                if self.is_operator(i, '(', '[', '{'):
                    i = self.tokens[i].partner
            i += 1
        return kept

    def end_of_angle(self, i):
        """Index of the token that closes the angle bracket at i."""
        depth = 0
        while True:
            depth += {'<': 1, '>': -1, '>>': -2}.get(self.tokens[i].text, 0)
            if depth <= 0:
                return i
            i += 1

    def kind_of_block(self, start, brace):
        """What the brace opens: a scope, a function or a value."""
        head = self.head(start, brace)
        words = [self.tokens[i].text for i in head]
        if '=' in words and words[words.index('=') - 1] != 'operator':
            return 'value'
        if '(' not in words:
            return 'scope' if {'namespace', 'class', 'struct', 'union', 'extern'} & set(words) else 'value'
        # a member's value in a constructor's list stands right behind the member's name
        if ':' in words[words.index('('):] and (self.tokens[brace - 1].kind == 'name' or self.is_operator(brace - 1, '>')):
            return 'value'
        return 'function'

    def lambdas(self, i, end):
        """Functions without a name inside a value."""
        while i < end:
            if self.is_operator(i, '{'):
                begin = self.begin_of_lambda(i)
                if begin is not None:
                    yield self.measured('[]', begin, self.tokens[i].partner)
                    i = self.tokens[i].partner
            i += 1

    def begin_of_lambda(self, brace):
        """Index of the square bracket that begins a lambda with this body; None where it is no lambda's."""
        i = brace - 1
        while i >= 0 and (self.tokens[i].kind == 'name' or self.is_operator(i, '->', '::', '<', '>', '*', '&')):
            i -= 1
        if self.is_operator(i, ')'):
            i = self.tokens[i].partner - 1
        if not self.is_operator(i, ']'):
            return None
        begin = self.tokens[i].partner
        subscript = begin > 0 and (self.tokens[begin - 1].kind == 'name' and self.tokens[begin - 1].text != 'return'
                                   or self.is_operator(begin - 1, ')', ']'))
        return None if subscript else begin

    def name(self, start, brace):
        """A function's name, of a test macro with its arguments."""
        head = self.head(start, brace)
        last = next(i for i in head if self.is_operator(i, '(')) - 1
        first = next((i for i in head if self.tokens[i].text == 'operator'), last)
        if self.tokens[last].text == 'operator':  # operator()
            last = self.tokens[last + 1].partner
        while self.is_operator(first - 1, '::'):
            first = self.begin_of_angle(first - 2)
        if self.tokens[last].text.startswith('TEST'):
            last = self.tokens[last + 1].partner
        return ' '.join(self.source.between(first, last).split())

    def begin_of_angle(self, i):
        """Index of the name that has its template arguments up to token i; i itself where it has none."""
        depth = 0
        while True:
            depth += {'>': 1, '>>': 2, '<': -1}.get(self.tokens[i].text, 0)
            if depth <= 0:
                return i - 1 if self.is_operator(i, '<') else i
            i -= 1

    def measured(self, name, first, last):
        """(name, first line, lines) of tokens first to last."""
        line = self.source.line_of(self.tokens[first].start)
        return name, line, self.source.line_of(self.tokens[last].start) - line + 1


def functions(file, text):
    """(name, first line, lines) of each function of a C++ or Python file; of others none."""
    if is_cpp(file):
        return list(CppScanner(text).functions())
    return list(python_functions(text)) if is_python(file, text) else []


def faults(texts, allowed=None):
    """A line for each file of {file: text} and each function in it that is too long, and for each exception that nothing needs."""
    allowed = ALLOWED if allowed is None else allowed
    too_long = []
    for file in sorted(texts):
        text = texts[file]
        if lines_of(text) > MOST_FILE_LINES:
            too_long.append((file, '%s:1: %d lines, allowed: %d in a file' % (file, lines_of(text), MOST_FILE_LINES)))
        for number, line in enumerate(text.split('\n') if is_cpp(file) else [], 1):
            if len(line) > MOST_COLUMNS:
                too_long.append((file, '%s:%d: %d columns, allowed: %d in a line' % (file, number, len(line), MOST_COLUMNS)))
        try:
            found = functions(file, text)
        except (SyntaxError, ValueError) as error:
            too_long.append((file, '%s:1: cannot be read: %s' % (file, error)))
            continue
        for name, line, lines in found:
            if lines > MOST_FUNCTION_LINES:
                key = '%s:%s' % (file, name)
                too_long.append((key, '%s:%d: %s: %d lines, allowed: %d in a function' % (file, line, name, lines, MOST_FUNCTION_LINES)))
    needed = {key for key, _ in too_long}
    return ([line for key, line in too_long if key not in allowed] +
            ['%s: is short enough: take the exception out' % key for key in sorted(allowed) if key not in needed])
