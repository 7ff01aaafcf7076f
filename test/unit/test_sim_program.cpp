// SPDX-License-Identifier: BSD-3-Clause
// The program player gives each line's set points when its time has come, once, and leaves the others alone.
#include <gtest/gtest.h>

#include <string>

#include "drill_rig_sim/crew/program.h"
#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/math/visit.h"
#include "drill_rig_sim/scene/read_scene.h"
#include "drill_rig_sim/sim/simulator.h"
#include "drill_rig_sim/sim/simulator_state.h"
#include "in_source.h"

namespace drill_rig_sim::test_sim_program
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
  Show show(quick(
      "[{at: 0, block_velocity: 0.1}, {at: 0.2, brake: true}, {at: 0.4, brake: false}, {at: 0.6, brake: false, block_velocity: "
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
  Show show(
      quick("[{at: 0.03, flow: 0.01}, {at: 0.05, flow: 0.02, top_drive_torque: 300}, {at: 0.07, top_drive_speed_rpm: 30}]"));
  for (int k = 0; k < 12; ++k)
  {
    show.program.apply(show.simulator);
    ASSERT_EQ(show.simulator.frame(kFrame), FrameStatus::running);
    const Setpoints& now = show.simulator.truth().setpoints;
    const double flow = k >= 5 ? 0.02 : k >= 3 ? 0.01 : 0.0;
    EXPECT_DOUBLE_EQ(now.pump.flow, flow) << k;
    EXPECT_DOUBLE_EQ(now.top_drive.torque, k >= 5 ? 300.0 : 0.0) << k;
    EXPECT_DOUBLE_EQ(now.top_drive.speed, k >= 7 ? 30.0 * rpm : 0.0) << k;
    EXPECT_EQ(now.top_drive.mode, k >= 5 && k < 7 ? TopDriveMode::torque : TopDriveMode::speed) << k;
    EXPECT_TRUE(now.winch.brake);
  }
}

// A program that comes late gives all lines that are due at once, in their order.
TEST(ProgramPlayer, LinesThatAreOverdueActInTheirOrder)
{
  const Scene scene = quick(
      "[{at: 0, flow: 0.01}, {at: 0.05, flow: 0.02, top_drive_torque: 300}, {at: 0.1, top_drive_speed_rpm: 30}, {at: 9, flow: "
      "0}]");
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

/// What is in force in each of `frames` frames of `program`.
std::vector<Setpoints> played(Show& show, int frames)
{
  std::vector<Setpoints> all;
  for (int k = 0; k < frames; ++k)
  {
    show.program.apply(show.simulator);
    EXPECT_EQ(show.simulator.frame(kFrame), FrameStatus::running) << show.simulator.failure();
    all.push_back(show.simulator.truth().setpoints);
  }
  return all;
}

// From 10 ms on in 40 ms: a quarter of the way in each frame, the whole of it from the fifth on.
TEST(ProgramRamp, LeadsThereInAStraightLine)
{
  Show show(quick("[{at: 0.01, top_drive_speed_rpm: 120, flow: 0.02, block_velocity: -0.1, ramp: 0.04}]"));
  const std::vector<Setpoints> now = played(show, 10);
  for (int k = 0; k < 10; ++k)
  {
    const double share = k < 1 ? 0.0 : k < 5 ? 0.25 * (k - 1) : 1.0;
    EXPECT_NEAR(now[k].top_drive.speed, share * 120.0 * rpm, 1e-12) << k;
    EXPECT_NEAR(now[k].pump.flow, share * 0.02, 1e-15) << k;
    EXPECT_NEAR(now[k].winch.block_velocity, -share * 0.1, 1e-15) << k;
    EXPECT_EQ(now[k].winch.brake, k < 1) << "released at once";
  }
  EXPECT_EQ(now.back().top_drive.speed, 120.0 * rpm) << "to the last bit";
  EXPECT_TRUE(show.program.finished());
}

// 0 to 80 rpm in 80 ms is at 40 rpm after half of it; from there on down to 0 in 40 ms.
TEST(ProgramRamp, ALaterLineGoesOnFromTheValueInForce)
{
  Show show(quick(
      "[{at: 0, top_drive_speed_rpm: 80, ramp: 0.08}, {at: 0.04, top_drive_speed_rpm: 0, ramp: 0.04}, {at: 0.06, flow: 0.02}]"));
  const std::vector<Setpoints> now = played(show, 10);
  const double expected[] = {0.0, 10.0, 20.0, 30.0, 40.0, 30.0, 20.0, 10.0, 0.0, 0.0};
  for (int k = 0; k < 10; ++k) EXPECT_NEAR(now[k].top_drive.speed, expected[k] * rpm, 1e-12) << k;
  EXPECT_DOUBLE_EQ(now[6].pump.flow, 0.02) << "another set point leaves it alone";
}

TEST(ProgramRamp, IsNotOverBeforeItsEnd)
{
  Show show(quick("[{at: 0, flow: 0.02, ramp: 0.05}]"));
  played(show, 5);
  EXPECT_FALSE(show.program.finished());
  played(show, 1);
  EXPECT_TRUE(show.program.finished());
  EXPECT_DOUBLE_EQ(program_end(show.simulator.scene().program), 0.05);
  EXPECT_DOUBLE_EQ(program_end(quick("[{at: 1, flow: 0.02, ramp: 9}, {at: 4, flow: 0.01}]").program), 10.0);
  EXPECT_EQ(program_end({}), 0.0);
}

TEST(ProgramRamp, BrakesEndIt)
{
  Show show(
      quick("[{at: 0, block_velocity: 0.08, top_drive_speed_rpm: 80, ramp: 0.08}, {at: 0.04, brake: true, top_drive_brake: "
            "true}, {at: 0.06, "
            "block_velocity: 0.02, ramp: 0.02}]"));
  const std::vector<Setpoints> now = played(show, 10);
  EXPECT_NEAR(now[5].winch.block_velocity, 0.04, 1e-15);
  EXPECT_TRUE(now[5].winch.brake);
  EXPECT_TRUE(now[5].top_drive.brake);
  EXPECT_NEAR(now[9].top_drive.speed, 40.0 * rpm, 1e-12);
  EXPECT_NEAR(now[6].winch.block_velocity, 0.0, 1e-15) << "from the brake it begins at rest";
  EXPECT_FALSE(now[6].winch.brake);
  EXPECT_NEAR(now[7].winch.block_velocity, 0.01, 1e-15);
  EXPECT_DOUBLE_EQ(now[8].winch.block_velocity, 0.02);
}

// In the other mode a ramp begins at what the drive does, and ends that mode's.
TEST(ProgramRamp, ToAnotherModeBeginsAtWhatTheDriveDoes)
{
  Show show(
      quick("[{at: 0, top_drive_speed_rpm: 60, ramp: 3}, {at: 2, top_drive_torque: 4000, ramp: 1}, {at: 2.5, "
            "top_drive_speed_rpm: 0, ramp: 1}]"));
  played(show, 200);
  const double torque = show.simulator.truth().torque;
  EXPECT_GT(torque, 10.0);
  EXPECT_NEAR(played(show, 1)[0].top_drive.torque, torque, 1e-12 * torque);
  const Setpoints half = played(show, 48).back();
  EXPECT_EQ(half.top_drive.mode, TopDriveMode::torque);
  EXPECT_NEAR(half.top_drive.torque, torque + 0.48 * (4000.0 - torque), 1e-6);
  played(show, 1);
  const double speed = show.simulator.truth().top_drive_speed;
  EXPECT_GT(speed, 1.0);
  const Setpoints back = played(show, 1)[0];
  EXPECT_EQ(back.top_drive.mode, TopDriveMode::speed);
  EXPECT_NEAR(back.top_drive.speed, speed, 1e-12 * speed);
}

// A line's own word, or its keys; what it leaves out stays.
TEST(ProgramPlayer, LinesNameTheModeOfTheTopDrive)
{
  Show show(
      quick("[{at: 0, top_drive_mode: z_torque, top_drive_speed_rpm: 60}, {at: 0.1, top_drive_speed_rpm: 30}, {at: 0.2, "
            "top_drive_mode: soft_torque, "
            "top_drive_torque_limit: 8000}, {at: 0.3, top_drive_angle_deg: 90}, {at: 0.4, amplitude_right_deg: 180}, {at: 0.5, "
            "top_drive_angle_deg: 45, "
            "top_drive_speed_rpm: 5}, {at: 0.6, top_drive_torque: 300}, {at: 0.7, top_drive_speed_rpm: 10}, {at: 0.8, "
            "top_drive_mode: angle}]"));
  EXPECT_EQ(show.play(0.05).top_drive.mode, TopDriveMode::z_torque);
  EXPECT_EQ(show.play(0.15).top_drive.mode, TopDriveMode::z_torque) << "a speed leaves it";
  EXPECT_DOUBLE_EQ(show.play(0.16).top_drive.speed, 30.0 * rpm);
  const TopDriveSetpoint soft = show.play(0.25).top_drive;
  EXPECT_EQ(soft.mode, TopDriveMode::soft_torque);
  EXPECT_DOUBLE_EQ(soft.speed, 30.0 * rpm);
  EXPECT_DOUBLE_EQ(soft.torque_limit, 8000.0);
  const TopDriveSetpoint angle = show.play(0.35).top_drive;
  EXPECT_EQ(angle.mode, TopDriveMode::angle);
  EXPECT_DOUBLE_EQ(angle.angle, 90.0 * degree);
  const TopDriveSetpoint rocking = show.play(0.45).top_drive;
  EXPECT_EQ(rocking.mode, TopDriveMode::oscillate);
  EXPECT_DOUBLE_EQ(rocking.amplitude_right, 180.0 * degree);
  EXPECT_EQ(rocking.amplitude_left, 0.0);
  const TopDriveSetpoint elsewhere = show.play(0.55).top_drive;
  EXPECT_EQ(elsewhere.mode, TopDriveMode::oscillate) << "about another middle";
  EXPECT_DOUBLE_EQ(elsewhere.angle, 45.0 * degree);
  EXPECT_DOUBLE_EQ(elsewhere.speed, 5.0 * rpm);
  EXPECT_EQ(show.play(0.65).top_drive.mode, TopDriveMode::torque);
  EXPECT_EQ(show.play(0.75).top_drive.mode, TopDriveMode::speed);
  EXPECT_EQ(show.play(0.85).top_drive.mode, TopDriveMode::angle);
  EXPECT_DOUBLE_EQ(show.play(0.86).top_drive.angle, 45.0 * degree);
}

// A program that comes late is as far as one that came in time.
TEST(ProgramRamp, OverdueItIsAsFarAsItWouldBe)
{
  const Scene scene = quick(
      "[{at: 0, flow: 0.02, ramp: 0.2}, {at: 0.05, top_drive_speed_rpm: 60, ramp: 0.05}, {at: 0.1, flow: 0.03, ramp: 0.2}]");
  Show in_time(scene), late(scene);
  played(in_time, 15);
  for (int k = 0; k < 15; ++k) ASSERT_EQ(late.simulator.frame(kFrame), FrameStatus::running);
  const Setpoints expected = played(in_time, 1)[0], now = played(late, 1)[0];
  EXPECT_NEAR(now.pump.flow, 0.01 + 0.02 * 0.25, 1e-12);
  EXPECT_NEAR(now.pump.flow, expected.pump.flow, 1e-12);
  EXPECT_DOUBLE_EQ(now.top_drive.speed, expected.top_drive.speed);
}

// A player's value is all of it: one that takes over half-way goes on alike.
TEST(ProgramRamp, IsPartOfThePlayersValue)
{
  const Scene scene = quick("[{at: 0, top_drive_speed_rpm: 80, flow: 0.02, block_velocity: 0.01, ramp: 0.08}]");
  Show show(scene);
  played(show, 4);
  ProgramPlayer copy(scene.program);
  ASSERT_TRUE(from_bytes(to_bytes(show.program), copy));
  show.program = copy;
  EXPECT_NEAR(played(show, 2).back().top_drive.speed, 50.0 * rpm, 1e-12);
  show.program.rewind();
  EXPECT_FALSE(show.program.finished());
}

// The pipe is gripped and let go by the program as by the simulator's own calls, bit for bit.
TEST(ProgramFault, PipeSticksAndComesFree)
{
  const std::string pull = "{at: 0.1, block_velocity: 0.02}, {at: 1, brake: true}";
  Show show(quick("[{at: 0.05, stuck_at: 60}, " + pull + ", {at: 2, free: true}]")), by_hand(quick("[" + pull + "]"));
  const double hanging = show.simulator.truth().hook_load;
  show.play(1.9);
  EXPECT_GT(show.simulator.truth().hook_load, hanging + 5e4) << "overpull";
  EXPECT_LT(std::abs(show.simulator.save()->mechanics.stuck_point.position.z() + 60.0), 9.5) << "within an element";
  played(by_hand, 5);
  ASSERT_TRUE(by_hand.simulator.stick_pipe(60.0));
  by_hand.play(1.9);
  EXPECT_EQ(by_hand.simulator.truth().hook_load, show.simulator.truth().hook_load);
  for (Show* one : {&show, &by_hand}) one->play(1.98);
  by_hand.simulator.free_pipe();
  double mean = 0.0;
  for (int k = 0; k < 400; ++k)
  {
    played(show, 1);
    played(by_hand, 1);
    mean += show.simulator.truth().hook_load / 400.0;
    ASSERT_EQ(by_hand.simulator.truth().hook_load, show.simulator.truth().hook_load) << k;
  }
  EXPECT_EQ(show.simulator.save()->mechanics.stuck_point.node, -1);
  EXPECT_NEAR(mean, hanging, 0.02 * hanging) << "it hangs as before, and swings about that";
}

TEST(ProgramFault, APlaceBelowTheBitFailsTheRun)
{
  Show show(quick("[{at: 0.02, stuck_at: 99.9}]"));
  played(show, 2);
  show.program.apply(show.simulator);
  EXPECT_EQ(show.simulator.frame(kFrame), FrameStatus::failed);
  EXPECT_STREQ(show.simulator.failure(), "program: stuck_at is below the bit, allowed: where there is pipe in the hole");
  EXPECT_NEAR(show.simulator.truth().time, 0.02, 1e-12) << "time stands";
  show.simulator.fail("another");
  EXPECT_NE(std::string("another"), show.simulator.failure()) << "the first reason stays";
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
}  // namespace drill_rig_sim::test_sim_program
