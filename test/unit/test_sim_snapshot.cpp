// SPDX-License-Identifier: BSD-3-Clause
// Snapshots: saving and restoring in the middle of everything changes no bit of what follows.
#include <gtest/gtest.h>

#include "drill_ahead.h"
#include "sim_numbers.h"
#include "test_scenes.h"

namespace test_sim_snapshot
{
using namespace drill_rig_sim;

namespace
{
constexpr double kFrame = 0.01;
constexpr int kFrames = 10000;

/// Drilling with noisy, slow instruments and a mud motor.
Scene noisy_scene()
{
  Scene scene = motor_drilling_scene(0.005);
  scene.formation[0].drillability = 3e-8;
  scene.instruments.hook_load = {500.0, 100.0, 0.25, 0.5};
  scene.instruments.torque = {20.0, 0.0, 0.1, 0.2};
  scene.instruments.stand_pipe_pressure = {1e4, 0.0, 0.35, 0.1};
  scene.instruments.mwd.period = 3.0;
  scene.instruments.mwd.latency = 1.0;
  scene.instruments.mwd.noise = 0.001;
  scene.instruments.toolface = {1.0, 0.7};
  return scene;
}

/// Commands that change while the frames are compared.
void disturb(Simulator& rig, int frame)
{
  if (frame == 500) rig.command(WinchSetpoint{-0.006, false});
  if (frame == 1000) rig.command(PumpSetpoint{0.02});
}

using Record = std::vector<std::vector<double>>;

Record run(Simulator& rig, int frames)
{
  Record out(frames);
  for (int k = 0; k < frames; ++k)
  {
    disturb(rig, k);
    EXPECT_EQ(rig.frame(kFrame), FrameStatus::running) << rig.failure();
    numbers_of(rig.truth(), out[k]);
    const std::vector<double> readings = numbers_of(rig.readings());
    out[k].insert(out[k].end(), readings.begin(), readings.end());
  }
  return out;
}

void expect_identical(const Record& a, const Record& b)
{
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t k = 0; k < a.size(); ++k) ASSERT_TRUE(bit_identical(a[k], b[k])) << "frame " << k;
}
}  // namespace

TEST(Snapshot, nextTenThousandFramesAreBitIdentical)
{
  const Scene scene = noisy_scene();
  Simulator rig(scene, 7);
  drill_ahead(rig, 60.0 * rpm, 0.03, 0.01);
  while (rig.truth().time < 17.3) ASSERT_EQ(rig.frame(kFrame), FrameStatus::running);

  // inside a correction interval: drilled since the last permanent node, and not a multiple of the interval
  const Wellbore& well = rig.wellbore();
  const double since = well.hole_depth() - well.node(well.node_count() - 1).md;
  ASSERT_TRUE(rig.truth().on_bottom);
  ASSERT_GT(since, 1e-3);
  ASSERT_LT(since, scene.trajectory.stage_two_length - 1e-3);
  ASSERT_GT(rig.readings().mwd.sequence, 0u);

  const auto snapshot = rig.save();
  const auto version = well.version();
  const Record first = run(rig, kFrames);
  const auto end = rig.save();
  EXPECT_GT(well.hole_depth(), snapshot->mechanics.well.hole_depth() + 0.1) << "has drilled through the end of the interval";

  rig.restore(*snapshot);
  EXPECT_EQ(rig.wellbore().version(), version);
  expect_identical(run(rig, kFrames), first);
  EXPECT_TRUE(bit_identical(numbers_of(rig.save()->mechanics), numbers_of(end->mechanics)));
  EXPECT_EQ(rig.wellbore().version(), end->mechanics.well.version());

  // and in another simulator of the same scene
  Simulator other(scene, 99);
  other.restore(*snapshot);
  expect_identical(run(other, kFrames), first);
}

TEST(Snapshot, ofAStringGuidedAboveTheMotorIsBitIdentical)
{
  Scene scene = noisy_scene();
  scene.numerics.level = Level::hybrid;
  scene.numerics.free_length = 40.0;
  Simulator rig(scene, 7);
  drill_ahead(rig, 60.0 * rpm, 0.03, 0.01);
  while (rig.truth().time < 17.3) ASSERT_EQ(rig.frame(kFrame), FrameStatus::running);
  const auto snapshot = rig.save();
  const Record first = run(rig, 1500);
  rig.restore(*snapshot);
  expect_identical(run(rig, 1500), first);
}

