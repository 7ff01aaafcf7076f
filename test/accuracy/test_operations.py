#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""What the operations matrix measures and how it judges, on series made by hand."""
import math
import os
import sys
import tempfile
import unittest

import numpy

HERE = os.path.dirname(os.path.abspath(__file__))
sys.dont_write_bytecode = True
sys.path.insert(0, os.path.join(HERE, 'operations'))
import automatic  # noqa: E402
import cells  # noqa: E402
import matrix  # noqa: E402
import report  # noqa: E402

TIME = numpy.linspace(0.0, 10.0, 101)


def series(**columns):
    """Level 100 kN with a range of 50, all else at rest."""
    out = {name: numpy.zeros_like(TIME) for name in matrix.KEPT}
    out.update(time=TIME, hook_load=1e5 + 5e3 * TIME, torque=numpy.full_like(TIME, 2e4))
    out.update(columns)
    return out


class FakeCell:
    name = file = 'fake'

    def __init__(self, irregular=None):
        self._irregular = irregular

    def irregular(self):
        return self._irregular


def judged(table, own=None, warnings=(), irregular=None):
    known = dict.fromkeys(list(matrix.FLOORS) + ['period', 'inclination'], 0.0)
    known.update(own or {})
    summary = {'nodes': 100, 'residuals': 9, 'tangents': 5, 'solves': 5, 'substitutions': 5, 'steps': 4, 'rejected_steps': 0, 'step': 0.01, 'simulated_s': 0.04,
               'accuracy_warnings': list(warnings)}
    return matrix.judge(FakeCell(irregular), matrix.Run(table, summary), matrix.Reference(series(), known, '', ''))


class Errors(unittest.TestCase):
    def test_over_the_range_a_tenth_of_the_level_or_the_resolution(self):
        told = matrix.errors(series(hook_load=1e5 + 5e3 * TIME + 500.0, torque=numpy.full_like(TIME, 2e4 + 40.0), wob=numpy.full_like(TIME, 10.0)), series(), None)
        self.assertAlmostEqual(told['hook_load'], 500.0 / 5e4 / 0.02)  # range
        self.assertAlmostEqual(told['torque'], 40.0 / 2e3 / 0.02)      # a tenth of the level
        self.assertAlmostEqual(told['wob'], 10.0 / 1e3 / 0.02)         # resolution

    def test_the_worst_three_seconds(self):
        late = numpy.where((TIME >= 6.0) & (TIME < 9.0), 2e3, 0.0)
        told = matrix.worst_window(series(hook_load=1e5 + 5e3 * TIME + late, bit_up=numpy.full_like(TIME, 1.0)), series())
        self.assertAlmostEqual(told, 2e3 / 5e4 / 0.02)
        self.assertLess(matrix.errors(series(hook_load=1e5 + 5e3 * TIME + late), series(), None)['hook_load'], 0.6 * told)

    def test_inclination_is_absolute(self):
        told = matrix.errors(series(inclination=numpy.where(TIME == 5.0, math.radians(0.05), 0.0)), series(), None)
        self.assertAlmostEqual(told['inclination'], 0.5)

    def test_places_by_their_distance(self):
        told = matrix.errors(series(bit_east=numpy.full_like(TIME, 3e-4), bit_up=numpy.full_like(TIME, 4e-4)), series(), None)
        self.assertAlmostEqual(told['position'], 5e-4 / 0.01 / 0.02)

    def test_where_it_is_irregular_statistics_are_compared(self):
        swing = 2e4 + 1e3 * numpy.sin(20.0 * TIME)
        late = 2e4 - 1e3 * numpy.sin(20.0 * TIME)
        self.assertGreater(matrix.errors(series(torque=late), series(torque=swing), None)['torque'], 10.0)
        self.assertLess(matrix.errors(series(torque=late), series(torque=swing), (0.0, 10.0))['torque'], 1.5)
        self.assertGreater(matrix.errors(series(torque=2.2e4 - 1e3 * numpy.sin(20.0 * TIME)), series(torque=swing), (0.0, 10.0))['torque'], 1.5)

    def test_what_comes_after_an_irregular_stretch_is_not_compared(self):
        stopped = series(torque=numpy.where(TIME > 8.0, 9e4, 2e4))
        self.assertLess(matrix.errors(stopped, series(), (1.0, 8.0))['torque'], 1e-9)
        self.assertGreater(matrix.errors(stopped, series(), (1.0, 9.0))['torque'], 1.0)

    def test_period(self):
        self.assertAlmostEqual(matrix.period(TIME, 3.0 + numpy.sin(2.0 * math.pi * TIME / 1.4)), 1.4, delta=0.01)
        self.assertTrue(math.isnan(matrix.period(TIME, numpy.sin(2.0 * math.pi * TIME / 1.4) * numpy.exp(-TIME / 2.0))), 'waves that die out')
        spikes = 1e5 + 1e3 * (numpy.mod(TIME, 1.3) < 0.25)
        self.assertAlmostEqual(matrix.period(TIME, spikes), 1.3, 1)
        self.assertTrue(math.isnan(matrix.period(TIME, numpy.random.default_rng(1).normal(size=TIME.size))))
        self.assertTrue(math.isnan(matrix.period(TIME, numpy.zeros_like(TIME))))

    def test_the_hook_load_s_period_is_relative(self):
        def swing(seconds):
            return series(hook_load=1e5 + 2e3 * numpy.sin(2.0 * math.pi * TIME / seconds))
        told = matrix.errors(swing(1.03), swing(1.0), (0.0, 10.0))['period']
        self.assertAlmostEqual(told, 1.5, 0)
        self.assertEqual(matrix.errors(swing(1.03), swing(1.0), None)['period'], 0.0)
        self.assertEqual(matrix.errors(swing(1.0), series(hook_load=numpy.full_like(TIME, 1e5)), (0.0, 10.0))['period'], 0.0)

    def test_series_of_other_lengths_are_no_run(self):
        with self.assertRaises(ValueError):
            matrix.errors({name: column[:-1] for name, column in series().items()}, series(), None)


