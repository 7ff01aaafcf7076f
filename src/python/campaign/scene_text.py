# SPDX-License-Identifier: BSD-3-Clause
"""A scene's file with places in it for values: any of its keys, those that it leaves out too."""
import json
import os
import re

import yaml
from drill_rig_sim.campaign.measures import split, with_unit

STEP = re.compile(r"([A-Za-z_][A-Za-z_0-9]*)((?:\[[^\]]+\])*)$")


class SceneTextError(Exception):
    """What is wrong with a key or a file, in one line."""


class Times(float):
    """A value that multiplies the number that stands there."""


class SceneText:
    """Text of a scene in which `keys` take other values. A key is a path: numerics.tolerance, formation[0].drillability, string[bit].diameter (the part of
    this name), well.sections[*].friction (all of them). SceneTextError where the scene has no such place."""

    def __init__(self, text, keys):
        try:
            root = yaml.compose(text, Loader=yaml.SafeLoader)
        except yaml.YAMLError as error:
            raise SceneTextError(str(error).replace("\n", " "))
        self.text = text
        self.places = []    # begin, end, and what to write: a key, or a tree of keys that are missing there
        self.missing = {}   # where a mapping begins: the mapping, and the tree of keys to be put into it
        for key in keys:
            self.find(root, steps_of(key), key)
        for node, tree in self.missing.values():
            at = node.start_mark.index + (1 if node.flow_style else 0)
            self.places.append((at, at, tree))
        self.places.sort(key=lambda place: place[0])
        for before, after in zip(self.places, self.places[1:]):
            if before[1] > after[0] or before[:2] == after[:2]:
                raise SceneTextError("%s and %s are the same key" % (leaves(before[2])[0], leaves(after[2])[0]))

    def find(self, node, steps, key):
        """Notes where the path leads from a node: a value to be replaced, or keys to be put in."""
        if not steps:
            if not (isinstance(node, yaml.ScalarNode) or node.flow_style):
                raise SceneTextError("%s: is a section; name the keys in it" % key)
            self.places.append((node.start_mark.index, node.end_mark.index, key))
            return
        step, rest = steps[0], steps[1:]
        if step.startswith("["):
            for item in items(node, step[1:-1], key):
                self.find(item, rest, key)
            return
        if not isinstance(node, yaml.MappingNode):
            raise SceneTextError("%s: the part before %s is not a section" % (key, step))
        for name, value in node.value:
            if name.value == step:
                self.find(value, rest, key)
                return
        if any(name.startswith("[") for name in rest):
            raise SceneTextError("%s: the scene has no %s" % (key, step))
        tree = self.missing.setdefault(node.start_mark.index, (node, {}))[1]
        for name in steps[:-1]:
            tree = tree.setdefault(name, {})
            if isinstance(tree, str):
                raise SceneTextError("%s and %s are the same key" % (tree, key))
        if steps[-1] in tree:
            raise SceneTextError("%s and %s are the same key" % (leaves(tree[steps[-1]])[0], key))
        tree[steps[-1]] = key

    def with_values(self, values):
        """The text with a value for each key: number, text, boolean, list or mapping, or Times. Keys that a block of lines does not have come as lines
        of their own before its first."""
        return "".join(part for part, _ in self.parts(values))

    def keys_on(self, line, values):
        """The keys whose values stand on a line of with_values(), from 1 on."""
        found, at = [], 1
        for part, keys in self.parts(values):
            found += keys if at == line else []
            at += part.count("\n")
        return found

    def line_of(self, line, values):
        """The line of the scene's own text that is a line of with_values(), from 1 on; None where that is one of the keys that the text does not have."""
        at = own = 1
        last = 0
        for begin, end, what in self.places:
            at, own, last = at + self.text.count("\n", last, begin), 1 + self.text.count("\n", 0, begin), end
            put_in = 0 if isinstance(what, str) else sum(part.count("\n") for part, _ in self.put_in(begin, what, values))
            if at > line or (at == line and not put_in):
                return own - (at - line)
            if line < at + put_in:
                return None
            at += put_in
        return 1 + self.text.count("\n", 0, last) + line - at

    def parts(self, values):
        """with_values() piece by piece, each with the keys whose values it holds."""
        at = 0
        for begin, end, what in self.places:
            yield self.text[at:begin], []
            if isinstance(what, str):
                yield self.replaced(begin, end, values[what], what), [what]
            else:
                yield from self.put_in(begin, what, values)
            at = end
        yield self.text[at:], []

    def replaced(self, begin, end, value, key):
        if not isinstance(value, Times):
            return written(value)
        number, unit = split(yaml.safe_load(self.text[begin:end]))
        try:
            return written(with_unit(float(value) * (float(self.text[begin:end]) if number is None else number), unit))
        except ValueError:
            raise SceneTextError("%s: %s is not a number, so it cannot be multiplied" % (key, self.text[begin:end]))

    def put_in(self, begin, tree, values):
        if self.text[begin - 1] == "{":
            inside = ", ".join("%s: %s" % (name, flow(what, values)) for name, what in tree.items())
            return [(inside + (", " if self.text[begin:].lstrip()[:1] != "}" else ""), leaves(tree))]
        column = begin - (self.text.rfind("\n", 0, begin) + 1)
        return [("%s: %s\n%s" % (name, flow(what, values), " " * column), leaves(what)) for name, what in tree.items()]


