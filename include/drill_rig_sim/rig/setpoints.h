// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_RIG_SETPOINTS_H
#define DRILL_RIG_SIM_RIG_SETPOINTS_H

namespace drill_rig_sim
{
/// What a mode of the top drive makes for.
enum class DriveGoal
{
  speed,   ///< set point: speed
  torque,  ///< torque
  angle,   ///< angle; speed on the way
  swing    ///< angle and amplitudes about it; speed on the way
};

/// The modes of the top drive, with the numbers of TopDriveCommand.msg.
enum class TopDriveMode
{
#define MODE(name, ...) name,
#include "drill_rig_sim/rig/top_drive_mode_list.h"
};

struct TopDriveModeTraits
{
  const char* word;   ///< of the scene file
  const char* label;  ///< for displays
  DriveGoal goal;
  bool brakes;  ///< the brake sets itself once the drive is there
  const char* meaning;
};

/// By TopDriveMode.
constexpr TopDriveModeTraits top_drive_modes[] = {
#define MODE(name, goal, brakes, loop, label, meaning) {#name, label, DriveGoal::goal, brakes, meaning},
#include "drill_rig_sim/rig/top_drive_mode_list.h"
};
constexpr int top_drive_mode_count = sizeof top_drive_modes / sizeof top_drive_modes[0];

constexpr bool is_known(TopDriveMode mode) noexcept
{
  return static_cast<unsigned>(mode) < static_cast<unsigned>(top_drive_mode_count);
}
/// Of a known mode.
constexpr DriveGoal goal_of(TopDriveMode mode) noexcept
{
  return top_drive_modes[static_cast<int>(mode)].goal;
}
/// It turns the shaft to an angle or about one.
constexpr bool turns_to_angle(DriveGoal goal) noexcept
{
  return goal == DriveGoal::angle || goal == DriveGoal::swing;
}
constexpr bool turns_to_angle(TopDriveMode mode) noexcept
{
  return turns_to_angle(goal_of(mode));
}
constexpr bool keeps_speed(TopDriveMode mode) noexcept
{
  return goal_of(mode) == DriveGoal::speed;
}

/// The kinds of commands, each with set points of its own.
enum class CommandKind
{
  winch,
  top_drive,
  mud_pump,
  steering
};
constexpr int command_kinds = 4;
constexpr const char* command_kind_names[command_kinds] = {"winch", "top_drive", "mud_pump",
                                                           "steering"};  ///< as their topics begin
constexpr unsigned bit_of(CommandKind kind)
{
  return 1u << static_cast<unsigned>(kind);
}

/// Set points, in the signs of the interface: block velocity + up, spin and torque + clockwise looking downhole.
/// Called set points because the generated messages own the names WinchCommand, TopDriveCommand, RigState, RigLimits,
/// DrillstringState, ... of this namespace.
struct WinchSetpoint
{
  double block_velocity = 0.0;  ///< [m/s]
  bool brake = true;

  template <class V>
  void visit(V& v)
  {
    v("block_velocity", block_velocity);
    v("brake", brake);
  }
};

struct TopDriveSetpoint
{
  TopDriveMode mode = TopDriveMode::speed;
  double speed = 0.0;            ///< [rad/s]; of angle and oscillate the largest, 0 = angle_speed (drive_reference.h)
  double torque = 0.0;           ///< [N m], torque mode
  double angle = 0.0;            ///< of the shaft, unbounded, to be held or rocked about [rad], modes angle and oscillate
  double torque_limit = 0.0;     ///< [N m]; 0 = the rig's
  bool brake = false;            ///< on, whatever the mode; it comes on by itself at a speed of 0 and at the angle
  double amplitude_right = 0.0;  ///< clockwise, mode oscillate [rad]
  double amplitude_left = 0.0;   ///< counterclockwise [rad]

  template <class V>
  void visit(V& v)
  {
    v("mode", mode);
    v("speed", speed);
    v("torque", torque);
    v("angle", angle);
    v("torque_limit", torque_limit);
    v("brake", brake);
    v("amplitude_right", amplitude_right);
    v("amplitude_left", amplitude_left);
  }
};

struct PumpSetpoint
{
  double flow = 0.0;  ///< [m3/s]

  template <class V>
  void visit(V& v)
  {
    v("flow", flow);
  }
};

/// Of a rotary steerable tool.
struct SteeringSetpoint
{
  double toolface = 0.0;  ///< of the force on the tool, clockwise looking downhole from the high side, or from north in a hole
                          ///< nearer the vertical [rad]
  double ratio = 0.0;     ///< of full steering, 0 .. 1

  template <class V>
  void visit(V& v)
  {
    v("toolface", toolface);
    v("ratio", ratio);
  }
};

/// The set points in force.
struct Setpoints
{
  WinchSetpoint winch;
  TopDriveSetpoint top_drive;
  PumpSetpoint pump;
  SteeringSetpoint steering;       ///< that the tool obeys
  bool magnetic_steering = false;  ///< its toolface counts from north

  template <class V>
  void visit(V& v)
  {
    v("winch", winch);
    v("top_drive", top_drive);
    v("pump", pump);
    v("steering", steering);
    v("magnetic_steering", magnetic_steering);
  }
};

inline bool operator==(const WinchSetpoint& a, const WinchSetpoint& b) noexcept
{
  return a.block_velocity == b.block_velocity && a.brake == b.brake;
}

inline bool operator==(const TopDriveSetpoint& a, const TopDriveSetpoint& b) noexcept
{
  return a.mode == b.mode && a.speed == b.speed && a.torque == b.torque && a.angle == b.angle &&
         a.torque_limit == b.torque_limit && a.brake == b.brake && a.amplitude_right == b.amplitude_right &&
         a.amplitude_left == b.amplitude_left;
}

inline bool operator==(const SteeringSetpoint& a, const SteeringSetpoint& b) noexcept
{
  return a.toolface == b.toolface && a.ratio == b.ratio;
}

inline bool operator==(const Setpoints& a, const Setpoints& b) noexcept
{
  return a.winch == b.winch && a.top_drive == b.top_drive && a.pump.flow == b.pump.flow && a.steering == b.steering &&
         a.magnetic_steering == b.magnetic_steering;
}

}  // namespace drill_rig_sim

#endif
