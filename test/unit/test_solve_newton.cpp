// SPDX-License-Identifier: BSD-3-Clause
// Newton's rules on a problem whose iterates are known: a bit on a spring, over a second spring that begins where it touches
// bottom.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "drill_rig_sim/model/evaluate.h"
#include "drill_rig_sim/model/forces/inertia.h"
#include "drill_rig_sim/solve/newton.h"
#include "lone_bit.h"

namespace test_solve_newton
{
using namespace drill_rig_sim;

namespace
{
constexpr double soft = 1e4;  // c, the first spring: the bit's inertia over the square of a step [N/m]

/// f(x) = c x + k max(0, x) - c D for the bit's depth x below first touch: Newton's method from x < 0 goes to D first, and the
/// solution is D c/(c + k).
class TwoSprings
{
public:
  /// `ratio`: k/c; `beyond`: D [m].
  TwoSprings(double ratio, double beyond)
      : rig_(lone_bit(scene_for(ratio), [](MeshNode&, BeamSection& pipe) { pipe.axial = 1e-9; })),
        stage_(*rig_.model),
        work_(*rig_.model),
        u_(6 * rig_.model->nodes(), 0.0)
  {
    begin_step(*rig_.model, rig_.state, 0.01, Setpoints(), stage_);
    stage_.dv_du = 0.0;
    stage_.da_du = soft / node_body(*rig_.model, stage_, 0).mass;
    stage_.drive = {0.01, 100.0, 1e4, 0.0, 0.0};
    std::vector<double> residual(u_);
    evaluate(*rig_.model, rig_.state, stage_, u_.data(), work_, residual.data(), nullptr);
    const Wellbore& well = rig_.state.well;
    touch_ = rig_.state.nodes[0].position.z() - rig_.model->mesh().bit_radius - well.bottom_position().z();
    stage_.acceleration[0].z() = (soft * (touch_ + beyond) - residual[2]) / node_body(*rig_.model, stage_, 0).mass;
    work_.work = Work();
  }

  /// From depth `from` below first touch [m].
  NewtonOutcome solve(double from, const NewtonLimits& limits)
  {
    u_[2] = -(touch_ + from);
    return Newton(*rig_.model).solve(context(), u_.data(), limits);
  }
  bool improve(double from)
  {
    u_[2] = -(touch_ + from);
    return Newton(*rig_.model).improve(context(), u_.data());
  }
  double depth() const { return -u_[2] - touch_; }
  const Work& work() const { return work_.work; }
  double force_on_bottom() const { return work_.result.bottom.value; }

private:
  static Scene scene_for(double ratio)
  {
    Scene scene = lone_bit_scene();
    scene.well.survey = {{0.0, 0.0, 0.0}, {10.3, 0.0, 0.0}};
    scene.well.hole_depth = 10.3;
    scene.well.sections = {{10.3, 0.2159, 0.0}};
    scene.string[0].bit->bottom = {ratio * soft, 1.0, 0.0};
    return scene;
  }
  StageContext context() { return {*rig_.model, rig_.state, stage_, work_}; }