class Verdicts(unittest.TestCase):
    wrong = series(hook_load=1e5 + 5e3 * TIME + numpy.where(TIME > 5.0, 5e3, 0.0))

    def test_right(self):
        self.assertEqual(judged(series()).kind, 'right')

    def test_wrong_without_a_warning_is_missed(self):
        verdict = judged(self.wrong)
        self.assertEqual((verdict.kind, verdict.by), ('missed', 'hook_load'))

    def test_warned_before_it_went_wrong(self):
        self.assertEqual(judged(self.wrong, warnings=[{'since': 4.0, 'text': 'shorter elements'}]).kind, 'warned')
        self.assertEqual(judged(self.wrong, warnings=[{'since': 4.0, 'text': 'shorter elements'}]).note, 'shorter elements')

    def test_a_warning_that_comes_too_late_is_none(self):
        self.assertEqual(judged(self.wrong, warnings=[{'since': 9.0, 'text': 'shorter elements'}]).kind, 'missed')

    def test_a_reference_that_does_not_know_decides_nothing(self):
        self.assertEqual(judged(series(), own={'torque': 0.5}).kind, 'undecided')
        self.assertEqual(judged(self.wrong, own={'hook_load': 10.0}).kind, 'undecided')
        self.assertEqual(judged(self.wrong, own={'torque': 10.0}).kind, 'missed')

    def test_a_run_that_fails_is_missed_and_says_why(self):
        verdict = matrix.judge(FakeCell(), matrix.Run(None, {}, 'no solution'), matrix.Reference(series(), {'torque': 0.0}, '', ''))
        self.assertEqual((verdict.kind, verdict.note), ('missed', 'no solution'))


