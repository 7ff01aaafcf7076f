// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/crew/pressure_trend.h"

#include <algorithm>
#include <cmath>

namespace drill_rig_sim
{
void PressureTrend::take(double pressure, double time) noexcept
{
  if (!begun) *this = {{pressure, pressure}, time, true};
  lags.take(pressure, time - at, trend_time);
  at = time;
}

bool PressureTrend::is_steady() const noexcept
{
  return lags.apart() <= std::max(share * std::abs(lags.slow), resolution);
}

}  // namespace drill_rig_sim
