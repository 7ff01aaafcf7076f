// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/accuracy/output_difference.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace drill_rig_sim
{
namespace
{
constexpr double share_of_level = 0.1;
static_assert(30 * SlidingMean<30>::piece == difference_window, "pieces of the window");
}  // namespace

void OutputDifference::add(double value, double other, double duration) noexcept
{
  if (output_ == Output::rop)
  {
    smooth_.add(value, duration);
    smooth_other_.add(other, duration);
    value = smooth_.mean();
    other = smooth_other_.mean();
  }
  const double off = value - other;
  squares_.add(off * off, duration);
  statistics_.add(value, duration);
  statistics_other_.add(other, duration);
  const bool first = time_ == 0.0;
  least_ = first ? other : std::min(least_, other);
  most_ = first ? other : std::max(most_, other);
  sum_ += std::abs(other) * duration;
  time_ += duration;
}

void OutputDifference::expect(double value) noexcept
{
  least_ = std::min(least_, value);
  most_ = std::max(most_, value);
}

double OutputDifference::absolute() const noexcept
{
  const double begun = std::min(1.0, time_ / difference_window);  // there was no difference before the start
  return std::sqrt(begun * squares_.mean());
}

StatisticDifferences OutputDifference::statistics() const noexcept
{
  const WindowStatistics::Summary one = statistics_.summary(), other = statistics_other_.summary();
  return {std::abs(one.mean - other.mean), std::abs(one.deviation - other.deviation),
          std::max(std::abs(one.least - other.least), std::abs(one.largest - other.largest)),
          one.period > 0.0 && other.period > 0.0 ? std::abs(one.period / other.period - 1.0)
                                                 : std::numeric_limits<double>::quiet_NaN()};
}

double OutputDifference::scale() const noexcept
{
  const double resolved = traits_of(output_).resolved;
  return std::max({most_ - least_, share_of_level * (time_ > 0.0 ? sum_ / time_ : 0.0), resolved});
}

}  // namespace drill_rig_sim
