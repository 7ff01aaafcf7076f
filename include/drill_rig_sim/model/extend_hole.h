// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_MODEL_EXTEND_HOLE_H
#define DRILL_RIG_SIM_MODEL_EXTEND_HOLE_H

#include "drill_rig_sim/model/stage.h"
#include "drill_rig_sim/model/workspace.h"

namespace drill_rig_sim
{
/// Extends the hole at the end of a step, after the nodes are committed. The bottom moves by the rock-breaking velocity at the
/// stage's forces times the step, or by the motion stored in the stage, or (regenerative law) by the average height that the
/// blades have cut in the step.
void extend_hole(const Model& model, const Stage& stage, const StageResult& result, State& state) noexcept;

/// Curvature of the hole by the rock law, if it exceeds the limit of the body behind the bit (well/turn_limit.h) [rad/m];
/// otherwise 0. `forces`: at the state.
double refused_turn(const Model& model, const State& state, const RigForces& forces) noexcept;

}  // namespace drill_rig_sim

#endif
