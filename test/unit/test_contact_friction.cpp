// SPDX-License-Identifier: BSD-3-Clause
// The bristle that carries friction: consistent tangents, sticking without creep, never more than its limit, no energy from
// nothing.
#include <gtest/gtest.h>

#include <random>

#include "contact_fixtures.h"
#include "drill_rig_sim/contact/friction_law.h"

namespace drill_rig_sim::test_contact_friction
{
TEST(StribeckFriction, FallsFromStaticToKinetic)
{
  EXPECT_DOUBLE_EQ(stribeck_friction(0.3, 1.2, 0.05, 0.0).value, 0.36);
  EXPECT_DOUBLE_EQ(stribeck_friction(0.3, 1.2, 0.05, 0.0).slope, 0.0);
  EXPECT_NEAR(stribeck_friction(0.3, 1.2, 0.05, 0.5).value, 0.3, 1e-15);
  const double h = 1e-5;
  const double slope =
      (stribeck_friction(0.3, 1.2, 0.05, 0.04 + h).value - stribeck_friction(0.3, 1.2, 0.05, 0.04 - h).value) / (2.0 * h);
  EXPECT_NEAR(stribeck_friction(0.3, 1.2, 0.05, 0.04).slope, slope, 1e-6 * std::abs(slope));
}

TEST(StribeckFriction, FallsFromRestOnByTheExponentialCurve)
{
  const auto at = [](double speed) { return stribeck_friction(0.3, 1.2, 0.05, speed, StribeckCurve::exponential); };
  EXPECT_DOUBLE_EQ(at(0.0).value, 0.36);
  EXPECT_DOUBLE_EQ(at(0.0).slope, -0.06 / 0.05);
  EXPECT_NEAR(at(0.05).value, 0.3 + 0.06 / std::exp(1.0), 1e-15);
  EXPECT_NEAR(at(2.0).value, 0.3, 1e-15);
  const double h = 1e-5;
  EXPECT_NEAR(at(0.04).slope, (at(0.04 + h).value - at(0.04 - h).value) / (2.0 * h), 1e-6 * std::abs(at(0.04).slope));
}

TEST(WallContact, TangentSticking)
{
  const StraightHole hole = leaning_hole();
  ContactStage stage = touching_stage(at_the_wall(hole));
  stage.velocity_0 *= 0.1;
  stage.angular_velocity_0 *= 0.02;  // the damper holds it too
  stage.bristle << 1e-5, -2e-5, 3e-5;
  Vector6d u;
  u << 2e-5, -4e-5, 3e-5, 1e-4, -2e-4, 3e-4;
  expect_tangent(hole, stage, u, false);

  const ArcHole arc;
  stage.start = at_the_wall(arc);
  expect_tangent(arc, stage, u, false);
}

TEST(WallContact, TangentSlipping)
{
  StraightHole hole = leaning_hole();
  hole.radius_slope = -0.004;  // taper; 0.1 m where the section stands
  hole.radius = 0.108;
  ContactStage stage = touching_stage(at_the_wall(hole));
  stage.bristle << 4e-4, -2e-4, 3e-4;
  stage.law.stribeck_speed = 0.5;  // so that its slope counts
  Vector6d u;
  u << 2e-4, -4e-4, 3e-4, 1e-3, -2e-3, 3e-3;
  expect_tangent(hole, stage, u, true);

  ArcHole arc;
  stage.start = at_the_wall(arc);
  expect_tangent(arc, stage, u, true);
  stage.law.stribeck_curve = StribeckCurve::exponential;
  expect_tangent(arc, stage, u, true);
  stage.law.law.exponent = 1.8;
  expect_tangent(arc, stage, u, true);
  arc.friction = 0.0;
  expect_tangent(arc, stage, u, true);
}

// The friction's power is its moment times the turning: force and slip know the same lever.
TEST(WallContact, FrictionHasALeverApartFromTheRadius)
{
  ArcHole arc;
  ContactStage stage = touching_stage(at_the_wall(arc));
  stage.law.friction_radius = 0.05;
  Vector6d u;
  u << 2e-4, -4e-4, 3e-4, 1e-3, -2e-3, 3e-3;
  expect_tangent(arc, stage, u, true);
  stage.law.tangential_stiffness = 1e4;
  stage.law.tangential_damping = 10.0;
  expect_tangent(arc, stage, u, false);

  const StraightHole hole;
  ContactStage turning;
  turning.start << 0.0214, 0.0, -3.0;
  turning.law.friction_radius = 0.05;
  Vector6d turn;
  turn << 0, 0, 0, 0, 0, -0.1;
  const ContactMotion m = turning.motion(turn);
  const WallForce f = wall_contact(hole.locate(m.position), turning.radius, m, turning.bristle, turning.law);
  EXPECT_TRUE(f.slipping);
  const double friction = hole.friction * f.normal_force;  // at 1 m/s
  EXPECT_NEAR(f.moment.z(), 0.05 * friction, 1e-9 * friction);
  EXPECT_NEAR(f.friction_power, -0.05 * friction * 20.0, 1e-9 * friction);
}

TEST(WallContact, TangentAtRandomStates)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  const auto vector = [&] { return Vector3d(uniform(random), uniform(random), uniform(random)); };
  ArcHole arc;
  int sticking = 0;
  int slipping = 0;
  for (int i = 0; i < 200; ++i)
  {
    ContactStage stage;
    const double angle = 3.0 * uniform(random);
    const ClosestPoint closest = arc.locate({4.0, 0.0, -3.0});
    const Vector3d across = closest.tangent.cross(Vector3d::UnitY());
    stage.start =
        closest.centre + (0.022 + 5e-4 * uniform(random)) * (std::cos(angle) * across + std::sin(angle) * Vector3d::UnitY());
    stage.velocity_0 = 0.3 * vector();
    stage.angular_velocity_0 = 5.0 * vector();
    stage.bristle = 3e-4 * vector();
    stage.law.tangential_damping = i % 2 == 0 ? 300.0 : 0.0;  // fast sections stick too
    Vector6d u;
    u << 1e-4 * vector(), 1e-2 * vector();

    const ContactMotion m = stage.motion(u);
    const WallForce f = wall_contact(arc.locate(m.position), stage.radius, m, stage.bristle, stage.law);
    // away from the switch only: the kink itself has no derivative
    if (!f.slipping && (f.force + f.normal_force * f.normal).norm() > 0.95 * arc.friction * f.normal_force)
    {
      continue;
    }
    ++(f.slipping ? slipping : sticking);
    expect_tangent(arc, stage, u, f.slipping);
  }
  EXPECT_GT(sticking, 20);
  EXPECT_GT(slipping, 20);
}

