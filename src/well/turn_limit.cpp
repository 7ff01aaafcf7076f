// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/well/turn_limit.h"

#include <algorithm>
#include <cmath>

namespace drill_rig_sim
{
using Eigen::Vector3d;

namespace
{
constexpr double widest = 1.0;  // a body that lets the hole turn by more is too short to hold anything [rad]

/// The hole's direction a body's length above the bottom.
Vector3d direction_above(const Wellbore& well, double length) noexcept
{
  return well.at(well.hole_depth() - length).tangent;
}

/// Half angle of the cone about `from` that the hole's end may not leave. `before`: the hole's direction where its newly drilled
/// interval begins.
double opening(const TurnLimit& limit, const Vector3d& from, const Vector3d& before) noexcept
{
  constexpr double play = 1.1;  // a step's overshoot is no sharper survey
  const double turned = std::acos(std::clamp(from.dot(before), -1.0, 1.0));
  return turned > play * limit.angle() ? std::min(turned, widest) : limit.angle();
}

/// The part of `way` that leads further out of such a cone, once the hole's end `now` has left it: the newly drilled interval's
/// direction is a mean with `before` and stays where the bottom goes on along that.
Vector3d outward_part(const Vector3d& from, double half_angle, const Vector3d& before, const Vector3d& now,
                      const Vector3d& way) noexcept
{
  const double slope = std::tan(half_angle), ahead = from.dot(now);
  const Vector3d aside = now - ahead * from;
  const double offset = aside.norm();
  if (offset <= slope * ahead) return Vector3d::Zero();
  const Vector3d outward = aside / offset;
  const double stays = std::min(slope, outward.dot(before) / std::max(from.dot(before), std::cos(widest)));
  return std::max(0.0, outward.dot(way) - stays * std::max(0.0, from.dot(way))) * outward;
}
}  // namespace

Vector3d limited_way(const Wellbore& well, const TurnLimit& limit, const Vector3d& way) noexcept
{
  if (limit.angle() >= widest) return way;
  const Vector3d& now = well.end_direction();
  const Vector3d above = direction_above(well, limit.length), before = well.node(well.node_count() - 1).tangent;
  Vector3d allowed = way;
  for (const Vector3d& from : {above, before}) allowed -= outward_part(from, opening(limit, from, before), before, now, allowed);
  return allowed;
}

double refused_turn(const Wellbore& well, const TurnLimit& limit, const Vector3d& way) noexcept
{
  if (limited_way(well, limit, way) == way) return 0.0;
  return std::acos(std::clamp(direction_above(well, limit.length).dot(way.normalized()), -1.0, 1.0)) / limit.length;
}

}  // namespace drill_rig_sim
