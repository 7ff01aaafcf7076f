// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/well/hole_segment.h"

namespace drill_rig_sim
{
HoleSegment HoleSegment::between(const WellNode& from, const WellNode& to) noexcept
{
  const double h = to.md - from.md;
  const Eigen::Vector3d d = to.position - from.position;
  HoleSegment g;
  g.c0 = from.position;
  g.c1 = h * from.tangent;
  g.c2 = 3.0 * d - h * (2.0 * from.tangent + to.tangent);
  g.c3 = h * (from.tangent + to.tangent) - 2.0 * d;
  g.chord = d / d.squaredNorm();
  g.md = from.md;
  g.length = h;
  g.radius = from.radius;
  g.radius_change = to.radius - from.radius;
  g.friction = from.friction;
  g.friction_change = to.friction - from.friction;
  g.section = from.section;
  g.section_change = to.section - from.section;
  return g;
}

HoleSegment HoleSegment::line(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction, const WellNode& from) noexcept
{
  HoleSegment g;
  g.c0 = origin;
  g.c1 = direction;
  g.c2.setZero();
  g.c3.setZero();
  g.chord = direction;
  g.md = from.md;
  g.length = 1.0;
  g.radius = from.radius;
  g.radius_change = 0.0;
  g.friction = from.friction;
  g.friction_change = 0.0;
  g.section = from.section;
  g.section_change = 0.0;
  return g;
}

WellNode HoleSegment::at(double s) const noexcept
{
  WellNode node;
  node.md = md + s * length;
  node.position = centre(s);
  node.tangent = (c1 + s * (2.0 * c2 + 3.0 * s * c3)).normalized();
  node.radius = radius + s * radius_change;
  node.friction = friction + s * friction_change;
  node.section = section + s * section_change;
  return node;
}

Box Box::around(const HoleSegment& g) noexcept
{
  const Eigen::Vector3d p0 = g.c0;
  const Eigen::Vector3d p1 = p0 + g.c1 / 3.0;
  const Eigen::Vector3d p2 = p0 + (2.0 * g.c1 + g.c2) / 3.0;
  const Eigen::Vector3d p3 = p0 + g.c1 + g.c2 + g.c3;
  return {p0.cwiseMin(p1).cwiseMin(p2).cwiseMin(p3), p0.cwiseMax(p1).cwiseMax(p2).cwiseMax(p3)};
}

double Box::squared_distance(const Eigen::Vector3d& point) const noexcept
{
  return (low - point).cwiseMax(point - high).cwiseMax(0.0).squaredNorm();
}

}  // namespace drill_rig_sim
