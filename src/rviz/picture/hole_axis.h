// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_RVIZ_PICTURE_HOLE_AXIS_H
#define DRILL_RIG_SIM_SRC_RVIZ_PICTURE_HOLE_AXIS_H

#include <Eigen/Geometry>
#include <vector>

namespace drill_rig_sim
{
/// A place on the hole's axis with a frame across it.
struct AxisPoint
{
  double md = 0.0;  ///< along the axis from its first point [m]
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Vector3d tangent = -Eigen::Vector3d::UnitZ();  ///< unit, down the hole
  Eigen::Vector3d side = Eigen::Vector3d::UnitX();      ///< unit, across it, carried down the hole without twist
  Eigen::Vector3d other() const { return tangent.cross(side); }
};

/// The hole's axis as a smooth curve through points with tangents (cubic Hermite), with frames by parallel transport: none of
/// them turns about the axis against the one before, so that tubes about it do not wind (Bishop, There is more than one way to
/// frame a curve, 1975). Above its first and below its last point it goes on straight.
class HoleAxis
{
public:
  /// A vertical one, one point long.
  HoleAxis();
  /// `points`: top down, at least one; points less than 1 mm from the one before are left out. `tangents`: as many, of any length
  /// but 0.
  HoleAxis(const std::vector<Eigen::Vector3d>& points, const std::vector<Eigen::Vector3d>& tangents);

  /// Goes on straight to this measured depth [m]; false where it is that deep already.
  bool extend_to(double md);
  double depth() const noexcept { return points_.back().md; }
  const std::vector<AxisPoint>& points() const noexcept { return points_; }
  AxisPoint at(double md) const noexcept;
  /// The place nearest to `point`, looked for from measured depth `guess` on; right where the guess is off by less than the
  /// radius of curvature.
  AxisPoint nearest(const Eigen::Vector3d& point, double guess) const noexcept;

private:
  std::vector<AxisPoint> points_;
};

/// Where a point is drawn when all that lies across the axis is made `factor` times as large: `axis` is the place nearest to it.
inline Eigen::Vector3d exaggerated(const AxisPoint& axis, const Eigen::Vector3d& point, double factor)
{
  const Eigen::Vector3d off = point - axis.position;
  const Eigen::Vector3d along = off.dot(axis.tangent) * axis.tangent;
  return axis.position + along + factor * (off - along);
}

/// Up, at right angles to the hole: its high side. In a vertical hole north (the y axis).
Eigen::Vector3d high_side_of(const Eigen::Vector3d& tangent) noexcept;

}  // namespace drill_rig_sim

#endif
