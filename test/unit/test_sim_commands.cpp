// SPDX-License-Identifier: BSD-3-Clause
// What a command leaves in the state by itself, and what the clock's shift does to it.
#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "drill_rig_sim/crew/commands.h"

namespace test_sim_commands
{
using namespace drill_rig_sim;

namespace
{
constexpr double now = 3.0;  // [s]

/// Both streams fell silent at 2 s.
CommandState silent_state()
{
  CommandState state;
  state.last_winch = state.last_drive = 1.0;
  watch_commands(1.5, now, state);
  EXPECT_TRUE(state.winch_silent && state.drive_silent);
  return state;
}
}  // namespace

// At once, not only with the next frame's look at the clock.
TEST(CommandState, aCommandEndsTheSilenceOfItsStream)
{
  const RigSpec rig;
  CommandState state = silent_state();
  take(rig, now, WinchSetpoint{0.0, false}, state);
  EXPECT_FALSE(state.winch_silent);
  EXPECT_TRUE(state.drive_silent);
  EXPECT_TRUE(state.timed_out());
  take(rig, now, TopDriveSetpoint(), state);
  EXPECT_FALSE(state.drive_silent);
  EXPECT_FALSE(state.timed_out());
}

// Just at the timeout a stream is not late yet.
TEST(CommandState, silenceIsLongerThanTheTimeout)
{
  for (const bool winch : {true, false})
  {
    CommandState state;
    (winch ? state.last_winch : state.last_drive) = 1.0;
    (winch ? state.last_drive : state.last_winch) = 2.0;
    watch_commands(2.0, now, state);
    EXPECT_FALSE(state.timed_out());
    watch_commands(1.75, now, state);
    EXPECT_EQ(winch, state.winch_silent);
    EXPECT_EQ(!winch, state.drive_silent);
  }
}

TEST(CommandState, withoutATimeoutNothingIsSilent)
{
  for (const double timeout : {0.0, -1.0})
  {
    CommandState state = silent_state();
    watch_commands(timeout, now, state);
    EXPECT_FALSE(state.winch_silent || state.drive_silent) << timeout;
    watch_commands(1.0, 1e6, state);
    EXPECT_FALSE(state.winch_silent || state.drive_silent) << "what came before anyone watched";
  }
}

// The last good one stays, and the reason is one line that names the field.
TEST(TopDriveCommand, nonsenseIsRefusedWhole)
{
  const RigSpec rig;
  CommandState state;
  TopDriveSetpoint good;
  good.mode = TopDriveMode::oscillate;
  good.amplitude_right = 1.0;
  ASSERT_EQ(take(rig, now, good, state).outcome, CommandResult::Outcome::accepted);
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const auto with = [&](auto change)
  {
    TopDriveSetpoint c = good;
    change(c);
    return c;
  };
  const std::pair<const char*, TopDriveSetpoint> bad[] = {
      {"mode", with([](auto& c) { c.mode = static_cast<TopDriveMode>(top_drive_mode_count); })},
      {"mode", with([](auto& c) { c.mode = static_cast<TopDriveMode>(255); })},
      {"angle", with([](auto& c) { c.angle = nan; })},
      {"angle", with([](auto& c) { c.angle = 1e12; })},
      {"angle", with([](auto& c) { c.angle = -1.01e8; })},
      {"angle", with([](auto& c) { c.mode = TopDriveMode::angle, c.angle = 1e12; })},
      {"amplitude_left", with([](auto& c) { c.amplitude_left = 1e12; })},
      {"amplitude_right", with([](auto& c) { c.amplitude_right = nan; })},
      {"amplitude_left", with([](auto& c) { c.amplitude_left = nan; })},
      {"amplitude_right", with([](auto& c) { c.amplitude_right = -1.0; })},
      {"amplitude_left", with([](auto& c) { c.amplitude_left = -1.0; })},
      {"amplitude_right", with([](auto& c) { c.amplitude_right = 0.0; })},
      {"torque_limit", with([](auto& c) { c.torque_limit = -1.0; })}};
  for (const auto& [field, command] : bad)
  {
    const CommandResult result = take(rig, now + 1.0, command, state);
    EXPECT_EQ(result.outcome, CommandResult::Outcome::refused) << field;
    EXPECT_NE(std::string(result.reason).find(field), std::string::npos) << result.reason;
    EXPECT_EQ(std::string(result.reason).find('\n'), std::string::npos);
    EXPECT_TRUE(state.asked.top_drive == good) << field;
  }
}

TEST(TopDriveCommand, anAngleIsTakenAsFarAsADoubleResolvesIt)
{
  const RigSpec rig;
  for (const double angle : {1e8, -1e8, 1.6e6})
  {
    CommandState state;
    TopDriveSetpoint c;
    c.mode = TopDriveMode::angle;
    c.angle = angle;
    EXPECT_EQ(take(rig, now, c, state).outcome, CommandResult::Outcome::accepted) << angle;
    EXPECT_NE(state.asked.top_drive.angle + 2e-8, state.asked.top_drive.angle) << angle;
    c.angle = 2.0 * angle;
    c.mode = TopDriveMode::speed;
    EXPECT_EQ(take(rig, now, c, state).outcome, CommandResult::Outcome::accepted) << "no angle is held";
  }
}

TEST(TopDriveCommand, everyModeIsTaken)
{
  const RigSpec rig;
  for (const TopDriveMode mode :
       {TopDriveMode::speed, TopDriveMode::torque, TopDriveMode::angle, TopDriveMode::soft_torque, TopDriveMode::z_torque})
  {
    CommandState state;
    TopDriveSetpoint c;
    c.mode = mode;
    EXPECT_EQ(take(rig, now, c, state).outcome, CommandResult::Outcome::accepted);
    EXPECT_EQ(state.asked.top_drive.mode, mode);
  }
}
}  // namespace test_sim_commands