TEST(WallContact, TangentWithZeroClearance)
{
  // gauge in its own hole, 0.1 mm off centre: friction is small, the normal direction turns fast
  StraightHole hole;
  ContactStage stage = touching_stage({8e-5, 6e-5, -1.0});
  stage.radius = hole.radius;
  stage.velocity_0 << 1e-3, 2e-3, 0.01;
  stage.law.tangential_stiffness = 1e4;
  stage.law.tangential_damping = 10.0;
  stage.bristle << 1e-5, -2e-5, 2e-5;
  Vector6d u;
  u << 1e-6, 2e-6, -3e-5, 1e-5, 2e-5, -1e-3;
  expect_tangent(hole, stage, u, false, 1e-7);
  stage.law.tangential_stiffness = 5e6;
  expect_tangent(hole, stage, u, true, 1e-7);
}

TEST(WallFriction, HeldBlockDoesNotCreep)
{
  // 70 deg from the vertical, mu_s = 3.6 > cot 70 deg: held. The elastic set is m g cos I / k_b = 0.2 mm, plus what slips while
  // the block is let down on the wall from zero penetration.
  BlockOnSlope block(70.0 * degree, 3.0);
  for (int i = 0; i < 1000; ++i)
  {
    block.step(0.005);
  }
  const double set = block.travel();
  EXPECT_NEAR(set, 300.0 * standard_gravity * std::cos(70.0 * degree) / 5e6, 2e-4);
  for (int i = 0; i < 100000; ++i)
  {
    block.step(0.005);
  }
  EXPECT_NEAR(block.travel(), set, 1e-12);
  EXPECT_LT(std::abs(block.speed()), 1e-12);
  EXPECT_FALSE(block.force().slipping);
}

