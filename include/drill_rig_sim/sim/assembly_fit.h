// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SIM_ASSEMBLY_FIT_H
#define DRILL_RIG_SIM_SIM_ASSEMBLY_FIT_H

#include <optional>
#include <string>

namespace drill_rig_sim
{
class Model;
struct RigForces;

/// A bent motor that its hole bends straight: bit, sleeve, bend and the motor's upper end lean on opposite sides of the hole.
struct TightAssembly
{
  double side_force = 0.0;  ///< with which that presses the bit aside [N]
  double weight = 0.0;      ///< of bit and motor, in mud [N]
  double turn = 0.0;        ///< most that the motor below its bend lets the hole turn (string/lower_body.h) [rad/m]
};

/// More than this times the weight of bit and motor presses a bit aside that does not fit: about 27 kN of a motor of 6 3/4 in.
/// Bends without a sleeve (0.5 to 2 deg) stay below it, gravity makes a half.
constexpr double most_of_weight = 3.0;

/// By the forces of a scene's start, at rest without friction; none without a bend, or where the bit's side force is no more than
/// `most_of_weight` of the weight.
std::optional<TightAssembly> tight_assembly(const Model& model, const RigForces& at_rest) noexcept;

/// In a line that names the remedy. Allocates.
std::string text_of(const TightAssembly& assembly);

}  // namespace drill_rig_sim

#endif
