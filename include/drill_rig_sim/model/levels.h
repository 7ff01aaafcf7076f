#ifndef DRILL_RIG_SIM_MODEL_LEVELS_H
#define DRILL_RIG_SIM_MODEL_LEVELS_H

#include <vector>

#include "drill_rig_sim/model/model.h"
#include "drill_rig_sim/model/rig_forces.h"
#include "drill_rig_sim/model/state.h"

namespace drill_rig_sim
{
/// Makes nodes free or guided (guides.h) between two steps, so that what the string carries goes on as it was.
///
/// Tension: a guided string is as long as the axis of its hole, a free one as the line in which it lies on the wall; in a bend the two differ by
/// clearance times curvature, a strain that would be hundreds of kN. So each element whose kind changes keeps its tension, and what its length
/// without tension differs by since then is kept in SpanState::free_stretch. Over a whole well that is a few centimetres of string, the angle built
/// times the clearance.
/// Wall: a node that becomes free stands where the wall gives the force that it had. Bristles are carried along; those between the nodes start anew.
/// Energy that the change makes or takes is in the balance: of beams and contact as correction, of rates as of_rebasing and added_mass.
/// @param guided   for each node whether it is to be guided, 1 or 0
/// @param forces   of the step before
/// @return whether anything changed
bool change_guided(const Model& model, const std::vector<unsigned char>& guided, const RigForces& forces, State& state) noexcept;

}  // namespace drill_rig_sim

#endif
