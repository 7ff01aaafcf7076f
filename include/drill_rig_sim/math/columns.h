// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_MATH_COLUMNS_H
#define DRILL_RIG_SIM_MATH_COLUMNS_H

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <vector>

namespace drill_rig_sim
{
/// One number of all nodes or elements side by side, as batch kernels want them. Before the first and behind the last there is
/// room for the lanes of a batch that are not used.
class Column
{
public:
  static constexpr int room = 8;

  /// All numbers are zero. An odd number of lines: columns of the same length begin in different sets of the cache.
  void resize(std::size_t count) { lines_.assign((count / room + 3) | 1, Line()); }
  double* data() noexcept { return lines_[1].number; }
  const double* data() const noexcept { return lines_[1].number; }
  double& operator[](std::ptrdiff_t i) noexcept { return data()[i]; }
  double operator[](std::ptrdiff_t i) const noexcept { return data()[i]; }

private:
  struct alignas(64) Line
  {
    double number[room] = {};
  };
  std::vector<Line> lines_;
};

/// A vector of all nodes or elements, a column for each of its numbers.
template <int N>
struct Columns
{
  using Vector = Eigen::Matrix<double, N, 1>;
  std::array<Column, N> part;

  Vector operator[](std::ptrdiff_t i) const noexcept
  {
    Vector out;
    for (int k = 0; k < N; ++k) out[k] = part[static_cast<std::size_t>(k)][i];
    return out;
  }
  void set(std::ptrdiff_t i, const Vector& v) noexcept
  {
    for (int k = 0; k < N; ++k) part[static_cast<std::size_t>(k)][i] = v[k];
  }
};

/// Makes room in all columns that a struct lists by visit().
class ColumnSizes
{
public:
  template <class List>
  static void resize(List& list, std::size_t count)
  {
    ColumnSizes sizes(count);
    list.visit(sizes);
  }
  void operator()(const char*, Column& column) { column.resize(count_); }
  template <int N>
  void operator()(const char* name, Columns<N>& columns)
  {
    for (Column& column : columns.part) (*this)(name, column);
  }

private:
  explicit ColumnSizes(std::size_t count) : count_(count) {}

  std::size_t count_;
};

}  // namespace drill_rig_sim

#endif
