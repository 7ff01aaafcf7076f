// SPDX-License-Identifier: BSD-3-Clause
// Ten thousand turns of the top drive leave no trace in the string's twist.
#include <gtest/gtest.h>

#include <cmath>

#include "drill_rig_sim/math/rotation.h"
#include "drill_rig_sim/solve/start.h"
#include "drill_rig_sim/solve/stepper.h"
#include "test_scenes.h"

namespace test_sim_many_turns
{
using namespace drill_rig_sim;

namespace
{
constexpr double kStep = 0.005;

/// Six elements that hang free, mud drag on their spin: a constant twist in steady rotation. The drive is faster than any rig's.
Scene spinning_scene()
{
  Scene scene = vertical_scene(60.0, 40.0);
  scene.string[0].bit->diameter = 0.2;
  scene.mud.torsional_damping = 0.05;
  scene.numerics.structural_damping = 0.0;  // a shaft so far above its critical speeds, in part in air, would whirl by it
  scene.rig.top_drive.max_speed = 1300.0 * rpm;
  scene.rig.top_drive.max_power = 1e8;
  scene.rig.top_drive.max_torque = 1e6;
  return scene;
}

/// Twist of each element over its length, from the sections themselves [rad/m].
std::vector<double> twist_rates(const RigAtRest& rig)
{
  std::vector<double> out;
  for (int e = 0; e + 1 < rig.model->nodes(); ++e)
    out.push_back(twist_between(rig.state.nodes[e + 1].orientation, rig.state.nodes[e].orientation) /
                  rig.model->mesh().elements[e].section.length);
  return out;
}

void run(RigAtRest& rig, Stepper& stepper, double speed, double seconds)
{
  Setpoints setpoints;
  setpoints.top_drive.speed = speed;
  const long steps = std::lround(seconds / kStep);
  for (long k = 0; k < steps; ++k) ASSERT_TRUE(stepper.advance(rig.state, kStep, setpoints));
}
}  // namespace

TEST(ManyTurns, leaveTheTwistAsItWas)
{
  RigAtRest rig = build_at_rest(spinning_scene());
  Stepper stepper(rig.model, find_method(IntegratorKind::automatic));
  const double speed = 1200.0 * rpm;
  run(rig, stepper, speed, 60.0);
  const std::vector<double> before = twist_rates(rig);
  const double turned = rig.state.nodes[0].spin_angle;
  EXPECT_LT(before[5], -1e-4) << "drag twists the string backwards";

  run(rig, stepper, speed, 500.0);
  EXPECT_NEAR((rig.state.nodes[0].spin_angle - turned) / (2.0 * pi), 1e4, 1.0);
  const std::vector<double> after = twist_rates(rig);
  for (std::size_t e = 0; e < after.size(); ++e) EXPECT_NEAR(after[e], before[e], 1e-9) << "element " << e;

  // the angle that is counted and the one that is drawn are the same turns
  const NodeState& top = rig.state.nodes.back();
  EXPECT_NEAR(std::remainder(top.spin_angle - rig.state.nodes[0].spin_angle, 2.0 * pi),
              -twist_between(top.orientation, rig.state.nodes[0].orientation), 1e-6);
}

// Wound up by the start, spun, stopped: nothing of it stays. The stop's swing dies in the mud.
TEST(ManyTurns, leaveNoTwistBehindAtRest)
{
  RigAtRest rig = build_at_rest(spinning_scene());
  Stepper stepper(rig.model, find_method(IntegratorKind::automatic));
  run(rig, stepper, 1200.0 * rpm, 500.0);
  run(rig, stepper, 0.0, 200.0);
  EXPECT_GT(rig.state.nodes[0].spin_angle / (2.0 * pi), 0.99e4);
  for (double rate : twist_rates(rig)) EXPECT_NEAR(rate, 0.0, 1e-9);
}
}  // namespace test_sim_many_turns
