# SPDX-License-Identifier: BSD-3-Clause
"""Runs of rows that are alike."""
import numpy


def spans(flags):
    """(first, last + 1) of each run of true ones."""
    edges = numpy.flatnonzero(numpy.diff(numpy.concatenate(([0], flags.astype(int), [0]))))
    return list(zip(edges[::2], edges[1::2]))
