# SPDX-License-Identifier: BSD-3-Clause
"""Runs to be judged: time series of `drill run --csv`, and bags, as columns by the names that `drill run --csv` has. Needs ROS only for bags."""
import csv
import os

import numpy
from drill_rig_sim.field.record import prefixed, read_table
from drill_rig_sim.field.table import RecordError
from drill_rig_sim.lockstep import series
from drill_rig_sim.refusal import Refusal
from drill_rig_sim.tables import SIGNALS
from drill_rig_sim.text_file import report

FLAGS = ("winch_limited", "top_drive_limited", "stop_reached", "slack_line", "relief_valve_open", "over_stress", "over_torque", "buckled",
         "accuracy_warning")
ZEROED = ("wob", "differential_pressure")  # nan of readings that have not been zeroed yet
NEW_RUN = 1.0  # time that goes back by so much begins a new run [s]
NEEDED = ("time", "hole_depth", "bit_depth", "wob", "torque", "top_drive_speed")
STATE = {"hole_depth": "hole_depth", "bit_depth": "bit_depth", "torque": "torque", "top_drive_speed": "top_drive_speed",
         "in_slips": "in_slips", "motor_stalled": "motor_stalled", "wob": "surface_wob", **{flag: flag for flag in FLAGS},
         **{name: name for name in ("hook_load", "block_height", "rop", "stand_pipe_pressure", "differential_pressure", "flow")}}
COMPANION = "companion_"  # begins the names of the companion's columns
COMPANION_TOPICS = ("companion/truth/rig_state", "companion/truth/bit")
TOPICS = ("truth/rig_state", "truth/bit", "rig_state", "downhole/mwd", "downhole/toolface", *COMPANION_TOPICS)
BIT = {row.name: row.field for row in SIGNALS if row.of == "bit" and row.field}  # columns of a run and fields of BitTruth
UNSENSED = tuple(row.name for row in SIGNALS if row.of == "truth")


class RunError(Refusal):
    """What is wrong with a run, in one line."""


class Run:
    """Columns of equal length by name, in SI units and radians. `source`: truth or readings. What a row says holds for the time since the row
    before: `dt` [s], 0 of the first. `title`: over pictures, the file's name without its folder. `surveys`: rows of measured depth, inclination
    and azimuth, where the hole itself was not seen. `may_be_nan`: columns that are not known in every row, beside those of may_be_empty().
    `earlier`: what is said of runs before it in the same file, or "". `companion`: columns of the model beside it (companion.py), nan once that has
    ended; {} without one."""

    def __init__(self, columns, source="truth", name="", surveys=(), may_be_nan=(), earlier="", companion=None):
        missing = [column for column in NEEDED if column not in columns]
        if missing:
            raise RunError("%s: has no %s, needed: the time series of drill run --csv or a bag" % (name, ", ".join(missing)))
        self.columns = {column: numpy.asarray(values, dtype=float) for column, values in columns.items()}
        self.source, self.name, self.surveys = source, name, numpy.array(surveys, dtype=float).reshape(-1, 3)
        self.title, self.earlier = os.path.basename(name), earlier
        self.companion = {column: numpy.asarray(values, dtype=float) for column, values in (companion or {}).items()}
        time = self.columns["time"]
        if len(time) < 2 or not (numpy.diff(time) > 0.0).all():
            raise RunError("%s: needed: two rows or more whose time increases" % name)
        bad = [column for column, values in self.columns.items()
               if (numpy.isinf(values) if column in may_be_nan or may_be_empty(column) else ~numpy.isfinite(values)).any()]
        if bad:
            raise RunError("%s: %s is not finite everywhere" % (name, ", ".join(bad)))
        self.dt = numpy.diff(time, prepend=time[0])

    def __contains__(self, column):
        return column in self.columns

    def __getitem__(self, column):
        return self.columns[column]


def may_be_empty(column):
    """Of a time series with --readings: a cell that has not been measured, or not been zeroed. With --errors: one after the companion's end."""
    return column.startswith(("reading_", "error_", COMPANION))


