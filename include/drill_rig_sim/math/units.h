// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_MATH_UNITS_H
#define DRILL_RIG_SIM_MATH_UNITS_H

namespace drill_rig_sim
{
constexpr double pi = 3.14159265358979323846;
constexpr double degree = pi / 180.0;         ///< one degree [rad]
constexpr double rpm = 2.0 * pi / 60.0;       ///< one revolution per minute [rad/s]
constexpr double standard_gravity = 9.80665;  ///< [m/s2]
constexpr double time_rounding = 1e-9;  ///< what a sum of many steps may miss a time by: 60 s is reached at 59.999999999 [s]
}  // namespace drill_rig_sim

#endif
