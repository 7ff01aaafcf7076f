// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/rig/top_drive.h"

#include <algorithm>
#include <cmath>

#include "drill_rig_sim/rig/damped_bristle.h"
#include "drill_rig_sim/rig/drive_reference.h"

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

/// tau = torque + speed_gain (speed - w) + turn_gain (turn - u) + meter_gain T, w the rotor's speed, u its turn since the start
/// of the step.
struct Law
{
  double torque = 0.0;
  double speed_gain = 0.0, speed = 0.0;
  double turn_gain = 0.0, turn = 0.0;
  double meter_gain = 0.0;

  double at(double u, double w, double meter) const noexcept
  {
    return torque + speed_gain * (speed - w) + turn_gain * (turn - u) + meter_gain * meter;
  }
  /// `meter`: T as a function of u.
  Branch at(const RotorStage& stage, const Branch& meter) const noexcept
  {
    return {torque + speed_gain * (speed - stage.rate_0) + turn_gain * turn + meter_gain * meter.at_zero,
            -speed_gain * stage.dv_du - turn_gain + meter_gain * meter.slope};
  }
};

Law constant(double torque) noexcept
{
  Law out;
  out.torque = torque;
  return out;
}

/// Towards a speed, to hold torque mode below its limit.
Law towards(const TopDriveSpec& spec, double speed) noexcept
{
  Law out;
  out.speed_gain = spec.proportional_gain;
  out.speed = speed;
  return out;
}

/// Gains of a loop, and how many times lighter than it is it makes the rotor.
struct Loop
{
  double proportional, integral;
  double lightened = 1.0;  ///< q

  /// What an integral holds [N m/rad].
  double holding() const noexcept { return integral > 0.0 ? integral : 1.0; }
  bool holds_as(const Loop& other) const noexcept { return integral == other.integral && lightened == other.lightened; }
  double torque(double held, double error, double meter) const noexcept
  {
    return meter + lightened * (proportional * error + held - meter);
  }
  /// The held torque that makes this one of the motor's.
  double held(double torque, double error, double meter) const noexcept
  {
    return (torque - (1.0 - lightened) * meter) / lightened - proportional * error;
  }
};

Loop loop_of_speed(const TopDriveSpec& spec) noexcept
{
  return {spec.proportional_gain, spec.integral_gain};
}

Loop loop_of_droop(const TopDriveSpec& spec) noexcept
{
  return {spec.proportional_gain, 0.0};
}

Loop loop_of_angle(const TopDriveSpec& spec) noexcept
{
  const double gain = spec.proportional_gain;
  return {gain, std::max(spec.integral_gain, 0.25 * gain * gain / spec.inertia)};
}

Loop loop_of(const DriveImpedance& z) noexcept
{
  return {z.damping, z.stiffness, 1.0 / (1.0 - z.inertia_compensation)};
}
Loop loop_of_soft_torque(const TopDriveSpec& spec) noexcept
{
  return loop_of(spec.soft_torque);
}
Loop loop_of_z_torque(const TopDriveSpec& spec) noexcept
{
  return loop_of(spec.z_torque);
}

Loop loop_of(const TopDriveSpec& spec, TopDriveMode mode) noexcept
{
  switch (mode)
  {
#define MODE(name, goal, brakes, loop, ...) \
  case TopDriveMode::name:                  \
    return loop(spec);
#include "drill_rig_sim/rig/top_drive_mode_list.h"
  }
  return loop_of_speed(spec);
}

/// The integral that a step begins with: another loop's is taken over so that the motor's torque goes on.
double integral_taken_over(const TopDriveSpec& spec, TopDriveMode mode, const DriveState& start, double limit) noexcept
{
  const Loop before = loop_of(spec, start.loop), loop = loop_of(spec, mode);
  if (loop.holds_as(before)) return start.integral;
  const double error = start.reference - start.speed, meter = spec.meter_stiffness * start.meter_twist;
  const double torque = before.torque(before.holding() * start.integral, error, meter);
  return std::clamp(loop.held(std::clamp(torque, -limit, limit), error, meter), -limit, limit) / loop.holding();
}

/// Where a stage ends, and the motor's law in force there.
struct Solution
{
  double increment;
  Law law;
  Branch branch;
  bool saturated;
};

/// The motor in a step.
struct Motor
{
  const TopDriveSpec& spec;
  const TopDriveSetpoint& command;
  const DriveState& start;
  double limit;  ///< [N m]
  Loop loop;
  double integral;  ///< at the start of the step [rad]
  SpeedReference reference;

