// SPDX-License-Identifier: BSD-3-Clause
// Friction of pipe that is known to lie on its wall: the same as the whole contact's, and exact slopes.
#include <gtest/gtest.h>

#include <cmath>

#include "contact_fixtures.h"
#include "drill_rig_sim/contact/surface_friction.h"

namespace test_contact_surface_friction
{
using namespace drill_rig_sim;
using Eigen::Matrix2d;
using Eigen::Vector2d;

namespace
{
constexpr double kKinetic = 0.3, kNormal = 2000.0, kLever = 0.08, kCoefficient = 150.0, kTime = 0.01;

WallLaw law_with(StribeckCurve curve)
{
  ContactSpec spec;
  spec.static_ratio = 1.4;
  spec.stribeck_speed = 0.1;
  spec.stribeck_curve = curve;
  return wall_law(spec, spec.law, 300.0, 0.0);
}

/// Slips at 0.05 m/s down and 0.1 m/s around in steps of 0.01 s, or creeps a thousandth of that.
SurfaceMotion motion_at(const Vector2d& velocity)
{
  return {kTime * velocity, velocity, kCoefficient, kTime};
}
}  // namespace

TEST(SurfaceFriction, isThatOfTheWholeContact)
{
  const StraightHole hole;
  const Vector3d normal = Vector3d::UnitX(), around = hole.tangent.cross(normal);
  for (const StribeckCurve curve : {StribeckCurve::gaussian, StribeckCurve::exponential})
    for (const Vector2d& velocity : {Vector2d(0.05, 0.1), Vector2d(-0.3, 0.02), Vector2d(1e-5, -1e-5), Vector2d(0.0, 0.0)})
    {
      const WallLaw law = law_with(curve);
      const Vector2d bristle(2e-5, -3e-5);
      const double penetration = std::pow(kNormal / law.law.stiffness, 1.0 / law.law.exponent);
      ContactMotion motion;
      motion.position = (hole.radius - kLever + penetration) * normal;
      motion.velocity = velocity.x() * hole.tangent;
      motion.angular_velocity = velocity.y() / kLever * hole.tangent;
      motion.displacement = kTime * motion.velocity;
      motion.rotation = kTime * motion.angular_velocity;
      motion.velocity_coefficient = kCoefficient;
      motion.time = kTime;
      const WallForce whole =
          wall_contact(hole.locate(motion.position), kLever, motion, bristle.x() * hole.tangent + bristle.y() * around, law);
      const SurfaceFriction f = surface_friction(whole.normal_force, kKinetic, motion_at(velocity), bristle, law, nullptr);
      EXPECT_EQ(f.slipping, whole.slipping);
      EXPECT_NEAR(f.force.x(), whole.force.dot(hole.tangent), 1e-6) << velocity.transpose();
      EXPECT_NEAR(f.force.y(), whole.force.dot(around), 1e-6) << velocity.transpose();
      EXPECT_NEAR(f.bristle.x(), whole.bristle.dot(hole.tangent), 1e-12) << velocity.transpose();
      EXPECT_NEAR(f.bristle.y(), whole.bristle.dot(around), 1e-12) << velocity.transpose();
    }
}

TEST(SurfaceFriction, slopesAreItsDerivatives)
{
  constexpr double h = 1e-8;  // [m]; bristles are some 1e-4
  for (const StribeckCurve curve : {StribeckCurve::gaussian, StribeckCurve::exponential})
    for (const Vector2d& velocity : {Vector2d(0.05, 0.1), Vector2d(-0.3, 0.02), Vector2d(1e-5, -1e-5)})
    {
      const WallLaw law = law_with(curve);
      const Vector2d bristle(2e-5, -3e-5);
      const auto force = [&](const Vector2d& more, double normal)
      {
        SurfaceMotion motion = motion_at(velocity);
        motion.displacement += more;
        motion.velocity += kCoefficient * more;
        return surface_friction(normal, kKinetic, motion, bristle, law, nullptr).force;
      };
      SurfaceSlopes slopes;
      surface_friction(kNormal, kKinetic, motion_at(velocity), bristle, law, &slopes);
      Matrix2d by_displacement;
      for (int k = 0; k < 2; ++k)
        by_displacement.col(k) = (force(h * Vector2d::Unit(k), kNormal) - force(-h * Vector2d::Unit(k), kNormal)) / (2.0 * h);
      EXPECT_LT((slopes.by_displacement - by_displacement).norm(), 1e-5 * by_displacement.norm()) << velocity.transpose();
      const Vector2d by_normal = (force(Vector2d::Zero(), kNormal + 1.0) - force(Vector2d::Zero(), kNormal - 1.0)) / 2.0;
      EXPECT_LT((slopes.by_normal_force - by_normal).norm(), 1e-8) << velocity.transpose();
    }
}
}  // namespace test_contact_surface_friction
