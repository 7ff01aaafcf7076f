// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_WELL_HOLE_SEGMENT_H
#define DRILL_RIG_SIM_WELL_HOLE_SEGMENT_H

#include <Eigen/Core>

#include "drill_rig_sim/well/well_node.h"

namespace drill_rig_sim
{
/// The hole between two nodes, ready to be searched: a cubic Hermite in powers of s = (md - md_i)/h, h = md_{i+1} - md_i,
///   c(s) = c0 + c1 s + c2 s^2 + c3 s^3,  c0 = r_i, c1 = h t_i, c2 = 3 d - h (2 t_i + t_{i+1}), c3 = h (t_i + t_{i+1}) - 2 d,
/// d = r_{i+1} - r_i, which is r(s) = (1-3s^2+2s^3) r_i + h (s-2s^2+s^3) t_i + (3s^2-2s^3) r_{i+1} + h (s^3-s^2) t_{i+1}
/// sorted by powers. Radius, friction and section are linear in s. An axis-aligned straight or slanted line is c2 = c3 = 0.
struct HoleSegment
{
  Eigen::Vector3d c0, c1, c2, c3;  ///< [m]
  Eigen::Vector3d chord;           ///< d / |d|^2: (r_D - c0) . chord is a first guess of s [1/m]
  double md;                       ///< at s = 0 [m]
  double length;                   ///< h [m]
  double radius, radius_change;    ///< at s = 0, and from s = 0 to 1 [m]
  double friction, friction_change;
  double section, section_change;  ///< 2.25: a quarter of the way from hole section 2 to 3

  template <class V>
  void visit(V& v)
  {
    v("c0", c0);
    v("c1", c1);
    v("c2", c2);
    v("c3", c3);
    v("chord", chord);
    v("md", md);
    v("length", length);
    v("radius", radius);
    v("radius_change", radius_change);
    v("friction", friction);
    v("friction_change", friction_change);
    v("section", section);
    v("section_change", section_change);
  }

  /// Between two nodes, `to.md` > `from.md`.
  static HoleSegment between(const WellNode& from, const WellNode& to) noexcept;
  /// A straight line through `origin` along the unit vector `direction`, s in metres from there.
  /// There the hole is as at `from`, its place and tangent apart.
  static HoleSegment line(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction, const WellNode& from) noexcept;
  /// The hole at s, which may lie outside 0 .. 1.
  WellNode at(double s) const noexcept;
  Eigen::Vector3d centre(double s) const noexcept { return c0 + s * (c1 + s * (c2 + s * c3)); }
};

/// An axis-aligned box [m].
struct Box
{
  Eigen::Vector3d low, high;

  template <class V>
  void visit(V& v)
  {
    v("low", low);
    v("high", high);
  }

  /// Holds the segment's curve from s = 0 to 1: the box of its four Bezier points.
  static Box around(const HoleSegment& segment) noexcept;
  /// Squared distance from a point to the box, 0 inside.
  double squared_distance(const Eigen::Vector3d& point) const noexcept;
};

}  // namespace drill_rig_sim

#endif
