#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""What other languages need of the lists in include/drill_rig_sim stands in their files as `drill reference --of` prints it, and the constants of
messages follow the lists.

Usage: test_tables.py PATH_TO_DRILL [--write]; with --write, writes the files instead.
"""
import os
import re
import subprocess
import sys
import unittest

SOURCE = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
FILES = {"RigState.msg": "msg/RigState.msg", "RigTruth.msg": "msg/RigTruth.msg", "tables.py": "src/python/tables.py"}
FLAGS_FILE = "src/python/web/flags.py"
FLAGS_HEAD = '''# SPDX-License-Identifier: BSD-3-Clause
"""What a flag means to a driller, and its rank: red is latched until it is acknowledged. Written by test/tool/test_tables.py from the table of
src/rviz/console/flags.cpp."""
FLAGS = {
'''
LAW_FILE = "src/python/web/law_points.py"
LAW_HEAD = '''# SPDX-License-Identifier: BSD-3-Clause
"""Set points of the package's laws, with the bounds of their boxes. Written by test/tool/test_tables.py from the table of
src/rviz/console/law_points.h."""
import typing


class LawPoint(typing.NamedTuple):
    name: str      # in ControllerStatus
    order: str     # in an order to the autodriller
    label: str
    quantity: str  # of drill_rig_sim.units
    least: float   # what an order may have [SI]
    most: float
    first: float   # in the box before the first start [SI]; 0: none
    optional: bool  # no limit if it is left out


LAW_POINTS = (
'''
drill_program = None


def printed(table):
    return subprocess.run([drill_program, "reference", "--of", table], stdout=subprocess.PIPE, check=True, universal_newlines=True).stdout


def read(path):
    with open(os.path.join(SOURCE, path), encoding="utf-8") as file:
        return file.read()


def write(path, text):
    with open(os.path.join(SOURCE, path), "w", encoding="utf-8") as out:
        out.write(text)


def constants(path):
    """Of the first group of constants in a message or service, by number."""
    return re.findall(r"^uint8 (\w+)=(\d+)", read(path), re.MULTILINE)


def flags():
    """Of the driller's console, as src/python/web/flags.py has them: what warns, without the accuracy of the simulation, which stands apart."""
    table = re.findall(r'^ *\{Flag::\w+, "(\w+)", "([^"]+)", Level::(\w+)\},$', read("src/rviz/console/flags.cpp"), re.MULTILINE)
    ranks = {"alarm": "red", "caution": "amber"}
    lines = ['    "%s": ("%s", "%s"),\n' % (key, ranks[level], text[0].upper() + text[1:]) for key, text, level in table
             if level in ranks and key != "accuracy_warning"]
    return FLAGS_HEAD + "".join(lines) + "}\n"


def law_points():
    """Of the driller's console, as src/python/web/law_points.py has them."""
    table = re.findall(r'^ *\{("\w+"), ("\w+"), ("[^"]+"), Dimension::(\w+), ([\de., -]+), (true|false)\},$', read("src/rviz/console/law_points.h"), re.MULTILINE)
    return LAW_HEAD + "".join('    LawPoint(%s, %s, %s, "%s", %s, %s),\n' % (*row[:5], row[5].capitalize()) for row in table) + ")\n"


def rows(path, macro):
    return re.findall(r"^%s\((\w+)," % macro, read(path), re.MULTILINE)


class Tables(unittest.TestCase):
    maxDiff = None

    def test_files_are_what_is_printed(self):
        for table, path in FILES.items():
            self.assertEqual(printed(table), read(path), "%s: write it by test/tool/test_tables.py DRILL --write" % path)

    def test_flags_of_the_page_are_those_of_the_console(self):
        self.assertEqual(flags(), read(FLAGS_FILE), "%s: write it by test/tool/test_tables.py DRILL --write" % FLAGS_FILE)
        self.assertEqual(14, flags().count('": ("'))

    def test_law_points_are_those_of_the_console(self):
        self.assertEqual(law_points(), read(LAW_FILE), "%s: write it by test/tool/test_tables.py DRILL --write" % LAW_FILE)
        self.assertEqual(7, law_points().count("    LawPoint("))

    def test_constants_follow_the_lists(self):
        for path, header, macro in (("msg/TopDriveCommand.msg", "include/drill_rig_sim/rig/top_drive_mode_list.h", "MODE"),
                                    ("srv/InjectFault.srv", "include/drill_rig_sim/scene/fault_list.h", "FAULT")):
            words = rows(header, macro)
            self.assertGreater(len(words), 5)
            self.assertEqual([(word.upper(), str(number)) for number, word in enumerate(words)], constants(path), path)

    def test_a_signal_that_no_rig_can_sense_is_in_the_truth_only(self):
        state, truth = read("msg/RigState.msg"), read("msg/RigTruth.msg")
        for name in ("on_bottom", "motor_stalled", "over_stress", "over_torque", "buckled", "steering"):
            self.assertIsNone(re.search(r"^\w+ %s " % name, state, re.MULTILINE), name)
            self.assertIsNotNone(re.search(r"^\w+ %s " % name, truth, re.MULTILINE), name)
        self.assertNotIn("lost_gauges", truth)

    def test_meanings_can_stand_in_xml(self):
        """WITSML files hold them as they are."""
        self.assertEqual([], [line for line in read("msg/RigState.msg").splitlines() if re.search("[<&]", line)])


class Layouts(unittest.TestCase):
    def test_curves_of_plotjuggler_are_fields_of_messages(self):
        messages = {"rig_state": "msg/RigState.msg", "truth/bit": "msg/BitTruth.msg"}
        curves = re.findall(r'<curve name="/rig/(\S+)/(\w+)"', read("config/plotjuggler/rig.xml"))
        self.assertGreater(len(curves), 10)
        for topic, field in curves:
            self.assertRegex(read(messages[topic]), r"(?m)^float64 %s " % field)


if __name__ == "__main__":
    if sys.argv[1:] in ([], ["--help"]):
        print(__doc__)
        sys.exit(0 if sys.argv[1:] else 2)
    drill_program = os.path.abspath(sys.argv.pop(1))
    if sys.argv[1:] == ["--write"]:
        for name, file in FILES.items():
            write(file, printed(name))
        write(FLAGS_FILE, flags())
        write(LAW_FILE, law_points())
    else:
        unittest.main()
