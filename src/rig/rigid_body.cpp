#include "drill_rig_sim/rig/rigid_body.h"

#include "drill_rig_sim/math/rotation.h"

namespace drill_rig_sim
{
using Eigen::Matrix3d;
using Eigen::Vector3d;
using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

Vector6 inertia_force(const RigidBody& body, const BodyMotion& motion, const Vector6& acceleration) noexcept
{
  const Vector3d& n = motion.normal;
  const Vector3d& w = motion.angular_velocity;
  const Vector3d a = acceleration.head<3>(), alpha = acceleration.tail<3>();
  Vector6 out;
  out.head<3>() = (body.mass + body.added_mass) * a - (body.added_mass * n.dot(a)) * n;
  out.tail<3>() =
      body.tilt_inertia * alpha + (body.spin_inertia - body.tilt_inertia) * (alpha.dot(n) * n + w.dot(n) * w.cross(n));
  return out;
}

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

double kinetic_energy(const RigidBody& body, const BodyMotion& motion) noexcept
{
  const double along = motion.velocity.dot(motion.normal), spin = motion.angular_velocity.dot(motion.normal);
  const double velocity = motion.velocity.squaredNorm(), angular = motion.angular_velocity.squaredNorm();
  return 0.5 * (body.mass * velocity + body.added_mass * (velocity - along * along) +
                body.tilt_inertia * (angular - spin * spin) + body.spin_inertia * spin * spin);
}

}  // namespace drill_rig_sim
