#!/usr/bin/python3
"""What the simulator costs. Usage: test_cost.py PATH_TO_DRILL"""
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True
import skips  # noqa: E402 (leaves nothing behind)

SOURCE = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
BOHAI = os.path.join(SOURCE, 'config/scenes/bohai.yaml')
drill_program = None


def run(folder, *words):
    """The summary of a run."""
    out = os.path.join(folder, 'out.json')
    subprocess.run([*words, '--json', out], check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, timeout=900)
    with open(out) as file:
        return json.load(file)


class Cost(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def test_bohai_runs_many_times_faster_than_real_time(self):
        summary = run(self.folder, drill_program, 'run', BOHAI, '--until-depth', '735')
        print('real-time factor %.1f, cost shares %s' % (summary['real_time_factor'], summary['cost_share']))
        # 42 on an idle core of the machine it was written on; CPU time, so a busy machine hardly matters
        self.assertGreater(summary['real_time_factor'], 5.0)
        self.assertEqual(summary['convergence_failures'], 0)
        # 0.20 where its inner loops are vectorised, 0.40 where they are not
        self.assertLess(summary['cost_share']['linear_solve'], 0.3)

    @unittest.skipUnless(shutil.which('valgrind'), 'valgrind is not installed')
    def test_rock_penetration_takes_few_instructions_whatever_was_drilled(self):
        """Instructions a step inside extend_hole(), at a fast drilling rate: short and long hole drilled."""
        def instructions_a_step(duration):
            log = os.path.join(self.folder, 'callgrind.log')
            summary = run(self.folder, 'valgrind', '--tool=callgrind', '--callgrind-out-file=/dev/null', '--log-file=' + log,
                          '--toggle-collect=drill_rig_sim::extend_hole*', drill_program, 'run',
                          os.path.join(SOURCE, 'config/scenes/quick.yaml'), '--duration', str(duration))
            with open(log) as file:
                collected = int(re.search(r'Collected : (\d+)', file.read()).group(1))
            return collected / summary['steps']
        short, long = instructions_a_step(45), instructions_a_step(90)
        print('rock penetration: %.0f and %.0f instructions a step' % (short, long))
        self.assertGreater(long, 50)
        self.assertLess(long, 5000)
        self.assertLess(long, 2000 + short)


if __name__ == '__main__':
    drill_program = os.path.abspath(sys.argv.pop())
    skips.main(verbosity=2)
