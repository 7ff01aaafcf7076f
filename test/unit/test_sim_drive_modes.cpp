// SPDX-License-Identifier: BSD-3-Clause
// The top drive's modes on a whole string: an angle that is held, rocking, a stall with its back-spin, and snapshots in the
// middle of each.
#include <gtest/gtest.h>

#include <algorithm>

#include "drill_rig_sim/rig/drive_reference.h"
#include "playing.h"
#include "sim_numbers.h"
#include "test_scenes.h"

namespace test_sim_drive_modes
{
using namespace drill_rig_sim;

namespace
{
TopDriveSetpoint in_mode(TopDriveMode mode, double speed = 0.0)
{
  TopDriveSetpoint c;
  c.mode = mode;
  c.speed = speed;
  return c;
}

TopDriveSetpoint to_angle(double angle)
{
  TopDriveSetpoint c = in_mode(TopDriveMode::angle);
  c.angle = angle;
  return c;
}

TopDriveSetpoint by_torque(double torque)
{
  TopDriveSetpoint c = in_mode(TopDriveMode::torque);
  c.torque = torque;
  return c;
}

/// A string of 1200 m in an inclined hole with friction: it winds up.
Scene rubbing_scene()
{
  Scene scene = scene_in(build_and_hold(100.0, 0.2 * degree, 40.0 * degree, 0.0, 1300.0), 1300.0, 1200.0, 0.3);
  scene.numerics.level = Level::axial_torsional;
  return scene;
}
}  // namespace

TEST(SimDriveModes, turnsTheStringToAnAngleAndHoldsItWhileTheBlockMoves)
{
  Simulator rig(rubbing_scene());
  double wound = 0.0;
  for (const double angle : {20.0, 17.5, 17.7})
  {
    rig.command(to_angle(angle));
    play(rig, 45.0);
    rig.command(WinchSetpoint{angle > 18.0 ? -0.1 : 0.1, false});
    play(rig, 10.0,
         [&](const Truth& t)
         {
           EXPECT_TRUE(t.top_drive_brake_set);
           EXPECT_NEAR(t.top_drive_angle, angle, angle_tolerance);
           wound = std::max(wound, std::abs(t.torque));
         });
    rig.command(WinchSetpoint{0.0, true});
  }
  EXPECT_GT(wound, 500.0) << "the string pulls at the brake";
}

TEST(SimDriveModes, rocksTheStringWithoutTurningTheBit)
{
  Simulator rig(rubbing_scene());
  TopDriveSetpoint rock = in_mode(TopDriveMode::oscillate, 1.5);
  rock.angle = 0.5;
  rock.amplitude_right = 1.2;
  rock.amplitude_left = 0.9;
  rig.command(rock);
  play(rig, 20.0);
  double highest = -1e9, lowest = 1e9;
  play(rig, 30.0,
       [&](const Truth& t)
       {
         highest = std::max(highest, t.top_drive_angle);
         lowest = std::min(lowest, t.top_drive_angle);
         EXPECT_NEAR(t.bit_speed, 0.0, 1e-3);
         EXPECT_FALSE(t.top_drive_brake_set);
       });
  // the string's torque grows on the way, and the loop lags by its rate over k_i: 1.2 kN m/s, 0.03 rad
  EXPECT_NEAR(highest, 1.7, 0.07);
  EXPECT_NEAR(lowest, -0.4, 0.07);
}

// Gripped at 300 m the string takes the limit's torque and stands; let go it turns the drive back, faster the more is wound up;
// free, it comes up to its speed without running away.
TEST(SimDriveModes, stallsAtTheLimitSpinsBackAndRecovers)
{
  Scene scene = vertical_scene(500.0, 400.0);
  scene.numerics.level = Level::axial_torsional;
  Simulator rig(scene);
  ASSERT_TRUE(rig.stick_pipe(300.0));
  const double limit = 9e3, gearbox = TopDriveSpec().gearbox_friction, speed = 6.0;
  TopDriveSetpoint turn = in_mode(TopDriveMode::speed, speed);
  turn.torque_limit = limit;
  rig.command(turn);
  play(rig, 40.0);
  play(rig, 5.0,
       [&](const Truth& t)
       {
         EXPECT_TRUE(t.top_drive_limited);
         EXPECT_NEAR(t.top_drive_speed, 0.0, 0.05);
         EXPECT_NEAR(t.torque, limit, 1.05 * gearbox) << "the motor's, the gearbox holds on either side of it";
       });

  const double wound = rig.truth().torque, angle = rig.truth().top_drive_angle;
  rig.command(by_torque(0.0));
  double fastest = 0.0;
  play(rig, 10.0, [&](const Truth& t) { fastest = std::min(fastest, t.top_drive_speed); });
  // the rotor on the string's spring against Coulomb friction: (T - f)/sqrt(k J), the string's own inertia takes a few percent
  const double stiffness = wound / angle;
  EXPECT_NEAR(-fastest, (wound - gearbox) / std::sqrt(stiffness * scene.rig.top_drive.inertia), 0.06 * -fastest);
  EXPECT_LT(rig.truth().top_drive_angle, 0.5 * angle) << "unwound";

  rig.free_pipe();
  turn.torque_limit = 0.0;
  rig.command(turn);
  double highest = 0.0;
  play(rig, 30.0, [&](const Truth& t) { highest = std::max(highest, t.top_drive_speed); });
  EXPECT_LT(highest, 1.2 * speed);
  EXPECT_NEAR(rig.truth().top_drive_speed, speed, 0.01 * speed);
  EXPECT_FALSE(rig.truth().top_drive_limited);
}

TEST(SimDriveModes, rampsTheSpeed)
{
  Scene scene = vertical_scene(500.0, 400.0);
  scene.numerics.level = Level::axial_torsional;
  scene.rig.top_drive.max_acceleration = 0.5;
  Simulator rig(scene);
  rig.command(in_mode(TopDriveMode::speed, 4.0));
  play(rig, 7.5, [](const Truth& t) { EXPECT_NEAR(t.top_drive_speed, 0.5 * t.time, 0.12); });
  play(rig, 5.0);
  EXPECT_NEAR(rig.truth().top_drive_speed, 4.0, 0.02);
  rig.command(in_mode(TopDriveMode::speed, 2.0));
  const double from = rig.truth().time;
  play(rig, 3.5, [&](const Truth& t) { EXPECT_NEAR(t.top_drive_speed, 4.0 - 0.5 * (t.time - from), 0.12); });
}

TEST(SimDriveModes, theEnergyBalanceClosesInEach)
{
  for (const TopDriveMode mode :
       {TopDriveMode::speed, TopDriveMode::soft_torque, TopDriveMode::z_torque, TopDriveMode::angle, TopDriveMode::oscillate})
  {
    Simulator rig(vertical_scene(100.0, 60.0));
    rig.balance_energy();
    TopDriveSetpoint command = in_mode(mode, 4.0);
    command.angle = 10.0;
    command.amplitude_right = command.amplitude_left = 1.0;
    rig.command(command);
    play(rig, 6.0);
    EXPECT_GT(rig.energy().drive, 1e3);
    EXPECT_LT(rig.energy().closure(), 5e-3) << static_cast<int>(mode);  // the motor starts within a step of 10 ms
  }
}

// One mode after the other, saved in the middle of each and at each change.
TEST(Snapshot, inEveryModeOfTheTopDriveIsBitIdentical)
{
  Scene scene = rubbing_scene();
  scene.rig.top_drive.max_acceleration = 3.0;
  Simulator rig(scene, 7), other(scene, 99);
  TopDriveSetpoint rock = in_mode(TopDriveMode::oscillate, 1.5);
  rock.angle = 12.0;
  rock.amplitude_right = rock.amplitude_left = 1.0;
  const TopDriveSetpoint commands[] = {in_mode(TopDriveMode::speed, 4.0),
                                       in_mode(TopDriveMode::z_torque, 5.0),
                                       in_mode(TopDriveMode::soft_torque, 4.0),
                                       to_angle(30.0),
                                       rock,
                                       by_torque(4e3),
                                       in_mode(TopDriveMode::z_torque, -3.0),
                                       in_mode(TopDriveMode::speed)};
  for (const TopDriveSetpoint& command : commands)
  {
    SCOPED_TRACE(static_cast<int>(command.mode));
    rig.command(command);
    for (const double seconds : {0.02, 3.0})
    {
      const auto snapshot = rig.save();
      play(rig, seconds);
      const auto first = numbers_of(rig.save()->mechanics);
      rig.restore(*snapshot);
      play(rig, seconds);
      EXPECT_TRUE(bit_identical(numbers_of(rig.save()->mechanics), first));
      other.restore(*snapshot);
      play(other, seconds);
      EXPECT_TRUE(bit_identical(numbers_of(other.save()->mechanics), first));
    }
  }
}
}  // namespace test_sim_drive_modes
