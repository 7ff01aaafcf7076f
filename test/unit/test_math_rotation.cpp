// SPDX-License-Identifier: BSD-3-Clause
// Rotation vectors, axes and the twist between two cross-sections.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <random>

#include "drill_rig_sim/math/rotation.h"
#include "drill_rig_sim/math/units.h"

namespace test_math_rotation
{
using namespace drill_rig_sim;
using Eigen::AngleAxisd;
using Eigen::Quaterniond;
using Eigen::Vector3d;

namespace
{
Vector3d random_vector(std::mt19937& random)
{
  std::normal_distribution<double> g;
  return {g(random), g(random), g(random)};
}

/// Rotation matrix of a rotation vector by Rodrigues' formula.
Eigen::Matrix3d rodrigues(const Vector3d& r)
{
  const double angle = r.norm();
  if (angle == 0.0) return Eigen::Matrix3d::Identity();
  const Eigen::Matrix3d k = skew(r / angle);
  return Eigen::Matrix3d::Identity() + std::sin(angle) * k + (1.0 - std::cos(angle)) * k * k;
}
}  // namespace

TEST(Rotation, skewIsTheCrossProduct)
{
  std::mt19937 random(1);
  const Vector3d a = random_vector(random), b = random_vector(random);
  EXPECT_LT((skew(a) * b - a.cross(b)).norm(), 1e-15);
}

// From 1e-9 rad through the series' end at 0.01 rad to many turns: a few round-offs, times the angle where it is large.
TEST(Rotation, vectorToQuaternionIsExactAtEverySize)
{
  std::mt19937 random(2);
  EXPECT_TRUE(rotation_from_vector(Vector3d::Zero()).isApprox(Quaterniond::Identity(), 0.0));
  for (double size : {1e-9, 1e-4, 0.0099, 0.00999999, 0.0100001, 0.0101, 0.5, 3.0, 6.0, 100.0})
  {
    const Vector3d r = size * random_vector(random).normalized();
    const Quaterniond q = rotation_from_vector(r);
    EXPECT_NEAR(q.norm(), 1.0, 4e-16) << size;
    EXPECT_LT((q.toRotationMatrix() - rodrigues(r)).norm(), 2e-15 * std::max(1.0, size)) << size;
  }
}

TEST(Rotation, axesAreTheMatrixColumns)
{
  std::mt19937 random(3);
  for (int i = 0; i < 20; ++i)
  {
    const Quaterniond q = rotation_from_vector(random_vector(random));
    const Eigen::Matrix3d m = q.toRotationMatrix();
    EXPECT_LT((x_axis(q) - m.col(0)).norm(), 1e-15);
    EXPECT_LT((y_axis(q) - m.col(1)).norm(), 1e-15);
  }
}

TEST(Rotation, twistUndoesTheTiltByTheShortestRotation)
{
  std::mt19937 random(4);
  for (double twist : {-3.1, -1.0, -0.02, -0.019, 0.0, 1e-9, 0.0199, 0.0201, 0.5, 3.1})
  {
    const Quaterniond from = rotation_from_vector(random_vector(random));
    // tilt about an axis across the section's normal, then twist about the tilted normal
    const Vector3d across = x_axis(from).cross(random_vector(random)).normalized();
    const Quaterniond swing(AngleAxisd(0.4, across));
    const Quaterniond to = swing * from * Quaterniond(AngleAxisd(twist, Vector3d::UnitX()));
    EXPECT_NEAR(twist_between(from, to), twist, 4e-15) << twist;
    EXPECT_NEAR(twist_between(to, from), -twist, 4e-15) << twist;
  }
}

// Both ends turned together by any number of turns: the same twist.
TEST(Rotation, twistForgetsCommonSpin)
{
  std::mt19937 random(5);
  const Quaterniond from = rotation_from_vector(random_vector(random));
  const Quaterniond to = from * rotation_from_vector(Vector3d(0.01, 0.02, -0.03));
  const double twist = twist_between(from, to);
  Quaterniond a = from, b = to;
  for (int turn = 0; turn < 1000; ++turn)
  {
    a = a * rotation_from_vector(Vector3d(2.0 * pi / 7.0, 0.0, 0.0));
    b = b * rotation_from_vector(Vector3d(2.0 * pi / 7.0, 0.0, 0.0));
  }
  // a thousand products of quaternions, each good to a round-off
  EXPECT_NEAR(twist_between(a.normalized(), b.normalized()), twist, 1e-12);
}

TEST(Rotation, theShortestTurnIsEigens)
{
  std::mt19937 random(6);
  for (int i = 0; i < 100; ++i)
  {
    const Vector3d from = random_vector(random), to = random_vector(random);
    EXPECT_EQ(shortest_turn(from, to).coeffs(), Quaterniond::FromTwoVectors(from, to).coeffs());
    EXPECT_LT((x_axis(pointed_along(rotation_from_vector(from), to)) - to.normalized()).norm(), 4e-15);
  }
}

// Any axis across will do. Next to a half turn 1 + c cancels: 5e-11 is left of it at 1e-5 rad, known to 1e-16.
TEST(Rotation, theShortestTurnMayBeAHalfOne)
{
  for (double off : {0.0, 1e-9, 1e-6, 1e-5})
  {
    const Vector3d from(3.0, 0.0, 0.0), to(-2.0, 2.0 * off, 0.0);
    const Quaterniond turn = shortest_turn(from, to);
    EXPECT_NEAR(turn.norm(), 1.0, 2e-6);
    EXPECT_LT((turn * from.normalized() - to.normalized()).norm(), 1.5e-6) << off;
  }
}
}  // namespace test_math_rotation