def survey_of_well(scene, scene_file):
    """What stands under well.survey in a scene's text: the key of the file's name and that name; None where there is none."""
    try:
        survey = ((yaml.safe_load(scene) or {}).get("well") or {}).get("survey")
        if isinstance(survey, dict):
            return "well.survey.file", survey.get("file")
    except (yaml.YAMLError, AttributeError) as error:
        raise SceneTextError("%s: is not a scene: %s" % (scene_file, " ".join(str(error).split())))
    return "well.survey", survey


def survey_file(scene, scene_file):
    """The path of the survey that a scene's text names, which counts from the scene's file; None where it has none."""
    name = survey_of_well(scene, scene_file)[1]
    return None if name is None else os.path.join(os.path.dirname(scene_file), str(name))


def steps_of(key):
    """Names and indices in brackets, one after the other."""
    steps = []
    for part in key.split("."):
        match = STEP.match(part)
        if not match:
            raise SceneTextError("%s: is not a key; examples: numerics.tolerance, formation[0].drillability, string[bit].diameter" % key)
        steps += [match.group(1)] + ["[%s]" % index for index in re.findall(r"\[([^\]]+)\]", match.group(2))]
    return steps


def items(node, index, key):
    """Of a sequence: all by *, one by its number or its name."""
    if not isinstance(node, yaml.SequenceNode):
        raise SceneTextError("%s: [%s] follows a value that is not a list" % (key, index))
    if index == "*":
        found = list(node.value)
    elif index.isdigit():
        found = node.value[int(index):int(index) + 1]
    else:
        found = [item for item in node.value if isinstance(item, yaml.MappingNode) and
                 any(name.value == "name" and value.value == index for name, value in item.value)]
    if not found:
        raise SceneTextError("%s: the list has no [%s]" % (key, index))
    return found


def leaves(what):
    """The keys of a tree of them."""
    return [what] if isinstance(what, str) else [key for inner in what.values() for key in leaves(inner)]


def flow(what, values):
    if isinstance(what, str):
        if isinstance(values[what], Times):
            raise SceneTextError("%s: the scene does not set it, so it cannot be multiplied" % what)
        return written(values[what])
    return "{%s}" % ", ".join("%s: %s" % (name, flow(inner, values)) for name, inner in what.items())


def written(value):
    """As YAML in one line. 1.0e-9 needs its point: without it YAML reads a text."""
    if isinstance(value, float):
        text = repr(float(value))  # of NumPy 2, repr is np.float64(1.5)
        return text if "e" not in text or "." in text else text.replace("e", ".0e")
    if isinstance(value, list):
        return "[%s]" % ", ".join(written(item) for item in value)
    if isinstance(value, dict):
        return "{%s}" % ", ".join("%s: %s" % (json.dumps(name), written(item)) for name, item in value.items())
    return json.dumps(value)
