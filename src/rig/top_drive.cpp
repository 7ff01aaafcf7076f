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

/// k_p (speed - w) as a function of u.
Branch proportional(const TopDriveSpec& spec, const RotorStage& stage, double speed) noexcept
{
  return {spec.proportional_gain * (speed - stage.rate_0), -spec.proportional_gain * stage.rate_by_u};
}

/// The integral of the speed error at the stage is exact: wanted angle less the angle turned.
Branch speed_loop(const TopDriveSpec& spec, const RotorState& start, const RotorStage& stage, double speed) noexcept
{
  Branch out = proportional(spec, stage, speed);
  out.at_zero += spec.integral_gain * (start.integral + speed * stage.time);
  out.slope -= spec.integral_gain;
  return out;
}

/// Torque mode: the command, or the branch that keeps the speed below its limit.
Branch torque_with_speed_limit(const TopDriveSpec& spec, const Rotor& rotor, const RotorStage& stage, double torque) noexcept
{
  const Branch wanted{torque, 0.0};
  const double u = rotor.increment(wanted);
  const Branch most = proportional(spec, stage, spec.max_speed);
  const Branch least = proportional(spec, stage, -spec.max_speed);
  return torque > most.at(u) ? most : torque < least.at(u) ? least : wanted;
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
  const Rotor rotor{spec.inertia * stage.acceleration_by_u + spring,
                    spring * (top_spin - start.twist) - spec.inertia * stage.acceleration_0};
  const double limit = motor_torque_limit(spec, command, start.speed);
  const bool torque_mode = command.mode == TopDriveMode::torque;
  const double speed = std::clamp(command.speed, -spec.max_speed, spec.max_speed);

  // the branch in force
  RotorResult out;
  Branch branch = torque_mode ? torque_with_speed_limit(spec, rotor, stage, command.torque) : speed_loop(spec, start, stage, speed);
  out.limited = torque_mode && branch.slope != 0.0;
  const double wanted = branch.at(rotor.increment(branch));
  const bool saturated = std::abs(wanted) > limit;
  if (saturated)
  {
    branch = {std::copysign(limit, wanted), 0.0};
    out.limited = true;
  }

  // rotor and meter
  out.increment = rotor.increment(branch);
  out.motor_torque = branch.at(out.increment);
  out.state.speed = stage.rate_by_u * out.increment + stage.rate_0;
  out.acceleration = stage.acceleration_by_u * out.increment + stage.acceleration_0;
  out.state.twist = start.twist + out.increment - top_spin;
  out.meter_torque = spring * out.state.twist;
  out.stiffness = spring * (1.0 - spring / (rotor.stiffness - branch.slope));

  // speed loop's memory
  if (torque_mode)
  {
    out.state.integral = spec.integral_gain > 0.0 ? out.motor_torque / spec.integral_gain : 0.0;
  }
  else
  {
    out.state.integral = next_integral(spec, start.integral, speed - out.state.speed, speed * stage.time - out.increment,
                                       out.motor_torque, limit, saturated);
  }
  return out;
}

DriveTorque drive_torque(const TopDriveSpec& spec, const TopDriveSetpoint& command, const RotorState& start, double time, double turn,
                         double speed) noexcept
{
  const double limit = motor_torque_limit(spec, command, start.speed);
  const double wanted = std::clamp(command.speed, -spec.max_speed, spec.max_speed);
  DriveTorque out;
  if (command.mode == TopDriveMode::torque)
  {
    const double most = spec.proportional_gain * (spec.max_speed - speed), least = spec.proportional_gain * (-spec.max_speed - speed);
    out.value = std::clamp(command.torque, least, most);
    out.limited = out.value != command.torque;
    out.by_speed = out.limited ? -spec.proportional_gain : 0.0;
  }
  else
  {
    out.value = spec.proportional_gain * (wanted - speed) + spec.integral_gain * (start.integral + wanted * time - turn);
    out.by_speed = -spec.proportional_gain;
    out.by_turn = -spec.integral_gain;
  }
  const bool saturated = std::abs(out.value) > limit;
  if (saturated)
  {
    out.value = std::copysign(limit, out.value);
    out.by_speed = out.by_turn = 0.0;
    out.limited = true;
  }
  if (command.mode == TopDriveMode::torque)
    out.integral = spec.integral_gain > 0.0 ? out.value / spec.integral_gain : 0.0;
  else
    out.integral = next_integral(spec, start.integral, wanted - speed, wanted * time - turn, out.value, limit, saturated);
  return out;
}

}  // namespace drill_rig_sim
