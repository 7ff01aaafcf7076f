# SPDX-License-Identifier: BSD-3-Clause
"""Which columns of a table hold which signals, where no map names them."""
from drill_rig_sim.field.cells import is_blank, is_number
from drill_rig_sim.field.columns import Column
from drill_rig_sim.field.dates import EARLIEST, fitting, form_said, is_time_of_day, joined, seconds_of
from drill_rig_sim.field.heading import Wanted
from drill_rig_sim.field.quality import flags_in
from drill_rig_sim.field.signals import NAMES, OWN, SIGNALS, known, si_unit, word, words_in
from drill_rig_sim.field.table import RecordError, apart, bare, shown, unit_in
from drill_rig_sim.field.units import DATE, factor_of, is_unit

ZONES = ("tz", "timezone", "utcoffset", "gmtoffset", "zone")  # columns of time zones
# columns of their own, of dates and of times of the day
DATES, TIMES_OF_DAY = ("date", "yyyymmdd", "ddmmyyyy", "mmddyyyy", "datum", "fecha", "data", "dato"), ("time", "hhmmss", "timeofday", "clock", "zeit", "uhrzeit", "hora", "heure", "ora", "tid", "tijd", "vremya")
DEPTHS, VERTICAL = ("bit_depth", "hole_depth"), {"tvd", "tvdss", "vert", "vertical", "lag", "lagged"}  # `Hole Depth (TVD)`, `Depth Bit (vert)`
EXTREMES = {"max", "min", "maximum", "minimum"}  # `Hookload (max)`
# what no gauge has measured: `Flow In (set point)`, `Hook Load (model)`
NOT_MEASURED = set("set setpoint sp target plan planned model modelled modeled simulated predicted expected theoretical calculated limit alarm "
                   "std stdev sd deviation variance rms delta derivative change error".split())
DOWNHOLE = set("mwd lwd downhole dh bit bha motor annular annulus choke kill cement cementing booster boost riser bypass".split())  # `Torque (MWD)`, but of depths
# what else names in brackets say that changes no number
HARMLESS = set("avg average averaged mean ave surface surf meas measured md gauge sensor reading readings raw rig instantaneous inst current actual act real time realtime total in into well hole string "
               "top drive td rotary pump pumps pipe drill block hook bit depth along ahd live edr primary main value s sec second seconds min utc gmt".split())
UNDIRECTED = set("flow caudal gasto debit vazao portata debiet".split())  # that may be into the well or out of it
DIFFERS = 0.02  # from 1, of the ratio of two columns of one name
MOST_SHOWN = 12  # names of columns in a line
TRUTH = {"time", "hook_load", "bit_torque", "bit_up"}  # names that drill run --csv writes and no rig


class OfTheTrade(Wanted):
    """The names that the trade gives the time and the signals, or those of drill run --csv --readings."""

    def count(self, names):
        if {OWN["time"], OWN["hook_load"]} <= set(names):
            return len(OWN)
        found = named(names)
        dated = bool(halves(names)[0])
        return len(found) + dated if len(found) > ("time" in found) and ("time" in found or dated) else 0

    def is_name(self, name):
        return bool(named([name]) or any(halves([name])))

    def places(self, names):
        own = [place for place, name in enumerate(names) if name in OWN.values()]
        return own + zones_in(names) + flags_in(names) + [place for half in halves(names) for place in half] + [place for places in named(names).values() for place in places]


class ByMap(OfTheTrade):
    """The names of a ColumnMap, and beside them those of the trade."""

    def __init__(self, columns):
        self.names = {name.strip().lower() for column in columns.columns.values() for name in column.names} | {name.strip().lower() for name in columns.quality}

    def count(self, names):
        found = len(self.names & {form for name in names for form in forms_of(name)})
        return found and found + super().count(names)

    def is_name(self, name):
        return bool(self.names & forms_of(name)) or super().is_name(name)

    def places(self, names):
        return [place for place, name in enumerate(names) if self.names & forms_of(name)] + super().places(names)


def forms_of(name):
    """How a map may write the name of a column: with its unit in brackets or without."""
    return {name.lower(), bare(name).lower()}


class AllOf(Wanted):
    """These names, and any others beside them."""

    def __init__(self, names):
        self.names = set(names)

    def count(self, names):
        return len(self.names) if self.names <= set(names) else 0


def named(names):
    """Signal -> places of the columns with one of its names, the best first. A vertical depth is none of a string, a set point none of a gauge, a downhole tool none of
    the rig; extremes of a row's interval come last."""
    words = [words_in(name) for name in names]
    found = {signal: [place for place in places if not words[place] & (NOT_MEASURED | (VERTICAL if signal in DEPTHS else DOWNHOLE))] for signal, places in known([bare(name) for name in names]).items()}
    return {signal: sorted(places, key=lambda place: bool(words[place] & EXTREMES)) for signal, places in found.items() if places}


def halves(names):
    """Places of the columns that may hold dates, and of those that may hold times of the day."""
    return [[place for place, name in enumerate(names) if word(bare(name)) in half] for half in (DATES, TIMES_OF_DAY)]


def zones_in(names):
    """Places of the columns that may hold time zones."""
    return [place for place, name in enumerate(names) if word(bare(name)) in ZONES]


def columns_of(table, mapped, remarks):
    """Column by signal: those of a map (`mapped`), and beside them those that have a name of the trade."""
    mapped = {signal: Column([table.names[table.column(name)] for name in column.names], column.unit, column.form, column.nulls) for signal, column in mapped.items()}
    taken = {name.lower() for column in mapped.values() for name in column.names}
    return {**known_columns(table, remarks, set(mapped), taken), **mapped}


