#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Error measures and verdict of the benchmark on made-up data."""
import math
import os
import re
import subprocess
import sys
import tempfile
import unittest

import numpy

HERE = os.path.dirname(os.path.abspath(__file__))
sys.dont_write_bytecode = True
sys.path.insert(0, HERE)
import drill  # noqa: E402
import fingerprint  # noqa: E402
import measure  # noqa: E402
import points  # noqa: E402
import reference  # noqa: E402
import report  # noqa: E402
import scenes  # noqa: E402
import verdict  # noqa: E402


def series(**columns):
    time = numpy.arange(0.0, 10.0 + 1e-9, 0.02)
    out = {name: numpy.zeros_like(time) for name in measure.COLUMNS}
    out['time'] = time
    for name, function in columns.items():
        out[name] = function(time)
    return out


class Errors(unittest.TestCase):
    def test_a_run_equal_to_the_reference_has_none(self):
        a = series(hook_load=lambda t: 1e5 * numpy.sin(t))
        self.assertEqual(measure.errors(a, a, scenes.Scene('s', '', 10.0))['all'], 0.0)

    def test_a_constant_offset_is_its_share_of_the_range(self):
        reference = series(wob=lambda t: 1e4 * t)
        run = series(wob=lambda t: 1e4 * t + 2e3)
        errors = measure.errors(run, reference, scenes.Scene('s', '', 10.0))
        self.assertAlmostEqual(errors['wob'], 2e3 / 1e5, 12)
        self.assertAlmostEqual(errors['all'], 2e3 / 1e5 / math.sqrt(6), 12)

    def test_position_is_one_output_of_three_columns(self):
        reference = series(bit_east=lambda t: 0.3 * t, bit_up=lambda t: 0.4 * t)  # range 5 m
        run = series(bit_east=lambda t: 0.3 * t, bit_up=lambda t: 0.4 * t, bit_north=lambda t: 0.05 + 0.0 * t)
        self.assertAlmostEqual(measure.errors(run, reference, scenes.Scene('s', '', 10.0))['bit_position'], 0.01, 12)

    def test_outputs_at_rest_are_measured_by_their_floor(self):
        run = series(torque=lambda t: 1.0 + 0.0 * t)
        self.assertAlmostEqual(measure.errors(run, series(), scenes.Scene('s', '', 10.0))['torque'], 0.01, 12)

    def test_phase_does_not_count_after_the_bifurcation(self):
        reference = series(bit_speed=lambda t: 5.0 + 5.0 * numpy.sin(2.0 * math.pi * t))
        late = series(bit_speed=lambda t: 5.0 + 5.0 * numpy.sin(2.0 * math.pi * t - 2.0 * (t > 5.0)))
        trace = measure.errors(late, reference, scenes.Scene('s', '', 10.0))
        statistics = measure.errors(late, reference, scenes.Scene('s', '', 10.0, trace_until=5.0))
        self.assertGreater(trace['bit_speed'], 0.3)
        self.assertLess(statistics['bit_speed'], 0.01)

    def test_period(self):
        time = numpy.arange(0.0, 20.0, 0.02)
        y = numpy.maximum(0.0, numpy.sin(2.0 * math.pi * time / 3.7))
        self.assertAlmostEqual(measure.period(time, y), 3.7, 3)
        self.assertTrue(math.isnan(measure.period(time, time)))
        reference = series(bit_speed=lambda t: numpy.sin(2.0 * math.pi * t))
        slower = series(bit_speed=lambda t: numpy.sin(2.0 * math.pi * t / 1.1))
        scene = scenes.Scene('s', '', 10.0, trace_until=0.0, period_of='bit_speed')
        self.assertAlmostEqual(measure.errors(slower, reference, scene)['period'], 0.1, 3)
        self.assertEqual(measure.errors(series(), reference, scene)['period'], 1.0)

    def test_times_that_differ_are_refused(self):
        scene = scenes.Scene('s', '', 10.0)
        for keep in (slice(None, -1), slice(1, None), slice(0, 1), slice(0, 250), slice(0, 500, 2)):
            with self.assertRaises(ValueError, msg=str(keep)):
                measure.errors({name: column[keep] for name, column in series().items()}, series(), scene)

    def test_a_run_of_long_steps_is_compared_where_it_has_samples(self):
        reference = series(wob=lambda t: 1e4 * t)
        run = {name: column[::2] for name, column in series(wob=lambda t: 1e4 * t + 2e3).items()}
        self.assertAlmostEqual(measure.errors(run, reference, scenes.Scene('s', '', 10.0))['wob'], 2e3 / 1e5, 12)


