// SPDX-License-Identifier: BSD-3-Clause
// What drill check reports of a scene whose numbers are all allowed, but whose rig cannot do what it is for.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "drill_margins.h"
#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/sim/profile.h"
#include "test_scenes.h"

namespace drill_rig_sim::test_tools_margins
{
namespace
{
/// Vertical, then a bend of 3 deg/30 m to 30 deg.
Scene bent_scene(double friction)
{
  Scene scene = scene_in({{0.0, 0.0, 0.0}, {200.0, 0.0, 0.0}, {500.0, 30.0 * degree, 0.0}, {800.0, 30.0 * degree, 0.0}}, 800.0,
                         790.0, friction);
  scene.numerics.element_length = 9.5;
  return scene;
}

std::string printed(const Scene& scene, const char* units = "si")
{
  testing::internal::CaptureStdout();
  print_margins(build_at_rest(scene), Printed(units));
  return testing::internal::GetCapturedStdout();
}

Operation drilling_with(double weight)
{
  Operation o;
  o.kind = OperationKind::drill;
  o.weight = weight;
  return o;
}

Operation turning(double rotary_speed)
{
  Operation o;
  o.kind = OperationKind::rotate;
  o.rotary_speed = rotary_speed;
  return o;
}
}  // namespace

TEST(Margins, turningTorqueIsFrictionTimesForceTimesRadius)
{
  Scene scene = vertical_scene(400.0, 290.0, 0.3);
  RigAtRest rig = build_at_rest(scene);
  std::fill(rig.statics.forces.contact.begin(), rig.statics.forces.contact.end(), 0.0);
  std::fill(rig.statics.forces.span_contact.begin(), rig.statics.forces.span_contact.end(), 0.0);
  EXPECT_EQ(turning_torque(rig), 0.0);
  rig.statics.forces.contact[8] = 10e3;  // a tool joint of 168 mm
  EXPECT_NEAR(turning_torque(rig), 0.3 * 10e3 * 0.084, 1e-9);
  rig.statics.forces.span_contact[8] = 10e3;  // pipe of 127 mm
  EXPECT_NEAR(turning_torque(rig), 0.3 * 10e3 * (0.084 + 0.0635), 1e-9);
}

TEST(Margins, turningTorqueIsNearThatOfTheEquilibriumWithFriction)
{
  const Scene scene = bent_scene(0.25);
  const double exact = static_report(scene, sliding_around).torque;
  ASSERT_GT(exact, 500.0);
  EXPECT_NEAR(turning_torque(build_at_rest(scene)), exact, 0.05 * exact);
}

TEST(Margins, aDriveThatCannotTurnTheStringIsReported)
{
  Scene scene = bent_scene(0.25);
  const double torque = turning_torque(build_at_rest(scene));
  scene.rig.top_drive.max_torque = 0.91 * torque;
  EXPECT_EQ(printed(scene), "");
  scene.rig.top_drive.max_torque = 0.89 * torque;
  EXPECT_EQ(printed(scene).rfind("torque      rig.top_drive.max_torque: ", 0), 0u) << printed(scene);
  scene.rig.top_drive.max_torque = 10.0 * torque;
  scene.program.resize(2);
  scene.program[1].torque_limit = 0.5 * torque;
  EXPECT_EQ(printed(scene).rfind("torque      program[1].top_drive_torque_limit: ", 0), 0u) << printed(scene);
  scene.program[1].torque_limit = 0.0;  // the rig's
  EXPECT_EQ(printed(scene), "");
}

// The string of a vertical hole weighs what hangs on the hook off bottom.
TEST(Margins, aWeightNearThatOfTheStringIsReported)
{
  const RigAtRest off = build_at_rest(drilling_scene());
  const double hangs = off.statics.top_force;
  Scene scene = drilling_scene(0.0);
  scene.start.weight_on_bit = 0.79 * hangs;
  EXPECT_EQ(printed(scene), "");
  scene.start.weight_on_bit = 0.9 * hangs;
  const std::string text = printed(scene);
  EXPECT_EQ(text.rfind("weight      start.weight_on_bit: ", 0), 0u) << text;
  EXPECT_NE(text.find(" is 90 % of the string's hook load off bottom"), std::string::npos) << text;
  EXPECT_NE(printed(scene, "oilfield").find(" klbf is 90 %"), std::string::npos);
}

TEST(Margins, aWeightBelowTheThresholdOfTheRockIsReported)
{
  Scene scene = drilling_scene();
  for (FormationLayer& layer : scene.formation) layer.threshold = 20e3;
  scene.operations = {turning(10.0), drilling_with(5e3)};
  const std::string text = printed(scene);
  EXPECT_EQ(
      text.rfind("weight      operations[1].weight: 5.0 kN is not above the threshold of the rock at the bottom, 20.0 kN", 0), 0u)
      << text;
}

TEST(Margins, aWinchThatItsLimitsStopIsReported)
{
  Scene scene = drilling_scene();
  const RigAtRest rig = build_at_rest(scene);
  const double hangs = rig.statics.top_force + standard_gravity * scene.rig.hoisting.block_mass;
  scene.rig.hoisting.trip_hook_load = 1.01 * hangs;
  scene.rig.hoisting.min_hook_load = 0.99 * hangs;
  EXPECT_EQ(printed(scene), "");
  scene.rig.hoisting.trip_hook_load = 1500.0;  // kN
  EXPECT_EQ(printed(scene).rfind("winch       rig.hoisting.trip_hook_load: 1.5 kN is below the hook load at the start, ", 0), 0u)
      << printed(scene);
  scene.rig.hoisting.trip_hook_load = 0.0;
  scene.rig.hoisting.min_hook_load = 1.01 * hangs;
  EXPECT_NE(printed(scene).find("the winch does not lower the string"), std::string::npos) << printed(scene);
}

TEST(Margins, aWeightOfAnOperationIsReported)
{
  Scene scene = drilling_scene();
  const double hangs = build_at_rest(scene).statics.top_force;
  scene.operations = {turning(10.0), drilling_with(1.5 * hangs), drilling_with(0.79 * hangs)};
  const std::string text = printed(scene);
  EXPECT_EQ(text.rfind("weight      operations[1].weight: ", 0), 0u) << text;
  EXPECT_NE(text.find(" is 150 % of"), std::string::npos) << text;
}

TEST(Margins, aBitThatNothingTurnsIsReported)
{
  Scene scene = drilling_scene();
  scene.operations = {turning(0.0), drilling_with(5e3)};
  EXPECT_EQ(printed(scene),
            "bit         operations[1]: nothing turns the bit when it begins to drill; needed before it: rotate\n");
  Operation flow, slide = drilling_with(5e3);
  flow.kind = OperationKind::flow;
  flow.flow = 0.02;
  slide.kind = OperationKind::slide;
  scene.operations = {turning(10.0), flow, slide};
  EXPECT_EQ(printed(scene),
            "bit         operations[2]: nothing turns the bit when it begins to slide; needed before it: a motor in the string, "
            "and flow\n");
  scene.string.front().motor.emplace();
  const auto without_rig = [&]
  {
    testing::internal::CaptureStdout();
    print_bits_that_stand(scene);
    return testing::internal::GetCapturedStdout();
  };
  EXPECT_EQ(without_rig(), "");
  scene.operations = {turning(10.0), slide};
  EXPECT_EQ(without_rig(),
            "bit         operations[1]: nothing turns the bit when it begins to slide; needed before it: flow, for the motor\n");
  scene.operations = {turning(10.0), drilling_with(5e3)};
  EXPECT_EQ(without_rig(), "");
}
}  // namespace drill_rig_sim::test_tools_margins
