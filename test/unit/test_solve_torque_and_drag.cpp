// SPDX-License-Identifier: BSD-3-Clause
// Pick-up, slack-off and rotating weights and torque: the static solution and the moving string against the soft string.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "drill_rig_sim/sim/simulator.h"
#include "drill_rig_sim/solve/start.h"
#include "soft_string.h"

namespace test_solve_torque_and_drag
{
using namespace drill_rig_sim;

namespace
{
struct Case
{
  const char* name;
  Scene scene;
  PlanarWell well;
};

/// Frictionless down to the end of the build, friction in the straight inclined hole below.
Case straight_inclined()
{
  const double kick_off = 50.0, rate = 0.1 * degree, inclination = 45.0 * degree, friction = 0.25;
  const double built = kick_off + inclination / rate;
  Scene scene = scene_in(build_and_hold(kick_off, rate, inclination, 2.0, 1000.0), 1000.0, 980.0, friction);
  scene.well.sections = {{built, 0.2159, 0.0}, {1000.0, 0.2159, friction}};
  PlanarWell well;
  well.inclination = [=](double md) { return std::clamp(rate * (md - kick_off), 0.0, inclination); };
  well.build_rate = [=](double md) { return md > kick_off && md < built ? rate : 0.0; };
  well.friction = [=](double md) { return md > built ? friction : 0.0; };
  return {"straight inclined", scene, well};
}

/// 3 deg per 30 m from the surface to 60 deg, friction everywhere.
Case constant_curvature()
{
  const double rate = 0.1 * degree, friction = 0.25;
  Scene scene = scene_in(build_and_hold(0.0, rate, 60.0 * degree, 0.8, 600.0), 600.0, 590.0, friction);
  PlanarWell well;
  well.inclination = [=](double md) { return rate * md; };
  well.build_rate = [=](double) { return rate; };
  well.friction = [=](double) { return friction; };
  return {"constant curvature", scene, well};
}

/// Built to 20 deg and dropped again, rough; below it pipe hangs free. Friction in the bends twists the string by 6 rad.
Case twisted()
{
  const double rate = 20.0 * degree / 400.0, friction = 1.0;
  const std::vector<SurveyStation> survey = {
      {0.0, 0.0, 0.8},    {100.0, 0.0, 0.8}, {500.0, 20.0 * degree, 0.8}, {600.0, 20.0 * degree, 0.8},
      {1000.0, 0.0, 0.8}, {1500.0, 0.0, 0.8}};
  PlanarWell well;
  well.inclination = [=](double md) { return std::clamp(rate * std::min(md - 100.0, 1000.0 - md), 0.0, 20.0 * degree); };
  well.build_rate = [=](double md) { return md > 100.0 && md < 500.0 ? rate : md > 600.0 && md < 1000.0 ? -rate : 0.0; };
  well.friction = [=](double) { return friction; };
  return {"twisted", scene_in(survey, 1500.0, 1490.0, friction), well};
}

SlidingMotion mode_of(Sliding sliding)
{
  switch (sliding)
  {
    case Sliding::up:
      return sliding_up;
    case Sliding::down:
      return sliding_down;
    case Sliding::rotate:
      return sliding_around;
    default:
      return no_sliding;
  }
}

const char* name_of(Sliding sliding)
{
  return sliding == Sliding::up ? "up" : sliding == Sliding::down ? "down" : sliding == Sliding::rotate ? "rotate" : "none";
}

/// The two levels that each model the whole string alike.
std::vector<Case> at_both_levels(const std::vector<Case>& cases)
{
  std::vector<Case> out = cases;
  for (Case guided : cases)
  {
    guided.scene.numerics.level = Level::axial_torsional;
    out.push_back(guided);
  }
  return out;
}

std::string named(const Case& c, Sliding sliding)
{
  return std::string(c.name) + (c.scene.numerics.level == Level::axial_torsional ? ", guided, " : ", ") + name_of(sliding);
}

SoftStringResult expected(const Case& c, Sliding sliding)
{
  return soft_string(c.scene, c.well, c.scene.start.bit_depth, c.scene.start.block_height, sliding);
}

/// Mean hook load of the string and torque of a rig that moves slowly.
SoftStringResult moving(const Case& c, Sliding sliding)
{
  Scene scene = c.scene;
  scene.rig.hoisting.rail_friction = 0.0;  // of the string alone
  scene.numerics.step = 0.01;
  Simulator rig(scene);
  const Truth& m = rig.truth();
  if (sliding == Sliding::rotate)
  {
    TopDriveSetpoint drive;
    drive.speed = 30.0 * rpm;
    rig.command(drive);
  }
  else
    rig.command(WinchSetpoint{sliding == Sliding::up ? 0.1 : -0.1, false});
  const double settle = 8.0, window = 8.0, frame = 0.01;
  SoftStringResult mean{0.0, 0.0};
  const int count = static_cast<int>(window / frame);
  for (int k = 0; k < settle / frame; ++k) EXPECT_EQ(rig.frame(frame), FrameStatus::running);
  for (int k = 0; k < count; ++k)
  {
    EXPECT_EQ(rig.frame(frame), FrameStatus::running);
    mean.hook_load += m.hook_load_string / count;
    mean.torque += m.torque / count;
  }
  return mean;
}
}  // namespace

// By hand: the hold's friction alone, mu w sin I per metre, added to the weight over the true vertical depth.
TEST(SoftString, straightHoleIsTheTextbookSum)
{
  const Case c = straight_inclined();
  const double buoyancy = 1.0 - c.scene.mud.density / steel_density;
  const double w = standard_gravity * tool_jointed_mass * buoyancy;
  const double bit = standard_gravity * 40.0 * buoyancy;
  const double radius = 450.0 / (45.0 * degree);  // of the build
  const double root = std::sqrt(0.5);
  const double vertical = 50.0 + radius * root + (979.7 - 500.0) * root;
  const double still = w * vertical + bit * root + standard_gravity * tool_jointed_mass * 20.0;
  const double drag = 0.25 * (w * (979.7 - 500.0) + bit) * root;
  EXPECT_NEAR(expected(c, Sliding::none).hook_load, still, 1e-4 * still);
  EXPECT_NEAR(expected(c, Sliding::up).hook_load, still + drag, 1e-4 * still);
  EXPECT_NEAR(expected(c, Sliding::down).hook_load, still - drag, 1e-4 * still);
}

// Seen: 0.05 % in hook load, 0.5 % in torque. 1 %: the stiff string leans on its joints alone, bends at the ends of the build,
// and has a clearance.
TEST(TorqueAndDrag, staticSolutionAgreesWithTheSoftString)
{
  for (const Case& c : at_both_levels({straight_inclined(), constant_curvature()}))
  {
    RigAtRest rig = build_at_rest(c.scene);
    for (Sliding sliding : {Sliding::none, Sliding::up, Sliding::down, Sliding::rotate})
    {
      State state = rig.state;
      const StaticOutcome out = solve_static(*rig.model, state, mode_of(sliding));
      ASSERT_TRUE(out.converged) << named(c, sliding);
      const SoftStringResult soft = expected(c, sliding);
      EXPECT_NEAR(out.top_force, soft.hook_load, 0.01 * soft.hook_load) << named(c, sliding);
      EXPECT_NEAR(out.top_torque, soft.torque, 0.01 * soft.torque + 1.0) << named(c, sliding);
    }
  }
}

// Turned along by 0.02 rad a step, as far as a step may tilt a node, the lower pipe would be left too few steps to settle.
// Bounds: of the weight as above; of the torque 2 %, for clearance takes 2 acos(1 - c/R) = 0.74 deg off the 40 deg of the bends.
TEST(TorqueAndDrag, manyRadiansOfTwistAreFound)
{
  for (const Case& c : at_both_levels({twisted()}))
  {
    RigAtRest rig = build_at_rest(c.scene);
    const StaticOutcome out = solve_static(*rig.model, rig.state, sliding_around);
    ASSERT_TRUE(out.converged) << named(c, Sliding::rotate);
    const SoftStringResult soft = expected(c, Sliding::rotate);
    EXPECT_NEAR(out.top_force, soft.hook_load, 0.01 * soft.hook_load) << named(c, Sliding::rotate);
    EXPECT_NEAR(out.top_torque, soft.torque, 0.02 * soft.torque) << named(c, Sliding::rotate);
  }
}

TEST(TorqueAndDrag, movingStringAgreesWithTheSoftString)
{
  for (const Case& c : at_both_levels({straight_inclined(), constant_curvature()}))
    for (Sliding sliding : {Sliding::up, Sliding::down, Sliding::rotate})
    {
      const SoftStringResult soft = expected(c, sliding), run = moving(c, sliding);
      EXPECT_NEAR(run.hook_load, soft.hook_load, 0.01 * soft.hook_load) << named(c, sliding);
      if (sliding != Sliding::rotate) continue;
      EXPECT_NEAR(run.torque, soft.torque, 0.01 * soft.torque) << named(c, sliding);
    }
}
}  // namespace test_solve_torque_and_drag