def read_run(file, namespace=None):
    """A bag where the file's name ends with .bag, else a time series."""
    return read_bag(file, namespace) if file.endswith(".bag") else read_series(file)


def read_series(file):
    try:
        table = read_table(file)
        report(prefixed(file, table.remarks))
        columns = {name: table.numbers(name, may_be_empty(name)) for name in table.names}
    except RecordError as error:
        raise RunError(str(error))
    begin, earlier = last_run(columns.get("time", ()), columns.pop("epoch", None))
    columns = {name: values[begin:] for name, values in columns.items()}
    companion = {name[len(COMPANION):]: columns.pop(name) for name in tuple(columns) if name.startswith(COMPANION)}
    return Run(columns, "truth", file, earlier=earlier, companion=companion)


def last_run(time, epochs=None):
    """Where the last run of a series begins, and what is said of those before it, or "". A new run begins where time goes back by NEW_RUN or more, for
    the rig's node was started again (by less it is an error of the series, which Run refuses), and where the epoch of its states changes."""
    begins = numpy.diff(time) <= -NEW_RUN
    if epochs is not None:
        begins |= numpy.diff(epochs) != 0
    places = numpy.flatnonzero(begins)
    if not len(places):
        return 0, ""
    begin = places[-1] + 1
    why = "time goes back to %.6g s there" % time[begin] if time[begin] < time[begin - 1] else "the rig was reset or restored there"
    return begin, "%d earlier run%s of the file, to %.6g s: %s; only the rows after it are scored" % (len(places), "s" if len(places) > 1 else "", time[begin - 1], why)


def read_bag(file, namespace=None):
    """Of truth/rig_state and truth/bit where the bag has them, else of rig_state and downhole/*."""
    try:
        import rosbag  # needed only for bags
    except ImportError:
        raise RunError("%s: bags need Debian's python3-rosbag" % file)
    try:
        with rosbag.Bag(file) as bag:
            prefix = namespace_of(bag, file, namespace)
            messages, earlier = messages_of(bag, prefix)
    except (OSError, rosbag.ROSBagException) as error:
        raise RunError("%s: %s" % (file, str(error).splitlines()[0]))
    if messages["truth/rig_state"]:
        columns = columns_of_truth(once(messages["truth/rig_state"]), once(messages["truth/bit"]))
        companion = columns_of_companion(*(once(messages[topic]) for topic in COMPANION_TOPICS), columns["time"])
        return Run(columns, "truth", file, may_be_nan=() if messages["truth/bit"] else ("wob",), earlier=earlier, companion=companion)
    states = once(messages["rig_state"])
    columns = columns_of_states(states, {column: path for column, path in STATE.items() if path not in UNSENSED})
    columns["differential_pressure"] = numpy.where(numpy.isnan(columns["wob"]), numpy.nan, columns["differential_pressure"])
    if messages["downhole/toolface"]:
        columns["toolface"] = last_toolface(columns["time"], messages["downhole/toolface"])
    return Run(columns, "readings", file, [(m.md, m.inclination, m.azimuth) for m in messages["downhole/mwd"]], ZEROED, earlier)


def messages_of(bag, prefix):
    """Of the last run in a bag, by the topics without their prefix, and what is said of earlier ones, or ""."""
    places = {name: in_order(bag, prefix + name) for name in TOPICS}
    states = places["truth/rig_state"] or places["rig_state"]
    begin, earlier = last_run(stamps([m for _, m in states]), numpy.array([getattr(m, "epoch", 0) for _, m in states], dtype=int))
    return {name: [m for place, m in found if not begin or place >= states[begin][0]] for name, found in places.items()}, earlier


def in_order(bag, topic):
    """Places in the file and messages as they were recorded: a bag stamped with simulated time, which goes back where a node is started again, is read by
    its stamps otherwise, one run among the other."""
    connections = list(bag._get_connections([topic]))  # pylint: disable=protected-access
    entries = bag._get_entries(connections) if connections else ()  # pylint: disable=protected-access
    return [(place, bag._read_message(place).message) for place in sorted(entry.position for entry in entries)]  # pylint: disable=protected-access


