# SPDX-License-Identifier: BSD-3-Clause
"""C++ text into tokens, as far as mutations need it: comments and preprocessor lines are left out, brackets know their partners."""
import bisect
import re

TOKEN = re.compile(r'''
    (?P<comment>//(?:\\\n|[^\n])*|/\*.*?\*/)
  | (?P<directive>(?<![^\n])[ \t]*\#(?:\\\n|[^\n])*)
  | (?P<string>(?:u8|[uUL])?R"(?P<tag>[^()\s\\]*)\(.*?\)(?P=tag)"|(?:u8|[uUL])?"(?:\\.|[^"\\\n])*")
  | (?P<char>'(?:\\.|[^'\\\n])+')
  | (?P<number>\.?\d(?:[eEpP][+-]|'(?=\w)|[\w.])*)
  | (?P<name>[A-Za-z_]\w*)
  | (?P<operator><<=|>>=|->\*|\.\.\.|::|->|\+\+|--|<<|>>|<=|>=|==|!=|&&|\|\||[-+*/%&|^]=|[-+*/%<>=!&|^~?:;,.(){}\[\]])
''', re.VERBOSE | re.DOTALL)
OPENING = {'(': ')', '[': ']', '{': '}'}
CLOSING = set(OPENING.values())


class Token:
    """A piece of the text; `partner` is the index of the bracket that closes or opens this one."""
    __slots__ = ('kind', 'text', 'start', 'end', 'partner')

    def __init__(self, kind, text, start):
        self.kind, self.text, self.start, self.end, self.partner = kind, text, start, start + len(text), None


class Source:
    """A file's text and tokens."""

    def __init__(self, text):
        self.text = text
        self.tokens = [Token(m.lastgroup if m.lastgroup != 'tag' else 'string', m.group(), m.start()) for m in TOKEN.finditer(text)]
        self.tokens = [t for t in self.tokens if t.kind not in ('comment', 'directive')]
        self._line_starts = [0] + [m.end() for m in re.finditer('\n', text)]
        open_ones = []
        for i, token in enumerate(self.tokens):
            if token.kind != 'operator':
                continue
            if token.text in OPENING:
                open_ones.append(i)
            elif token.text in CLOSING and open_ones:
                token.partner = open_ones.pop()
                self.tokens[token.partner].partner = i

    def line_of(self, place):
        """Number of the line that holds this place of the text, from 1."""
        return bisect.bisect_right(self._line_starts, place)

    def line(self, number):
        """A line's text without its end."""
        first = self._line_starts[number - 1]
        last = self.text.find('\n', first)
        return self.text[first:last if last >= 0 else len(self.text)]

    def is_at(self, i, *texts):
        """Whether token i is one of these (not as a string's or character's content)."""
        return 0 <= i < len(self.tokens) and self.tokens[i].text in texts

    def between(self, first, last):
        """The text from token `first` to token `last`, both included."""
        return self.text[self.tokens[first].start:self.tokens[last].end]

    def spaced(self, i):
        """Whether white space stands on both sides: so are binary operators written, and nothing else."""
        before, token, after = self.tokens[i - 1], self.tokens[i], self.tokens[i + 1]
        return before.end < token.start and token.end < after.start

    def end_of_operand(self, i, stops):
        """Index of the first token from i on, outside of inner brackets, that is one of `stops` or closes a bracket around it."""
        while i < len(self.tokens):
            token = self.tokens[i]
            if token.kind == 'operator':
                if token.text in OPENING and token.partner is not None:
                    i = token.partner
                elif token.text in CLOSING or (token.text in stops and (token.text in UNSPACED or self.spaced(i))):
                    return i
            i += 1
        return i

    def start_of_statement(self, i):
        """Index of the first token of the statement that holds token i."""
        while i > 0:
            before = self.tokens[i - 1]
            if before.text in (';', '{', '}') and before.kind == 'operator':
                return i
            i = before.partner if before.text in (')', ']') and before.partner is not None else i - 1
        return 0


UNSPACED = {';', ','}
