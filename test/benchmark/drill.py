# SPDX-License-Identifier: BSD-3-Clause
"""Runs the offline runner and reads what it writes."""
import json
import os
import subprocess

import numpy

import measure

# every name that a scene may give; what the program at hand does not know is left out and said
METHODS = ('bdf2', 'implicit_euler', 'linearly_implicit_euler', 'trbdf2', 'generalised_alpha', 'explicit', 'arkode_dirk', 'ida')
ELEMENTS = ('corotational', 'geometrically_exact', 'rotation_vector')


WALL_PER_CPU = 4.0  # of a busy machine: a run that has not ended in this number of times its CPU is ended


class Failed(Exception):
    """A run that ended without a result; the message says why."""


class Drill:
    def __init__(self, program, folder, reuse=False, cpu_limit=150):
        self.program = program
        self.folder = folder
        self.reuse = reuse  # what the folder holds of earlier runs
        self.cpu_limit = cpu_limit  # of one run [s]
        os.makedirs(folder, exist_ok=True)

    def call(self, words, cpu_limit=None):
        """What the program prints. A limit of CPU set by the system (RLIMIT_CPU) would make the child's own clock of CPU tick in milliseconds."""
        seconds = WALL_PER_CPU * (cpu_limit or self.cpu_limit)
        try:
            done = subprocess.run([self.program] + words, stdout=subprocess.PIPE, stderr=subprocess.PIPE, universal_newlines=True, timeout=seconds)
        except subprocess.TimeoutExpired:
            raise Failed('not ended after %g s' % seconds)
        if done.returncode < 0:
            raise Failed('ended by signal %d' % -done.returncode)
        if done.returncode != 0:
            raise Failed((done.stderr.strip() or 'exit status %d' % done.returncode).splitlines()[0])
        return done.stdout

    def run(self, name, scene, options=(), cpu_limit=None):
        """Runs a scene; returns columns by name and the summary. `name`: of the files it leaves in the folder. More CPU than the limit, as
        the summary tells it, is a failure."""
        csv, summary, failed = (os.path.join(self.folder, name + end) for end in ('.csv', '.json', '.failed'))
        if self.reuse and os.path.exists(failed):
            with open(failed) as file:
                raise Failed(file.read())
        if os.path.exists(failed):
            os.remove(failed)  # of an earlier run: this one may succeed
        if not (self.reuse and os.path.exists(summary) and os.path.getsize(summary)):
            try:
                self.call(['run', scene.path, '--duration', repr(scene.duration), '--every', repr(scene.every), '--csv', csv,
                           '--json', summary] + list(options), cpu_limit)
            except Failed as failure:
                with open(failed, 'w') as file:
                    file.write(str(failure))
                raise
        with open(summary) as file:
            done = json.load(file)
        if 'failure' in done:
            raise Failed(done['failure'])
        if done['cpu_s'] > (cpu_limit or self.cpu_limit):
            raise Failed('more than %g s of CPU' % (cpu_limit or self.cpu_limit))
        return read_series(csv), done

    def knows(self, scene, options):
        """Whether the program takes these options for a scene: ends with None, or with what it says against them."""
        try:
            self.call(['run', scene.path, '--duration', '0.02'] + list(options))
        except Failed as refusal:
            return str(refusal)
        return None


def read_series(path):
    """Columns by name. Numbers that are not finite are a failure."""
    with open(path) as file:
        names = file.readline().strip().split(',')
        columns = [names.index(name) for name in measure.COLUMNS]
        table = numpy.loadtxt(file, delimiter=',', usecols=columns, ndmin=2)
    if not numpy.isfinite(table).all():
        raise Failed('numbers that are not finite')
    return dict(zip(measure.COLUMNS, table.T))
