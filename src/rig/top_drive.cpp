#include "drill_rig_sim/rig/top_drive.h"

#include <algorithm>
#include <cmath>

#include "drill_rig_sim/rig/damped_bristle.h"

namespace drill_rig_sim
{
namespace
{
/// A branch of the motor's torque as a function of the rotor's increment u.
struct Branch
{
  double at_zero = 0.0;
  double slope = 0.0;  ///< <= 0
  double at(double u) const noexcept { return at_zero + slope * u; }
};

/// J a + k_m (twist + u - top spin) = torque, written as stiffness u - load = torque.
struct Rotor
{
  double stiffness;
  double load;
  double increment(const Branch& torque) const noexcept { return (load + torque.at_zero) / (stiffness - torque.slope); }
  Rotor with(const Branch& torque) const noexcept { return {stiffness - torque.slope, load + torque.at_zero}; }
};

/// tau = torque + speed_gain (speed - w) + turn_gain (turn - u), w the rotor's speed and u its turn since the start of the step.
struct Law
{
  double torque = 0.0;
  double speed_gain = 0.0, speed = 0.0;
  double turn_gain = 0.0, turn = 0.0;

  double at(double u, double w) const noexcept { return torque + speed_gain * (speed - w) + turn_gain * (turn - u); }
  Branch at(const RotorStage& stage) const noexcept
  {
    return {torque + speed_gain * (speed - stage.rate_0) + turn_gain * turn, -speed_gain * stage.dv_du - turn_gain};
  }
};

Law constant(double torque) noexcept
{
  Law out;
  out.torque = torque;
  return out;
}

Law towards(const TopDriveSpec& spec, double speed) noexcept
{
  Law out;
  out.speed_gain = spec.proportional_gain;
  out.speed = speed;
  return out;
}

/// The integral of the speed error is exact: wanted angle less the angle turned.
Law speed_loop(const TopDriveSpec& spec, const RotorState& start, double time, double speed) noexcept
{
  Law out = towards(spec, speed);
  out.turn_gain = spec.integral_gain;
  out.turn = start.integral + speed * time;
  return out;
}

/// Torque mode: the command, or the law that keeps the speed below its limit. value(law): its torque where the rotor is.
template <typename Value>
Law torque_with_speed_limit(const TopDriveSpec& spec, double torque, const Value& value) noexcept
{
  const Law most = towards(spec, spec.max_speed), least = towards(spec, -spec.max_speed);
  return torque > value(most) ? most : torque < value(least) ? least : constant(torque);
}

double wanted_speed(const TopDriveSpec& spec, const TopDriveSetpoint& command) noexcept
{
  return std::clamp(command.speed, -spec.max_speed, spec.max_speed);
}

/// The integral after a step in torque mode.
double following_integral(const TopDriveSpec& spec, double torque) noexcept
{
  return spec.integral_gain > 0.0 ? torque / spec.integral_gain : 0.0;
}

/// The integral after a step in speed mode (anti-windup, see the header).
double next_integral(const TopDriveSpec& spec, double start, double error, double error_integral, double torque, double limit,
                     bool saturated) noexcept
{
  if (spec.integral_gain <= 0.0)
  {
    return 0.0;
  }
  double next = start + error_integral;
  if (saturated)
  {
    const double at_limit = (torque - spec.proportional_gain * error) / spec.integral_gain;
    const bool deeper = (next - start) * torque > 0.0;
    next = deeper ? std::clamp(at_limit, std::min(start, next), std::max(start, next)) : next;
  }
  const double most = limit / spec.integral_gain;
  return std::clamp(next, -most, most);
}

/// Where a stage ends, and the motor's branch in force there.
struct Solution
{
  double increment;
  Branch branch;
  bool saturated, limited;
};

/// The motor in a step.
struct Motor
{
  const TopDriveSpec& spec;
  const TopDriveSetpoint& command;
  const RotorState& start;
  double limit;  ///< [N m]

  bool by_torque() const noexcept { return command.mode == TopDriveMode::torque; }
  /// The law that holds torque mode below the largest speed.
  bool holds_speed(const Law& law) const noexcept { return by_torque() && law.speed_gain != 0.0; }

  /// value(law): its torque where the rotor is.
  template <typename Value>
  Law law(double time, const Value& value) const noexcept
  {
    return by_torque() ? torque_with_speed_limit(spec, command.torque, value) : speed_loop(spec, start, time, wanted_speed(spec, command));
  }

  Solution solve(const Rotor& rotor, const RotorStage& stage, bool braked) const noexcept
  {
    if (braked) return {rotor.increment({}), {}, false, false};
    const double by_command = rotor.increment(constant(command.torque).at(stage));
    const Law in_force = law(stage.time, [&](const Law& l) { return l.at(stage).at(by_command); });
    Branch branch = in_force.at(stage);
    const double wanted = branch.at(rotor.increment(branch));
    const bool saturated = std::abs(wanted) > limit;
    if (saturated) branch = {std::copysign(limit, wanted), 0.0};
    return {rotor.increment(branch), branch, saturated, saturated || holds_speed(in_force)};
  }

