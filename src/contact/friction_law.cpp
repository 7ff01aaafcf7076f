// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/contact/friction_law.h"

#include "drill_rig_sim/contact/one_lane_friction.h"

namespace drill_rig_sim
{
FrictionCoefficient stribeck_friction(double kinetic, double static_ratio, double stribeck_speed, double speed,
                                      StribeckCurve curve) noexcept
{
  const one_lane::Stribeck mu =
      one_lane::stribeck(kinetic, static_ratio, stribeck_speed, speed, curve == StribeckCurve::exponential);
  return {mu.value, mu.slope};
}

}  // namespace drill_rig_sim
