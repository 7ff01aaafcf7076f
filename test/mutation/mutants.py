# SPDX-License-Identifier: BSD-3-Clause
"""Finds the small faults that can be put into a C++ text: each a Mutant, the text between two places and what takes its place.

What is written follows the house's format: a binary operator has white space on both sides, a template's bracket or a unary one not.
Left out: comments, strings, preprocessor lines, assertions, the profiler's calls, logging, and messages of what is thrown.
"""
import hashlib
import re

from tokens import Source

# How often each kind is drawn: like what a person gets wrong.
WEIGHTS = {
    'sign': 14, 'dropped statement': 14, 'dropped term': 14, 'dropped minus': 8, 'constant': 8, 'factor': 6, 'product': 6,
    'swapped arguments': 8, 'flipped comparison': 6, 'boundary': 3, 'equality': 4, 'logic': 5, 'negated condition': 6, 'swapped branches': 4, 'boolean': 4,
    'component': 6, 'function': 6, 'early return': 4}

SWAPS = {
    'sign': {'+': '-', '-': '+', '+=': '-=', '-=': '+='},
    'product': {'*': '/', '/': '*', '*=': '/=', '/=': '*='},
    'flipped comparison': {'<': '>', '>': '<', '<=': '>=', '>=': '<='},
    'boundary': {'<': '<=', '>': '>=', '<=': '<', '>=': '>'},
    'equality': {'==': '!=', '!=': '=='},
    'logic': {'&&': '||', '||': '&&'}}
FUNCTIONS = {'min': 'max', 'max': 'min', 'sin': 'cos', 'cos': 'sin', 'asin': 'acos', 'acos': 'asin', 'floor': 'ceil', 'ceil': 'floor',
             'front': 'back', 'back': 'front', 'min_element': 'max_element', 'max_element': 'min_element'}
COMPONENTS = {'x': 'y', 'y': 'x', 'z': 'y', 'UnitX': 'UnitY', 'UnitY': 'UnitZ', 'UnitZ': 'UnitX'}
SYMMETRIC = {'min', 'max', 'hypot', 'dot', 'mean', 'swap'}
ASSIGNMENTS = {'=', '+=', '-=', '*=', '/=', '%=', '|=', '&=', '^='}
END_OF_FACTOR = {'+', '-', '*', '/', '%', '<', '>', '<=', '>=', '==', '!=', '&&', '||', '?', ':', ';', ',', '=', '<<', '>>'} | ASSIGNMENTS
END_OF_TERM = END_OF_FACTOR - {'*', '/', '%'}
BEFORE_UNARY = {'(', '[', '{', ',', '=', '?', ':', '<', '>', '<=', '>=', '==', '!=', '&&', '||', '+', '-', '*', '/', '+=', '-=', '*=', '/='}
NOT_A_STATEMENT = {'return', 'throw', 'using', 'delete', 'goto', 'case', 'default', 'typedef', 'break', 'continue', 'if', 'for', 'while',
                   'do', 'else', 'switch', 'template', 'struct', 'class', 'enum', 'namespace', 'public', 'private', 'protected', 'friend'}
NOT_A_CALL = {'if', 'for', 'while', 'switch', 'catch', 'return', 'sizeof', 'decltype', 'noexcept', 'alignas', 'operator'}
AFTER_PARAMETERS = {')', 'const', 'noexcept', 'override', 'final', 'mutable'}
MUTED = re.compile(r'assert|static_assert|profiler_?|costs|ROS_\w+|cerr|stderr|throw|template|using|typedef|friend')


