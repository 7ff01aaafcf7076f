# SPDX-License-Identifier: BSD-3-Clause
"""Logs of WITSML 2.0 and 2.1 as Tables: one for each ChannelSet, or for each Channel that holds data of its own, of JSON arrays [[index, ...], [values, ...]]."""
import json

from drill_rig_sim.field.quality import flag_name
from drill_rig_sim.field.signals import RANKS, word
from drill_rig_sim.field.table import RecordError, Table, shown

TIME_INDEX = {"date time": True, "datetime": True, "elapsed time": False}  # whether its values are dates


class NotInTime(Exception):
    """Why a log cannot be put on a time axis."""


def sets_of(root):
    """Elements that hold channels and data, in a document of WITSML 2."""
    found = []
    for group in root.iter("{*}ChannelSet", "{*}Log"):
        channels = group.findall("{*}Channel")
        if data_of(group):
            found.append((group, channels, data_of(group)))
        else:
            found += [(channel, [channel], data_of(channel)) for channel in channels if data_of(channel)]
    return found


def data_of(group):
    """The elements of a group whose texts are its data."""
    return [inner for outer in group.findall("{*}Data") for inner in (outer.findall("{*}Data") or outer.findall("{*}FileUri") or [outer])]


def wells_of(root):
    """Titles of the wellbores that the logs name."""
    return sorted({title.strip() for log in root.iter("{*}Log") for title in (log.findtext("{*}Wellbore/{*}Title"),) if title})


def table_of_set(file, group, channels, data, times):
    """The Table of one of sets_of(). NotInTime where neither its index nor one of its channels is a time."""
    indices = group.findall("{*}Index")
    rows, places, flags = [], [], flags_of(channels)
    for block in data:
        add_rows(file, block, len(indices), len(channels), flags, rows, places)
    names = [text_in(one, "Mnemonic") for one in (*indices, *channels)] + [name for _, _, name in flags]
    units = [text_in(one, "Uom") or None for one in (*indices, *channels)] + [None] * len(flags)
    index, dated = index_of(indices, names, times)
    if indices and text_in(indices[0], "Direction").lower() == "decreasing" and index == 0:
        rows, places = rows[::-1], places[::-1]
    return Table(file, names, [None if index == place and dated else unit for place, unit in enumerate(units)], rows, places, index=index, index_is_date=dated)


def text_in(element, name):
    return (element.findtext("{*}" + name) or "").strip()


def index_of(indices, names, times):
    """(place of the column of time, whether it holds dates, None where that is not known)."""
    asked = [place for place, name in enumerate(names) if name.lower() in times]
    kinds = [(text_in(one, "IndexType") or text_in(one, "IndexKind")).lower() for one in indices]
    of_kind = [place for place, kind in enumerate(kinds) if kind in TIME_INDEX]
    if asked or of_kind:
        place = (asked or of_kind)[0]
        return place, TIME_INDEX.get(kinds[place]) if place < len(kinds) else None
    named = [place for place, name in enumerate(names) if word(name) in RANKS["time"] and (place >= len(kinds) or not kinds[place])]
    if not named:
        raise NotInTime("its index is %s, and none of its channels is a time (%s); needed: a log by time" % (kinds[0] if kinds else "not said", shown(names)))
    return named[0], None


def flags_of(channels):
    """(place among the channels, place in the array of a value, name of a column) of what marks the values of a channel as good or bad: the metadata of its points."""
    found = []
    for place, channel in enumerate(channels):
        for number, one in enumerate(channel.findall("{*}PointMetadata"), 1):
            name = "%s %s" % (text_in(channel, "Mnemonic"), text_in(one, "Name"))
            if flag_name(text_in(one, "Name"))[0]:
                found.append((place, number, name + (" valid" if text_in(one, "DataKind").lower() == "boolean" else "")))
    return found


def add_rows(file, block, indices, channels, flags, rows, places):
    """Rows of one element's text, and where they stand; at the end of each the cells of `flags`."""
    place = "%d: data row" % block.sourceline
    if block.tag.endswith("FileUri"):
        raise RecordError("%s:%d: its data are in another file, %s; needed: data in the document" % (file, block.sourceline, (block.text or "").strip()))
    try:
        found = json.loads(block.text or "", parse_float=str, parse_int=str, parse_constant=str)
    except ValueError as error:
        raise RecordError("%s:%d: Data is not valid JSON: %s; needed: arrays [[index, ...], [values, ...]]" % (file, block.sourceline, error))
    for number, row in enumerate(found if isinstance(found, list) else [found], 1):
        cells = flat(row) if isinstance(row, list) else None
        if cells is None or len(cells) != indices + channels:
            raise RecordError("%s:%s %d must be an array of %d indices and one of %d values" % (file, place, number, indices, channels))
        values = values_in(row)[indices:]
        rows.append(cells + [attribute(values[channel], number) for channel, number, _ in flags])
        places.append("%s %d" % (place, number))


def values_in(row):
    """Of a row, in one or in two arrays. A value may stand in an array with its attributes."""
    parts = row if len(row) == 2 and all(isinstance(part, list) for part in row) else [row]
    return [value for part in parts for value in part]


def attribute(value, number):
    """The text of an attribute of a value, "" where it has none."""
    return str(value[number]) if isinstance(value, list) and number < len(value) and value[number] is not None else ""


def flat(row):
    """Texts of the values of a row, without their attributes; None where it is not such."""
    values = [value[0] if isinstance(value, list) and value else value for value in values_in(row)]
    return None if any(isinstance(value, (list, dict)) for value in values) else ["" if value is None else str(value) for value in values]
