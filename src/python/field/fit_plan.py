# SPDX-License-Identifier: BSD-3-Clause
"""A fit's file: what is fitted to what."""
import os

import numpy
from drill_rig_sim.campaign.plan_text import PlanError, plan_of
from drill_rig_sim.campaign.scene_text import SceneText, SceneTextError, Times
from drill_rig_sim.field.cell_units import take_units
from drill_rig_sim.field.column_finder import NOT_MEASURED, VERTICAL
from drill_rig_sim.field.columns import LAYOUT_KEYS, QUALITY, Column, check_unit, nulls_and_layout, nulls_of, quality_of
from drill_rig_sim.field.fit import Parameter
from drill_rig_sim.field.heading import Wanted
from drill_rig_sim.field.models import ModelError, Period, RecordModel, TableModel, scene_and_survey
from drill_rig_sim.field.motions import MOTIONS, WAYS
from drill_rig_sim.field.native import of_module
from drill_rig_sim.field.quality import take_flags
from drill_rig_sim.field.record import COMPARED, RecordError, prefixed, read_record, read_table
from drill_rig_sim.field.signal_reader import encoding_choice, values_of
from drill_rig_sim.field.signals import SIGNALS, words_in
from drill_rig_sim.field.start import FROM
from drill_rig_sim.field.table import bare
from drill_rig_sim.field.units import is_unit
from drill_rig_sim.field.weight_checks import leave_out_zeros, unlikely
from drill_rig_sim.field.weight_names import called
from drill_rig_sim.field.window import limits, stretches
from drill_rig_sim.lockstep import Refused
from drill_rig_sim.refusal import after

OF_RECORDS = ("columns", "signals", "from", "to", "leave_out", "start")
KEYS = ("scene", "record", "table", "parameters", "held_out", *OF_RECORDS)
ALIKE = 2.0  # rows of a move that say as much as one: what rings goes on from row to row
PARAMETER_KEYS = ("name", "key", "keys", "times", "signal", "start", "from", "to")


class FitPlan:
    """`model`, `parameters`, and which of the model's numbers are `fitted` and which `held_out`. `scene_remarks`: what the scene's reader reports, a line each."""

    def __init__(self, model, parameters, fitted, held_out, scene_remarks=()):
        self.model, self.parameters, self.fitted, self.held_out, self.scene_remarks = model, parameters, fitted, held_out, list(scene_remarks)


def read_fit(file, fitted=None):
    """A FitPlan; PlanError, RecordError or ModelError with one line. `fitted`: a Fitted, whose parameters and signals stand in the place of the file's own."""
    entries = plan_of(file).mapping(KEYS, needed=("scene",) if fitted else ("scene", "parameters"))
    if ("record" in entries) == ("table" in entries):
        raise PlanError("%s: needed: record or table, not both" % file)
    base = os.path.dirname(os.path.abspath(file))
    scene_file = os.path.join(base, entries["scene"].text())
    scene, survey = scene_and_survey(scene_file)
    if fitted:
        parameters = fitted.parameters
        check_places(scene, parameters, "%s: parameters of the fit" % scene_file)
    else:
        parameters = [parameter_of(item, scene) for item in entries["parameters"].sequence()]
        check_places(scene, parameters, entries["parameters"].place())
    model = model_of(entries, base, (scene_file, scene, survey), parameters, tuple(fitted.scatter) if fitted else ())
    if not fitted:
        check_offsets(entries["parameters"], parameters, model)
    held = 0.0 if fitted else entries["held_out"].number(0.0, most=0.9) if "held_out" in entries else 0.3
    held_out = model.place >= 1.0 - held if held else numpy.zeros(len(model.place), bool)
    if not (~held_out & numpy.isfinite(model.observed)).any():
        raise PlanError("%s: from, to, leave_out and held_out leave no number to compare" % file)
    return FitPlan(model, parameters, ~held_out, held_out, remarks_of_scene(scene_file))


def remarks_of_scene(file):
    """What the scene's reader reports; of a scene that is refused nothing, for the fit says why."""
    try:
        return of_module().scene_remarks(file)
    except Refused:
        return []


def model_of(entries, base, scene, parameters, signals):
    """A TableModel or a RecordModel. `scene`: its file, its text and its survey's. `signals`: that are compared, unless the file names them; (): all."""
    if "table" in entries:
        for key in OF_RECORDS:
            if key in entries:
                entries[key].fail("is of a record, and this is the fit of a table")
        return TableModel(*scene, parameters, *weights_of(entries["table"], base))
    if "signals" in entries:
        signals = [item.choice(COMPARED) for item in entries["signals"].sequence()]
    columns = os.path.join(base, entries["columns"].text()) if "columns" in entries else None
    record = read_record([os.path.join(base, item.text()) for item in one_or_more(entries["record"])], columns)
    with after(lambda: record.noticed):
        return RecordModel(*scene, parameters, record, signals, period_of(entries, record))