class Mutant:
    """text[start:end] becomes `replacement`."""
    __slots__ = ('file', 'kind', 'start', 'end', 'replacement', 'line', 'before', 'after')

    def __init__(self, file, source, kind, start, end, replacement):
        self.file, self.kind, self.start, self.end, self.replacement = file, kind, start, end, replacement
        self.line = source.line_of(start)
        last = source.line_of(end - 1) if end > start else self.line
        lines = '\n'.join(source.line(n) for n in range(self.line, last + 1))
        offset = start - source.text.rfind('\n', 0, start) - 1
        self.before = plain(lines)
        self.after = plain(lines[:offset] + replacement + lines[offset + end - start:])

    @property
    def name(self):
        """Same for the same fault in the same text."""
        return hashlib.sha1(('%s:%d:%d:%s' % (self.file, self.start, self.end, self.replacement)).encode()).hexdigest()[:8]

    def apply(self, text):
        return text[:self.start] + self.replacement + text[self.end:]


def plain(text):
    """On one line, white space of a single blank, a trailing comment left out."""
    return ' '.join(' '.join(re.sub(r'\s//.*', '', line) for line in text.split('\n')).split())


def find(file, text):
    """All mutants of a text; of a header those inside function bodies."""
    source = Source(text)
    allowed = function_bodies(source) if file.endswith('.h') else [True] * len(source.tokens)
    mute(source, allowed)
    found = []
    for generator in GENERATORS:
        for first, last, kind, start, end, replacement in generator(source):
            if all(allowed[first:last + 1]):
                found.append(Mutant(file, source, kind, start, end, replacement))
    return [m for m in found if m.before != m.after]


def function_bodies(source):
    """By token: whether it stands inside a function's body."""
    inside = [False] * len(source.tokens)
    for i, token in enumerate(source.tokens):
        if source.is_at(i, '{') and i > 0 and source.tokens[i - 1].text in AFTER_PARAMETERS and token.partner is not None:
            inside[i + 1:token.partner] = [True] * (token.partner - i - 1)
    return inside


def mute(source, allowed):
    """Takes out the statements that no numbers depend on."""
    for i, token in enumerate(source.tokens):
        if token.kind != 'name' or not MUTED.fullmatch(token.text):
            continue
        first = i if token.text in ('template', 'throw') else source.start_of_statement(i)  # what is thrown upon stays
        last = i + 1
        while last < len(source.tokens) and not source.is_at(last, ';', '{', '}'):
            last += 1
        allowed[first:last + 1] = [False] * (min(last + 1, len(allowed)) - first)


def of_token(source, i, kind, replacement):
    token = source.tokens[i]
    return i, i, kind, token.start, token.end, replacement


def beside_text(source, i):
    """Whether an operand of token i is a text: `+` then joins texts."""
    sides = [source.tokens[i - 1].kind, source.tokens[i + 1].kind]
    return 'string' in sides or 'char' in sides


def loop_heads(source):
    """Indices of the tokens in the brackets of a `for`."""
    inside = set()
    for i, token in enumerate(source.tokens[:-1]):
        if token.text == 'for' and source.tokens[i + 1].partner is not None:
            inside.update(range(i + 1, source.tokens[i + 1].partner))
    return inside


def operators(source):
    heads = loop_heads(source)
    for i, token in enumerate(source.tokens[:-1]):
        if token.kind != 'operator' or i == 0 or not source.spaced(i) or beside_text(source, i):
            continue
        for kind, texts in SWAPS.items():
            # a loop that reads one entry too many is the sanitizers' business
            if token.text in texts and not (kind == 'boundary' and i in heads):
                yield of_token(source, i, kind, texts[token.text])


def unary(source):
    for i, token in enumerate(source.tokens[:-1]):
        if token.kind != 'operator' or i == 0 or token.end != source.tokens[i + 1].start:
            continue
        before = source.tokens[i - 1]
        if token.text == '-' and (before.text == 'return' or before.kind == 'operator' and before.text in BEFORE_UNARY):
            yield of_token(source, i, 'dropped minus', '')
        if token.text == '!':
            yield of_token(source, i, 'boolean', '')


