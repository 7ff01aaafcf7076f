// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/rig/rigid_body.h"

#include "drill_rig_sim/math/rotation.h"

namespace drill_rig_sim
{
using Eigen::Matrix3d;
using Eigen::Vector3d;
using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

Matrix6 inertia_by_acceleration(const RigidBody& body, const BodyMotion& motion) noexcept
{
  const Matrix3d nn = motion.normal * motion.normal.transpose();
  Matrix6 out = Matrix6::Zero();
  out.topLeftCorner<3, 3>() = (body.mass + body.added_mass) * Matrix3d::Identity() - body.added_mass * nn;
  out.bottomRightCorner<3, 3>() = body.tilt_inertia * Matrix3d::Identity() + (body.spin_inertia - body.tilt_inertia) * nn;
  return out;
}

Matrix3d inertia_by_angular_velocity(const RigidBody& body, const BodyMotion& motion) noexcept
{
  const Vector3d& n = motion.normal;
  const Vector3d& w = motion.angular_velocity;
  return (body.spin_inertia - body.tilt_inertia) * (w.cross(n) * n.transpose() - w.dot(n) * skew(n));
}

Eigen::Matrix<double, 6, 3> inertia_by_rotation(const RigidBody& body, const BodyMotion& motion,
                                                const Vector6& acceleration) noexcept
{
  // dn = theta x n
  const Vector3d& n = motion.normal;
  const Vector3d& w = motion.angular_velocity;
  const Vector3d a = acceleration.head<3>(), alpha = acceleration.tail<3>();
  const Matrix3d cross_n = skew(n);
  Eigen::Matrix<double, 6, 3> out;
  out.topRows<3>() = body.added_mass * (n.dot(a) * cross_n - n * n.cross(a).transpose());
  out.bottomRows<3>() =
      (body.spin_inertia - body.tilt_inertia) * (n * n.cross(alpha).transpose() - alpha.dot(n) * cross_n +
                                                 w.cross(n) * n.cross(w).transpose() - w.dot(n) * skew(w) * cross_n);
  return out;
}

}  // namespace drill_rig_sim
