// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/model/mast.h"

#include <algorithm>
#include <cmath>

namespace drill_rig_sim
{
void open_mast(ClosestPoint& closest) noexcept
{
  if (closest.segment != 0 || closest.md >= 0.0) return;
  const double opened = closest.radius - mast_opening * closest.md;
  const double inside = std::max(closest.radius, mast_radius);
  closest.radius_slope = opened < inside ? -mast_opening : 0.0;
  closest.radius = std::min(opened, inside);
}

bool clear_in_mast(const Wellbore& well, const Eigen::Vector3d& point, double radius) noexcept
{
  constexpr double rounding = 1e-6;  // and the wall's smoothing [m]
  return point.z() > rounding && std::hypot(point.x(), point.y()) + radius + rounding < well.node(0).radius;
}

}  // namespace drill_rig_sim
