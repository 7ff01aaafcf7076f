// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/rig/drive_reference.h"

#include <algorithm>
#include <cmath>

namespace drill_rig_sim
{
namespace
{
double acceleration_to_angles(const TopDriveSpec& spec) noexcept
{
  return spec.max_acceleration > 0.0 ? spec.max_acceleration : angle_acceleration;
}

double speed_to_angles(const TopDriveSpec& spec, const TopDriveSetpoint& command) noexcept
{
  return command.speed != 0.0 ? std::min(std::abs(command.speed), spec.max_speed) : angle_speed;
}

/// The speed from which the rotor comes to rest after `left` [rad].
double speed_to_rest(double left, double acceleration) noexcept
{
  const double far = std::abs(left), near = acceleration / (angle_gain * angle_gain);
  const double speed = far < near ? angle_gain * far : std::sqrt(2.0 * acceleration * (far - 0.5 * near));
  return std::copysign(speed, left);
}

double target_speed(const TopDriveSpec& spec, const TopDriveSetpoint& command, const DriveState& start) noexcept
{
  const double most = speed_to_angles(spec, command);
  switch (goal_of(command.mode))
  {
    case DriveGoal::torque:
      return 0.0;
    case DriveGoal::angle:
      return std::clamp(speed_to_rest(command.angle - start.angle, acceleration_to_angles(spec)), -most, most);
    case DriveGoal::swing:
      return swings_left(spec, command, start) ? -most : most;
    case DriveGoal::speed:
      break;
  }
  return std::clamp(command.speed, -spec.max_speed, spec.max_speed);
}
}  // namespace

double SpeedReference::at(double time) const noexcept
{
  return time < over ? from + (to - from) * time / over : to;
}

double SpeedReference::turned(double time) const noexcept
{
  const double moving = std::min(time, over);
  return 0.5 * (from + at(moving)) * moving + to * (time - moving);
}

double SpeedReference::acceleration(double time) const noexcept
{
  return time > 0.0 ? (at(time) - from) / time : 0.0;
}

SpeedReference speed_reference(const TopDriveSpec& spec, const TopDriveSetpoint& command, const DriveState& start) noexcept
{
  const double target = target_speed(spec, command, start);
  const double acceleration = turns_to_angle(command.mode) ? acceleration_to_angles(spec) : spec.max_acceleration;
  if (acceleration <= 0.0 || goal_of(command.mode) == DriveGoal::torque) return {target, target, 0.0};
  return {start.reference, target, std::abs(target - start.reference) / acceleration};
}

bool swings_left(const TopDriveSpec& spec, const TopDriveSetpoint& command, const DriveState& start) noexcept
{
  if (goal_of(command.mode) != DriveGoal::swing) return start.swings_left;
  const double way = start.swings_left ? -1.0 : 1.0, speed = way * start.reference, most = speed_to_angles(spec, command);
  const double stop = speed > 0.0 ? 0.5 * speed * speed / acceleration_to_angles(spec) : 0.0;
  const double left_over = start.swings_left ? start.angle - (command.angle - command.amplitude_left)
                                             : command.angle + command.amplitude_right - start.angle;
  const bool held = start.limited && speed >= most && std::abs(start.speed) < standing_rotor;
  return left_over <= stop || held ? !start.swings_left : start.swings_left;
}

}  // namespace drill_rig_sim
