// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_RIG_DRIVE_REFERENCE_H
#define DRILL_RIG_SIM_RIG_DRIVE_REFERENCE_H

#include "drill_rig_sim/rig/top_drive.h"

/// The speed w* that the top drive's loop follows: by command, or to an angle. As a drive's own computer does, it is set anew at
/// the start of every step, from the angle there.
///
/// It moves towards its target at max_acceleration at most. The target is
/// - SPEED, SOFT_TORQUE, Z_TORQUE: the command's speed;
/// - ANGLE: the speed from which the rotor comes to rest at the angle, slower by itself over the last part: with e the angle
/// left,
///   angle_gain |e| up to |e| = a/angle_gain^2, beyond it sqrt(2 a (|e| - a/(2 angle_gain^2))), never above the command's; a the
///   acceleration;
/// - OSCILLATE: the command's speed, clockwise up to angle + amplitude_right, counterclockwise down to angle - amplitude_left; it
/// turns back
///   so far ahead of these as it takes to stop, and where the torque limit has stopped the rotor.
namespace drill_rig_sim
{
constexpr double angle_gain = 1.0;                ///< [1/s]
constexpr double angle_acceleration = 2.0;        ///< of ANGLE and OSCILLATE where the scene has no max_acceleration [rad/s2]
constexpr double angle_speed = 10.0 * rpm;        ///< of both where the command's is 0 [rad/s]
constexpr double angle_tolerance = 0.5 * degree;  ///< so near the brake holds it; it takes over at half of that [rad]

/// Linear in time up to its target, then constant.
struct SpeedReference
{
  double from = 0.0, to = 0.0;  ///< [rad/s]
  double over = 0.0;            ///< time that the way takes [s]

  /// [rad/s]
  double at(double time) const noexcept;
  /// Turned by it from the start of the step on [rad].
  double turned(double time) const noexcept;
  /// Its mean acceleration from the start of the step on [rad/s2].
  double acceleration(double time) const noexcept;
};

/// In a step from `start`; constantly 0 in TORQUE.
SpeedReference speed_reference(const TopDriveSpec& spec, const TopDriveSetpoint& command, const DriveState& start) noexcept;

/// Which way OSCILLATE swings in a step from `start`; as before in other modes.
bool swings_left(const TopDriveSpec& spec, const TopDriveSetpoint& command, const DriveState& start) noexcept;

}  // namespace drill_rig_sim

#endif