  /// The loop's memory after a step that ends at this speed, turn and torque.
  double next(double speed, double turn, double time, double torque, bool saturated) const noexcept
  {
    if (by_torque()) return following_integral(spec, torque);
    const double wanted = wanted_speed(spec, command);
    return next_integral(spec, start.integral, wanted - speed, wanted * time - turn, torque, limit, saturated);
  }
};

/// Friction of gearbox and brake in a step from `start`.
DampedBristle gear_bristle(const TopDriveSpec& spec, bool braked, const RotorState& start) noexcept
{
  DampedBristle out{spec.gearbox_friction + (braked ? spec.brake_torque : 0.0), gear_stiffness, std::sqrt(gear_stiffness * spec.inertia),
                    start.gear_twist};
  if (braked && !start.braked) out.deflection -= spec.integral_gain * start.integral / gear_stiffness;
  return out;
}

/// What it carries while it sticks, as a function of the increment.
Branch held_by(const DampedBristle& bristle, const RotorStage& stage) noexcept
{
  return {-bristle.trial(0.0, stage.rate_0), -bristle.stiffness - bristle.damping * stage.dv_du};
}
}  // namespace

double motor_torque_limit(const TopDriveSpec& spec, const TopDriveSetpoint& command, double speed) noexcept
{
  const double torque = command.torque_limit > 0.0 ? std::min(spec.max_torque, command.torque_limit) : spec.max_torque;
  const double turning = std::abs(speed);
  return torque * turning > spec.max_power ? spec.max_power / turning : torque;
}

bool brake_is_on(const TopDriveSpec& spec, const TopDriveSetpoint& command, const RotorState& start) noexcept
{
  if (spec.brake_torque <= 0.0) return false;
  const bool stopped = command.mode == TopDriveMode::speed && command.speed == 0.0;
  return command.brake || (stopped && (start.braked || std::abs(start.speed) < standing_rotor));
}

RotorResult solve_rotor(const TopDriveSpec& spec, const TopDriveSetpoint& command, const RotorState& start, const RotorStage& stage,
                        double top_spin) noexcept
{
  const double spring = spec.meter_stiffness;
  const Rotor bare{spec.inertia * stage.da_du + spring, spring * (top_spin - start.twist) - spec.inertia * stage.acceleration_0};
  const bool braked = brake_is_on(spec, command, start);
  const Motor motor{spec, command, start, motor_torque_limit(spec, command, start.speed)};

  const DampedBristle gear = gear_bristle(spec, braked, start);
  Branch held = held_by(gear, stage);
  Solution found = motor.solve(bare.with(held), stage, braked);
  const double q = -held.at(found.increment);
  if (std::abs(q) > gear.most)
  {
    held = {std::copysign(gear.most, -q), 0.0};
    found = motor.solve(bare.with(held), stage, braked);
  }

  RotorResult out;
  out.increment = found.increment;
  out.motor_torque = found.branch.at(out.increment);
  out.friction = held.at(out.increment);
  out.limited = found.limited;
  out.state.speed = stage.dv_du * out.increment + stage.rate_0;
  out.acceleration = stage.da_du * out.increment + stage.acceleration_0;
  out.state.twist = start.twist + out.increment - top_spin;
  out.meter_torque = spring * out.state.twist;
  out.stiffness = spring * (1.0 - spring / (bare.stiffness - held.slope - found.branch.slope));
  out.state.braked = braked;
  out.state.gear_twist = gear.next(out.increment, out.friction, held.slope == 0.0, stage.time);
  out.state.integral = braked ? following_integral(spec, out.motor_torque + out.friction)
                              : motor.next(out.state.speed, out.increment, stage.time, out.motor_torque, found.saturated);
  return out;
}

DriveTorque drive_torque(const TopDriveSpec& spec, const TopDriveSetpoint& command, const RotorState& start, double time, double turn,
                         double speed) noexcept
{
  const bool braked = brake_is_on(spec, command, start);
  const Motor motor{spec, command, start, motor_torque_limit(spec, command, start.speed)};
  Law law = braked ? constant(0.0) : motor.law(time, [&](const Law& l) { return l.at(turn, speed); });
  DriveTorque out;
  out.limited = motor.holds_speed(law);
  out.motor = law.at(turn, speed);
  const bool saturated = std::abs(out.motor) > motor.limit;
  if (saturated)
  {
    out.motor = std::copysign(motor.limit, out.motor);
    law = constant(out.motor);
    out.limited = true;
  }
  const BristleForce friction = gear_bristle(spec, braked, start).at(turn, speed, time);
  out.friction = friction.force;
  out.by_turn = -law.turn_gain + friction.by_move;
  out.by_speed = -law.speed_gain + friction.by_speed;
  out.braked = braked;
  out.gear_twist = friction.next;
  out.integral = braked ? following_integral(spec, out.motor + out.friction) : motor.next(speed, turn, time, out.motor, saturated);
  return out;
}

}  // namespace drill_rig_sim