def scaled(number):
    """A wrong value for this literal; None where there is none to think of."""
    literal = re.fullmatch(r'(\d[\d\']*)([uUlLzZ]*)', number)
    if literal:
        value = int(literal.group(1).replace("'", ''), 8 if re.match(r"0\d", number) else 10)
        return str(value + 1) + literal.group(2)
    try:
        value = float(number.rstrip('fFlL').replace("'", ''))
    except ValueError:
        return None
    # small ones are tolerances: a tenth more of them is no likely fault
    wrong = 1.0 if value == 0.0 else value * 1000.0 if value < 1e-5 else value * 1.1
    return '%.12g' % wrong if '%.12g' % wrong != str(int(wrong)) else '%.1f' % wrong


def constants(source):
    for i, token in enumerate(source.tokens[:-1]):
        inner = i > 1 and source.is_at(i - 1, '[') and source.is_at(i + 1, ']') and source.tokens[i - 2].kind == 'name'
        template = source.is_at(i - 1, '<') and not source.spaced(i - 1) or source.is_at(i + 1, '>') and not source.spaced(i + 1)
        if token.kind == 'number' and inner:
            if re.fullmatch('[0-5]', token.text):
                yield of_token(source, i, 'component', '1' if token.text == '0' else str(int(token.text) - 1))
        elif token.kind == 'number' and not template:
            wrong = scaled(token.text)
            if wrong is not None:
                yield of_token(source, i, 'constant', wrong)
        elif token.kind == 'name' and token.text in ('true', 'false') and not source.is_at(i - 2, 'noexcept'):
            yield of_token(source, i, 'boolean', 'false' if token.text == 'true' else 'true')


def functions(source):
    for i, token in enumerate(source.tokens[:-1]):
        if token.kind != 'name' or not source.is_at(i + 1, '(') or source.is_at(i - 1, '>'):
            continue
        limits = i > 1 and source.is_at(i - 1, '::') and source.is_at(i - 2, '>')
        if token.text in FUNCTIONS and not limits:
            yield of_token(source, i, 'function', FUNCTIONS[token.text])
        if token.text in COMPONENTS and source.is_at(i - 1, '.', '::', '->'):
            yield of_token(source, i, 'component', COMPONENTS[token.text])


def sums_and_products(source):
    """A term of a sum, a factor of a product left out, with its sign."""
    for i, token in enumerate(source.tokens[:-1]):
        if token.kind != 'operator' or i == 0 or not source.spaced(i):
            continue
        for signs, kind, stops in ((('+', '-'), 'dropped term', END_OF_TERM), (('*', '/'), 'factor', END_OF_FACTOR)):
            if token.text not in signs:
                continue
            last = source.end_of_operand(i + 1, stops) - 1
            operand = source.tokens[i:last + 1]
            if last > i and not beside_text(source, i) and all(t.kind != 'string' for t in operand):
                yield i, last, kind, source.tokens[i - 1].end, source.tokens[last].end, ''


def statements(source):
    """A statement with a side effect left out, or a way out of a function."""
    for i, token in enumerate(source.tokens):
        if token.kind not in ('name', 'operator') or not begins_statement(source, i):
            continue
        last = source.end_of_operand(i, {';'})
        if not source.is_at(last, ';') or last == i:
            continue
        if token.text in ('return', 'continue', 'break'):
            if source.is_at(i - 1, ')'):
                yield i, last, 'early return', token.start, source.tokens[last].end, ';'
        elif has_effect(source, i, last):
            yield i, last, 'dropped statement', token.start, source.tokens[last].end, ';'


def begins_statement(source, i):
    """Whether a statement inside a function may begin at token i."""
    if i == 0 or source.tokens[i - 1].kind == 'string':
        return False
    if source.is_at(i - 1, ')'):
        opening = source.tokens[i - 1].partner
        return opening is not None and source.is_at(opening - 1, 'if', 'for', 'while')
    return source.is_at(i - 1, ';', '{', '}', 'else') and not source.is_at(i, '}', '{')


