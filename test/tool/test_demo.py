#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""How ./launch/demo ends. What it builds and launches is taken by programs that do nothing."""
import os
import shutil
import signal
import subprocess
import tempfile
import time
import unittest

SOURCE = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
LIB = '''package_dir=$(dirname "$0")/..
say() { echo "$*"; }
complain() { echo "$*" >&2; }
set_environment() { :; }
build() { :; }
free_port() { echo 11311; }
'''
WAITS = '#!/bin/sh\necho $$ > %s\nexec sleep 100\n'


def alive(pid):
    try:
        os.kill(pid, 0)
        return True
    except ProcessLookupError:
        return False


class Demo(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        os.makedirs(self.place('launch'))
        os.makedirs(self.place('build/devel'))
        shutil.copy(os.path.join(SOURCE, 'launch/demo'), self.place('launch/demo'))
        self.write('launch/lib.sh', LIB)
        self.write('launch/readout.py', '')
        self.write('build/devel/setup.bash', '')
        # roslaunch ends on SIGINT, though bash has it ignored in the background
        self.write('roslaunch', '#!/usr/bin/python3\nimport os, signal\nsignal.signal(signal.SIGINT, signal.SIG_DFL)\n'
                   'open(%r, "w").write(str(os.getpid()))\nsignal.pause()\n' % self.place('launched'))

    def place(self, name):
        return os.path.join(self.folder, name)

    def write(self, name, text):
        with open(self.place(name), 'w') as out:
            out.write(text)
        os.chmod(self.place(name), 0o755)

    def demo(self, readout):
        """The demo with this in its readout's place."""
        self.write('python3', readout)
        for name in ('reading', 'launched'):
            self.write(name, '')
        return subprocess.Popen([self.place('launch/demo'), '--no-install', '--headless'], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                universal_newlines=True, env=dict(os.environ, PATH=self.folder + ':' + os.environ['PATH']))

    def pid_in(self, name):
        end = time.monotonic() + 20.0
        while not os.path.getsize(self.place(name)):
            self.assertLess(time.monotonic(), end)
            time.sleep(0.02)
        with open(self.place(name)) as file:
            return int(file.read())

    def test_a_signal_ends_it_and_all_it_started(self):
        for number in (signal.SIGTERM, signal.SIGINT):
            demo = self.demo(WAITS % self.place('reading'))
            started = [self.pid_in('reading'), self.pid_in('launched')]
            demo.send_signal(number)
            said = demo.communicate(timeout=20)[0]
            self.assertEqual(demo.returncode, 0, said)
            self.assertNotIn('Terminated', said)
            self.assertEqual([alive(pid) for pid in started], [False, False])

    def test_the_readouts_end_is_its_end(self):
        for status, expected in ((0, 0), (1, 1), (130, 0)):
            demo = self.demo('#!/bin/sh\nwhile [ ! -s %s ]; do sleep 0.02; done\nexit %d\n' % (self.place('launched'), status))
            demo.communicate(timeout=20)
            self.assertEqual(demo.returncode, expected)
            self.assertFalse(alive(self.pid_in('launched')))

    def test_it_leaves_a_page_and_says_where(self):
        drawn = '#!/bin/sh\nif [ "$1" = -m ]; then [ -s "$3" ] && echo %s/index.html; exit; fi\n' % self.folder
        records = 'for last; do :; done; echo time > $last\nwhile [ ! -s %s ]; do sleep 0.02; done\n' % self.place('launched')
        said = self.demo(drawn + records).communicate(timeout=20)[0]
        self.assertEqual(said.splitlines()[-1], 'logs and pictures of this run: %s/index.html' % self.folder)
        waits = self.demo(drawn + records + 'echo $$ > %s\nexec sleep 100\n' % self.place('reading'))
        self.pid_in('reading')
        waits.send_signal(signal.SIGINT)
        self.assertIn('logs and pictures of this run', waits.communicate(timeout=20)[0])

    def test_without_a_page_it_says_why(self):
        said = self.demo('#!/bin/sh\nif [ "$1" = -m ]; then echo "no matplotlib" >&2; exit 1; fi\n'
                         'for last; do :; done; echo time > $last\nwhile [ ! -s %s ]; do sleep 0.02; done\n' % self.place('launched')).communicate(timeout=20)[0]
        self.assertEqual(said.splitlines()[-1], 'no page of this run: no matplotlib')


if __name__ == '__main__':
    unittest.main()
