# SPDX-License-Identifier: BSD-3-Clause
"""A bag as a source: all of it at once."""
from diagnostic_msgs.msg import DiagnosticArray
from drill_rig_sim.score_runs import RunError, namespace_of
from drill_rig_sim.web.news import STATE, STATE_KIND, TOPICS, TRUTH, TRUTH_KIND, News, ReadSource, margin_of


class BagSource(ReadSource):
    """RunError where the file is no bag, or has no rig_state of this version."""

    def __init__(self, file, namespace=None):
        try:
            import rosbag  # needed only for bags
        except ImportError:
            raise RunError("%s: bags need Debian's python3-rosbag" % file) from None
        try:
            with rosbag.Bag(file) as bag:
                super().__init__(file, news_of(bag, file, namespace_of(bag, file, namespace)))
        except (OSError, rosbag.ROSBagException) as error:
            raise RunError("%s: %s" % (file, str(error).splitlines()[0])) from None


def news_of(bag, file, prefix):
    states = raw_messages(bag, file, prefix + STATE, STATE_KIND)
    if not states:
        raise RunError("%s: has no message of %srig_state" % (file, prefix))
    latest = {}
    for topic, (what, kind) in TOPICS.items():
        found = raw_messages(bag, file, prefix + topic, kind)
        if found:
            latest[what] = kind().deserialize(found[-1])
    diagnostics = raw_messages(bag, file, "/diagnostics", DiagnosticArray)
    margins = (margin_of(DiagnosticArray().deserialize(data), prefix) for data in reversed(diagnostics))
    margin = next((one for one in margins if one is not None), None)
    if margin is not None:
        latest["margin"] = margin
    return News(states, raw_messages(bag, file, prefix + TRUTH, TRUTH_KIND), STATE_KIND().deserialize(states[-1]), latest)


def raw_messages(bag, file, topic, kind):
    """Their bytes, in the order in which they were recorded: simulated time goes back where a node was started again."""
    connections = list(bag._get_connections([topic]))  # pylint: disable=protected-access
    old = [c for c in connections if c.md5sum != kind._md5sum]  # pylint: disable=protected-access
    if old:
        raise RunError("%s: %s is of another version of %s" % (file, topic, kind._type))  # pylint: disable=protected-access
    entries = bag._get_entries(connections) if connections else ()  # pylint: disable=protected-access
    places = sorted(entry.position for entry in entries)
    return [bag._read_message(place, raw=True).message[1] for place in places]  # pylint: disable=protected-access
