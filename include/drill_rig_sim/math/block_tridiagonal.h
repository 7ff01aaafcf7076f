// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_MATH_BLOCK_TRIDIAGONAL_H
#define DRILL_RIG_SIM_MATH_BLOCK_TRIDIAGONAL_H

#include <Eigen/Core>
#include <vector>

#include "drill_rig_sim/math/kernel.h"

namespace drill_rig_sim
{
template <class Number>
struct BlockRowsOf;
struct BlockSweeps;
struct SweepRow;

/// A square matrix of blocks on three diagonals, not assumed symmetric, and its direct solution. A block row has six unknowns, or
/// two where it is small; vectors have six places for either, those of a small row are its first two. Blocks are row-major and
/// contiguous: block i of a diagonal starts at 36 i, a small one at 4 i.
class BlockTridiagonal
{
public:
  static constexpr int size = 6;
  using Block = Eigen::Map<Eigen::Matrix<double, size, size, Eigen::RowMajor>>;
  using SmallBlock = Eigen::Map<Eigen::Matrix<double, 2, 2, Eigen::RowMajor>>;

  /// n block rows of six, whose blocks are still to be filled, to be solved by this kernel; the only call that allocates.
  void resize(int n, Kernel kernel = Kernel::scalar);
  int rows() const noexcept { return n_; }
  /// Whether block row i has two unknowns.
  void set_small(int i, bool small) noexcept { small_[static_cast<std::size_t>(i)] = small; }
  bool small(int i) const noexcept { return small_[static_cast<std::size_t>(i)] != 0; }
  void set_zero() noexcept;

  Block diagonal(int i) noexcept { return Block(diagonal_.data() + 36 * i); }
  Block upper(int i) noexcept { return Block(upper_.data() + 36 * i); }  ///< block (i, i + 1)
  Block lower(int i) noexcept { return Block(lower_.data() + 36 * i); }  ///< block (i + 1, i)
  /// The same of small rows; the others are between two of them. Where a small row meets one of six, upper() and lower() hold
  /// their block in its first two rows or columns, and zeros in the others.
  SmallBlock small_diagonal(int i) noexcept { return SmallBlock(small_diagonal_.data() + 4 * i); }
  SmallBlock small_upper(int i) noexcept { return SmallBlock(small_upper_.data() + 4 * i); }
  SmallBlock small_lower(int i) noexcept { return SmallBlock(small_lower_.data() + 4 * i); }

  /// Solves A x = b in place of `b` (6 n numbers) by block elimination; the blocks are overwritten with what solve_again() needs.
  /// The scalar kernel goes from the first row to the last, others from both ends to the middle. Pivots stay within a block's
  /// diagonal order: meant for matrices dominated by inertia and stiffness. Returns false, with b undefined, at a vanishing or
  /// non-finite pivot.
  bool solve(double* b) noexcept;
  /// Solves with the matrix of the last solve(), which must have succeeded, for another `b`: a seventh of its work.
  void solve_again(double* b) const noexcept;
  /// y = A x, 6 n numbers each.
  void multiply(const double* x, double* y) noexcept;

private:
  int middle() const noexcept;
  template <class SmallRow, class SixRows>
  void sweep(SweepRow first, int left_first, SweepRow second, int left_second, SmallRow&& small_row,
             SixRows&& six_rows) const noexcept;
  void subtract_from_small(SweepRow at) noexcept;
  void subtract_from_right(SweepRow at, double* b) const noexcept;
  void substitute_small(SweepRow at, double* b) const noexcept;
  bool eliminate_small(SweepRow at, double* b) noexcept;
  bool eliminate_middle(double* b) noexcept;
  void substitute_middle(double* b) const noexcept;
  void substitute_outwards(double* b) const noexcept;
  BlockRowsOf<double> six() noexcept;
  BlockRowsOf<const double> six() const noexcept;
  BlockRowsOf<double> twos() noexcept;
  BlockRowsOf<const double> twos() const noexcept;
  bool both_small(int i) const noexcept { return small(i) && small(i + 1); }

  int n_ = 0;
  int middle_ = 0;  // the row that was solved last
  const BlockSweeps* sweeps_ = nullptr;
  std::vector<unsigned char> small_;
  std::vector<double> diagonal_, upper_, lower_;
  std::vector<double> small_diagonal_, small_upper_, small_lower_;
};

}  // namespace drill_rig_sim

#endif
