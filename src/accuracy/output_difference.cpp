#include "drill_rig_sim/accuracy/output_difference.h"

#include <algorithm>
#include <cmath>

namespace drill_rig_sim
{
namespace
{
constexpr double share_of_level = 0.1;
static_assert(30 * SlidingMean<30>::piece == difference_window, "pieces of the window");
static_assert(300 * SlidingMean<300>::piece == mean_window, "pieces of the window");
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
  signed_.add(off, duration);
  const bool first = time_ == 0.0;
  least_ = first ? other : std::min(least_, other);
  most_ = first ? other : std::max(most_, other);
  sum_ += std::abs(other) * duration;
  time_ += duration;
}

double OutputDifference::absolute() const noexcept
{
  const double begun = std::min(1.0, time_ / difference_window);  // there was no difference before the start
  return std::sqrt(begun * squares_.mean());
}

double OutputDifference::of_means() const noexcept
{
  return std::abs(signed_.mean());
}

double OutputDifference::scale() const noexcept
{
  const double resolved = traits_of(output_).resolved;
  return time_ > 0.0 ? std::max({most_ - least_, share_of_level * sum_ / time_, resolved}) : resolved;
}

}  // namespace drill_rig_sim
