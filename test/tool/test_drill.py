#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The offline runner from outside: exit statuses, one-line messages, files. Usage: test_drill.py PATH_TO_DRILL"""
import csv
import glob
import json
import math
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
QUICK = os.path.join(SOURCE, 'config/scenes/quick.yaml')
BOHAI = os.path.join(SOURCE, 'config/scenes/bohai.yaml')
ALONE = ('--set', 'numerics.companion=none')
NEAR_BOTTOM = ('--set', 'start.bit_depth=99.95', *ALONE)  # of quick.yaml: tags after 10 s instead of 35
COLUMNS = ('time,hook_load,torque,block_height,top_drive_speed,wob,bit_torque,bit_speed,bit_depth,hole_depth,rop,inclination,azimuth,'
           'toolface,bit_east,bit_north,bit_up,bit_inclination,in_slips,motor_stalled,winch_limited,top_drive_limited,stop_reached,slack_line,'
           'relief_valve_open,over_stress,over_torque,buckled,accuracy_warning,stand_pipe_pressure,differential_pressure,flow,floor_height,'
           'dead_line_hook_load,hook_load_string,stroke_rate,pump_strokes,ecd,flow_line_temperature,encoder_bit_depth,block_velocity,floor_velocity,top_drive_angle,surface_wob,tared,on_bottom,'
           'stand_count,brake_set,cuttings_volume,bed_height,bottom_hole_temperature,top_drive_brake_set,command_clamped,commands_timed_out,over_pull,pump_tripped,drive_tripped').split(',')
drill_program = None


def drill(*words):
    return subprocess.run([drill_program, *words], stdout=subprocess.PIPE, stderr=subprocess.PIPE, universal_newlines=True, timeout=900)  # with sanitizers ten times as long


