# SPDX-License-Identifier: BSD-3-Clause
"""Units that stand in the lines above a table alone (`Depths in feet, hook load in klbs`): taken where the names have none, reported where these have another one."""
import re

from drill_rig_sim.field.column_finder import named
from drill_rig_sim.field.signals import RANKS, SIGNALS, si_unit
from drill_rig_sim.field.units import factor_of, is_unit

SAID = re.compile(r"(.+?)(?:\s+(?:are|is|given|measured|recorded|expressed))*(?:\s+in\s+|\s*[:=]\s*)([A-Za-z\u00b0].*)$", re.IGNORECASE)
PARTS, AND = re.compile(r"[,;|\t]+|\.\s"), re.compile(r"\s+and\s+", re.IGNORECASE)
LONGEST, MOST_PARTS = 200, 12  # letters and parts of a line that is looked at
# signals by a word, in the plural too, beside which only FILLERS stand; other words are names of signals
DEPTHS, HEIGHT = ("bit_depth", "hole_depth"), ("block_height",)
OF_WORDS = {"depth": DEPTHS, "height": HEIGHT, "length": DEPTHS + HEIGHT, "load": ("hook_load",), "weight": ("hook_load",), "pressure": ("stand_pipe_pressure",), "torque": ("torque",), "flow": ("flow",)}
FILLERS = set("all the these measured recorded data units unit uom".split())
SAME = 1e-3  # share by which units of one quantity differ at least


def units_said(lines):
    """Signal -> (unit, line) of (line number, text); the first one of each."""
    found = {}
    for number, text in lines:
        for names, unit in pairs_in(text[:LONGEST].strip(" #\"'*!%")):
            for signal in (signal for name in names for signal in signals_of(name)):
                if is_unit(unit, SIGNALS[signal][0]):
                    found.setdefault(signal, (unit, number))
    return found


def pairs_in(text):
    """(names, unit) of `depths and heights in feet, torque in kft-lb and SPP in psi`."""
    for part in PARTS.split(text)[:MOST_PARTS]:
        names = []
        for piece in AND.split(part):
            match = SAID.match(piece.strip())
            names.append(match[1] if match else piece)
            if match:
                yield names, match[2].strip(" .()[]")
                names = []


def signals_of(name):
    words = [word for word in re.findall("[a-z]+", name.lower()) if word not in FILLERS]
    exact = [signal for signal, ranks in RANKS.items() if "".join(words) in ranks and signal != "time"]
    return exact or (OF_WORDS.get(words[0], OF_WORDS.get(words[0].rstrip("s"), ())) if len(words) == 1 else ())


def take_title_units(table, mapped, remarks):
    """Gives the columns of a table that have a name of the trade and no unit that of its title. `mapped`: columns by signal whose unit a map may say: these are left as they are."""
    said_above = units_said(table.title)
    left = {place for column in mapped.values() if column.unit for name in column.names for place in table.places_of(name)}
    for signal, places in named(table.names).items() if said_above else ():
        unit, line = said_above.get(signal, (None, 0))
        for place in set(places) - left if unit else ():
            said, name = table.units[place], table.names[place]
            if said is None:
                table.units[place] = unit
                remarks.append("%s: %s has no unit and is read in %s, as line %d says" % (signal, name, unit, line))
            elif is_unit(said, SIGNALS[signal][0]) and differ(SIGNALS[signal][0], said, unit):
                remarks.append("%s: line %d says %s, %s is in %s: it is read so (1 is %.6g %s); is that right?" %
                               (signal, line, unit, name, said, factor_of(SIGNALS[signal][0], said), si_unit(signal)))


def differ(quantity, one, other):
    return abs(factor_of(quantity, one) / factor_of(quantity, other) - 1.0) > SAME
