#ifndef DRILL_RIG_SIM_MODEL_INTERPOLATE_H
#define DRILL_RIG_SIM_MODEL_INTERPOLATE_H

#include "drill_rig_sim/model/rig_forces.h"
#include "drill_rig_sim/model/state.h"

namespace drill_rig_sim
{
/// What shows between the two ends of one step, at `share` (0 .. 1) of it, into `out`, which holds a copy of `end` whose other fields stay:
/// motions of the nodes, drive, hoisting, motor, hydraulics and time, in straight lines (orientations along the arc). Right to second order, as the method
/// is: a wave of frequency w is off by (w h)^2/8 between the ends of a step h. For showing alone: hole, bristles and memory are the end's.
void interpolate(const State& start, const State& end, double share, State& out) noexcept;
/// The same of the forces; vectors of equal lengths.
void interpolate(const RigForces& start, const RigForces& end, double share, RigForces& out) noexcept;

}  // namespace drill_rig_sim

#endif
