// SPDX-License-Identifier: BSD-3-Clause
// Guided nodes: tangent, equilibria, waves and energy of strings that are confined to their hole, wholly or in part.
#include <gtest/gtest.h>

#include <cmath>

#include "tangent_check.h"

namespace test_model_guided
{
using namespace drill_rig_sim;

namespace
{
/// Built to 40 deg, then held.
Scene built_and_held(Level level, double free_length = 0.0)
{
  Scene scene = scene_in(build_and_hold(40.0, 0.15 * degree, 40.0 * degree, 2.0, 500.0), 500.0, 400.0, 0.3);
  scene.contact.static_ratio = 1.3;
  scene.contact.stribeck_speed = 0.3;
  scene.numerics.level = level;
  scene.numerics.free_length = free_length;
  return scene;
}

int guided_nodes(const State& state)
{
  return static_cast<int>(
      std::count_if(state.nodes.begin(), state.nodes.end(), [](const NodeState& node) { return node.guided; }));
}

/// Where a beam ends in a guided node that slides through a bend, the node tilts within the step, by w s, some 1e-6 here; the
/// tangent is exact at none (ModelTangent, errorGrowsNoFasterThanTheTiltOfTheStep).
constexpr double of_tilt = 1e-5;

/// Where the load on the wall changes sides it does so within a newton: less than elsewhere [m, rad].
constexpr double guided_difference = 1e-7;

void expect_exact_in_motion(Rig& rig, double tolerance = 1e-6)
{
  rig.run(1.0);
  expect_exact(rig, guided_difference, tolerance);
  rig.setpoints.winch = {-0.2, false};
  rig.run(3.0);
  expect_exact(rig, guided_difference, tolerance);
  rig.setpoints.top_drive.speed = 30.0 * rpm;
  rig.run(3.0);
  expect_exact(rig, guided_difference, tolerance);
}
}  // namespace

TEST(ModelGuided, tangentOfAStringGuidedThroughout)
{
  Rig rig(built_and_held(Level::axial_torsional));
  EXPECT_EQ(guided_nodes(rig.rest.state), rig.rest.model->nodes());
  expect_exact_in_motion(rig);
}

TEST(ModelGuided, tangentOfAStringThatIsFreeBelow)
{
  Rig rig(built_and_held(Level::hybrid, 60.0));
  EXPECT_GT(guided_nodes(rig.rest.state), 30);
  EXPECT_LT(guided_nodes(rig.rest.state), rig.rest.model->nodes() - 5);
  expect_exact_in_motion(rig);
}

TEST(ModelGuided, tangentWhereAPartInTheMiddleIsFree)
{
  Rig rig(built_and_held(Level::axial_torsional));
  for (int i = 8; i < 14; ++i) rig.rest.state.nodes[i].guided = false;
  rig.rest.state.nodes[17].guided = false;  // one alone
  expect_exact_in_motion(rig, of_tilt);
}

TEST(ModelGuided, tangentWithAStuckPoint)
{
  Rig rig(built_and_held(Level::axial_torsional));
  rig.run(0.5);
  pull_at_stuck_point(rig, 5);
  expect_exact(rig);
}

TEST(ModelGuided, tangentInTheSlips)
{
  Rig rig(built_and_held(Level::axial_torsional));
  rest_in_slips(rig, rig.rest.model->top() - 2);
  expect_exact(rig, guided_difference);
}

TEST(ModelGuided, tangentOnBottom)
{
  Scene scene = drilling_scene(0.002);
  scene.numerics.level = Level::axial_torsional;
  Rig rig(scene);
  rig.setpoints.top_drive.speed = 90.0 * rpm;
  rig.run(1.0);
  rig.setpoints.winch = {-0.012, false};
  rig.run(7.0);
  EXPECT_GT(rig.stepper.find_forces(rig.rest.state).wob, 1000.0);
  expect_exact(rig);
}

TEST(ModelGuided, tangentOfStatics)
{
  for (const double free_length : {-1.0, 60.0, 415.0})  // none, some, all but the top
    for (const SlidingMotion mode : {no_sliding, sliding_up, sliding_around})
    {
      RigAtRest rig =
          build_at_rest(free_length < 0.0 ? built_and_held(Level::axial_torsional) : built_and_held(Level::hybrid, free_length));
      EXPECT_NEAR(rig.state.nodes.back().position.z(), 20.0, 1e-9) << "the block's height";
      Problem problem(rig, evaluate_static);
      begin_static(problem.model, problem.start, mode, 0.0, problem.stage);
      EXPECT_LT(worst_column(problem, VectorXd::Zero(6 * rig.model->nodes()), tangent_difference, 1), 1e-5)
          << "places 400 m away are rounded to 6e-14 m";
    }
}
}  // namespace test_model_guided