  RigAtRest rig_;
  Stage stage_;
  Workspace work_;
  std::vector<double> u_;
  double touch_ = 0.0;
};

constexpr double just_above = -1e-9;  // [m]
constexpr double nan_value = std::numeric_limits<double>::quiet_NaN();
}  // namespace

// What an iteration leaves is its increment times its contraction, the first one's taken as 1; an increment that was cut never
// ends it.
TEST(Newton, convergesOnTheErrorThatItsIncrementLeaves)
{
  NewtonLimits limits;
  limits.tolerance = 1e-6;
  limits.max_increment = 0.05;
  EXPECT_TRUE(newton_converged(0.9e-6, 0.0, limits));
  EXPECT_FALSE(newton_converged(1.1e-6, 0.0, limits)) << "of the first nothing is known";
  EXPECT_TRUE(newton_converged(0.9e-4, 1e-2, limits)) << "leaves 8e-7";
  EXPECT_FALSE(newton_converged(1.1e-4, 1e-2, limits)) << "leaves 1.2e-6";
  EXPECT_FALSE(newton_converged(1.1e-6, 1e-6, limits)) << "grows: counted whole, no more";
  EXPECT_TRUE(newton_converged(0.9e-6, 1e-9, limits));
  EXPECT_FALSE(newton_converged(0.06, 1e9, limits)) << "cut";
  EXPECT_FALSE(newton_converged(nan_value, 1e-3, limits));
}

// One spring: the first increment solves it, the residual after it shows that.
TEST(Newton, solvesALinearProblemWithOneTangent)
{
  TwoSprings problem(1.0, -0.03);
  const NewtonOutcome outcome = problem.solve(-0.07, NewtonLimits());
  EXPECT_TRUE(outcome.converged);
  EXPECT_EQ(outcome.iterations, 1);
  EXPECT_LT(outcome.increment, 1e-9);
  EXPECT_NEAR(problem.depth(), -0.03, 1e-9);
  EXPECT_EQ(problem.work().tangents, 1u);
  EXPECT_EQ(problem.work().solves, 1u);
  EXPECT_EQ(problem.work().residuals, 2u);
  EXPECT_EQ(problem.work().substitutions, 1u);
}

// k = c/10: with the tangent of the first iteration the increments are D/10^n. It must go on until D/10^(n+1), what the n-th
// leaves, is below the tolerance, and no further; then one more look at the forces, where the solution is.
TEST(Newton, stopsWhenTheToleranceIsReachedAndNotBefore)
{
  int n = 1;
  for (const double tolerance : {1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8})
  {
    TwoSprings problem(0.1, 0.02);
    NewtonLimits limits;
    limits.tolerance = tolerance;
    const NewtonOutcome outcome = problem.solve(just_above, limits);
    EXPECT_TRUE(outcome.converged);
    EXPECT_EQ(outcome.iterations, 1);
    EXPECT_EQ(problem.work().substitutions, static_cast<std::uint64_t>(n)) << tolerance;
    EXPECT_EQ(problem.work().residuals, static_cast<std::uint64_t>(n + 2)) << tolerance;
    EXPECT_NEAR(outcome.increment, 0.02 * std::pow(0.1, n), 1e-3 * outcome.increment) << tolerance;
    const double left = problem.depth() - 0.02 / 1.1;
    EXPECT_NEAR(std::abs(left), 0.02 / 1.1 * std::pow(0.1, n + 1), 1e-9) << tolerance;
    EXPECT_LT(std::abs(left), tolerance);
    EXPECT_NEAR(problem.force_on_bottom(), 0.1 * soft * problem.depth(), 1e-6) << "the forces are those at the solution";
    ++n;
  }
}

// A kept tangent serves as long as it takes four fifths off each increment: k = 0.15 c, but not 0.25 c.
TEST(Newton, aTangentThatNoLongerServesIsMadeAnew)
{
  TwoSprings serves(0.15, 0.02), does_not(0.25, 0.02);
  EXPECT_EQ(serves.solve(just_above, NewtonLimits()).iterations, 1);
  EXPECT_EQ(does_not.solve(just_above, NewtonLimits()).iterations, 2);
  EXPECT_EQ(does_not.work().substitutions, 2u);
  EXPECT_NEAR(does_not.depth(), 0.02 / 1.25, 1e-9);
}

// k = 9 c: the increment of 0.02 m asks for another of 0.18 m back: half of it is taken back, and the second tangent solves it.
TEST(Newton, halfOfAnIncrementOverAKinkIsTakenBack)
{
  TwoSprings problem(9.0, 0.02);
  const NewtonOutcome outcome = problem.solve(just_above, NewtonLimits());
  EXPECT_TRUE(outcome.converged);
  EXPECT_EQ(outcome.iterations, 2);
  EXPECT_EQ(problem.work().substitutions, 2u);
  EXPECT_NEAR(problem.depth(), 0.002, 1e-9);
  TwoSprings given_up(9.0, 0.02);
  NewtonLimits limits;
  limits.max_iterations = 1;
  const NewtonOutcome early = given_up.solve(just_above, limits);
  EXPECT_FALSE(early.converged);
  EXPECT_EQ(early.iterations, 1);
  EXPECT_NEAR(given_up.depth(), 0.01, 1e-8);
}

// k = 0.6 c: 0.6 of the first is progress, taken whole.
TEST(Newton, anIncrementThatShrinksIsTakenWhole)
{
  TwoSprings problem(0.6, 0.02);
  const NewtonOutcome outcome = problem.solve(just_above, NewtonLimits());
  EXPECT_TRUE(outcome.converged);
  EXPECT_EQ(outcome.iterations, 2);
  EXPECT_EQ(problem.work().substitutions, 2u);
  EXPECT_NEAR(problem.depth(), 0.0125, 1e-9);
}

// 12 cm to go, 5 cm at most at a time: 5, 5, 2, each with a tangent of its own.
TEST(Newton, longIncrementsAreCut)
{
  TwoSprings problem(1.0, -0.03);
  NewtonLimits limits;
  limits.max_increment = 0.05;
  const NewtonOutcome outcome = problem.solve(-0.15, limits);
  EXPECT_TRUE(outcome.converged);
  EXPECT_EQ(outcome.iterations, 3);
  EXPECT_EQ(problem.work().substitutions, 1u);
  EXPECT_NEAR(problem.depth(), -0.03, 1e-9);
  TwoSprings again(1.0, -0.03);
  limits.max_iterations = 2;
  EXPECT_FALSE(again.solve(-0.15, limits).converged);
  EXPECT_NEAR(again.depth(), -0.05, 1e-9);
}

TEST(Newton, whatIsNoNumberEndsItUnconverged)
{
  TwoSprings problem(1.0, 0.02);
  const NewtonOutcome outcome = problem.solve(nan_value, NewtonLimits());
  EXPECT_FALSE(outcome.converged);
  EXPECT_EQ(outcome.iterations, 1);
  EXPECT_FALSE(problem.improve(nan_value));
}

// Linearly implicit methods: one increment, whole however long it is.
TEST(Newton, improvesByOneWholeIncrement)
{
  TwoSprings problem(9.0, 0.02);
  EXPECT_TRUE(problem.improve(-0.15));
  EXPECT_NEAR(problem.depth(), 0.02, 1e-9);
  EXPECT_TRUE(problem.improve(0.02));
  EXPECT_NEAR(problem.depth(), 0.002, 1e-9);
  EXPECT_EQ(problem.work().tangents, 2u);
}
}  // namespace test_solve_newton
