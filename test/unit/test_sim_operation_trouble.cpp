// SPDX-License-Identifier: BSD-3-Clause
// What makes a driller stop: a motor that stalls, weight that runs away, a pressure that still rises while the weight is zeroed.
#include <gtest/gtest.h>

#include <cmath>

#include "drill_rig_sim/crew/operation_trouble.h"
#include "drill_rig_sim/hydraulics/mud_motor.h"
#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/sim/run.h"
#include "playing.h"
#include "test_scenes.h"

namespace test_sim_operation_trouble
{
using namespace drill_rig_sim;

namespace
{
Operation drilling(double weight)
{
  Operation o = default_operation(OperationKind::drill);
  o.weight = weight;
  o.distance = 50.0;
  return o;
}

/// The trouble after `seconds` of the same readings, in frames of 0.1 s.
OperationTrouble look_for(OperationTroubleWatch& watch, Readings& now, const Operation& operation, double seconds)
{
  OperationTrouble found = OperationTrouble::none;
  for (int k = 0; k < std::lround(seconds / 0.1) && found == OperationTrouble::none; ++k)
  {
    now.time += 0.1;
    found = watch.look(operation, now);
  }
  return found;
}

Scene stalling_scene()
{
  Scene scene = motor_drilling_scene(0.3);
  scene.instruments.hook_load.place = HookLoadPlace::block;
  scene.string[1].motor->bend = 0.0;
  scene.string[1].motor->stall_torque = 300.0;
  Operation flow = default_operation(OperationKind::flow), rotate = default_operation(OperationKind::rotate);
  flow.flow = 0.02;
  rotate.rotary_speed = 30.0 * rpm;
  Operation pick_up = default_operation(OperationKind::pick_up);
  pick_up.distance = 1.0;
  scene.operations = {flow, rotate, default_operation(OperationKind::tag), drilling(60e3), pick_up};
  return scene;
}

RunEnd play_on(Simulator& rig, ScenePlayer& player)
{
  RunGoal goal;
  goal.duration = 300.0;
  return run(rig, player, goal, frame);
}
}  // namespace

TEST(OperationTroubleWatch, aStallThatStandsForTwoSeconds)
{
  const Scene scene = motor_drilling_scene(0.0);
  OperationTroubleWatch watch(scene);
  const MotorSpec& motor = *scene.string[1].motor;
  Readings now;
  now.tared = true;
  watch.begin(now.time);
  now.differential_pressure = 0.93 * 2.0 * pi * motor.stall_torque / motor.displacement_per_rev;
  now.rop = 1e-3;
  EXPECT_EQ(look_for(watch, now, drilling(60e3), 20.0), OperationTrouble::none) << "a motor near its limit turns";
  now.rop = 0.0;
  EXPECT_EQ(look_for(watch, now, drilling(60e3), 1.8), OperationTrouble::none);
  EXPECT_EQ(look_for(watch, now, drilling(60e3), 0.4), OperationTrouble::motor_stalled)
      << "a zero with the pressure that it took off bottom";
  watch.begin(now.time);
  now.rop = 1e-3;
  now.differential_pressure = 2.0 * pi * motor.stall_torque / motor.displacement_per_rev;
  EXPECT_EQ(look_for(watch, now, drilling(60e3), 1.8), OperationTrouble::none);
  EXPECT_EQ(look_for(watch, now, drilling(60e3), 0.4), OperationTrouble::motor_stalled);
}

TEST(OperationTroubleWatch, weightFarAboveWhatWasAskedFor)
{
  OperationTroubleWatch watch(drilling_scene());
  Readings now;
  now.tared = true;
  watch.begin(now.time);
  now.mean_surface_wob = 118e3;
  EXPECT_EQ(look_for(watch, now, drilling(60e3), 60.0), OperationTrouble::none);
  now.mean_surface_wob = 122e3;
  EXPECT_EQ(look_for(watch, now, drilling(60e3), 9.8), OperationTrouble::none);
  EXPECT_EQ(look_for(watch, now, drilling(60e3), 0.4), OperationTrouble::over_weight);
  EXPECT_EQ(OperationTroubleWatch::over_weight(5e3), 35e3) << "a little weight may be missed by more";
}

TEST(OperationTroubleWatch, otherOperationsMayPush)
{
  OperationTroubleWatch watch(drilling_scene());
  Readings now;
  watch.begin(now.time);
  now.mean_surface_wob = 500e3;
  EXPECT_EQ(look_for(watch, now, default_operation(OperationKind::slack_off), 60.0), OperationTrouble::none);
}

TEST(OperationTroubleWatch, aBlockThatStandsAtAnEndOfItsTravel)
{
  OperationTroubleWatch watch(drilling_scene());
  Readings now;
  now.tared = now.stop_reached = true;
  Operation pick_up = default_operation(OperationKind::pick_up);
  pick_up.distance = 60.0;
  watch.begin(now.time);
  EXPECT_EQ(look_for(watch, now, pick_up, 9.8), OperationTrouble::none);
  EXPECT_EQ(look_for(watch, now, pick_up, 0.4), OperationTrouble::block_at_stop);
  watch.begin(now.time);
  now.block_velocity = 0.05;
  EXPECT_EQ(look_for(watch, now, pick_up, 60.0), OperationTrouble::none) << "slowed down before the end";
  now.block_velocity = 0.0;
  pick_up.time = 100.0;
  EXPECT_EQ(look_for(watch, now, pick_up, 60.0), OperationTrouble::none) << "it ends after its time";
  now.rop = 1e-3;
  EXPECT_EQ(look_for(watch, now, drilling(60e3), 60.0), OperationTrouble::none) << "the string's stretch is drilled off";
  now.rop = 0.0;
  EXPECT_EQ(look_for(watch, now, drilling(60e3), 10.2), OperationTrouble::block_at_stop);
  watch.begin(now.time);
  EXPECT_EQ(look_for(watch, now, default_operation(OperationKind::rotate), 60.0), OperationTrouble::none) << "moves no block";
}

// Higher than the derrick: the block stops below its highest place, and the operation ends 10 s later.
TEST(OperationTrouble, aPickUpBeyondTheBlocksTravelIsGivenUp)
{
  Scene scene = drilling_scene();
  Operation pick_up = default_operation(OperationKind::pick_up);
  pick_up.distance = scene.rig.hoisting.highest_block_height + 10.0;
  pick_up.speed = 0.5;
  scene.operations = {pick_up};
  Simulator rig(scene);
  ScenePlayer player(rig.scene());
  ASSERT_EQ(play_on(rig, player), RunEnd::trouble);
  EXPECT_EQ(player.operations().status().trouble, OperationTrouble::block_at_stop);
  EXPECT_NEAR(rig.readings().block_height, scene.rig.hoisting.highest_block_height, 0.1);
  EXPECT_TRUE(rig.setpoints().winch.brake);
}

TEST(OperationTrouble, aStalledMotorEndsTheOperationsWithTheBrakeSet)
{
  Simulator rig(stalling_scene());
  ScenePlayer player(rig.scene());
  ASSERT_EQ(play_on(rig, player), RunEnd::trouble);
  const OperationStatus status = player.operations().status();
  EXPECT_EQ(status.trouble, OperationTrouble::motor_stalled);
  EXPECT_EQ(status.kind, OperationKind::drill);
  EXPECT_TRUE(rig.truth().motor_stalled);
  EXPECT_TRUE(rig.setpoints().winch.brake);
  const double block = rig.readings().block_height;
  for (int k = 0; k < 500; ++k) ASSERT_EQ(play_frame(rig, &player, frame), FrameStatus::running);
  EXPECT_NEAR(rig.readings().block_height, block, 0.01) << "neither fed nor lifted";
  EXPECT_EQ(player.operations().status().number, 4);
}

TEST(OperationTrouble, survivesASnapshotAndARewind)
{
  Simulator rig(stalling_scene());
  ScenePlayer player(rig.scene());
  ASSERT_EQ(play_on(rig, player), RunEnd::trouble);
  ScenePlayer copy = player;
  EXPECT_EQ(copy.operations().status().trouble, OperationTrouble::motor_stalled);
  copy.rewind();
  EXPECT_EQ(copy.operations().status().trouble, OperationTrouble::none);
}

TEST(MotorSpec, frictionInsideNeedsMorePressureForTheSameTorque)
{
  MotorSpec motor;
  motor.displacement_per_rev = 0.024;
  motor.efficiency = 0.8;
  EXPECT_NEAR(mud_motor_pressure(0.03, motor.pressure_displacement(), 4e3), 2.0 * pi * 4e3 / 0.024 / 0.8, 1e-6);
}

// p = P (1 - exp(-t/20 s)): what still comes when it counts as steady is a few per cent.
TEST(PressureTrend, isSteadyWhenLittleIsStillToCome)
{
  constexpr double dt = 0.01, slow = 20.0, top = 15e6;
  PressureTrend trend;
  double t = 0.0;
  for (; t < 300.0 && (t < 1.0 || !trend.is_steady()); t += dt) trend.take(top * -std::expm1(-t / slow), t);
  EXPECT_GT(t, 20.0);
  EXPECT_LT(t, 120.0);
  EXPECT_LT(std::exp(-t / slow), 0.1);
}

TEST(PressureTrend, ofAPumpThatStands)
{
  PressureTrend trend;
  trend.take(0.0, 0.0);
  trend.take(0.0, 0.01);
  EXPECT_TRUE(trend.is_steady());
}
}  // namespace test_sim_operation_trouble
