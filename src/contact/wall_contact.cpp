// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/contact/wall_contact.h"

#include <Eigen/Geometry>

#include "drill_rig_sim/contact/one_lane_friction.h"

namespace drill_rig_sim::one_lane
{
#include "drill_rig_sim/contact/wall_text.h"
}  // namespace drill_rig_sim::one_lane

namespace drill_rig_sim
{
namespace
{
using Eigen::Vector3d;
using one_lane::from;
using one_lane::to_eigen;
using one_lane::V3;
using Tangent = Eigen::Ref<Eigen::Matrix<double, 6, 6>>;

/// The section at rest in the hole.
one_lane::Contact contact_of(const ClosestPoint& closest, double radius, const Vector3d& position, const WallLaw& law) noexcept
{
  one_lane::Contact c{};
  c.centre = from(closest.centre);
  c.slope = from(closest.centre_slope);
  c.gradient = from(closest.md_gradient);
  c.hole_radius = closest.radius;
  c.radius_slope = closest.radius_slope;
  c.radius = radius;
  c.position = from(position);
  c.stiffness = law.law.stiffness;
  c.exponent = law.law.exponent;
  c.damping = law.law.damping;
  c.lever = law.friction_radius > 0.0 ? law.friction_radius : radius;
  c.rubbing = rubbing_of(law, closest.friction);
  return c;
}

void fill_result(const one_lane::Wall& w, const V3& friction, double lever, WallForce& out) noexcept
{
  out.normal_force = w.normal.value;
  out.normal = to_eigen(w.n);
  out.force = to_eigen(friction - w.normal.value * w.n);
  out.moment = to_eigen(lever * cross(w.n, friction));
}

WallForce evaluate(const ClosestPoint& closest, double radius, const ContactMotion& motion, const Vector3d& bristle,
                   const WallLaw& law, Tangent* tangent) noexcept
{
  one_lane::Contact c = contact_of(closest, radius, motion.position, law);
  c.displacement = from(motion.displacement);
  c.rotation = from(motion.rotation);
  c.velocity = from(motion.velocity);
  c.turning = from(motion.angular_velocity);
  c.bristle = from(bristle);
  one_lane::Wall w;
  press(c, w);
  WallForce out;
  out.penetration = w.penetration;
  if (tangent) tangent->setZero();
  if (!w.touches) return out;
  rub(c, motion.time, w);
  fill_result(w, w.friction.force, c.lever, out);
  out.bristle = to_eigen(w.friction.bristle);
  out.slipping = w.friction.slipping;
  out.friction_power = dot(w.friction.force, w.surface_velocity);
  if (!tangent) return out;
  double rows[36];
  find_wall_tangent(c, w, motion.velocity_coefficient, rows);
  *tangent = Eigen::Map<const Eigen::Matrix<double, 6, 6, Eigen::RowMajor>>(rows);
  return out;
}
}  // namespace

WallForce wall_contact(const ClosestPoint& closest, double radius, const ContactMotion& motion, const Eigen::Vector3d& bristle,
                       const WallLaw& law) noexcept
{
  return evaluate(closest, radius, motion, bristle, law, nullptr);
}

WallForce wall_contact(const ClosestPoint& closest, double radius, const ContactMotion& motion, const Eigen::Vector3d& bristle,
                       const WallLaw& law, Eigen::Ref<Eigen::Matrix<double, 6, 6>> tangent) noexcept
{
  return evaluate(closest, radius, motion, bristle, law, &tangent);
}

WallForce sliding_wall_contact(const ClosestPoint& closest, double radius, const Eigen::Vector3d& position,
                               const SlidingMotion& sliding, const WallLaw& law,
                               Eigen::Ref<Eigen::Matrix<double, 6, 6>> tangent) noexcept
{
  const one_lane::Contact c = contact_of(closest, radius, position, law);
  one_lane::Wall w;
  press(c, w);
  WallForce out;
  out.penetration = w.penetration;
  tangent.setZero();
  if (!w.touches) return out;
  const double rim_speed = sliding.spin_speed * c.lever, speed = std::hypot(sliding.axial_speed, rim_speed);
  const double axial = speed > 0.0 ? sliding.axial_speed / speed : 0.0, around = speed > 0.0 ? rim_speed / speed : 0.0;
  const V3 along = from(closest.tangent), direction = axial * along + around * cross(along, w.n);
  const double coefficient = sliding.share * closest.friction, limit = coefficient * w.normal.value;
  const V3 friction = -limit * direction;
  fill_result(w, friction, c.lever, out);
  out.slipping = speed > 0.0;
  out.friction_power = -limit * speed;

  V3 b[3];
  find_normal_derivative(w, c.gradient, b);
  const Vector3d gradient = w.normal.stiffness * to_eigen(w.gradient);
  for (int j = 0; j < 3; ++j)
  {
    const V3 by_place = -coefficient * gradient[j] * direction - limit * around * cross(along, b[j]);
    tangent.block<3, 1>(0, j) = to_eigen(by_place - gradient[j] * w.n - w.normal.value * b[j]);
    tangent.block<3, 1>(3, j) = to_eigen(c.lever * (cross(w.n, by_place) + cross(b[j], friction)));
  }
  return out;
}

}  // namespace drill_rig_sim
