#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""launch/lib.sh asks before it calls sudo: on a terminal, without --yes. apt-get, sudo and id are programs that install nothing."""
import os
import pty
import shutil
import subprocess
import tempfile
import unittest

SOURCE = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
RUN = """#!/bin/bash
set -u
yes=${YES:-false}
. "$(dirname "$0")/launch/lib.sh"
build_dir=$package_dir/build debian=12
unset ROS_DISTRO
missing_packages() { printf 'g++ cmake '; }
install_packages g++ cmake
"""
APT = """#!/bin/sh
echo "apt-get $*" >> "$FOLDER/called"
case "$*" in *--assume-no*) printf '0 upgraded, 7 newly installed, 0 to remove\nNeed to get 12.3 MB of archives.\nAfter this operation, 45.6 MB of additional disk space\n'; exit 1 ;; esac
"""
SUDO = '#!/bin/sh\necho sudo >> "$FOLDER/called"\nexec "$@"\n'


class AskForSudo(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        for name in ('launch', 'tools', 'build'):
            os.mkdir(os.path.join(self.folder, name))
        for name in ('lib.sh', 'build.sh'):
            shutil.copy(os.path.join(SOURCE, 'launch', name), os.path.join(self.folder, 'launch'))
        for name, text in (('run', RUN), ('tools/apt-get', APT), ('tools/sudo', SUDO), ('tools/id', '#!/bin/sh\necho "${USER_ID:-1000}"\n')):
            with open(os.path.join(self.folder, name), 'w') as out:
                out.write(text)
            os.chmod(os.path.join(self.folder, name), 0o755)

    def install(self, answer, **environment):
        """Exit status, what was said and what was called, with this answer typed on a terminal; without a terminal where it is None."""
        open(os.path.join(self.folder, 'called'), 'w').close()
        terminal, end = pty.openpty()
        try:
            if answer is not None:
                os.write(terminal, answer.encode())
            done = subprocess.run([os.path.join(self.folder, 'run')], stdin=subprocess.DEVNULL if answer is None else end, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                  universal_newlines=True, timeout=60,
                                  env=dict(os.environ, PATH=os.path.join(self.folder, 'tools') + ':' + os.environ['PATH'], FOLDER=self.folder, **environment))
        finally:
            os.close(terminal)
            os.close(end)
        with open(os.path.join(self.folder, 'called')) as called:
            return done.returncode, done.stdout, called.read()

    def test_it_asks_with_names_and_size_and_obeys(self):
        for answer in ('y\n', '\n', 'Yes\n'):
            status, said, called = self.install(answer)
            self.assertEqual(0, status, said)
            self.assertIn('run: 2 packages are missing: g++ cmake', said)
            self.assertIn('run: apt: 7 packages with all that they need, 12.3 MB to download, 45.6 MB on disk', said)
            self.assertIn('sudo', called)
            self.assertLess(called.index('--assume-no'), called.index('sudo'), 'the size is known before')
        for answer in ('n\n', 'what?\n', '\x04'):
            status, said, called = self.install(answer)
            self.assertEqual(2, status, said)
            self.assertIn('apt-get install -y --no-install-recommends g++ cmake', said)
            self.assertNotIn('sudo', called)

    def test_it_does_not_ask_where_it_need_not(self):
        for answer, environment in (('', {'YES': 'true'}), (None, {}), ('', {'USER_ID': '0'})):
            status, said, called = self.install(answer, **environment)
            self.assertEqual(0, status, said)
            self.assertNotIn('are missing', said)
            self.assertIn('run: installing 2 packages: g++ cmake', said)
            self.assertEqual(environment.get('USER_ID') != '0', 'sudo' in called)


if __name__ == '__main__':
    unittest.main()