TEST(WallFriction, PulsatingLoadWithinTheLimitDoesNotCreep)
{
  // the normal load swings by half; friction never reaches its limit: each cycle must come back to the same place
  BlockOnSlope block(70.0 * degree, 3.0);
  const double weight = 300.0 * standard_gravity * std::sin(70.0 * degree);
  const auto cycle = [&]
  {
    for (int i = 0; i < 40; ++i)
    {
      block.step(0.005, 0.5 * weight * std::sin(2.0 * pi * i / 40.0));
    }
  };
  for (int i = 0; i < 50; ++i)
  {
    cycle();
  }
  const double set = block.travel();
  for (int i = 0; i < 1000; ++i)
  {
    cycle();
  }
  EXPECT_NEAR(block.travel(), set, 1e-12);
}

TEST(WallFriction, DampingIsAShareOfCritical)
{
  // 2 * 0.25 * sqrt(5e6 N/m * 320 kg)
  EXPECT_DOUBLE_EQ(wall_law(ContactSpec(), ContactLaw(), 320.0, 0.0).tangential_damping, 2e4);
}

TEST(WallFriction, BristleAndDamperByHand)
{
  // 1 mm in the wall of a vertical hole: F_n = 5e7 * 1e-3^1.5 = 1581 N, mu_k F_n = 474 N
  StraightHole hole;
  ContactMotion m;
  m.position = Vector3d(0.021, 0.0, -1.0);
  m.displacement.z() = 1e-5;
  m.velocity.z() = 2e-3;
  m.time = 0.005;
  const WallLaw law = usual_law();
  const Vector3d bristle(0.0, 3e-5, 2e-5);
  // sticks: y: 5e6 * 3e-5 = 150 N, z: 5e6 * 3e-5 + 2e4 * 2e-3 = 190 N
  WallForce f = wall_contact(hole.locate(m.position), 0.08, m, bristle, law);
  EXPECT_FALSE(f.slipping);
  EXPECT_NEAR(f.normal_force, 1581.139, 0.01);
  EXPECT_NEAR(f.force.y(), -150.0, 1e-9);
  EXPECT_NEAR(f.force.z(), -190.0, 1e-9);
  EXPECT_NEAR((f.bristle - Vector3d(0.0, 3e-5, 3e-5)).norm(), 0.0, 1e-15);
  // slides at 1 m/s: q = (150, 150 + 20000) N, the force is mu_k F_n along it; in 5 ms the bristle goes 5/9 of its way, for
  // 2e4/5e6 = 4 ms is its time, from (3e-5, 2e-5) to 474.34/5e6 m along q
  m.velocity.z() = 1.0;
  f = wall_contact(hole.locate(m.position), 0.08, m, bristle, law);
  EXPECT_TRUE(f.slipping);
  EXPECT_NEAR(f.force.z(), -474.342 * 20150.0 / std::hypot(150.0, 20150.0), 1e-3);
  EXPECT_NEAR(f.bristle.z(), 2e-5 + 5.0 / 9.0 * (9.48657e-5 - 2e-5), 1e-9);
}

