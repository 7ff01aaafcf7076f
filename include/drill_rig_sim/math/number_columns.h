#ifndef DRILL_RIG_SIM_MATH_NUMBER_COLUMNS_H
#define DRILL_RIG_SIM_MATH_NUMBER_COLUMNS_H

#include <cstddef>
#include <vector>

namespace drill_rig_sim
{
/// Several quantities of all nodes or elements, those of one kind side by side, as batch kernels want them. Behind the last there is room
/// for the lanes of a batch that are not used. NumberColumns begin in different sets of the cache.
class NumberColumns
{
public:
  static constexpr int room = 8;  ///< numbers behind the last

  /// @param kinds  columns
  /// @param count  nodes or elements; all numbers are zero
  NumberColumns(int kinds, int count) : stride_(odd_lines(count)), lines_(static_cast<std::size_t>(kinds) * stride_) {}

  double* operator[](int kind) noexcept { return lines_[static_cast<std::size_t>(kind) * stride_].number; }
  const double* operator[](int kind) const noexcept { return lines_[static_cast<std::size_t>(kind) * stride_].number; }

private:
  struct alignas(64) Line
  {
    double number[room] = {};
  };
  static std::size_t odd_lines(int count) { return (static_cast<std::size_t>(count) / room + 2) | 1; }

  std::size_t stride_;  // lines
  std::vector<Line> lines_;
};

}  // namespace drill_rig_sim

#endif
