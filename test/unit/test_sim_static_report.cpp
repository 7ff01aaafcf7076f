// What is reported of a string at rest or in slow motion: weights by hand, the bit's tilt and side force from its place in the hole.
#include <gtest/gtest.h>

#include <cmath>

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
    EXPECT_EQ(drag < -100.0, motion.axial_speed > 0.0) << drag;
    EXPECT_EQ(report.torque > 1.0, motion.spin_speed > 0.0) << report.torque;
    EXPECT_EQ(report.torque, report.outcome.top_torque);
    EXPECT_EQ(report.hook_load_string, report.outcome.top_force);
  }
}
}  // namespace test_sim_static_report
