#include "drill_rig_sim/accuracy/measured_error.h"

#include <algorithm>
#include <cmath>

namespace drill_rig_sim
{
namespace
{
constexpr double seen = 0.1;  // share of an instrument's resolution below which no error matters
}

MeasuredError::MeasuredError(double tolerance, double error_over_difference) noexcept
    : error_over_difference_(error_over_difference), resolved_share_(seen / tolerance)
{
  for (std::size_t i = 0; i < output_count; ++i) differences_[i] = OutputDifference(static_cast<Output>(i));
}

void MeasuredError::add_run(const Outputs& run, double duration) noexcept
{
  frames_[run_++ % capacity] = {run, {}, duration};
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
  return true;
}

double MeasuredError::absolute_error(Output output) const noexcept
{
  return error_over_difference_ * differences_[static_cast<std::size_t>(output)].absolute();
}

double MeasuredError::scale(Output output) const noexcept
{
  return std::max(differences_[static_cast<std::size_t>(output)].scale(), resolved_share_ * traits_of(output).resolved);
}

double MeasuredError::error(Output output) const noexcept
{
  return absolute_error(output) / scale(output);
}

StatisticDifferences MeasuredError::statistics(Output output) const noexcept
{
  StatisticDifferences off = differences_[static_cast<std::size_t>(output)].statistics();
  const double share = error_over_difference_ / scale(output);
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

OutputError largest_of(const Outputs& errors, unsigned needs) noexcept
{
  OutputError largest;
  for (std::size_t i = 0; i < output_count; ++i)
    if ((needs & output_traits[i].need) && errors[i] > largest.error) largest = {static_cast<Output>(i), errors[i]};
  return largest;
}

}  // namespace drill_rig_sim
