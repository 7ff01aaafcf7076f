// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/crew/pressure_trend.h"

#include <algorithm>
#include <cmath>

namespace drill_rig_sim
{
void PressureTrend::take(double pressure, double time) noexcept
{
  if (!begun) *this = {pressure, pressure, time, true};
  const double duration = time - at;
  at = time;
  fast_mean += duration / (fast + duration) * (pressure - fast_mean);
  slow_mean += duration / (slow + duration) * (pressure - slow_mean);
}

bool PressureTrend::is_steady() const noexcept
{
  return std::abs(fast_mean - slow_mean) <= std::max(share * std::abs(slow_mean), resolution);
}

}  // namespace drill_rig_sim
