#include "drill_rig_sim/accuracy/measured_error.h"

#include <algorithm>

namespace drill_rig_sim
{
namespace
{
constexpr double seen = 0.1;  // share of what an instrument tells apart below which no error matters
}

MeasuredError::MeasuredError(double tolerance) noexcept : resolved_share_(seen / tolerance)
{
  for (std::size_t i = 0; i < output_count; ++i) differences_[i] = OutputDifference(static_cast<Output>(i));
}

void MeasuredError::add(const Outputs& run, const Outputs& finer, double duration) noexcept
{
  for (std::size_t i = 0; i < output_count; ++i) differences_[i].add(run[i], finer[i], duration);
}

double MeasuredError::error(Output output) const noexcept
{
  const OutputDifference& difference = differences_[static_cast<std::size_t>(output)];
  return error_over_difference * difference.absolute() / std::max(difference.scale(), resolved_share_ * traits_of(output).resolved);
}

MeasuredError::OfOutput MeasuredError::largest(unsigned needs) const noexcept
{
  OfOutput largest;
  for (std::size_t i = 0; i < output_count; ++i)
  {
    const Output output = static_cast<Output>(i);
    const double here = needs & traits_of(output).need ? error(output) : 0.0;
    if (here > largest.error) largest = {output, here};
  }
  return largest;
}

}  // namespace drill_rig_sim
