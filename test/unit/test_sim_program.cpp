// The program player gives each line's set points when its time has come, once, and leaves the others alone.
#include <gtest/gtest.h>

#include <string>

#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/scene/read_scene.h"
#include "drill_rig_sim/sim/program.h"
#include "drill_rig_sim/sim/simulator.h"

namespace drill_rig_sim
{
namespace
{
constexpr double kFrame = 0.01;  // [s]

Scene quick(const std::string& program)
{
  return read_scene(std::string(DRILL_RIG_SIM_SOURCE_DIR) + "/config/scenes/quick.yaml", {"program=" + program});
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
