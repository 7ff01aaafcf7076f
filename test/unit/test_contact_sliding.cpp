// SPDX-License-Identifier: BSD-3-Clause
// Sliding on the wall: Coulomb's law in motion, competition of axial and circumferential friction, prescribed sliding.
#include <gtest/gtest.h>

#include "contact_fixtures.h"

namespace drill_rig_sim::test_contact_sliding
{
TEST(WallContact, RotationFreesTheAxialSlide)
{
  // steady slip: axial share of friction = v_a / |v|
  StraightHole hole;
  ContactStage stage;
  stage.start << 0.0214, 0.0, -3.0;
  stage.law.static_ratio = 1.0;
  const double axial = 0.02;
  const double spin = 53.0 * rpm;
  const double h = 0.005;
  stage.coefficient = 1.0 / h;
  Vector3d bristle = Vector3d::Zero();
  WallForce f;
  for (int i = 0; i < 200; ++i)
  {
    // runs down and turns clockwise looking down: right-hand about the tangent, -z
    Vector6d u;
    u << 0, 0, -axial * h, 0, 0, -spin * h;
    stage.start.z() = -3.0;
    ContactMotion m = stage.motion(u);
    f = wall_contact(hole.locate(m.position), stage.radius, m, bristle, stage.law);
    bristle = f.bristle;
  }
  const double around = spin * stage.radius;
  const double total = std::hypot(axial, around);
  EXPECT_TRUE(f.slipping);
  EXPECT_NEAR(f.force.z(), hole.friction * f.normal_force * axial / total,
              1e-9 * f.normal_force);  // upwards: against running down
  EXPECT_NEAR(f.moment.z(), hole.friction * f.normal_force * stage.radius * around / total, 1e-9 * f.normal_force);
  EXPECT_NEAR(f.friction_power, -hole.friction * f.normal_force * total, 1e-9 * f.normal_force);
}

TEST(WallFriction, StoppingDistanceDoesNotDependOnTheStep)
{
  // v^2 / (2 g (mu sin I - cos I)), mu static = kinetic: Coulomb's stop, less by half a step's slide in implicit Euler
  const double inclination = 80.0 * degree;
  for (double h : {0.004, 0.001})
  {
    BlockOnSlope block(inclination, 0.5);
    block.law().static_ratio = 1.0;
    for (int i = 0; i * h < 1.0; ++i)
    {
      block.step(h);  // lets it settle on the wall
    }
    const double start = block.travel();
    block.throw_down(1.0);
    for (int i = 0; i * h < 3.0; ++i)
    {
      block.step(h);
    }
    const double deceleration = standard_gravity * (0.5 * std::sin(inclination) - std::cos(inclination));
    EXPECT_NEAR(block.travel() - start, 0.5 / deceleration - 0.5 * h, 1e-3);
    EXPECT_LT(std::abs(block.speed()), 1e-3);
  }
}

TEST(WallFriction, SlidingBlockAcceleratesByTheDifference)
{
  const double inclination = 20.0 * degree;
  BlockOnSlope block(inclination, 0.5);
  block.law().static_ratio = 1.0;
  const double h = 0.002;
  for (int i = 0; i < 500; ++i)
  {
    block.step(h);
  }
  const double before = block.speed();
  for (int i = 0; i < 500; ++i)
  {
    block.step(h);
  }
  const double expected = standard_gravity * (std::cos(inclination) - 0.5 * std::sin(inclination));
  EXPECT_NEAR((block.speed() - before) / (500 * h), expected, 1e-6 * expected);
  EXPECT_NEAR(block.force().normal_force, 300.0 * standard_gravity * std::sin(inclination), 1e-3);
}

TEST(SlidingWallContact, ForcesAndTangent)
{
  ArcHole arc;
  const Vector3d where = at_the_wall(arc);
  WallLaw law = usual_law();
  const SlidingMotion pull_out{-1.0, 0.0};
  const SlidingMotion rotate{0.0, 1.0};
  Matrix6d tangent;
  const ClosestPoint closest = arc.locate(where);

  WallForce f = sliding_wall_contact(closest, 0.08, where, pull_out, law, tangent);
  EXPECT_NEAR(f.force.dot(closest.tangent), arc.friction * f.normal_force, 1e-9 * f.normal_force);
  f = sliding_wall_contact(closest, 0.08, where, rotate, law, tangent);
  EXPECT_NEAR(f.force.dot(closest.tangent), 0.0, 1e-9 * f.normal_force);
  EXPECT_NEAR(f.moment.dot(closest.tangent), -arc.friction * f.normal_force * 0.08, 1e-9 * f.normal_force);

  // a straight hole: the tangent is complete there
  const StraightHole hole = leaning_hole();
  const Vector3d start = at_the_wall(hole);
  for (const SlidingMotion& sliding : {pull_out, rotate, SlidingMotion{0.3, 7.0}, SlidingMotion{}})
  {
    const auto force = [&](const Vector6d& u)
    {
      const Vector3d p = start + u.head<3>();
      Matrix6d unused;
      return wrench(sliding_wall_contact(hole.locate(p), 0.08, p, sliding, law, unused));
    };
    sliding_wall_contact(hole.locate(start), 0.08, start, sliding, law, tangent);
    const Matrix6d numeric = difference(force, Vector6d::Zero(), 1e-6);
    EXPECT_LT((tangent - numeric).norm(), 1e-6 * numeric.norm());
  }
}

// Half the lever: half the torque of pure turning; the slip is half as fast around, so that more of it goes along.
TEST(SlidingWallContact, HasALeverApartFromTheRadius)
{
  const StraightHole hole = leaning_hole();
  const Vector3d start = at_the_wall(hole);
  const ClosestPoint closest = hole.locate(start);
  WallLaw law = usual_law();
  law.friction_radius = 0.04;
  Matrix6d tangent;
  const WallForce turning = sliding_wall_contact(closest, 0.08, start, {0.0, 1.0}, law, tangent);
  EXPECT_NEAR(turning.moment.dot(hole.tangent), -hole.friction * turning.normal_force * 0.04, 1e-9 * turning.normal_force);
  const WallForce both = sliding_wall_contact(closest, 0.08, start, {0.3, 7.0}, law, tangent);
  EXPECT_NEAR(both.force.dot(hole.tangent), -hole.friction * both.normal_force * 0.3 / std::hypot(0.3, 0.28),
              1e-9 * both.normal_force);
  EXPECT_NEAR(both.friction_power, -hole.friction * both.normal_force * std::hypot(0.3, 0.28), 1e-9 * both.normal_force);
  const auto force = [&](const Vector6d& u)
  {
    const Vector3d p = start + u.head<3>();
    Matrix6d unused;
    return wrench(sliding_wall_contact(hole.locate(p), 0.08, p, {0.3, 7.0}, law, unused));
  };
  const Matrix6d numeric = difference(force, Vector6d::Zero(), 1e-6);
  EXPECT_LT((tangent - numeric).norm(), 1e-6 * numeric.norm());
}

}  // namespace drill_rig_sim::test_contact_sliding
