// SPDX-License-Identifier: BSD-3-Clause
// Hoisting: line statics, winch ramps and limits, steady block speed.
#include <gtest/gtest.h>

#include <cmath>

#include "drill_rig_sim/rig/hoisting.h"

namespace drill_rig_sim::test_rig_hoisting
{
namespace
{
WinchSetpoint velocity(double value)
{
  return {value, false};
}

TEST(DrillLine, TensionStiffnessAndSlack)
{
  const HoistingSpec spec;
  EXPECT_DOUBLE_EQ(strung_length(spec, 34.0), 10.0 * 12.0 + 60.0);
  const double unstretched = line_length_for(spec, 34.0, 407e3);
  const LinePull pull = line_pull(spec, 34.0, unstretched);
  // L0 from L - L0 loses digits: 180 m of line, 0.2 m of stretch
  EXPECT_NEAR(pull.hook_force, 407e3, 1e-6);
  EXPECT_NEAR(pull.tension, 40.7e3, 1e-7);
  EXPECT_FALSE(pull.slack);
  const double h = 1e-3;
  const double k =
      (line_pull(spec, 34.0 - h, unstretched).hook_force - line_pull(spec, 34.0 + h, unstretched).hook_force) / (2 * h);
  EXPECT_NEAR(pull.stiffness, k, 1e-8 * k);
  EXPECT_NEAR(pull.stiffness, 100.0 * spec.line_ea / unstretched, 1e-6);

  const LinePull slack = line_pull(spec, 34.1, unstretched);
  EXPECT_TRUE(slack.slack);
  EXPECT_EQ(slack.hook_force, 0.0);
  EXPECT_EQ(slack.stiffness, 0.0);
}

TEST(Winch, ConstantCommandGivesExactlyThatBlockSpeedAtSteadyLoad)
{
  // at a constant hook force the block sits where the line's pull equals it
  const HoistingSpec spec;
  const double hook = 400e3;
  const double command = -0.00908;
  const double h = 0.005;
  double height = 34.0;
  double line = line_length_for(spec, height, hook);
  double speed = command;
  for (int i = 0; i < 2000; ++i)
  {
    const WinchStep w = advance_winch(spec, velocity(command), line, speed, height, hook, h);
    line = w.line_length;
    speed = w.speed;
    const double strung = line * (1.0 + hook / (2.0 * spec.sheaves) / spec.line_ea);
    height = spec.crown_height - (strung - spec.fixed_length) / (2.0 * spec.sheaves);
    EXPECT_FALSE(w.limits.any());
  }
  EXPECT_NEAR(height, 34.0 + command * 10.0, 1e-10);
}

TEST(Winch, RampsAtTheAccelerationLimit)
{
  const HoistingSpec spec;
  const double h = 0.01;
  double line = strung_length(spec, 20.0);
  double speed = 0.0;
  double reeled = 0.0;
  for (int i = 0; i < 10; ++i)
  {
    const WinchStep w = advance_winch(spec, velocity(-0.042), line, speed, 20.0, 0.0, h);
    reeled += (w.line_length - line) / line * strung_length(spec, 20.0) / (2.0 * spec.sheaves);
    line = w.line_length;
    speed = w.speed;
    EXPECT_EQ(w.limits.acceleration, i < 8);
  }
  EXPECT_DOUBLE_EQ(speed, -0.042);
  // Area under the ramp: 0.084 s to 0.042 m/s, then constant to 0.1 s; the step in which the ramp ends is exact too.
  // What is left is rounding of 320 m of line.
  EXPECT_NEAR(reeled, 0.5 * 0.084 * 0.042 + 0.016 * 0.042, 1e-13);
}

TEST(Winch, SpeedIsClampedAndFlagged)
{
  const HoistingSpec spec;
  const WinchStep w = advance_winch(spec, velocity(-9.0), 100.0, -spec.max_speed, 20.0, 0.0, 0.01);
  EXPECT_EQ(w.speed, -spec.max_speed);
  EXPECT_TRUE(w.limits.speed);
  EXPECT_FALSE(w.limits.acceleration);
}

TEST(Winch, BrakeRampsToRestAndHolds)
{
  const HoistingSpec spec;
  double line = 200.0;
  double speed = 0.5;
  for (int i = 0; i < 101; ++i)
  {
    const WinchStep w = advance_winch(spec, {1.0, true}, line, speed, 20.0, 0.0, 0.01);
    line = w.line_length;
    speed = w.speed;
  }
  EXPECT_EQ(speed, 0.0);
  EXPECT_EQ(advance_winch(spec, {1.0, true}, line, speed, 20.0, 0.0, 0.01).line_length, line);
}

TEST(SteadyHookLoad, RailAndSheavesByHand)
{
  HoistingSpec spec;
  spec.block_mass = 18000.0;
  const double weight = 221450.0;
  const double rail = 0.03 * 18000.0 * 9.80665;
  for (const int direction : {-1, 0, 1})
  {
    const SteadyHookLoad load = steady_hook_load(spec, weight, direction);
    EXPECT_NEAR(load.at_block, weight + direction * rail, 1e-6);
    double lines = 0.0;  // tensions as shares of the dead line's: each sheave passed towards the fast line adds its friction
    for (int i = 0; i < 2 * spec.sheaves; ++i) lines += std::pow(spec.sheave_efficiency, -direction * i);
    EXPECT_NEAR(load.at_dead_line, 2 * spec.sheaves * load.at_block / lines, 1e-6);
  }
  EXPECT_LT(steady_hook_load(spec, weight, 1).at_dead_line, weight);
  EXPECT_GT(steady_hook_load(spec, weight, -1).at_dead_line, weight);
}

TEST(Winch, StopsAtTheHeightLimitsWithinTheRamp)
{
  const HoistingSpec spec;
  const double h = 0.01;
  for (double command : {1.5, -1.5})
  {
    double height = 20.0;
    double speed = 0.0;
    double line = strung_length(spec, height);  // no load: the block follows the drum
    bool flagged = false;
    for (int i = 0; i < 4000; ++i)
    {
      const WinchStep w = advance_winch(spec, velocity(command), line, speed, height, 0.0, h);
      EXPECT_LE(std::abs(w.speed - speed), spec.max_acceleration * h * (1.0 + 1e-9));
      speed = w.speed;
      line = w.line_length;
      height = spec.crown_height - (line - spec.fixed_length) / (2.0 * spec.sheaves);
      flagged = w.limits.height;
    }
    const double stop = command > 0.0 ? spec.highest_block_height : spec.lowest_block_height;
    EXPECT_NEAR(height, stop, 1e-9);
    EXPECT_TRUE(flagged);
    // free to leave
    EXPECT_FALSE(advance_winch(spec, velocity(-command), line, speed, height, 0.0, h).limits.height);
    EXPECT_NE(advance_winch(spec, velocity(-command), line, speed, height, 0.0, h).speed, 0.0);
  }
}

TEST(Winch, HookLoadLimitStopsRaisingOnly)
{
  const HoistingSpec spec;
  const WinchStep up = advance_winch(spec, velocity(1.0), 200.0, 1.0, 20.0, 2.5e6, 0.01);
  EXPECT_EQ(up.speed, 0.0);
  EXPECT_EQ(up.line_length, 200.0);
  EXPECT_TRUE(up.limits.load);
  const WinchStep down = advance_winch(spec, velocity(-1.0), 200.0, -1.0, 20.0, 2.6e6, 0.01);
  EXPECT_EQ(down.speed, -1.0);
  EXPECT_TRUE(down.limits.load) << "said, whichever way it goes";
}

// One step by hand for each limit: 0.1 s, 0.5 m/s2, a line of 200 m on 320 m strung, ten lines.
TEST(Winch, LeastHookLoadStopsLoweringOnly)
{
  HoistingSpec spec;
  spec.min_hook_load = 50e3;
  const double line = line_length_for(spec, 20.0, 40e3);
  const WinchStep down = advance_winch(spec, velocity(-0.2), line, -0.2, 20.0, 40e3, 0.01);
  EXPECT_EQ(down.speed, 0.0);
  EXPECT_EQ(down.line_length, line);
  EXPECT_TRUE(down.limits.load);
  const WinchStep up = advance_winch(spec, velocity(0.2), line, 0.2, 20.0, 40e3, 0.01);
  EXPECT_EQ(up.speed, 0.2);
  const WinchStep enough = advance_winch(spec, velocity(-0.2), line, -0.2, 20.0, 50e3, 0.01);
  EXPECT_EQ(enough.speed, -0.2);
  EXPECT_FALSE(enough.limits.load);
  spec.min_hook_load = 0.0;
  EXPECT_EQ(advance_winch(spec, velocity(-0.2), line, -0.2, 20.0, 0.0, 0.01).speed, -0.2) << "off: slack line is paid out";
}

// A block of mass m under its weight W and lines that carry F at most: it sinks with (W - F)/m from rest, the lines' pull off F
// by what the block's acceleration does within a step, k a h^2/2.
TEST(SlippingBrake, LetsTheBlockSinkByWhatItDoesNotHold)
{
  const HoistingSpec spec;
  const double mass = 40e3, weight = 400e3, most = 300e3, h = 0.002;
  double height = 30.0, velocity = 0.0, line = line_length_for(spec, height, weight);
  for (int k = 0; k < 1000; ++k)
  {
    line = slipping_line(spec, line, height, velocity, most, h);
    height += velocity * h;
    const LinePull pull = line_pull(spec, height, line);
    EXPECT_NEAR(pull.hook_force, most, 1.0) << k;
    velocity += h * (pull.hook_force - weight) / mass;
  }
  EXPECT_NEAR(velocity, -2.0 * (weight - most) / mass, 1e-3);
}

TEST(SlippingBrake, HoldsWhatItCanAndNeverTakesLineIn)
{
  const HoistingSpec spec;
  const double line = line_length_for(spec, 30.0, 200e3);
  EXPECT_EQ(slipping_line(spec, line, 30.0, 0.0, 300e3, 0.01), line);
  EXPECT_EQ(slipping_line(spec, line, 30.0, 0.5, 300e3, 0.01), line) << "a block that goes up";
  EXPECT_GT(slipping_line(spec, line, 30.0, 0.0, 100e3, 0.01), line);
}

TEST(Winch, EachLimitByHand)
{
  const HoistingSpec spec;
  const auto step = [&spec](double command, double speed, double height, double load)
  { return advance_winch(spec, velocity(command), 200.0, speed, height, load, 0.1); };
  const auto none_but = [](const WinchLimits& limits, bool speed, bool acceleration, bool height, bool load)
  {
    EXPECT_EQ(limits.speed, speed);
    EXPECT_EQ(limits.acceleration, acceleration);
    EXPECT_EQ(limits.height, height);
    EXPECT_EQ(limits.load, load);
    EXPECT_EQ(limits.any(), speed || acceleration || height || load);
  };
  // nothing: the command is within reach, the ramp ends half way through the step
  const WinchStep free = step(0.225, 0.2, 20.0, 0.0);
  EXPECT_DOUBLE_EQ(free.speed, 0.225);
  EXPECT_NEAR(free.line_length, 200.0 - 10.0 * (0.5 * 0.2125 + 0.5 * 0.225) * 0.1 * 200.0 / 320.0, 1e-12);
  none_but(free.limits, false, false, false, false);
  // acceleration, up and down
  const WinchStep ramp = step(1.0, 0.2, 20.0, 0.0);
  EXPECT_DOUBLE_EQ(ramp.speed, 0.25);
  EXPECT_NEAR(ramp.line_length, 200.0 - 10.0 * 0.225 * 0.1 * 200.0 / 320.0, 1e-12);
  none_but(ramp.limits, false, true, false, false);
  EXPECT_DOUBLE_EQ(step(-1.0, 0.2, 20.0, 0.0).speed, 0.15);
  // speed, either way
  for (const double way : {1.0, -1.0})
  {
    const WinchStep fast = step(way * 2.0, way * 1.5, 20.0, 0.0);
    EXPECT_DOUBLE_EQ(fast.speed, way * 1.5);
    none_but(fast.limits, true, false, false, false);
  }
  // height: 5 cm from either stop, v with (0.2 + v) 0.05 + v^2 = 0.05 can still stop there
  const double stopping = 0.5 * (std::sqrt(0.05 * 0.05 + 4.0 * 0.04) - 0.05);
  const WinchStep up = step(0.2, 0.2, 39.95, 0.0), down = step(-0.2, -0.2, 1.05, 0.0);
  EXPECT_NEAR(up.speed, stopping, 1e-12);
  EXPECT_NEAR(down.speed, -stopping, 1e-12);
  none_but(up.limits, false, false, true, false);
  none_but(down.limits, false, false, true, false);
  // beyond a stop: at once, the other way is free
  EXPECT_EQ(step(0.2, 0.2, 40.1, 0.0).speed, 0.0);
  EXPECT_EQ(step(0.2, 0.2, 40.1, 0.0).line_length, 200.0);
  EXPECT_EQ(step(-0.2, -0.2, 0.9, 0.0).speed, 0.0);
  EXPECT_DOUBLE_EQ(step(-0.2, -0.2, 40.1, 0.0).speed, -0.2);
  EXPECT_DOUBLE_EQ(step(0.2, 0.2, 0.9, 0.0).speed, 0.2);
  // load: from max_hook_load on, raising alone
  none_but(step(0.2, 0.2, 20.0, 2.499e6).limits, false, false, false, false);
  const WinchStep heavy = step(0.2, 0.2, 20.0, 2.5e6);
  EXPECT_EQ(heavy.speed, 0.0);
  EXPECT_EQ(heavy.line_length, 200.0);
  none_but(heavy.limits, false, false, false, true);
  const WinchStep lowering = step(-0.2, -0.2, 20.0, 2.6e6);
  EXPECT_EQ(lowering.speed, -0.2) << "down stays free";
  none_but(lowering.limits, false, false, false, true);
}
}  // namespace
}  // namespace drill_rig_sim::test_rig_hoisting
