"""A fit's file: what is fitted to what."""
import os

import numpy
from drill_rig_sim.campaign.plan_text import PlanError, plan_of
from drill_rig_sim.campaign.scene_text import SceneText, SceneTextError, Times
from drill_rig_sim.field.columns import LAYOUT_KEYS, Column, check_unit, nulls_and_layout, nulls_of
from drill_rig_sim.field.fit import Parameter
from drill_rig_sim.field.models import MOTIONS, ModelError, RecordModel, TableModel, scene_and_survey
from drill_rig_sim.field.record import COMPARED, RecordError, prefixed, read_record, read_table
from drill_rig_sim.field.signal_reader import values_of

KEYS = ("scene", "record", "columns", "table", "parameters", "signals", "from", "held_out")
PARAMETER_KEYS = ("name", "key", "keys", "times", "signal", "start", "from", "to")


class FitPlan:
    """`model`, `parameters`, and which of the model's numbers are `fitted` and which `held_out`; the beginning may be neither."""

    def __init__(self, model, parameters, fitted, held_out):
        self.model, self.parameters, self.fitted, self.held_out = model, parameters, fitted, held_out


def read_fit(file):
    """A FitPlan; PlanError, RecordError or ModelError with one line."""
    entries = plan_of(file).mapping(KEYS, needed=("scene", "parameters"))
    if ("record" in entries) == ("table" in entries):
        raise PlanError("%s: needed: record or table, not both" % file)
    base = os.path.dirname(os.path.abspath(file))
    scene, survey = scene_and_survey(os.path.join(base, entries["scene"].text()))
    parameters = [parameter_of(item, scene) for item in entries["parameters"].sequence()]
    check_places(scene, parameters, entries["parameters"])
    if "table" in entries:
        model = TableModel(scene, survey, parameters, *weights_of(entries["table"], base))
    else:
        columns = os.path.join(base, entries["columns"].text()) if "columns" in entries else None
        signals = [item.choice(COMPARED) for item in entries["signals"].sequence()] if "signals" in entries else ()
        model = RecordModel(scene, survey, parameters, read_record(files_of(entries["record"], base), columns), signals)
    for parameter, item in zip(parameters, entries["parameters"].sequence()):
        if parameter.signal and parameter.signal not in model.signals:
            item.fail("%s: is not fitted" % parameter.signal)
    held = entries["held_out"].number(0.0, most=0.9) if "held_out" in entries else 0.3
    begin = entries["from"].number(0.0) / model.length if "from" in entries else 0.0
    fitted = (model.place >= begin) & (model.place < 1.0 - held)
    if not (fitted & numpy.isfinite(model.observed)).any():
        raise PlanError("%s: from and held_out leave no number to fit to" % file)
    return FitPlan(model, parameters, fitted, model.place >= 1.0 - held)


def files_of(entry, base):
    """Of `record`: a file, or a list of files of the same well."""
    return [os.path.join(base, item.text()) for item in (entry.sequence() if entry.is_sequence() else [entry])]


def check_places(scene, parameters, entry):
    """That no two parameters are of one key."""
    try:
        SceneText(scene, [key for parameter in parameters for key in parameter.keys])
    except SceneTextError as error:
        entry.fail(str(error))


def parameter_of(item, scene):
    parts = item.mapping(PARAMETER_KEYS, needed=("name", "start"))
    if sum(key in parts for key in ("key", "keys", "signal")) != 1:
        item.fail("needs one of key, keys and signal (an offset of it)")
    places = [parts["key"].text()] if "key" in parts else [one.text() for one in parts["keys"].sequence()] if "keys" in parts else []
    times = "times" in parts and parts["times"].yes()
    try:
        SceneText(scene, places).with_values({place: Times(1.0) if times else 1.0 for place in places})
    except SceneTextError as error:
        item.fail(str(error))
    low = parts["from"].number() if "from" in parts else -numpy.inf
    high = parts["to"].number(beyond=low if numpy.isfinite(low) else None) if "to" in parts else numpy.inf
    start = parts["start"].number()
    if not low <= start <= high:
        parts["start"].fail("is %g, outside %g to %g" % (start, low, high))
    signal = parts["signal"].choice(COMPARED) if "signal" in parts else None
    return Parameter(parts["name"].text(), start, low, high, places, times, signal)


def weights_of(entry, base):
    """Depths and weights: `table: {file: F, depth: {column, unit}, pick_up: {column, unit}, ...}`; a unit may stand in the file instead."""
    parts = entry.mapping(("file", "depth", *MOTIONS, *LAYOUT_KEYS), needed=("file", "depth"))
    if not any(name in parts for name in MOTIONS):
        entry.fail("needs one or more of %s" % ", ".join(MOTIONS))
    columns = {name: weight_column(parts[name], name) for name in ("depth", *MOTIONS) if name in parts}
    nulls, layout = nulls_and_layout(parts)
    table = read_table(os.path.join(base, parts["file"].text()), layout, [column.names[0] for column in columns.values()])
    remarks = list(table.remarks)
    found = {name: values_of(table, quantity_of(name), column, nulls, True, remarks) for name, column in columns.items()}
    depths = found.pop("depth")
    if not len(depths):
        raise RecordError("%s: has no rows" % table.file)
    odd = numpy.flatnonzero(~numpy.isfinite(depths))
    if len(odd):
        cell = table.rows[odd[0]][table.column(columns["depth"].names[0])].strip()
        raise RecordError("%s: %s: %s is no depth of a well" % (table.place(odd[0]), columns["depth"].names[0], cell or "an empty cell"))
    return depths, found, prefixed(table.file, remarks + remarks_of(table, found))


def remarks_of(table, weights):
    """Lines on weights that are missing, and on a pick-up weight below a slack-off weight: friction makes it the larger one."""
    lines = []
    for name, values in weights.items():
        lost = int((~numpy.isfinite(values)).sum())
        if lost:
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
    """The signal of a record that a column of such a table is like."""
    return "bit_depth" if name == "depth" else "hook_load"


__all__ = ["FitPlan", "ModelError", "PlanError", "RecordError", "read_fit"]