class Front(unittest.TestCase):
    POINTS = [(1e-1, 1.0), (1e-2, 10.0), (1e-3, 100.0), (1e-2, 30.0), (5e-2, 20.0)]

    def test_beaten_points_are_not_on_it(self):
        self.assertEqual(verdict.front(self.POINTS), [(1e-3, 100.0), (1e-2, 10.0), (1e-1, 1.0)])

    def test_cost_between_points_is_log_log(self):
        self.assertAlmostEqual(verdict.cost_at(self.POINTS, math.sqrt(1e-1 * 1e-2)), math.sqrt(10.0))
        self.assertAlmostEqual(verdict.cost_at(self.POINTS, 1e-2), 10.0)

    def test_cost_beyond_the_ends(self):
        self.assertEqual(verdict.cost_at(self.POINTS, 1.0), 1.0)
        self.assertTrue(math.isnan(verdict.cost_at(self.POINTS, 1e-4)))


class Judgement(unittest.TestCase):
    def scene(self, ratio):
        return verdict.SceneVerdict('s', [(1e-2, 1.0), (1e-3, 10.0)], (1e-2, ratio))

    def test_a_default_on_the_front_passes(self):
        self.assertEqual(self.scene(1.0).ratio, 1.0)
        self.assertTrue(verdict.Verdict([self.scene(1.0), self.scene(1.0)]).holds)

    def test_the_geometric_mean_decides(self):
        self.assertTrue(verdict.Verdict([self.scene(2.0), self.scene(1.1)]).holds)
        self.assertFalse(verdict.Verdict([self.scene(2.0), self.scene(1.2)]).holds)

    def test_one_scene_may_not_cost_more_than_four_times(self):
        good = [self.scene(1.0)] * 5
        self.assertFalse(verdict.Verdict(good + [self.scene(4.1)]).holds)
        self.assertTrue(verdict.Verdict(good + [self.scene(3.9)]).holds)

    def test_a_default_that_fails_fails_the_verdict(self):
        self.assertFalse(verdict.Verdict([self.scene(1.0)], ['other']).holds)
        self.assertFalse(verdict.Verdict([]).holds)

    def test_one_scene_may_not_be_farther_off_than_its_limit_however_cheap(self):
        def judged(error):
            scene = verdict.SceneVerdict('s', [(1e-2, 1.0), (1e-3, 10.0)], (error, 0.5), largest_error=0.05)
            return verdict.Verdict([scene])
        self.assertTrue(judged(0.05).holds)
        self.assertFalse(judged(0.051).holds)
        self.assertIn('s: the error of the default is 5.1e-02, 5.0e-02 is allowed', judged(0.051).complaints)

    def test_errors_below_the_references_own_count_as_that(self):
        judged = verdict.SceneVerdict('s', [(1e-6, 1.0), (1e-2, 0.5)], (1e-5, 3.0), floor=1e-4)
        self.assertEqual(judged.error, 1e-4)
        self.assertAlmostEqual(judged.ratio, 3.0)


class Scenes(unittest.TestCase):
    def assert_whole(self, number):
        self.assertAlmostEqual(number, round(number), 6)

    def test_every_scene_has_its_file_and_times_that_fit(self):
        for scene in scenes.ALL + scenes.FAST:
            self.assertTrue(os.path.exists(scene.path), scene.path)
            self.assertLessEqual(scene.trace_until, scene.duration)
            for step in scene.steps + scenes.SHORT_STEPS:
                self.assert_whole(max(scene.every / step, step / scene.every))
                self.assert_whole(scene.duration / max(scene.every, step))
            self.assert_whole(scene.duration / scene.every)

    def test_every_scene_limits_the_defaults_error_and_says_why(self):
        for scene in scenes.ALL:
            self.assertGreater(scene.largest_error, 0.0, scene.name)
            self.assertGreater(len(scene.why_so_large), 20, scene.name)

    def test_a_scenes_numbers_are_what_counts_not_their_spelling(self):
        with tempfile.TemporaryDirectory() as folder:
            class Here(scenes.Scene):
                path = os.path.join(folder, 'here.yaml')

            def hash_of(scene_text, survey_text):
                for name, text in (('here.yaml', scene_text), ('s.csv', survey_text)):
                    with open(os.path.join(folder, name), 'w') as out:
                        out.write(text)
                return reference.scene_hash(Here('here', '', 1.0))
            usual = hash_of('well: {survey: s.csv}\nmud: {density: 1150.0}\n', 'md_m\n0\n9\n')
            self.assertEqual(hash_of('# a word\nmud: {density: 1.15e+3}\nwell:\n  survey: s.csv\n', '# another\nmd_m\n0\n9\n'), usual)
            self.assertNotEqual(hash_of('well: {survey: s.csv}\nmud: {density: 1151.0}\n', 'md_m\n0\n9\n'), usual)
            self.assertNotEqual(hash_of('well: {survey: s.csv}\nmud: {density: 1150.0}\n', 'md_m\n0\n8\n'), usual)


