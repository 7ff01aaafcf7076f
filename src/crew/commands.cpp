// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/crew/commands.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "drill_rig_sim/math/in_capitals.h"
#include "drill_rig_sim/rig/drive_reference.h"

namespace drill_rig_sim
{
namespace
{
CommandResult refused(const char* reason) noexcept
{
  return {CommandResult::Outcome::refused, reason};
}

/// `value` within its limits; sets `clamped` where it was not.
double clamped_to(double value, double low, double high, bool& clamped) noexcept
{
  const double inside = std::clamp(value, low, high);
  clamped = clamped || inside != value;
  return inside;
}

/// Notes in the state whether the last command, of several at once any, was clamped.
CommandResult taken(bool clamped, const char* reason, double now, CommandState& state) noexcept
{
  state.clamped = clamped || (state.clamped && now == state.last_taken);
  state.last_taken = now;
  if (!clamped) return {};
  return {CommandResult::Outcome::clamped, reason};
}
}  // namespace

bool moves(const WinchSetpoint& c) noexcept
{
  return !c.brake && c.block_velocity != 0.0;
}

bool turns(const TopDriveSetpoint& c) noexcept
{
  if (c.brake) return false;
  return goal_of(c.mode) == DriveGoal::torque ? c.torque != 0.0 : turns_to_angle(c.mode) || c.speed != 0.0;
}

const char* what_is_wrong(const WinchSetpoint& c) noexcept
{
  return std::isfinite(c.block_velocity) ? nullptr : "block_velocity: must be finite";
}

namespace
{
const std::string allowed_modes = "mode: allowed are 0 (" + in_capitals(top_drive_modes[0].word) + ") to " +
                                  std::to_string(top_drive_mode_count - 1) + " (" +
                                  in_capitals(top_drive_modes[top_drive_mode_count - 1].word) + ")";
}  // namespace

const char* what_is_wrong(const TopDriveSetpoint& c) noexcept
{
  static_assert(most_drive_angle == 1e8, "the texts have this number");
  if (!is_known(c.mode)) return allowed_modes.c_str();
  const bool swings = goal_of(c.mode) == DriveGoal::swing;
  if (!std::isfinite(c.speed) || !std::isfinite(c.torque) || !std::isfinite(c.angle) || !std::isfinite(c.torque_limit))
    return "speed, torque, angle and torque_limit: must be finite";
  if (!std::isfinite(c.amplitude_right) || !std::isfinite(c.amplitude_left))
    return "amplitude_right and amplitude_left: must be finite";
  if (c.amplitude_right < 0.0 || c.amplitude_left < 0.0) return "amplitude_right and amplitude_left: must not be negative";
  if (swings && c.amplitude_right + c.amplitude_left == 0.0)
    return "amplitude_right and amplitude_left: one of them must be above 0 in OSCILLATE";
  if (turns_to_angle(c.mode) && std::abs(c.angle) > most_drive_angle)
    return "angle: must be between -1e8 and 1e8 rad in ANGLE and OSCILLATE: beyond, a double does not resolve it to 1e-8 rad";
  if (swings && std::max(c.amplitude_right, c.amplitude_left) > most_drive_angle)
    return "amplitude_right and amplitude_left: must be at most 1e8 rad";
  if (c.torque_limit < 0.0) return "torque_limit: must not be negative; 0 means the rig's limit";
  return nullptr;
}

const char* what_is_wrong(const PumpSetpoint& c) noexcept
{
  return std::isfinite(c.flow) ? nullptr : "flow: must be finite";
}

const char* what_is_wrong(const SteeringSetpoint& c) noexcept
{
  return std::isfinite(c.toolface) && std::isfinite(c.ratio) ? nullptr : "toolface and ratio: must be finite";
}

Setpoints CommandState::in_force() const noexcept
{
  if (crew_drives)
  {
    Setpoints crew = by_crew;
    crew.steering = asked.steering;
    crew.magnetic_steering = asked.magnetic_steering;
    return crew;
  }
  if (!timed_out()) return asked;
  Setpoints safe;
  safe.top_drive.mode = TopDriveMode::torque;
  safe.pump = asked.pump;
  safe.steering = asked.steering;
  safe.magnetic_steering = asked.magnetic_steering;
  return safe;
}

CommandResult take(const RigSpec& rig, double now, const WinchSetpoint& c, CommandState& state) noexcept
{
  if (const char* wrong = what_is_wrong(c)) return refused(wrong);
  bool clamped = false;
  const double limit = rig.hoisting.max_speed;
  state.asked.winch = {clamped_to(c.block_velocity, -limit, limit, clamped), c.brake};
  state.last_winch = now;
  state.winch_silent = false;
  return taken(clamped, "block_velocity: clamped to the winch's max_speed", now, state);
}

CommandResult take(const RigSpec& rig, double now, const TopDriveSetpoint& c, CommandState& state) noexcept
{
  if (const char* wrong = what_is_wrong(c)) return refused(wrong);
  const TopDriveSpec& spec = rig.top_drive;
  bool clamped = false;
  TopDriveSetpoint inside = c;
  inside.speed = clamped_to(c.speed, -spec.max_speed, spec.max_speed, clamped);
  inside.torque = clamped_to(c.torque, -spec.max_torque, spec.max_torque, clamped);
  inside.torque_limit = clamped_to(c.torque_limit, 0.0, spec.max_torque, clamped);
  state.asked.top_drive = inside;
  state.last_drive = now;
  state.drive_silent = false;
  return taken(clamped, "speed, torque or torque_limit: clamped to the top drive's limits", now, state);
}

CommandResult take(const RigSpec& rig, double now, const PumpSetpoint& c, CommandState& state) noexcept
{
  if (const char* wrong = what_is_wrong(c)) return refused(wrong);
  bool clamped = false;
  state.asked.pump.flow = clamped_to(c.flow, 0.0, rig.mud_pump.max_flow, clamped);
  return taken(clamped, "flow: clamped to 0 .. the pump's max_flow", now, state);
}

CommandResult take(const RigSpec&, double now, const SteeringSetpoint& c, CommandState& state) noexcept
{
  if (const char* wrong = what_is_wrong(c)) return refused(wrong);
  bool clamped = false;
  state.asked.steering = {c.toolface, clamped_to(c.ratio, 0.0, 1.0, clamped)};
  return taken(clamped, "ratio: clamped to 0 .. 1", now, state);
}

void watch_commands(double timeout, double now, CommandState& state) noexcept
{
  constexpr double not_begun = std::numeric_limits<double>::infinity();
  if (timeout <= 0.0) state.last_winch = state.last_drive = not_begun;
  state.winch_silent = now - state.last_winch > timeout;
  state.drive_silent = now - state.last_drive > timeout;
}

}  // namespace drill_rig_sim
