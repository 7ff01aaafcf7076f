// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_SOLVE_PLACED_STRING_H
#define DRILL_RIG_SIM_SRC_SOLVE_PLACED_STRING_H

#include <vector>

#include "drill_rig_sim/model/model.h"
#include "drill_rig_sim/model/state.h"

namespace drill_rig_sim
{
/// A string to begin with.
struct Guess
{
  double length = 0.0;    ///< unstretched [m]
  double toolface = 0.0;  ///< of the bend [rad]
  double twist = 0.0;     ///< of the top beyond the bend, clockwise [rad]
  bool held = false;      ///< the bend, at its toolface
};

/// The node whose toolface is the string's: of the bend; without one the lowest.
std::size_t toolface_node(const Mesh& mesh) noexcept;

/// From the bend up to each node, per torque [rad/(N m)]; 0 below.
std::vector<double> torsional_compliances(const Mesh& mesh);

/// How far each node moves away from the bit as the string stretches under its own weight in mud, bit
/// first [m]. A guess: no drag, no bending, no weight on bit.
std::vector<double> estimated_stretch(const Mesh& mesh, const Scene& scene, const Wellbore& well, double depth);

/// What the string pulls along its hole, without friction [N].
double string_pull(const Scene& scene, const Mesh& mesh, const Wellbore& well, double depth);

/// Puts the string into the hole down to `depth`, its top on the block, stretched as estimated_stretch() says.
void place_string(const Mesh& mesh, const Scene& scene, const Wellbore& well, double depth, const Guess& guess, State& state);

/// Turns a string at rest from the toolface and the twist of one guess to those of another one, where it is.
void turn_string(const Mesh& mesh, const Guess& from, const Guess& to, State& state);

}  // namespace drill_rig_sim

#endif