class Rivals(unittest.TestCase):
    """The limit of one scene can be passed by the points that run: those of real scenes, costed by steps x elements x iterations."""

    @staticmethod
    def step_of(point):
        """Variable ones are about as long as their tolerance asks."""
        return math.sqrt(point.tolerance) * 0.05 if point.step == points.VARIABLE else point.step

    def ratio(self, scene, error, default_step=0.01):
        def cost(point):
            if point.step == points.VARIABLE:
                return 3.0 / (self.step_of(point) * 9.5)
            iterations = {None: 3.0, points.TIGHT_NEWTON: 4.0, points.LOOSE_NEWTON: 2.0, points.LOOSEST_NEWTON: 1.5}[point.newton]
            return iterations / (point.step * point.length)
        grid = points.grid(scene, ('bdf2', 'trbdf2'), ['corotational'], 'bdf2', default_step, 9.5)
        judged = verdict.SceneVerdict(scene.name, [(error(p), cost(p)) for p in grid], (error(grid[0]), cost(grid[0])))
        return judged.ratio

    def test_where_steps_make_no_error_a_default_of_short_steps_passes_the_limit(self):
        for scene in scenes.ALL:
            self.assertGreater(self.ratio(scene, lambda p: 0.01), verdict.SCENE_LIMIT, scene.name)

    def test_where_steps_make_the_error_it_does_not(self):
        for scene in scenes.ALL:
            self.assertLess(self.ratio(scene, lambda p: self.step_of(p) ** 2 + (p.newton or 0.0)), 2.0, scene.name)

    def test_finer_settings_than_the_defaults_run_too(self):
        for scene in scenes.ALL:
            grid = points.grid(scene, ('bdf2', 'ida'), ['corotational'], 'bdf2', 0.01, 9.5)
            self.assertTrue(any(p.step < 0.01 for p in grid) and any(p.newton and p.newton < 1e-6 for p in grid))
            self.assertLessEqual(min(p.length for p in grid), 2.375 if scene.reference_length < 2.375 else 4.75)
            self.assertEqual({p.tolerance for p in grid if p.method == 'ida'}, {None, 1e-4, 1e-3})
            self.assertEqual(len({p.name for p in grid[1:]}), len(grid) - 1)


    def test_the_references_method_and_what_failed_do_not_compete(self):
        grid = points.grid(scenes.ALL[0], ('bdf2', 'ida'), ['corotational'], 'bdf2', 0.01, 9.5)
        self.assertFalse(any(p.competes for p in grid))
        for p in grid:
            p.errors = {'all': 0.1}
        self.assertEqual({p.method for p in grid if p.competes}, {'bdf2'})

    def test_a_mesh_coarser_than_the_defaults_does_not_compete_and_is_told(self):
        grid = [p for p in points.grid(scenes.ALL[0], ('bdf2',), ['corotational'], 'bdf2', 0.01, points.MESH_BY_THE_HOLE) if p.level == points.BEAM or p.default]
        for p in grid:
            p.errors, p.work, p.summary = {'all': 0.1}, 100.0 / (p.length or 4.75), {'nodes': 100 / (p.length or 4.75)}
        points.mark_coarse(grid)
        self.assertEqual({p.length for p in grid if p.coarse}, {9.5})
        self.assertFalse(any(p.competes for p in grid if p.coarse))
        self.assertTrue(all(p.competes for p in grid if not p.coarse))
        of = {coarse: [(p.error, p.work) for p in grid if p.coarse == coarse] for coarse in (False, True)}
        judged = verdict.SceneVerdict('s', of[False], (0.1, 100.0 / 4.75), coarse=of[True])
        self.assertAlmostEqual(judged.ratio, 1.0)
        self.assertAlmostEqual(judged.ratio_on_any_mesh, 2.0)

    def test_the_cheapest_named_is_one_that_competes(self):
        scene, grid = scenes.ALL[0], points.grid(scenes.ALL[0], ('bdf2', 'ida'), ['corotational'], 'bdf2', 0.01, 9.5)
        for p in grid:
            p.errors, p.work, p.cpu = {'all': 0.1}, 1.0 if p.method == 'ida' else 10.0, 1.0
        judged = verdict.Verdict([verdict.SceneVerdict(scene.name, [(p.error, p.work) for p in grid if p.competes], (0.1, 10.0))])
        note = {'recipe': reference.recipes(scene, ('ida',))[0][0], 'own_error': {}}
        said = report.text([scene], {scene.name: grid}, {scene.name: note}, judged)
        self.assertIn('axial_wave, 1.00e-01, 1.00, auto to 0.02', said)
        self.assertNotIn('better than', said)


