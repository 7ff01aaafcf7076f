#include "drill_rig_sim/rig/top_drive.h"

#include <algorithm>
#include <cmath>
#include <limits>

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
}  // namespace

double motor_torque_limit(const TopDriveSpec& spec, const TopDriveSetpoint& command, double speed) noexcept
{
  const double torque = command.torque_limit > 0.0 ? std::min(spec.max_torque, command.torque_limit) : spec.max_torque;
  const double turning = std::abs(speed);
  return torque * turning > spec.max_power ? spec.max_power / turning : torque;
}

RotorResult solve_rotor(const TopDriveSpec& spec, const TopDriveSetpoint& command, const RotorState& start, const RotorStage& stage,
                        double top_spin) noexcept
{
  const double spring = spec.meter_stiffness;
  const Rotor rotor{spec.inertia * stage.da_du + spring,
                    spring * (top_spin - start.twist) - spec.inertia * stage.acceleration_0};
  const double limit = motor_torque_limit(spec, command, start.speed);
  const bool torque_mode = command.mode == TopDriveMode::torque;
  const double speed = wanted_speed(spec, command);

  // the branch in force
  RotorResult out;
  const double by_command = rotor.increment(constant(command.torque).at(stage));
  const Law law = torque_mode ? torque_with_speed_limit(spec, command.torque, [&](const Law& l) { return l.at(stage).at(by_command); })
                              : speed_loop(spec, start, stage.time, speed);
  Branch branch = law.at(stage);
  out.limited = torque_mode && law.speed_gain != 0.0;
  const double wanted = branch.at(rotor.increment(branch));
  const bool saturated = std::abs(wanted) > limit;
  if (saturated)
  {
    branch = constant(std::copysign(limit, wanted)).at(stage);
    out.limited = true;
  }

  // rotor and meter
  out.increment = rotor.increment(branch);
  out.motor_torque = branch.at(out.increment);
  out.state.speed = stage.dv_du * out.increment + stage.rate_0;
  out.acceleration = stage.da_du * out.increment + stage.acceleration_0;
  out.state.twist = start.twist + out.increment - top_spin;
  out.meter_torque = spring * out.state.twist;
  out.stiffness = spring * (1.0 - spring / (rotor.stiffness - branch.slope));

  // speed loop's memory
  const double integral = next_integral(spec, start.integral, speed - out.state.speed, speed * stage.time - out.increment,
                                        out.motor_torque, limit, saturated);
  out.state.integral = torque_mode ? following_integral(spec, out.motor_torque) : integral;
  return out;
}

DriveTorque drive_torque(const TopDriveSpec& spec, const TopDriveSetpoint& command, const RotorState& start, double time, double turn,
                         double speed) noexcept
{
  const double limit = motor_torque_limit(spec, command, start.speed);
  const bool torque_mode = command.mode == TopDriveMode::torque;
  const double wanted = wanted_speed(spec, command);
  Law law = torque_mode ? torque_with_speed_limit(spec, command.torque, [&](const Law& l) { return l.at(turn, speed); })
                        : speed_loop(spec, start, time, wanted);
  DriveTorque out;
  out.limited = torque_mode && law.speed_gain != 0.0;
  out.value = law.at(turn, speed);
  const bool saturated = std::abs(out.value) > limit;
  if (saturated)
  {
    out.value = std::copysign(limit, out.value);
    law = constant(out.value);
    out.limited = true;
  }
  out.by_turn = -law.turn_gain;
  out.by_speed = -law.speed_gain;
  const double integral = next_integral(spec, start.integral, wanted - speed, wanted * time - turn, out.value, limit, saturated);
  out.integral = torque_mode ? following_integral(spec, out.value) : integral;
  return out;
}

}  // namespace drill_rig_sim