def period_of(entries, record):
    """By from, to, leave_out and start, which are as the options of drill replay."""
    texts, places = zip(*((entries[key].text(), entries[key].place()) if key in entries else ("", "") for key in ("from", "to")))
    begin, end = limits(record, *texts, places)
    left_out = [span for item in (one_or_more(entries["leave_out"]) if "leave_out" in entries else []) for span in stretches([item.text()], record, item.place())]
    return Period(begin, end, left_out, entries["start"].choice(FROM) if "start" in entries else "")


def one_or_more(entry):
    """Of a value or a list of them."""
    return entry.sequence() if entry.is_sequence() else [entry]


def check_places(scene, parameters, place):
    """That the scene has the parameters' keys, and no two of them one key."""
    factors = {key: Times(1.0) if parameter.times else 1.0 for parameter in parameters for key in parameter.keys}
    try:
        SceneText(scene, [key for parameter in parameters for key in parameter.keys]).with_values(factors)
    except SceneTextError as error:
        raise PlanError("%s: %s" % (place, error))


def check_offsets(entry, parameters, model):
    """That an offset's signal is fitted."""
    for parameter, item in zip(parameters, entry.sequence()):
        if parameter.signal and parameter.signal not in model.signals:
            item.fail("%s: is not fitted" % parameter.signal)


def parameter_of(item, scene):
    parts = item.mapping(PARAMETER_KEYS, needed=("name", "start"))
    if sum(key in parts for key in ("key", "keys", "signal")) != 1:
        item.fail("needs one of key, keys and signal (an offset of it)")
    places = [parts["key"].text()] if "key" in parts else [one.text() for one in parts["keys"].sequence()] if "keys" in parts else []
    times = "times" in parts and parts["times"].yes()
    low = parts["from"].number() if "from" in parts else -numpy.inf
    high = parts["to"].number(beyond=low if numpy.isfinite(low) else None) if "to" in parts else numpy.inf
    start = parts["start"].number()
    if not low <= start <= high:
        parts["start"].fail("is %g, outside %g to %g" % (start, low, high))
    signal = parts["signal"].choice(COMPARED) if "signal" in parts else None
    parameter = Parameter(parts["name"].text(), start, low, high, places, times, signal)
    check_places(scene, [parameter], item.place())
    return parameter


def weights_of(entry, base):
    """Depths, weights, remarks, errors_of() and WAYS: `table: {file: F, depth: {column, unit}, pick_up: {column, unit}, ...}`; a unit may stand in the file instead. Without columns those that have
    these names; the torque, of which a few numbers say little, only where it is named."""
    parts = entry.mapping(("file", "depth", *MOTIONS, *WAYS, *LAYOUT_KEYS, QUALITY), needed=("file",))
    columns = {name: weight_column(parts[name], name) for name in ("depth", *MOTIONS, *WAYS) if name in parts}
    nulls, layout = nulls_and_layout(parts)
    named = any(name not in WAYS for name in columns)
    table = read_table(os.path.join(base, parts["file"].text()), layout, [column.names[0] for column in columns.values()], None if named else OfWeights())
    take_units(table)
    columns = {**known_ways(table), **({} if named else known_columns(table)), **columns}
    if "depth" not in columns or not any(name in MOTIONS for name in columns):
        entry.fail("needs depth and one or more of %s; columns of %s: %s%s" % (", ".join(MOTIONS), table.file, table.header(), encoding_choice(table)))
    with after(lambda: prefixed(table.file, table.remarks)):
        take_flags(table, columns, quality_of(parts), table.remarks)
        return weights_in(table, columns, nulls)


def weights_in(table, columns, nulls):
    """weights_of() of a table whose columns are known."""
    remarks = table.remarks
    found = {name: values_of(table, quantity_of(name), column, nulls, True, remarks) for name, column in columns.items()}
    depths, ways = found.pop("depth"), {name: found.pop(name) for name in WAYS if name in found}
    if not len(depths):
        raise RecordError("%s: has no rows" % table.file)
    odd = numpy.flatnonzero(~(depths >= 0.0))
    if len(odd):
        cell = table.rows[odd[0]][table.column(columns["depth"].names[0])].strip()
        raise RecordError("%s: %s: %s is not a depth of a well" % (table.place(odd[0]), columns["depth"].names[0], cell or "an empty cell"))
    loads = {name: values for name, values in found.items() if quantity_of(name) == "hook_load"}
    remarks += leave_out_zeros(table, loads)
    return depths, found, prefixed(table.file, remarks + remarks_of(table, found) + unlikely(table, depths, loads)), errors_of(table, nulls), ways


