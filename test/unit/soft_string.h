// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_TEST_SOFT_STRING_H
#define DRILL_RIG_SIM_TEST_SOFT_STRING_H

#include <algorithm>
#include <cmath>
#include <functional>

#include "test_scenes.h"

/// Torque and drag of a soft string (no bending stiffness, no clearance) in a hole that lies in one vertical plane, integrated
/// from the bit up. Independent of the simulator: knows the scene's numbers only.
///
/// With s down the hole, w the weight in mud per length, I the inclination and k = dI/ds the build rate:
///   side force per length   S = w sin I - T k      (a build's tension lifts the string off the low side)
///   up, down:  N = |S|,  dT/ds = -(w cos I +- mu N)
///   rotating:  friction mu N acts across the hole, so the string climbs until N and mu N balance S: N = |S|/sqrt(1 + mu^2);
///              dT/ds = -w cos I,  torque dM/ds = -mu N r with r the radius of the tool joints.
/// The textbooks' soft string takes N = |S| when rotating too: 1 - 1/sqrt(1 + mu^2) more torque, 3 % at mu 0.25.
namespace drill_rig_sim
{
struct PlanarWell
{
  std::function<double(double)> inclination;  ///< of measured depth [rad]
  std::function<double(double)> build_rate;   ///< [rad/m]
  std::function<double(double)> friction;     ///< [-]
};

enum class Sliding
{
  none,
  up,
  down,
  rotate
};

struct SoftStringResult
{
  double hook_load;  ///< of the string [N]
  double torque;     ///< [N m]
};

/// Bit and the parts above it from `bit_depth` up to the surface, `in_air` metres of the last of them above it. Pipe touches with
/// its tool joints. `climbs`: the rotating balance above; false: the textbooks' N = |S|.
inline SoftStringResult soft_string(const Scene& scene, const PlanarWell& well, double bit_depth, double in_air, Sliding sliding,
                                    bool climbs = true)
{
  double tension = 0.0, torque = 0.0;
  // adds a piece of weight `weight` with its contact radius
  auto add = [&](double md, double weight, double length, double radius)
  {
    const double mu = well.friction(md);
    const double side = std::abs(weight * std::sin(well.inclination(md)) - tension * well.build_rate(md) * length);
    tension += weight * std::cos(well.inclination(md));
    if (sliding == Sliding::up) tension += mu * side;
    if (sliding == Sliding::down) tension -= mu * side;
    if (sliding == Sliding::rotate) torque += mu * side / (climbs ? std::sqrt(1.0 + mu * mu) : 1.0) * radius;
  };
  const PartSpec& bit = scene.string[0];
  add(bit_depth, standard_gravity * bit.bit->mass * (1.0 - scene.mud.density / bit.density), 0.0, 0.5 * bit.bit->diameter);
  double left = bit_depth - bit.length;  // to the surface
  for (std::size_t p = 1; p < scene.string.size(); ++p)
  {
    const PartSpec& part = scene.string[p];
    const double length = part.joints > 0 ? part.joints * part.joint_length : left;
    const int pieces = static_cast<int>(std::ceil(length / 0.25));
    const double piece = length / pieces;
    const double weight = standard_gravity * part.linear_mass * (1.0 - scene.mud.density / part.density) * piece;
    const double radius = 0.5 * std::max(part.outer_diameter, part.pipe ? part.pipe->tool_joint_diameter : 0.0);
    for (int i = 0; i < pieces; ++i) add(left - (i + 0.5) * piece, weight, piece, radius);
    left -= length;
  }
  tension += standard_gravity * scene.string.back().linear_mass * in_air;
  return {tension, torque};
}

}  // namespace drill_rig_sim

#endif