// What a window leaves behind, of its spans and, where the string turns, of its nodes, is no part of the next frame.
TEST(Snapshot, acrossAWindowOfAHybridStringIsBitIdentical)
{
  Scene scene = vertical_scene(300.0, 299.99, 0.2);
  scene.numerics.element_length = 4.75;
  scene.numerics.level = Level::hybrid;
  scene.numerics.free_length = 20.0;
  for (const double speed : {0.0, 60.0 * rpm})
  {
    Simulator rig(scene);
    const auto run_window = [speed](Simulator& one)
    {
      Record out;
      TopDriveSetpoint drive;
      drive.speed = speed;
      one.command(drive);
      const auto move = [&](double velocity, double seconds)
      {
        one.command(WinchSetpoint{velocity, false});
        for (int k = 0; k < seconds / kFrame; ++k)
        {
          EXPECT_EQ(one.frame(kFrame), FrameStatus::running);
          out.push_back(numbers_of(one.save()->mechanics));
        }
      };
      move(-0.01, 5.0);
      move(0.01, 7.0);
      move(0.0, 14.0);
      return out;
    };
    const auto snapshot = rig.save();
    const Record first = run_window(rig);
    EXPECT_EQ(rig.save()->levels.closed, 1u) << speed;
    rig.restore(*snapshot);
    expect_identical(run_window(rig), first);
    Simulator other(scene);
    expect_identical(run_window(other), first);
  }
}

// Out of one layer into the next: the hole drilled in each has its friction, and a hole that is taken back and drilled anew has
// it again.
TEST(Snapshot, keepsTheFrictionThatTheRockGaveTheHole)
{
  Scene scene = drilling_scene(0.005);
  scene.formation.insert(scene.formation.begin(), scene.formation[0]);
  scene.formation[0].to_tvd = 100.15;
  scene.formation[0].friction = 0.18;
  scene.formation[1].friction = 0.37;
  Simulator rig(scene, 7);
  const auto start = rig.save();
  const Wellbore& well = rig.wellbore();
  const auto drill_to = [&rig](double depth)
  {
    drill_ahead(rig, 60.0 * rpm, 0.03, 0.01);
    while (rig.wellbore().hole_depth() < depth && rig.truth().time < 120.0) ASSERT_EQ(rig.frame(kFrame), FrameStatus::running);
  };
  drill_to(100.22);
  const auto between = rig.save();
  drill_to(100.45);
  const auto expect_layers = [&well]
  {
    EXPECT_EQ(well.at(99.9).friction, 0.25) << "hole that was there";
    EXPECT_NEAR(well.at(100.105).friction, 0.18, 0.02);
    EXPECT_NEAR(well.at(100.35).friction, 0.37, 1e-12);
  };
  expect_layers();
  const auto version = well.version();
  rig.restore(*between);
  drill_to(100.45);
  EXPECT_EQ(well.version(), version);
  expect_layers();
  rig.restore(*start);
  EXPECT_EQ(well.at(100.35).friction, 0.25) << "not drilled any more";
  drill_to(100.45);
  EXPECT_EQ(well.version(), version);
  expect_layers();
}

TEST(Snapshot, sameSeedAndCommandsGiveTheSameBits)
{
  const Scene scene = noisy_scene();
  Simulator a(scene, 3), b(scene, 3), c(scene, 4);
  for (Simulator* rig : {&a, &b, &c}) drill_ahead(*rig, 60.0 * rpm, 0.03, 0.01);
  const Record of_a = run(a, 1000);
  expect_identical(run(b, 1000), of_a);
  const Record of_c = run(c, 1000);
  EXPECT_FALSE(bit_identical(of_c.back(), of_a.back())) << "another seed, other noise";
}

// The clock alone runs on: everything else follows bit by bit, times shifted. Time enters sums (k h), so only what does not hold
// a time is compared, and instruments to the round-off of their clocks' differences. The streams of commands end on the way.
// A hole inclined at the table: a warning of the model, after some frames.
TEST(Snapshot, bringsTheReasonOfItsWarningBack)
{
  Scene scene = vertical_scene(400.0, 290.0);
  for (SurveyStation& station : scene.well.survey) station.inclination = 12.0 * degree;
  Simulator rig(scene);
  const auto before = rig.save();
  for (int k = 0; k < 100; ++k) rig.frame(kFrame);
  const auto warned = rig.save();
  ASSERT_EQ(rig.statistics().accuracy.doubt, AccuracyDoubt::slant);
  ASSERT_TRUE(rig.restore(*before));
  EXPECT_EQ(rig.statistics().accuracy.doubt, AccuracyDoubt::none);
  EXPECT_FALSE(rig.truth().accuracy_warning);
  ASSERT_TRUE(rig.restore(*warned));
  EXPECT_EQ(rig.statistics().accuracy.doubt, AccuracyDoubt::slant);
  EXPECT_TRUE(rig.truth().accuracy_warning);
}

}  // namespace test_sim_snapshot
