# SPDX-License-Identifier: BSD-3-Clause
"""Audits: some runs of a campaign are played once more together with two finer models, as `drill verify` does, to measure how wrong its results are."""
import math

import numpy
from drill_rig_sim.campaign.runner import GOOD

SHARE = 0.02       # of the runs, drawn at random
SMALL = 20         # campaigns with fewer runs have no audits unless their plan asks for them
EXTREMES = 6       # most runs that are audited because a result of theirs is the largest or the least
OF_RUNS = 10       # and no more than one in this number of runs, at least two
DRAWN = "drawn"
VERDICTS = {"right": "right", "warned": "wrong, and warned of", "missed": "wrong without a warning", "unknown": "not known"}


def chosen(rows, about):
    """Why runs are audited, by their numbers, in order: of a campaign that is done. `rows`: the plan's, as Results.rows() gives them; `about`: what the file says of
    itself. The same for the same results."""
    rows = once(rows)
    good = [row for row in rows if row["status"] == GOOD]
    if not share_of(about, len(rows)) or not good:
        return {}
    found = {row["number"]: DRAWN for row in drawn(rows, share_of(about, len(rows)), about["sample"]["seed"])}
    for why, row in extremes(good, ordered(about), max(2, len(rows) // OF_RUNS)):
        found[row["number"]] = why if row["number"] not in found else "%s, %s" % (found[row["number"]], why)
    return dict(sorted(found.items()))


def share_of(about, runs):
    """Of the runs that are drawn; 0: none are audited."""
    asked = about.get("audit")
    return asked if asked is not None else SHARE if runs >= SMALL else 0.0


def once(rows):
    """The first of each key: the same run may stand in a plan several times."""
    return list({row["key"]: row for row in reversed(list(rows))}.values())[::-1]


def drawn(rows, share, seed):
    """The first good ones of a random order."""
    wanted = max(1, round(share * len(rows)))
    order = numpy.random.default_rng(seed).permutation(len(rows))
    return [rows[k] for k in order if rows[k]["status"] == GOOD][:wanted]


def ordered(about):
    """Names of the outputs, that by which the page shows the worst runs before the others."""
    worst = about["report"]["worst"]
    return [worst] + [name for name in about["outputs"] if name != worst]


def extremes(good, outputs, most):
    """(why, row) of the runs with the largest and the least of each output, up to `most` and EXTREMES different ones."""
    found, numbers = [], set()
    for name in outputs:
        with_one = [row for row in good if row["outputs"].get(name) is not None]
        for word, pick in (("largest", max), ("least", min)):
            row = pick(with_one, key=lambda row: row["outputs"][name], default=None)
            if row is not None and len(numbers | {row["number"]}) <= min(EXTREMES, most):
                numbers.add(row["number"])
                found.append(("%s %s" % (word, name), row))
    return found


def verdict_of(status):
    """The word of VERDICTS for what became of an audit: one that did not go to its end is not known."""
    return status if status in VERDICTS else "unknown"


def by_output(audits):
    """Of each output's name its findings in the audits that have some, in their order: (row, finding)."""
    found = {}
    for row in audits:
        for name, finding in row["outputs"].get("outputs", {}).items():
            found.setdefault(name, []).append((row, finding))
    return found


def counts(statuses):
    """How many of each verdict, by its word in VERDICTS."""
    found = dict.fromkeys(VERDICTS, 0)
    for status in statuses:
        found[verdict_of(status)] += 1
    return found


def summary(statuses):
    """A line, what there is none of left out."""
    return ", ".join("%d %s" % (number, VERDICTS[word]) for word, number in counts(statuses).items() if number)


def unmeasured(audited):
    """A sentence about audited runs whose error was not measured, so that no warning could come, with the first one's reason; "" where there are none."""
    reasons = [why for why in (row.get("outputs", {}).get("not_measured") for row in audited) if why]
    return "%d of them did not measure their error, so that no warning could come: %s" % (len(reasons), reasons[0]) if reasons else ""


def worst_of(row):
    """Name and finding of the needed output that is farthest off in an audit; (None, None) where it has none."""
    needed = [(name, finding) for name, finding in row["outputs"].get("outputs", {}).items() if finding["needed"] and finding["worst"] is not None]
    return max(needed, key=lambda one: one[1]["worst"], default=(None, None))


def bins(worst, tolerance):
    """Edges of a histogram of errors, in equal steps of the logarithm, one of them the tolerance."""
    positive = [value for value in worst if value > 0.0] or [tolerance]
    low = math.floor(2.0 * math.log10(min(positive) / tolerance))
    high = math.ceil(2.0 * math.log10(max(positive) / tolerance))
    return tolerance * 10.0**(0.5 * numpy.arange(min(low, -1), max(high, 1) + 1))