class Automatic(unittest.TestCase):
    def test_a_cell_is_judged_by_the_tolerance_asked_for(self):
        off = matrix.Run(series(torque=numpy.full_like(TIME, 2e4 + 40.0)), {'nodes': 1, 'residuals': 1, 'tangents': 1, 'solves': 1, 'substitutions': 1, 'steps': 1, 'rejected_steps': 0, 'step': 0.01, 'simulated_s': 0.01,
                                                                             'accuracy_warnings': []})  # 2 % of a tenth of the level
        reference = matrix.Reference(series(), dict.fromkeys(list(matrix.FLOORS) + ['period', 'inclination'], 0.1), '', '')
        told = [matrix.judge(FakeCell(), off, reference, tolerance) for tolerance in (0.05, 0.015, 0.002)]
        self.assertEqual([verdict.kind for verdict in told], ['right', 'missed', 'missed'])

    def test_the_first_setting_that_is_right_is_the_cheapest_by_hand(self):
        asked = []

        def judged_at(numerics, tolerances):
            asked.append((numerics, tolerances))
            told = [matrix.Verdict(FakeCell(), 'right' if numerics <= tolerance else 'missed') for tolerance in tolerances]
            for out in told:
                out.cost = 1.0 / numerics
            return told
        self.assertEqual(automatic.cheapest([0.04, 0.02, 0.01], {0.05: 200.0, 0.01: 200.0}, judged_at), {0.05: (25.0, '0.04'), 0.01: (100.0, '0.01')})
        self.assertEqual(asked, [(0.04, [0.05, 0.01]), (0.02, [0.01]), (0.01, [0.01])], 'one run for all tolerances')
        self.assertEqual(automatic.cheapest([0.04, 0.02], {0.05: 200.0, 0.01: 200.0}, judged_at), {0.05: (25.0, '0.04'), 0.01: (200.0, 'auto')})
        asked.clear()
        self.assertEqual(automatic.cheapest([0.04, 0.02, 0.015, 0.012, 0.01, 0.001], {0.001: 40.0}, judged_at), {0.001: (40.0, 'auto')})
        self.assertEqual(len(asked), 4, 'no further than three that are dearer')

    def test_settings_by_hand_begin_with_what_costs_least(self):
        settings = automatic.by_hand()
        self.assertEqual((settings[0].level, settings[0].length, settings[0].step), ('hybrid', 9.51, 0.05))
        self.assertEqual((settings[-1].level, settings[-1].length, settings[-1].step), ('beam3d', 2.4, 0.0025))

    def test_a_row_is_of_verdicts_and_cost(self):
        told = []
        for kind, cost in (('right', 2.0), ('right', 8.0), ('warned', 4.0)):
            told.append(matrix.Verdict(cells.Cell('J 2 km', '5 in', 'rock'), kind))
            told[-1].cost = cost
        name = told[0].cell.name
        row = automatic.Row(0.01, told, {name: 4.0})
        row.compare({(name, 0.01): 2.0})
        self.assertEqual(row.line(), '| 1 % | 3 | 2 | 1 | 0 | 67 % | 1.00 | 2.00 | 4.00 |')

    def test_cells_count_whose_reference_knows_its_error_to_a_third(self):
        asked = []

        def judge_all(todo, numerics, _):
            asked.append((str(numerics), [cell.operation for cell in todo]))
            return []
        todo = [cells.Cell('J 2 km', '5 in', operation) for operation in ('rock', 'stuck', 'reverse')]
        own = {'rock': 0.1, 'stuck': 0.7, 'reverse': 5.0}  # of 2 %
        automatic.play(todo, lambda cell: own[cell.operation], judge_all, None, None, searches=False)
        self.assertEqual(asked, [('beam3d', ['rock', 'stuck']), ('auto, tolerance=0.05', ['rock', 'stuck']), ('auto, tolerance=0.02', ['rock']),
                                 ('auto, tolerance=0.01', ['rock']),
                                 ('auto, tolerance=0.002', [])])


