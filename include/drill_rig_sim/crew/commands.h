// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_CREW_COMMANDS_H
#define DRILL_RIG_SIM_CREW_COMMANDS_H

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

/// The commands taken last and when they came.
struct CommandState
{
  Setpoints asked;          ///< by the last command of each kind, within the limits
  bool clamped = false;     ///< the last command was, or another of the same instant
  double last_taken = 0.0;  ///< when the last command of any kind came [s]
  /// When [s]; infinity: never yet, so that its silence is no lost stream.
  double last_winch = std::numeric_limits<double>::infinity();
  double last_drive = std::numeric_limits<double>::infinity();
  bool winch_silent = false, drive_silent = false;  ///< for longer than the timeout, up to its next command
  bool crew_drives =
      false;  ///< the rig's crew gives the set points for a while (crew.h): what is asked meanwhile acts afterwards
  Setpoints by_crew;

  bool timed_out() const noexcept { return winch_silent || drive_silent; }
  /// What was asked, or the crew's; brake and coasting drive while a stream has stopped.
  Setpoints in_force() const noexcept;

  template <class V>
  void visit(V& v)
  {
    v("asked", asked);
    v("clamped", clamped);
    v("last_taken", last_taken);
    v("last_winch", last_winch);
    v("last_drive", last_drive);
    v("winch_silent", winch_silent);
    v("drive_silent", drive_silent);
    v("crew_drives", crew_drives);
    v("by_crew", by_crew);
  }
};

/// Of the top drive's shaft, that may be commanded: a double resolves it to 1.5e-8 rad. At 200 rpm it takes two months of turning
/// [rad].
constexpr double most_drive_angle = 1e8;

/// Whether a set point has its actuator move, in ANGLE and OSCILLATE always.
bool moves(const WinchSetpoint& command) noexcept;
bool turns(const TopDriveSetpoint& command) noexcept;

/// Why a command would be refused, one line, static storage; null: it would not.
const char* what_is_wrong(const WinchSetpoint& command) noexcept;
const char* what_is_wrong(const TopDriveSetpoint& command) noexcept;
const char* what_is_wrong(const PumpSetpoint& command) noexcept;
const char* what_is_wrong(const SteeringSetpoint& command) noexcept;

/// Takes a command at simulated time `now` [s]. A finite value beyond the rig's limit is clamped, as a real drive saturates; a
/// value that is not finite, an unknown mode, a negative torque limit or amplitude, an angle or amplitude beyond
/// most_drive_angle, and OSCILLATE without amplitudes are refused whole: the last good one stays.
CommandResult take(const RigSpec& rig, double now, const WinchSetpoint& command, CommandState& state) noexcept;
CommandResult take(const RigSpec& rig, double now, const TopDriveSetpoint& command, CommandState& state) noexcept;
CommandResult take(const RigSpec& rig, double now, const PumpSetpoint& command, CommandState& state) noexcept;
CommandResult take(const RigSpec& rig, double now, const SteeringSetpoint& command, CommandState& state) noexcept;

/// Notes which of the winch's and the drive's commands have not come for longer than `timeout` [s]; 0: never. A stream is watched
/// from its first command on: its first since the start, or since `timeout` was 0.
void watch_commands(double timeout, double now, CommandState& state) noexcept;

}  // namespace drill_rig_sim

#endif
