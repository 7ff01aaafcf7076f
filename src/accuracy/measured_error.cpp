// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/accuracy/measured_error.h"

#include <cmath>

namespace drill_rig_sim
{
MeasuredError::MeasuredError(double error_over_difference) noexcept : error_over_difference_(error_over_difference)
{
  for (std::size_t i = 0; i < output_count; ++i) differences_[i] = OutputDifference(static_cast<Output>(i));
}

void MeasuredError::add_run(const Outputs& run, double top_drive_speed, double duration) noexcept
{
  frames_[run_++ % capacity] = {run, {}, top_drive_speed, duration};
  waiting_ += duration;
}

void MeasuredError::add_companion(const Outputs& companion) noexcept
{
  if (companion_ < run_) frames_[companion_++ % capacity].companion = companion;
}

bool MeasuredError::compare() noexcept
{
  const Frame& frame = frames_[compared_++ % capacity];
  waiting_ = compared_ == run_ ? 0.0 : waiting_ - frame.duration;
  if (std::isnan(frame.companion.front())) return false;
  for (std::size_t i = 0; i < output_count; ++i) differences_[i].add(frame.companion[i], frame.run[i], frame.duration);
  differences_[static_cast<std::size_t>(Output::bit_speed)].expect(frame.top_drive_speed);
  differences_[static_cast<std::size_t>(Output::wob)].expect(0.0);
  return true;
}

double MeasuredError::absolute_error(Output output) const noexcept
{
  return error_over_difference_ * differences_[static_cast<std::size_t>(output)].absolute();
}

double MeasuredError::error(Output output) const noexcept
{
  return absolute_error(output) / differences_[static_cast<std::size_t>(output)].scale();
}

StatisticDifferences MeasuredError::statistics(Output output) const noexcept
{
  const OutputDifference& difference = differences_[static_cast<std::size_t>(output)];
  StatisticDifferences off = difference.statistics();
  const double share = error_over_difference_ / difference.scale();
  off.mean *= share;
  off.deviation *= share;
  off.extremes *= share;
  off.period *= error_over_difference_;
  return off;
}

Outputs MeasuredError::errors() const noexcept
{
  Outputs out;
  for (std::size_t i = 0; i < output_count; ++i) out[i] = error(static_cast<Output>(i));
  return out;
}

Outputs MeasuredError::lasting(const Outputs& errors, double tolerance, double duration) noexcept
{
  Outputs out{};
  for (std::size_t i = 0; i < output_count; ++i)
  {
    above_for_[i] = errors[i] > tolerance ? above_for_[i] + duration : 0.0;
    if (above_for_[i] > output_traits[i].warned_after - rounding) out[i] = errors[i];
  }
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
