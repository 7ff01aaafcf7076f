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

Outputs MeasuredError::errors() const noexcept
{
  Outputs out;
  for (std::size_t i = 0; i < output_count; ++i) out[i] = error(static_cast<Output>(i));
  return out;
}

OutputError largest_of(const Outputs& errors, unsigned needs) noexcept
{
  OutputError largest;
  for (std::size_t i = 0; i < output_count; ++i)
    if ((needs & output_traits[i].need) && errors[i] > largest.error) largest = {static_cast<Output>(i), errors[i]};
  return largest;
}

}  // namespace drill_rig_sim
