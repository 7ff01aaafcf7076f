// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_REFERENCE_SPARSE_JACOBIAN_H
#define DRILL_RIG_SIM_REFERENCE_SPARSE_JACOBIAN_H

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace drill_rig_sim
{
/// A square sparse matrix in compressed columns, put together by adding entries in any order; entries at the same place add up.
/// As long as the same places are named in the same order as last time, the pattern is kept and nothing is sorted.
class SparseJacobian
{
public:
  explicit SparseJacobian(int size) : size_(size) {}

  void begin() { entries_.clear(), values_in_.clear(); }
  void add(int row, int column, double value)
  {
    entries_.push_back(static_cast<std::uint64_t>(column) << 32 | static_cast<std::uint32_t>(row));
    values_in_.push_back(value);
  }
  /// A dense block whose first entry stands at (row, column).
  template <typename Block>
  void add_block(int row, int column, const Eigen::MatrixBase<Block>& block)
  {
    for (Eigen::Index j = 0; j < block.cols(); ++j)
      for (Eigen::Index i = 0; i < block.rows(); ++i) add(row + static_cast<int>(i), column + static_cast<int>(j), block(i, j));
  }
  /// Sums up. True: the pattern is not that of last time.
  bool finish();

  int size() const { return size_; }
  const std::vector<std::int64_t>& column_starts() const { return starts_; }  ///< size + 1
  const std::vector<std::int64_t>& rows() const { return rows_; }
  const std::vector<double>& values() const { return values_; }
  /// y = A x.
  void multiply(const double* x, double* y) const;

private:
  int size_;
  std::vector<std::uint64_t> entries_, known_entries_;
  std::vector<double> values_in_;
  std::vector<std::size_t> slots_;  // of known_entries_ in values_
  std::vector<std::int64_t> starts_, rows_;
  std::vector<double> values_;
};

}  // namespace drill_rig_sim

#endif
