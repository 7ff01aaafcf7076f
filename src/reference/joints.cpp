// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/reference/joints.h"

#include "drill_rig_sim/math/rotation.h"

namespace drill_rig_sim
{
using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

namespace
{
Constraint point(const Vector3d& direction, const BodyMotion& a, const BodyMotion& b, const Vector3d& place)
{
  return {Constraint::Kind::point, direction, a.orientation.conjugate() * (place - a.position),
          b.orientation.conjugate() * (place - b.position)};
}

Constraint angle(const BodyMotion& a, const BodyMotion& b, const Vector3d& u, const Vector3d& w)
{
  return {Constraint::Kind::angle, Vector3d::Zero(), a.orientation.conjugate() * u, b.orientation.conjugate() * w};
}

void hold_place(Joint& joint, const BodyMotion& a, const BodyMotion& b, const Vector3d& place, int axes)
{
  for (int k = 0; k < axes; ++k) joint.constraints.push_back(point(Vector3d::Unit(k), a, b, place));
}

/// Three right angles between axes of a and of b, both along `axes` now.
void hold_orientation(Joint& joint, const BodyMotion& a, const BodyMotion& b, const Quaterniond& axes)
{
  for (int k = 0; k < 3; ++k)
    joint.constraints.push_back(angle(a, b, axes * Vector3d::Unit((k + 1) % 3), axes * Vector3d::Unit((k + 2) % 3)));
}
}  // namespace

double constraint_value(const Constraint& c, const BodyMotion& a, const BodyMotion& b) noexcept
{
  const Vector3d on_a = a.orientation * c.on_a, on_b = b.orientation * c.on_b;
  if (c.kind == Constraint::Kind::angle) return on_a.dot(on_b);
  // positions first: they are large and nearly equal
  return c.direction.dot((b.position - a.position) + (on_b - on_a));
}

JointRow constraint_row(const Constraint& c, const BodyMotion& a, const BodyMotion& b) noexcept
{
  const Vector3d on_a = a.orientation * c.on_a, on_b = b.orientation * c.on_b;
  JointRow row = JointRow::Zero();
  if (c.kind == Constraint::Kind::angle)
  {
    const Vector3d axis = on_a.cross(on_b);
    row.segment<3>(3) = axis.transpose();
    row.segment<3>(9) = -axis.transpose();
    return row;
  }
  row.segment<3>(0) = -c.direction.transpose();
  row.segment<3>(3) = -on_a.cross(c.direction).transpose();
  row.segment<3>(6) = c.direction.transpose();
  row.segment<3>(9) = on_b.cross(c.direction).transpose();
  return row;
}

JointHessian constraint_hessian(const Constraint& c, const BodyMotion& a, const BodyMotion& b) noexcept
{
  const Vector3d on_a = a.orientation * c.on_a, on_b = b.orientation * c.on_b;
  JointHessian h = JointHessian::Zero();
  if (c.kind == Constraint::Kind::angle)
  {
    // d(u x w) = (theta_a x u) x w + u x (theta_b x w)
    const double uw = on_a.dot(on_b);
    const Matrix3d by_a = on_a * on_b.transpose() - uw * Matrix3d::Identity();
    const Matrix3d by_b = uw * Matrix3d::Identity() - on_b * on_a.transpose();
    h.block<3, 3>(3, 3) = by_a;
    h.block<3, 3>(3, 9) = by_b;
    h.block<3, 3>(9, 3) = -by_a;
    h.block<3, 3>(9, 9) = -by_b;
    return h;
  }
  // d(p x e) = (theta x p) x e = skew(e) skew(p) theta
  const Matrix3d along = skew(c.direction);
  h.block<3, 3>(3, 3) = -along * skew(on_a);
  h.block<3, 3>(9, 9) = along * skew(on_b);
  return h;
}

Joint fixed_joint(int a, const BodyMotion& pose_a, int b, const BodyMotion& pose_b)
{
  Joint joint{a, b, {}};
  hold_place(joint, pose_a, pose_b, pose_b.position, 3);
  hold_orientation(joint, pose_a, pose_b, pose_b.orientation);
  return joint;
}

Joint guide_rail(int a, const BodyMotion& pose_a, int b, const BodyMotion& pose_b)
{
  Joint joint{a, b, {}};
  hold_place(joint, pose_a, pose_b, pose_b.position, 2);
  hold_orientation(joint, pose_a, pose_b, Quaterniond::Identity());
  return joint;
}

Joint revolute_joint(int a, const BodyMotion& pose_a, int b, const BodyMotion& pose_b)
{
  Joint joint{a, b, {}};
  hold_place(joint, pose_a, pose_b, pose_b.position, 3);
  const Vector3d axis = pose_b.orientation * Vector3d::UnitX();
  for (int k = 1; k < 3; ++k) joint.constraints.push_back(angle(pose_a, pose_b, pose_b.orientation * Vector3d::Unit(k), axis));
  return joint;
}

Joint ball_joint(int a, const BodyMotion& pose_a, int b, const BodyMotion& pose_b, const Vector3d& place)
{
  Joint joint{a, b, {}};
  hold_place(joint, pose_a, pose_b, place, 3);
  return joint;
}

}  // namespace drill_rig_sim
