// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_CONTACT_FILTER_CAKE_H
#define DRILL_RIG_SIM_CONTACT_FILTER_CAKE_H

#include <cmath>

/// Differential sticking: pipe that rests on the filter cake of permeable rock seals a strip of it off from the mud, and the
/// mud's overpressure pushes it on the rock over that strip.
///
/// Width: pipe of radius r that touches a hole of radius R leaves a gap g = (R - r)(1 - cos a) at the angle a from the line of
/// contact. Cake of thickness h fills it where g < h, so the strip is w = 2 r acos(1 - h/(R - r)) wide, at most half the pipe's
/// circumference. Time: what is left of the mud's pressure in the cake under the pipe bleeds off into the rock, and the pipe is
/// held by so much more: F(t) = F(oo) (1 - e^(-t/tau)), the first and slowest mode of a layer that consolidates. Source: Outmans,
/// Mechanics of differential pressure sticking of drill collars, Trans. AIME 213 (1958), 265-274, has the mechanism, and a force
/// that grows with the rest towards its most over minutes to hours; h and tau are an ordinary mud's, assumptions. Left out: cake
/// that grows or gives way under the pipe, which both widen the strip.
namespace drill_rig_sim
{
constexpr double cake_thickness = 1.6e-3;     ///< h: two 32nds of an inch, as the test of API RP 13B-1 leaves in half an hour [m]
constexpr double cake_bleeding_time = 600.0;  ///< tau [s]

/// w [m]. @param room  R - r [m]
inline double sealed_width(double radius, double room) noexcept
{
  return 2.0 * radius * (room > cake_thickness ? std::acos(1.0 - cake_thickness / room) : std::acos(0.0));
}

/// Share of the overpressure that acts after a rest of t >= 0 [s].
inline double sealed_share(double rest) noexcept
{
  return -std::expm1(-rest / cake_bleeding_time);
}

}  // namespace drill_rig_sim

#endif
