// SPDX-License-Identifier: BSD-3-Clause
// Order of the steppers on smooth motions: axial and torsional swings of a string that hangs free.
#include <gtest/gtest.h>

#include <cmath>

#include "drill_rig_sim/compared/explicit_limit.h"
#include "drill_rig_sim/math/rotation.h"
#include "drill_rig_sim/sim/integrator_table.h"
#include "drill_rig_sim/solve/methods/method.h"
#include "drill_rig_sim/solve/start.h"
#include "drill_rig_sim/solve/stepper.h"
#include "lone_bit.h"
#include "plucked_rig.h"

namespace test_solve_convergence
{
using namespace drill_rig_sim;
using Eigen::Vector3d;

namespace
{
Eigen::VectorXd after(const RigAtRest& start, IntegratorKind method, double step)
{
  Stepper stepper(start.model, find_method(method));
  stepper.limits().tolerance = 1e-12;
  return after_span(start, stepper, step);
}

/// Order from three steps in the ratio 1 : 2 : 4: log2 of |y_4 - y_2|/|y_2 - y_1|; no reference solution is needed.
double order(const RigAtRest& start, IntegratorKind method, double finest)
{
  const Eigen::VectorXd fine = after(start, method, finest), middle = after(start, method, 2.0 * finest),
                        coarse = after(start, method, 4.0 * finest);
  return std::log2((coarse - middle).norm() / (middle - fine).norm());
}
}  // namespace

// Coarsest 1 ms: the pluck's shortest wave, 150 m long, takes 30 of it.
TEST(Convergence, bdf2IsOfSecondOrder)
{
  EXPECT_NEAR(order(plucked(), IntegratorKind::bdf2, 0.00025), 2.0, 0.1);
}

TEST(Convergence, implicitEulerIsOfFirstOrder)
{
  EXPECT_NEAR(order(plucked(), IntegratorKind::implicit_euler, 0.000125), 1.0, 0.15);
}

TEST(Convergence, trbdf2IsOfSecondOrder)
{
  EXPECT_NEAR(order(plucked(), IntegratorKind::trbdf2, 0.00025), 2.0, 0.1);
}

TEST(Convergence, generalisedAlphaIsOfSecondOrder)
{
  EXPECT_NEAR(order(plucked(), IntegratorKind::generalised_alpha, 0.00025), 2.0, 0.1);
}

TEST(Convergence, linearlyImplicitEulerIsOfFirstOrder)
{
  EXPECT_NEAR(order(plucked(), IntegratorKind::linearly_implicit_euler, 0.000125), 1.0, 0.15);
}

// It linearises about the start of the step, whatever came before: no first guess is carried over.
TEST(Convergence, linearlyImplicitEulerHasNoPast)
{
  const RigAtRest start = plucked();
  State state = start.state;
  Stepper stepper(start.model, find_method(IntegratorKind::linearly_implicit_euler));
  for (int k = 0; k < 20; ++k) ASSERT_TRUE(stepper.advance(state, 1e-3, Setpoints()));
  State forgetful = state;
  forgetful.memory.past[last_rate].nodes[0].velocity.z() += 0.1;
  Stepper other(start.model, find_method(IntegratorKind::linearly_implicit_euler));
  ASSERT_TRUE(stepper.advance(state, 1e-3, Setpoints()));
  ASSERT_TRUE(other.advance(forgetful, 1e-3, Setpoints()));
  EXPECT_EQ(state.nodes[0].position, forgetful.nodes[0].position);
  EXPECT_EQ(state.nodes[1].position, forgetful.nodes[1].position);
}

// Its steps are shorter than the stability limit.
TEST(Convergence, centralDifferencesAreOfSecondOrder)
{
  const RigAtRest start = plucked();
  const double limit = explicit_step_limit(*start.model, start.state);
  EXPECT_GT(limit, 0.0002);
  EXPECT_NEAR(order(start, IntegratorKind::central_differences, 0.00005), 2.0, 0.15);
}

// All of second order go to the same solution.
TEST(Convergence, methodsOfSecondOrderAgreeInTheLimit)
{
  const RigAtRest start = plucked();
  const Eigen::VectorXd reference = after(start, IntegratorKind::bdf2, 0.00005);
  const double scale = (reference - after(start, IntegratorKind::bdf2, plucked_span)).norm();
  for (IntegratorKind method : {IntegratorKind::trbdf2, IntegratorKind::generalised_alpha, IntegratorKind::central_differences})
    EXPECT_LT((after(start, method, 0.00005) - reference).norm(), 1e-3 * scale) << find_integrator(method).name;
}

// What the summary tells: iterations of all solves of a step.
TEST(Convergence, iterationsAreCounted)
{
  const RigAtRest start = plucked();
  for (const auto& [method, solves] : {std::pair(IntegratorKind::implicit_euler, 1u), std::pair(IntegratorKind::trbdf2, 2u)})
  {
    Stepper stepper(start.model, find_method(method));
    State state = start.state;
    for (int k = 0; k < 10; ++k) ASSERT_TRUE(stepper.advance(state, 1e-3, Setpoints()));
    EXPECT_GE(stepper.counters().newton_iterations, 10 * solves);
    EXPECT_LE(stepper.counters().newton_iterations, 10 * solves * 20);
  }
}

// In a smooth motion the tangent at the guess serves for the whole step, and the residual after its increment says that this was
// the last.
TEST(Convergence, smoothStepsTakeOneTangent)
{
  const RigAtRest start = plucked();
  Stepper stepper(start.model, find_method(IntegratorKind::bdf2));
  const Work before = stepper.work();
  constexpr double step = 0.001;
  after_span(start, stepper, step);
  const double steps = plucked_span / step;
  const Work& after = stepper.work();
  EXPECT_NEAR((after.tangents - before.tangents) / steps, 1.0, 0.01);
  EXPECT_EQ(after.solves - before.solves, after.tangents - before.tangents);
  EXPECT_LT((after.residuals - before.residuals) / steps, 2.01);
}

// Whatever way the iteration went, what it leaves is within its tolerance: 1e-6 of increments in 400 steps against 1e-12.
TEST(Convergence, newtonLeavesNoMoreThanItsTolerance)
{
  const RigAtRest start = plucked();
  const auto end = [&start](double tolerance)
  {
    Stepper stepper(start.model, find_method(IntegratorKind::bdf2));
    stepper.limits().tolerance = tolerance;
    return after_span(start, stepper, 0.001);
  };
  const Eigen::VectorXd exact = end(1e-12);
  EXPECT_LT((end(1e-6) - exact).cwiseAbs().maxCoeff(), 1e-6);
  EXPECT_LT((end(1e-9) - exact).cwiseAbs().maxCoeff(), 1e-9);
}

// A bit that is hit changes its speed by 2 m/s within a step of 10 ms: that step is worth its halves, those of the swing after it
// are not.
TEST(Convergence, blowsAreRefined)
{
  RigAtRest start = plucked();
  Stepper smooth(start.model, find_method(IntegratorKind::bdf2));
  after_span(start, smooth, 0.01);
  EXPECT_EQ(smooth.counters().error_test_failures, 0u);

  start.state.nodes[0].rate.velocity.z() = 2.0;
  Stepper stepper(start.model, find_method(IntegratorKind::bdf2)),
      fixed(start.model, find_method(IntegratorKind::generalised_alpha));
  after_span(start, stepper, 0.01);
  EXPECT_GT(stepper.counters().error_test_failures, 0u);
  EXPECT_LT(stepper.counters().error_test_failures, 30u);
  EXPECT_EQ(stepper.counters().convergence_failures, 0u);
  after_span(start, fixed, 0.01);
  EXPECT_EQ(fixed.counters().error_test_failures, 0u);
  // TR-BDF2 does not damp the swing, and refines as long as it is there
  Stepper one_step(start.model, find_method(IntegratorKind::trbdf2));
  after_span(start, one_step, 0.01);
  EXPECT_GT(one_step.counters().error_test_failures, 0u);
  EXPECT_EQ(one_step.counters().convergence_failures, 0u);
}

// The difference of a second and a third order: eight times less at half the step.
TEST(Convergence, theEstimateOfTrbdf2IsOfThirdOrder)
{
  const RigAtRest start = plucked();
  double last = 0.0;
  for (const double step : {4e-4, 2e-4, 1e-4})
  {
    State state = start.state;
    Stepper stepper(start.model, find_method(IntegratorKind::trbdf2));
    // from the same motion: a swing well under way, by steps too short to matter
    Stepper fine(start.model, find_method(IntegratorKind::trbdf2));
    for (int k = 0; k < 200; ++k) ASSERT_TRUE(fine.advance(state, 5e-5, Setpoints()));
    ASSERT_TRUE(stepper.advance(state, step, Setpoints()));
    const double now = stepper.error_estimate();
    if (last > 0.0)
    {
      EXPECT_NEAR(std::log2(last / now), 3.0, 0.2) << step;
    }
    last = now;
  }
}

// Central differences below the limit stay bounded, a fifth above it they do not.
TEST(Convergence, centralDifferencesFailBeyondTheirLimit)
{
  const RigAtRest start = plucked();
  const double limit = explicit_step_limit(*start.model, start.state);
  auto largest_rate = [&](double step)
  {
    State state = start.state;
    Stepper stepper(start.model, find_method(IntegratorKind::central_differences));
    for (int k = 0; k < 400 && stepper.advance(state, step, Setpoints()); ++k)
    {
    }
    double most = 0.0;
    for (const NodeState& node : state.nodes) most = std::max(most, node.rate.velocity.norm() + std::abs(node.rate.spin));
    return most;
  };
  EXPECT_LT(largest_rate(0.95 * limit), 1.0);
  EXPECT_GT(largest_rate(1.2 * limit), 1e3);
}

// A bit on a wall and a bottom so stiff that nothing else counts: omega^2 is the slope of k delta^e at a millimetre over its
// mass; the wall at the middle of the pipe above it gives with a half of the bit's motion, so that it resists with a quarter.
TEST(Convergence, theExplicitLimitIsThatOfAPressedContact)
{
  Scene scene = weightless(lone_bit_scene());
  scene.contact.law = {1e14, 1.5, 0.0};
  scene.string[0].bit->bottom = {3e14, 1.5, 0.0};
  const RigAtRest rig = lone_bit(scene,
                                 [&scene](MeshNode& bit, BeamSection&)
                                 {
                                   bit.mass = 1000.0;
                                   bit.mud_inside = bit.mud_outside = 0.0;
                                   bit.spin_inertia = bit.tilt_inertia = 1e6;
                                   bit.contact = scene.contact.law;
                                 });
  const double slope = 1.5 * 4.25e14 * std::sqrt(1e-3);  // [N/m]
  EXPECT_NEAR(explicit_step_limit(*rig.model, rig.state), 2.0 / std::sqrt(slope / 1000.0),
              1e-4 * 2.0 / std::sqrt(slope / 1000.0));
}

// Rates half a step old: of an oscillator's 2/omega, damping zeta leaves sqrt(1 + zeta^2) - zeta. Here zeta = omega b/2 = 1/2.
TEST(Convergence, dampingShortensTheExplicitLimit)
{
  Scene scene = without_damping(vertical_scene(100.0, 90.0));
  const RigAtRest undamped = build_at_rest(scene);
  const double limit = explicit_step_limit(*undamped.model, undamped.state);
  scene.numerics.structural_damping = 0.5 * limit;
  const RigAtRest damped = build_at_rest(scene);
  EXPECT_NEAR(explicit_step_limit(*damped.model, damped.state), limit * (std::sqrt(1.25) - 0.5), 1e-6 * limit);
}

// Both go to the same solution, BDF2 sooner.
TEST(Convergence, methodsAgreeInTheLimit)
{
  const RigAtRest start = plucked();
  const Eigen::VectorXd reference = after(start, IntegratorKind::bdf2, 0.00005);
  const double scale = (reference - after(start, IntegratorKind::bdf2, plucked_span)).norm();  // one step: where it began, nearly
  const double bdf2 = (after(start, IntegratorKind::bdf2, 0.00025) - reference).norm();
  const double euler = (after(start, IntegratorKind::implicit_euler, 0.00025) - reference).norm();
  EXPECT_GT(scale, 1e-3);
  EXPECT_LT(euler, 0.1 * scale);
  EXPECT_LT(bdf2, 0.1 * euler);
}

// Halved steps in between (as after a rejected one) keep the second order: BDF2 knows its last step's length.
TEST(Convergence, unevenStepsKeepTheSecondOrder)
{
  const RigAtRest start = plucked();
  auto uneven = [&](double step)
  {
    State state = start.state;
    Stepper stepper(start.model, find_method(IntegratorKind::bdf2));
    stepper.limits().tolerance = 1e-12;
    for (long k = 0; k < std::lround(plucked_span / step); ++k)
      for (int part = 0; part < (k % 3 == 1 ? 2 : 1); ++part)
        EXPECT_TRUE(stepper.advance(state, k % 3 == 1 ? 0.5 * step : step, Setpoints()));
    Eigen::VectorXd out(state.nodes.size());
    for (std::size_t i = 0; i < state.nodes.size(); ++i) out[i] = state.nodes[i].position.z();
    return out;
  };
  const Eigen::VectorXd fine = uneven(0.0005), middle = uneven(0.001), coarse = uneven(0.002);
  EXPECT_NEAR(std::log2((coarse - middle).norm() / (middle - fine).norm()), 2.0, 0.2);
}
}  // namespace test_solve_convergence