  Motor(const TopDriveSpec& s, const TopDriveSetpoint& c, const DriveState& at_start) noexcept
      : spec(s),
        command(c),
        start(at_start),
        limit(motor_torque_limit(s, c, at_start.speed)),
        loop(loop_of(s, c.mode)),
        integral(integral_taken_over(s, c.mode, at_start, limit)),
        reference(speed_reference(s, c, at_start))
  {
  }

  bool by_torque() const noexcept { return goal_of(command.mode) == DriveGoal::torque; }
  /// The law that holds torque mode below the largest speed.
  bool holds_speed(const Law& law) const noexcept { return by_torque() && law.speed_gain != 0.0; }

  /// The integral of the speed error is exact: wanted angle less the angle turned.
  Law speed_loop(double time) const noexcept
  {
    Law out;
    out.torque = spec.inertia * reference.acceleration(time);
    out.speed_gain = loop.lightened * loop.proportional;
    out.speed = reference.at(time);
    out.turn_gain = loop.lightened * loop.integral;
    out.turn = integral + reference.turned(time);
    out.meter_gain = 1.0 - loop.lightened;
    return out;
  }

  /// value(law): its torque where the rotor is.
  template <typename Value>
  Law law(double time, const Value& value) const noexcept
  {
    if (!by_torque()) return speed_loop(time);
    const Law most = towards(spec, spec.max_speed), least = towards(spec, -spec.max_speed);
    return command.torque > value(most) ? most : command.torque < value(least) ? least : constant(command.torque);
  }

  Solution solve(const Rotor& rotor, const RotorStage& stage, const Branch& meter, bool braked) const noexcept
  {
    if (braked) return {rotor.increment({}), {}, {}, false};
    const double by_command = rotor.increment({command.torque, 0.0});
    Solution out{0.0, law(stage.time, [&](const Law& l) { return l.at(stage, meter).at(by_command); }), {}, false};
    out.branch = out.law.at(stage, meter);
    const double wanted = out.branch.at(rotor.increment(out.branch));
    out.saturated = std::abs(wanted) > limit;
    if (out.saturated) out.branch = {std::copysign(limit, wanted), 0.0};
    out.increment = rotor.increment(out.branch);
    return out;
  }

  /// The integral after a step that ends at this speed, turn, motor's and meter's torque (anti-windup, see the header).
  double next_integral(double time, double speed, double turn, double torque, double meter, bool saturated) const noexcept
  {
    if (by_torque()) return torque / loop.holding();
    if (loop.integral <= 0.0) return 0.0;
    double next = integral + (reference.turned(time) - turn);
    if (saturated)
    {
      const double pushed = torque - spec.inertia * reference.acceleration(time);
      const double at_limit = loop.held(pushed, reference.at(time) - speed, meter) / loop.integral;
      const bool deeper = (next - integral) * torque > 0.0;
      next = deeper ? std::clamp(at_limit, std::min(integral, next), std::max(integral, next)) : next;
    }
    const double most = limit / loop.integral;
    return std::clamp(next, -most, most);
  }
};

/// Friction of gearbox and brake in a step from `start`.
DampedBristle gear_bristle(const TopDriveSpec& spec, bool braked, const DriveState& start) noexcept
{
  DampedBristle out{spec.gearbox_friction + (braked ? spec.brake_torque : 0.0), gear_stiffness,
                    std::sqrt(gear_stiffness * spec.inertia), start.gear_twist};
  if (braked && !start.braked) out.deflection -= loop_of(spec, start.loop).holding() * start.integral / gear_stiffness;
  return out;
}

/// What it carries while it sticks, as a function of the increment.
Branch held_by(const DampedBristle& bristle, const RotorStage& stage) noexcept
{
  return {-bristle.trial(0.0, stage.rate_0), -bristle.stiffness - bristle.damping * stage.dv_du};
}

/// Where a step ends, and what drives the rotor there.
struct End
{
  double time, turn, speed, meter_twist;
  double motor, friction;
  bool saturated;
};

/// What is remembered of it.
DriveState next_state(const Motor& motor, bool braked, const End& end) noexcept
{
  DriveState next = motor.start;
  next.angle += end.turn;
  next.speed = end.speed;
  next.meter_twist = end.meter_twist;
  next.reference = braked || motor.by_torque() ? end.speed : motor.reference.at(end.time);
  next.swings_left = swings_left(motor.spec, motor.command, motor.start);
  next.braked = braked;
  next.reversed = motor.start.speed * end.speed < 0.0;
  next.loop = braked ? TopDriveMode::torque : motor.command.mode;
  next.integral = braked ? (end.motor + end.friction) / loop_of(motor.spec, next.loop).holding()
                         : motor.next_integral(end.time, end.speed, end.turn, end.motor,
                                               motor.spec.meter_stiffness * end.meter_twist, end.saturated);
  return next;
}
}  // namespace

