# SPDX-License-Identifier: BSD-3-Clause
"""The readings of a bag as rows of a live feed."""
from drill_rig_sim.field.feed_row import Row, measured
from drill_rig_sim.field.signals import SIGNALS
from drill_rig_sim.field.table import RecordError
from drill_rig_sim.score_runs import RunError, namespace_of

PLAYED = tuple(name for name in SIGNALS if name not in ("time", "block_velocity"))  # fields of RigState


def bag_rows(file, namespace, every, say):
    """Rows of rig_state in the order in which it was recorded, one row each `every` seconds of its stamps. RecordError where there is none."""
    try:
        import rosbag  # needed only for bags
    except ImportError:
        raise RecordError("%s: bags need Debian's python3-rosbag" % file) from None
    try:
        with rosbag.Bag(file) as bag:
            yield from rows_of(bag, namespace_of(bag, file, namespace) + "rig_state", every, say)
    except rosbag.ROSBagException as error:
        raise RecordError("%s: %s" % (file, str(error).splitlines()[0])) from None
    except RunError as error:
        raise RecordError(str(error)) from None


def rows_of(bag, topic, every, say):
    due = None
    for count, (_, state, _) in enumerate(bag.read_messages([topic]), 1):
        time = state.header.stamp.to_sec()
        if due is None or time >= due - 1e-6 or time < due - 2.0 * every:  # time may go back, which is judged elsewhere
            due = time + every
            place = "message %d" % count
            yield Row(place, time, {name: measured(name, getattr(state, name), 1.0, "%s: %s" % (place, name), say) for name in PLAYED})
