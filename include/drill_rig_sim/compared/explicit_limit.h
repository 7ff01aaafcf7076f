// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_COMPARED_EXPLICIT_LIMIT_H
#define DRILL_RIG_SIM_COMPARED_EXPLICIT_LIMIT_H

#include "drill_rig_sim/model/model.h"
#include "drill_rig_sim/model/state.h"

namespace drill_rig_sim
{
/// Longest stable step of central differences at a state (CFL) [s]: h = (2/w) (sqrt(1 + z^2) - z), w the highest natural
/// frequency by power iteration on M^-1 K, every node pressed a millimetre into wall or bottom; z = w t_d/2 the damping ratio
/// that structural damping gives that mode, its force taken half a step late (Belytschko, Liu and Moran, Nonlinear finite
/// elements, 6.2). Allocates.
double explicit_step_limit(const Model& model, const State& state);

/// Throws std::runtime_error with one line if the scene's step is longer than that.
void check_explicit_step(const Model& model, const State& state);

}  // namespace drill_rig_sim

#endif