TEST(WallFriction, AStuckBlockComesToRest)
{
  // thrown by 1 mm/s it swings on its bristle: sqrt(5e6/300) = 129.1 rad/s, damped by 2e4/(2 * 300 * 129.1) = 0.258 of critical
  BlockOnSlope block(70.0 * degree, 3.0);
  const double step = 2e-5;
  for (int i = 0; i < 1000; ++i) block.step(1e-3);
  const double rest = block.travel(), frequency = std::sqrt(5e6 / 300.0), ratio = 2e4 / (2.0 * 300.0 * frequency);
  block.throw_down(1e-3);
  const double damped = frequency * std::sqrt(1.0 - ratio * ratio), half = pi / damped;
  double most = 0.0, back = 0.0;
  for (double time = 0.0; time < 2.0 * half; time += step)
  {
    block.step(step);
    (time < half ? most : back) = std::max(time < half ? most : back, std::abs(block.travel() - rest));
  }
  EXPECT_FALSE(block.force().slipping);
  EXPECT_NEAR(back / most, std::exp(-ratio * frequency * half), 0.02);
}

/// Work that random displacements of a section do on the wall, step by step, less what its bristle then holds: the least of it.
double least_loss(double h, double damping, double along, double around)
{
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  StraightHole hole;
  ContactStage stage;
  stage.law.law.damping = 0.0;
  stage.law.tangential_damping = damping;
  stage.start << 0.0214, 0.0, -3.0;
  stage.coefficient = 1.0 / h;
  Vector3d bristle = Vector3d::Zero();
  double taken_out = 0.0, least = HUGE_VAL;
  for (int i = 0; i < 20000; ++i)
  {
    Vector6d u;
    u << 0.0, 0.0, along * normal(random), 0.0, 0.0, around * normal(random);
    const ContactMotion m = stage.motion(u);
    const WallForce f = wall_contact(hole.locate(m.position), stage.radius, m, bristle, stage.law);
    taken_out -= f.friction_power * h;  // implicit: force at the end of the step times the step's slip
    bristle = f.bristle;
    const double held = 0.5 * stage.law.tangential_stiffness * bristle.squaredNorm();
    least = std::min(least, taken_out - held * (1.0 - 1e-12));
  }
  EXPECT_GT(taken_out, 0.0);
  return least;
}

TEST(WallFriction, NeverCreatesEnergy)
{
  EXPECT_GE(least_loss(0.005, 0.0, 2e-4, 2e-3), 0.0);
  // steps longer and far shorter than the bristle's time; as fast, and as short
  for (double h : {0.05, 0.005, 1e-4, 1e-6})
  {
    EXPECT_GE(least_loss(h, 2e4, 2e-4, 2e-3), 0.0) << h;
    EXPECT_GE(least_loss(h, 2e4, 0.04 * h, 0.4 * h), 0.0) << h;
    EXPECT_GE(least_loss(h, 1e7, 0.04 * h, 0.4 * h), 0.0) << h;
  }
}

TEST(WallFriction, BristleNeverLeavesTheLimitOrThePlane)
{
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  StraightHole hole;
  ContactStage stage;
  Vector3d bristle = Vector3d::Zero();
  for (int i = 0; i < 1000; ++i)
  {
    const double angle = 0.01 * i;
    stage.start << 0.0214 * std::cos(angle), 0.0214 * std::sin(angle), -3.0;
    Vector6d u;
    u << 0.0, 0.0, 3e-4 * normal(random), 0.0, 0.0, 5e-3 * normal(random);
    const ContactMotion m = stage.motion(u);
    const WallForce f = wall_contact(hole.locate(m.position), stage.radius, m, bristle, stage.law);
    bristle = f.bristle;
    EXPECT_NEAR(bristle.dot(Vector3d(std::cos(angle), std::sin(angle), 0.0)), 0.0, 1e-15);
    EXPECT_LE(stage.law.tangential_stiffness * bristle.norm(),
              hole.friction * stage.law.static_ratio * f.normal_force * (1.0 + 1e-12));
  }
}

}  // namespace drill_rig_sim::test_contact_friction