double motor_torque_limit(const TopDriveSpec& spec, const TopDriveSetpoint& command, double speed) noexcept
{
  const double torque = command.torque_limit > 0.0 ? std::min(spec.max_torque, command.torque_limit) : spec.max_torque;
  const double turning = std::abs(speed);
  return torque * turning > spec.max_power ? spec.max_power / turning : torque;
}

bool brake_is_on(const TopDriveSpec& spec, const TopDriveSetpoint& command, const DriveState& start) noexcept
{
  if (spec.brake_torque <= 0.0) return false;
  const bool stands = start.braked || start.reversed || std::abs(start.speed) < standing_rotor;
  const TopDriveModeTraits& mode = top_drive_modes[static_cast<int>(command.mode)];
  const bool stopped = mode.goal == DriveGoal::speed && command.speed == 0.0;
  const bool there =
      mode.goal == DriveGoal::angle && std::abs(command.angle - start.angle) < (start.braked ? 1.0 : 0.5) * angle_tolerance;
  return command.brake || (mode.brakes && (stopped || there) && stands);
}

RotorResult solve_rotor(const TopDriveSpec& spec, const TopDriveSetpoint& command, const DriveState& start,
                        const RotorStage& stage, double top_spin) noexcept
{
  const double spring = spec.meter_stiffness;
  const Branch meter{spring * (start.meter_twist - top_spin), spring};
  const Rotor bare{spec.inertia * stage.da_du + spring, -meter.at_zero - spec.inertia * stage.acceleration_0};
  const bool braked = brake_is_on(spec, command, start);
  const Motor motor(spec, command, start);

  const DampedBristle gear = gear_bristle(spec, braked, start);
  Branch held = held_by(gear, stage);
  Solution found = motor.solve(bare.with(held), stage, meter, braked);
  const double q = -held.at(found.increment);
  if (std::abs(q) > gear.most)
  {
    held = {std::copysign(gear.most, -q), 0.0};
    found = motor.solve(bare.with(held), stage, meter, braked);
  }

  RotorResult out;
  const double u = out.increment = found.increment;
  out.motor_torque = found.branch.at(u);
  out.friction = held.at(u);
  out.acceleration = stage.da_du * u + stage.acceleration_0;
  const double twist = start.meter_twist + u - top_spin;
  out.meter_torque = spring * twist;
  const double by_top = found.saturated ? spring : spring * (1.0 - found.law.meter_gain);
  out.stiffness = spring * (1.0 - by_top / (bare.stiffness - held.slope - found.branch.slope));
  out.state = next_state(motor, braked,
                         {stage.time, u, stage.dv_du * u + stage.rate_0, twist, out.motor_torque, out.friction, found.saturated});
  out.state.gear_twist = gear.next(u, out.friction, held.slope == 0.0, stage.time);
  out.state.limited = found.saturated || motor.holds_speed(found.law);
  return out;
}

DriveTorque drive_torque(const TopDriveSpec& spec, const TopDriveSetpoint& command, const DriveState& start, double time,
                         double turn, double speed, double twist) noexcept
{
  const bool braked = brake_is_on(spec, command, start);
  const Motor motor(spec, command, start);
  const double meter = spec.meter_stiffness * twist;
  Law law = braked ? Law{} : motor.law(time, [&](const Law& l) { return l.at(turn, speed, meter); });
  DriveTorque out;
  bool limited = motor.holds_speed(law);
  out.motor = law.at(turn, speed, meter);
  const bool saturated = std::abs(out.motor) > motor.limit;
  if (saturated)
  {
    out.motor = std::copysign(motor.limit, out.motor);
    law = constant(out.motor);
    limited = true;
  }
  const BristleForce friction = gear_bristle(spec, braked, start).at(turn, speed, time);
  out.friction = friction.force;
  out.by_turn = -law.turn_gain + friction.by_move;
  out.by_speed = -law.speed_gain + friction.by_speed;
  out.by_meter = law.meter_gain;
  out.state = next_state(motor, braked, {time, turn, speed, twist, out.motor, out.friction, saturated});
  out.state.gear_twist = friction.next;
  out.state.limited = limited;
  return out;
}

}  // namespace drill_rig_sim
