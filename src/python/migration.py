# SPDX-License-Identifier: BSD-3-Clause
"""Bags of version 0.2, whose truth/rig_state was a RigState, for this version (migrate_bag)."""
import math
import os
import sys

import genpy
import rosbag
from drill_rig_sim.msg import RigState, RigTruth
from drill_rig_sim.refusal import Refusal

TRUTH = "truth/rig_state"
USAGE = "usage: migrate_bag OLD.bag NEW.bag\nWrites NEW.bag: the messages of OLD.bag, which version 0.2 recorded, as this version has them."


ADDED = {"epoch": 0, "encoder_bit_depth": math.nan, "accuracy_code": "", "accuracy_reason": "", "commands_refused": 0, "last_refusal": "", "active_faults": [], "active_fault_depths": [], "cuttings_volume": 0.0, "bed_height": 0.0, "flow_line_temperature": 0.0,
         "bottom_hole_temperature": 0.0}  # fields that version 0.2 did not have


def copy_fields(old, new):
    """Fills a message with those fields of another that it has too, or that were added since; a ValueError names one that the other does not have."""
    for name in new.__slots__:
        if not hasattr(old, name) and name not in ADDED:
            raise ValueError("has no %s" % name)
        setattr(new, name, getattr(old, name, ADDED.get(name)))
    return new


def is_truth(topic):
    return topic == TRUTH or topic.endswith("/" + TRUTH)


def migrated(topic, kind, message):
    """The RigState or RigTruth that a message of 0.2 becomes; None: it stays as it is. `kind`: type and checksum in the bag."""
    present = RigTruth if is_truth(topic) else RigState
    if kind[0] != RigState._type or kind == (present._type, present._md5sum):
        return None
    return copy_fields(message(), present())


def migrate(old, new):
    """Writes the bag `new`, which must not be there yet; the number of messages that changed. A Refusal says why not, and leaves no file behind."""
    if os.path.exists(new):
        raise Refusal("%s: already exists; needed: the name of a new file" % new)
    try:
        with rosbag.Bag(old) as source, rosbag.Bag(new, "w", options=source.options) as target:
            return sum(hand_on(entry, target) for entry in source.read_messages(raw=True, return_connection_header=True))
    except (OSError, ValueError, genpy.DeserializationError, rosbag.ROSBagException) as error:
        if os.path.exists(new):
            os.remove(new)
        raise Refusal("%s: %s" % (old, str(error).splitlines()[0])) from None


def hand_on(entry, target):
    """Writes one message; whether it changed."""
    topic, raw, stamp, connection = entry
    message = migrated(topic, (raw[0], raw[2]), lambda: raw[4]().deserialize(raw[1]))
    if message is None:
        target.write(topic, raw, stamp, raw=True, connection_header=connection)
        return False
    header = {**connection, "type": message._type, "md5sum": message._md5sum, "message_definition": message._full_text}
    target.write(topic, message, stamp, connection_header=header)
    return True


def main(words):
    if words in ([], ["--help"]):
        print(USAGE)
        return 0 if words else 2
    try:
        if len(words) != 2:
            raise Refusal("two files are needed, OLD.bag and NEW.bag (got %d)" % len(words))
        print("%s: %d messages changed" % (words[1], migrate(*words)))
    except Refusal as refusal:
        print("migrate_bag: %s" % refusal, file=sys.stderr)
        return 2
    return 0