class Fingerprints(unittest.TestCase):
    SCENE = scenes.Scene('s', '', 10.0, fingerprint_until=10.0)

    def recorded(self, **columns):
        return {name: ' '.join('%.9g' % value for value in column) for name, column in series(**columns).items()}

    def test_rounding_makes_nothing_stale(self):
        recorded = self.recorded(wob=lambda t: 1e4 * t, torque=lambda t: 500.0 + t)
        now = self.recorded(wob=lambda t: 1e4 * t + 4.0, torque=lambda t: 500.0 + t + 1e-3)
        self.assertIsNone(fingerprint.complaint(self.SCENE, now, recorded))

    def test_a_changed_law_does_and_says_where_and_what_to_do(self):
        recorded = self.recorded(wob=lambda t: 1e4 * t)
        said = fingerprint.complaint(self.SCENE, self.recorded(wob=lambda t: 1.001e4 * t), recorded)
        self.assertRegex(said, r'^s: its reference is stale: wob .* 1\.0e-03 .*--full --scene s$')

    def test_what_cannot_be_compared_is_stale(self):
        recorded = self.recorded()
        for now in ({name: line[:-2] for name, line in recorded.items()}, {name: line for name, line in recorded.items() if name != 'wob'},
                    self.recorded(torque=lambda t: t * float('nan'))):
            self.assertIsNotNone(fingerprint.complaint(self.SCENE, now, recorded))
        self.assertRegex(fingerprint.complaint(self.SCENE, recorded, None), 'no fingerprint')

    def test_one_of_another_length_is_stale_and_says_so(self):
        recorded = self.recorded()
        said = fingerprint.complaint(scenes.Scene('s', '', 10.0, fingerprint_until=5.0), recorded, recorded)
        self.assertRegex(said, '^s: its reference is stale: its fingerprint covers 10 s, now 5 s are wanted; make')

    def test_other_settings_in_scenes_make_a_reference_stale(self):
        with tempfile.TemporaryDirectory() as folder:
            def scene(**settings):
                return scenes.Scene('tagging', '', 3.0, **settings)
            note = {'scene_hash': reference.scene_hash(scene()), 'recipe': reference.recipes(scene(), ('ida',))[0][0]}
            reference.save(folder, scene(), series(), note)
            self.assertEqual(reference.load(folder, scene())[1], note)
            for settings in ({'reference_length': 2.0}, {'reference_step': 1e-3}, {'reference_tolerance': 1e-6}):
                with self.assertRaisesRegex(reference.Stale, '^tagging: its reference is stale: .*--full --scene tagging$'):
                    reference.load(folder, scene(**settings))

    def test_the_references_have_theirs(self):
        for scene in scenes.ALL:
            note = reference.load(os.path.join(HERE, 'reference'), scene)[1]
            with self.subTest(scene.name):
                self.assertIsNone(fingerprint.complaint(scene, note['fingerprint'], note['fingerprint']))


