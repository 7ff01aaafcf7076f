// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SIM_PROFILE_H
#define DRILL_RIG_SIM_SIM_PROFILE_H

#include <optional>

#include "drill_rig_sim/rig/hoisting.h"
#include "drill_rig_sim/sim/accuracy.h"
#include "drill_rig_sim/sim/assembly_fit.h"
#include "drill_rig_sim/sim/string_profile.h"
#include "drill_rig_sim/sim/string_watch.h"
#include "drill_rig_sim/solve/statics.h"

namespace drill_rig_sim
{
/// Quantities along the string of a state and its forces, bit first. Fills the arrays in place; they allocate on first use only.
void fill_profile(const Model& model, const State& state, const RigForces& forces, StringProfile& out);

/// Torque and drag at rest, or in quasi-static motion with full slip.
struct StaticReport
{
  StaticOutcome outcome;
  StringLoads loads;  ///< loads of the string
  BuckledPipe buckled;
  AccuracyReport accuracy;             ///< what of it the elements do not stand for
  std::optional<TightAssembly> tight;  ///< whose side force drags on the wall too
  double refined_length = 0.0;  ///< of the elements that were taken for the scene's, where these are too long for compressed
                                ///< pipe; 0: these are not [m]
  StringProfile profile;
  double hook_load = 0.0;           ///< block and top drive included [N]
  double hook_load_string = 0.0;    ///< [N]
  SteadyHookLoad gauges;            ///< what they show while the block moves as the string does
  double hook_load_gauge = 0.0;     ///< of them the one that the scene has, without its errors [N]
  double torque = 0.0;              ///< at the top [N m]
  double bit_side_force = 0.0;      ///< wall on bit, normal [N]
  double bit_side_direction = 0.0;  ///< where the bit pushes the wall, clockwise from the high side looking downhole [rad]
  double bit_tilt = 0.0;            ///< between the bit's axis and the hole's [rad]
  double annulus_pressure = 0.0;    ///< at the bit, above that of the mud at rest: surge and swab, and the pump's [Pa]
};

/// How the mud moves while the string slides, in steady flow.
struct MovingMud
{
  bool by_string = false;  ///< the speeds of the sliding are those of the string: the mud has its drag on it, and surge or swab
  double flow = 0.0;       ///< of the pump [m3/s]

  bool moves() const noexcept { return by_string || flow > 0.0; }
};

/// The scene's string at its start, then moved as `sliding` says, at rest without friction. Elements that are too long for the
/// compression that they carry, or with which no equilibrium is found, are halved where friction pushes pipe, down to an eighth
/// of a joint. Throws std::runtime_error with one line if there is no such equilibrium; it says where the pipe buckles, and
/// whether it must be pushed in, if it does.
/// @param mud  at rest unless it is given
StaticReport static_report(const Scene& scene, const SlidingMotion& sliding, const MovingMud& mud = {});

}  // namespace drill_rig_sim

#endif
