#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Types every page of the manual from its first line to its last, each in a folder of its own, as a reader would.

Usage: test_pages.py [PAGE ...], as how_to/survey; needs the environment of the built package. A page whose packages are not installed is skipped.
"""
import importlib.util
import os
import signal
import socket
import subprocess
import sys
import tempfile
import time
import unittest

SOURCE = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.dont_write_bytecode = True
sys.path[:0] = [os.path.join(SOURCE, 'src', 'manual'), os.path.dirname(os.path.abspath(__file__))]
import pages  # noqa: E402
import test_texts  # noqa: E402

NEEDS = {'tutorial/first_campaign': ('distributed', 'scipy')}
LONGEST = 300.0  # of a page [s]
wanted = []


def free_port():
    with socket.socket() as one:
        one.bind(('127.0.0.1', 0))
        return one.getsockname()[1]


def typed(text, folder):
    """(exit status, what was printed) of a page; all that it has started is ended."""
    place = pages.Workplace(folder)
    place.write('session', pages.script(text))
    environment = {**pages.environment(), 'ROS_MASTER_URI': 'http://localhost:%d' % free_port(), 'ROS_HOSTNAME': 'localhost', 'ROS_HOME': folder,
                   'ROS_LOG_DIR': os.path.join(folder, 'log'), 'MPLCONFIGDIR': folder}
    with open(os.path.join(folder, 'printed'), 'w+', encoding='utf-8') as printed:
        with subprocess.Popen(['bash', 'session'], cwd=folder, env=environment, stdout=printed, stderr=subprocess.STDOUT, start_new_session=True) as session:
            try:
                status = session.wait(LONGEST)
            except subprocess.TimeoutExpired:
                status = 'none after %g s' % LONGEST
            end(session.pid)
        printed.seek(0)
        return status, printed.read()


def end(group):
    """What a session has left running, first as Ctrl-C does."""
    for ending in (signal.SIGINT, signal.SIGKILL):
        try:
            os.killpg(group, ending)
        except ProcessLookupError:
            return
        time.sleep(3.0)


class Pages(unittest.TestCase):
    def test_each_page_works_as_it_is_typed(self):
        for name in [name[:-3] for name in test_texts.names()]:
            text = test_texts.read(name + '.md')
            if not pages.blocks(text) or (wanted and name not in wanted):
                continue
            missing = [package for package in NEEDS.get(name, ()) if not importlib.util.find_spec(package)]
            if missing:
                print('%s: skipped, not installed: %s' % (name, ', '.join(missing)))
                continue
            with self.subTest(page=name), tempfile.TemporaryDirectory() as folder:
                status, printed = typed(text, folder)
                self.assertEqual(0, status, '%s\n%s' % (name, printed))

    def test_no_link_leads_back_into_the_package(self):
        """roslaunch and rosrun follow links below the package: with a loop they search without end."""
        for folder, folders, _ in os.walk(os.path.join(SOURCE, 'build')):
            for path in [os.path.join(folder, name) for name in folders]:
                self.assertFalse(os.path.islink(path) and path.startswith(os.path.realpath(path) + os.sep), path)


if __name__ == '__main__':
    wanted = sys.argv[1:]
    unittest.main(argv=sys.argv[:1])
