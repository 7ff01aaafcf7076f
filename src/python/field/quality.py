# SPDX-License-Identifier: BSD-3-Clause
"""Columns that mark the values beside them as good or bad (`QC`, `Hook Load Quality`, `Status`): what is marked bad is no measurement. The words and names are those of
surveys (scene/quality_flags.h)."""
import functools
import re

from drill_rig_sim.field.cells import is_number
from drill_rig_sim.field.native import of_module
from drill_rig_sim.field.signals import OWN, RANKS, word
from drill_rig_sim.field.table import RecordError, bare, shown

MOST_CODES = 8  # different numbers of a column of flags; more are a measure of quality, as per cent
MOST_SHOWN = 4  # different cells in a message
BRACKETS = re.compile(r"[(\[{<][^()\[\]{}<>]*[)\]}>]")
ROW = -1        # the place of what is of the whole row


@functools.lru_cache(maxsize=None)
def flag_name(name):
    """(sense of a column of flags, "" where the name is none; what else the name says, "" where it is of the row)."""
    return of_module().flag_name(without_brackets(name))


def without_brackets(name):
    """Of `Hook Load (klbf) Quality` too."""
    return BRACKETS.sub(" ", name)


def flags_in(names):
    """Places of the columns that may hold flags."""
    return [] if OWN["hook_load"] in names else [place for place, name in enumerate(names) if "%" not in name and flag_name(name)[0]]


def take_flags(table, columns, said, remarks):
    """Empties the cells of the columns (signal -> columns.Column) that a column of flags marks as bad, and takes away the rows that one marks as a whole; reported.
    `said`: of a map, the name of a column of flags -> its good cells in small letters. RecordError where which cells are bad cannot be known, or where all rows are."""
    signals = {place: signal for signal, column in columns.items() for place in table.places_of(column.names[0]) if signal != "time"}
    asked = {table.column(name): good for name, good in said.items()}
    flags, left_out = flags_in(table.names), set()
    for place in sorted({*asked, *flags}):
        owner = owner_of(table, place, flags, signals)
        if owner is None and place not in asked:
            continue
        bad, kept = judged(table, place, asked.get(place), remarks)
        report(table, place, signals.get(owner), bad, kept, remarks)
        for k in bad if owner in signals else ():
            table.rows[k][owner] = ""
        left_out.update(() if owner in signals else bad)
    if left_out and len(left_out) == len(table.rows):
        raise RecordError("%s: all rows are marked bad by %s; needed: rows with measurements" % (table.file, shown([table.names[place] for place in flags], MOST_SHOWN)))
    stay = [k for k in range(len(table.rows)) if k not in left_out]
    table.rows, table.places = [table.rows[k] for k in stay], [table.places[k] for k in stay]


def owner_of(table, place, flags, signals):
    """The place of the column that flags at a place are of, ROW, or None where they are of a column that is not used. Where several columns of flags have no name but
    that, each is of the column before it."""
    sense, of = flag_name(table.names[place])
    if not sense:
        return ROW  # a map names it
    if not of:
        alike = [other for other in flags if not flag_name(table.names[other])[1]]
        if len(alike) == 1 or any(other - 1 in flags for other in alike):
            return ROW
        return place - 1 if place - 1 in signals else None
    return next((column for column in signals if of == word(bare(table.names[column]))),
                next((column for column, signal in signals.items() if of in RANKS.get(signal, ())), None))


def judged(table, place, good, remarks):
    """Rows that a column marks bad, and those that it marks neither good nor bad. `good`: its good cells where a map names them, else None."""
    cells = [row[place].strip() for row in table.rows]
    kinds = list(dict.fromkeys(cells))
    meanings = {kind: "good" if is_among(kind, good) else "bad" for kind in kinds} if good is not None else meanings_of(table, place, kinds, remarks)
    neither = ("derived",) if flag_name(table.names[place])[0] == "status" else ("derived", "other")  # a status also says what the rig does
    return [[k for k, cell in enumerate(cells) if meanings.get(cell) in wanted] for wanted in (("bad",), neither)]


def is_among(cell, good):
    """Whether a cell is one of a map's, as a text or a number."""
    return cell.lower() in good or is_number(cell) and any(is_number(one) and float(one) == float(cell) for one in good)


def meanings_of(table, place, kinds, remarks):
    """Of the different cells of a column; none where these say nothing. RecordError where the name is only that of flags and which of them are bad cannot be known;
    a line where it may be another. What a rig does and a measure of quality, as in per cent, are no flags."""
    name, sense = table.names[place], flag_name(table.names[place])[0]
    meanings, known, unclear = of_module().flag_cells(without_brackets(name), kinds)
    if known:
        return dict(zip(kinds, meanings))
    codes = all(is_number(kind) for kind in kinds if kind)
    if not unclear or len(kinds) > MOST_CODES or (sense == "status" and not (codes and len(kinds) == 2)):
        return {}
    line = "%s holds %s: which of them mark bad values is not known; needed: a map, --columns, quality: {column: %s, good: %s}" % (
        name, " and ".join(kind or "nothing" for kind in kinds[:MOST_SHOWN]), name, next(filter(None, kinds)))
    if sense != "status":
        raise RecordError("%s: %s" % (table.file, line))
    remarks.append(line)
    return {}


def report(table, place, signal, bad, kept, remarks):
    """Lines on rows that a column marks bad, and on those that it marks neither good nor bad."""
    name, of = table.names[place], "%s: %%d of %d values" % (signal, len(table.rows)) if signal else "%%d of %d rows" % len(table.rows)
    for rows, so in ((bad, "are no measurements" if signal else "are left out"), (kept, "are used")):
        if rows:
            kinds = dict.fromkeys(table.rows[k][place].strip() or "(empty)" for k in rows)
            remarks.append("%s are marked %s by %s and %s (first: %s)" % (of % len(rows), shown(list(kinds), MOST_SHOWN), name, so, table.place(rows[0])))
