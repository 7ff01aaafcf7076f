// SPDX-License-Identifier: BSD-3-Clause
// What is reported of a string at rest or in slow motion: weights by hand, the bit's tilt and side force from its place in the
// hole.
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <string>
#include <tuple>

#include "drill_rig_sim/math/rotation.h"
#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/sim/profile.h"
#include "drill_rig_sim/solve/start.h"
#include "drill_rig_sim/well/directions.h"
#include "test_scenes.h"

namespace test_sim_static_report
{
using namespace drill_rig_sim;
using Eigen::Vector3d;

namespace
{
constexpr double weight_on_bit = 10e3;  // [N]

/// Two collars and pipe on the bottom of a slanted hole of 200 m.
Scene resting_string()
{
  Scene scene = slanted_scene(200.0, 0.2);
  scene.string.insert(scene.string.begin() + 1, collar_part(2, 9.4));
  scene.start.weight_on_bit = weight_on_bit;
  return scene;
}
}  // namespace

TEST(StaticReport, isOfTheBitAtTheStringsLowerEnd)
{
  const Scene scene = resting_string();
  const StaticReport report = static_report(scene, no_sliding);
  const RigAtRest rig = build_at_rest(scene);
  ASSERT_NE(report.profile.contact_side.front(), report.profile.contact_side.back());
  EXPECT_EQ(report.bit_side_force, rig.statics.forces.contact.front());
  EXPECT_EQ(report.bit_side_direction, report.profile.contact_side.front());
  EXPECT_GT(report.bit_side_force, 0.0);
  // the hole is straight: the angle between two directions, by its cosine
  const Vector3d axis = x_axis(rig.state.nodes.front().orientation), hole = tangent_from(slant, slant_azimuth);
  EXPECT_GT(report.bit_tilt, 1e-5);
  EXPECT_NEAR(std::cos(report.bit_tilt), axis.dot(hole), 1e-12);
  EXPECT_NEAR(std::sin(report.bit_tilt), axis.cross(hole).norm(), 1e-9);
  EXPECT_NEAR(report.hook_load - report.hook_load_string, standard_gravity * scene.rig.hoisting.block_mass, 1e-6);
}

// A string that friction stretches on its way up hangs as free of the bottom as it began.
TEST(StaticReport, isOffBottomWhereTheSceneIs)
{
  const double depth = 2000.0;
  const Scene near = scene_in(build_and_hold(100.0, 0.1 * degree, 60.0 * degree, 1.0, depth), depth, depth - 0.01, 0.4);
  const StaticReport up = static_report(near, sliding_up);
  EXPECT_LT(up.outcome.forces.wob, 1.0);
  Scene above = near;
  above.start.bit_depth = depth - 5.0;
  const StaticReport free = static_report(above, sliding_up);
  EXPECT_GT(up.hook_load, free.hook_load) << "five metres more of pipe, at 60 deg";
  EXPECT_LT(up.hook_load, free.hook_load + 2e3);
}

// Friction on the way up or down is the pipe's, not the bottom's: the bit goes on carrying the scene's weight.
TEST(StaticReport, holdsTheWeightOnBitInEachMotion)
{
  const Scene scene = resting_string();
  const StaticReport still = static_report(scene, no_sliding);
  for (const SlidingMotion& motion : {no_sliding, sliding_up, sliding_down, sliding_around})
  {
    const StaticReport report = static_report(scene, motion);
    const double tolerance = motion.still() ? 1e-2 : 1e-4;  // a start's; a motion's
    EXPECT_NEAR(report.outcome.forces.wob, weight_on_bit, tolerance * weight_on_bit);
    const double drag = report.hook_load - still.hook_load;
    EXPECT_EQ(drag > 100.0, motion.axial_speed < 0.0) << drag;
    EXPECT_EQ(drag<-100.0, motion.axial_speed> 0.0) << drag;
    EXPECT_EQ(report.torque > 1.0, motion.spin_speed > 0.0) << report.torque;
    EXPECT_EQ(report.torque, report.outcome.top_torque);
    EXPECT_EQ(report.hook_load_string, report.outcome.top_force);
  }
}

namespace
{
/// Pipe whose tool joints are no thicker than its body, as the soft string's, and three collars in a hole that is vertical to
/// `kick_off`, built at 9 deg/30 m and horizontal from there on.
StaticReport slacked_off(double kick_off, double depth, double friction)
{
  Scene scene =
      scene_in({{0.0, 0.0, 0.0}, {kick_off, 0.0, 0.0}, {kick_off + 300.0, 90.0 * degree, 0.0}, {3500.0, 90.0 * degree, 0.0}},
               depth + 10.0, depth, friction);
  scene.string.back().pipe->tool_joint_diameter = pipe_outer;
  scene.string.insert(scene.string.begin() + 1, collar_part(3, 9.4));
  scene.mud.density = 1200.0;
  return static_report(scene, sliding_down);
}
}  // namespace

// The soft string's hook loads, in pieces of 0.5 m, with what a helix presses against the wall, r F^2/(4 E I), where pipe is
// buckled. At 0.22 the whole of the vertical hole is, and the friction is raised by and by: in one go the search for a helix ends
// in another one, or never.
TEST(StaticReport, slackOffOfBuckledPipe)
{
  for (const auto& [friction, soft_string, buckled] : {std::tuple{0.05, 149.0e3, 0.0},
                                                       {0.08, 122.0e3, 24.0},
                                                       {0.10, 102.7e3, 95.0},
                                                       {0.12, 82.2e3, 176.0},
                                                       {0.15, 48.94e3, 305.0},
                                                       {0.22, -54.42e3, 499.0}})
  {
    const StaticReport report = slacked_off(500.0, 3390.0, friction);
    EXPECT_NEAR(report.hook_load_string, soft_string, 0.012 * std::abs(soft_string)) << friction;
    EXPECT_NEAR(report.buckled.length, buckled, 15.0) << friction;
    EXPECT_LE(report.buckled.helical, report.buckled.length) << friction;
    EXPECT_NEAR(report.buckled.from_bit, buckled > 0.0 ? 2890.0 : 0.0, 10.0) << friction << ": from the end of the build up";
  }
}

// Near lock-up the search for a helix that rests ends within its work, by the mesh that came farthest: with nearly all of the
// friction.
TEST(StaticReport, refusesWhatDoesNotRestWithTheLargestShareFound)
{
  try
  {
    slacked_off(500.0, 3390.0, 0.24);
    FAIL() << "the pipe locks up";
  }
  catch (const std::runtime_error& error)
  {
    const std::string text = error.what(), before = "with more than ";
    ASSERT_NE(text.find(before), std::string::npos) << text;
    EXPECT_GT(std::stod(text.substr(text.find(before) + before.size())), 80.0) << text;
  }
}

// Other pipe in another hole, by the same soft string: 71.34 kN with 463 m of helix.
TEST(StaticReport, slackOffInAHoleOf85Deg)
{
  Scene scene = scene_in(
      {{0.0, 0.0, 0.0}, {700.0, 0.0, 0.0}, {1100.0, 85.0 * degree, 30.0 * degree}, {4200.0, 85.0 * degree, 30.0 * degree}},
      4000.0, 3990.0, 0.25);
  PartSpec heavy = pipe_part(12, 9.5, 73.0, pipe_outer);
  heavy.name = "hwdp";
  heavy.inner_diameter = 0.0762;
  scene.string.insert(scene.string.begin() + 1, {collar_part(2, 9.4), heavy});
  scene.string.back().outer_diameter = scene.string.back().pipe->tool_joint_diameter = 0.1397;
  scene.string.back().inner_diameter = 0.1186;
  scene.string.back().linear_mass = 38.0;
  scene.mud.density = 1200.0;
  const StaticReport report = static_report(scene, sliding_down);
  EXPECT_NEAR(report.hook_load_string, 71.34e3, 0.02 * 71.34e3);
  EXPECT_NEAR(report.buckled.length, 463.0, 15.0);
}

TEST(StaticReport, aStringThatMustBePushedIn)
{
  EXPECT_GT(slacked_off(300.0, 1800.0, 0.20).hook_load_string, 30e3);
  EXPECT_LT(slacked_off(300.0, 1800.0, 0.30).hook_load_string, -30e3);
}
// A weight that buckled pipe cannot bring to the bit: the search ends by its work, some 15 s, not after minutes.
TEST(StaticReport, aWeightThatDoesNotReachTheBit)
{
  Scene scene = scene_in(
      {{0.0, 0.0, 0.0}, {823.4, 0.0, 0.0}, {1367.6, 88.8 * degree, 20.0 * degree}, {2925.3, 88.8 * degree, 20.0 * degree}},
      2924.3, 2924.3, 0.289);
  PartSpec collars = collar_part(2, 9.4);
  collars.outer_diameter = 0.121;
  collars.inner_diameter = 0.0572;
  collars.linear_mass = 69.0;
  scene.string.insert(scene.string.begin() + 1, collars);
  PartSpec& pipe = scene.string.back();
  pipe.outer_diameter = pipe.pipe->tool_joint_diameter = 0.0889;
  pipe.inner_diameter = 0.0702;
  pipe.linear_mass = 19.8;
  scene.mud.density = 1200.0;
  scene.start.weight_on_bit = 30e3;
  try
  {
    static_report(scene, sliding_down);
    FAIL() << "accepted";
  }
  catch (const std::runtime_error& error)
  {
    EXPECT_NE(std::string(error.what()).find("with the scene's weight on bit for this motion"), std::string::npos)
        << error.what();
  }
}
}  // namespace test_sim_static_report
