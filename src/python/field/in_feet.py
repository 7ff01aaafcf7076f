# SPDX-License-Identifier: BSD-3-Clause
"""Lengths in feet under a heading of metres: pipe that is added or taken away in a record has a length that joints and stands have in feet and not in metres."""
import numpy

LEAST_PIPE, LEAST_CONNECTIONS = 5.0, 2  # of pipe that is added or taken away at a time [m]
OF_PIPE = ((29.8, 34.0), (45.0, 130.0))  # lengths of joints and stands in feet that none of them has in metres: 30 to 33, and above 45
STANDS = 0.01  # by which the bit may move from row to row while pipe is added [m]
LIGHT = 0.5    # of the hook loads that the largest tenth exceeds, below which a string is taken to hang in the slips


def pipe_in_feet(record):
    """A line where the pipe that is added or taken away has a length that joints and stands have in feet and not in metres."""
    if "block_height" not in record and "block_velocity" not in record:
        return []
    lengths = numpy.abs(by_the_bit(record) if "bit_depth" in record else by_the_load(record) if "hook_load" in record else ())
    lengths = lengths[lengths > LEAST_PIPE]
    usual = float(numpy.median(lengths)) if len(lengths) >= LEAST_CONNECTIONS else 0.0
    signal = "block_height" if "block_height" in record else "block_velocity"
    return ["%s: %d times about %.3g m of pipe are added or taken away; joints and stands have 8 to 29 m or 35 to 43 m; is its unit ft?" %
            (signal, len(lengths), usual)] if any(low < usual < high for low, high in OF_PIPE) else []


def block_ways(record):
    """Of the block from row to row [m]; a speed is that of the way to its row."""
    if "block_height" in record:
        return numpy.diff(record.at("block_height", record.time))
    return record.at("block_velocity", record.time)[1:] * numpy.diff(record.time)


def by_the_bit(record):
    """Ways of the block while the bit stands [m]."""
    bit, block = numpy.diff(record.at("bit_depth", record.time)), block_ways(record)
    runs = numpy.flatnonzero(numpy.diff(numpy.concatenate(([True], numpy.abs(bit) > STANDS, [True]))))  # the bit stands between each second pair
    return numpy.array([block[begin:end].sum() for begin, end in zip(runs[::2], runs[1::2])])


def by_the_load(record):
    """Ways of the block from the last row with the string to the last one without it, of whole connections [m]."""
    loads, block = record.at("hook_load", record.time), block_ways(record)
    light = loads < LIGHT * numpy.quantile(loads, 0.9)
    edges = numpy.flatnonzero(numpy.diff(light.astype(int)))
    edges = edges[1:] if len(edges) and light[0] else edges
    return numpy.array([block[begin:end].sum() for begin, end in zip(edges[::2], edges[1::2])])
