#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""`drill verify`: of scenes and bags, and the scores beside it. Usage: test_drill_verify.py PATH_TO_DRILL, from an environment that finds drill_rig_sim."""
import json
import math
import os
import sys
import unittest

import rosbag
from std_msgs.msg import String

sys.dont_write_bytecode = True
import test_drill  # noqa: E402 (leaves nothing behind)
from test_drill import QUICK  # noqa: E402

FAST = ('--set', 'numerics.element_length=9.5', '--set', 'numerics.step=0.01', '--times', '1.2')  # three cheap models
DRILLS = ('--set', 'start.bit_depth=99.98', '--set', 'program=[{at: 0, top_drive_speed_rpm: 60, flow: 0.02}, {at: 1, block_velocity: -0.02, ramp: 1.5}]')


class Verify(test_drill.Drill):
    def verified(self, *words):
        """Standard output, and the findings; exit status 0 or 1."""
        done = test_drill.drill('verify', *words, '--json', self.file('v.json'))
        self.assertIn(done.returncode, (0, 1), done.stderr)
        with open(self.file('v.json'), encoding='utf-8') as text:
            found = json.load(text)
        self.assertEqual(done.returncode == 1, found['verdict'] == 'missed')
        return done.stdout, found

    def numbers(self, found):
        """All that a comparison of two verifications needs."""
        return {name: {key: value for key, value in one.items()} for name, one in found['outputs'].items()}

    # --- scenes

    def test_findings_by_output(self):
        out, found = self.verified(QUICK, *FAST, *DRILLS, '--duration', '9')
        self.assertIn('9.0 s compared with two finer models (beam3d, elements and steps 1.2 and 1.44 times shorter)', out)
        self.assertEqual({'hook_load', 'torque', 'wob', 'rop', 'bit_speed', 'stand_pipe_pressure'}, set(found['outputs']))
        for one in found['outputs'].values():
            self.assertEqual(3, len(one['off']))
            self.assertEqual(one['worst'], max(one['off']))
            self.assertIn(one['verdict'], ('right', 'warned', 'missed', 'unknown'))

    def test_a_wrong_run_that_measures_no_error_is_reported_with_the_reason(self):
        out, found = self.verified(QUICK, '--set', 'numerics.level=beam3d', '--set', 'numerics.step=0.01', '--duration', '6')
        self.assertRegex(out, r'\nwrong without a warning: [^\n]*; its error was not measured: numerics.level is set by hand and numerics.companion is not\n$')
        self.assertEqual('numerics.level is set by hand and numerics.companion is not', found['not_measured'])

    def test_what_is_refused(self):
        for words, said in (((QUICK, '--wob', '1e4'), 'need --score'), ((QUICK, '--namespace', 'rig'), 'allowed only with a bag'), ((QUICK, '--score', '--wob-band', '1'), '--wob-band: needs --wob'),
                            ((self.file('no.bag'),), 'no.bag'), ((QUICK, '--times', '1.1'), '--times')):
            self.assertIn(said, self.refuse('verify', *words))

    # --- scores

    def test_scores_of_the_three_and_how_far_the_run_is_off(self):
        out, found = self.verified(QUICK, *FAST, *DRILLS, '--duration', '12', '--score', '--wob', '10e3', '--bit-diameter', '0.2')
        self.assertRegex(out, r'\nscore +run +finer +finest +off\n')
        self.assertRegex(out, r'\nweight on bit, mean +[0-9.]+ +[0-9.]+ +[0-9.]+ +[-0-9.e]+ kN\n')
        scores = found['scores']
        self.assertEqual({'run', 'finer', 'finest', 'off'}, set(scores))
        self.assertTrue(math.isclose(scores['off']['wob']['mean'], scores['run']['wob']['mean'] - scores['finest']['wob']['mean'], abs_tol=1e-9))
        self.succeed('run', QUICK, *FAST[:4], *DRILLS, '--duration', '12', '--csv', self.file('r.csv'))
        self.succeed('score', self.file('r.csv'), '--wob', '10e3', '--bit-diameter', '0.2', '--json', self.file('s.json'))
        with open(self.file('s.json'), encoding='utf-8') as text:
            alone = json.load(text)
        self.assertAlmostEqual(alone['wob']['mean'], scores['run']['wob']['mean'], places=6)

    def test_a_plan_that_cannot_be_read_is_told(self):
        done = test_drill.drill('verify', QUICK, *FAST, '--duration', '1', '--score', '--plan', self.file('no.csv'))
        self.assertEqual(3, done.returncode)
        self.assertIn('no.csv', done.stderr)

    # --- bags

    def bag(self, *words):
        self.succeed('run', QUICK, *FAST[:4], *DRILLS, '--duration', '9', '--bag', self.file('r.bag'), *words)
        return self.file('r.bag')

    def test_a_run_is_verified_by_its_bag_as_by_its_scene(self):
        _, by_bag = self.verified(self.bag(), '--times', '1.2')
        _, by_scene = self.verified(QUICK, *FAST, *DRILLS, '--duration', '9')
        self.assertEqual(self.numbers(by_scene), self.numbers(by_bag))

    def rewritten(self, change):
        """The bag with other messages: change(topic, message) gives the message, or None to leave it out."""
        with rosbag.Bag(self.bag('--every', '0.01')) as bag, rosbag.Bag(self.file('other.bag'), 'w') as out:
            for topic, message, stamp in bag.read_messages():
                changed = change(topic.replace('/rig/', '', 1), message)
                if changed is not None:
                    out.write(topic, changed, stamp)
        return self.file('other.bag')

    def test_set_points_in_force_are_played_where_commands_came(self):
        """As a node's bag has it: the scene without its program, and stamps of commands."""
        def of_node(topic, message):
            if topic == 'scene':
                return String(message.data.split('\nprogram:')[0] + '\n')
            if topic == 'truth/rig_state':
                message.last_command = message.header.stamp
            return message

        _, by_bag = self.verified(self.rewritten(of_node), '--times', '1.2')
        _, by_scene = self.verified(QUICK, *FAST, *DRILLS, '--duration', '9')
        self.assertEqual(self.numbers(by_scene), self.numbers(by_bag))

    def test_what_cannot_be_played_again_is_refused(self):
        def late(topic, message):
            if topic == 'truth/rig_state':
                message.last_command = message.header.stamp
                return message if message.header.stamp.to_sec() > 5.0 else None
            return message

        def stuck(topic, message):
            if topic == 'truth/rig_state' and message.header.stamp.to_sec() > 5.0:
                message.hook_load *= 1.1
            return message

        for change, said in ((late, r'begins 5\.01 s after the start of the rig, after the first command; needed: a bag recorded from the start'),
                             (stuck, r'cannot be replayed: at 5\.01 s the hook load is [0-9.]+ kN, recorded: [0-9.]+; services'),
                             (lambda topic, message: None if topic == 'scene' else message, r'holds no scene \(topic scene\), needed: --scene FILE'),
                             (lambda topic, message: None if topic == 'truth/rig_state' else message, r'has no truth/rig_state, which is needed')):
            self.assertRegex(self.refuse('verify', self.rewritten(change), '--times', '1.2'), r'^drill verify: \S+other\.bag: ' + said)

    def test_the_scene_may_be_given(self):
        self.succeed('run', QUICK, '--duration', '3', '--bag', self.file('r.bag'))
        _, found = self.verified(self.file('r.bag'), '--times', '1.2', '--scene', QUICK)
        self.assertEqual('quick', found['scene'])
        self.assertIn('--until-depth', self.refuse('verify', self.file('r.bag'), '--until-depth', '101'))


if __name__ == '__main__':
    test_drill.drill_program = os.path.abspath(sys.argv.pop(1))
    unittest.main()
