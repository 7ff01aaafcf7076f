// SPDX-License-Identifier: BSD-3-Clause
// The tool of downhole dynamics: means and extremes of a period against closed forms, its telemetry, and what it sees of a rig.
#include <gtest/gtest.h>

#include <cmath>

#include "drill_rig_sim/instruments/dynamics_tool.h"
#include "drill_rig_sim/math/units.h"
#include "drill_ahead.h"
#include "playing.h"
#include "test_scenes.h"

namespace test_sim_dynamics_tool
{
using namespace drill_rig_sim;

namespace
{
constexpr double flow = 0.03;  // [m3/s]

DynamicsSpec every(double period, double latency = 0.0)
{
  DynamicsSpec spec;
  spec.period = period;
  spec.latency = latency;
  return spec;
}
}  // namespace

// 4 s of a speed 5 + 3 sin(2 pi t): mean 5, extremes 2 and 8, index 0.6; a side-to-side motion of 0.1 sin(4 pi t) m/s: 0.4 pi
// m/s2, less by its frames.
TEST(DynamicsTool, meansAndExtremesOfAPeriod)
{
  DynamicsTool tool(every(4.0));
  const double h = 0.01, w = 4.0 * pi;
  for (int k = 0; k <= 400; ++k)
  {
    const double t = h * k;
    SubView view;
    view.md = 90.0;
    view.tension = 3e4 + 1e3 * std::cos(2.0 * pi * t);
    view.weight_below = 5e4;
    view.torque = 2e3;
    view.bending_moment = 400.0 + 100.0 * std::sin(2.0 * pi * t);
    view.spin_speed = 5.0 + 3.0 * std::sin(2.0 * pi * t);
    view.velocity = {0.1 * std::sin(w * t), 0.0, -0.02 * t};
    tool.update(t, flow, view);
  }
  const DynamicsReading& r = tool.arrived();
  ASSERT_EQ(1u, r.sequence);
  EXPECT_NEAR(r.time, 4.0, 1e-9);
  EXPECT_NEAR(r.duration, 4.0, 1e-9);
  EXPECT_EQ(r.md, 90.0);
  EXPECT_NEAR(r.weight, 2e4, 1e-6);
  EXPECT_NEAR(r.torque, 2e3, 1e-9);
  EXPECT_NEAR(r.bending_moment, 500.0, 1e-6);
  EXPECT_NEAR(r.speed, 5.0, 1e-9);
  EXPECT_NEAR(r.least_speed, 2.0, 1e-6);
  EXPECT_NEAR(r.largest_speed, 8.0, 1e-6);
  EXPECT_NEAR(r.stick_slip, 0.6, 1e-6);
  EXPECT_NEAR(r.lateral_acceleration, 0.1 * std::sin(w * h) / h, 1e-9);
  EXPECT_NEAR(r.axial_acceleration, 0.02, 1e-9);
}

TEST(DynamicsTool, comesByPeriodLateAndWithFlowAlone)
{
  DynamicsTool tool(every(5.0, 2.0)), none(every(0.0));
  for (int k = 0; k <= 4000; ++k)
  {
    const double t = 0.01 * k;
    tool.update(t, t < 22.5 ? flow : 0.0, SubView());
    none.update(t, flow, SubView());
    const std::uint64_t wanted = t < 7.0 - 1e-9 ? 0 : std::min(4.0, std::floor((t - 2.0 + 1e-9) / 5.0));
    ASSERT_EQ(wanted, tool.arrived().sequence) << t;
    ASSERT_EQ(0u, none.arrived().sequence);
  }
}

TEST(DynamicsTool, standsStillWithoutAnIndex)
{
  DynamicsTool tool(every(1.0));
  for (int k = 0; k <= 100; ++k) tool.update(0.01 * k, flow, SubView());
  EXPECT_EQ(1u, tool.arrived().sequence);
  EXPECT_EQ(0.0, tool.arrived().stick_slip);
}

TEST(DynamicsTool, hasNoIndexForPipeThatIsNotTurned)
{
  // rocks to and fro by 2 rad/s about a mean speed, as while a motor slides or stalls
  for (const double mean : {0.01, -0.01, 0.4, 0.6, -0.6})
  {
    DynamicsTool tool(every(1.0));
    for (int k = 0; k <= 100; ++k)
    {
      SubView view;
      view.spin_speed = mean + 2.0 * std::sin(2.0 * M_PI * 0.01 * k);
      tool.update(0.01 * k, flow, view);
    }
    EXPECT_NEAR(std::abs(mean) < DynamicsTool::turning ? 0.0 : 2.0 / 0.6, tool.arrived().stick_slip, 0.01) << mean;
  }
}

// Above the collars of a vertical well without friction: nothing on it off bottom, the bit's weight, torque and the drive's speed
// on it.
TEST(DynamicsTool, seesWhatTheBitCarries)
{
  Scene scene = drilling_scene(0.3, 0.0);
  scene.instruments.dynamics = every(4.0);
  scene.instruments.dynamics.from_bit = 19.0;
  Simulator rig(scene);
  drill_ahead(rig, 90.0 * rpm, 0.001, 0.0);
  play(rig, 12.1);
  const double hangs = rig.truth().hook_load;
  ASSERT_GT(rig.readings().dynamics.sequence, 0u);
  EXPECT_NEAR(rig.readings().dynamics.md, rig.truth().bit_depth - 19.0, 1e-9);
  EXPECT_NEAR(rig.readings().dynamics.weight, 0.0, 0.01 * hangs);
  drill_ahead(rig, 90.0 * rpm, 0.001, 0.01);
  play(rig, 60.0);
  double weight = 0.0, torque = 0.0;
  const std::uint64_t before = rig.readings().dynamics.sequence;
  const double began = rig.readings().dynamics.time;
  int frames = 0;
  while (rig.readings().dynamics.sequence < before + 2)
  {
    play(rig, 0.01);
    if (rig.truth().time > began + 4.0 + 1e-9)
    {
      weight += rig.truth().wob;
      torque += rig.truth().bit_torque;
      ++frames;
    }
  }
  const DynamicsReading& r = rig.readings().dynamics;
  EXPECT_GT(weight / frames, 3e3);
  EXPECT_NEAR(r.weight, weight / frames, 0.03 * weight / frames);
  EXPECT_NEAR(r.torque, torque / frames, 0.05 * torque / frames);
  EXPECT_NEAR(r.speed, 90.0 * rpm, 0.05);
  EXPECT_LT(r.least_speed, r.speed);
  EXPECT_GT(r.largest_speed, r.speed);
}
}  // namespace test_sim_dynamics_tool