class OfWeights(Wanted):
    """Names of the columns of a table of weights, where a fit's file names none."""

    def count(self, names):
        found = [name for name in names if self.is_name(name)]
        return len(found) if len(found) > 1 and any(called(name) == "depth" for name in found) else 0

    def is_name(self, name):
        return called(name) is not None


def known_columns(table):
    """Column by depth and weight, of those that were measured. RecordError where two are called alike."""
    found = {}
    for name in table.names:
        what, words = called(name), words_in(name)
        if what is None or quantity_of(what) not in ("bit_depth", "hook_load") or words & (NOT_MEASURED | (VERTICAL if what == "depth" else set())):
            continue
        if what in found:
            raise RecordError("%s: several columns are %s: %s, %s; needed: one, or %s: {column: NAME} in the fit's file" % (table.file, what, found[what].names[0], name, what))
        found[what] = Column([name])
    table.remarks += not_recognised(table, found)
    return found


def not_recognised(table, found):
    """A line on other columns of forces where the pick-up or the slack-off weight is missing: without one of them, little determines friction."""
    missing = [name for name in ("pick_up", "slack_off") if name not in found]
    left = [name for place, name in enumerate(table.names) if called(name) is None and is_unit(table.units[place] or "", "force") and not words_in(name) & NOT_MEASURED]
    return ["no column is recognised as %s; %s: {column: NAME} in the fit's file can name it: %s" % (" and ".join(missing), missing[0], ", ".join(left))] if missing and left else []


def known_ways(table):
    """Column by WAYS, of those with a unit."""
    places = {name: table.places_of(name) for name in WAYS}
    return {name: Column([table.names[found[0]]]) for name, found in places.items() if len(found) == 1 and is_unit(table.units[found[0]] or "", SIGNALS[WAYS[name]][0])}


def errors_of(table, nulls):
    """Of the load of each row, standard deviation [N]: of a mean of `rows` that vary by `deviation`, in a table that drill weights has written; else 0."""
    names = {bare(name): name for name in table.names}
    if not {"motion", "rows", "deviation"} <= set(names):
        return numpy.zeros(len(table.rows))
    deviation = numpy.nan_to_num(values_of(table, "hook_load", Column([names["deviation"]]), nulls, True, []))
    return deviation / numpy.sqrt(numpy.maximum(numpy.nan_to_num(table.numbers(names["rows"], True)) / ALIKE, 1.0))


def remarks_of(table, weights):
    """Lines on weights that are missing, unless each row is a move that has but one, and on a pick-up weight below a slack-off weight: friction makes it the larger one."""
    lines = []
    loads = sum(numpy.isfinite(values).astype(int) for name, values in weights.items() if quantity_of(name) == "hook_load")
    for name, values in weights.items():
        lost = int((~numpy.isfinite(values)).sum())
        if lost and not (len(weights) > 1 and numpy.all(loads == 1)):
            lines.append("%s: %d of %d rows hold no measurement" % (name, lost, len(values)))
    if "pick_up" in weights and "slack_off" in weights:
        swapped = numpy.flatnonzero(weights["pick_up"] < weights["slack_off"])
        if len(swapped):
            lines.append("%d of %d rows have a pick-up weight below the slack-off weight (first: %s): are the columns exchanged?" %
                         (len(swapped), len(table.rows), table.place(swapped[0])))
    return lines


def weight_column(entry, name):
    parts = entry.mapping(("column", "unit", "null"), needed=("column",))
    unit = parts["unit"].text() if "unit" in parts else None
    if unit is not None:
        check_unit(quantity_of(name), unit, parts["unit"])
    return Column([parts["column"].text()], unit, nulls=nulls_of(parts))


def quantity_of(name):
    """The signal of a record that a column of such a table is like; None where it is none of them."""
    return "bit_depth" if name == "depth" else MOTIONS[name][0] if name in MOTIONS else WAYS.get(name)


def column_said(entry):
    parts = entry.mapping(("column", "unit"), needed=("column", "unit"))
    return Column([parts["column"].text()], parts["unit"].text())


__all__ = ["FitPlan", "ModelError", "PlanError", "RecordError", "read_fit"]
