# SPDX-License-Identifier: BSD-3-Clause
"""The published and closed-form cases: runs their program, one group a process, and writes their table."""
import concurrent.futures
import csv
import os
import subprocess

TITLE = 'case, ours, published, relative difference, bound, source'

SKIPPED = 77  # exit status: all that were run hold, others were skipped
RANKS = (0, SKIPPED, 1, 2, 3)  # exit statuses of the program, the worst last; a signal's, not among them, is worse still


def rank(status):
    return RANKS.index(status) if status in RANKS else len(RANKS)


class Line:
    """One line of the program's output."""

    def __init__(self, group, text):
        self.group = group
        self.text = text
        self.holds = not text.endswith(' FAILED')
        self.skipped = text.split(', ')[1] == 'skipped'
        self.cells = [cell.strip() for cell in (text if self.holds else text[:-len(' FAILED')]).split(', ', 5)]

    def __str__(self):
        return self.text

    @property
    def used(self):
        """Share of the bound that the difference takes; 0 for a band, which holds or not."""
        difference, bound = float(self.cells[3].split()[0]), float(self.cells[4])
        return abs(difference) / bound if bound > 0.0 else 0.0


def run_group(program, group, place):
    """Output and exit status of a group; the output is kept in `place`."""
    done = subprocess.run([program, group], stdout=subprocess.PIPE, universal_newlines=True)
    with open(place, 'w') as out:
        out.write(done.stdout)
    return done.returncode


def run(program, folder, reuse):
    """All lines in the program's order, and the worst exit status (0, 77: cases were skipped, 1: one failed, 3: a group could not be run)."""
    os.makedirs(folder, exist_ok=True)
    groups = [line.split()[0] for line in subprocess.check_output([program, '--list'], universal_newlines=True).splitlines()]
    places = [os.path.join(folder, group + '.txt') for group in groups]
    status = 0
    if not reuse:
        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            status = max(pool.map(run_group, [program] * len(groups), groups, places), key=rank)
    lines = []
    for group, place in zip(groups, places):
        with open(place) as text:
            rows = text.read().splitlines()
        lines += [Line(group, row) for row in rows[1:] if row.count(', ') >= 5]
        if not rows or 'beyond their bounds' not in rows[-1]:
            print('\n'.join(rows[-1:]))
            status = 3
    if status == 0 and any(line.skipped for line in lines):
        status = SKIPPED
    return lines, status


def summarise(lines, out):
    """A row a group: how many cases, how many beyond their bounds, and the one that comes nearest to its bound."""
    out.write('| group | cases | beyond | nearest to its bound | ours | published | relative difference | bound |\n')
    out.write('| --- | --- | --- | --- | --- | --- | --- | --- |\n')
    for group in dict.fromkeys(line.group for line in lines):
        mine = [line for line in lines if line.group == group and not line.skipped]
        if not mine:
            out.write('| %s | skipped: no data | | | | | | |\n' % group)
            continue
        nearest = max(mine, key=lambda line: line.used)
        out.write('| %s | %d | %d | %s |\n' % (group, len(mine), sum(not line.holds for line in mine), ' | '.join(nearest.cells[:5])))


def write(lines, folder):
    """cases.csv; cases.md, all of them, and cases_by_group.md for README.md here."""
    with open(os.path.join(folder, 'cases_by_group.md'), 'w') as out:
        summarise(lines, out)
    with open(os.path.join(folder, 'cases.csv'), 'w', newline='') as out:
        table = csv.writer(out)
        table.writerow(TITLE.split(', '))
        table.writerows(line.cells for line in lines)
    with open(os.path.join(folder, 'cases.md'), 'w') as out:
        out.write('| case | ours | published | relative difference | bound | source |\n| --- | --- | --- | --- | --- | --- |\n')
        for line in lines:
            out.write('| ' + ' | '.join(line.cells) + (' |\n' if line.holds else ' **beyond** |\n'))
