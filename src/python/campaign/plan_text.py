# SPDX-License-Identifier: BSD-3-Clause
"""A campaign's file as YAML whose every key is known: errors name file, line and key, and say what is allowed."""
import yaml
from drill_rig_sim.campaign import measures
from drill_rig_sim.refusal import Refusal
from drill_rig_sim.text_file import TextError, read_text


class PlanError(Refusal):
    """What is wrong with a plan, in one line."""


class Entry:
    """A value of the plan and where it stands."""

    def __init__(self, file, node, key):
        self.file, self.node, self.key = file, node, key

    def place(self):
        """Where a message says that it stands."""
        return "%s:%d%s" % (self.file, self.node.start_mark.line + 1, ": " + self.key if self.key else "")

    def fail(self, text):
        raise PlanError("%s: %s" % (self.place(), text))

    # --- what it may be

    def mapping(self, allowed=None, needed=()):
        """Entries by name; with `allowed`, no others than these."""
        if not isinstance(self.node, yaml.MappingNode):
            self.fail("needed: keys and values")
        found = {}
        for name, value in self.node.value:
            entry = Entry(self.file, value, ("%s.%s" % (self.key, name.value)).lstrip("."))
            if not isinstance(name, yaml.ScalarNode) or (allowed is not None and name.value not in allowed):
                Entry(self.file, name, str(name.value)).fail("unknown key, allowed: %s" % ", ".join(allowed or ()))
            if name.value in found:
                Entry(self.file, name, name.value).fail("is given twice")
            found[name.value] = entry
        for name in needed:
            if name not in found:
                self.fail("needs %s" % name)
        return found

    def is_sequence(self):
        return isinstance(self.node, yaml.SequenceNode)

    def sequence(self):
        if not self.is_sequence() or not self.node.value:
            self.fail("needed: a list of one or more")
        return [Entry(self.file, item, "%s[%d]" % (self.key, index)) for index, item in enumerate(self.node.value)]

    def text(self):
        if not isinstance(self.node, yaml.ScalarNode) or not self.node.value:
            self.fail("needed: a text")
        return self.node.value

    def measure(self, beyond=None, unit=None):
        """A number and its unit, "" without one. `unit`: the only one allowed."""
        value, given = measures.split(self.node.value)
        if unit is not None and given != unit:
            self.fail("is %s, needed: a number %s" % (self.node.value, "in %s" % unit if unit else "without a unit"))
        if value is None:
            return self.number(beyond=beyond), ""
        if beyond is not None and not value > beyond:
            self.fail("is %s, needed: a number above %g %s" % (self.node.value, beyond, given))
        return value, given

    def number(self, least=None, beyond=None, most=None):
        """At least `least`, above `beyond`, at most `most`."""
        allowed = "a number" + "".join(" %s %g" % (word, limit) for word, limit in (("from", least), ("above", beyond), ("up to", most)) if limit is not None)
        try:
            value = float(self.node.value)
        except (TypeError, ValueError):
            self.fail("needed: " + allowed)
        good = abs(value) < float("inf") and (least is None or value >= least) and (beyond is None or value > beyond) and (most is None or value <= most)
        return value if good else self.fail("is %s, needed: %s" % (self.node.value, allowed))

    def whole(self, least=0, most=10**9):
        value = self.number(least, most=most)
        return int(value) if value == int(value) else self.fail("is %s, needed: a whole number" % self.node.value)

    def choice(self, allowed):
        return self.node.value if self.node.value in allowed else self.fail("is %s, allowed: %s" % (self.node.value, ", ".join(allowed)))

    def yes(self):
        return self.choice(("true", "false")) == "true"

    def plain(self):
        """As YAML has it; texts that are numbers (1e-9) are numbers."""
        if isinstance(self.node, yaml.MappingNode):
            return {name: entry.plain() for name, entry in self.mapping().items()}
        if isinstance(self.node, yaml.SequenceNode):
            return [Entry(self.file, item, self.key).plain() for item in self.node.value]
        try:
            value = yaml.SafeLoader("").construct_object(self.node)
        except (ValueError, yaml.YAMLError):
            self.fail("%s cannot be read as a value" % self.node.value)
        if isinstance(value, str) and self.node.style is None:
            try:
                return float(value)
            except ValueError:
                pass
        return value


def no_yaml(file, error):
    """The line on an error of YAML, with its place."""
    mark, problem = getattr(error, "problem_mark", None), getattr(error, "problem", None)
    said = " ".join(str(problem or error).split()).replace("'\\t' that cannot start any token", "tab, which YAML allows in texts only")
    return "%s%s: is not valid YAML: %s" % (file, ":%d" % (mark.line + 1) if mark else "", said)


def plan_of(file):
    """The whole of a plan's file as an Entry."""
    try:
        root = yaml.compose(read_text(file), Loader=yaml.SafeLoader)
    except TextError as error:
        raise PlanError(str(error))
    except RecursionError:
        raise PlanError("%s: is nested too deeply" % file)
    except yaml.YAMLError as error:
        raise PlanError(no_yaml(file, error))
    if root is None:
        raise PlanError("%s: is empty" % file)
    return Entry(file, root, "")
