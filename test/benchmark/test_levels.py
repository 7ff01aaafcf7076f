#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Levels, variable steps and auto among the points of the benchmark, and the weights of counted work, on made-up data."""
import os
import sys
import unittest

HERE = os.path.dirname(os.path.abspath(__file__))
sys.dont_write_bytecode = True
sys.path.insert(0, HERE)
import auto  # noqa: E402
import points  # noqa: E402
import scenes  # noqa: E402
import weights  # noqa: E402


class Levels(unittest.TestCase):
    """Variable steps, levels of guided pipe and level auto among the points, and auto's table."""

    def grid(self, length=points.MESH_BY_THE_HOLE):
        return points.grid(scenes.ALL[0], ('bdf2', 'ida'), ['corotational'], 'bdf2', 0.01, length)

    def computed(self):
        grid = self.grid()
        for p in grid:
            p.errors, p.work, p.summary = {'all': 0.1}, 10.0, {'nodes': 100}
        points.mark_coarse(grid)
        return grid

    def test_every_level_has_variable_steps_of_every_tolerance(self):
        for level in (points.BEAM, points.HYBRID, points.AXIAL):
            variable = [p for p in self.grid() if p.step == points.VARIABLE and p.level == level and p.length == points.MESH_BY_THE_HOLE]
            self.assertEqual(tuple(p.tolerance for p in variable), points.TOLERANCES, level)
        self.assertEqual(tuple(p.tolerance for p in self.grid() if p.level == points.AUTO), (points.DEFAULT_TOLERANCE,) + points.AUTO_TOLERANCES)

    def test_no_two_points_share_their_files(self):
        for length in (points.MESH_BY_THE_HOLE, 9.5):
            names = [p.name for p in self.grid(length)[1:]]
            self.assertEqual(len(set(names)), len(names))

    def test_the_program_is_told_level_step_and_tolerance(self):
        p = points.Point(scenes.ALL[0], 'bdf2', 'corotational', points.VARIABLE, 9.5, tolerance=0.002, level=points.AUTO)
        self.assertEqual(p.options(), ['--level', 'auto', '--integrator', 'bdf2', '--step', '0.0', '--element-length', '9.5', '--set', 'numerics.tolerance=0.002'])
        self.assertEqual(p.label(), 'auto to 0.002')
        ida = points.Point(scenes.ALL[0], 'ida', 'corotational', 0.005, 9.5, tolerance=1e-3)
        self.assertIn('numerics.reference_tolerance=0.001', ida.options())

    def test_levels_of_guided_pipe_do_not_compete_and_auto_does(self):
        grid = self.computed()
        self.assertEqual({p.level for p in grid if p.competes}, {points.BEAM, points.AUTO})
        self.assertEqual({p.level for p in grid if p.counted and not p.competes}, {points.HYBRID, points.AXIAL})

    def test_the_cheapest_as_accurate_is_of_any_level_and_the_reference_method_is_not(self):
        grid = self.computed()
        hybrid, ida = next(p for p in grid if p.level == points.HYBRID), next(p for p in grid if p.method == 'ida')
        hybrid.work, ida.work = 4.0, 1.0
        star = next(p for p in grid if p.level == points.AUTO)
        row = auto.Row(star, grid)
        self.assertIs(row.rival, hybrid)
        self.assertAlmostEqual(row.over_cheapest, 2.5)
        self.assertAlmostEqual(row.over_fixed, 1.0)
        hybrid.errors = {'all': 0.1004}
        self.assertIs(auto.Row(star, grid).rival, hybrid)
        hybrid.errors = {'all': 0.11}
        self.assertAlmostEqual(auto.Row(star, grid).over_cheapest, 1.0)
        self.assertIs(auto.Row(star, grid, floor=0.2).rival, hybrid)  # both are as near as the reference can show

    def test_the_table_tells_each_scene_and_tolerance_and_what_failed(self):
        grid = self.computed()
        stars = sorted((p for p in grid if p.level == points.AUTO), key=lambda p: -p.tolerance)
        stars[0].summary, stars[1].errors, stars[1].failure = {'accuracy_warnings': ['so']}, None, 'no more'
        found = auto.rows({'axial_wave': grid}, {'axial_wave': 0.0})
        said = auto.text(found).splitlines()
        self.assertIn('| 5 % | 10 % | yes | 1.00 |', said[2])
        self.assertIn('| 2 % | failed: no more |', said[3])
        self.assertEqual(said[-3:], ['- To %s %%: within it in 0 of the 1 scenes whose reference is accurate enough; in geometric mean over all 1.00 times the cheapest\'s work, '
                                     '1.00 times that of free nodes by 10 ms.' % tolerance for tolerance in ('5', '1', '0.2')])

    def test_a_scene_whose_reference_cannot_tell_is_not_judged(self):
        def row(error, floor):
            star = points.Point(scenes.ALL[0], 'bdf2', 'corotational', points.VARIABLE, 9.5, tolerance=0.01, level=points.AUTO, default=True)
            star.errors, star.work = {'all': error}, 1.0
            return auto.Row(star, [star], floor)
        self.assertTrue(row(0.005, 0.003).judged and row(0.005, 0.003).within)
        self.assertFalse(row(0.005, 0.004).judged)
        self.assertTrue(row(0.02, 0.006).judged)  # beyond, however the reference errs
        self.assertFalse(row(0.02, 0.006).within)


class Work(unittest.TestCase):
    KERNELS = {'residuals': 3, 'tangents': 2, 'solves': 2, 'substitutions': 1}

    def weights(self, step=0.0, frame=0.0):
        return weights.Weights({'corotational': dict.fromkeys(weights.KERNELS, 10.0), 'guided': dict.fromkeys(weights.KERNELS, 1.0)}, {'step': step, 'frame': frame})

    def summary(self, **changed):
        return dict(self.KERNELS, nodes=100, guided_nodes=0.0, steps=4, rejected_steps=0, step=0.01, simulated_s=0.04, **changed)

    def test_guided_nodes_have_weights_of_their_own(self):
        self.assertEqual(self.weights().of('corotational', self.summary()), 8000.0)
        self.assertEqual(self.weights().of('corotational', dict(self.summary(), guided_nodes=60.0)), 0.4 * 8000.0 + 0.6 * 800.0)

    def test_steps_count_and_rejected_ones_too_and_frames(self):
        self.assertEqual(self.weights(step=5.0).of('corotational', dict(self.summary(), rejected_steps=2)), 8000.0 + 3000.0)
        self.assertAlmostEqual(self.weights(frame=5.0).of('corotational', self.summary()), 8000.0 + 2000.0)
        self.assertAlmostEqual(self.weights(frame=5.0).of('corotational', dict(self.summary(), step=0.04)), 8000.0 + 500.0)

    def test_what_is_beside_the_kernels_is_found_from_steps_of_two_lengths(self):
        def second(step):
            summary = dict(self.summary(), step=step, simulated_s=1.0, steps=round(1.0 / step))
            return self.weights(9.0, 4.0).of('corotational', summary), summary
        found = weights.beside_kernels([second(0.01), second(0.0025)], self.weights())
        self.assertAlmostEqual(found['step'], 9.0)
        self.assertAlmostEqual(found['frame'], 4.0)


if __name__ == '__main__':
    unittest.main()
