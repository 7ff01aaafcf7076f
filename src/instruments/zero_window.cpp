// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/instruments/zero_window.h"

#include <cmath>

#include "drill_rig_sim/math/units.h"

namespace drill_rig_sim
{
void ZeroWindow::Moments::join(double weight, const Moments& other, double added) noexcept
{
  const double difference = other.mean - mean, share = added / (weight + added);
  mean += difference * share;
  square += other.square + difference * difference * weight * share;
}

void ZeroWindow::Part::join(const Part& other) noexcept
{
  hook_load.join(length, other.hook_load, other.length);
  pressure.join(length, other.pressure, other.length);
  length += other.length;
}

void ZeroWindow::restart() noexcept
{
  begun_ = false;
  count_ = 0;
  held_ = 0.0;
}

void ZeroWindow::take(double hook_load, double pressure, double time) noexcept
{
  const double since = begun_ ? time - last_ : 0.0;
  if (begun_ && !(since > 0.0)) return;
  begun_ = true;
  last_ = time;
  if (!(since > 0.0)) return;
  if (count_ == 0 || parts_[newest_].length >= part_length - time_rounding)
  {
    newest_ = (newest_ + 1) % most_parts;
    if (count_ == most_parts)
      held_ -= parts_[newest_].length;
    else
      ++count_;
    parts_[newest_] = Part();
  }
  parts_[newest_].join({since, {hook_load, 0.0}, {pressure, 0.0}});
  held_ += since;
}

Zero ZeroWindow::over(double duration) const noexcept
{
  Part all;
  for (std::size_t k = 0; k < count_ && all.length < duration - time_rounding; ++k)
    all.join(parts_[(newest_ + most_parts - k) % most_parts]);
  if (!(all.length > 0.0)) return {};
  return {all.length, all.hook_load.mean, std::sqrt(all.hook_load.square / all.length), all.pressure.mean,
          std::sqrt(all.pressure.square / all.length)};
}

}  // namespace drill_rig_sim