class Energy(unittest.TestCase):
    ACCOUNTS = {'closure': 0.001, 'throughput': 1e6, 'numerical_inertia': 4e4, 'numerical_contact': -3e4, 'numerical_share': 0.01, 'numerical_of_losses': 0.5}

    def test_what_cancels_counts(self):
        closure, dissipation = matrix.shares_of_energy(self.ACCOUNTS)
        self.assertEqual(closure, 0.001)
        self.assertAlmostEqual(dissipation, 0.07)

    def test_a_right_run_that_leaks_does_not_hold(self):
        verdict = judged(series())
        self.assertTrue(verdict.balances())  # nothing was counted
        self.assertTrue(report.holds([verdict], whole=False))
        verdict.closure, verdict.dissipation = matrix.shares_of_energy(self.ACCOUNTS)
        self.assertFalse(report.holds([verdict], whole=False))

    def test_of_the_whole_enough_are_right_and_decided(self):
        def verdicts(**kinds):
            return [matrix.Verdict(FakeCell(), kind) for kind, number in kinds.items() for _ in range(number)]
        self.assertTrue(report.holds(verdicts(right=17, warned=3, undecided=5), whole=True))
        self.assertFalse(report.holds(verdicts(right=16, warned=4), whole=True))
        self.assertFalse(report.holds(verdicts(right=17, undecided=5), whole=True))
        self.assertFalse(report.holds(verdicts(right=99, missed=1), whole=True))

    def test_the_right_ones_under_a_warning_are_counted(self):
        told = [matrix.Verdict(FakeCell(), kind, note) for kind, note in (('right', ''), ('right', 'torque'), ('warned', 'torque'))]
        told[1].window = 1.5
        self.assertEqual(report.summary_line(told), '3 cells: 2 right, 1 warned, 0 missed, 0 undecided; of the right ones under a warning: 1, of which 1 are beyond the '
                         'bound for three seconds')

    def test_by_operation_the_farthest_of_the_decided_stands(self):
        told = []
        for kind, worst, operation in (('right', 0.5, 'rock'), ('warned', 1.5, 'rock'), ('undecided', 9.0, 'rock'), ('undecided', 2.0, 'stuck')):
            told.append(matrix.Verdict(cells.Cell('J 2 km', '5 in', operation), kind))
            told[-1].worst, told[-1].by = worst, 'hook_load'
        rows = report.table_by_operation(told).splitlines()[2:]
        self.assertEqual(rows, ['| rock | 3 | 1 | 1 | 0 | 1 | 1.50 | hook load | J 2 km, 5 in |', '| stuck | 1 | 0 | 0 | 0 | 1 | - | - | - |'])


class References(unittest.TestCase):
    def test_one_that_is_kept_comes_back(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, 'r.npz')
            matrix.Reference(series(bit_up=-2000.0 - 0.01 * TIME), {'torque': 0.25}, 'trbdf2', 'abc').save(path)
            back = matrix.Reference.load(path)
        numpy.testing.assert_allclose(back.table['bit_up'], -2000.0 - 0.01 * TIME, atol=1e-8)
        self.assertEqual((back.own, back.numerics, back.made_of), ({'torque': 0.25}, 'trbdf2', 'abc'))

    def test_own_error_is_the_rest_of_a_series_where_there_is_one(self):
        def off(by):
            return series(torque=numpy.full_like(TIME, 2e4 + by))
        difference = matrix.errors(off(4.0), off(0.0), None)['torque']
        self.assertAlmostEqual(matrix.own_errors(off(0.0), off(4.0), off(20.0), None)['torque'], 1.25 * difference / 3.0, 3)  # second order
        self.assertAlmostEqual(matrix.own_errors(off(0.0), off(4.0), off(104.0), None)['torque'], 1.25 * difference / 3.0, 3)  # better is not believed
        self.assertAlmostEqual(matrix.own_errors(off(0.0), off(4.0), off(9.0), None)['torque'], difference, 3)  # hardly shrinks
        self.assertEqual(matrix.own_errors(off(0.0), off(0.0), off(9.0), None)['torque'], 0.0)

    def test_what_a_cell_can_afford_is_finer_where_it_is_shorter(self):
        by_name = {cell.name: cell for cell in cells.CELLS}
        short, long = by_name['vertical 1 km / 5 in / pick up 0.3'], by_name['extended 5 km / 5 in, motor / slide 25 min']
        self.assertEqual(matrix.reference_rung(short, 600.0), matrix.QUARTERS)
        self.assertGreater(matrix.reference_rung(long, 600.0), matrix.QUARTERS)


class Cells(unittest.TestCase):
    def test_there_are_ninety_with_names_of_their_own(self):
        self.assertGreaterEqual(len(cells.CELLS), 90)
        self.assertEqual(len({cell.file for cell in cells.CELLS}), len(cells.CELLS))
        self.assertLessEqual(cells.FAST, {cell.name for cell in cells.CELLS})


if __name__ == '__main__':
    unittest.main()
