# SPDX-License-Identifier: BSD-3-Clause
"""Which faults are tried: rooms by the tree, an order by the seed."""
import collections
import functools
import os
import random
import re

import builds
import mutants

LEFT_OUT = {'rviz', 'python'}  # plug-ins for a screen; what Python tests alone see
INCLUDE = re.compile(rb'^\s*#\s*include\s*"([^"]+)"', re.MULTILINE)


def room_of(file):
    """src/ROOM/... and include/PACKAGE/ROOM/... stand for the same room; None for anything else."""
    parts = file.split('/')
    inner = {'src': parts[1:], 'include': parts[2:]}.get(parts[0], [])
    return inner[0] if len(inner) > 1 and file.endswith(('.cpp', '.h')) and inner[0] not in LEFT_OUT else None


def rooms(files):
    """Files by room."""
    out = collections.defaultdict(list)
    for file in files:
        if room_of(file):
            out[room_of(file)].append(file)
    return dict(out)


@functools.lru_cache(None)
def units_of_headers():
    """How many .cpp files each header is compiled into."""
    files = set(builds.tree_files('src', 'include'))
    named = {}
    for file in files:
        includes = [name.decode() for name in INCLUDE.findall(builds.read(os.path.join(builds.SOURCE, file)))]
        named[file] = files & {path for name in includes for path in ('include/' + name, os.path.join(os.path.dirname(file), name))}
    units = collections.Counter()
    for file in files:
        if file.endswith('.cpp'):
            seen, waiting = set(), [file]
            while waiting:
                fresh = [f for f in named[waiting.pop()] if f not in seen]
                seen.update(fresh)
                waiting += fresh
            units.update(seen)
    return units


def draw(files, seed, room):
    """All faults of a room in the order in which they are tried: at random by weight of their kind, the second of a line after all firsts.

    A fault in a header costs as many compilations as units include it, and is drawn the more rarely.
    """
    units = units_of_headers()
    found = []
    for file in sorted(files):
        found += mutants.find(file, builds.read(os.path.join(builds.SOURCE, file)).decode())
    of_kind = collections.Counter(m.kind for m in found)
    chance = random.Random('%d/%s' % (seed, room))

    def place(mutant):
        weight = mutants.WEIGHTS[mutant.kind] / of_kind[mutant.kind]
        if mutant.file.endswith('.h'):
            weight *= min(1.0, 4.0 / max(1, units[mutant.file]))
        return chance.expovariate(weight)  # the first of several such clocks rings with a chance in proportion to its weight
    ordered = [mutant for _, _, mutant in sorted((place(m), i, m) for i, m in enumerate(found))]
    seen, firsts, others = set(), [], []
    for mutant in ordered:
        (others if (mutant.file, mutant.line) in seen else firsts).append(mutant)
        seen.add((mutant.file, mutant.line))
    return firsts + others
