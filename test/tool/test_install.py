#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""`cmake --install` into any folder leaves a rig that works from there, and writes nowhere else. rosrun and a package that depends on this one find
the rig there and in the devel space. Usage: test_install.py BUILD_FOLDER [DEVEL_SPACE]."""
import glob
import os
import shutil
import subprocess
import sys
import tempfile
import unittest

build, devel = '', ''
ROSRUN = shutil.which('rosrun')


def installed(folder, prefix, destdir=''):
    """What `cmake --install` prints."""
    with tempfile.TemporaryDirectory() as home:
        return subprocess.run(['cmake', '--install', build, '--prefix', prefix], cwd=folder, env={**os.environ, 'DESTDIR': destdir, 'HOME': home},
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=True).stdout


def in_shell(shell, lines, folder):
    """What the lines print in a shell that has no ROS but Debian's."""
    done = subprocess.run([shell, '-e', '-c', lines], cwd=folder, env={'PATH': '/usr/bin:/bin', 'TMPDIR': folder, 'HOME': folder, 'MPLCONFIGDIR': folder},
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
    if done.returncode:
        raise AssertionError(done.stdout)
    return done.stdout


class Install(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        holder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(holder.cleanup)
        cls.folder = os.path.realpath(holder.name)
        cls.prefix = os.path.join(cls.folder, 'a prefix')
        cls.printed = installed(cls.folder, cls.prefix)
        cls.runner = ('drill',) if os.path.exists(cls.prefix + '/lib/drill_rig_sim/drill') else ()

    def test_all_is_below_the_prefix(self):
        written = [line for line in self.printed.splitlines() if line.startswith(('-- Installing: ', '-- Up-to-date: '))]
        self.assertGreater(len(written), 300)
        self.assertEqual([], [line for line in written if self.prefix not in line])

    def test_the_runner_needs_no_environment(self):
        if not self.runner:
            self.skipTest('the build has no runner')
        scene = os.path.join(self.prefix, 'share', 'drill_rig_sim', 'config', 'scenes', 'quick.yaml')
        printed = in_shell('sh', "'%s/lib/drill_rig_sim/drill' check '%s'" % (self.prefix, scene), self.folder)
        self.assertIn('quick: OK', printed)

    def test_its_setup_files_show_it_to_ros(self):
        for shell, setup in (('bash', 'setup.bash'), ('sh', 'setup.sh')):
            printed = in_shell(shell, ". '%s/%s'; catkin_find --first-only --libexec drill_rig_sim; catkin_find --first-only drill_rig_sim launch/rig.launch"
                               % (self.prefix, setup), self.folder)
            self.assertEqual([self.prefix + '/lib/drill_rig_sim', self.prefix + '/share/drill_rig_sim/launch/rig.launch'], printed.splitlines())

    def test_python_drives_a_rig(self):
        if not glob.glob(self.prefix + '/lib/python3/dist-packages/drill_rig_sim/_sim.*'):
            self.skipTest('the build has no Python module')
        lines = ". '%s/setup.bash'; /usr/bin/python3 -c 'from drill_rig_sim.sim import Simulator, __file__; print(__file__, Simulator(\"quick.yaml\").step(0.1).t)'"
        self.assertEqual('%s/lib/python3/dist-packages/drill_rig_sim/sim.py 0.1' % self.prefix, in_shell('bash', lines % self.prefix, self.folder).strip())

    def rosrun_finds_programs(self, setup):
        for program in (*self.runner, 'rig_simulator', 'weight_holder', 'drill_campaign'):
            printed = in_shell('bash', ". '%s/setup.bash'; rosrun --prefix echo drill_rig_sim %s" % (setup, program), self.folder)
            self.assertRegex(printed.strip(), '/%s$' % program, setup)
        if self.runner:
            self.assertIn("Usage: drill", in_shell('bash', ". '%s/setup.bash'; rosrun drill_rig_sim drill --help" % setup, self.folder))

    @unittest.skipUnless(ROSRUN, 'rosrun is not installed (rosbash)')
    def test_rosrun_finds_its_programs_in_the_build(self):
        self.rosrun_finds_programs(devel)

    @unittest.skipUnless(ROSRUN, 'rosrun is not installed (rosbash)')
    def test_rosrun_finds_its_programs_in_a_prefix(self):
        with open(ROSRUN) as script:
            if ' ' in self.prefix and '=(${exepathlist[0]})' in script.read():
                self.skipTest('rosrun of this release parts paths at blanks')
        self.rosrun_finds_programs(self.prefix)

    def test_a_package_that_depends_on_it_is_built_and_runs(self):
        source = os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(__file__))), 'dependent')
        for setup in (self.prefix, devel):
            with tempfile.TemporaryDirectory() as other:
                printed = in_shell('bash', ". '%s/setup.bash'; cmake -S '%s' -B . -DCATKIN_ENABLE_TESTING=OFF; make; devel/lib/rig_user/rig_user \"$(catkin_find --first-only drill_rig_sim config/scenes/quick.yaml)\""
                                   % (setup, source), other)
                hook_load = [float(line.split()[1]) for line in printed.splitlines() if line.startswith('hook_load: ')]
                self.assertEqual(1, len(hook_load), printed)
                self.assertGreater(hook_load[0], 1e5)
                versions = in_shell('bash', 'readelf --version-info devel/lib/rig_user/rig_user', other)
                self.assertIn('Name: DRILL_RIG_SIM ', versions)
                self.assertNotIn('DRILL_RIG_SIM_PRIVATE', versions, 'it needs a symbol that is not part of the interface (src/sim/exported.map)')

    def test_destdir(self):
        stage = os.path.join(self.folder, 'stage')
        installed(self.folder, '/opt/rig', stage)
        self.assertTrue(os.path.isfile(stage + '/opt/rig/setup.bash'))
        with open(stage + '/opt/rig/setup.sh', encoding='utf-8') as setup:
            self.assertIn(': ${_CATKIN_SETUP_DIR:=/opt/rig}', setup.read())


if __name__ == '__main__':
    build = os.path.abspath(sys.argv.pop(1))
    devel = os.path.abspath(sys.argv.pop(1)) if len(sys.argv) > 1 else build + '/devel'
    unittest.main()
