// SPDX-License-Identifier: BSD-3-Clause
// Variable steps: the local error that steers them, how the steps follow the tolerance, and what impacts do to them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "drill_rig_sim/model/evaluate.h"
#include "drill_rig_sim/solve/stepper.h"
#include "plucked_rig.h"
#include "test_scenes.h"

namespace test_solve_step_control
{
using namespace drill_rig_sim;

namespace
{
std::shared_ptr<const Model> with_numerics(const RigAtRest& rig, double step, double tolerance)
{
  Scene scene = rig.model->scene();
  scene.numerics.step = step;
  scene.numerics.tolerance = tolerance;
  return build_at_rest(scene).model;
}

/// Largest difference of the nodes' places [m].
double distance(const State& a, const State& b)
{
  double most = 0.0;
  for (std::size_t i = 0; i < a.nodes.size(); ++i)
    most = std::max(most, (a.nodes[i].position - b.nodes[i].position).cwiseAbs().maxCoeff());
  return most;
}

/// Lengths of the steps in `span` [s] of a plucked string.
std::vector<double> steps_of_plucked(double tolerance, double span)
{
  const RigAtRest rig = plucked();
  const auto model = with_numerics(rig, 0.0, tolerance);
  Stepper stepper(model, bdf2);
  State state = rig.state;
  std::vector<double> out;
  for (double frame = 0.05; state.time < span - 1e-9;)
  {
    const std::uint64_t before = stepper.counters().steps;
    EXPECT_TRUE(stepper.advance(state, frame, Setpoints()));
    out.insert(out.end(), stepper.counters().steps - before, frame / static_cast<double>(stepper.counters().steps - before));
  }
  return out;
}
}  // namespace

// A step of BDF2 from a history that a run of tiny steps has made, against that run.
TEST(StepControl, theDistanceToTheExtrapolationTellsTheLocalError)
{
  constexpr double tiny = 1e-5, before = 2e-3;
  const RigAtRest rig = plucked();
  Stepper fine(rig.model, bdf2);
  State a = rig.state;
  const auto play = [&](State& state, double span)
  {
    for (long k = 0; k < std::lround(span / tiny); ++k) ASSERT_TRUE(fine.advance(state, tiny, Setpoints()));
  };
  play(a, 0.04);
  State b = a;
  play(b, before);
  for (const double ratio : {0.5, 1.0, 2.0})
  {
    const double step = ratio * before;
    State exact = b, coarse = b, extrapolated = b;
    play(exact, step);
    coarse.memory.last_step = before;
    for (std::size_t i = 0; i < a.nodes.size(); ++i)
    {
      coarse.memory.past[0].nodes[i] = a.nodes[i].rate;
      coarse.memory.past[1].nodes[i] = {b.nodes[i].position - a.nodes[i].position, Eigen::Vector3d::Zero(),
                                        b.nodes[i].spin_angle - a.nodes[i].spin_angle};
    }
    coarse.memory.past[0].rotor = a.drive.speed;
    coarse.memory.past[1].rotor = b.drive.angle - a.drive.angle;
    std::vector<double> guess(6 * coarse.nodes.size());
    predict(coarse, step, guess.data());
    for (std::size_t i = 0; i < coarse.nodes.size(); ++i)
      extrapolated.nodes[i].position += Eigen::Map<const Eigen::Vector3d>(guess.data() + 6 * i);
    Stepper stepper(rig.model, bdf2);
    ASSERT_TRUE(stepper.advance(coarse, step, Setpoints()));
    const double told = bdf2.share_of_distance(ratio) * distance(coarse, extrapolated), is = distance(coarse, exact);
    EXPECT_GT(told, 0.4 * is) << ratio;
    EXPECT_LT(told, 2.5 * is) << ratio;
  }
}

// The error of smooth waves goes with h^2, and what is allowed with the tolerance to the power of 3/2: ten times the
// tolerance, 5.6 times the step; less where places, whose error goes with h^3, or what instruments resolve stand in the way.
TEST(StepControl, stepsGoWithTheTolerance)
{
  const auto mean = [](double tolerance)
  {
    const std::vector<double> steps = steps_of_plucked(tolerance, 4.0);
    return 4.0 / static_cast<double>(steps.size());
  };
  const double loose = mean(1e-1), tight = mean(1e-2);
  EXPECT_GT(loose / tight, 3.5);
  EXPECT_LT(loose / tight, 6.0);
}

/// What the control allows of a wave about the string, or along it, over what it allows by a tolerance of 2 % where all is
/// needed: outputs that have ranged so far that nothing but the rule is in the way.
double allowed(double tolerance, unsigned needs, bool about)
{
  const auto stretch_squared = [&](double t, unsigned n)
  {
    Scene scene = vertical_scene(400.0, 290.0);
    scene.numerics.tolerance = t;
    scene.needs = n;
    RigAtRest rig = build_at_rest(scene);
    rig.state.step.hook_load = {0.0, 1e7};
    rig.state.step.torque = {0.0, 1e6};
    rig.state.step.bit_speed = {0.0, 1e4};
    Stage stage(*rig.model);
    Workspace work(*rig.model);
    std::vector<double> u(6 * rig.state.nodes.size(), 0.0), residual(u.size()), error(u.size(), 0.0);
    begin_step(*rig.model, rig.state, default_step, Setpoints(), stage);
    prepare_implicit_euler(rig.state, default_step, stage);
    evaluate(*rig.model, rig.state, stage, u.data(), work, residual.data(), nullptr);
    const Eigen::Vector3d axis = work.nodes[5].axis;
    for (int c = 0; c < 3; ++c) error[6 * 5 + (about ? 3 : 0) + c] = (about ? 1e-3 : 1e-6) * axis[c];
    return std::pow(StepControl(*rig.model).stretch(rig.state, work, error.data(), 1e-8), 2);
  };
  return stretch_squared(tolerance, needs) / stretch_squared(0.02, every_need);
}

// The rule by itself: the power of 3/2 of the tolerance, ten times as much where the result is not in needs.
TEST(StepControl, waveErrorsAreAllowedByToleranceAndNeeds)
{
  for (const bool about : {false, true})
  {
    EXPECT_NEAR(allowed(0.04, every_need, about), std::pow(2.0, 1.5), 1e-9) << about;
    EXPECT_NEAR(allowed(0.005, every_need, about), std::pow(0.25, 1.5), 1e-9) << about;
  }
  EXPECT_NEAR(allowed(0.02, need_hook_load | need_wob, true), 10.0, 1e-9);
  EXPECT_NEAR(allowed(0.02, need_hook_load | need_wob, false), 1.0, 1e-9);
  EXPECT_NEAR(allowed(0.02, need_torque, true), 1.0, 1e-9);
  EXPECT_NEAR(allowed(0.02, need_torque, false), 10.0, 1e-9);
  EXPECT_NEAR(allowed(0.02, need_rop, true), 1.0, 1e-9);
}

// A string that begins to turn in its hole: a scene that needs only the hook load has longer steps.
TEST(StepControl, stepsGoWithTheNeeds)
{
  const auto steps = [](unsigned needs)
  {
    Scene scene = vertical_scene(400.0, 290.0);
    scene.numerics.step = 0.0;
    scene.needs = needs;
    const RigAtRest rig = build_at_rest(scene);
    Stepper stepper(rig.model, bdf2);
    State state = rig.state;
    Setpoints setpoints;
    setpoints.top_drive.speed = 120.0 * rpm;
    for (int k = 0; k < 60; ++k) EXPECT_TRUE(stepper.advance(state, longest_step, setpoints));
    return static_cast<double>(stepper.counters().steps);
  };
  const double of_all = steps(every_need);
  EXPECT_EQ(steps(need_torque), of_all);
  EXPECT_LT(steps(need_hook_load), 0.5 * of_all);
}

TEST(StepControl, aRestIsSteppedAsLongAsAllowed)
{
  const Scene scene = []
  {
    Scene s = vertical_scene(400.0, 290.0);
    s.numerics.step = 0.0;
    return s;
  }();
  const RigAtRest rig = build_at_rest(scene);
  Stepper stepper(rig.model, bdf2);
  State state = rig.state;
  for (int k = 0; k < 20; ++k) ASSERT_TRUE(stepper.advance(state, longest_step, Setpoints()));
  EXPECT_LT(stepper.counters().steps, 30u);
  EXPECT_NEAR(state.memory.last_step, longest_step, 1e-12);
}

// The ratio of steps stays where BDF2 is stable and remembers.
TEST(StepControl, stepsAtMostDouble)
{
  const std::vector<double> steps = steps_of_plucked(1e-3, 2.0);
  for (std::size_t k = 1; k < steps.size(); ++k) EXPECT_LT(steps[k], 2.3 * steps[k - 1]) << k;
}

TEST(StepControl, aBentMotorThatTurnsShortensTheLongestStep)
{
  Scene scene = motor_drilling_scene(0.005);
  scene.numerics.step = 0.0;
  const RigAtRest rig = build_at_rest(scene);
  const StepControl control(*rig.model);
  State state = rig.state;
  EXPECT_EQ(control.longest(state), longest_step);
  state.nodes[0].rate.spin = 120.0 * rpm;
  const double w = 3.0 * 120.0 * rpm, h = control.longest(state);
  EXPECT_NEAR(0.25 * std::pow(w * h, 4) / h, 5.0 * scene.numerics.tolerance, 1e-9);
}
}  // namespace test_solve_step_control