class Drill(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def file(self, name):
        return os.path.join(self.folder, name)

    def succeed(self, *words):
        done = drill(*words)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(done.stderr, '', 'no progress bar in a pipe, no warnings')
        return done.stdout

    def refuse(self, *words):
        """Exit status 2 and exactly one line."""
        done = drill(*words)
        self.assertEqual(done.returncode, 2, done.stdout + done.stderr)
        self.assertEqual(done.stdout, '')
        self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
        return done.stderr


class Usage(Drill):
    def test_help_lists_every_command_and_option(self):
        text = self.succeed('--help')
        for command in ('run', 'check', 'static', 'modes', 'survey', 'score', 'reference'):
            self.assertIn('\n  ' + command, text)
        text = self.succeed('run', '--help')
        for option in ('--duration', '--until-depth', '--level', '--integrator', '--step', '--element-length', '--csv', '--bag', '--every',
                       '--profile', '--profile-every',
                       '--json'):
            self.assertIn(option, text)

    def test_wrong_usage_is_one_line_and_status_2(self):
        self.assertEqual(drill().returncode, 2)
        self.assertIn('is not a command', self.refuse('dig'))
        self.assertIn('needs a SCENE', self.refuse('run'))
        self.assertIn('one argument too many', self.refuse('check', QUICK, BOHAI))
        self.assertIn('unknown option', self.refuse('run', QUICK, '--fast'))
        self.assertIn('needs a value', self.refuse('run', QUICK, '--duration'))
        self.assertIn('--duration', self.refuse('run', QUICK, '--duration', 'long'))
        self.assertIn('--every', self.refuse('run', QUICK, '--every', '-1'))
        self.assertIn('--every', self.refuse('run', QUICK, '--every', 'nan'))
        self.assertIn('--until-depth', self.refuse('run', QUICK, '--until-depth', '99'))
        self.assertIn('cannot be written', self.refuse('run', QUICK, '--bag', self.file('no/such/folder.bag')))
        self.assertIn('is unknown, allowed: rigid', self.refuse('run', QUICK, '--level', 'planar'))
        self.assertIn('auto: not available with the reference (ida)', self.refuse('run', QUICK, '--integrator', 'ida', '--step', '0.01', '--level', 'beam3d', '--set', 'connections=auto'))
        self.assertIn('integrator', self.refuse('run', QUICK, '--integrator', 'no_such'))
        self.assertIn('setting: numerics.step: 7 is out of range', self.refuse('run', QUICK, '--step', '7'))
        self.assertIn('setting: mud.densty: unknown key', self.refuse('run', QUICK, '--set', 'mud.densty=1'))
        self.assertIn('cannot be written', self.refuse('run', QUICK, '--csv', self.file('no/such/folder.csv')))
        self.assertIn('is the file of --csv', self.refuse('run', QUICK, '--csv', self.file('x'), '--json', self.file('x')))
        self.assertIn('--motion', self.refuse('static', QUICK, '--motion', 'sideways'))


class Check(Drill):
    def test_good_scenes_are_described(self):
        for scene, level in ((QUICK, 'hybrid'), (BOHAI, 'beam3d')):
            text = self.succeed('check', scene)
            self.assertIn(': OK', text)
            self.assertIn('level %s, integrator bdf2, variable steps' % level, text)
            self.assertIn('drill_pipe', text)

    def test_bad_scenes_are_refused_with_file_line_and_key(self):
        scenes = sorted(glob.glob(os.path.join(SOURCE, 'test/bad_scenes/*.yaml')))
        self.assertGreaterEqual(len(scenes), 30)
        for scene in scenes:
            with open(scene) as text:
                line = text.readline().split(': ')[1]
            self.assertTrue(self.refuse('check', scene).startswith('%s:%s: ' % (scene, line)), scene)

    def test_a_missing_scene_is_named(self):
        self.assertIn('no_such.yaml: cannot be read', self.refuse('check', 'no_such.yaml'))


class Survey(Drill):
    def test_bohai(self):
        rows = self.succeed('survey', os.path.join(SOURCE, 'config/surveys/bohai.csv')).splitlines()
        last = [float(cell) for cell in rows[-1].split()]
        # vertical 200 m, an arc of radius 180 m / pi * 30 / 3 through 51 deg, 20 m at 51 deg
        self.assertAlmostEqual(last[5], 200.0 + 572.958 * 0.777146 + 20.0 * 0.629320, delta=0.01)
        self.assertAlmostEqual(float(rows[-2].split()[6]), 3.0, delta=0.001)

    def test_a_survey_below_the_table_begins_where_its_columns_say(self):
        with open(self.file('tied.csv'), 'w') as out:
            out.write('md_m,inclination_deg,azimuth_deg,tvd_m,north_m,east_m\n1000,30,90,900,-50,200\n1100,30,90,,,\n')
        first, last = [[float(cell) for cell in row.split()] for row in self.succeed('survey', self.file('tied.csv')).splitlines()[1:]]
        self.assertEqual(first, [1000.0, 30.0, 90.0, -50.0, 200.0, 900.0, 0.0])
        self.assertEqual(last, [1100.0, 30.0, 90.0, -50.0, 250.0, 986.603, 0.0])  # 100 m at 30 deg to the east

    def test_broken_surveys_are_refused(self):
        for name in ('backwards', 'deep', 'empty', 'nan_cell', 'no_header', 'short_row', 'text_cell', 'tie_in_text'):
            self.assertIn(name + '.csv:', self.refuse('survey', os.path.join(SOURCE, 'test/bad_scenes/surveys', name + '.csv')))


def curved_soft_string(sign):
    """Hook load and rotating torque of the pipe in test/scenes/curved_well.yaml by a sum along the arc, from the bit up: the side load
    is w sin I - T d(I)/ds, towards the low side; tension lifts the pipe in a build section."""
    step, friction, curvature = 0.1, 0.25, math.radians(0.1)
    in_mud = 1.0 - 1150.0 / 7850.0
    weight = 31.9 * 9.80665 * in_mud
    depth = 589.7
    tension, torque = 40.0 * 9.80665 * in_mud * math.cos(curvature * depth), 0.0
    while depth > 0.0:
        inclination = curvature * (depth - 0.5 * step)
        side = abs(weight * math.sin(inclination) - tension * curvature)
        tension += step * (weight * math.cos(inclination) + sign * friction * side)
        torque += step * 0.084 * side * math.sin(math.atan(friction))
        depth -= step
    return tension + 31.9 * 9.80665 * 20.0, torque


class Static(Drill):
    def figure(self, name, words):
        for line in self.succeed('static', *words).splitlines():
            if line.startswith(name):
                return float(line[len(name):].split()[0])
        self.fail('no ' + name)

    def hook_load(self, *words):
        return self.figure('of the string', words)

    def torque(self, *words):
        return self.figure('torque', words)

    def test_hanging_string_weighs_its_buoyant_weight(self):
        scene = os.path.join(SOURCE, 'test/scenes/vertical_frictionless.yaml')
        in_mud = 1.0 - 1150.0 / 7850.0
        # bit_depth 990 m, block_height 20 m; the bit is 0.3 m of it; no buoyancy above the table; the stretch is below 0.5 m
        weight = 9.80665 * (40.0 * in_mud + 31.9 * (989.7 * in_mud + 20.0))
        self.assertAlmostEqual(self.hook_load(scene) / weight, 1.0, delta=1e-3)

    def test_friction_holds_back(self):
        rest, up, down = (self.hook_load(BOHAI, '--motion', motion) for motion in ('none', 'up', 'down'))
        self.assertGreater(up, rest + 1e4)
        self.assertLess(down, rest - 1e4)

    # Friction acts on 1130 m of straight pipe at 20 deg (and not above), so up and down differ from rest by mu w sin I L. A turning
    # string climbs the wall until friction and weight balance: N = w sin I cos(phi), tan(phi) = mu, torque = r w sin I sin(phi) L.
    INCLINED = os.path.join(SOURCE, 'test/scenes/inclined_straight_20deg.yaml')
    SIDE_LOAD = 31.9 * 9.80665 * (1.0 - 1150.0 / 7850.0) * math.sin(math.radians(20.0)) * (1400.0 - 270.0)  # [N]
    DRAG = 0.5 * SIDE_LOAD
    TORQUE = 0.084 * SIDE_LOAD * math.sin(math.atan(0.5))

    def test_straight_inclined_well_agrees_with_the_soft_string(self):
        rest = self.hook_load(self.INCLINED)
        for motion, expected in (('up', rest + self.DRAG), ('down', rest - self.DRAG), ('rotate', rest)):
            self.assertAlmostEqual(self.hook_load(self.INCLINED, '--motion', motion) / expected, 1.0, delta=0.01, msg=motion)
        self.assertAlmostEqual(self.torque(self.INCLINED, '--motion', 'rotate') / self.TORQUE, 1.0, delta=0.01)

    def test_weight_on_bit_stays_what_it_is_while_the_string_slides(self):
        """Slide drilling: friction takes its share off the hook, not off the bit."""
        weight = 20000.0
        start = ('--set', 'well.hole_depth=1400', '--set', 'start.bit_depth=1400', '--set', 'start.weight_on_bit=%g' % weight)
        rest = self.hook_load(self.INCLINED, *start)
        for motion, expected in (('none', rest), ('up', rest + self.DRAG), ('down', rest - self.DRAG), ('rotate', rest)):
            words = (self.INCLINED, '--motion', motion) + start
            self.assertAlmostEqual(self.figure('weight on bit', words) / weight, 1.0, delta=2e-4, msg=motion)
            self.assertAlmostEqual(self.hook_load(*words), expected, delta=0.02 * self.DRAG, msg=motion)

    def test_dynamic_run_agrees_with_the_soft_string(self):
        rest = self.hook_load(self.INCLINED)
        block = 17500.0 * 9.80665
        for line, expected in (('block_velocity: 0.1', rest + self.DRAG), ('block_velocity: -0.1', rest - self.DRAG),
                               ('top_drive_speed_rpm: 30', rest)):
            # the start's transient rings on in a well without axial damping: the mean over many periods counts
            self.succeed('run', self.INCLINED, *ALONE, '--set', 'program=[{at: 0, %s}]' % line, '--duration', '60', '--csv', self.file('d.csv'))
            with open(self.file('d.csv')) as text:
                rows = [row for row in csv.DictReader(text) if float(row['time']) > 30.0]
            rail = 0.03 * block * (line.startswith('block') and (1.0 if expected > rest else -1.0))
            mean = sum(float(row['hook_load']) for row in rows) / len(rows) - block - rail
            self.assertAlmostEqual(mean / expected, 1.0, delta=0.01, msg=line)
        torque = sum(float(row['torque']) for row in rows) / len(rows)
        self.assertAlmostEqual(torque / self.TORQUE, 1.0, delta=0.01)

    def test_constant_curvature_agrees_with_the_soft_string(self):
        scene = os.path.join(SOURCE, 'test/scenes/curved_well.yaml')
        for motion, sign in (('none', 0.0), ('up', 1.0), ('down', -1.0), ('rotate', 0.0)):
            tension, torque = curved_soft_string(sign)
            self.assertAlmostEqual(self.hook_load(scene, '--motion', motion) / tension, 1.0, delta=0.01, msg=motion)
        self.assertAlmostEqual(self.torque(scene, '--motion', 'rotate') / torque, 1.0, delta=0.01)

    def test_profile_has_the_named_columns(self):
        self.succeed('static', BOHAI, '--motion', 'rotate', '--csv', self.file('s.csv'))
        with open(self.file('s.csv')) as text:
            rows = list(csv.DictReader(text))
        self.assertEqual(list(rows[0]), ['md', 'from_bit', 'east', 'north', 'up', 'tension', 'true_axial_force', 'torque', 'bending_moment',
                                         'contact_force', 'contact_side_deg'])
        self.assertGreater(float(rows[-1]['torque']), float(rows[0]['torque']))


class Run(Drill):
    def test_series_and_summary(self):
        self.succeed('run', QUICK, *ALONE, '--duration', '60', '--every', '0.5', '--csv', self.file('q.csv'), '--json', self.file('q.json'),
                     '--path', self.file('path.csv'), '--raw-path', self.file('raw.csv'))
        with open(self.file('q.csv')) as text:
            rows = list(csv.reader(text))
        self.assertEqual(rows[0], COLUMNS)
        self.assertEqual(len(rows) - 1, 121)
        for i, row in enumerate(rows[1:]):
            self.assertAlmostEqual(float(row[0]), 0.5 * i, delta=0.011)
        with open(self.file('q.json')) as text:
            summary = json.load(text)
        for key in ('simulated_s', 'wall_s', 'cpu_s', 'real_time_factor', 'nodes', 'guided_nodes', 'coordinates', 'steps', 'newton_iterations',
                    'convergence_failures'):
            self.assertGreaterEqual(summary[key], 0.0, key)
        self.assertAlmostEqual(summary['simulated_s'], 60.0, delta=0.011)
        self.assertAlmostEqual(sum(summary['cost_share'].values()), 1.0, delta=1e-6)
        for share in ('contact', 'elements', 'linear_solve', 'rock_penetration'):
            self.assertIn(share, summary['cost_share'])
        for block in ('final', 'mean_drilling', 'mean_last_quarter'):
            self.assertEqual(list(summary[block]), ['hook_load', 'torque', 'wob', 'bit_torque', 'bit_speed_rpm', 'rop', 'hole_depth', 'bit_east',
                                                    'bit_north', 'bit_up', 'inclination_deg', 'azimuth_deg'])
        # the winch feeds 12 mm/s; 2 % for what the string still gives way
        self.assertAlmostEqual(summary['mean_last_quarter']['rop'] / 0.012, 1.0, delta=0.02)
        with open(self.file('path.csv')) as text:
            path = list(csv.DictReader(text))
        # the path is that of the last whole step, which may have begun frames ago: 50 ms of 12 mm/s
        self.assertAlmostEqual(float(path[-1]['md']), summary['final']['hole_depth'], delta=6e-4)
        with open(self.file('raw.csv')) as text:
            self.assertGreater(len(text.readlines()), 100)

    def test_until_depth_stops_there(self):
        self.succeed('run', QUICK, *NEAR_BOTTOM, '--until-depth', '100.1', '--json', self.file('q.json'))
        with open(self.file('q.json')) as text:
            depth = json.load(text)['final']['hole_depth']
        self.assertGreaterEqual(depth, 100.1)
        self.assertLess(depth, 100.101)

    def test_a_depth_that_is_never_reached_is_told(self):
        """The brake is set and the bit off bottom: nothing drills."""
        result = drill('run', QUICK, *ALONE, '--set', 'program=[]', '--until-depth', '101', '--json', self.file('q.json'))
        self.assertEqual(result.returncode, 3)
        self.assertIn('101 m, is not reached: the hole is 100.000 m deep and has not grown for 600 s', result.stderr)
        with open(self.file('q.json')) as text:
            self.assertAlmostEqual(json.load(text)['simulated_s'], 600.0, delta=0.02)

    def test_what_no_instrument_has_shown_yet_is_null(self):
        self.succeed('run', QUICK, '--duration', '0.1', '--readings', '--json', self.file('q.json'))
        with open(self.file('q.json')) as text:
            readings = json.load(text)['final_readings']
        for name in ('mwd_md', 'mwd_inclination_deg', 'mwd_azimuth_deg', 'toolface_deg', 'surface_wob', 'differential_pressure'):
            self.assertIsNone(readings[name], name)
        self.assertIsNotNone(readings['hook_load'])

    def test_the_summary_has_its_keys_in_order_and_its_numbers_in_full(self):
        self.succeed('run', QUICK, '--duration', '0.1', '--every', '0.1', '--csv', self.file('q.csv'), '--json', self.file('q.json'))
        with open(self.file('q.json')) as text:
            written = text.read()
        summary = json.loads(written)
        keys = ['scene', 'simulated_s', 'wall_s', 'cpu_s', 'real_time_factor', 'level', 'integrator', 'kernel', 'step', 'nodes', 'guided_nodes', 'coordinates', 'choice', 'steps',
                'newton_iterations', 'rejected_steps', 'convergence_failures', 'error_test_failures', 'residuals', 'tangents', 'solves',
                'substitutions', 'accuracy_warnings', 'measured_error', 'limits_passed', 'cost_share', 'final', 'mean_drilling', 'mean_last_quarter']
        self.assertEqual(list(summary), keys)
        self.assertEqual(summary['rejected_steps'], summary['convergence_failures'] + summary['error_test_failures'])
        self.assertTrue(written.startswith('{\n  "scene": "quick",\n') and written.endswith('}\n'))
        for count in ('nodes', 'steps', 'residuals', 'rejected_steps'):
            self.assertIsInstance(summary[count], int, count)
        # nine digits in the series, all of them here
        with open(self.file('q.csv')) as text:
            row = list(csv.DictReader(text))[-1]
        self.assertEqual('%.9g' % summary['final']['hook_load'], row['hook_load'])
        self.assertNotEqual(summary['final']['hook_load'], float(row['hook_load']))

    def test_off_bottom_means_are_null(self):
        self.succeed('run', QUICK, '--duration', '1', '--json', self.file('q.json'))
        with open(self.file('q.json')) as text:
            self.assertIsNone(json.load(text)['mean_drilling']['wob'])

    def test_two_runs_are_identical(self):
        for name in ('a.csv', 'b.csv'):
            self.succeed('run', QUICK, *NEAR_BOTTOM, '--duration', '20', '--every', '0.5', '--csv', self.file(name))
        with open(self.file('a.csv')) as a, open(self.file('b.csv')) as b:
            self.assertEqual(a.read(), b.read())

    def test_settings_replace_the_scene(self):
        self.succeed('run', QUICK, '--duration', '1', '--step', '0.002', '--element-length', '4', '--json', self.file('q.json'))
        with open(self.file('q.json')) as text:
            summary = json.load(text)
        self.assertEqual(summary['step'], 0.002)
        self.assertEqual(summary['steps'], 500)
        self.assertGreater(summary['nodes'], 25)


    def test_a_failed_computation_says_when_and_saves_the_last_good_state(self):
        done = drill('run', os.path.join(SOURCE, 'test/scenes/unsolvable.yaml'), '--duration', '60', '--json', self.file('f.json'),
                     '--csv', self.file('f.csv'))
        self.assertEqual(done.returncode, 3, done.stdout)
        self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
        self.assertIn(' s simulated: ', done.stderr)
        with open(self.file('f.json')) as text:
            summary = json.load(text)
        self.assertIn('did not converge', summary['failure'])
        self.assertIsNotNone(summary['final']['hook_load'])
        with open(self.file('f_string.csv')) as text:
            rows = list(csv.DictReader(text))
        self.assertEqual(len(rows), summary['nodes'])
        for row in rows:
            self.assertTrue(math.isfinite(float(row['tension'])))

    def test_a_failure_is_told_where_its_state_cannot_be_saved(self):
        scene = os.path.join(SOURCE, 'test/scenes/unsolvable.yaml')
        os.mkdir(self.file('f_string.csv'))
        done = drill('run', scene, '--duration', '60', '--json', self.file('f.json'))
        self.assertEqual(done.returncode, 3, done.stderr)
        self.assertIn(' s simulated: ', done.stderr)
        self.assertIn('f_string.csv cannot be written', done.stderr)
        done = drill('run', scene, '--duration', '60', '--json', '/dev/null')
        self.assertEqual(done.returncode, 3, done.stderr)
        self.assertIn(' s simulated: ', done.stderr)
        self.assertFalse(os.path.exists('/dev/null_string.csv'))

    def test_no_output_takes_the_place_of_an_input_or_another(self):
        scene = self.file('scene.yaml')
        shutil.copy(QUICK, scene)
        with open(scene) as text:
            before = text.read()
        other = os.path.join(os.path.dirname(scene), '.', 'scene.yaml')
        self.assertIn('is the scene', self.refuse('run', scene, '--json', other))
        self.assertIn('--profile: ', self.refuse('run', scene, '--profile', other))
        self.assertIn('is the scene', self.refuse('static', scene, '--csv', other))
        self.assertIn('is the file of --csv', self.refuse('run', scene, '--csv', self.file('a'), '--profile', self.file('./a')))
        self.assertIn('is the file of', self.refuse('run', scene, '--csv', self.file('a'), '--json', self.file('./a')))
        with open(scene) as text:
            self.assertEqual(before, text.read())
        self.succeed('run', scene, '--duration', '0.1', '--csv', '/dev/null', '--json', '/dev/null')

    def test_a_setting_in_a_scene_with_aliases_is_refused(self):
        with open(QUICK) as text:
            changed = text.read().replace('name: quick', 'name: &the_name quick', 1)
        with open(self.file('alias.yaml'), 'w') as out:
            out.write(changed)
        self.succeed('check', self.file('alias.yaml'), '--set', 'mud.density=1100')
        changed = re.sub(r'outer_diameter: ([0-9.]+)', r'outer_diameter: &od \1', changed, count=1)
        changed = re.sub(r'tool_joint_diameter: [0-9.]+', 'tool_joint_diameter: *od', changed, count=1)
        with open(self.file('alias.yaml'), 'w') as out:
            out.write(changed)
        self.succeed('check', self.file('alias.yaml'))
        self.assertIn('aliases', self.refuse('check', self.file('alias.yaml'), '--set', 'mud.density=1100'))

    def test_a_full_disk_is_told(self):
        if not os.path.exists('/dev/full'):
            self.skipTest('no /dev/full')
        for option in ('--csv', '--profile', '--json', '--path', '--raw-path'):
            done = drill('run', QUICK, '--duration', '0.1', option, '/dev/full')
            self.assertEqual(done.returncode, 3, option)
            self.assertIn('/dev/full could not be written completely', done.stderr)

    def test_a_run_ends_a_minute_after_its_program(self):
        self.succeed('run', QUICK, *ALONE, '--set', 'program=[{at: 0, brake: true}, {at: 2.5, brake: true}]', '--json', self.file('q.json'))
        self.assertAlmostEqual(json.load(open(self.file('q.json')))['simulated_s'], 62.5, places=6)


class Reference(Drill):
    def test_every_block_is_listed(self):
        text = self.succeed('reference')
        for block in ('well', 'formation[]', 'mud', 'string[]', 'rig.hoisting', 'rig.top_drive', 'contact', 'start', 'numerics',
                      'instruments.mwd', 'program[]'):
            self.assertIn('### `%s`' % block, text)


if __name__ == '__main__':
    drill_program = os.path.abspath(sys.argv.pop(1))
    skips.main()