def known_columns(table, remarks, mapped, taken):
    """Column by signal, of those that have a name of the trade. Where a signal has several, one with numbers in a unit and the first of signals.NAMES is taken,
    which is reported. Left out are the signals and the columns of a map: `mapped` and `taken`."""
    if all(OWN[signal] in table.names for signal in ("time", "hook_load")):
        return {signal: Column([name], si_unit(signal)) for signal, name in OWN.items() if name in table.names and name not in taken}
    if TRUTH <= set(table.names):
        if mapped:
            return {}
        raise RecordError("%s: is a time series of drill run without readings; needed: drill run --csv --readings, or a map, --columns" % table.file)
    free = {signal: [place for place in places if table.names[place].lower() not in taken] for signal, places in named(table.names).items()}
    by_signal = {signal: places for signal, places in free.items() if places and signal not in mapped}
    found = {} if "time" in mapped else {"time": time_column(table, by_signal.get("time", []))}
    for signal, places in ((signal, places) for signal, places in by_signal.items() if signal != "time"):
        with_unit = [place for place in places if table.units[place]]
        filled = [place for place in with_unit if any(is_number(row[place]) for row in table.rows)]
        in_known_unit = [place for place in filled if is_unit(table.units[place], SIGNALS[signal][0])]
        if with_unit:
            found[signal] = Column([table.names[(in_known_unit or filled or with_unit)[0]]])
            remarks += differing(table, signal, in_known_unit)
            passed = [table.names[place] for place in places if table.names[place] != found[signal].names[0]]
            remarks += ["%s is taken from %s; not used: %s" % (signal, found[signal].names[0], ", ".join(passed))] if passed else []
            remarks += unread_of(found[signal].names[0], signal)
            remarks += ["%s is read as the flow into the well" % found[signal].names[0]] if word(bare(found[signal].names[0])) in UNDIRECTED else []
        elif "rpm" in words_in(table.names[places[0]]):
            found[signal] = Column([table.names[places[0]]], "rpm")
            remarks.append("%s: %s has no unit and is read as rpm" % (signal, table.names[places[0]]))
        else:
            remarks.append("%s: %s is left out: it has no unit; needed: a map, --columns" % (signal, table.names[places[0]]))
    remarks += unknown_names(table, by_signal, mapped, taken)
    return {signal: column for signal, column in found.items() if column is not None}


def differing(table, signal, places):
    """A line on a column that has the name of the first one, another unit and other numbers: one of the units is wrong."""
    for other in places[1:]:
        one = places[0]
        if word(bare(table.names[other])) != word(bare(table.names[one])) or table.units[other] == table.units[one]:
            continue
        ratio = factor_of(SIGNALS[signal][0], table.units[other]) / factor_of(SIGNALS[signal][0], table.units[one])
        shares = sorted(ratio * float(row[other]) / float(row[one]) for row in table.rows if is_number(row[one]) and is_number(row[other]) and float(row[one]) != 0.0)
        if shares and abs(shares[len(shares) // 2] - 1.0) > DIFFERS:
            return ["%s: %s is usually %.3g times %s, both in the same unit; is one of their units wrong?" % (signal, table.names[other], shares[len(shares) // 2], table.names[one])]
    return []


def unread_of(name, signal):
    """A line on what stands in the brackets of a name, beside its unit, and may change its numbers: `Hook Load (excl. block) (kN)`."""
    texts = [text for text in apart(name)[1] if not is_unit(text) and words_in(text) - HARMLESS]
    known_unit = unit_in(name)
    return ["%s: (%s) in the name of %s is not taken into account" % (signal, text, name) for text in texts if text != known_unit]


def unknown_names(table, by_signal, mapped, taken):
    """A line on columns by names that are not known, where a signal has no column."""
    missing = [signal for signal in NAMES if signal not in by_signal and signal not in mapped and signal not in ("time", "hole_depth")]
    known_places = {place for places in (*by_signal.values(), *halves(table.names), zones_in(table.names)) for place in places}
    unknown = [name for place, name in enumerate(table.names) if name and place not in known_places and name.lower() not in taken]
    return ["no column is recognised as %s; a map, --columns, can name it: %s" % (", ".join(missing), shown(unknown, MOST_SHOWN))] if missing and unknown else []


def time_column(table, places):
    """Of the columns at these places: one with whole dates, else a date and a time of the day, else one in a unit, else whole dates by another name, else the
    first. A date that cannot be read comes after a column in a unit."""
    dates, times = halves(table.names)
    places = [table.index] if table.index is not None else places
    whole = [place for place in places if (seconds_of(first_cell(table, place)) or [EARLIEST])[0] > EARLIEST]
    in_unit = [place for place in places if table.units[place] and is_unit(table.units[place], "time") and is_number(first_cell(table, place))]
    if not whole and dates and times:
        both = joined([first_cell(table, dates[0]), first_cell(table, times[0])])
        said = form_of_header(table, (dates[0], times[0]))
        if said and seconds_of(both, said) or not in_unit and seconds_of(both) or is_time_of_day(first_cell(table, times[0])) and (not in_unit or seconds_of(both)) \
                or not in_unit and fitting([both]):
            return Column([table.names[dates[0]], table.names[times[0]]], DATE)
    other = [place for place in dates if seconds_of(first_cell(table, place))]
    return next((Column([table.names[place]]) for place in whole + in_unit + other + places), None)


def form_of_header(table, places):
    """The format of dates that the names or the units of these columns write; None where they write none."""
    return form_said([table.units[place] or table.names[place] for place in places])


def first_cell(table, place):
    """The first of a column that holds something, or ""."""
    return next((row[place] for row in table.rows if not is_blank(row[place])), "")