class CommittedTable(unittest.TestCase):
    """pictures/verdict.md has the columns, row names and wording that report.py writes today; its figures are not looked at."""
    maxDiff = None

    def rows_and_words(self, folder):
        """Of a verdict.md: the head, of each scene its name, what is allowed and the reference, and the words of the line below."""
        with open(os.path.join(folder, 'verdict.md')) as file:
            lines = file.read().splitlines()
        head, *rows = [[cell.strip() for cell in line.strip('|').split('|')] for line in lines if line.startswith('| ')]
        stays = [head.index(name) for name in ('scene', 'allowed', 'reference') if name in head]
        words = next(line for line in lines if line.startswith('geometric mean')).split(';')[0].strip('.')
        return head, [[row[k] for k in stays] for row in rows[1:]], re.sub(r'\d+\.\d+', '#', words)

    def test_it_is_as_it_would_be_written_today(self):
        by_scene, judged, notes = {}, [], {}
        for scene in scenes.ALL:
            by_scene[scene.name] = grid = points.grid(scene, ('bdf2', 'ida'), ['corotational'], 'bdf2', 0.01, 9.5)
            for p in grid:
                p.errors, p.work, p.cpu = {'all': 0.001}, 1.0, 1.0
            judged.append(verdict.SceneVerdict(scene.name, [(0.001, 1.0)], (0.001, 1.0)))
            notes[scene.name] = reference.read_note(os.path.join(HERE, 'reference'), scene)
        about = {'cpu': '', 'cores': 2, 'compiler': '', 'flags': '', 'load': [0.0], 'date': ''}
        with tempfile.TemporaryDirectory() as folder:
            report.write(scenes.ALL, by_scene, notes, verdict.Verdict(judged), about, folder)
            today = self.rows_and_words(folder)
        self.assertEqual(self.rows_and_words(os.path.join(HERE, 'pictures')), today,
                         'make it again with ./test/benchmark/run --update-readme')


class Usage(unittest.TestCase):
    def test_wrong_usage_is_one_line_and_status_2(self):
        command = [sys.executable, os.path.join(HERE, 'run'), '--drill']
        for words in (['/no/such/program'], ['/bin/true', '--scene', 'nowhere'], ['/bin/true', '--method', 'guess'],
                      ['/bin/true', '--update-readme', '--fast'], ['/bin/true', '--update-readme', '--scene', 'drilling'],
                      ['/bin/true', '--update-readme', '--method', 'bdf2']):
            done = subprocess.run(command + words, stdout=subprocess.PIPE, stderr=subprocess.PIPE, universal_newlines=True, check=False)
            self.assertEqual((done.returncode, done.stdout, done.stderr.count('\n')), (2, '', 1), done.stderr)


# what a program given to drill.Drill writes, as the offline runner would
RUNNER = """#!/usr/bin/python3
import json, sys
place = dict(zip(sys.argv, sys.argv[1:]))
with open(place['--csv'], 'w') as out:
    out.write('%s\\n' + ','.join(['0'] * %d) + '\\n')
with open(place['--json'], 'w') as out:
    json.dump({'cpu_s': 1.0}, out)
""" % (','.join(measure.COLUMNS), len(measure.COLUMNS))


class Runs(unittest.TestCase):
    """The offline runner's place is taken by a small program."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def drill(self, body, **options):
        path = os.path.join(self.folder, 'drill')
        with open(path, 'w') as out:
            out.write(body)
        os.chmod(path, 0o755)
        return drill.Drill(path, os.path.join(self.folder, 'runs'), **options)

    def test_a_failure_is_kept_until_the_run_succeeds(self):
        scene = scenes.FAST[0]
        with self.assertRaisesRegex(drill.Failed, 'no more'):
            self.drill('#!/bin/sh\necho no more >&2; exit 3\n').run('a', scene)
        with self.assertRaisesRegex(drill.Failed, 'no more'):
            self.drill(RUNNER, reuse=True).run('a', scene)
        self.drill(RUNNER).run('a', scene)
        self.drill('#!/bin/sh\nexit 3\n', reuse=True).run('a', scene)

    def test_too_much_cpu_is_a_failure_and_so_is_no_end(self):
        with self.assertRaisesRegex(drill.Failed, 'more than 0.9 s of CPU'):
            self.drill(RUNNER, cpu_limit=0.9).run('a', scenes.FAST[0])
        with self.assertRaisesRegex(drill.Failed, 'not ended after 0.4 s'):
            self.drill('#!/bin/sh\nexec sleep 60\n', cpu_limit=0.1).run('a', scenes.FAST[0])

    def test_the_system_limits_no_cpu(self):
        free = '#!/bin/sh\n[ "$(ulimit -t)" = unlimited ] && exit 0\nulimit -t >&2; exit 1\n'
        self.assertEqual(self.drill(free).call([]), '')


if __name__ == '__main__':
    unittest.main()
