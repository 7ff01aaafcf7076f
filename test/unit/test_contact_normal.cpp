// SPDX-License-Identifier: BSD-3-Clause
// The wall pushes across the hole by Hertz and by Hunt and Crossley: closed forms, impacts, zero clearance.
#include <gtest/gtest.h>

#include "contact_fixtures.h"

namespace drill_rig_sim::test_contact_normal
{
TEST(WallContact, ClearOfTheWallIsZero)
{
  StraightHole hole;
  ContactStage stage = touching_stage({0.01, 0.005, -3.0});
  const ContactMotion m = stage.motion(Vector6d::Zero());
  Matrix6d tangent = Matrix6d::Ones();
  const ClosestPoint closest = hole.locate(m.position);
  const WallForce f = wall_contact(closest, stage.radius, m, Vector3d(1e-3, 0, 0), stage.law, tangent);
  EXPECT_TRUE(wrench(f).isZero(0.0));
  EXPECT_TRUE(tangent.isZero(0.0));
  EXPECT_TRUE(f.bristle.isZero(0.0));
  EXPECT_EQ(f.normal_force, 0.0);
  EXPECT_NEAR(wall_gap(closest, m.position, stage.radius), 0.02 - std::hypot(0.01, 0.005), 1e-12);
  EXPECT_EQ(f.penetration, -wall_gap(closest, m.position, stage.radius));
}

TEST(WallContact, RestingOnTheWallFollowsHertz)
{
  StraightHole hole;
  ContactStage stage;
  stage.start << 0.0213, 0.0, -3.0;  // delta = 1.3 mm towards +x
  const ContactMotion m = stage.motion(Vector6d::Zero());
  const WallForce f = wall_contact(hole.locate(m.position), stage.radius, m, Vector3d::Zero(), stage.law);
  const double expected = 5e7 * std::pow(0.0013, 1.5);
  EXPECT_NEAR(f.force.x(), -expected, 1e-8 * expected);
  EXPECT_EQ(f.force.y(), 0.0);
  EXPECT_EQ(f.force.z(), 0.0);
  EXPECT_FALSE(f.slipping);
}

TEST(WallContact, DampingNeverPulls)
{
  StraightHole hole;
  ContactStage stage;
  stage.start << 0.0213, 0.0, -3.0;
  stage.velocity_0 << 2.0, 0.0, 0.0;
  const auto normal = [&]
  {
    const ContactMotion m = stage.motion(Vector6d::Zero());
    return wall_contact(hole.locate(m.position), stage.radius, m, Vector3d::Zero(), stage.law).normal_force;
  };
  const double elastic = 5e7 * std::pow(0.0013, 1.5);
  EXPECT_NEAR(normal(), elastic * (1.0 + 0.3 * 2.0), 1e-8 * elastic);
  stage.velocity_0 << -100.0, 0.0, 0.0;
  EXPECT_EQ(normal(), 0.0);
}

TEST(WallContact, ZeroClearanceIsSmoothThroughTheCentre)
{
  StraightHole hole;
  hole.friction = 0.3;
  ContactStage stage;
  stage.radius = hole.radius;
  stage.start << 0.0, 0.0, -1.0;
  Matrix6d tangent;
  for (double x : {0.0, 1e-12, 1e-9, 1e-7, 1e-6, 1e-4})
  {
    stage.start.x() = x;
    const ContactMotion m = stage.motion(Vector6d::Zero());
    const WallForce f = wall_contact(hole.locate(m.position), stage.radius, m, Vector3d(0, 0, 1e-4), stage.law, tangent);
    ASSERT_TRUE(tangent.allFinite());
    ASSERT_TRUE(wrench(f).allFinite());
    // |F_n n| = k rho^(e-1) x
    const double rho = std::hypot(x, 1e-7);
    EXPECT_NEAR(f.force.x(), -5e7 * std::sqrt(rho) * x, 1e-9 * 5e7 * std::sqrt(rho) * x);
    EXPECT_LT(tangent.norm(), 1e6 + 3.0 * 5e7 * std::sqrt(rho));
  }
}

TEST(WallContact, ElasticImpactRestoresTheSpeed)
{
  // c_d = 0: a mass thrown at the wall comes back as fast; explicit, fine steps
  StraightHole hole;
  hole.friction = 0.0;
  WallLaw law = usual_law();
  law.law.damping = 0.0;
  const double mass = 100.0;
  const double h = 1e-6;
  ContactMotion m;
  m.position << 0.0199, 0.0, 0.0;
  m.velocity << 0.5, 0.0, 0.0;
  for (int i = 0; i < 100000 && (m.velocity.x() > 0.0 || m.position.x() > 0.0199); ++i)
  {
    m.position += 0.5 * h * m.velocity;
    m.velocity += h / mass * wall_contact(hole.locate(m.position), 0.08, m, Vector3d::Zero(), law).force;
    m.position += 0.5 * h * m.velocity;
  }
  EXPECT_NEAR(m.velocity.x(), -0.5, 1e-6);
}

TEST(WallContact, DampedImpactFollowsHuntAndCrossley)
{
  // restitution 1 - 2/3 c_d v for small c_d v
  StraightHole hole;
  hole.friction = 0.0;
  WallLaw law = usual_law();
  const double mass = 100.0;
  const double h = 1e-6;
  const double speed = 0.05;
  ContactMotion m;
  m.position << 0.01999, 0.0, 0.0;
  m.velocity << speed, 0.0, 0.0;
  for (int i = 0; i < 200000 && (m.velocity.x() > 0.0 || m.position.x() > 0.01999); ++i)
  {
    m.position += 0.5 * h * m.velocity;
    m.velocity += h / mass * wall_contact(hole.locate(m.position), 0.08, m, Vector3d::Zero(), law).force;
    m.position += 0.5 * h * m.velocity;
  }
  // next term of the series is (c_d v)^2 = 2e-4
  EXPECT_NEAR(-m.velocity.x() / speed, 1.0 - 2.0 / 3.0 * law.law.damping * speed, 3e-4);
}

}  // namespace drill_rig_sim::test_contact_normal
