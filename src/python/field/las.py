"""Log ASCII Standard, LAS 1.2 and 2.0 (Canadian Well Logging Society), as a Table."""
import re

from drill_rig_sim.field.signals import RANKS, word
from drill_rig_sim.field.table import RecordError, Table, is_number, lines_of, shown
from drill_rig_sim.field.units import UnitError, factor_of

LINE = re.compile(r"\s*([^.:]*?)\s*\.(\S*)\s*(.*?)\s*:([^:]*)$")  # NAME.UNIT  VALUE : DESCRIPTION


def read_las(file, text):
    """A Table of a log by time; RecordError where it is by depth and has no curve of time."""
    sections = sections_of(file, text)
    version = values_in(sections.get("V", []))
    if "A" not in sections or "C" not in sections:
        raise RecordError("%s: has no section %s; needed: LAS 2.0 with ~V, ~W, ~C and ~A" % (file, "~A" if "A" not in sections else "~C"))
    if version.get("VERS", ("", "2.0"))[1].strip() not in ("1.2", "1.20", "2.0", "2.00", "2"):
        raise RecordError("%s: is LAS %s; allowed: 1.2 and 2.0" % (file, version["VERS"][1].strip()))
    curves = [match.groups()[:2] for match in (LINE.match(line) for _, line in sections["C"]) if match]
    names, units = [name for name, _ in curves], [unit.strip() or None for _, unit in curves]
    null = values_in(sections.get("W", [])).get("NULL", ("", ""))[1].strip()
    wrapped = version.get("WRAP", ("", "NO"))[1].strip().upper() == "YES"
    rows, places = rows_of(file, sections["A"], names, wrapped)
    index = index_of(file, names, units)
    units[index] = units[index] if is_time(units[index]) else None
    dated = any(not is_number(row[index]) for row in rows[:1])
    return Table(file, names, units, rows, places, [(float(null),) if is_number(null) else ()] * len(names), index, dated)


def sections_of(file, text):
    """Lines with their numbers by the letter of their section; empty lines and comments are passed over."""
    found, lines = {}, None
    for number, line in enumerate(lines_of(text), 1):
        if line.startswith("~"):
            letter = line[1:2].upper()
            if letter in found:
                raise RecordError("%s:%d: there is a second section ~%s; needed: one" % (file, number, letter))
            lines = found.setdefault(letter, [])
        elif line.strip() and not line.lstrip().startswith("#"):
            if lines is None:
                raise RecordError("%s:%d: stands before the first section" % (file, number))
            lines.append((number, line))
    return found


def values_in(lines):
    """Unit and value by name."""
    return {match.group(1).upper(): (match.group(2), match.group(3)) for match in (LINE.match(line) for _, line in lines) if match}


def rows_of(file, lines, names, wrapped):
    """Of wrapped data a row goes on over lines until it has as many values as there are curves."""
    rows, places, cells, begun = [], [], [], None
    for number, line in lines:
        begun, cells = begun or number, cells + line.split()
        if wrapped and len(cells) < len(names):
            continue
        if len(cells) != len(names):
            raise RecordError("%s:%d: has %d values, there are %d curves (%s); needed: as many" % (file, begun, len(cells), len(names), shown(names, 8)))
        rows.append(cells)
        places.append(str(begun))
        cells, begun = [], None
    if cells:
        raise RecordError("%s:%d: the last row has %d values, there are %d curves" % (file, begun, len(cells), len(names)))
    return rows, places


def is_time(unit):
    try:
        factor_of("time", unit or "")
        return True
    except UnitError:
        return False


def index_of(file, names, units):
    """The first curve where it is a time, else the first that is called so."""
    places = [place for place, name in enumerate(names) if word(name) in RANKS["time"] or word(name) in ("etim", "etime", "elapsedtime")]
    if names and is_time(units[0]):
        return 0
    if not places:
        raise RecordError("%s: its index is %s [%s], and none of its curves is a time (%s); needed: a log by time" %
                          (file, names[0] if names else "(none)", units[0] if names else "", shown(names)))
    return places[0]
