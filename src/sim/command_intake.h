// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_SIM_COMMAND_INTAKE_H
#define DRILL_RIG_SIM_SRC_SIM_COMMAND_INTAKE_H

#include "drill_rig_sim/crew/commands.h"
#include "drill_rig_sim/crew/refusals.h"
#include "drill_rig_sim/sim/simulator_state.h"
#include "motion.h"

namespace drill_rig_sim
{
struct FrameOrder;

/// Commands, and what becomes of them: locks, the watchdog on their streams, the downlink to the string's tool, dead times,
/// interlocks and faults. Owns `commands`, `delay`, `downlink` and `interlocks` of the simulator's state. Nothing but its
/// constructor allocates.
class CommandIntake
{
public:
  /// All of these have to outlive this.
  CommandIntake(const Scene& scene, const Motion& motion, SimulatorState& state);

  /// Takes a command within the rig's limits, or refuses it.
  template <class Setpoint>
  CommandResult command(const Setpoint& c) noexcept
  {
    if (const char* lock = locked(c)) return {CommandResult::Outcome::refused, lock};
    return take(scene_.rig, motion_.now(), c, commands_);
  }
  /// Why such a command would be refused at present, one line, static storage; null: it would not be.
  const char* locked(const WinchSetpoint& c) const noexcept;
  const char* locked(const TopDriveSetpoint& c) const noexcept;
  const char* locked(const PumpSetpoint& c) const noexcept;
  const char* locked(const SteeringSetpoint& c) const noexcept;
  /// What slips, connections and commands are refused by.
  StringAtTable at_table() const noexcept;
  /// Streams of commands may stop for so long [s]; 0: for ever.
  void set_timeout(double seconds) noexcept { timeout_ = seconds; }
  /// No stream is expected until the next command of the winch, or of the drive.
  void winch_command_stands() noexcept { commands_.last_winch = CommandState().last_winch; }
  void drive_command_stands() noexcept { commands_.last_drive = CommandState().last_drive; }

  /// Before a frame: the watchdog, the tool in the string, the interlocks and the dead times take the set points on.
  void watch() noexcept;
  /// By the last command of each kind.
  const Setpoints& asked() const noexcept { return commands_.asked; }
  /// Those, or the crew's, or the watchdog's.
  Setpoints requested() const noexcept { return commands_.in_force(); }
  /// Those that act: after their dead times, what interlocks and faults leave of them.
  Setpoints in_force() const noexcept;

  /// The rig's crew gives the set points for a while.
  bool crew_drives() const noexcept { return commands_.crew_drives; }
  void let_crew_drive(bool on) noexcept { commands_.crew_drives = on; }
  Setpoints& by_crew() noexcept { return commands_.by_crew; }
  /// The string is broken out by a connection that no crew makes: winch and pump are locked.
  bool is_broken_out_by_hand() const noexcept { return state_.connection.under_way && state_.crew.doing == CrewTask::none; }

  /// As those of the rig that a companion goes along with.
  void follow(const FrameOrder& order) noexcept;

private:
  void steer() noexcept;
  Setpoints passed() const noexcept;

  const Scene& scene_;
  const Motion& motion_;
  const SimulatorState& state_;
  CommandState& commands_;
  CommandDelay& delay_;
  DownlinkReceiver& downlink_;
  InterlockState& interlocks_;
  double timeout_ = 0.0;  // [s]
};

}  // namespace drill_rig_sim

#endif
