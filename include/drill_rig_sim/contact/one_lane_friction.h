// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_CONTACT_ONE_LANE_FRICTION_H
#define DRILL_RIG_SIM_CONTACT_ONE_LANE_FRICTION_H

#include "drill_rig_sim/contact/contact_spec.h"
#include "drill_rig_sim/math/one_lane.h"

/// The text of friction for V = double. Only sources include it: a change of the text then compiles few files.
namespace drill_rig_sim::one_lane
{
#include "drill_rig_sim/contact/friction_text.h"
}  // namespace drill_rig_sim::one_lane

namespace drill_rig_sim
{
/// Friction and bristle of a law with this kinetic coefficient, for the laws' texts.
inline one_lane::Rubbing rubbing_of(const WallLaw& law, double kinetic) noexcept
{
  return {kinetic,
          law.static_ratio,
          law.stribeck_speed,
          law.tangential_stiffness,
          law.tangential_damping,
          law.stribeck_curve == StribeckCurve::exponential};
}

}  // namespace drill_rig_sim

#endif
