// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/rig/heave.h"

#include <algorithm>
#include <cmath>

#include "drill_rig_sim/math/units.h"

namespace drill_rig_sim
{
FloorMotion floor_motion(const HeaveSpec& spec, double time) noexcept
{
  if (spec.amplitude == 0.0) return {};
  const double rate = 2.0 * pi / spec.period, wave = std::sin(rate * time);
  const double rises = rising_periods * spec.period, share = std::min(time / rises, 1.0);
  const double risen = share * share * (3.0 - 2.0 * share), rising = 6.0 * share * (1.0 - share) / rises;
  return {spec.amplitude * risen * wave, spec.amplitude * (risen * rate * std::cos(rate * time) + rising * wave)};
}

double heave_acceleration(const HeaveSpec& spec) noexcept
{
  const double rate = 2.0 * pi / spec.period;
  return spec.amplitude * rate * rate;
}

}  // namespace drill_rig_sim
