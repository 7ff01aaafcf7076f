# SPDX-License-Identifier: BSD-3-Clause
"""Which values the runs of a campaign take: grid, list, Latin hypercube, Sobol's sequence, and the pairs of samples that Sobol's indices need."""
import itertools
import math

import numpy
from drill_rig_sim.campaign.measures import with_unit
from scipy.stats import qmc

KINDS = {"grid": "every value with every other", "list": "the first values together, then the second ones", "latin_hypercube": "scipy.stats.qmc.LatinHypercube",
         "sobol": "scipy.stats.qmc.Sobol, scrambled", "saltelli": "two samples of Sobol's sequence and their mixtures, for first-order and total indices"}


class DesignError(Exception):
    """What is wrong with a design, in one line."""


class Factor:
    """What changes from run to run: `values` one after the other, or a range from `low` to `high`, in equal steps of it or (`log`) of its logarithm. Values of
    a range with a `unit` are texts such as 9.5 ppg."""

    def __init__(self, name, values=None, low=None, high=None, log=False, unit=""):
        self.name, self.values, self.low, self.high, self.log, self.unit = name, values, low, high, log, unit

    def at(self, share):
        """The value so far along, share in 0..1."""
        if self.values is not None:
            return self.values[min(int(share * len(self.values)), len(self.values) - 1)]
        if self.log:
            return with_unit(float(math.exp(math.log(self.low) + share * (math.log(self.high) - math.log(self.low)))), self.unit)
        return with_unit(float(self.low + share * (self.high - self.low)), self.unit)

    def shared_out(self, number):
        """So many values, ends included; all of them where they are listed."""
        if self.values is not None:
            return self.values
        return [self.at(share) for share in (numpy.linspace(0.0, 1.0, number) if number > 1 else [0.5])]


def rows_of(factors, kind, runs=0, steps=0, seed=0):
    """Rows of values, one run each, in the factors' order. `runs`: how many, of latin_hypercube and sobol; of saltelli how many in each of the two samples,
    (factors + 2) times as many runs in all. `steps`: values of each range in a grid or list. The same for the same seed."""
    if kind == "grid":
        return [list(row) for row in itertools.product(*(factor.shared_out(steps) for factor in factors))]
    if kind == "list":
        columns = [factor.shared_out(steps) for factor in factors]
        if len({len(column) for column in columns}) > 1:
            raise DesignError("a list needs the same number of values for each factor; there are %s" % ", ".join("%d of %s" % (len(c), f.name) for c, f in zip(columns, factors)))
        return [list(row) for row in zip(*columns)]
    return [[factor.at(share) for factor, share in zip(factors, row)] for row in shares_of(len(factors), kind, runs, seed)]


def shares_of(factors, kind, runs, seed):
    """Points of the unit cube."""
    if kind == "latin_hypercube":
        return qmc.LatinHypercube(factors, seed=seed).random(runs)
    if kind == "sobol":
        return sobol(factors, runs, seed)
    both = sobol(2 * factors, runs, seed)
    a, b = both[:, :factors], both[:, factors:]
    mixed = [numpy.where(numpy.arange(factors) == k, b, a) for k in range(factors)]
    return numpy.concatenate([a, b, *mixed])


def sobol(factors, runs, seed):
    """The first `runs` points: balanced where that is a power of two."""
    sequence = qmc.Sobol(factors, scramble=True, seed=seed)
    return sequence.random_base2(max(1, math.ceil(math.log2(max(runs, 2)))))[:runs]
