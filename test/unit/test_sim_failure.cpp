// SPDX-License-Identifier: BSD-3-Clause
// What cannot be solved stops time and nothing else: no number that is not finite ever leaves, and a restored state runs on.
// Commands beyond the rig's limits are clamped, those that are no numbers refused.
#include <gtest/gtest.h>

#include <cstring>
#include <limits>

#include "drill_rig_sim/solve/start.h"
#include "drill_rig_sim/solve/stepper.h"
#include "drill_ahead.h"
#include "sim_numbers.h"
#include "test_scenes.h"

namespace test_sim_failure
{
using namespace drill_rig_sim;
using Eigen::Vector3d;
using Outcome = CommandResult::Outcome;

namespace
{
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Ways to make a state unsolvable.
struct Damage
{
  const char* name;
  void (*apply)(State&);
};

const Damage kDamages[] = {
    {"node a thousand kilometres away", [](State& s) { s.nodes[3].position.x() += 1e6; }},
    {"speed beyond reason", [](State& s) { s.nodes[2].rate.velocity.y() = 1e200; }},
    {"position not a number", [](State& s) { s.nodes[4].position.z() = kNan; }},
    {"rotor at infinite speed", [](State& s) { s.drive.speed = kInfinity; }},
    {"orientation not a number", [](State& s) { s.nodes[3].orientation.w() = kNan; }},
};
}  // namespace

TEST(Stepper, refusesWhatItCannotSolveAndLeavesTheStateAlone)
{
  RigAtRest rig = build_at_rest(drilling_scene());
  Stepper stepper(rig.model, find_method(IntegratorKind::automatic));
  Setpoints setpoints;
  for (int k = 0; k < 10; ++k) ASSERT_TRUE(stepper.advance(rig.state, 0.005, setpoints));
  for (const Damage& damage : kDamages)
  {
    State broken = rig.state;
    damage.apply(broken);
    const std::vector<double> before = numbers_of(broken);
    EXPECT_FALSE(stepper.advance(broken, 0.005, setpoints)) << damage.name;
    EXPECT_TRUE(bit_identical(numbers_of(broken), before)) << damage.name;
  }
  EXPECT_GT(stepper.counters().convergence_failures, 0u);
  // and goes on from a sound state as if nothing had been
  for (int k = 0; k < 10; ++k) ASSERT_TRUE(stepper.advance(rig.state, 0.005, setpoints));
  EXPECT_TRUE(all_finite(numbers_of(rig.state)));
}

TEST(Simulator, failedFrameKeepsTheLastGoodNumbersAndRestoreRecovers)
{
  Simulator rig(drilling_scene());
  drill_ahead(rig, 90.0 * rpm, 0.02, 0.012);
  for (int k = 0; k < 300; ++k) ASSERT_EQ(rig.frame(0.01), FrameStatus::running);
  const auto good = rig.save();
  std::vector<double> shown, now;
  numbers_of(rig.truth(), shown);
  ASSERT_TRUE(all_finite(shown));

  for (const Damage& damage : kDamages)
  {
    SimulatorState broken = *good;
    damage.apply(broken.mechanics);
    rig.restore(broken);
    EXPECT_STREQ(rig.failure(), "");
    for (int k = 0; k < 3; ++k)
    {
      EXPECT_EQ(rig.frame(0.01), FrameStatus::failed) << damage.name;
      EXPECT_GT(std::strlen(rig.failure()), 20u);
      numbers_of(rig.truth(), now);
      EXPECT_TRUE(bit_identical(now, shown)) << damage.name;
    }
    rig.restore(*good);
    ASSERT_EQ(rig.frame(0.01), FrameStatus::running) << damage.name;
  }
}

// Rough handling: a new extreme command every tenth of a second. Whatever happens, every number is finite.
TEST(Simulator, everyNumberStaysFiniteUnderRoughHandling)
{
  Simulator rig(drilling_scene(0.2));
  StringProfile profile;
  std::vector<double> now;
  const double winch[] = {-1.5, 1.5, -1.5, 0.0, -0.3, 1.0};
  const double speeds[] = {23.0, -23.0, 0.0, 23.0};
  int running = 0;
  for (int k = 0; k < 1000; ++k)
  {
    if (k % 10 == 0)
    {
      rig.command(WinchSetpoint{winch[(k / 10) % 6], k % 70 == 0});
      TopDriveSetpoint drive;
      drive.speed = speeds[(k / 10) % 4];
      drive.mode = k % 30 == 0 ? TopDriveMode::torque : TopDriveMode::speed;
      drive.torque = k % 60 == 0 ? 5e4 : -5e4;
      rig.command(drive);
      rig.command(PumpSetpoint{k % 40 == 0 ? 0.06 : 0.0});
    }
    running += rig.frame(0.01) == FrameStatus::running;
    numbers_of(rig.truth(), now);
    ASSERT_TRUE(all_finite(now)) << k;
    rig.profile(profile);
    for (const auto* values : {&profile.md, &profile.tension, &profile.torque, &profile.bending_moment, &profile.contact_force})
      ASSERT_TRUE(all_finite(*values)) << k;
  }
  EXPECT_EQ(running, 1000) << rig.failure();
}

// The seed's interpolation of one total rotation vector a node ends where the top has made a full turn: said, not shown as
// numbers.
TEST(Simulator, totalRotationVectorsStopAtTheFirstFullTurn)
{
  Scene scene = drilling_scene();
  scene.numerics.element = ElementKind::rotation_vector;
  Simulator rig(scene);
  drill_ahead(rig, 90.0 * rpm, 0.02, 0.012);
  std::vector<double> now;
  int frames = 0;
  while (rig.frame(0.01) == FrameStatus::running && frames < 1000)
  {
    ++frames;
    numbers_of(rig.truth(), now);
    ASSERT_TRUE(all_finite(now)) << frames;
  }
  EXPECT_GT(rig.truth().top_drive_angle, 0.8 * 2.0 * pi);
  EXPECT_LT(rig.truth().top_drive_angle, 2.0 * pi);
  EXPECT_GT(std::strlen(rig.failure()), 20u);
}

TEST(Commands, notNumbersAreRefusedAndChangeNothing)
{
  Simulator rig(drilling_scene());
  drill_ahead(rig, 90.0 * rpm, 0.02, 0.012);
  ASSERT_EQ(rig.frame(0.01), FrameStatus::running);
  const Setpoints before = rig.truth().setpoints;
  std::uint64_t refused = 0;
  for (double bad : {kNan, kInfinity, -kInfinity})
  {
    TopDriveSetpoint speed, torque, limit;
    speed.speed = torque.torque = limit.torque_limit = bad;
    for (const CommandResult& r : {rig.command(WinchSetpoint{bad, false}), rig.command(speed), rig.command(torque),
                                   rig.command(limit), rig.command(PumpSetpoint{bad})})
    {
      EXPECT_EQ(r.outcome, Outcome::refused);
      EXPECT_GT(std::strlen(r.reason), 10u);
      ++refused;
    }
  }
  TopDriveSetpoint mode, negative;
  mode.mode = static_cast<TopDriveMode>(top_drive_mode_count);
  negative.torque_limit = -1.0;
  EXPECT_EQ(rig.command(mode).outcome, Outcome::refused);
  EXPECT_EQ(rig.command(negative).outcome, Outcome::refused);
  EXPECT_EQ(rig.statistics().commands_refused, refused + 2);

  ASSERT_EQ(rig.frame(0.01), FrameStatus::running);
  const Setpoints after = rig.truth().setpoints;
  EXPECT_EQ(after.winch.block_velocity, before.winch.block_velocity);
  EXPECT_EQ(after.winch.brake, before.winch.brake);
  EXPECT_EQ(after.top_drive.speed, before.top_drive.speed);
  EXPECT_EQ(after.top_drive.mode, before.top_drive.mode);
  EXPECT_EQ(after.pump.flow, before.pump.flow);
  EXPECT_FALSE(rig.truth().command_clamped);
}

TEST(Commands, beyondTheLimitsAreClampedAndFlagged)
{
  const Scene scene = drilling_scene();
  Simulator rig(scene);
  EXPECT_EQ(rig.command(WinchSetpoint{-0.01, false}).outcome, Outcome::accepted);
  EXPECT_EQ(rig.command(WinchSetpoint{-100.0, false}).outcome, Outcome::clamped);
  TopDriveSetpoint drive;
  drive.speed = 1e3;
  EXPECT_EQ(rig.command(drive).outcome, Outcome::clamped);
  const CommandResult flow = rig.command(PumpSetpoint{1.0});
  EXPECT_EQ(flow.outcome, Outcome::clamped);
  EXPECT_GT(std::strlen(flow.reason), 10u);
  ASSERT_EQ(rig.frame(0.005), FrameStatus::running);
  const Setpoints& set = rig.truth().setpoints;
  EXPECT_EQ(set.winch.block_velocity, -scene.rig.hoisting.max_speed);
  EXPECT_EQ(set.top_drive.speed, scene.rig.top_drive.max_speed);
  EXPECT_EQ(set.pump.flow, scene.rig.mud_pump.max_flow);
  EXPECT_TRUE(rig.truth().command_clamped);
  EXPECT_EQ(rig.statistics().commands_clamped, 3u);
  EXPECT_EQ(rig.command(PumpSetpoint{-0.1}).outcome, Outcome::clamped);
  ASSERT_EQ(rig.frame(0.005), FrameStatus::running);
  EXPECT_EQ(rig.truth().setpoints.pump.flow, 0.0);
  rig.command(PumpSetpoint{0.02});
  ASSERT_EQ(rig.frame(0.005), FrameStatus::running);
  EXPECT_FALSE(rig.truth().command_clamped);
}

// Silence beyond the timeout sets the brake and coasts the drive.
TEST(Commands, silenceSetsTheBrake)
{
  Simulator rig(drilling_scene(5.0));
  rig.set_command_timeout(0.5);
  drill_ahead(rig, 90.0 * rpm, 0.02, 0.012);
  for (int k = 0; k < 45; ++k) rig.frame(0.01);
  EXPECT_FALSE(rig.truth().commands_timed_out);
  EXPECT_FALSE(rig.truth().brake_set);
  for (int k = 0; k < 10; ++k) rig.frame(0.01);
  EXPECT_TRUE(rig.truth().commands_timed_out);
  EXPECT_TRUE(rig.truth().brake_set);
  // the block bounces on its line by a millimetre; the feed would have made 24
  const double height = rig.truth().block_height;
  for (int k = 0; k < 200; ++k) rig.frame(0.01);
  EXPECT_NEAR(rig.truth().block_height, height, 3e-3);
  drill_ahead(rig, 90.0 * rpm, 0.02, 0.012);
  rig.frame(0.01);
  EXPECT_FALSE(rig.truth().commands_timed_out);
}

// Either stream that falls silent is enough, the pump has none; then the winch is braked, the drive coasts, and the pump goes on.
TEST(Commands, eitherStreamsSilenceIsNoticed)
{
  for (const bool winch_talks : {true, false})
  {
    Simulator rig(drilling_scene(5.0));
    rig.set_command_timeout(0.3);
    drill_ahead(rig, 90.0 * rpm, 0.02, 0.012);
    TopDriveSetpoint drive;
    drive.speed = 90.0 * rpm;
    for (int k = 0; k < 100 && !rig.truth().commands_timed_out; ++k)
    {
      if (k >= 20) winch_talks ? rig.command(WinchSetpoint{-0.012, false}) : rig.command(drive);
      rig.command(PumpSetpoint{0.02});
      ASSERT_EQ(rig.frame(0.01), FrameStatus::running);
    }
    ASSERT_TRUE(rig.truth().commands_timed_out) << winch_talks;
    EXPECT_NEAR(rig.truth().time, 0.31, 0.011) << "the first frame that starts later than the timeout allows";
    const Setpoints& now = rig.truth().setpoints;
    EXPECT_TRUE(now.winch.brake);
    EXPECT_EQ(now.winch.block_velocity, 0.0);
    EXPECT_EQ(now.top_drive.mode, TopDriveMode::torque);
    EXPECT_EQ(now.top_drive.torque, 0.0);
    EXPECT_EQ(now.pump.flow, 0.02);
  }
}

// What never came cannot fall silent; 0 switches the watch off.
TEST(Commands, aStreamThatNeverBeganIsNotMissed)
{
  Simulator rig(drilling_scene(5.0));
  rig.set_command_timeout(0.1);
  rig.command(PumpSetpoint{0.02});
  for (int k = 0; k < 50; ++k) rig.frame(0.01);
  EXPECT_FALSE(rig.truth().commands_timed_out);
  rig.set_command_timeout(0.0);
  rig.command(WinchSetpoint{-0.01, false});
  for (int k = 0; k < 50; ++k) rig.frame(0.01);
  EXPECT_FALSE(rig.truth().commands_timed_out);
  EXPECT_FALSE(rig.truth().brake_set);
  rig.set_command_timeout(0.1);
  for (int k = 0; k < 50; ++k) rig.frame(0.01);
  EXPECT_FALSE(rig.truth().commands_timed_out) << "what was sent before anyone watched is no stream";
  rig.command(WinchSetpoint{-0.01, false});
  for (int k = 0; k < 12; ++k) rig.frame(0.01);
  EXPECT_TRUE(rig.truth().commands_timed_out);
}

// The rig stays safe until the silent stream itself speaks again, whatever the other says; then both are obeyed at once.
TEST(Commands, aSilenceIsEndedByItsOwnStreamAlone)
{
  for (const bool winch_talks : {true, false})
  {
    Simulator rig(drilling_scene(5.0));
    rig.set_command_timeout(0.1);
    drill_ahead(rig, 90.0 * rpm, 0.02, 0.012);
    const auto winch = [&rig] { rig.command(WinchSetpoint{-0.01, false}); };
    const auto drive = [&rig] { rig.command(TopDriveSetpoint{TopDriveMode::speed, 6.0, 0.0, 0.0, 0.0}); };
    for (int k = 0; k < 40; ++k)
    {
      winch_talks ? winch() : drive();
      rig.frame(0.01);
      const bool silent = k > 10;  // of what came at 0, at 0.11 s for longer than 0.1 s
      EXPECT_EQ(silent, rig.truth().commands_timed_out) << k;
      EXPECT_EQ(silent, rig.truth().brake_set) << k;
      EXPECT_EQ(silent, rig.truth().setpoints.top_drive.mode == TopDriveMode::torque) << k;
      EXPECT_EQ(0.02, rig.truth().setpoints.pump.flow) << k;
    }
    winch_talks ? drive() : winch();
    rig.frame(0.01);
    EXPECT_FALSE(rig.truth().commands_timed_out || rig.truth().brake_set);
    EXPECT_EQ(-0.01, rig.truth().setpoints.winch.block_velocity);
    EXPECT_EQ(6.0, rig.truth().setpoints.top_drive.speed);
  }
}

TEST(Commands, bothSilentBothMustSpeak)
{
  Simulator rig(drilling_scene(5.0));
  rig.set_command_timeout(0.1);
  drill_ahead(rig, 90.0 * rpm, 0.02, 0.012);
  for (int k = 0; k < 20; ++k) rig.frame(0.01);
  ASSERT_TRUE(rig.truth().commands_timed_out);
  rig.command(WinchSetpoint{-0.01, false});
  rig.frame(0.01);
  EXPECT_TRUE(rig.truth().commands_timed_out && rig.truth().brake_set);
  rig.command(TopDriveSetpoint{TopDriveMode::speed, 6.0, 0.0, 0.0, 0.0});
  rig.frame(0.01);
  EXPECT_FALSE(rig.truth().commands_timed_out || rig.truth().brake_set);
  EXPECT_EQ(-0.01, rig.truth().setpoints.winch.block_velocity);
  rig.set_command_timeout(0.0);
  for (int k = 0; k < 20; ++k) rig.frame(0.01);
  EXPECT_FALSE(rig.truth().commands_timed_out) << "there is no watchdog";
}

// A controller of two actuators sends both each frame: the clamp of one must not hide behind the other.
TEST(Commands, aClampShowsBesideOtherCommandsOfItsFrame)
{
  Simulator rig(drilling_scene(5.0));
  for (int k = 0; k < 3; ++k)
  {
    rig.command(WinchSetpoint{-100.0, false});
    rig.command(TopDriveSetpoint{TopDriveMode::speed, 6.0, 0.0, 0.0, 0.0});
    rig.command(PumpSetpoint{0.02});
    rig.frame(0.01);
    EXPECT_TRUE(rig.truth().command_clamped) << k;
  }
  rig.command(PumpSetpoint{0.02});
  rig.frame(0.01);
  EXPECT_FALSE(rig.truth().command_clamped) << "of the last command";
}

// Pipe is gripped at its node nearest to the depth; in the air, below the bit, or where no depth is told, nothing changes.
TEST(StickPipe, gripsTheNearestNodeOrRefuses)
{
  Simulator rig(drilling_scene(30.0));  // bit at 70 m; nodes every 9.5 m and less
  for (const double nowhere : {kNan, kInfinity, -kInfinity, 70.001, 200.0, -30.0, -0.1, 0.0})
  {
    EXPECT_FALSE(rig.stick_pipe(nowhere)) << nowhere;
    EXPECT_EQ(rig.save()->mechanics.stuck_point.node, -1);
  }
  for (const double md : {rig.truth().bit_depth, 55.0, 31.0, 8.0, 0.001})
  {
    ASSERT_TRUE(rig.stick_pipe(md)) << md;
    const State state = rig.save()->mechanics;
    const int held = state.stuck_point.node;
    EXPECT_EQ(state.stuck_point.position, state.nodes[held].position);
    EXPECT_EQ(state.stuck_point.spin_angle, state.nodes[held].spin_angle);
    for (const NodeState& node : state.nodes)
    {
      if (node.position.z() >= 0.0) continue;
      EXPECT_LE(std::abs(-state.nodes[held].position.z() - md), std::abs(-node.position.z() - md) + 0.02)
          << md;  // less the stretch
    }
  }
  rig.free_pipe();
  EXPECT_EQ(rig.save()->mechanics.stuck_point.node, -1);
}
}  // namespace test_sim_failure
