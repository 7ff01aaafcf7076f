#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""./test/realtime/run from outside: whatever the machine bears, it ends well and accounts for every frame. And its tables, by hand."""
import os
import re
import subprocess
import sys
import unittest

HERE = os.path.dirname(os.path.abspath(__file__))
sys.dont_write_bytecode = True
sys.path.insert(0, HERE)
import report  # noqa: E402


def rows(text, first):
    """Cells of the rows that begin with this one."""
    return [[cell.strip() for cell in line.strip('|').split('|')] for line in text.splitlines() if line.startswith('| %s |' % first)]


class Tables(unittest.TestCase):
    RUN = {'name': 'OTHER', 'frames': 2000, 'cpu': {'simulation': 0.4, 'publishing': 0.05, 'ros': 0.15},
           'topics': {'rig_state': (1990, 3), '/clock': (1995, 4), 'markers': (7, 0)},
           'last': {'unpublished_frames': '2', 'pictures_left_out': '1', 'dropped_seconds': '0.25'}}

    def test_cost_is_cpu_by_frames(self):
        cells = rows(report.costs([self.RUN]), 'OTHER')[0]
        self.assertEqual(['OTHER', '2000', '2', '7', '1', '0.25', '200', '25', '75', '100'], cells)

    def test_histograms_are_read_as_the_diagnostics_write_them(self):
        self.assertEqual({'< 0.1 ms': 3, '>= 20 ms': 4}, report.histogram('< 0.1 ms: 3, >= 20 ms: 4'))

    def test_a_real_time_factor_is_simulated_over_wall_seconds(self):
        def at(time, dropped, slow):
            return {'simulated_time': str(time), 'dropped_seconds': str(dropped), 'slow': slow}
        run = {'name': 'OTHER', 'phases': [('hog', at(10, 0, False), at(13, 5, False), [at(11, 3, True), at(12, 4, True), at(12.5, 5, False), at(13, 5, False)])]}
        self.assertEqual([['OTHER', 'hog', '0.750', '5.00', 'yes']], rows(report.phases([run]), 'OTHER'))


class Run(unittest.TestCase):
    def test_every_frame_is_accounted_for(self):
        done = subprocess.run([os.path.join(HERE, 'run'), '--minutes', '0.05', '--rate', '200', '--fifo', '0'] + PROGRAMS, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, text=True, timeout=240, check=False)
        self.assertEqual(0, done.returncode, done.stdout)
        late, took = [sum(int(n) for n in cells[2:]) for cells in rows(done.stdout, 'OTHER') if len(cells) == 11 and re.fullmatch(r'\d+', cells[2])]
        self.assertEqual(late, took)
        frames = [int(cells[1]) for cells in rows(done.stdout, 'OTHER') if re.fullmatch(r'\d+', cells[1])][0]
        self.assertGreater(frames, 10)
        self.assertGreaterEqual(took, frames)


if __name__ == '__main__':
    PROGRAMS = ['--program', sys.argv.pop(1), '--listener', sys.argv.pop(1)]
    unittest.main()
