// The program player gives each line's set points when its time has come, once, and leaves the others alone.
#include <gtest/gtest.h>

#include <string>

#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/scene/read_scene.h"
#include "drill_rig_sim/sim/program.h"
#include "drill_rig_sim/sim/simulator.h"
#include "in_source.h"

namespace drill_rig_sim
{
namespace
{
constexpr double kFrame = 0.01;  // [s]

Scene quick(const std::string& program)
{
  return read_scene(in_source("config/scenes/quick.yaml"), {"program=" + program});
}

struct Show
{
  Simulator simulator;
  ProgramPlayer program;

  explicit Show(const Scene& scene) : simulator(scene), program(scene.program) {}

  // plays until just after `time`
  const Setpoints& play(double time)
  {
    while (simulator.truth().time < time + 1.5 * kFrame)
    {
      program.apply(simulator);
      EXPECT_EQ(simulator.frame(kFrame), FrameStatus::running) << simulator.failure();
    }
    return simulator.truth().setpoints;
  }
};

TEST(ProgramPlayer, LinesActAtTheirTimes)
{
  Show show(
      quick("[{at: 0, top_drive_speed_rpm: 60, flow: 0.02}, {at: 0.5, block_velocity: 0.1}, {at: 1, brake: true, "
            "top_drive_torque: 500}]"));
  const Setpoints first = show.play(0.2);
  EXPECT_DOUBLE_EQ(first.top_drive.speed, 60.0 * rpm);
  EXPECT_EQ(first.top_drive.mode, TopDriveMode::speed);
  EXPECT_DOUBLE_EQ(first.pump.flow, 0.02);
  EXPECT_TRUE(first.winch.brake) << "as at the start";

  const Setpoints second = show.play(0.7);
  EXPECT_FALSE(second.winch.brake) << "a velocity releases the brake";
  EXPECT_DOUBLE_EQ(second.winch.block_velocity, 0.1);
  EXPECT_DOUBLE_EQ(second.top_drive.speed, 60.0 * rpm) << "left alone";
  EXPECT_FALSE(show.program.finished());

  const Setpoints third = show.play(1.1);
  EXPECT_TRUE(third.winch.brake);
  EXPECT_EQ(third.top_drive.mode, TopDriveMode::torque);
  EXPECT_DOUBLE_EQ(third.top_drive.torque, 500.0);
  EXPECT_DOUBLE_EQ(third.pump.flow, 0.02);
  EXPECT_TRUE(show.program.finished());
}

// A brake of its own: set, it holds the velocity that stands; released, that velocity acts again.
TEST(ProgramPlayer, BrakeIsSetAndReleased)
{
  Show show(
      quick("[{at: 0, block_velocity: 0.1}, {at: 0.2, brake: true}, {at: 0.4, brake: false}, {at: 0.6, brake: false, block_velocity: "
            "-0.02}, {at: 0.8, brake: true}, {at: 1.0, block_velocity: 0.03}]"));
  EXPECT_FALSE(show.play(0.1).winch.brake);
  const Setpoints set = show.play(0.3);
  EXPECT_TRUE(set.winch.brake);
  EXPECT_DOUBLE_EQ(set.winch.block_velocity, 0.1) << "kept";
  EXPECT_TRUE(show.simulator.truth().brake_set);
  const Setpoints released = show.play(0.5);
  EXPECT_FALSE(released.winch.brake);
  EXPECT_DOUBLE_EQ(released.winch.block_velocity, 0.1);
  EXPECT_FALSE(show.simulator.truth().brake_set);
  const Setpoints both = show.play(0.7);
  EXPECT_FALSE(both.winch.brake);
  EXPECT_DOUBLE_EQ(both.winch.block_velocity, -0.02);
  EXPECT_TRUE(show.play(0.9).winch.brake);
  const Setpoints last = show.play(1.1);
  EXPECT_FALSE(last.winch.brake) << "a velocity releases it";
  EXPECT_DOUBLE_EQ(last.winch.block_velocity, 0.03);
}

// A line acts in the frame that starts at its time, not in the one before; what it leaves out stays as it was.
TEST(ProgramPlayer, LinesActInOrderFromTheFrameThatStartsAtTheirTime)
{
  Show show(quick("[{at: 0.03, flow: 0.01}, {at: 0.05, flow: 0.02, top_drive_torque: 300}, {at: 0.07, top_drive_speed_rpm: 30}]"));
  for (int k = 0; k < 12; ++k)
  {
    show.program.apply(show.simulator);
    ASSERT_EQ(show.simulator.frame(kFrame), FrameStatus::running);
    const Setpoints& now = show.simulator.truth().setpoints;
    const double flow = k >= 5 ? 0.02 : k >= 3 ? 0.01 : 0.0;
    EXPECT_DOUBLE_EQ(now.pump.flow, flow) << k;
    EXPECT_DOUBLE_EQ(show.simulator.truth().flow, flow) << k;
    EXPECT_DOUBLE_EQ(now.top_drive.torque, k >= 5 ? 300.0 : 0.0) << k;
    EXPECT_DOUBLE_EQ(now.top_drive.speed, k >= 7 ? 30.0 * rpm : 0.0) << k;
    EXPECT_EQ(now.top_drive.mode, k >= 5 && k < 7 ? TopDriveMode::torque : TopDriveMode::speed) << k;
    EXPECT_TRUE(now.winch.brake);
  }
}

// A program that comes late gives all lines that are due at once, in their order.
TEST(ProgramPlayer, LinesThatAreOverdueActInTheirOrder)
{
  const Scene scene = quick("[{at: 0, flow: 0.01}, {at: 0.05, flow: 0.02, top_drive_torque: 300}, {at: 0.1, top_drive_speed_rpm: 30}, {at: 9, flow: 0}]");
  Show show(scene);
  for (int k = 0; k < 20; ++k) ASSERT_EQ(show.simulator.frame(kFrame), FrameStatus::running);
  show.program.apply(show.simulator);
  ASSERT_EQ(show.simulator.frame(kFrame), FrameStatus::running);
  const Setpoints& now = show.simulator.truth().setpoints;
  EXPECT_DOUBLE_EQ(now.pump.flow, 0.02);
  EXPECT_EQ(now.top_drive.mode, TopDriveMode::speed);
  EXPECT_DOUBLE_EQ(now.top_drive.speed, 30.0 * rpm);
  EXPECT_DOUBLE_EQ(now.top_drive.torque, 300.0) << "kept for torque mode";
  EXPECT_FALSE(show.program.finished());
}

TEST(ProgramPlayer, ALineActsOnce)
{
  Show show(quick("[{at: 0, flow: 0.02}]"));
  show.play(0.1);
  show.simulator.command(PumpSetpoint{0.01});
  EXPECT_DOUBLE_EQ(show.play(0.3).pump.flow, 0.01) << "a later command stands";
}

TEST(ProgramPlayer, RewindPlaysFromTheFirstLine)
{
  Show show(quick("[{at: 0, flow: 0.02}]"));
  show.play(0.1);
  show.simulator.command(PumpSetpoint{0.01});
  show.program.rewind();
  EXPECT_DOUBLE_EQ(show.play(0.3).pump.flow, 0.02);
}

}  // namespace
}  // namespace drill_rig_sim

int main(int argc, char** argv)
{
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