def namespace_of(bag, file, wanted):
    """What stands before the topics of the rig to be judged."""
    found = sorted({topic[:-len(name)] for topic in bag.get_type_and_topic_info().topics for name in ("truth/rig_state", "rig_state")
                    if topic.endswith("/" + name) and not (name == "rig_state" and topic.endswith("/truth/rig_state"))})
    found = [prefix for prefix in found if not any(prefix == other + "companion/" for other in found)]
    if wanted is not None:
        found = [prefix for prefix in found if prefix.strip("/") == wanted.strip("/")]
    if not found:
        raise RunError("%s: has no rig_state%s" % (file, "" if wanted is None else " of the namespace " + wanted))
    if len(found) > 1:
        raise RunError("%s: has several rigs, needed: --namespace with one of %s" % (file, ", ".join(prefix.strip("/") or "/" for prefix in found)))
    return found[0]


def once(messages):
    """One message for each stamp, the last: a change that no frame brings repeats a stamp."""
    return list({m.header.stamp.to_nsec(): m for m in messages}.values())


def stamps(messages):
    return numpy.array([1e-9 * m.header.stamp.to_nsec() for m in messages])


def field(message, path):
    for part in path.split("."):
        message = getattr(message, part)
    return float(message)


def columns_of(messages, table):
    columns = {column: numpy.array([field(m, path) for m in messages]) for column, path in table.items()}
    columns["time"] = stamps(messages)
    return columns


def columns_of_states(states, table=STATE):
    """Of RigTruth or RigState; surface WOB is nan until it has been zeroed."""
    columns = columns_of(states, table)
    columns["wob"] = numpy.where([m.tared for m in states], columns["wob"], numpy.nan)
    return columns


def columns_of_truth(states, bits):
    """The rig's, and the bit's where every state has one."""
    by_stamp = {m.header.stamp.to_nsec(): m for m in bits}
    if bits:
        states = [m for m in states if m.header.stamp.to_nsec() in by_stamp]
    columns = columns_of_states(states)
    if bits:
        columns.update(columns_of([by_stamp[m.header.stamp.to_nsec()] for m in states], BIT))
    return columns


def columns_of_companion(states, bits, time):
    """The companion's in the rows of these times, nan where it is not there; {} without one."""
    if not states or not bits:
        return {}
    columns = columns_of_truth(states, bits)
    row = {stamp: k for k, stamp in enumerate(columns.pop("time"))}
    rows = numpy.array([row.get(stamp, -1) for stamp in time])
    return {name: numpy.append(values, numpy.nan)[rows] for name, values in columns.items()}


def last_toolface(time, toolfaces):
    """That was measured by then; before the first, the first."""
    last = numpy.searchsorted(stamps(toolfaces), time + 1e-9, side="right") - 1
    return numpy.array([m.toolface for m in toolfaces])[numpy.maximum(last, 0)]


def write_series(run, file):
    """A file that read_series() reads, to the last bit."""
    with open(file, "w", newline="", encoding="utf-8") as text:
        rows = csv.writer(text)
        rows.writerow(run.columns)
        rows.writerows(zip(*(column.tolist() for column in run.columns.values())))


def run_of_states(states, name="states"):
    """Of a list of states (drill_rig_sim.lockstep), by their truth."""
    return run_by(series(states, "t"), lambda path: series(states, "truth." + path), lambda path: series(states, "bit." + path), name)


def run_of_record(record, name="record"):
    """Of a drill_rig_sim.sim.Record, by its truth."""
    return run_by(record.t, record.truth.__getitem__, record.bit.__getitem__, name)


def run_by(time, truth, bit, name):
    """By what gives a field of every RigTruth or BitTruth, named by its path."""
    columns = {column: truth(path) for column, path in STATE.items()}
    columns.update({column: bit(path) for column, path in BIT.items()})
    return Run({"time": time, **columns}, "truth", name)
