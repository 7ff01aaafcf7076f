#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Inputs that were handled badly once, found by fuzzing: each is refused in one line, solved, or ended by a bound that names itself, within
10 s of processor time and 1 GB of memory. Usage: test_bad_inputs.py PATH_TO_DRILL [--instrumented]: without these bounds, which are not
for sanitizers: they map far more than they use"""
import os
import resource
import shutil
import subprocess
import sys
import tempfile
import unittest

INPUTS = os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(__file__))), 'bad_inputs')
SECONDS = 10
BYTES = 10 ** 9
drill_program = None
instrumented = False


def bounded():
    if instrumented:
        return
    resource.setrlimit(resource.RLIMIT_CPU, (SECONDS, SECONDS))
    resource.setrlimit(resource.RLIMIT_AS, (BYTES, BYTES))


def drill(*words):
    """Wall time is bounded more widely: the machine may be busy with others."""
    with tempfile.TemporaryDirectory() as folder:
        return subprocess.run([drill_program, *words], stdout=subprocess.PIPE, stderr=subprocess.PIPE, preexec_fn=bounded, cwd=folder,
                              timeout=20 * SECONDS)


class BadInputs(unittest.TestCase):
    def clean(self, text):
        """Nothing of a file's control characters reaches the terminal."""
        for line in text.decode().split("\n"):
            self.assertTrue(all(sign.isprintable() for sign in line), line)
            self.assertLess(len(line), 1000, line)
        return text.decode()

    def refused(self, name, *words, command='check', folder=INPUTS):
        """Exit status 2 and one line that begins with the file's name and holds `words`."""
        file = os.path.join(folder, name)
        done = drill(command, file)
        message = self.clean(done.stderr)
        self.assertEqual(done.returncode, 2, message)
        self.assertEqual(done.stdout, b'')
        self.assertEqual(len(message.splitlines()), 1, message)
        self.assertTrue(message.startswith(file + ':'), message)
        for word in words:
            self.assertIn(word, message)
        return message

    def good(self, *words):
        done = drill(*words)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.clean(done.stdout)
        return done.stdout.decode()

    def scene(self, name, old, new):
        """A copy of an input with one text replaced."""
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        with open(os.path.join(INPUTS, name), encoding='latin-1') as text:
            scene = text.read()
        self.assertIn(old, scene)
        with open(os.path.join(folder.name, name), 'w', encoding='latin-1') as out:
            out.write(scene.replace(old, new))
        return os.path.join(folder.name, name)

    # yaml-cpp's LoadAll takes all memory where a document is followed by what begins none
    def test_yaml_hang_comma(self):
        self.refused('yaml_hang_comma.yaml', ':1: YAML: a second YAML document')

    def test_yaml_hang_json_comma(self):
        self.refused('yaml_hang_json_comma.yaml', ':1: YAML: a second YAML document')

    def test_yaml_hang_fuzz1(self):
        self.refused('yaml_hang_fuzz1.yaml', ':1: contains a NUL byte')
        self.refused(self.scene('yaml_hang_fuzz1.yaml', '\0', ' '), ':1: YAML: a second YAML document')

    def test_yaml_hang_fuzz2(self):
        self.refused('yaml_hang_fuzz2.yaml', ':1: contains a NUL byte')
        self.refused(self.scene('yaml_hang_fuzz2.yaml', '\0', ' '), ':1: YAML: a second YAML document')

    def test_values_of_yaml_are_counted(self):
        file = self.scene('stab_5cm.yaml', 'name: quick', 'name: [%s]' % ('0,' * 300000))
        self.refused(file, 'more than 200000 values')

    # regular files up to 16 MiB only
    def test_survey_zero(self):
        self.refused('survey_zero.yaml', ':5: well.survey: /dev/zero: is not a regular file')

    def test_survey_fifo(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        shutil.copy(os.path.join(INPUTS, 'survey_fifo.yaml'), folder.name)
        os.mkfifo(os.path.join(folder.name, 'fifo'))
        self.refused('survey_fifo.yaml', ':5: well.survey: ', 'fifo: is not a regular file', folder=folder.name)
        self.refused('fifo', 'is not a regular file', folder=folder.name)
        self.refused('fifo', 'is not a regular file', folder=folder.name, command='survey')

    def test_scenes_that_are_no_files(self):
        self.refused('/dev/zero', 'is not a regular file')
        self.refused('/dev/zero', 'is not a regular file', command='survey')
        self.refused(INPUTS, 'is not a regular file')

    def test_large_files(self):
        with tempfile.NamedTemporaryFile() as large:
            large.truncate(16 << 20)
            self.assertNotIn('larger', self.refused(large.name, ':1: contains a NUL byte', command='survey'))
            large.truncate((16 << 20) + 1)
            self.refused(large.name, 'is larger than 16 MiB')
            self.refused(large.name, 'is larger than 16 MiB', command='survey')

    def test_a_wrong_file_is_not_echoed(self):
        with tempfile.NamedTemporaryFile('w', suffix='.csv') as secret:
            secret.write('md_m,inclination_deg,azimuth_deg\nsecret,0,0\n')
            secret.flush()
            self.assertNotIn('secret', self.refused(secret.name, ':2: md_m: must be a finite number (got text)', command='survey'))
            self.assertNotIn('secret', self.refused(secret.name, ':1: text is given, allowed: a block'))

    def test_trajectories_that_would_fill_the_memory(self):
        for text, problem in (('<a>' * 5000000, 'more than 2000000 elements'), ('<a>' * 1900000, 'is not an XML document'), ('<a/>' * 1900000, 'has no trajectory'),
                              ('<t>' + '<a b="" c=""/>' * 600000 + '</t>', 'has no trajectory'), ('<!DOCTYPE t [<!ENTITY a "%s">]><t>&a;</t>' % ('x' * 9), 'has no trajectory')):
            with tempfile.NamedTemporaryFile('w', suffix='.xml') as document:
                document.write(text)
                document.flush()
                self.refused(document.name, problem, command='survey')

    # lengths that no string has
    def test_stab_tiny(self):
        self.refused('stab_tiny.yaml', ':18: string[1].length: 1e-200 is out of range, allowed: 0.02 to 2000 m')

    def test_bit_short_stab(self):
        self.refused('bit_short_stab.yaml', ':17: string[0].length: ', 'out of range')
        file = self.scene('bit_short_stab.yaml', 'length: 0.01,', 'length: 0.02,')
        self.refused(file, ':17: string[0].length: the next node is 0.045 m above the bit', 'a longer bit')

    def test_bit_short_el(self):
        self.refused('bit_short_el.yaml', ':17: string[0].length: 0.001 is out of range')

    def test_stab_5cm(self):
        for length in ('0.02', '0.05', '0.1', '0.2'):
            self.assertIn(': OK', self.good('check', self.scene('stab_5cm.yaml', 'length: 0.05,', 'length: %s,' % length)))

    def test_tiny_displacement(self):
        self.refused('tiny_displacement.yaml', 'string[1].displacement_per_rev: ', 'allowed: 0.0001 to 1 m3/rev')

    def test_sections_1mm(self):
        self.refused('sections_1mm.yaml', ':9: well.sections[1].to: the section is 0.001 m long, allowed: 0.01 m or more')

    # work is bounded
    def test_deep20k_el0_1(self):
        self.refused('deep20k_el0.1.yaml', ':21: numerics.element_length: 0.1 m gives about 2', 'nodes, allowed: up to 40000')

    def test_20_km_in_elements_of_a_metre_start(self):
        scene = self.scene('deep20k_el0.1.yaml', 'element_length: 0.1', 'element_length: 1.0')
        text = self.good('static', scene, '--set', 'rig.hoisting.max_hook_load=1e7')  # no default rig lifts it
        # 20 km of 31.9 kg/m in mud of 1100 kg/m3, 20 m of it in air, and the collars
        weight = 9.80665 * ((31.9 * (19999.0 - 19.1) + 136.0 * 18.8 + 40.0) * (1.0 - 1100.0 / 7850.0) + 31.9 * 20.0)
        string = float([line for line in text.splitlines() if line.startswith('of the string')][0].split()[3])
        self.assertAlmostEqual(string / weight, 1.0, delta=0.01)

    def test_ida_frame_unbounded(self):
        done = drill('run', os.path.join(INPUTS, 'ida_frame_unbounded.yaml'), '--duration', '0.1', '--set', 'contact.tangential_damping=0')
        message = self.clean(done.stderr)
        self.assertEqual(done.returncode, 3, message)
        self.assertIn('integrator ida needs more steps of its own than are allowed', message)

    # names and numbers that would reach the terminal
    def test_name_nl(self):
        self.refused('name_nl.yaml', ':2: name: is not a valid name, allowed: 1 to 64 letters, digits and _')

    def test_md_tiny(self):
        done = drill('survey', os.path.join(INPUTS, 'md_tiny.csv'))
        message = self.clean(done.stderr)
        self.assertEqual(done.returncode, 2, message)
        self.assertIn(':3: station 2: md 4.94066e-324 m is too close to the station before it, 0 m, allowed: 0.01 m or more', message)
        self.assertNotIn(b'inf', done.stdout)


if __name__ == '__main__':
    drill_program = os.path.abspath(sys.argv.pop(1))
    instrumented = '--instrumented' in sys.argv
    if instrumented:
        sys.argv.remove('--instrumented')
    unittest.main()
