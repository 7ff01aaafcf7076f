// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/rig/hoisting.h"

#include <algorithm>
#include <cmath>

#include "drill_rig_sim/math/units.h"

namespace drill_rig_sim
{
namespace
{
double line_count(const HoistingSpec& spec) noexcept
{
  return 2.0 * spec.sheaves;
}

/// Largest speed v at the end of a step towards a stop `distance` ahead that the ramp can still bring to rest there; `speed` is
/// that at the start of the step, both towards the stop: (speed + v) h/2 + v^2/(2 a) = distance.
double stopping_speed(double distance, double speed, double acceleration, double step) noexcept
{
  const double half = 0.5 * acceleration * step;
  const double square = half * half + 2.0 * (acceleration * distance - half * speed);
  return std::max(0.0, std::sqrt(std::max(0.0, square)) - half);
}
}  // namespace

double strung_length(const HoistingSpec& spec, double block_height) noexcept
{
  return line_count(spec) * (spec.crown_height - block_height) + spec.fixed_length;
}

LinePull line_pull(const HoistingSpec& spec, double block_height, double line_length) noexcept
{
  LinePull out;
  const double stretch = strung_length(spec, block_height) - line_length;
  if (stretch <= 0.0)
  {
    out.slack = true;
    return out;
  }
  const double lines = line_count(spec);
  out.tension = spec.line_ea * stretch / line_length;
  out.hook_force = lines * out.tension;
  out.stiffness = lines * lines * spec.line_ea / line_length;
  return out;
}

double line_length_for(const HoistingSpec& spec, double block_height, double hook_force) noexcept
{
  const double tension = hook_force / line_count(spec);
  return strung_length(spec, block_height) / (1.0 + tension / spec.line_ea);
}

LineDamper line_damper(const HoistingSpec& spec, const LinePull& pull, double block_velocity, double winch_speed) noexcept
{
  const double damping = 2.0 * spec.line_damping * std::sqrt(pull.stiffness * spec.block_mass);
  const double force = damping * (winch_speed - block_velocity);
  if (force < -pull.hook_force) return {-pull.hook_force, 0.0};
  return {force, damping};
}

DampedBristle rail_bristle(const HoistingSpec& spec, double deflection) noexcept
{
  // half of critical
  return {spec.rail_friction * standard_gravity * spec.block_mass, rail_stiffness, std::sqrt(rail_stiffness * spec.block_mass),
          deflection};
}

StopForce stop_force(const HoistingSpec& spec, double block_height, double block_velocity) noexcept
{
  const bool low = block_height < spec.lowest_block_height;
  const double beyond =
      (low ? spec.lowest_block_height - block_height : block_height - spec.highest_block_height) - stop_clearance;
  const double side = low ? 1.0 : -1.0;
  const double share = 1.0 - stop_damping * side * block_velocity;
  if (beyond <= 0.0) return {};
  const double energy = 0.5 * stop_stiffness * beyond * beyond;
  if (share <= 0.0) return {0.0, 0.0, 0.0, energy};
  return {side * stop_stiffness * beyond * share, stop_stiffness * share, stop_damping * stop_stiffness * beyond, energy};
}

WinchStep advance_winch(const HoistingSpec& spec, const WinchSetpoint& command, double line_length, double speed,
                        double block_height, double hook_load, double step) noexcept
{
  WinchStep out;
  const double wanted = command.brake ? 0.0 : command.block_velocity;
  double target = std::clamp(wanted, -spec.max_speed, spec.max_speed);
  out.limits.speed = target != wanted;

  // ramp
  const double change = spec.max_acceleration * step;
  const double ramped = std::clamp(target, speed - change, speed + change);
  out.limits.acceleration = ramped != target;

  // stops
  const double up = stopping_speed(spec.highest_block_height - block_height, speed, spec.max_acceleration, step);
  const double down = stopping_speed(block_height - spec.lowest_block_height, -speed, spec.max_acceleration, step);
  double reached = std::clamp(ramped, -down, up);
  out.limits.height = reached != ramped;
  const bool most = hook_load >= spec.max_hook_load, least = hook_load < spec.min_hook_load;
  out.limits.load = most || least;
  if (most) reached = std::min(reached, 0.0);
  if (least) reached = std::max(reached, 0.0);

  // What the drum takes in: a ramp that may end within the step. A stop at once is one at the start of the step.
  const double ramp_share = std::abs(reached - speed) / change;
  const bool at_once = ramp_share > 1.0 + 1e-9;
  const double mean = at_once ? reached : reached + 0.5 * ramp_share * (speed - reached);
  out.speed = reached;
  out.line_length = line_length * (1.0 - line_count(spec) * mean * step / strung_length(spec, block_height));
  return out;
}

double slipping_line(const HoistingSpec& spec, double line_length, double block_height, double block_velocity, double most,
                     double step) noexcept
{
  return std::max(line_length, line_length_for(spec, block_height + block_velocity * step, most));
}

double sheave_slip(double slip, double travel) noexcept
{
  return std::clamp(slip + travel / sheave_presliding, -1.0, 1.0);
}

double dead_line_hook_load(double hook_load, double slip, int sheaves, double sheave_efficiency) noexcept
{
  const double ratio = std::pow(sheave_efficiency, -slip);
  const int lines = 2 * sheaves;
  double sum = 0.0;
  for (int i = 0; i < lines; ++i)
  {
    sum = sum * ratio + 1.0;
  }
  return lines * hook_load / sum;
}

SteadyHookLoad steady_hook_load(const HoistingSpec& spec, double weight, int direction) noexcept
{
  SteadyHookLoad load;
  load.at_block = weight + direction * spec.rail_friction * spec.block_mass * standard_gravity;
  load.at_dead_line = dead_line_hook_load(load.at_block, direction, spec.sheaves, spec.sheave_efficiency);
  return load;
}

}  // namespace drill_rig_sim
