// SPDX-License-Identifier: BSD-3-Clause
// What a rig does of itself: limits that trip and stay, by what its gauges show, and what releases them.
#include <gtest/gtest.h>

#include "drill_rig_sim/crew/interlocks.h"
#include "drill_rig_sim/math/units.h"
#include "drill_ahead.h"
#include "playing.h"
#include "test_scenes.h"

namespace test_sim_interlocks
{
using namespace drill_rig_sim;

namespace
{
Scene hanging()
{
  Scene scene = vertical_scene(150.0, 140.0);
  scene.instruments.hook_load.place = HookLoadPlace::block;
  return scene;
}

double weight_of(const Scene& scene)
{
  return Simulator(scene).truth().hook_load;
}

/// A rig whose pipe is stuck and whose brake comes on at 1.3 times what hangs.
Scene with_over_pull()
{
  Scene scene = hanging();
  scene.rig.hoisting.trip_hook_load = 1.3 * weight_of(scene);
  return scene;
}
}  // namespace

TEST(OverPull, setsTheBrakeAndHoldsUntilTheWinchIsToldNotToRaise)
{
  const Scene scene = with_over_pull();
  const double limit = scene.rig.hoisting.trip_hook_load;
  Simulator rig(scene);
  ASSERT_TRUE(rig.stick_pipe(130.0));
  rig.command(WinchSetpoint{0.02, false});
  play(rig, 10.0);
  EXPECT_TRUE(rig.truth().over_pull);
  EXPECT_TRUE(rig.readings().over_pull);
  EXPECT_TRUE(rig.truth().brake_set);
  EXPECT_EQ(0.0, rig.truth().setpoints.winch.block_velocity) << "the set point in force";
  EXPECT_NEAR(rig.truth().hook_load, limit, 0.05 * limit);
  const double height = rig.truth().block_height;
  rig.command(WinchSetpoint{0.02, false});
  play(rig, 5.0);
  EXPECT_TRUE(rig.truth().over_pull) << "raising again does not release it";
  EXPECT_NEAR(rig.truth().block_height, height, 1e-3);
  rig.command(WinchSetpoint{-0.02, false});
  play(rig, 3.0);
  EXPECT_FALSE(rig.truth().over_pull);
  EXPECT_FALSE(rig.truth().brake_set);
  EXPECT_LT(rig.truth().hook_load, limit);
  rig.command(WinchSetpoint{0.02, false});
  play(rig, 0.5);
  EXPECT_FALSE(rig.truth().over_pull) << "armed, and below its limit";
}

// The set points of the last second, which raise, are still on their way when the driller brakes.
TEST(OverPull, withADeadTimeWaitsForTheSetPointsOnTheirWay)
{
  Scene scene = with_over_pull();
  scene.rig.hoisting.latency = 1.0;
  Simulator rig(scene);
  ASSERT_TRUE(rig.stick_pipe(130.0));
  rig.command(WinchSetpoint{0.02, false});
  play(rig, 15.0);
  ASSERT_TRUE(rig.truth().over_pull);
  const double height = rig.truth().block_height, load = rig.truth().hook_load;
  rig.command(WinchSetpoint{0.0, true});
  play(rig, 0.9);
  EXPECT_TRUE(rig.truth().over_pull);
  play(rig, 2.1);
  EXPECT_FALSE(rig.truth().over_pull);
  EXPECT_NEAR(rig.truth().block_height, height, 1e-3);
  EXPECT_NEAR(rig.truth().hook_load, load, 0.02 * load);
}

TEST(OverPull, isOffByDefaultAndDoesNotMindAHeavyStringThatIsNotRaised)
{
  Scene scene = hanging();
  Simulator off(scene);
  ASSERT_TRUE(off.stick_pipe(130.0));
  off.command(WinchSetpoint{0.02, false});
  play(off, 5.0);
  EXPECT_FALSE(off.truth().over_pull);
  scene.rig.hoisting.trip_hook_load = 0.9 * weight_of(scene);
  Simulator heavy(scene);
  heavy.command(WinchSetpoint{-0.1, false});
  play(heavy, 2.0);
  EXPECT_FALSE(heavy.truth().over_pull);
  heavy.command(WinchSetpoint{0.1, false});
  play(heavy, 0.1);
  EXPECT_TRUE(heavy.truth().over_pull);
}

// It sees what the gauge shows: one that is frozen lets the rig pull on.
TEST(OverPull, isBlindWithoutItsGauge)
{
  Simulator rig(with_over_pull());
  ASSERT_TRUE(rig.stick_pipe(130.0));
  play(rig, 0.1);
  ASSERT_FALSE(rig.inject({FaultKind::sensor_freeze, 0.0, 0.0, Gauge::hook_load}));
  rig.command(WinchSetpoint{0.02, false});
  play(rig, 10.0);
  EXPECT_FALSE(rig.truth().over_pull);
  EXPECT_GT(rig.truth().hook_load, 1.5 * rig.scene().rig.hoisting.trip_hook_load);
}

TEST(OverPressure, stopsThePumpUntilItIsToldTo)
{
  Scene scene = hanging();
  Simulator free(scene);
  free.command(PumpSetpoint{0.04});
  play(free, 30.0);
  scene.rig.mud_pump.trip_pressure = 0.5 * free.truth().stand_pipe_pressure;
  Simulator rig(scene);
  rig.command(PumpSetpoint{0.04});
  double most = 0.0;
  play(rig, 30.0, [&](const Truth& truth) { most = std::max(most, truth.stand_pipe_pressure); });
  EXPECT_TRUE(rig.truth().pump_tripped);
  EXPECT_EQ(0.0, rig.truth().flow);
  EXPECT_LT(most, 1.2 * scene.rig.mud_pump.trip_pressure);
  rig.command(PumpSetpoint{0.02});
  play(rig, 5.0);
  EXPECT_TRUE(rig.truth().pump_tripped) << "less does not release it";
  rig.command(PumpSetpoint{0.0});
  play(rig, 0.1);
  EXPECT_FALSE(rig.truth().pump_tripped);
  rig.command(PumpSetpoint{0.02});
  play(rig, 20.0);
  EXPECT_NEAR(rig.truth().flow, 0.02, 1e-12);
  EXPECT_FALSE(rig.truth().pump_tripped);
}

// The bit takes the string's weight; what hangs is not let fall below the limit, and can be raised.
TEST(SlackLine, isNotPaidOutBelowTheLeastHookLoad)
{
  Scene scene = drilling_scene(0.5);
  scene.formation[0].drillability = 1e-12;
  const double weight = weight_of(scene);
  scene.rig.hoisting.min_hook_load = 0.8 * weight;
  for (const bool limited : {true, false})
  {
    if (!limited) scene.rig.hoisting.min_hook_load = 0.0;
    Simulator rig(scene);
    rig.command(WinchSetpoint{-0.05, false});
    play(rig, 20.0);
    EXPECT_EQ(limited, rig.truth().hook_load > 0.6 * weight) << rig.truth().hook_load / weight;
    EXPECT_EQ(limited, rig.truth().winch_limited);
    if (!limited) continue;
    EXPECT_FALSE(rig.truth().slack_line);
    const double height = rig.truth().block_height;
    rig.command(WinchSetpoint{0.05, false});
    play(rig, 4.0);
    EXPECT_GT(rig.truth().block_height, height + 0.1);
  }
}

TEST(Restrained, leavesWhatIsNotTripped)
{
  Setpoints asked;
  asked.winch = {0.3, false};
  asked.top_drive.speed = 4.0;
  asked.top_drive.brake = true;
  asked.pump.flow = 0.02;
  EXPECT_TRUE(restrained(asked, {}, {}) == asked);
  InterlockState interlocks;
  interlocks.over_pull = true;
  Setpoints out = restrained(asked, interlocks, {});
  EXPECT_TRUE(out.winch.brake);
  EXPECT_TRUE(out.top_drive == asked.top_drive && out.pump.flow == asked.pump.flow);
  interlocks = {};
  interlocks.over_pressure = true;
  out = restrained(asked, interlocks, {});
  EXPECT_EQ(0.0, out.pump.flow);
  EXPECT_TRUE(out.top_drive == asked.top_drive && out.winch == asked.winch);
  FaultState faults;
  faults.drive_tripped = true;
  out = restrained(asked, {}, faults);
  EXPECT_EQ(TopDriveMode::torque, out.top_drive.mode);
  EXPECT_EQ(0.0, out.top_drive.torque);
  EXPECT_TRUE(out.top_drive.brake) << "the brake is its own";
  EXPECT_TRUE(out.winch == asked.winch && out.pump.flow == asked.pump.flow);
}
}  // namespace test_sim_interlocks
