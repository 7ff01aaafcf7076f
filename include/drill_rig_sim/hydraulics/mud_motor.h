// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_HYDRAULICS_MUD_MOTOR_H
#define DRILL_RIG_SIM_HYDRAULICS_MUD_MOTOR_H

#include <algorithm>
#include <cmath>

#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/string/part.h"

/// Positive-displacement mud motor: the bit's speed relative to the housing.
///
/// Steady: w_ss = N_0 (1 - (T/T_stall)^b), N_0 = 2 pi Q/V, dp = 2 pi T/V: the pressure across the motor does the work of the
/// torque, slip takes the rest of the flow's. A motor with friction inside has dp = 2 pi T/(e V), e its mechanical efficiency:
/// callers give e V for V in dp. Q flow, V displacement per revolution of the bit, T torque on rotor and bit; b 3 to 5 for power
/// sections as in curves of manufacturers. Beyond stall the curve continues along its tangent: a rotor turned backwards by the
/// string carries little more than T_stall. A flow below the leakage, whose pressure is not enough for the torque, does not
/// turn it: it is locked, and has its speed from twice the leakage on. So T w is never more than dp Q. The speed follows with a
/// time constant of 0.05 s (inertia of the rotor, compressibility of the mud in it); with that lag the speed is known at the
/// start of a step and torque and speed are not coupled within it. The steady state is untouched.
namespace drill_rig_sim
{
constexpr double mud_motor_lag = 0.05;  ///< [s]
/// Flow that passes a loaded motor without turning it: below, its pressure falls in proportion, so that what the pump has left
/// behind leaks away through it [m3/s].
constexpr double mud_motor_leakage = 5e-4;

/// What of the flow Q >= 0 turns the motor [m3/s].
inline double mud_motor_turning_flow(double flow) noexcept
{
  return flow * std::clamp(flow / mud_motor_leakage - 1.0, 0.0, 1.0);
}

/// Speed whose product with the torque is the power dp Q that the mud gives [rad/s].
inline double mud_motor_flow_speed(double flow, double displacement) noexcept
{
  return std::clamp(flow / mud_motor_leakage, 0.0, 1.0) * 2.0 * pi * flow / displacement;
}

struct MudMotorSpeed
{
  double value = 0.0;  ///< w_ss [rad/s]
  double slope = 0.0;  ///< d w_ss / d T, <= 0 [rad/s per N m]
};

/// A torque that drives the bit on (T < 0) does not speed it up: the flow holds it.
/// @param flow          Q >= 0 [m3/s]
/// @param displacement  V > 0 [m3/rev]
/// @param stall_torque  T_stall > 0 [N m]
/// @param exponent      b >= 1 [-]
/// @param torque        T, + against the bit's turning [N m]
inline MudMotorSpeed mud_motor_steady_speed(double flow, double displacement, double stall_torque, double exponent,
                                            double torque) noexcept
{
  const double free = 2.0 * pi * mud_motor_turning_flow(flow) / displacement, load = std::max(0.0, torque / stall_torque),
               steepest = exponent * free / stall_torque;
  if (load > 1.0) return {steepest * (stall_torque - torque), -steepest};
  return {free * (1.0 - std::pow(load, exponent)), torque > 0.0 ? -steepest * std::pow(load, exponent - 1.0) : 0.0};
}

/// Speed at the end of a step h [s]: implicit Euler of the lag, as if the torque followed the motor's turn within the step as its
/// slope says. Without that a stuck bit, stiff as it is, would swing against the motor.
/// @param steady  at the torque of the step
/// @param by_turn  dT / d (turn of the bit), >= 0 [N m/rad]
inline double advance_mud_motor(double speed, const MudMotorSpeed& steady, double by_turn, double step) noexcept
{
  const double share = step / (mud_motor_lag + step);
  return speed + share * (steady.value - speed) / (1.0 - share * steady.slope * std::max(0.0, by_turn) * step);
}

/// Differential pressure dp = 2 pi T/V [Pa], V the displacement times the mechanical efficiency, in proportion below the leakage;
/// zero for a torque that drives the bit on.
inline double mud_motor_pressure(double flow, double displacement, double torque) noexcept
{
  return std::clamp(flow / mud_motor_leakage, 0.0, 1.0) * 2.0 * pi * std::max(0.0, torque) / displacement;
}

/// dp of a motor that is pumped at its stall torque [Pa].
inline double mud_motor_stall_pressure(const MotorSpec& motor) noexcept
{
  return mud_motor_pressure(mud_motor_leakage, motor.pressure_displacement(), motor.stall_torque);
}

/// The motor is pumped but its torque has reached T_stall.
inline bool mud_motor_stalled(double flow, double stall_torque, double torque) noexcept
{
  return flow > 0.0 && torque >= stall_torque;
}

}  // namespace drill_rig_sim

#endif
