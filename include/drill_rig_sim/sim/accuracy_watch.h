// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SIM_ACCURACY_WATCH_H
#define DRILL_RIG_SIM_SIM_ACCURACY_WATCH_H

#include "drill_rig_sim/model/model.h"
#include "drill_rig_sim/model/rig_forces.h"
#include "drill_rig_sim/model/state.h"
#include "drill_rig_sim/sim/accuracy.h"

namespace drill_rig_sim
{
/// Loads of the string that elements or wall cannot represent. Returns the largest of the first kind that occurs.
/// - Confined: guided pipe carries more than 0.8 of its critical buckling load (string_watch.h).
/// - Compression: two cubic elements carry the half wave into which pipe in a hole buckles, pi sqrt(2 E I/P), so an element of
/// length L
///   carries (pi^2/2) E I/L^2. Above it the mesh decides how the pipe buckles.
/// - Twist: 1 rad an element; the corotational element is made for less.
/// - Embedding: the string is deeper in the wall than its clearance there and 2 mm: positions and side forces are those of a
/// wider hole.
AccuracyReport doubt_of_string(const Model& model, const State& state, const RigForces& forces) noexcept;

/// Turn where the bit is pressed aside so far that the body that follows it holds back the turn of the hole (well/turn_limit.h).
AccuracyReport doubt_of_turn(const Model& model, const State& state, const RigForces& forces) noexcept;

/// Slant where the hole leaves the rotary table by more than 10 deg from the vertical: the rig stands upright, and pulls the
/// string over a corner there. Without friction the hook load is 1 % low at 12 deg, 6 % at 20 deg.
AccuracyReport doubt_of_hole(const State& state) noexcept;

/// Where the scene needs an output that its level does not represent.
AccuracyReport doubt_of_level(const Scene& scene, const State& state) noexcept;

/// After a frame of `duration` [s]: looks at every tenth frame for all of these. A warning stays for 10 s after its cause.
void watch_model(const Model& model, const State& state, const RigForces& forces, double duration,
                 AccuracyMemory& memory) noexcept;

}  // namespace drill_rig_sim

#endif
