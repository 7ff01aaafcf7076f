#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Tests of what `./test/benchmark/run --laws` makes of callgrind's counts."""
import os
import sys
import unittest

sys.dont_write_bytecode = True
sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import laws  # noqa: E402
import mud_costs  # noqa: E402


class Laws(unittest.TestCase):
    ANNOTATED = """
2,000 (100.0%)  /a/build/../src/sim/simulator.cpp:drill_rig_sim::Simulator::frame(double) [/a/lib.so]
  700 (35.00%)  /a/build/../src/model/forces/free_string.cpp:drill_rig_sim::add_free_string(drill_rig_sim::StageContext const&) [/a/lib.so]
  600 (30.00%)  /usr/include/emmintrin.h:drill_rig_sim::(anonymous namespace)::add(drill_rig_sim::StageContext const&) [/a/lib.so]
  400 (20.00%)  /a/build/../src/model/forces/span_wall.cpp:void drill_rig_sim::(anonymous namespace)::add_span_wall<&drill_rig_sim::sticking>(drill_rig_sim::StageContext const&) [/a/lib.so]
  380 (19.00%)  /a/build/../src/model/forces/span_wall.cpp:drill_rig_sim::(anonymous namespace)::add_span_wall<&drill_rig_sim::sticking>(drill_rig_sim::StageContext const&)::{lambda(int)#1}::operator()(int) const [/a/lib.so]
  300 (15.00%)  /a/build/../src/math/block_tridiagonal.cpp:drill_rig_sim::BlockTridiagonal::solve(double*)
   50 ( 2.50%)  src/math/block_tridiagonal.cpp:drill_rig_sim::BlockTridiagonal::solve_again(double*) const [/a/lib.so]
"""

    def test_a_part_is_the_sum_of_its_functions_in_their_own_files(self):
        rows, pieces = laws.table_of(self.ANNOTATED), dict(laws.PARTS)
        self.assertEqual(laws.count(rows, pieces['frame']), 2000)
        self.assertEqual(laws.count(rows, pieces['beams, inertia, drag of the mud']), 700)
        self.assertEqual(laws.count(rows, pieces['wall and friction, between nodes']), 400, 'what stands within it is in it')
        self.assertEqual(laws.count(rows, pieces['linear system']), 350)
        self.assertEqual(laws.count(rows, pieces['squeeze films']), 0)

    def test_an_older_tree_stands_beside_where_it_has_the_scene(self):
        numbers = list(range(len(laws.PARTS)))
        table = laws.text({scene.name: numbers for scene in laws.SCENES}, {laws.SCENES[0].name: numbers})
        self.assertIn('| %s | %s, before | %s |' % (laws.SCENES[0].name, laws.SCENES[0].name, laws.SCENES[1].name), table)
        self.assertIn('| frame | - | - | - |', table)

    def test_a_mud_has_the_options_of_its_row_only(self):
        for _, options in mud_costs.ROWS:
            mud = mud_costs.scene_with(options)['mud']
            self.assertEqual(set(options), set(mud) & set(mud_costs.ROWS[-1][1]))
        self.assertEqual('bingham', mud['rheology']['law'])

    def test_a_share_of_a_level_is_of_its_own_frame(self):
        found = {(row, level): [20.0, 2000.0 if level == 'beam3d' else 400.0] for row, _ in mud_costs.ROWS for level in mud_costs.LEVELS}
        self.assertIn('| all | 20 | 1.00 % | 5.00 % |', mud_costs.text(found))


if __name__ == '__main__':
    unittest.main()
