// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/rig/damped_bristle.h"

#include "drill_rig_sim/contact/one_lane_friction.h"

namespace drill_rig_sim
{
double DampedBristle::next(double move, double force, bool slips, double time) const noexcept
{
  if (!slips) return deflection + move;
  return deflection + one_lane::follows_by(time, stiffness, damping) * (-force / stiffness - deflection);
}
}  // namespace drill_rig_sim
