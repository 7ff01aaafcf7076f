# SPDX-License-Identifier: BSD-3-Clause
"""A part of a record, and stretches of it that are not compared."""
import copy
import math

import numpy
from drill_rig_sim.field.dates import seconds_of
from drill_rig_sim.field.record import RecordError


def moment(text, record, option):
    """Seconds in the record, of a number or an ISO date, without a time zone by that of the record's header. RecordError naming the option."""
    try:
        seconds = float(text)
        if math.isfinite(seconds):
            return seconds
    except ValueError:
        pass
    found = seconds_of(text)
    if found is None:
        raise RecordError("%s: '%s' is neither seconds in the record nor an ISO date such as 2017-07-31T23:59:00Z" % (option, text))
    if record.begin is None:
        raise RecordError("%s: %s has no dates; needed: seconds in the record" % (option, record.name))
    seconds, zoned = found
    return seconds - record.begin - (0.0 if zoned else record.offset)


def limits(record, begin, end, options=("--from", "--to")):
    """Two times in the record [s] of texts, none where a text is empty. RecordError naming the option."""
    return (moment(begin, record, options[0]) if begin else -math.inf, moment(end, record, options[1]) if end else math.inf)


def between(record, begin, end):
    """The rows of a record between two times in it [s]; their signal `time` stays the record's. RecordError where less than two are left."""
    rows = (record.time >= begin) & (record.time <= end)
    if rows.sum() < 2:
        raise RecordError("%s: has %d rows from %g to %g s; needed: two or more, it goes from %g to %g s" %
                          (record.name, rows.sum(), begin, end, record.time[0], record.time[-1]))
    part = copy.copy(record)
    part.signals = {name: values[rows] for name, values in record.signals.items()}
    part.time = part.signals["time"] - part.signals["time"][0]
    part.begin = None if record.begin is None else record.begin + float(part.signals["time"][0] - record.signals["time"][0])
    return part


def stretches(texts, record, option="--leave-out"):
    """(begin, end) in the record [s] of each A:B; a date has colons of its own, so that A..B is taken too. RecordError naming the option."""
    found = []
    for text in texts:
        begin, _, end = text.partition("..") if ".." in text else text.partition(":")
        begin, end = (moment(part.strip(), record, option) for part in (begin, end))
        if not begin < end:
            raise RecordError("%s: '%s' must be A:B with A before B (dates: A..B)" % (option, text))
        found.append((begin, end))
    return found


def inside(times, spans):
    """Which of the times lie in one of the spans."""
    found = numpy.zeros(len(times), bool)
    for begin, end in spans:
        found |= (times >= begin) & (times <= end)
    return found
