// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_MODEL_LEVELS_H
#define DRILL_RIG_SIM_MODEL_LEVELS_H

#include <vector>

#include "drill_rig_sim/model/model.h"
#include "drill_rig_sim/model/rig_forces.h"
#include "drill_rig_sim/model/state.h"

namespace drill_rig_sim
{
/// Makes nodes free or guided (guides.h) between two steps, and keeps tension and wall forces of the string.
///
/// Tension: a guided string is as long as the axis of its hole, a free string as the line in which it lies on the wall. In a
/// bend, the strains differ by clearance times curvature, which would be hundreds of kN. So an element keeps its tension when it
/// changes; SpanState::free_stretch stores the difference of the lengths without tension. Over a whole well that is a few
/// centimetres of string: the angle built times the clearance.
///
/// Wall: a freed node is put where the wall gives the same force. Its bristle is kept; bristles between nodes start at zero.
/// The energy balance contains the energy of the change: of beams and contact as correction, of rates as of_rebasing and
/// added_mass.
/// @param guided   for each node whether it is to be guided, 1 or 0
/// @param forces   of the step before
/// @return whether anything changed
bool change_guided(const Model& model, const std::vector<unsigned char>& guided, const RigForces& forces, State& state) noexcept;

}  // namespace drill_rig_sim

#endif
