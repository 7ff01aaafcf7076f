#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""What launch/build.sh shows of a build, what it leaves out, and how it ends. cmake and make are programs that compile nothing."""
import os
import pty
import re
import shutil
import signal
import subprocess
import tempfile
import time
import unittest

SOURCE = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
RUN = '#!/bin/bash\nset -u\n. "$(dirname "$0")/launch/lib.sh"\nbuild "$package_dir/build" "${TARGETS:-some}" "$@"\n'
CMAKE = '#!/bin/sh\necho cmake >> "$FOLDER/build/called"\necho "$*" > "$FOLDER/build/CMakeCache.txt"\n'
# FILES objects, one every PACE seconds; -n names them all
MAKE = '''#!/bin/bash
if [ "$1" = -n ]; then seq -f 'echo "Building CXX object %g.o"' "$FILES"; exit; fi
echo make >> "$FOLDER/build/called"
for file in $(seq "$FILES"); do echo "[ 1%] Building CXX object $file.o"; sleep "$PACE"; done
mkdir -p "$FOLDER/build/devel" && echo made > "$FOLDER/build/devel/product"
'''


def alive(pid):
    try:
        os.kill(pid, 0)
        return True
    except ProcessLookupError:
        return False


class Build(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        for name in ('launch', 'build', 'tools', 'src'):
            os.mkdir(self.place(name))
        for name in ('lib.sh', 'build.sh'):
            shutil.copy(os.path.join(SOURCE, 'launch', name), self.place('launch'))
        for name, text in (('run', RUN), ('tools/cmake', CMAKE), ('tools/make', MAKE), ('tools/nproc', '#!/bin/sh\necho 1\n'), ('src/a.cpp', '')):
            self.write(name, text)
        self.environment = dict(os.environ, PATH=self.place('tools') + ':' + os.environ['PATH'], FOLDER=self.folder, FILES='0', PACE='0',
                                TERM='xterm', CMAKE_PREFIX_PATH='')

    def place(self, name):
        return os.path.join(self.folder, name)

    def write(self, name, text):
        with open(self.place(name), 'w') as out:
            out.write(text)
        os.chmod(self.place(name), 0o755)

    def build(self, *options, **environment):
        """Exit status, what was printed, and what was called."""
        self.write('build/called', '')
        done = subprocess.run([self.place('run'), *options], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, universal_newlines=True,
                              env=dict(self.environment, **environment), timeout=60)
        with open(self.place('build/called')) as called:
            return done.returncode, done.stdout, called.read().split()

    def text(self, log, *numbers):
        self.write('log', log)
        command = ['bash', '-c', '. "$0"; progress_text "$@"', self.place('launch/build.sh'), self.place('log')]
        return subprocess.check_output(command + [str(n) for n in numbers], universal_newlines=True, env=self.environment).strip()

    def of_lib(self, command):
        return subprocess.check_output(['bash', '-c', '. "$0"; ' + command, self.place('launch/lib.sh')], universal_newlines=True, env=self.environment)

    def on_terminal(self, **environment):
        """A build that begins on a terminal: its process and the terminal."""
        pid, terminal = pty.fork()
        if pid == 0:
            os.execve(self.place('run'), ['run'], dict(self.environment, **environment))
        return pid, terminal

    def read(self, terminal, until=None):
        """What comes from the terminal up to a text, or all."""
        said = ''
        while until is None or until not in said:
            try:
                said += os.read(terminal, 1000).decode()
            except OSError:  # closed
                break
        return said

    def test_the_line_names_what_is_done_and_how_long_it_takes(self):
        self.assertEqual(self.text('-- The CXX compiler', 0, 0, 0), 'configuring')
        self.assertEqual(self.text('make: Entering', 0, 0, 0), 'checking what changed')
        self.assertEqual(self.text('make: Entering\n[ 1%] Generating C++', 0, 0, 0), 'generating messages')
        self.assertEqual(self.text('', 4, 130, 20), 'compiling: file 4 of 130')
        self.assertEqual(self.text('', 41, 130, 60), 'compiling: file 41 of 130, about 2 min left')
        self.assertEqual(self.text('', 121, 130, 100), 'compiling: file 121 of 130, about 10 s left')
        self.assertEqual(self.text('', 131, 130, 120), 'compiling: file 131 of 131, about 10 s left')
        self.assertEqual(self.text('', 132, 130, 120), 'compiling: file 132')

    def test_packages_that_are_missing_and_what_they_take(self):
        self.write('tools/dpkg-query', '#!/bin/sh\nprintf "installed a \\nconfig-files b \\ninstalled libc-dev \\n"\nexit 1\n')
        self.assertEqual(self.of_lib('missing_packages a b libc libc-dev'), 'b libc ')
        self.write('tools/apt-get', '#!/bin/sh\necho "0 upgraded, 41 newly installed, 0 to remove and 5 not upgraded.\n'
                   'Need to get 33.2 MB/36.3 MB of archives.\nAfter this operation, 173 MB of additional disk space will be used."\nexit 1\n')
        self.assertIn('apt: 41 packages with all that they need, 33.2 MB to download, 173 MB on disk\n', self.of_lib('say_size apt-get "b libc"'))

    def test_not_on_a_terminal_lines_are_few(self):
        started = time.monotonic()
        status, said, _ = self.build(FILES='12', PACE='0.25', PROGRESS_EVERY='1')
        lines = said.splitlines()
        self.assertEqual(status, 0, said)
        self.assertNotIn('\r', said)
        self.assertGreaterEqual(len(lines), 3, said)
        self.assertLess(len(lines), 3 + time.monotonic() - started, said)
        while re.match('run: (configuring|checking what changed)$', lines[1]):  # on a busy machine the first file is late
            del lines[1]
        self.assertGreater(len(lines), 2, said)
        for line in lines[1:-1]:
            self.assertRegex(line, '^run: compiling: file [0-9]+ of 12(, about [0-9]+ s left)?$')
        self.assertRegex(lines[-1], '^run: built in [0-9]+ s, files compiled: 12$')

    def test_on_a_terminal_the_line_is_rewritten(self):
        pid, terminal = self.on_terminal(FILES='24', PACE='0.4')  # so many that a busy machine shows some, too
        said = self.read(terminal)
        self.assertEqual(os.waitstatus_to_exitcode(os.waitpid(pid, 0)[1]), 0)
        shown = [int(number) for number in re.findall('\rrun: compiling: file ([0-9]+) of 24[^\r]*\x1b\\[K', said)]
        self.assertGreater(len(set(shown)), 3, said)
        self.assertEqual(shown, sorted(shown))
        self.assertRegex(said, '\r\x1b\\[Krun: built in')

    def test_failure_shows_errors_and_the_log(self):
        self.write('tools/make', '#!/bin/sh\necho "a.cpp:1: error: no such thing"\nexit 2\n')
        for _ in range(2):  # and is not taken for a build
            status, said, _ = self.build()
            self.assertEqual(status, 1)
            self.assertIn('a.cpp:1: error: no such thing', said)
            self.assertIn('all it said is in %s/build.log' % self.place('build'), said)

    def test_only_what_changed_is_done(self):
        self.assertEqual(self.build()[2], ['cmake', 'make'])
        self.assertEqual(self.build()[2], [])
        self.assertIn('nothing has changed', self.build()[1])
        self.write('src/a.cpp', 'int a;')
        self.assertEqual(self.build()[2], ['make'])
        os.remove(self.place('src/a.cpp'))
        self.assertEqual(self.build()[2], ['make'])
        os.remove(self.place('build/devel/product'))
        self.assertEqual(self.build()[2], ['make'])
        self.assertEqual(self.build('-DOPTION=1')[2], ['cmake', 'make'])
        self.assertEqual(self.build('-DOPTION=1')[2], [])
        self.write('build/CMakeCache.txt', 'by hand')
        self.assertEqual(self.build('-DOPTION=1')[2], ['cmake', 'make'])
        self.assertEqual(self.build('-DOPTION=1', CMAKE_PREFIX_PATH='/other/workspace')[2], ['cmake', 'make'])
        self.assertEqual(self.build('-DOPTION=1', CMAKE_PREFIX_PATH='/other/workspace')[2], ['cmake', 'make'])

    def test_a_build_of_all_is_one_of_each_target(self):
        self.assertEqual(self.build(TARGETS='all tests')[2], ['cmake', 'make'])
        self.assertEqual(self.build()[2], [])
        self.write('src/a.cpp', 'int a;')
        self.assertEqual(self.build()[2], ['make'])
        self.assertEqual(self.build(TARGETS='all tests')[2], ['make'])

    def test_what_changes_during_a_build_is_built_the_next_time(self):
        self.write('tools/make', MAKE + 'echo "int a;" > "$FOLDER/src/a.cpp"\n')
        self.build()
        self.assertEqual(self.build()[2], ['make'])

    def slow_make(self):
        self.write('tools/make', '#!/bin/bash\n[ "$1" != -n ] || exit\necho $$ > "$FOLDER/build/pid"\necho "Building CXX object a.o"\nsleep 20\n')

    def making(self):
        end = time.monotonic() + 20.0
        while not (os.path.exists(self.place('build/pid')) and os.path.getsize(self.place('build/pid'))):
            self.assertLess(time.monotonic(), end)
            time.sleep(0.02)
        with open(self.place('build/pid')) as file:
            return int(file.read())

    def test_ctrl_c_ends_make_and_leaves_a_clean_line(self):
        self.slow_make()
        pid, terminal = self.on_terminal()
        self.read(terminal, until='compiling')
        os.write(terminal, b'\x03')
        said = self.read(terminal)
        self.assertEqual(os.waitstatus_to_exitcode(os.waitpid(pid, 0)[1]), -signal.SIGINT)
        self.assertTrue(said.endswith('\r\x1b[K'), repr(said))
        self.assertFalse(alive(self.making()))

    def test_a_signal_to_the_script_alone_ends_make(self):
        self.slow_make()
        build = subprocess.Popen([self.place('run')], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, universal_newlines=True, env=self.environment)
        made_by = self.making()
        build.terminate()
        said = build.communicate(timeout=20)[0]
        self.assertEqual(build.returncode, -signal.SIGTERM)
        self.assertNotIn('Terminated', said)
        self.assertFalse(alive(made_by))


if __name__ == '__main__':
    unittest.main()
