#ifndef DRILL_RIG_SIM_MATH_BLOCK_TRIDIAGONAL_H
#define DRILL_RIG_SIM_MATH_BLOCK_TRIDIAGONAL_H

#include <Eigen/Core>
#include <vector>

namespace drill_rig_sim
{
/// A square matrix of 6x6 blocks on three diagonals, not assumed symmetric, and its direct solution.
/// Blocks are row-major and contiguous: block i of a diagonal starts at 36 i.
class BlockTridiagonal
{
public:
  static constexpr int size = 6;
  using Block = Eigen::Map<Eigen::Matrix<double, size, size, Eigen::RowMajor>>;

  /// n block rows, whose blocks are still to be filled; the only call that allocates.
  void resize(int n);
  int rows() const noexcept { return n_; }
  void set_zero() noexcept;

  Block diagonal(int i) noexcept { return Block(diagonal_.data() + 36 * i); }
  Block upper(int i) noexcept { return Block(upper_.data() + 36 * i); }  ///< block (i, i + 1)
  Block lower(int i) noexcept { return Block(lower_.data() + 36 * i); }  ///< block (i + 1, i)

  /// Solves A x = b in place of `b` (6 n numbers) by block elimination; the blocks are overwritten with what solve_again() needs.
  /// Pivots stay within a block's diagonal order: meant for matrices dominated by inertia and stiffness.
  /// Returns false, with b undefined, at a vanishing or non-finite pivot.
  bool solve(double* b) noexcept;
  /// Solves with the matrix of the last solve(), which must have succeeded, for another `b`: a seventh of its work.
  void solve_again(double* b) const noexcept;
  /// y = A x, 6 n numbers each.
  void multiply(const double* x, double* y) noexcept;

private:
  void substitute_upwards(double* b) const noexcept;

  int n_ = 0;
  std::vector<double> diagonal_;
  std::vector<double> upper_;
  std::vector<double> lower_;
};

}  // namespace drill_rig_sim

#endif
