// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/model/pointing.h"

#include <cmath>

#include "drill_rig_sim/math/rotation.h"
#include "drill_rig_sim/well/directions.h"

namespace drill_rig_sim
{
using Eigen::Quaterniond;
using Eigen::Vector3d;

namespace
{
/// A vector across `from` by the shortest rotation that takes `from` to `to`, both unit.
Vector3d carried(const Vector3d& from, const Vector3d& to, const Vector3d& across) noexcept
{
  return across - to.dot(across) / (1.0 + from.dot(to)) * (from + to);
}
}  // namespace

Vector3d steering(const Vector3d& axis, const Setpoints& setpoints, double full) noexcept
{
  if (setpoints.steering.ratio == 0.0) return Vector3d::Zero();
  const Vector3d from = setpoints.magnetic_steering ? north_side(axis) : high_side(axis);
  const double toolface = setpoints.steering.toolface;
  return setpoints.steering.ratio * full * (std::cos(toolface) * from + std::sin(toolface) * axis.cross(from));
}

Vector3d lean_after(const Model& model, const State& state, const Setpoints& setpoints, double time) noexcept
{
  const int node = model.mesh().pivot_node;
  if (node < 0) return Vector3d::Zero();
  const Vector3d axis = x_axis(state.nodes[static_cast<std::size_t>(node)].orientation);
  const Vector3d lean = state.lean - axis * axis.dot(state.lean);
  const double full = model.steerable()->tilt, most = full / tilting_time * time;
  const Vector3d left = steering(axis, setpoints, full) - lean;
  const double size = left.norm();
  return size <= most ? Vector3d(lean + left) : Vector3d(lean + (most / size) * left);
}

Quaterniond leaning(const Quaterniond& collar, const Vector3d& lean) noexcept
{
  return rotation_from_vector(x_axis(collar).cross(lean)) * collar;
}

ShaftEnd shaft_end(const Model& model, const Stage& stage, const Workspace& work) noexcept
{
  const std::size_t i = static_cast<std::size_t>(model.mesh().pivot_node);
  const NodeMotion& collar = work.nodes[i];
  ShaftEnd end;
  end.lean = carried(stage.normal[i], collar.normal, stage.lean);
  end.orientation = leaning(collar.orientation, end.lean);
  end.normal = x_axis(end.orientation);
  end.off = end.normal - collar.normal;
  end.spin = collar.rate.tail<3>().dot(collar.axis);
  return end;
}

}  // namespace drill_rig_sim
