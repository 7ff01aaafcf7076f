// SPDX-License-Identifier: BSD-3-Clause
// Steps longer than frames: what the frames between show, commands at their own frame, snapshots on the way, energy.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "drill_ahead.h"
#include "drill_rig_sim/model/interpolate.h"
#include "drill_rig_sim/solve/start.h"
#include "sim_numbers.h"
#include "test_scenes.h"

namespace test_sim_strides
{
using namespace drill_rig_sim;

namespace
{
constexpr double kFrame = 0.01;

Scene with_step(Scene scene, double step)
{
  scene.numerics.step = step;
  return scene;
}

/// On the way down, some seconds after the last command: in the middle of a stride.
Simulator on_the_way(const Scene& scene, int frames = 1503)
{
  Simulator rig(scene, 7);
  drill_ahead(rig, 0.0, 0.03, 0.01);
  for (int k = 0; k < frames; ++k) EXPECT_EQ(rig.frame(kFrame), FrameStatus::running) << rig.failure();
  return rig;
}

void play(Simulator& rig, int frames, double frame = kFrame)
{
  for (int k = 0; k < frames; ++k) ASSERT_EQ(rig.frame(frame), FrameStatus::running) << rig.failure();
}

const Scene& variable()
{
  static const Scene scene = with_step(vertical_scene(400.0, 290.0), 0.0);
  return scene;
}

bool under_way(const Simulator& rig)
{
  return rig.save()->stride.length > 0.0;
}

/// Plays on until a stride is under way.
void into_a_stride(Simulator& rig)
{
  for (int k = 0; k < 200 && !under_way(rig); ++k) ASSERT_EQ(rig.frame(kFrame), FrameStatus::running);
  ASSERT_TRUE(under_way(rig));
}
}  // namespace

TEST(Strides, aQuietRigTakesFewerStepsThanFrames)
{
  Simulator rig = on_the_way(variable());
  const std::uint64_t before = rig.statistics().steps;
  play(rig, 1000);
  EXPECT_LT(rig.statistics().steps - before, 400u);
}

TEST(Strides, timeAdvancesByTheFrame)
{
  Simulator rig(variable());
  for (int k = 1; k <= 500; ++k)
  {
    ASSERT_EQ(rig.frame(kFrame), FrameStatus::running);
    ASSERT_NEAR(rig.truth().time, k * kFrame, 1e-9);
  }
}

TEST(Strides, betweenTheEndsOfAStepAreItsEnds)
{
  const RigAtRest rig = build_at_rest(variable());
  State end = rig.state, out = rig.state;
  end.time = 0.05;
  end.drive.angle = 0.3;
  end.hydraulics.stand_pipe_pressure = 1e6;
  for (NodeState& node : end.nodes)
  {
    node.position.z() -= 0.01;
    node.rate.spin = 2.0;
    node.spin_angle += 0.1;
  }
  interpolate(rig.state, end, 0.0, out);
  EXPECT_EQ(out.nodes[3].position, rig.state.nodes[3].position);
  EXPECT_EQ(out.drive.angle, 0.0);
  interpolate(rig.state, end, 1.0, out);
  EXPECT_TRUE(out.nodes[3].position.isApprox(end.nodes[3].position, 1e-15));
  EXPECT_EQ(out.drive.angle, 0.3);
  interpolate(rig.state, end, 0.5, out);
  EXPECT_NEAR(out.time, 0.025, 1e-15);
  EXPECT_NEAR(out.nodes[3].rate.spin, 1.0, 1e-15);
  EXPECT_NEAR(out.hydraulics.stand_pipe_pressure, 0.5e6, 1e-6);
}

// By the same turn in every part of a step, as the sines of the arc have it.
TEST(Strides, onTheWayNodesTurnEvenly)
{
  const RigAtRest rig = build_at_rest(variable());
  for (const double angle : {1e-9, 1e-3, 0.5, 1.1, 1.4, 3.0})  // [rad]
    for (const double sign : {1.0, -1.0})                      // a turn has two quaternions
    {
      State end = rig.state, out = rig.state;
      for (NodeState& node : end.nodes)
      {
        node.orientation = node.orientation * Eigen::AngleAxisd(angle, Eigen::Vector3d(2.0, -1.0, 0.5).normalized());
        node.orientation.coeffs() *= sign;
      }
      for (const double share : {0.0, 0.1, 0.5, 0.93, 1.0})
      {
        interpolate(rig.state, end, share, out);
        EXPECT_NEAR(out.nodes[3].orientation.norm(), 1.0, 1e-12);
        EXPECT_NEAR(Eigen::AngleAxisd(rig.state.nodes[3].orientation.conjugate() * out.nodes[3].orientation).angle(),
                    share * angle, 1e-11)
            << angle;
      }
    }
}

// Against steps of a millisecond: start, stop and a change of direction in one run, commands in the middle of strides.
TEST(Strides, commandsActAtTheirOwnFrame)
{
  Scene damped = variable();  // as a string in mud is: waves that never die are late by ever more
  damped.mud.axial_damping = 12.0;
  const auto course = [](const Scene& scene, const std::function<void(const Truth&, int)>& see)
  {
    Simulator rig(scene);
    for (int k = 0; k < 2400; ++k)
    {
      if (k == 1003) rig.command(WinchSetpoint{0.2, false});
      if (k == 1707) rig.command(WinchSetpoint{-0.1, false});
      ASSERT_EQ(rig.frame(kFrame), FrameStatus::running);
      see(rig.truth(), k);
    }
  };
  std::vector<double> height, load;
  course(with_step(damped, 1e-3), [&](const Truth& m, int) { height.push_back(m.block_height), load.push_back(m.hook_load); });
  double square = 0.0;
  course(damped,
         [&](const Truth& m, int k)
         {
           ASSERT_NEAR(m.block_height, height[k], 1e-3) << k;
           square += (m.hook_load - load[k]) * (m.hook_load - load[k]);
         });
  const auto [least, most] = std::minmax_element(load.begin(), load.end());
  EXPECT_LT(std::sqrt(square / static_cast<double>(load.size())), variable().numerics.tolerance * (*most - *least));
}

TEST(Strides, framesAfterASnapshotOnTheWayAreBitIdentical)
{
  Simulator rig = on_the_way(variable());
  into_a_stride(rig);
  const auto saved = rig.save();
  const auto go_on = [](Simulator& r)
  {
    std::vector<double> out;
    for (int k = 0; k < 600; ++k)
    {
      if (k == 251) r.command(WinchSetpoint{0.05, false});
      EXPECT_EQ(r.frame(kFrame), FrameStatus::running);
      const std::vector<double> now = numbers_of(r.truth());
      out.insert(out.end(), now.begin(), now.end());
    }
    return out;
  };
  const std::vector<double> first = go_on(rig);
  ASSERT_TRUE(rig.restore(*saved));
  EXPECT_TRUE(bit_identical(first, go_on(rig)));
  Simulator other(variable());
  ASSERT_TRUE(other.restore(*saved));
  EXPECT_TRUE(bit_identical(first, go_on(other)));
}

// Most frames do not look at the whole string; those that do see it at their own time, whatever the frames before looked at.
TEST(Strides, aFrameShowsTheWholeStringAtItsOwnTime)
{
  Simulator always = on_the_way(variable()), seldom = on_the_way(variable());
  const std::size_t middle = static_cast<std::size_t>(always.statistics().nodes / 2);
  StringProfile first, second, third;
  int seen = 0;
  for (int k = 0; k < 300; ++k)
  {
    std::swap(first, second);
    std::swap(second, third);
    play(always, 1);
    play(seldom, 1);
    always.profile(third);
    if (always.save()->stride.played < 2.5 * kFrame) continue;
    StringProfile once;
    seldom.profile(once);
    ASSERT_EQ(once.position, third.position);
    ASSERT_EQ(once.tension, third.tension);
    const double step = second.position[middle].z() - first.position[middle].z();
    EXPECT_LT(step, -1e-6);
    EXPECT_NEAR(third.position[middle].z() - second.position[middle].z(), step, 1e-9);
    EXPECT_NEAR(third.tension[middle] - second.tension[middle], second.tension[middle] - first.tension[middle], 1e-3);
    ++seen;
  }
  EXPECT_GT(seen, 10);
}

TEST(Strides, framesMayChangeTheirLength)
{
  Simulator rig = on_the_way(variable());
  for (const double frame : {0.01, 0.003, 0.02, 0.001, 0.05, 0.01})
  {
    into_a_stride(rig);
    const double before = rig.truth().time, depth = rig.truth().bit_depth;
    play(rig, 7, frame);
    EXPECT_NEAR(rig.truth().time, before + 7.0 * frame, 1e-9);
    EXPECT_NEAR(rig.truth().bit_depth, depth + 0.07 * frame, 1e-3);
  }
}

TEST(Strides, pipeMaySticksOnTheWay)
{
  Simulator rig = on_the_way(variable());
  into_a_stride(rig);
  const double time = rig.truth().time;
  EXPECT_TRUE(rig.stick_pipe(150.0));
  play(rig, 300);
  EXPECT_NEAR(rig.truth().time, time + 3.0, 1e-9);
  EXPECT_TRUE(all_finite(numbers_of(rig.truth())));
  rig.free_pipe();
  play(rig, 300);
}

TEST(Strides, aControllerThatCommandsEveryFrameCostsNoWorkThatIsThrownAway)
{
  Simulator rig = on_the_way(variable());
  const std::uint64_t before = rig.statistics().steps;
  for (int k = 0; k < 500; ++k)
  {
    rig.command(WinchSetpoint{-0.01 - 1e-6 * (k % 7), false});
    ASSERT_EQ(rig.frame(kFrame), FrameStatus::running);
  }
  EXPECT_LE(rig.statistics().steps - before, 520u);
}

TEST(Strides, energyCloses)
{
  Simulator rig = on_the_way(variable(), 300);
  rig.balance_energy();
  for (int k = 0; k < 1500; ++k)
  {
    if (k % 400 == 203) rig.command(WinchSetpoint{k % 800 < 400 ? 0.1 : -0.1, false});
    ASSERT_EQ(rig.frame(kFrame), FrameStatus::running);
  }
  const EnergyAccounts& accounts = rig.energy();
  EXPECT_LT(std::abs(accounts.closure()), 2e-3 * accounts.input_magnitudes());
}

// The accounts of before a restore do not come back with the next command.
TEST(Strides, energyBeginsAnewWhereAStateIsRestoredWithinAStride)
{
  Simulator rig = on_the_way(variable());
  rig.balance_energy();
  play(rig, 300);
  into_a_stride(rig);
  const auto saved = rig.save();
  play(rig, 600);
  const double before = rig.energy().input_magnitudes();
  ASSERT_GT(before, 0.0);
  ASSERT_TRUE(rig.restore(*saved));
  rig.command(WinchSetpoint{0.0, true});
  play(rig, 5);
  EXPECT_LT(rig.energy().input_magnitudes(), 0.5 * before);
}

// Pipe that pressed on the bit is guided again after ten seconds: frames within a step count too.
TEST(Strides, countForTheSecondsAfterWhichPipeIsGuidedAgain)
{
  constexpr double frame = 0.002;  // a tenth of a step and less [s]
  Scene scene = with_step(vertical_scene(300.0, 299.99, 0.2), 0.0);
  scene.numerics.level = Level::hybrid;
  scene.numerics.free_length = 20.0;
  scene.numerics.element_length = 4.75;
  Simulator rig(scene);
  const auto move = [&rig](double velocity, double seconds)
  {
    rig.command(WinchSetpoint{velocity, false});
    for (int k = 0; k < seconds / frame; ++k) ASSERT_EQ(rig.frame(frame), FrameStatus::running) << rig.failure();
  };
  const int at_start = rig.statistics().coordinates;
  move(-0.01, 5.0);
  move(0.01, 10.0);
  ASSERT_GT(rig.statistics().coordinates, at_start);
  move(0.0, 14.0);
  EXPECT_EQ(rig.statistics().coordinates, at_start);
}

TEST(Strides, aBlowIsSteppedFinely)
{
  Scene scene = with_step(drilling_scene(0.005), 0.0);
  Simulator rig(scene);
  rig.command(WinchSetpoint{-0.1, false});
  double shortest = 1.0;
  for (int k = 0; k < 1500 && !rig.truth().on_bottom; ++k)
  {
    ASSERT_EQ(rig.frame(kFrame), FrameStatus::running);
    shortest = std::min(shortest, rig.save()->mechanics.memory.last_step);
  }
  ASSERT_TRUE(rig.truth().on_bottom);
  for (int k = 0; k < 20; ++k)
  {
    ASSERT_EQ(rig.frame(kFrame), FrameStatus::running);
    shortest = std::min(shortest, rig.save()->mechanics.memory.last_step);
  }
  EXPECT_LT(shortest, 2e-3);
}
}  // namespace test_sim_strides
