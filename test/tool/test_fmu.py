#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""drill fmu: an FMU of a scene by an importer that follows the text of FMI 2.0, beside the same rig in this process. Usage: test_fmu.py PATH_TO_DRILL"""
import ctypes
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as xml
import zipfile

from drill_rig_sim.sim import Simulator

SOURCE = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
QUICK = os.path.join(SOURCE, "config/scenes/quick.yaml")
OK, WARNING, DISCARD, ERROR = range(4)
CO_SIMULATION = 1
RPM = 3.141592653589793 / 30.0
LOGGER = ctypes.CFUNCTYPE(None, ctypes.c_void_p, ctypes.c_char_p, ctypes.c_int, ctypes.c_char_p, ctypes.c_char_p, ctypes.c_char_p)
KINDS = {"Real": ("Real", ctypes.c_double), "Integer": ("Integer", ctypes.c_int), "Enumeration": ("Integer", ctypes.c_int), "Boolean": ("Boolean", ctypes.c_int)}
drill_program = None


class Callbacks(ctypes.Structure):
    _fields_ = [("logger", LOGGER), ("allocate", ctypes.c_void_p), ("free", ctypes.c_void_p), ("finished", ctypes.c_void_p), ("environment", ctypes.c_void_p)]


class Fmu:
    """One instance of an unpacked FMU."""

    def __init__(self, folder, guid=None):
        self.folder = folder
        self.description = xml.parse(os.path.join(folder, "modelDescription.xml")).getroot()
        self.variables = {v.get("name"): (int(v.get("valueReference")), v[0].tag) for v in self.description.iter("ScalarVariable")}
        name = self.description.find("CoSimulation").get("modelIdentifier")
        self.library = ctypes.CDLL(os.path.join(folder, "binaries/linux64", name + ".so"))
        self.library.fmi2Instantiate.restype = ctypes.c_void_p
        self.said = []
        self.logger = LOGGER(lambda _, name, status, category, form, text: self.said.append((status, text.decode())))
        self.callbacks = Callbacks(self.logger)
        resources = pathlib.Path(folder, "resources").as_uri().encode()
        self.instance = self.library.fmi2Instantiate(b"rig", CO_SIMULATION, (guid or self.description.get("guid")).encode(), resources, ctypes.byref(self.callbacks), 0, 1)

    def call(self, name, *arguments):
        return getattr(self.library, "fmi2" + name)(ctypes.c_void_p(self.instance), *arguments)

    def set(self, name, value):
        reference, kind = self.variables[name]
        function, number = KINDS[kind]
        return self.call("Set" + function, ctypes.byref(ctypes.c_uint(reference)), ctypes.c_size_t(1), ctypes.byref(number(value)))

    def get(self, name):
        reference, kind = self.variables[name]
        function, number = KINDS[kind]
        value = number()
        assert OK == self.call("Get" + function, ctypes.byref(ctypes.c_uint(reference)), ctypes.c_size_t(1), ctypes.byref(value)), self.said
        return value.value

    def begin(self, **parameters):
        assert self.instance, self.said
        assert OK == self.call("SetupExperiment", 0, ctypes.c_double(0.0), ctypes.c_double(0.0), 0, ctypes.c_double(0.0))
        for name, value in parameters.items():
            assert OK == self.set(name, value), self.said
        assert OK == self.call("EnterInitializationMode"), self.said
        assert OK == self.call("ExitInitializationMode"), self.said
        self.time = 0.0
        return self

    def step(self, duration, status=OK):
        said = self.call("DoStep", ctypes.c_double(self.time), ctypes.c_double(duration), 1)
        assert said == status, (said, self.said)
        if status in (OK, WARNING):
            self.time += duration

    def outputs(self):
        return {name: self.get(name) for name in self.variables if name.startswith(("readings.", "truth."))}


