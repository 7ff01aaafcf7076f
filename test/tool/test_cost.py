#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""What the simulator costs. Usage: test_cost.py PATH_TO_DRILL SUMMARY_OF_THE_MAIN_JOB"""
import json
import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import unittest

import yaml

sys.dont_write_bytecode = True
import skips  # noqa: E402 (leaves nothing behind)

SOURCE = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
drill_program = main_job = None


def read(path):
    with open(path) as file:
        return json.load(file)


class Cost(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def test_bohai_runs_many_times_faster_than_real_time(self):
        summary = read(main_job)
        print('real-time factor %.1f, cost shares %s' % (summary['real_time_factor'], summary['cost_share']))
        # 42 on an idle core of the machine it was written on; CPU time, so a busy machine hardly matters
        self.assertGreater(summary['real_time_factor'], 5.0)
        self.assertEqual(summary['convergence_failures'], 0)
        # 0.20 where its inner loops are vectorised, 0.40 where they are not
        self.assertLess(summary['cost_share']['linear_solve'], 0.3)

    @unittest.skipUnless(shutil.which('valgrind'), 'valgrind is not installed')
    def test_rock_penetration_takes_few_instructions_whatever_was_drilled(self):
        """Instructions a step inside extend_hole(), at 60 mm/s: 0.2 and 0.7 m of hole drilled. Valgrind is slow: the bit starts
        on bottom, and the model is the cheapest that drills."""
        with open(os.path.join(SOURCE, 'config/scenes/quick.yaml')) as file:
            scene = yaml.safe_load(file)
        scene['start'].update(bit_depth=scene['well']['hole_depth'] - 1e-4)
        scene['formation'][0].update(drillability=6.5e-7)
        scene['program'] = [{'at': 0.0, 'top_drive_speed_rpm': 90.0, 'flow': 0.02, 'block_velocity': -0.06}]
        place, out, log = (os.path.join(self.folder, name) for name in ('scene.yaml', 'out.json', 'callgrind.log'))
        with open(place, 'w') as file:
            yaml.safe_dump(scene, file)

        def instructions_a_step(duration):
            done = subprocess.run(['valgrind', '--tool=callgrind', '--callgrind-out-file=/dev/null', '--log-file=' + log,
                                   '--toggle-collect=drill_rig_sim::extend_hole*', drill_program, 'run', place, '--level', 'axial_torsional',
                                   '--duration', str(duration), '--json', out], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, timeout=900)
            if done.returncode == -signal.SIGILL:
                self.skipTest('valgrind does not know an instruction that libhwy uses on this processor')
            done.check_returncode()
            with open(log) as file:
                collected = int(re.search(r'Collected : (\d+)', file.read()).group(1))
            summary = read(out)
            return collected / summary['steps'], summary['final']['hole_depth'] - scene['well']['hole_depth']
        (short, little), (long, much) = instructions_a_step(3), instructions_a_step(12)
        print('rock penetration: %.0f instructions a step after %.2f m, %.0f after %.2f m' % (short, little, long, much))
        self.assertGreater(much, 0.5)
        self.assertGreater(much, 4.0 * little)
        self.assertGreater(long, 50)
        self.assertLess(long, 5000)
        self.assertLess(long, 2000 + short)


if __name__ == '__main__':
    main_job = os.path.abspath(sys.argv.pop())
    drill_program = os.path.abspath(sys.argv.pop())
    skips.main(verbosity=2)
