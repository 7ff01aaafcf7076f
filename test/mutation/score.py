# SPDX-License-Identifier: BSD-3-Clause
"""What became of each mutant: a file of JSON lines, the table by room, the survivors and what is argued about them."""
import glob
import json
import os
import re

GOAL_OF_ROOM, GOAL_OVER_ALL = 0.8, 0.9
ARGUED = re.compile(r'- `([^`]+)`: `([^`]*)` => `([^`]*)`: (.+)')


class Record:
    """The state file of one seed: a line about the run, then one for each mutant tried. Later lines replace earlier ones."""

    def __init__(self, path):
        self.path, self.head, self.results = path, None, {}
        if os.path.isfile(path):
            with open(path, 'r+') as file:
                text = file.read()
                if text and not text.endswith('\n'):
                    file.write('\n')  # the end of a run that was cut off
            for line in text.splitlines():
                try:
                    self._take(json.loads(line))
                except ValueError:
                    pass

    def _take(self, entry):
        if 'seed' in entry:
            self.head = entry
        else:
            self.results[entry['room'], entry['index']] = entry

    def add(self, entry):
        self._take(entry)
        with open(self.path, 'a') as file:
            file.write(json.dumps(entry) + '\n')

    def of_room(self, room):
        return [r for (of, _), r in sorted(self.results.items()) if of == room]

    def counted(self, room):
        """Those that compile to something else."""
        return [r for r in self.of_room(room) if r['result'] in ('caught', 'survived')]


def latest(folder):
    """The newest state file in a folder; None if there is none."""
    found = glob.glob(os.path.join(folder, 'seed_*.jsonl'))
    return max(found, key=os.path.getmtime) if found else None


def read_argued(path):
    """[(file, before, after, reason)] of the lines like "- `file`: `before` => `after`: reason"."""
    out = []
    if path and os.path.isfile(path):
        with open(path) as file:
            for line in file:
                match = ARGUED.match(line.strip())
                if match:
                    out.append(match.groups())
    return out


def argument(argued, result):
    """The reason given for a survivor; None if there is none. Line numbers move, so the texts decide."""
    for file, before, after, reason in argued:
        if (file, before, after) == (result['file'], result['before'], result['after']):
            return reason
    return None


def share(caught, counted):
    return '%4.0f %%' % (100.0 * caught / counted) if counted else '   -  '


def report(record, argued):
    """The report's text, and whether the goals are reached."""
    rooms = sorted({room for room, _ in record.results})
    lines = ['seed %s' % record.head['seed'], '', '%-12s %8s %8s %8s %8s %8s' % ('room', 'mutants', 'caught', 'score', 'argued', 'void')]
    reached, all_counted, all_caught, survivors = True, 0, 0, []
    for room in rooms:
        counted = record.counted(room)
        caught = sum(r['result'] == 'caught' for r in counted)
        alive = [r for r in counted if r['result'] == 'survived']
        survivors += alive
        named = sum(argument(argued, r) is not None for r in alive)
        void = len(record.of_room(room)) - len(counted)
        lines.append('%-12s %8d %8d %8s %8d %8d' % (room, len(counted), caught, share(caught, len(counted)), named, void))
        all_counted, all_caught = all_counted + len(counted), all_caught + caught
        reached = reached and bool(counted) and caught >= GOAL_OF_ROOM * len(counted) and named == len(alive)
    reached = reached and all_caught >= GOAL_OVER_ALL * all_counted
    lines.append('%-12s %8d %8d %8s' % ('all', all_counted, all_caught, share(all_caught, all_counted)))
    lines += ['', 'void: does not compile, or compiles to the same', '']
    lines += ['%d survivors' % len(survivors)] + [text for r in survivors for text in described(r, argument(argued, r))]
    lines += ['', 'goals (every room %.0f %%, all %.0f %%, each survivor argued): %s'
              % (100 * GOAL_OF_ROOM, 100 * GOAL_OVER_ALL, 'reached' if reached else 'not reached')]
    return '\n'.join(lines), reached


def listed(tests, most=6):
    if not tests:
        return 'none applies'
    return ', '.join(tests[:most]) + (' and %d more' % (len(tests) - most) if len(tests) > most else '')


def described(result, reason):
    """A survivor: place, fault, the line for the file of arguments, the tests that let it pass."""
    to_argue = 'not yet; to argue: - `%s`: `%s` => `%s`: REASON' % (result['file'], result['before'], result['after'])
    return ['', '%s:%d: %s' % (result['file'], result['line'], result['kind']), '  - ' + result['before'], '  + ' + result['after'],
            '  tests: ' + listed(result['tests']), '  argued: ' + (reason or to_argue)]
