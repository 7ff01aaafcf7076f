// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/instruments/period_mean.h"

#include <algorithm>

namespace drill_rig_sim
{
void PeriodMean::take(double value, double time) noexcept
{
  if (period_ > 0.0 && held_ > 0 && time > now_.time) now_.integral += 0.5 * (value_ + value) * (time - now_.time);
  now_.time = time;
  value_ = value;
  if (period_ == 0.0 || (held_ > 0 && time < samples_[newest_].time + period_ / pieces)) return;
  newest_ = (newest_ + 1) % samples_.size();
  samples_[newest_] = now_;
  held_ = std::min(held_ + 1, samples_.size());
}

double PeriodMean::mean() const noexcept
{
  if (held_ == 0) return value_;
  const double begin = std::max(now_.time - period_, back(held_ - 1).time);
  std::size_t k = 0;
  while (k + 1 < held_ && back(k).time > begin) ++k;
  const Sample &before = back(k), &after = k > 0 ? back(k - 1) : now_;
  const double share = after.time > before.time ? (begin - before.time) / (after.time - before.time) : 0.0;
  const double integral = before.integral + share * (after.integral - before.integral);
  return now_.time > begin ? (now_.integral - integral) / (now_.time - begin) : value_;
}

}  // namespace drill_rig_sim