class Fmus(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.file = os.path.join(folder.name, "rig.fmu")
        subprocess.run([drill_program, "fmu", QUICK, "--out", cls.file], check=True)
        cls.folder = os.path.join(folder.name, "a folder")  # its space is an escape in the location of the resources
        with zipfile.ZipFile(cls.file) as content:
            content.extractall(cls.folder)

    def fmu(self, **parameters):
        fmu = Fmu(self.folder).begin(play_program=False, **parameters)
        self.addCleanup(fmu.call, "FreeInstance")
        return fmu

    def drilling(self, fmu, seconds):
        fmu.set("winch.brake", False)
        fmu.set("winch.block_velocity", -0.02)
        fmu.set("top_drive.speed", 90.0 * RPM)
        fmu.step(seconds)

    def test_the_archive_and_its_description(self):
        with zipfile.ZipFile(self.file) as content:
            self.assertEqual({"modelDescription.xml", "resources/scene.yaml", "resources/rate", "binaries/linux64/drill_rig_sim_fmu.so", "binaries/linux64/libdrill_rig_sim.so.0.3"},
                             set(content.namelist()))
        top = xml.parse(os.path.join(self.folder, "modelDescription.xml")).getroot()
        self.assertEqual(("2.0", "drill_rig_sim.quick"), (top.get("fmiVersion"), top.get("modelName")))
        self.assertEqual(["CoSimulation", "UnitDefinitions", "TypeDefinitions", "LogCategories", "DefaultExperiment", "ModelVariables", "ModelStructure"],
                         [part.tag for part in top])  # the order of the schema
        variables = list(top.iter("ScalarVariable"))
        units = {unit.get("name") for unit in top.iter("Unit")}
        self.assertEqual(len(variables), len({v.get("name") for v in variables}))
        for k, variable in enumerate(variables):
            self.assertEqual(k, int(variable.get("valueReference")))
            self.assertEqual(variable.get("causality") != "output", variable[0].get("start") is not None, variable.get("name"))
            if variable[0].tag == "Real" and variable[0].get("unit"):
                self.assertIn(variable[0].get("unit"), units)
        outputs = [k + 1 for k, v in enumerate(variables) if v.get("causality") == "output"]
        for part in ("Outputs", "InitialUnknowns"):
            self.assertEqual(outputs, [int(unknown.get("index")) for unknown in top.find("ModelStructure").find(part)])
        self.assertTrue(all(unit.find("BaseUnit") is not None for unit in top.iter("Unit")), units)
        self.assertIn("OSCILLATE", [item.get("name").upper() for item in top.iter("Item")])

    def test_it_is_the_rig_in_lockstep_to_the_last_bit(self):
        fmu, rig = self.fmu(seed=3), Simulator(QUICK, seed=3)
        self.drilling(fmu, 5.0)
        rig.rotate(rpm=90)
        rig.winch(-0.02)
        state = rig.step(5.0)
        fmu.step(0.01)
        state = rig.step(0.01)
        outputs = fmu.outputs()
        for name in ("hook_load", "torque", "block_height", "bit_depth", "surface_wob", "tared", "in_slips", "stand_count"):
            self.assertEqual(getattr(state.readings, name), outputs["readings." + name], name)
            self.assertEqual(getattr(state.truth, name), outputs["truth." + name], name)
        self.assertEqual(state.bit.wob, outputs["truth.wob"])
        self.assertNotEqual(0.0, outputs["truth.bit_speed"])

    def test_the_rate_of_the_command_line_holds_where_the_importer_sets_none(self):
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([drill_program, "fmu", QUICK, "--out", os.path.join(folder, "rig.fmu"), "--rate", "50"], check=True)
            with zipfile.ZipFile(os.path.join(folder, "rig.fmu")) as content:
                content.extractall(folder)
            fmu, rig = Fmu(folder).begin(play_program=False), Simulator(QUICK, rate=50.0)
            self.addCleanup(fmu.call, "FreeInstance")
            self.assertEqual(50.0, fmu.get("rate"))
            fmu.step(0.01, ERROR)
            self.drilling(fmu, 3.0)
            rig.rotate(rpm=90)
            rig.winch(-0.02)
            self.assertEqual(rig.step(3.0).truth.torque, fmu.get("truth.torque"))

    def test_a_state_is_gone_back_to(self):
        fmu = self.fmu()
        self.drilling(fmu, 1.0)
        state, time = ctypes.c_void_p(None), fmu.time
        self.assertEqual(OK, fmu.call("GetFMUstate", ctypes.byref(state)))
        fmu.step(1.0)
        first = fmu.outputs()
        self.assertEqual(OK, fmu.call("SetFMUstate", state))
        fmu.time = time
        fmu.step(1.0)
        self.assertEqual(first, fmu.outputs())
        self.assertEqual(OK, fmu.call("FreeFMUstate", ctypes.byref(state)))
        self.assertIsNone(state.value)

    def test_the_scene_program_plays_until_a_set_point_changes(self):
        fmu = Fmu(self.folder).begin()
        self.addCleanup(fmu.call, "FreeInstance")
        rig = Simulator(QUICK, play_program=True)
        fmu.step(3.0)
        self.assertEqual(rig.step(3.0).truth.block_height, fmu.get("truth.block_height"))

    def test_reset_begins_again(self):
        fmu = self.fmu()
        first = fmu.outputs()
        self.drilling(fmu, 1.0)
        self.assertNotEqual(first, fmu.outputs())
        self.assertEqual(OK, fmu.call("Reset"))
        fmu.begin(play_program=False)
        self.assertEqual(first, fmu.outputs())

    def test_no_step_follows_its_end(self):
        fmu = self.fmu()
        self.assertEqual(OK, fmu.call("Terminate"))
        fmu.step(0.01, ERROR)
        self.assertEqual("fmi2DoStep: the FMU is terminated; needed: fmi2Reset", fmu.said[-1][1])
        self.assertEqual(OK, fmu.call("Reset"))
        fmu.begin(play_program=False)
        fmu.step(0.01)

    def test_two_instances_do_not_mix(self):
        one, other = self.fmu(), self.fmu()
        at_rest = other.outputs()
        self.drilling(one, 1.0)
        self.assertEqual(at_rest, other.outputs())

    def test_what_is_wrong_is_refused_in_one_line(self):
        fmu = self.fmu()
        for said, call in (("winch.block_velocity must be a finite number", lambda: fmu.set("winch.block_velocity", float("nan"))),
                           ("top_drive.mode must be 0 to", lambda: fmu.set("top_drive.mode", 77)),
                           ("seed is a parameter", lambda: fmu.set("seed", 9)),
                           ("truth.wob is an output", lambda: fmu.set("truth.wob", 1.0)),
                           ("fmi2CancelStep is not available", lambda: fmu.call("CancelStep"))):
            del fmu.said[:]
            self.assertEqual(ERROR, call(), said)
            self.assertEqual([ERROR], [status for status, _ in fmu.said])
            self.assertIn(said, fmu.said[0][1])
            self.assertNotIn("\n", fmu.said[0][1])
        for duration in (0.013, 0.0, -1.0, float("inf")):
            del fmu.said[:]
            fmu.step(duration, ERROR)
            self.assertIn("the communication step must be a whole number of frames of 0.01 s", fmu.said[0][1])
        fmu.step(0.01)

    def test_what_the_rig_refuses_is_a_warning_and_tried_again(self):
        fmu = self.fmu()
        fmu.set("steering.ratio", 0.5)
        fmu.step(0.01, WARNING)
        fmu.step(0.01, WARNING)
        self.assertEqual(1, len(fmu.said), fmu.said)
        self.assertIn("steering: ", fmu.said[0][1])

    def test_tare_is_the_rising_edge_of_an_input(self):
        fmu = self.fmu()
        fmu.set("tare", True)
        fmu.step(0.01)
        self.assertTrue(fmu.get("truth.tared"))

    def test_a_description_of_another_program_is_refused(self):
        fmu = Fmu(self.folder, guid="{another}")
        self.assertIsNone(fmu.instance)
        self.assertIn("the guid must be {drill_rig_sim-", fmu.said[0][1])

    def test_the_command_line(self):
        for words, said in (((QUICK, "--out", "/no/folder/rig.fmu"), "drill fmu: --out: /no/folder/rig.fmu cannot be written"),
                            ((QUICK, "--out", self.file, "--rate", "300.7", "--set", "numerics.step=0.01"), "rate")):
            done = subprocess.run([drill_program, "fmu", *words], stdout=subprocess.PIPE, stderr=subprocess.PIPE, universal_newlines=True, check=False)
            self.assertEqual((2, 1), (done.returncode, len(done.stderr.splitlines())), done.stderr)
            self.assertIn(said, done.stderr)


if __name__ == "__main__":
    drill_program = os.path.abspath(sys.argv.pop(1))
    unittest.main()