def has_effect(source, first, last):
    """Whether tokens first..last (a `;`) are an assignment, a count or a call: no declaration."""
    words = source.tokens[first:last]
    if words[0].text in NOT_A_STATEMENT or words[0].kind == 'operator' and words[0].text not in ('++', '--', '*', '('):
        return False
    if words[0].text in ('++', '--') or words[-1].text in ('++', '--'):
        return True
    assignment = source.end_of_operand(first, ASSIGNMENTS)
    target_end = assignment if assignment < last else source.end_of_operand(first, {';'})
    if any(a.kind == b.kind == 'name' for a, b in zip(source.tokens[first:target_end], source.tokens[first + 1:target_end])):
        return False
    target = source.between(first, target_end - 1)
    if re.search(r'[&*>]\s*\w+$', target) and words[0].text != '*' and '->' not in target:
        return False  # T& name = ..., vector<T> name = ...
    return assignment < last or words[-1].text == ')' and words[0].kind == 'name'


def arguments_of(source, opening):
    """First and last token of each argument in a pair of brackets."""
    closing = source.tokens[opening].partner
    out, first = [], opening + 1
    while first < closing:
        last = source.end_of_operand(first, {','})
        if last > closing or last == first:
            return []
        out.append((first, last - 1))
        first = last + 1
    return out


def swaps(source):
    """Two neighbouring arguments of a call, or of what braces hold, in each other's place."""
    for i, token in enumerate(source.tokens):
        braces = source.is_at(i, '{') and source.is_at(i - 1, 'return', '=', '(', ',')
        if token.partner is None or i == 0 or not (braces or called(source, i)):
            continue
        pairs = arguments_of(source, i)
        for (a, b), (c, d) in zip(pairs, pairs[1:]):
            left, right = source.between(a, b), source.between(c, d)
            if plain(left) != plain(right) and swappable(source, a, b) and swappable(source, c, d):
                yield i, d, 'swapped arguments', source.tokens[a].start, source.tokens[d].end, '%s, %s' % (right, left)


def called(source, i):
    before = source.tokens[i - 1]
    return source.is_at(i, '(') and before.kind == 'name' and before.text not in NOT_A_CALL | SYMMETRIC


def swappable(source, first, last):
    """A value: no parameter's declaration, no text, nothing long."""
    words = source.tokens[first:last + 1]
    if len(source.between(first, last)) > 80 or any(t.kind in ('string', 'char') or t.text in ('{', ';', 'const', '&') for t in words):
        return False
    return not any(a.kind == b.kind == 'name' or a.text in ('>', '*') and b.kind == 'name' and not source.spaced(first + k)
                   for k, (a, b) in enumerate(zip(words, words[1:])))


def conditions(source):
    for i, token in enumerate(source.tokens[:-1]):
        if source.is_at(i, 'if') and source.is_at(i + 1, '(') and source.tokens[i + 1].partner is not None:
            closing = source.tokens[i + 1].partner
            if any(source.is_at(k, '=') for k in range(i, closing)):
                continue  # it declares what it asks
            yield i, closing, 'negated condition', source.tokens[i + 1].start, source.tokens[closing].end, \
                '(!%s)' % source.between(i + 1, closing)
        if token.kind == 'operator' and token.text == '?':
            middle = source.end_of_operand(i + 1, {':', '?'})
            end = source.end_of_operand(middle + 1, {';', ',', '?', ':'}) if source.is_at(middle, ':') else i
            texts = any(t.kind in ('string', 'char') for t in source.tokens[i:end])
            if end > middle + 1 and source.is_at(end, ';', ',', ')', ']', '}') and not texts:
                yes, no = source.between(i + 1, middle - 1), source.between(middle + 1, end - 1)
                yield i, end - 1, 'swapped branches', source.tokens[i + 1].start, source.tokens[end - 1].end, '%s : %s' % (no, yes)


GENERATORS = (operators, unary, constants, functions, sums_and_products, statements, swaps, conditions)
