#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The links that a build in the package leaves for rosrun in build-rosrun/ (CMakeLists.txt): none of them leads to nothing."""
import os
import re
import shutil
import subprocess
import tempfile
import unittest

LISTS = os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', '..', 'CMakeLists.txt')
PROJECT = """cmake_minimum_required(VERSION 3.16)
project(links LANGUAGES C)
file(WRITE ${CMAKE_BINARY_DIR}/main.c "int main(void) { return 0; }")
add_executable(rig_simulator ${CMAKE_BINARY_DIR}/main.c)
add_executable(weight_holder ${CMAKE_BINARY_DIR}/main.c)
"""


class Links(unittest.TestCase):
    def setUp(self):
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.package = os.path.join(os.path.realpath(holder.name), 'package')
        os.makedirs(self.package)
        with open(LISTS, encoding='utf-8') as lists:
            block = re.search(r'^# rosrun ignores .*?^endforeach\(\)$', lists.read(), re.M | re.S).group(0)
        with open(self.package + '/CMakeLists.txt', 'w', encoding='utf-8') as file:
            file.write(PROJECT + block)

    def run_in_package(self, *command):
        subprocess.run(command, cwd=self.package, stdout=subprocess.DEVNULL, check=True)

    def links(self):
        """The programs that are linked, and where each link leads."""
        folder = self.package + '/build-rosrun'
        return {name: os.path.realpath(os.path.join(folder, name)) for name in os.listdir(folder)}

    def test_only_programs_that_are_built_are_linked(self):
        self.run_in_package('cmake', '-S', '.', '-B', 'build')
        self.run_in_package('make', '-C', 'build', 'rig_simulator')  # as launch/demo does
        self.assertEqual({'rig_simulator': self.package + '/build/rig_simulator'}, self.links())
        self.run_in_package('make', '-C', 'build')
        self.assertEqual(['rig_simulator', 'weight_holder'], sorted(self.links()))

    def test_links_of_a_build_that_was_removed_go(self):
        self.run_in_package('cmake', '-S', '.', '-B', 'build')
        self.run_in_package('make', '-C', 'build')
        shutil.rmtree(self.package + '/build')
        self.run_in_package('cmake', '-S', '.', '-B', '../elsewhere')
        self.assertEqual({}, self.links())
        self.run_in_package('make', '-C', '../elsewhere')
        self.assertEqual({}, self.links())


if __name__ == '__main__':
    unittest.main()
