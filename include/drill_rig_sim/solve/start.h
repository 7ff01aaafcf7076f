// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SOLVE_START_H
#define DRILL_RIG_SIM_SOLVE_START_H

#include <memory>

#include "drill_rig_sim/solve/statics.h"

namespace drill_rig_sim
{
/// A rig at rest, ready to run.
struct RigAtRest
{
  std::shared_ptr<const Model> model;
  State state;
  StaticOutcome statics;
};

/// Builds well, string and rig as `scene.start` says, in frictionless static equilibrium with the winch braked: the string's
/// unstretched length is found such that bit depth (or, on bottom, weight on bit), block height and the bend's toolface are those
/// of the scene. Throws std::runtime_error with one line (what, where, what is allowed) if there is no such rig.
RigAtRest build_at_rest(const Scene& scene);

/// Shortening of the unstretched string per axial force between its ends [m/N].
double string_compliance(const Mesh& mesh);

/// Measured depth of the bit's face in a state [m].
double bit_depth(const Model& model, const State& state);

/// Toolface of the bend [rad], -pi .. pi, from the high side (north where the hole is nearly vertical); 0 for a straight string.
double bend_toolface(const Model& model, const State& state);

}  // namespace drill_rig_sim

#endif
