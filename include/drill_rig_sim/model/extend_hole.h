#ifndef DRILL_RIG_SIM_MODEL_EXTEND_HOLE_H
#define DRILL_RIG_SIM_MODEL_EXTEND_HOLE_H

#include "drill_rig_sim/model/stage.h"
#include "drill_rig_sim/model/workspace.h"

namespace drill_rig_sim
{
/// The hole at the end of a step whose nodes are committed: its bottom moves by the rock-breaking velocity at the stage's forces times the
/// step, or by what the stage knows of it, or (regenerative law) by the mean height of what the blades have cut in the step.
void extend_hole(const Model& model, const Stage& stage, const StageResult& result, State& state) noexcept;

/// How fast the hole would turn by the rock law alone where the body that follows the bit does not let it (well/turn_limit.h) [rad/m]; 0 elsewhere.
/// `forces`: at the state.
double refused_turn(const Model& model, const State& state, const RigForces& forces) noexcept;

}  // namespace drill_rig_sim

#endif
