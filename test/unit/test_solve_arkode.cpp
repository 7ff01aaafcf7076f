// SPDX-License-Identifier: BSD-3-Clause
// SUNDIALS ARKODE as a stepper: its order, and that it goes where our own steppers go.
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <string>

#include "drill_rig_sim/compared/arkode_stepper.h"
#include "drill_rig_sim/crew/player.h"
#include "drill_rig_sim/math/rotation.h"
#include "drill_rig_sim/scene/read_scene.h"
#include "drill_rig_sim/sim/simulator.h"
#include "drill_rig_sim/solve/start.h"
#include "drill_rig_sim/solve/stepper.h"
#include "in_source.h"
#include "plucked_rig.h"
#include "sim_numbers.h"
#include "test_scenes.h"

namespace test_solve_arkode
{
using namespace drill_rig_sim;
using Eigen::Vector3d;

namespace
{
Eigen::VectorXd after_arkode(const RigAtRest& start, double step)
{
  ArkodeStepper stepper(start.model);
  stepper.limits().tolerance = 1e-12;
  return after_span(start, stepper, step);
}

Eigen::VectorXd after_own(const RigAtRest& start, IntegratorKind method, double step)
{
  Stepper stepper(start.model, find_method(method));
  stepper.limits().tolerance = 1e-12;
  return after_span(start, stepper, step);
}

constexpr double kFrame = 0.01;

Scene quick_scene(IntegratorKind integrator)
{
  Scene scene = read_scene(in_source("config/scenes/quick.yaml"));
  scene.numerics.integrator = integrator;
  return scene;
}

/// What a driller reads: means over a window.
struct Drilling
{
  double wob = 0.0, torque = 0.0, bit_torque = 0.0, hook_load = 0.0, depth = 0.0, rejected = 0.0;
};

Drilling drill(IntegratorKind integrator, double from, double to)
{
  const Scene scene = quick_scene(integrator);
  Simulator rig(scene);
  ScenePlayer program(scene);
  Drilling mean;
  double frames = 0.0;
  while (rig.truth().time < to)
  {
    program.apply(rig);
    EXPECT_EQ(rig.frame(kFrame), FrameStatus::running) << rig.failure();
    const Truth& m = rig.truth();
    if (m.time < from) continue;
    mean.wob += m.wob;
    mean.torque += m.torque;
    mean.bit_torque += m.bit_torque;
    mean.hook_load += m.hook_load;
    ++frames;
  }
  for (double* sum : {&mean.wob, &mean.torque, &mean.bit_torque, &mean.hook_load}) *sum /= frames;
  mean.depth = rig.truth().hole_depth;
  mean.rejected = static_cast<double>(rig.statistics().convergence_failures);
  return mean;
}
}  // namespace

class Arkode : public testing::Test
{
protected:
  void SetUp() override
  {
    if (!ArkodeStepper::available()) GTEST_SKIP() << "this build's SUNDIALS is older than 6";
  }
};

TEST(ArkodeStepper, isThereOrRefusedWithItsReason)
{
  const RigAtRest start = plucked();
  std::string reason;
  try
  {
    ArkodeStepper stepper(start.model);
  }
  catch (const std::runtime_error& error)
  {
    reason = error.what();
  }
  if (ArkodeStepper::available())
    EXPECT_EQ(reason, "");
  else
    EXPECT_EQ(reason.find("numerics.integrator: arkode_dirk is not available in this build: it needs SUNDIALS 6"), 0u) << reason;
}

// Steps in the ratio 1 : 2 : 4, the coarsest 1 ms.
TEST_F(Arkode, isOfSecondOrder)
{
  const RigAtRest start = plucked();
  const Eigen::VectorXd fine = after_arkode(start, 0.00025), middle = after_arkode(start, 0.0005),
                        coarse = after_arkode(start, 0.001);
  EXPECT_NEAR(std::log2((coarse - middle).norm() / (middle - fine).norm()), 2.0, 0.1);
}

TEST_F(Arkode, goesToTheSolutionOfBdf2)
{
  const RigAtRest start = plucked();
  const Eigen::VectorXd reference = after_own(start, IntegratorKind::bdf2, 0.00005);
  const double scale = (reference - after_own(start, IntegratorKind::bdf2, plucked_span)).norm();
  EXPECT_LT((after_arkode(start, 0.00005) - reference).norm(), 1e-3 * scale);
}

// One formula, two codes. Ours carries the acceleration over from the step before where ARKODE evaluates it: the same but for the
// turn of the axes within a step and what Newton's method leaves.
TEST_F(Arkode, agreesWithOurTrBdf2AtEveryStep)
{
  const RigAtRest start = plucked();
  for (double step : {0.005, 0.001})
    EXPECT_LT((after_arkode(start, step) - after_own(start, IntegratorKind::trbdf2, step)).norm(), 1e-7 * (1e-3 / step)) << step;
}

// Contact, friction, the breaking rock, the rotor's loop: all that the plucked string has not. Ten seconds on bottom.
TEST_F(Arkode, drillsAsOurTrBdf2Does)
{
  const Drilling ours = drill(IntegratorKind::trbdf2, 45.0, 55.0), theirs = drill(IntegratorKind::arkode_dirk, 45.0, 55.0);
  EXPECT_GT(ours.wob, 1e3);
  EXPECT_GT(ours.depth, 100.1);
  EXPECT_EQ(theirs.rejected, 0.0);
  EXPECT_NEAR(theirs.wob, ours.wob, 1e-3 * ours.wob);
  EXPECT_NEAR(theirs.torque, ours.torque, 1e-3 * ours.torque);
  EXPECT_NEAR(theirs.bit_torque, ours.bit_torque, 1e-3 * ours.bit_torque);
  EXPECT_NEAR(theirs.hook_load, ours.hook_load, 1e-4 * ours.hook_load);
  EXPECT_NEAR(theirs.depth, ours.depth, 1e-5);
}

// Nothing that ARKODE remembers reaches the next step.
// Beside those of Newton's method with their tangents, a step takes two evaluations: the rates at its start, and its end's
// results.
TEST_F(Arkode, aStepEvaluatesNothingTwice)
{
  const RigAtRest start = plucked();
  ArkodeStepper stepper(start.model);
  after_span(start, stepper, 0.001);
  const Work& work = stepper.work();
  EXPECT_EQ(work.solves, work.tangents);
  EXPECT_EQ(work.solves, stepper.counters().newton_iterations);
  EXPECT_EQ(work.residuals - work.tangents, 2 * stepper.counters().steps);
  EXPECT_LT(static_cast<double>(work.solves), 3.0 * static_cast<double>(stepper.counters().steps))
      << "smooth: fewer than two a stage";
}

TEST_F(Arkode, goesOnBitByBitFromASnapshot)
{
  const Scene scene = quick_scene(IntegratorKind::arkode_dirk);
  Simulator rig(scene);
  ScenePlayer program(scene);
  auto go_on = [&](int frames)
  {
    for (int k = 0; k < frames; ++k)
    {
      program.apply(rig);
      ASSERT_EQ(rig.frame(kFrame), FrameStatus::running) << rig.failure();
    }
  };
  go_on(4000);
  ASSERT_TRUE(rig.truth().on_bottom);
  const auto middle = rig.save();
  go_on(300);
  const auto end = rig.save();
  rig.restore(*middle);
  go_on(300);
  EXPECT_TRUE(bit_identical(numbers_of(rig.save()->mechanics), numbers_of(end->mechanics)));

  Simulator other(scene);
  other.restore(*middle);
  for (int k = 0; k < 300; ++k) ASSERT_EQ(other.frame(kFrame), FrameStatus::running);
  EXPECT_TRUE(bit_identical(numbers_of(other.save()->mechanics), numbers_of(end->mechanics)));
}

// A step that is far too long for Newton's method is halved, or refused with the state as it was.
TEST_F(Arkode, stepsThatCannotBeSolvedLeaveAFiniteState)
{
  const RigAtRest start = plucked();
  State state = start.state;
  for (NodeState& node : state.nodes) node.rate.velocity = Vector3d(300.0, 0.0, -300.0);
  ArkodeStepper stepper(start.model);
  stepper.advance(state, 0.1, Setpoints());
  EXPECT_GT(stepper.counters().convergence_failures, 0u);
  EXPECT_LE(stepper.counters().newton_iterations, 240u) << "the budget of a step with all its parts";
  EXPECT_TRUE(all_finite(numbers_of(state)));
  state = start.state;
  EXPECT_TRUE(stepper.advance(state, 0.005, Setpoints())) << "and the next one from a good state is solved";
}
}  // namespace test_solve_arkode
