// SPDX-License-Identifier: BSD-3-Clause
// Dead times of PLC and drawworks: when set points act, by frames that are counted.
#include <gtest/gtest.h>

#include "drill_rig_sim/crew/command_delay.h"
#include "drill_rig_sim/sim/simulator.h"
#include "sim_numbers.h"
#include "test_scenes.h"

namespace test_sim_latency
{
using namespace drill_rig_sim;

namespace
{
constexpr double frame = 0.01;  // [s]

Setpoints given(double velocity, double flow)
{
  Setpoints all;
  all.winch = {velocity, false};
  all.pump.flow = flow;
  return all;
}

Scene late_scene(double plc, double drawworks)
{
  Scene scene = drilling_scene(5.0);
  scene.rig.plc_latency = plc;
  scene.rig.hoisting.latency = drawworks;
  return scene;
}

/// Frames until the block has a speed of its own, after a command before the first.
int frames_until_it_moves(const Scene& scene)
{
  Simulator rig(scene);
  rig.command(WinchSetpoint{0.2, false});
  for (int k = 1; k <= 200; ++k)
  {
    rig.frame(frame);
    if (rig.truth().setpoints.winch.block_velocity > 0.0) return k;
  }
  return 0;
}
}  // namespace

TEST(CommandDelay, passesAllOfThemLateAndTheWinchLater)
{
  CommandDelay delay(0.2, 0.3);
  for (int k = 0; k <= 100; ++k)
  {
    delay.take(given(0.001 * (k + 1), 0.01 * (k + 1)), frame * k);
    EXPECT_DOUBLE_EQ(delay.passed().pump.flow, k < 20 ? 0.0 : 0.01 * (k - 19)) << k;
    EXPECT_DOUBLE_EQ(delay.passed().winch.block_velocity, k < 50 ? 0.0 : 0.001 * (k - 49)) << k;
    EXPECT_EQ(delay.passed().winch.brake, k < 50) << "a rig at rest is braked";
  }
}

TEST(CommandDelay, isNoneWithoutDeadTimes)
{
  EXPECT_FALSE(CommandDelay(0.0, 0.0).is_on());
  EXPECT_TRUE(CommandDelay(0.1, 0.0).is_on());
}

TEST(Latency, theBlockMovesAfterBothDeadTimes)
{
  EXPECT_EQ(frames_until_it_moves(late_scene(0.0, 0.0)), 1);
  EXPECT_EQ(frames_until_it_moves(late_scene(0.0, 0.25)), 26);
  EXPECT_EQ(frames_until_it_moves(late_scene(0.1, 0.25)), 36);
}

TEST(Latency, aSnapshotBringsTheCommandsOnTheirWayBack)
{
  Simulator rig(late_scene(0.1, 0.1));
  rig.command(WinchSetpoint{0.2, false});
  for (int k = 0; k < 5; ++k) rig.frame(frame);
  const auto saved = rig.save();
  const auto run = [&rig]
  {
    std::vector<double> heights;
    for (int k = 0; k < 60; ++k)
    {
      rig.frame(frame);
      heights.push_back(rig.truth().block_height);
    }
    return heights;
  };
  const std::vector<double> first = run();
  ASSERT_TRUE(rig.restore(*saved));
  EXPECT_EQ(first, run());
  EXPECT_GT(first.back(), first.front() + 1e-3);
}

TEST(Latency, anInterlockActsAtOnce)
{
  Scene scene = late_scene(1.0, 0.0);
  Simulator rig(scene);
  rig.command(PumpSetpoint{0.01});
  for (int k = 0; k < 150; ++k) rig.frame(frame);
  ASSERT_GT(rig.truth().setpoints.pump.flow, 0.0);
  rig.inject({FaultKind::pump_trip, 0.0, 0.0, Gauge::hook_load});
  rig.frame(frame);
  EXPECT_EQ(rig.truth().setpoints.pump.flow, 0.0);
}

}  // namespace test_sim_latency
