#ifndef DRILL_RIG_SIM_SIM_COMMANDS_H
#define DRILL_RIG_SIM_SIM_COMMANDS_H

#include <cstdint>
#include <limits>

#include "drill_rig_sim/rig/setpoints.h"
#include "drill_rig_sim/scene/scene.h"

/// The door for commands: limits, refusals, and the watchdog on their streams.
namespace drill_rig_sim
{
/// What became of a command.
struct CommandResult
{
  enum class Outcome
  {
    accepted,
    clamped,  ///< taken, at the limit
    refused   ///< nothing changed
  };
  Outcome outcome = Outcome::accepted;
  const char* reason = "";  ///< one line, static storage; names the field and what is allowed
};

/// The set points in force and when they came.
struct CommandState
{
  Setpoints setpoints;
  bool clamped = false;  ///< the last command was
  /// When [s]; infinity: never yet, so that its silence is no lost stream.
  double last_winch = std::numeric_limits<double>::infinity();
  double last_drive = std::numeric_limits<double>::infinity();
  bool timed_out = false;

  /// Moves all it remembers by `shift` [s].
  void shift_time(double shift) noexcept;

  template <class V>
  void visit(V& v)
  {
    v("setpoints", setpoints);
    v("clamped", clamped);
    v("last_winch", last_winch);
    v("last_drive", last_drive);
    v("timed_out", timed_out);
  }
};

/// Takes a command at simulated time `now` [s]. A finite value beyond the rig's limit is clamped, as a real drive saturates; a value that
/// is not finite, an unknown mode and a negative torque limit are refused whole: the last good one stays.
CommandResult take(const RigSpec& rig, double now, const WinchSetpoint& command, CommandState& state) noexcept;
CommandResult take(const RigSpec& rig, double now, const TopDriveSetpoint& command, CommandState& state) noexcept;
CommandResult take(const RigSpec& rig, double now, const PumpSetpoint& command, CommandState& state) noexcept;

/// Sets the brake and coasts the drive when the winch's or the drive's commands have been silent for longer than `timeout` [s]; 0: never.
/// A stream is watched from its first command on: its first since the start, since `timeout` was 0, or since the last silence.
void watch_commands(double timeout, double now, CommandState& state) noexcept;

}  // namespace drill_rig_sim

#endif
