// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_MODEL_FORCES_WALL_PARTS_H
#define DRILL_RIG_SIM_MODEL_FORCES_WALL_PARTS_H

#include "drill_rig_sim/contact/normal_law.h"
#include "drill_rig_sim/contact/wall_contact.h"

namespace drill_rig_sim
{
/// A wall's force as the energy balance wants it, in the residual's sign (it resists the motion).
struct WallParts
{
  Eigen::Vector3d elastic;          ///< gradient of the wall's energy [N]
  Eigen::Vector3d ledge;            ///< what the force lacks of that, along a ledge [N]
  Eigen::Vector3d damping;          ///< the rest of the normal force [N]
  Eigen::Vector3d friction;         ///< [N]
  Eigen::Vector3d friction_moment;  ///< [N m]
};

inline WallParts parts_of(const WallForce& f, const ClosestPoint& closest, const ContactLaw& law) noexcept
{
  const double elastic = elastic_force(law, f.penetration);
  WallParts parts;
  parts.ledge = (elastic * closest.radius_slope) * closest.md_gradient;
  parts.elastic = elastic * f.normal - parts.ledge;
  parts.damping = (f.normal_force - elastic) * f.normal;
  parts.friction = -(f.force + f.normal_force * f.normal);
  parts.friction_moment = -f.moment;
  return parts;
}

/// How long a contact's friction has stuck after `time` at this force, `before` at its start [s].
inline double rest_after(const WallForce& f, double before, double time) noexcept
{
  return f.normal_force > 0.0 && !f.slipping ? before + time : 0.0;
}

}  // namespace drill_rig_sim

#endif
