// SPDX-License-Identifier: BSD-3-Clause
// A run ends at its duration or its depth, whichever comes first, or where a frame fails; every frame is told once.
#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <vector>

#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/scene/read_scene.h"
#include "drill_rig_sim/sim/run.h"
#include "in_source.h"

namespace drill_rig_sim::test_sim_run
{
namespace
{
constexpr double kFrame = 0.01;  // [s]

Scene quick(const std::string& program)
{
  return read_scene(in_source("config/scenes/quick.yaml"), {"program=" + program});
}

// lowers a turning bit onto the bottom and into it, 10 cm/s from 5 cm above it on
Scene drilling()
{
  const std::string program = "program=[{at: 0, top_drive_speed_rpm: 120, block_velocity: -0.1}]";
  return read_scene(in_source("config/scenes/quick.yaml"), {"start.bit_depth=99.95", program});
}

TEST(PlayFrame, GivesTheProgramsLinesBeforeTheFrame)
{
  const Scene scene = quick("[{at: 0, flow: 0.02}]");
  Simulator simulator(scene);
  ScenePlayer program(scene);
  ASSERT_EQ(play_frame(simulator, &program, kFrame), FrameStatus::running);
  EXPECT_DOUBLE_EQ(simulator.truth().setpoints.pump.flow, 0.02) << "in force in the frame itself";
  EXPECT_DOUBLE_EQ(simulator.truth().time, kFrame);
}

TEST(PlayFrame, WithoutAProgramTheSetPointsStay)
{
  Simulator simulator(quick("[{at: 0, flow: 0.02}]"));
  simulator.command(PumpSetpoint{0.01});
  ASSERT_EQ(play_frame(simulator, nullptr, kFrame), FrameStatus::running);
  EXPECT_DOUBLE_EQ(simulator.truth().setpoints.pump.flow, 0.01);
  EXPECT_DOUBLE_EQ(simulator.truth().time, kFrame);
}

TEST(Run, FramesAreWholeSteps)
{
  EXPECT_DOUBLE_EQ(frame_of_whole_steps(0.01, 0.002), 0.01);
  EXPECT_DOUBLE_EQ(frame_of_whole_steps(0.01, 0.003), 0.009);
  EXPECT_DOUBLE_EQ(frame_of_whole_steps(0.01, 0.0035), 0.0105);
  EXPECT_DOUBLE_EQ(frame_of_whole_steps(0.01, 0.05), 0.05) << "one step at least";
}

TEST(Run, PlaysFramesOfWholeSteps)
{
  const Scene scene = read_scene(in_source("config/scenes/quick.yaml"), {"numerics.step=0.003"});
  Simulator simulator(scene);
  ScenePlayer program(scene);
  std::vector<double> times;
  EXPECT_EQ(RunEnd::duration, run(simulator, program, {0.027}, kFrame, [&](const Truth& m) { times.push_back(m.time); }));
  ASSERT_EQ(3u, times.size()) << "of 9 ms each";
  EXPECT_NEAR(times[0], 0.009, 1e-12);
}

TEST(Run, EndsAfterItsDurationAndTellsEachFrameOnce)
{
  const Scene scene = quick("[{at: 0.1, flow: 0.02}]");
  Simulator simulator(scene);
  ScenePlayer program(scene);
  std::vector<double> times;
  const auto note = [&](const Truth& m) { times.push_back(m.time); };

  ASSERT_EQ(run(simulator, program, {0.3}, kFrame, note), RunEnd::duration);
  ASSERT_EQ(times.size(), 30U);
  for (std::size_t i = 0; i < times.size(); ++i) EXPECT_NEAR(times[i], static_cast<double>(i + 1) * kFrame, 1e-9);
  EXPECT_TRUE(program.finished());
  EXPECT_DOUBLE_EQ(simulator.truth().setpoints.pump.flow, 0.02);

  // a second run goes on from there
  ASSERT_EQ(run(simulator, program, {0.2}, kFrame, note), RunEnd::duration);
  EXPECT_EQ(times.size(), 50U);
  EXPECT_NEAR(simulator.truth().time, 0.5, 1e-9);
}

TEST(Run, EndsWithTheFirstFrameThatReachesTheDepth)
{
  const Scene scene = drilling();
  Simulator simulator(scene);
  ScenePlayer program(scene);
  const double depth = scene.well.hole_depth + 0.01;
  double before = 0.0, last = scene.well.hole_depth;
  const auto note = [&](const Truth& m)
  {
    before = last;
    last = m.hole_depth;
  };
  ASSERT_EQ(run(simulator, program, {10.0, depth}, kFrame, note), RunEnd::depth);
  EXPECT_LT(before, depth);
  EXPECT_GE(last, depth);
  EXPECT_LT(simulator.truth().time, 9.0);

  // reached already: no frame at all
  const double now = simulator.truth().time;
  EXPECT_EQ(run(simulator, program, {10.0, depth}, kFrame), RunEnd::depth);
  EXPECT_EQ(simulator.truth().time, now);
}

TEST(Run, EndsWhereAFrameFailsAndTellsNothingOfIt)
{
  const Scene scene = read_scene(in_source("test/scenes/unsolvable.yaml"));
  Simulator simulator(scene);
  ScenePlayer program(scene);
  double told = 0.0;
  ASSERT_EQ(run(simulator, program, {60.0}, kFrame, [&](const Truth& m) { told = m.time; }), RunEnd::failure);
  EXPECT_STRNE(simulator.failure(), "");
  EXPECT_EQ(told, simulator.truth().time) << "the last good frame";
}

TEST(Run, WhatTheCallbackThrowsEndsIt)
{
  Simulator simulator(quick("[]"));
  ScenePlayer program;
  const auto full_disk = [](const Truth&) { throw std::runtime_error("full"); };
  EXPECT_THROW(run(simulator, program, {1.0}, kFrame, full_disk), std::runtime_error);
  EXPECT_NEAR(simulator.truth().time, kFrame, 1e-12);
}

}  // namespace
}  // namespace drill_rig_sim::test_sim_run
