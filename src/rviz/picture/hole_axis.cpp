// SPDX-License-Identifier: BSD-3-Clause
#include "hole_axis.h"

#include <algorithm>
#include <cmath>

#include "drill_rig_sim/math/rotation.h"

namespace drill_rig_sim
{
using Eigen::Vector3d;

namespace
{
constexpr double least_distance = 1e-3;  // [m]

/// What of `side` lies across `tangent`, as a unit vector.
Vector3d across(const Vector3d& side, const Vector3d& tangent)
{
  Vector3d v = side - side.dot(tangent) * tangent;
  if (v.norm() < 1e-6) v = tangent.unitOrthogonal();
  return v.normalized();
}

Vector3d unit(const Vector3d& v)
{
  const double length = v.norm();
  return length > 0.0 ? Vector3d(v / length) : Vector3d(-Vector3d::UnitZ());
}

/// Length of the cubic that has unit tangents at its ends: by Simpson's rule on a chord of length h it is h (1 + b^2/24), b the
/// angle between the tangents; to fourth order in b.
double arc_length(const Vector3d& chord, const Vector3d& from, const Vector3d& to)
{
  const double angle = std::atan2(from.cross(to).norm(), from.dot(to));
  return chord.norm() * (1.0 + angle * angle / 24.0);
}
}  // namespace

HoleAxis::HoleAxis() : points_(1)
{
}

HoleAxis::HoleAxis(const std::vector<Vector3d>& points, const std::vector<Vector3d>& tangents)
{
  for (std::size_t i = 0; i < std::min(points.size(), tangents.size()); ++i)
  {
    AxisPoint p;
    p.position = points[i];
    p.tangent = unit(tangents[i]);
    if (points_.empty())
    {
      p.side = across(Vector3d::UnitX(), p.tangent);
    }
    else
    {
      const AxisPoint& last = points_.back();
      const Vector3d chord = p.position - last.position;
      if (chord.norm() < least_distance) continue;
      p.md = last.md + arc_length(chord, last.tangent, p.tangent);
      p.side = across(shortest_turn(last.tangent, p.tangent) * last.side, p.tangent);
    }
    points_.push_back(p);
  }
  if (points_.empty()) points_.resize(1);
}

bool HoleAxis::extend_to(double md)
{
  if (!(md > depth())) return false;
  points_.push_back(at(md));
  return true;
}

AxisPoint HoleAxis::at(double md) const noexcept
{
  const AxisPoint &first = points_.front(), &last = points_.back();
  if (!(md > first.md) || md >= last.md)
  {
    AxisPoint p = md > first.md ? last : first;
    p.position += (md - p.md) * p.tangent;
    p.md = md;
    return p;
  }
  const auto above = std::upper_bound(points_.begin(), points_.end(), md, [](double s, const AxisPoint& p) { return s < p.md; });
  const AxisPoint &b = *above, &a = *(above - 1);
  const double h = b.md - a.md, u = (md - a.md) / h, w = 1.0 - u;
  AxisPoint p;
  p.md = md;
  p.position = (1.0 + 2.0 * u) * w * w * a.position + u * w * w * h * a.tangent + u * u * (3.0 - 2.0 * u) * b.position -
               u * u * w * h * b.tangent;
  p.tangent =
      unit(6.0 * u * w * (b.position - a.position) / h + w * (1.0 - 3.0 * u) * a.tangent + u * (3.0 * u - 2.0) * b.tangent);
  p.side = across(w * a.side + u * b.side, p.tangent);
  return p;
}

AxisPoint HoleAxis::nearest(const Vector3d& point, double guess) const noexcept
{
  AxisPoint p = at(guess);
  for (int i = 0; i < 20; ++i)
  {
    const double step = (point - p.position).dot(p.tangent);
    p = at(p.md + step);
    if (std::abs(step) < 1e-9) break;
  }
  return p;
}

Vector3d high_side_of(const Vector3d& tangent) noexcept
{
  const Vector3d up = Vector3d::UnitZ() - tangent.z() * tangent;
  return up.norm() > 1e-3 ? Vector3d(up.normalized()) : across(Vector3d::UnitY(), tangent);
}

}  // namespace drill_rig_sim
