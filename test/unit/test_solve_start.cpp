// SPDX-License-Identifier: BSD-3-Clause
// How soon a start is found: its first guess and its continuation are worth counting, a result that is right all the same hides
// them.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/model/evaluate.h"
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

// A bend may be held on an edge of its hole, from which only the friction of the walls keeps it: neither at rest nor lowered does
// it jump.
TEST(Start, ofASlideStaysInItsToolface)
{
  struct Slide
  {
    double inclination, bend, toolface, friction;  // [deg, deg, deg, -]
  };
  for (const Slide& s : {Slide{0.0, 1.3, 115.0, 0.12},
                         {3.0, 1.6, -140.0, 0.2},
                         {12.0, 2.0, -60.0, 0.1},
                         {45.0, 1.0, 180.0, 0.3},
                         {90.0, 1.7, 135.0, 0.25},
                         {90.0, 1.1, 0.0, 0.1}})
  {
    const double inclination = s.inclination * degree;
    Scene scene = scene_in({{0.0, 0.0, 1.0}, {100.0, 0.0, 1.0}, {400.0, inclination, 1.0}, {500.0, inclination, 1.0}}, 500.0,
                           499.0, s.friction);
    scene.string = {bit_part(0.2159), motor_part(s.bend * degree), mwd_part(), pipe_part(0, 9.5, tool_jointed_mass)};
    scene.start.toolface = s.toolface * degree;
    Simulator rig(scene);
    const auto off = [&]
    { return std::abs(std::remainder(rig.truth().bend_toolface - scene.start.toolface, 2.0 * pi)) / degree; };
    for (int k = 0; k < 2000; ++k)
    {
      if (k == 1000) rig.command(WinchSetpoint{-0.02, false});
      ASSERT_EQ(FrameStatus::running, rig.frame(0.01)) << rig.failure();
      ASSERT_LT(off(), 0.2) << s.inclination << " deg, " << s.toolface << " deg, at " << 0.01 * k << " s";
    }
  }
}

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

// Slant from the surface on, the string leans and bends where it enters: the bit does not reach as much farther as the string is
// longer.
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
    EXPECT_NEAR(bit_depth(*rig.model, rig.state), scene.well.hole_depth, 5e-5)
        << file << ": a tilted ball touches beside its face's middle";
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

// The motor holds what the rock holds below: nothing moves until a set point is given.
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

// A bent motor in a hole that inclines from the surface on: the string leans on the table's edge, and its length is found all the
// same.
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

namespace
{
/// The start is the string's own equilibrium, at the scene's toolface and without anything that holds it.
void expect_start(const Scene& scene)
{
  const RigAtRest rig = build_at_rest(scene);
  EXPECT_LT(rig.statics.residual, 1e-6 * rig.statics.top_force);
  EXPECT_LT(std::abs(rig.statics.holding_torque), 1e-2);
  EXPECT_NEAR(std::remainder(bend_toolface(*rig.model, rig.state) - scene.start.toolface, 2.0 * pi), 0.0, 1e-4)
      << scene.start.toolface / degree;
  Stage stage(*rig.model);
  Workspace work(*rig.model);
  std::vector<double> residual(6 * rig.state.nodes.size()), there(residual.size(), 0.0);
  begin_static(*rig.model, rig.state, no_sliding, 0.0, stage);
  evaluate_static(*rig.model, rig.state, stage, there.data(), work, residual.data(), nullptr);
  for (const double force : residual)
    EXPECT_LT(std::abs(force), 1e-6 * rig.statics.top_force) << "out of balance where it was found";
}

/// Light pipe of aluminium, soft in torsion.
PartSpec light_pipe()
{
  PartSpec pipe = pipe_part(0, 9.3, 17.5, 0.172);
  pipe.outer_diameter = 0.147;
  pipe.inner_diameter = 0.121;
  pipe.young_modulus = 71e9;
  pipe.poisson_ratio = 0.33;
  pipe.density = 2800.0;
  return pipe;
}

/// A bent motor in an S-shaped hole that ends with this inclination.
Scene s_shaped_scene(double last, double bend)
{
  Scene scene = scene_in({{0.0, 0.0, 3.7},
                          {160.0, 0.0, 3.7},
                          {360.0, 27.0 * degree, 3.7},
                          {530.0, 27.0 * degree, 3.7},
                          {710.0, last, 3.7},
                          {1370.0, last, 3.7}},
                         1370.0, 1369.6, 0.2);
  scene.string = {bit_part(0.2159), motor_part(bend), collar_part(2, 9.4), light_pipe()};
  return scene;
}
}  // namespace

// A bent tool's axis swings about the 5 deg at which the toolface's reference changes: it is the hole's that decides.
TEST(Start, everyToolfaceWhereItsReferenceChanges)
{
  for (const double last : {4.0, 4.9, 5.1, 6.0})
    for (const double toolface : {0.0, 90.0, 180.0, -135.0})
    {
      Scene scene = s_shaped_scene(last * degree, 1.27 * degree);
      scene.start.toolface = toolface * degree;
      expect_start(scene);
    }
}

// A large bend below a long string turns away from most toolfaces, and a turned top makes it jump past them.
TEST(Start, everyToolfaceOfALargeBendBelowASoftString)
{
  for (const double toolface : {0.0, 45.0, 90.0, 135.0, 180.0, -45.0, -90.0, -135.0})
  {
    Scene scene = s_shaped_scene(12.0 * degree, 2.2 * degree);
    scene.start.toolface = toolface * degree;
    expect_start(scene);
  }
}

// Light pipe that pushes a packed assembly along buckles, and snaps from one side of its hole to the other on the way to its
// equilibrium.
TEST(Start, compressedPipeThatSnaps)
{
  for (const double weight : {20e3, 30e3, 37e3, 45e3})
    for (const int joints : {3, 6, 10})
    {
      Scene scene = scene_in(build_and_hold(195.0, 90.0 * degree / 289.0, 90.0 * degree, 5.3, 750.0), 750.0, 750.0, 0.2);
      PartSpec heavy = pipe_part(joints, 9.5, 62.0, 0.159);
      heavy.outer_diameter = 0.1143;
      heavy.inner_diameter = 0.0699;
      scene.string = {bit_part(0.2159), collar_part(3, 9.4), heavy, light_pipe()};
      scene.mud.density = 1640.0;
      scene.start.weight_on_bit = weight;
      const RigAtRest rig = build_at_rest(scene);
      EXPECT_LT(rig.statics.residual, 1e-6 * weight);
      EXPECT_NEAR(rig.statics.forces.wob, weight, 0.01 * weight);
    }
}

// With nearly all of its weight on the bit, light pipe buckles from one shape into another one: placed anew at each length the
// string has every weight but the scene's.
TEST(Start, aWeightBetweenTwoBuckledShapes)
{
  for (const double weight : {214e3, 231e3})
  {
    Scene scene = read_scene(in_source("test/scenes/buckled_start.yaml"));
    scene.start.weight_on_bit = weight;
    const RigAtRest rig = build_at_rest(scene);
    EXPECT_NEAR(rig.statics.forces.wob, weight, 1e-3 * weight);
    EXPECT_LT(rig.statics.residual, 1e-6 * weight);
  }
}

}  // namespace drill_rig_sim::test_solve_start
