// How soon a start is found: its first guess and its continuation are worth counting, a result that is right all the same hides them.
#include <gtest/gtest.h>

#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/scene/read_scene.h"
#include "drill_rig_sim/sim/simulator.h"
#include "drill_rig_sim/solve/start.h"
#include "in_source.h"
#include "test_scenes.h"

namespace drill_rig_sim::test_solve_start
{
namespace
{
int iterations_of(const Scene& scene)
{
  const RigAtRest rig = build_at_rest(scene);
  EXPECT_TRUE(rig.statics.converged);
  return rig.statics.iterations;
}

/// Bent motor and survey tool below pipe in a straight hole at 60 deg.
Scene steep_scene()
{
  Scene scene = scene_in({{0.0, 60.0 * degree, 1.0}, {500.0, 60.0 * degree, 1.0}}, 500.0, 490.0, 0.2);
  scene.string = {bit_part(0.2159), motor_part(), mwd_part(), pipe_part(0, 9.5, tool_jointed_mass)};
  return scene;
}

void expect_refusal(const Scene& scene, const std::string& word)
{
  try
  {
    build_at_rest(scene);
    FAIL() << "was accepted";
  }
  catch (const std::runtime_error& error)
  {
    EXPECT_NE(std::string::npos, std::string(error.what()).find(word)) << error.what();
  }
}
}  // namespace

TEST(Start, aLongVerticalString)
{
  EXPECT_LE(iterations_of(vertical_scene(4000.0, 3990.0)), 395);
}

TEST(Start, aStringOnTheLowSide)
{
  EXPECT_LE(iterations_of(slanted_scene(150.0, 0.2)), 65);
}

TEST(Start, aBentMotorInASteepHole)
{
  EXPECT_LE(iterations_of(steep_scene()), 395);
}

TEST(Start, aBuiltHole)
{
  Scene scene = scene_in(build_and_hold(100.0, 3.0 * degree / 30.0, 60.0 * degree, 5.2, 1000.0), 1000.0, 990.0, 0.2);
  EXPECT_LE(iterations_of(scene), 32);
}

TEST(Start, weightOnBit)
{
  Scene scene = drilling_scene();
  scene.start.bit_depth = scene.well.hole_depth;
  scene.start.weight_on_bit = 20e3;
  EXPECT_LE(iterations_of(scene), 17);
}

// Slant from the surface on, the string leans and bends where it enters: the bit does not reach as much farther as the string is longer.
TEST(Start, aSlantHoleFromTheSurface)
{
  for (const double weight : {0.0, 3e3, 10e3, 20e3})
    for (const int collars : {2, 4})
    {
      Scene scene = slanted_scene(200.0, 0.2);
      scene.string.insert(scene.string.begin() + 1, collar_part(collars, 9.4));
      scene.start.weight_on_bit = weight;
      if (weight == 0.0) scene.start.bit_depth = 199.0;
      const RigAtRest rig = build_at_rest(scene);
      EXPECT_NEAR(rig.statics.forces.wob, weight, 1e-4 * weight) << collars;
      EXPECT_NEAR(bit_depth(*rig.model, rig.state), weight > 0.0 ? 200.0 : 199.0, 2e-3) << collars;
    }
}

// On bottom without weight is where the face touches: a string too long by a micron would weigh several newtons on it.
TEST(Start, onBottomWithoutWeightTheBitJustTouches)
{
  for (const char* file : {"test/stability/scenes/inclined.yaml", "config/scenes/bohai.yaml", "config/scenes/quick.yaml"})
  {
    Scene scene = read_scene(in_source(file));
    scene.start.bit_depth = scene.well.hole_depth;
    scene.start.weight_on_bit = scene.start.torque_on_bit = 0.0;
    const RigAtRest rig = build_at_rest(scene);
    EXPECT_LT(rig.statics.forces.wob, 20.0) << file;
    EXPECT_NEAR(bit_depth(*rig.model, rig.state), scene.well.hole_depth, 5e-5) << file << ": a tilted ball touches beside its face's middle";
  }
}

TEST(Start, whatTheWinchMayNotLiftIsRefused)
{
  Scene scene = drilling_scene();
  const RigAtRest rig = build_at_rest(scene);
  const double hook_load = rig.statics.top_force + standard_gravity * scene.rig.hoisting.block_mass;
  scene.rig.hoisting.max_hook_load = 1.01 * hook_load;
  EXPECT_NO_THROW(build_at_rest(scene));
  scene.rig.hoisting.max_hook_load = 0.99 * hook_load;
  expect_refusal(scene, "max_hook_load");
}

// Torque is what weight holds: without it there is none.
TEST(Start, torqueOnBitWithoutWeightIsRefused)
{
  Scene scene = drilling_scene();
  scene.start.bit_depth = scene.well.hole_depth;
  scene.start.torque_on_bit = 500.0;
  EXPECT_THROW(build_at_rest(scene), std::runtime_error);
}

// The motor holds what the rock holds below: nobody moves until somebody is told to.
TEST(Start, aStringStartedWithTorqueStaysAtRest)
{
  Scene scene = drilling_scene();
  scene.start.bit_depth = scene.well.hole_depth;
  scene.start.weight_on_bit = 30e3;
  scene.start.torque_on_bit = 500.0;
  Simulator rig(scene);
  for (int k = 0; k < 300; ++k)
  {
    ASSERT_EQ(rig.frame(0.01), FrameStatus::running);
    ASSERT_NEAR(500.0, rig.truth().torque, 5.0) << k;
    ASSERT_NEAR(0.0, rig.truth().top_drive_speed, 1e-4) << k;
  }
}

// A bent motor in a hole that inclines from the surface on: the string leans on the table's edge, and its length is found all the same.
TEST(Start, aBentMotorInAHoleThatInclinesFromTheSurface)
{
  Scene scene = slanted_scene(150.0, 0.3);
  scene.well.hole_depth = 150.0;
  scene.well.sections[0].to = 150.0;
  scene.string.insert(scene.string.begin() + 1, motor_part());
  const RigAtRest rig = build_at_rest(scene);
  EXPECT_NEAR(bit_depth(*rig.model, rig.state), 150.0, 1e-3);
}

// Iterations of both of its parts are bounded by what the caller grants, but for the one that KINSOL takes at least.
TEST(Start, anEquilibriumTakesNoMoreIterationsThanAllowed)
{
  const RigAtRest rig = build_at_rest(slanted_scene(150.0, 0.2));
  for (const int most : {3, 8})
  {
    State state = rig.state;
    for (NodeState& node : state.nodes) node.position.z() += 0.3 * std::sin(node.position.z());
    const StaticOutcome out = solve_static(*rig.model, state, no_sliding, most);
    EXPECT_FALSE(out.converged);
    EXPECT_GE(out.iterations, most);
    EXPECT_LE(out.iterations, most + 1);
  }
  State state = rig.state;
  EXPECT_TRUE(solve_static(*rig.model, state, no_sliding, 400).converged);
}

// The continuation takes inertia back where a step was too long: without it this start is not found.
TEST(Start, onWallsOfTheGreatestStiffness)
{
  EXPECT_LE(iterations_of(read_scene(in_source("test/stability/scenes/inclined.yaml"), {"contact.stiffness=1e13"})), 450);
}

}  // namespace drill_rig_sim::test_solve_start
