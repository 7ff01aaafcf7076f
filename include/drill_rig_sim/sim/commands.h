#ifndef DRILL_RIG_SIM_SIM_COMMANDS_H
#define DRILL_RIG_SIM_SIM_COMMANDS_H

namespace drill_rig_sim
{
enum class TopDriveMode
{
  speed = 0,
  torque = 1,
  angle = 2,
  soft_torque = 3,
  z_torque = 4
};

/// Set points, in the signs of the interface: block velocity + up, spin and torque + clockwise looking downhole.
struct WinchCommand
{
  double block_velocity = 0.0;  ///< [m/s]
  bool brake = true;
};

struct TopDriveCommand
{
  TopDriveMode mode = TopDriveMode::speed;
  double speed = 0.0;         ///< [rad/s]
  double torque = 0.0;        ///< [N m], torque mode
  double angle = 0.0;         ///< [rad], angle mode
  double torque_limit = 0.0;  ///< [N m]; 0 = the rig's
};

struct PumpCommand
{
  double flow = 0.0;  ///< [m3/s]
};

/// The set points in force.
struct Setpoints
{
  WinchCommand winch;
  TopDriveCommand top_drive;
  PumpCommand pump;
};

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

}  // namespace drill_rig_sim

#endif
