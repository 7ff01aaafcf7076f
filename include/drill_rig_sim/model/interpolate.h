// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_MODEL_INTERPOLATE_H
#define DRILL_RIG_SIM_MODEL_INTERPOLATE_H

#include "drill_rig_sim/model/rig_forces.h"
#include "drill_rig_sim/model/state.h"

namespace drill_rig_sim
{
/// State at `share` (0 .. 1) of a step. `out` must be a copy of `end`; motions of the nodes, drive, hoisting, motor, hydraulics
/// and time are replaced. Interpolation is linear (orientations along the arc), so of second order, as the method is: a wave of
/// frequency w has the error (w h)^2/8 inside a step h. Only for display: hole, bristles and memory are those of the end.
void interpolate(const State& start, const State& end, double share, State& out) noexcept;
/// The parts of it: nodes `first` up to but not including `last`, and all else.
void interpolate_nodes(const State& start, const State& end, double share, std::size_t first, std::size_t last,
                       State& out) noexcept;
void interpolate_rig(const State& start, const State& end, double share, State& out) noexcept;
/// The same of the forces; vectors of equal lengths.
void interpolate(const RigForces& start, const RigForces& end, double share, RigForces& out) noexcept;
/// The parts of it: the loads along the string, and those at bit and rig.
void interpolate_loads(const RigForces& start, const RigForces& end, double share, RigForces& out) noexcept;
void interpolate_rig(const RigForces& start, const RigForces& end, double share, RigForces& out) noexcept;

}  // namespace drill_rig_sim

#endif
