#ifndef DRILL_RIG_SIM_RIG_MUD_MOTOR_H
#define DRILL_RIG_SIM_RIG_MUD_MOTOR_H

#include <algorithm>

#include "drill_rig_sim/math/units.h"

/// Positive-displacement mud motor: the bit's speed relative to the housing.
///
/// Steady: w_ss = 2 pi Q/V max(0, 1 - T/T_stall), dp = 2 pi T/V: the pressure across the motor does the work of the torque, slip
/// takes the rest of the flow's. Q flow, V displacement per revolution of the bit, T torque on bit. The speed follows with a time
/// constant of 0.05 s (inertia of the rotor, compressibility of the mud in it); with that lag the speed is known at the start of
/// a step and torque and speed are not coupled within it. The steady state is untouched.
namespace drill_rig_sim
{
constexpr double mud_motor_lag = 0.05;  ///< [s]

/// w_ss [rad/s], >= 0. A torque that drives the bit on (T < 0) does not speed it up: the flow holds it.
/// @param flow          Q >= 0 [m3/s]
/// @param displacement  V > 0 [m3/rev]
/// @param stall_torque  T_stall > 0 [N m]
/// @param torque        T, + against the bit's turning [N m]
inline double mud_motor_steady_speed(double flow, double displacement, double stall_torque, double torque) noexcept
{
  return 2.0 * pi * flow / displacement * std::clamp(1.0 - torque / stall_torque, 0.0, 1.0);
}

/// Speed at the end of a step h [s] in which the torque is held: implicit Euler of the lag, (tau w + h w_ss) / (tau + h).
inline double advance_mud_motor(double speed, double steady_speed, double step) noexcept
{
  return (mud_motor_lag * speed + step * steady_speed) / (mud_motor_lag + step);
}

/// Differential pressure dp = 2 pi T/V [Pa]; zero without flow, and for a torque that drives the bit on.
inline double mud_motor_pressure(double flow, double displacement, double torque) noexcept
{
  return flow > 0.0 ? 2.0 * pi * std::max(0.0, torque) / displacement : 0.0;
}

/// The motor is pumped but its torque has reached T_stall.
inline bool mud_motor_stalled(double flow, double stall_torque, double torque) noexcept
{
  return flow > 0.0 && torque >= stall_torque;
}

}  // namespace drill_rig_sim

#endif
