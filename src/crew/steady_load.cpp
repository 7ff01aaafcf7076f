// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/crew/steady_load.h"

#include <algorithm>

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
  lags_ = {load, load};
  steady_for_ = 0.0;
}

void SteadyLoad::take(double load, double block_height, double duration, double within) noexcept
{
  lowers_from_ = std::max(lowers_from_, block_height);
  if (!has_turned_) restart(load);
  has_turned_ = lowers_from_ - block_height >= turns_round;
  lags_.take(load, duration, trend_time);
  const bool agree = has_turned_ && lags_.apart() <= within;
  steady_for_ = agree ? steady_for_ + duration : 0.0;
}

}  // namespace drill_rig_sim
