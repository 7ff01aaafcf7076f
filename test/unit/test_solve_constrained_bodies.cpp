// SPDX-License-Identifier: BSD-3-Clause
// Rigid bodies with joints and multipliers, integrated by IDA: tangents, and motions known in closed form.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>

#include "drill_rig_sim/math/rotation.h"
#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/reference/ida_solver.h"
#include "index_three.h"

namespace test_solve_constrained_bodies
{
using namespace drill_rig_sim;
using Eigen::Quaterniond;
using Eigen::Vector3d;

namespace
{
BodyTolerance tolerance_of(double t)
{
  return {t, t, t, t, t};
}

/// Two bodies in wild motion, tied by every kind of constraint.
FallingBodies tangled(Formulation formulation)
{
  std::vector<BodyMotion> motions(2);
  motions[0].position = Vector3d(0.3, -0.2, 1.0);
  motions[0].orientation = Quaterniond(0.3, -0.5, 0.7, 0.2).normalized();
  motions[0].velocity = Vector3d(0.5, 1.0, -0.7);
  motions[0].angular_velocity = Vector3d(2.0, -1.0, 0.5);
  motions[1].position = Vector3d(-0.1, 0.4, 0.2);
  motions[1].orientation = Quaterniond(0.8, 0.1, -0.3, 0.4).normalized();
  motions[1].velocity = Vector3d(-0.5, 0.3, 0.9);
  motions[1].angular_velocity = Vector3d(0.4, 1.7, -2.5);
  std::vector<Joint> joints = {fixed_joint(0, motions[0], 1, motions[1]),
                               ball_joint(-1, BodyMotion(), 0, motions[0], Vector3d(0.2, 0.3, 0.4))};
  return FallingBodies({{3.0, 0.5, 0.2, 0.7}, {2.0, 0.0, 0.9, 0.3}}, motions, joints, formulation, tolerance_of(1e-6));
}

void expect_exact_jacobian(Formulation formulation)
{
  FallingBodies bodies = tangled(formulation);
  std::vector<double> y = bodies.at_bases();
  const auto n = y.size();
  std::vector<double> rate(n);
  for (std::size_t k = 0; k < n; ++k)
  {
    y[k] += 0.2 * std::sin(1.0 + 7.0 * static_cast<double>(k));
    rate[k] = std::cos(2.0 + 3.0 * static_cast<double>(k));
  }
  const double c = 3.7;
  SparseJacobian jacobian(static_cast<int>(n));
  jacobian.begin();
  bodies.jacobian(0.0, y.data(), rate.data(), c, jacobian);
  EXPECT_TRUE(jacobian.finish());
  std::vector<double> x(n), column(n), above(n), below(n);
  for (std::size_t k = 0; k < n; ++k)
  {
    std::fill(x.begin(), x.end(), 0.0);
    x[k] = 1.0;
    jacobian.multiply(x.data(), column.data());
    const double h = 1e-5;
    for (const double sign : {1.0, -1.0})
    {
      std::vector<double> moved = y, moved_rate = rate;
      moved[k] += sign * h;
      moved_rate[k] += sign * c * h;
      bodies.residual(0.0, moved.data(), moved_rate.data(), sign > 0.0 ? above.data() : below.data());
    }
    for (std::size_t i = 0; i < n; ++i) EXPECT_NEAR(column[i], (above[i] - below[i]) / (2.0 * h), 1e-7) << i << " by " << k;
  }
}

/// A pendulum of one metre with its weight `tilt_inertia` apart from a point, let go at `angle` from straight down.
FallingBodies pendulum(double angle, double tilt_inertia, Formulation formulation, double tolerance)
{
  std::vector<BodyMotion> motions(1);
  motions[0].position = Vector3d(std::sin(angle), 0.0, -std::cos(angle));
  const std::vector<Joint> joints = {ball_joint(-1, BodyMotion(), 0, motions[0], Vector3d::Zero())};
  return FallingBodies({{2.0, 0.0, tilt_inertia, tilt_inertia}}, motions, joints, formulation, tolerance_of(tolerance));
}

/// Quarter of the period by the arithmetic-geometric mean: T = 2 pi sqrt(l/g (1 + J/(m l^2))) / agm(1, cos(angle/2)).
double quarter_period(double angle, double tilt_inertia)
{
  double a = 1.0, b = std::cos(0.5 * angle);
  for (int k = 0; k < 8; ++k)
  {
    const double mean = 0.5 * (a + b);
    b = std::sqrt(a * b);
    a = mean;
  }
  return 0.5 * pi * std::sqrt((1.0 + tilt_inertia / 2.0) / standard_gravity) / a;
}

/// Where the pendulum is off the lowest point after a quarter period, and the joints' drift.
struct Swing
{
  double offset;
  ConstraintDrift drift;
  IdaStatistics statistics;
};

Swing swing(double tolerance)
{
  const double angle = 2.0, inertia = 0.3;
  FallingBodies body = pendulum(angle, inertia, Formulation::stabilised_index_2, tolerance);
  std::vector<double> y = body.at_bases(), rate(y.size());
  EXPECT_TRUE(body.make_consistent(0.0, y, rate));
  IdaSolver ida(body, IdaOptions());
  EXPECT_TRUE(ida.start(0.0, y, rate));
  Swing out;
  for (int k = 1; k <= 9; ++k)
  {
    // the base is renewed as often as the chart needs it
    EXPECT_TRUE(ida.advance(k * quarter_period(angle, inertia) / 9.0, y, rate)) << ida.flag_name();
    if (body.largest_tilt(y.data()) < 0.3) continue;
    body.renew_bases(y);
    EXPECT_TRUE(body.make_consistent(0.0, y, rate));
    EXPECT_TRUE(ida.start(k * quarter_period(angle, inertia) / 9.0, y, rate));
  }
  out.drift = body.drift(y.data());
  body.read(y.data());
  out.offset = body.motion(0).position.x();
  out.statistics = ida.statistics();
  return out;
}
}  // namespace

TEST(ConstrainedBodies, JacobianByFiniteDifferences)
{
  expect_exact_jacobian(Formulation::stabilised_index_2);
  expect_exact_jacobian(Formulation::index_3);
}

TEST(ConstrainedBodies, ConsistentStartHasNoViolationOfPlaceVelocityOrBalance)
{
  // one joint only: the tangled pair is overconstrained for a start
  FallingBodies body = pendulum(0.7, 0.3, Formulation::stabilised_index_2, 1e-6);
  std::vector<double> y = body.at_bases(), rate(y.size()), f(y.size());
  y[0] += 0.02;  // off the joint
  y[6] = 1.5;    // and flying away from it
  y[8] = -0.5;
  y[10] = 2.0;
  ASSERT_TRUE(body.make_consistent(0.0, y, rate));
  body.residual(0.0, y.data(), rate.data(), f.data());
  for (const double value : f) EXPECT_NEAR(value, 0.0, 1e-11);
  // acceleration of the constraint, by moving on a little: g stays zero to third order
  std::vector<double> moved = y;
  for (std::size_t k = 0; k < y.size(); ++k) moved[k] += 1e-4 * rate[k];
  EXPECT_LT(body.drift(moved.data()).velocity, 1e-6);
}

TEST(ConstrainedBodies, PendulumConvergesToTheEllipticIntegralsPeriod)
{
  double coarser = 0.0;
  for (const double tolerance : {1e-5, 1e-7, 1e-9})
  {
    const Swing s = swing(tolerance);
    const double speed = std::sqrt(2.0 * standard_gravity * (1.0 - std::cos(2.0)) / 1.15);
    // some hundred local errors add up
    EXPECT_LT(std::abs(s.offset) / speed, 300.0 * tolerance);
    if (coarser > 0.0)
    {
      EXPECT_LT(std::abs(s.offset), 0.2 * coarser);
    }
    coarser = std::abs(s.offset);
    // both constraints are unknowns' equations: Newton's method leaves a share of the tolerance, no more, and it does not grow
    EXPECT_LT(s.drift.position, tolerance);
    EXPECT_LT(s.drift.velocity, 10.0 * tolerance);
  }
}

TEST(ConstrainedBodies, SpinningTopKeepsItsEnergyAndMoment)
{
  // a heavy symmetric top on its tip: energy, moment about the vertical and spin are its integrals
  std::vector<BodyMotion> motions(1);
  const Vector3d axis = Vector3d(std::sin(0.5), 0.0, std::cos(0.5));
  motions[0].orientation = shortest_turn(Vector3d::UnitX(), axis);
  motions[0].position = 0.1 * axis;
  motions[0].angular_velocity = 60.0 * axis;
  const std::vector<Joint> joints = {ball_joint(-1, BodyMotion(), 0, motions[0], Vector3d::Zero())};
  FallingBodies top({{1.0, 0.0, 0.002, 0.001}}, motions, joints, Formulation::stabilised_index_2, tolerance_of(1e-8));
  std::vector<double> y = top.at_bases(), rate(y.size());
  ASSERT_TRUE(top.make_consistent(0.0, y, rate));
  auto integrals = [&]
  {
    top.read(y.data());
    const BodyMotion& m = top.motion(0);
    const Vector3d moment =
        m.position.cross(m.velocity) + 0.001 * m.angular_velocity + 0.001 * m.angular_velocity.dot(m.normal) * m.normal;
    return Vector3d(kinetic_energy({1.0, 0.0, 0.002, 0.001}, m) + standard_gravity * m.position.z(), moment.z(),
                    m.angular_velocity.dot(m.normal));
  };
  const Vector3d before = integrals();
  IdaSolver ida(top, IdaOptions());
  ASSERT_TRUE(ida.start(0.0, y, rate));
  for (int k = 1; k <= 100; ++k)
  {
    const double t = 0.01 * k;
    ASSERT_TRUE(ida.advance(t, y, rate)) << ida.flag_name();
    if (top.largest_tilt(y.data()) < 0.3) continue;
    top.renew_bases(y);
    ASSERT_TRUE(top.make_consistent(t, y, rate));
    ASSERT_TRUE(ida.start(t, y, rate));
  }
  const Vector3d after = integrals();
  // 60 rad in a second: 1e-8 a step and some thousand steps
  EXPECT_NEAR(after[0], before[0], 2e-5 * std::abs(before[0]));
  EXPECT_NEAR(after[1], before[1], 2e-5 * std::abs(before[1]));
  EXPECT_NEAR(after[2], before[2], 2e-5 * std::abs(before[2]));
}

TEST(IndexThree, FailsAtSmallStepsWhereTheStabilisedFormulationDoesNot)
{
  for (const double step : {1e-3, 1e-5, 1e-7, 1e-9})
  {
    const DaeStepOutcome stabilised = pendulum_with_step(step, Formulation::stabilised_index_2);
    EXPECT_TRUE(stabilised.reached) << step;
    EXPECT_LT(stabilised.multiplier_error, 1e-2) << step;
    const DaeStepOutcome index_3 = pendulum_with_step(step, Formulation::index_3);
    // at ordinary steps it goes through, though every change of the order upsets its multipliers
    if (step > 1e-6)
      EXPECT_TRUE(index_3.reached) << step;
    else
      EXPECT_TRUE(!index_3.reached || index_3.multiplier_error > 0.1) << step;
  }
}
}  // namespace test_solve_constrained_bodies
