// What a command leaves in the state by itself, and what the clock's shift does to it.
#include <gtest/gtest.h>

#include "drill_rig_sim/sim/commands.h"

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

// A snapshot restored with its own time shifted: the same commands at the same distance in time do the same.
TEST(CommandState, shiftsWithTheClock)
{
  const RigSpec rig;
  CommandState state;
  take(rig, now, WinchSetpoint{0.0, false}, state);
  take(rig, now, TopDriveSetpoint(), state);
  take(rig, now, PumpSetpoint{-1.0}, state);
  ASSERT_TRUE(state.clamped);
  state.shift_time(5.0);
  EXPECT_EQ(now + 5.0, state.last_winch);
  EXPECT_EQ(now + 5.0, state.last_drive);
  take(rig, now + 5.0, PumpSetpoint{0.0}, state);
  EXPECT_TRUE(state.clamped) << "of the same frame";
  take(rig, now + 5.01, PumpSetpoint{0.0}, state);
  EXPECT_FALSE(state.clamped);
}

int main(int argc, char** argv)
{
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
