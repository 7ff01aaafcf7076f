// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_MATH_BLOCK_SWEEPS_H
#define DRILL_RIG_SIM_SRC_MATH_BLOCK_SWEEPS_H

#include "drill_rig_sim/math/kernel.h"

namespace drill_rig_sim
{
/// Blocks of a BlockTridiagonal, laid out as there.
template <class Number>
struct BlockRowsOf
{
  int count;
  Number *diagonal, *upper, *lower;
};
using BlockRows = BlockRowsOf<double>;
using SolvedRows = BlockRowsOf<const double>;  ///< of an eliminated matrix, for further right sides

/// A block row that a sweep over the matrix has come to, and the way it goes: +1 or -1.
struct SweepRow
{
  int row, step;
};

/// Sweeps over `count` neighbouring block rows of six, from `a` on and from `b` on at once; where both are the same, from there
/// alone. Of row i and a sweep inwards by steps s: D is its diagonal block, L that to row i - s, zero where there is none, U that
/// to row i + s.
struct BlockSweeps
{
  bool both_ends;  ///< whether a matrix is swept from both ends to its middle, or from the first row to the last
  /// Inwards: in place of D what is needed of D' = D - L W of row i - s, in place of U W = D'^-1 U, in place of the right side b
  /// y = D'^-1 (b - L y of row i - s). False at a pivot that vanishes or is not finite.
  bool (*eliminate)(const BlockRows& rows, SweepRow a, SweepRow b, int count, double* right) noexcept;
  /// Inwards, for another right side: its y.
  void (*substitute_inwards)(const SolvedRows& rows, SweepRow a, SweepRow b, int count, double* right) noexcept;
  /// Outwards, by steps s: x = y - W x of row i - s.
  void (*substitute_outwards)(const SolvedRows& rows, SweepRow a, SweepRow b, int count, double* right) noexcept;
};

extern const BlockSweeps scalar_sweeps;
const BlockSweeps& block_sweeps(Kernel kernel) noexcept;

}  // namespace drill_rig_sim

#endif
