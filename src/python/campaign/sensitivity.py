# SPDX-License-Identifier: BSD-3-Clause
"""How much of an output's variance each factor makes: Sobol's indices from a design of kind saltelli, with confidence by bootstrap; rank correlations from others.

First order: V_i = mean of b (ab_i - a) (Saltelli et al., Comput. Phys. Comm. 181 (2010) 259, table 2 (b)); total: T_i = mean of (a - ab_i)^2 / 2 (Jansen, same
table (f)); both over the variance of a and b. ab_i is sample a with factor i from b.
"""
import numpy
from scipy.stats import spearmanr

REPEATS = 500  # of the bootstrap


def indices(outputs, factors, seed=0, level=0.95):
    """Rows (first order, half width, total, half width), one a factor, of the outputs of a saltelli design in its order; None where a tenth or more of its
    points have no output. Half widths: `level` of the bootstrap's normal spread."""
    values = numpy.asarray(outputs, dtype=float).reshape(factors + 2, -1)
    values = values[:, numpy.isfinite(values).all(axis=0)]
    if values.shape[1] < max(8, 0.9 * len(outputs) / (factors + 2)) or not numpy.var(values[:2]) > 0.0:
        return None
    first, total = estimates(values)
    chance, repeats = numpy.random.default_rng(seed), []
    for _ in range(REPEATS):
        repeats.append(estimates(values[:, chance.integers(0, values.shape[1], values.shape[1])]))
    width = normal_quantile(level) * numpy.nanstd(repeats, axis=0)
    return [tuple(map(float, row)) for row in zip(first, width[0], total, width[1])]


def estimates(values):
    """First-order and total indices of rows a, b, ab_1, ab_2, ..."""
    a, b, mixed = values[0], values[1], values[2:]
    centre = values[:2].mean()
    variance = values[:2].var()
    with numpy.errstate(invalid="ignore", divide="ignore"):
        return ((b - centre) * (mixed - a)).mean(axis=1) / variance, ((a - mixed)**2).mean(axis=1) / (2.0 * variance)


def normal_quantile(level):
    from scipy.special import ndtri
    return float(ndtri(0.5 + 0.5 * level))


def rank_correlations(columns, output):
    """Spearman's coefficient of each factor's column of numbers with the output; None where one of the two is constant or no number."""
    found = []
    for column in columns:
        try:
            pairs = numpy.array([(float(x), float(y)) for x, y in zip(column, output) if y is not None], dtype=float)
        except (TypeError, ValueError):
            found.append(None)
            continue
        pairs = pairs[numpy.isfinite(pairs).all(axis=1)] if len(pairs) else pairs
        varied = len(pairs) > 2 and numpy.ptp(pairs[:, 0]) > 0.0 and numpy.ptp(pairs[:, 1]) > 0.0
        found.append(float(spearmanr(pairs[:, 0], pairs[:, 1])[0]) if varied else None)
    return found
