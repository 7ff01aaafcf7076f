// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/crew/steady_load.h"

#include <algorithm>
#include <cmath>

namespace drill_rig_sim
{
void SteadyLoad::begin(double load, double block_height) noexcept
{
  lowers_from_ = block_height;
  has_turned_ = false;
  restart(load);
}

void SteadyLoad::restart(double load) noexcept
{
  fast_load_ = slow_load_ = load;
  steady_for_ = 0.0;
}

void SteadyLoad::take(double load, double block_height, double duration, double within) noexcept
{
  lowers_from_ = std::max(lowers_from_, block_height);
  if (!has_turned_) restart(load);
  has_turned_ = lowers_from_ - block_height >= turns_round;
  fast_load_ += duration / (trend_time + duration) * (load - fast_load_);
  slow_load_ += duration / (2.0 * trend_time + duration) * (load - slow_load_);
  const bool agree = has_turned_ && std::abs(fast_load_ - slow_load_) <= within;
  steady_for_ = agree ? steady_for_ + duration : 0.0;
}

}  // namespace drill_rig_sim
