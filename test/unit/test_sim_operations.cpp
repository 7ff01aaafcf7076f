// SPDX-License-Identifier: BSD-3-Clause
// What a driller does, one thing after the other: feed by weight against its closed form, and each operation's end.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/sim/run.h"
#include "operating.h"
#include "playing.h"
#include "test_scenes.h"

namespace test_sim_operations
{
using namespace drill_rig_sim;
using namespace operating;

namespace
{
Operation wait(double time)
{
  Operation o = operation(OperationKind::wait);
  o.time = time;
  return o;
}

Operation move(OperationKind kind, double speed, double distance)
{
  Operation o = operation(kind);
  o.speed = speed;
  o.distance = distance;
  return o;
}

}  // namespace

// Rock that does not give way: W* - W = W* exp(-t/T).
TEST(WeightFeed, closesOnTheWeightWithItsTime)
{
  constexpr double stiffness = 2e5, wanted = 50e3, dt = 1e-3;
  WeightFeed feed;
  double weight = 0.0;
  for (int k = 1; k <= 60000; ++k)
  {
    weight += -feed.velocity(weight, wanted, stiffness, 1.0, dt) * stiffness * dt;
    ASSERT_NEAR(wanted - weight, wanted * std::exp(-k * dt / WeightFeed::feed_time), 1e-3 * wanted) << k;
  }
}

// Rock that gives way, from hard to soft beside the string: no lasting error, and soon.
TEST(WeightFeed, leavesNoErrorWhileItDrills)
{
  constexpr double wanted = 50e3, dt = 0.01;
  for (const double stiffness : {5e4, 1e6, 1e7})
    for (const double rop : {1e-4, 1e-3, 1e-2})
      for (const double threshold : {0.0, 20e3})
      {
        WeightFeed feed;
        double weight = 5e3;
        for (int k = 0; k < 8000; ++k)
        {
          const double rate = rop * std::max(0.0, weight - threshold) / (wanted - threshold);
          weight += (-feed.velocity(weight, wanted, stiffness, 0.05, dt) - rate) * stiffness * dt;
        }
        EXPECT_NEAR(weight, wanted, 0.03 * wanted) << stiffness << ' ' << rop << ' ' << threshold;
      }
}

TEST(WeightFeed, keepsItsLimit)
{
  WeightFeed feed;
  for (int k = 0; k < 1000; ++k) EXPECT_EQ(feed.velocity(0.0, 1e6, 1e5, 0.05, 0.1), -0.05);
  EXPECT_EQ(feed.velocity(3e6, 1e6, 1e5, 0.05, 0.1), 0.0) << "it never lifts";
}

TEST(Operations, followEachOther)
{
  Simulator rig(scene_with({flow(0.02), rotate(60.0 * rpm, 5.0), wait(2.0)}));
  ScenePlayer player(rig.scene());
  play_up_to(2, rig, player);
  EXPECT_EQ(rig.setpoints().pump.flow, 0.02);
  EXPECT_NEAR(rig.truth().time, frame, 1e-9);
  play_up_to(3, rig, player);
  EXPECT_NEAR(player.operations().began()[2], 5.0, 1e-9);
  EXPECT_EQ(rig.setpoints().top_drive.speed, 60.0 * rpm);
  EXPECT_FALSE(player.finished());
  play_up_to(0, rig, player);
  EXPECT_TRUE(player.finished());
  EXPECT_NEAR(player.operations().began()[3], 7.0, 1e-9);
}

TEST(Operations, aRampIsStraight)
{
  Simulator rig(scene_with({rotate(60.0 * rpm, 5.0)}));
  ScenePlayer player(rig.scene());
  for (int k = 0; k < 251; ++k) ASSERT_EQ(play_frame(rig, &player, frame), FrameStatus::running);
  EXPECT_NEAR(rig.setpoints().top_drive.speed, 30.0 * rpm, 1e-9);
  EXPECT_NEAR(player.operations().status().progress, 0.5, 1e-6);
}

TEST(Operations, tagDrillAndPickUp)
{
  Scene scene = scene_with(
      {flow(0.02), rotate(60.0 * rpm, 5.0), operation(OperationKind::tag), drill(0.3), move(OperationKind::pick_up, 0.2, 3.0)});
  scene.formation[0].drillability = 2e-8;  // 2.5 mm/s: some periods of the feed
  Simulator rig(scene);
  ScenePlayer player(rig.scene());
  play_up_to(4, rig, player);
  EXPECT_TRUE(rig.readings().tared);
  EXPECT_GE(rig.readings().surface_wob, 5e3);
  EXPECT_TRUE(rig.truth().on_bottom);
  const double hole = rig.readings().hole_depth;
  double sum = 0.0;
  int count = 0;
  while (player.operations().status().number == 4)
  {
    ASSERT_EQ(play_frame(rig, &player, frame), FrameStatus::running);
    if (player.operations().status().progress < 0.5) continue;
    sum += rig.truth().wob;
    ++count;
  }
  EXPECT_NEAR(sum / count, 20e3, 400.0);
  EXPECT_NEAR(rig.readings().hole_depth, hole + 0.3, 1e-3);
  const double block = rig.readings().block_height;
  play_up_to(0, rig, player);
  EXPECT_TRUE(rig.setpoints().winch.brake);
  play(rig, 1.0);
  EXPECT_NEAR(rig.readings().block_height, block + 3.0, 0.01);
}

// By the dead line, whose sheaves take a tenth of the load when they turn back: rock that gets hard for a while leaves too much
// weight on the bit, which is drilled off.
TEST(Operations, drillDoesNotRunAwayFromHardRockByTheDeadLine)
{
  Scene scene = scene_with({rotate(60.0 * rpm, 5.0), operation(OperationKind::tag), drill(50.0)});
  scene.instruments.hook_load.place = HookLoadPlace::dead_line;
  Simulator rig(scene);
  ScenePlayer player(rig.scene());
  play_up_to(3, rig, player);
  const auto play_frames = [&](double seconds)
  {
    double weight = 0.0;
    for (int k = 0; k < std::lround(seconds / frame); ++k)
    {
      EXPECT_EQ(play_frame(rig, &player, frame), FrameStatus::running) << rig.failure();
      EXPECT_LE(rig.setpoints().winch.block_velocity, 0.0);
      weight += rig.truth().wob * frame / seconds;
    }
    return weight;
  };
  play_frames(20.0);
  ASSERT_EQ(rig.inject({FaultKind::formation_change, 0.0, 0.02, Gauge::hook_load}), nullptr);
  play_frames(4.0);
  rig.clear(FaultKind::formation_change, Gauge::hook_load);
  play_frames(30.0);
  EXPECT_GT(play_frames(20.0), 5e3);
}

TEST(Operations, reamGoesUpAndDownAgain)
{
  Operation ream = move(OperationKind::ream, 0.5, 2.0);
  ream.times = 2;
  Simulator rig(scene_with({ream}, 5.0));
  ScenePlayer player(rig.scene());
  const double block = rig.readings().block_height;
  double highest = 0.0, before = block, turns = 0.0;
  bool up = true;
  while (!player.finished())
  {
    ASSERT_EQ(play_frame(rig, &player, frame), FrameStatus::running);
    const double height = rig.readings().block_height;
    highest = std::max(highest, height);
    if ((height > before) != up && std::abs(height - before) > 1e-4) ++turns, up = !up;
    before = height;
  }
  EXPECT_EQ(turns, 3);
  EXPECT_NEAR(highest, block + 2.0, 0.02);
  play(rig, 2.0);
  EXPECT_NEAR(rig.readings().block_height, block, 0.02);
}

TEST(Operations, anOverpullEndsAPickUp)
{
  Scene scene = scene_with({move(OperationKind::pick_up, 0.05, 5.0)}, 5.0);
  scene.operations[0].overpull = 50e3;
  Simulator rig(scene);
  ASSERT_TRUE(rig.stick_pipe(60.0));
  ScenePlayer player(rig.scene());
  const double load = rig.readings().hook_load;
  play_up_to(0, rig, player);
  EXPECT_NEAR(rig.readings().hook_load, load + 50e3, 8e3);
  EXPECT_TRUE(rig.setpoints().winch.brake);
}

TEST(Operations, slideTurnsToTheToolface)
{
  Scene scene = slanted_scene(150.0, 0.2);
  scene.string = {bit_part(0.2), motor_part(), mwd_part(), collar_part(2, 9.4), pipe_part(0, 9.5, tool_jointed_mass)};
  scene.instruments.toolface = {};
  Operation slide = operation(OperationKind::slide);
  slide.toolface = 90.0 * degree;
  slide.weight = 1e3;  // off bottom it lowers slowly
  slide.speed = 0.01;
  slide.time = 90.0;
  scene.operations = {flow(0.02), slide};
  Simulator rig(scene);
  ScenePlayer player(rig.scene());
  play_up_to(0, rig, player);
  EXPECT_NEAR(std::remainder(rig.truth().bend_toolface - 90.0 * degree, 2.0 * pi), 0.0, 10.0 * degree);
}

TEST(Operations, oscillateGoesOnWhileOthersFollow)
{
  Operation rock = operation(OperationKind::oscillate);
  rock.amplitude_right = rock.amplitude_left = 1.0;
  Simulator rig(scene_with({rock, wait(1.0)}));
  ScenePlayer player(rig.scene());
  play_up_to(2, rig, player);
  EXPECT_EQ(rig.setpoints().top_drive.mode, TopDriveMode::oscillate);
  EXPECT_EQ(rig.setpoints().top_drive.amplitude_left, 1.0);
}

TEST(Operations, goOnFromASnapshotBitForBit)
{
  Simulator rig(scene_with({flow(0.02), rotate(60.0 * rpm, 5.0), operation(OperationKind::tag), drill(0.3)}));
  ScenePlayer player(rig.scene());
  play_up_to(4, rig, player);
  const auto state = rig.save();
  const ScenePlayer there = player;
  const auto play_on = [&](ScenePlayer from)
  {
    for (int k = 0; k < 500; ++k) EXPECT_EQ(play_frame(rig, &from, frame), FrameStatus::running);
    return std::make_pair(rig.truth(), from.operations().status().progress);
  };
  const auto [once, progress] = play_on(there);
  ASSERT_TRUE(rig.restore(*state));
  const auto [again, progress_again] = play_on(there);
  EXPECT_EQ(once.hook_load, again.hook_load);
  EXPECT_EQ(once.hole_depth, again.hole_depth);
  EXPECT_EQ(progress, progress_again);
}

TEST(Operations, drillingWithoutAZeroIsGivenUp)
{
  Scene scene = scene_with({drill(0.3)}, 0.0);
  scene.start.weight_on_bit = 5e3;
  Simulator rig(scene);
  ScenePlayer player(rig.scene());
  ASSERT_EQ(play_frame(rig, &player, frame), FrameStatus::running) << rig.failure();
  EXPECT_EQ(player.operations().status().trouble, OperationTrouble::no_zero);
  EXPECT_TRUE(rig.asked().winch.brake);
}

TEST(Operations, endARun)
{
  Simulator rig(scene_with({wait(2.0)}));
  ScenePlayer player(rig.scene());
  RunGoal goal;
  goal.duration = 100.0;
  goal.goes_on = 1.0;
  EXPECT_EQ(run(rig, player, goal, frame), RunEnd::played);
  EXPECT_NEAR(rig.truth().time, 3.0, 0.02);
}

TEST(Operations, aRunEndsWhereOneGetsNowhere)
{
  Scene scene = scene_with({operation(OperationKind::tag), drill(0.3)});
  scene.formation[0].threshold = 1e6;  // no weight that it has breaks the rock
  Simulator rig(scene);
  ScenePlayer player(rig.scene());
  RunGoal goal;
  goal.duration = 1e4;
  goal.patience = 60.0;
  EXPECT_EQ(run(rig, player, goal, frame), RunEnd::standstill);
  EXPECT_LT(rig.truth().time, 300.0);
}
}  // namespace test_sim_operations
