// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_MODEL_FORCES_HOISTING_H
#define DRILL_RIG_SIM_MODEL_FORCES_HOISTING_H

#include "drill_rig_sim/model/forces/force.h"

namespace drill_rig_sim
{
/// Drill line, rail, stops and weight of the travelling block on the top node (rig/hoisting.h).
extern const Force hoisting;

/// Line and winch `time` [s] after a state, the winch's set point held, and the floor on which they stand.
HoistState advance_hoist(const Model& model, const State& state, const Setpoints& setpoints, double time) noexcept;

}  // namespace drill_rig_sim

#endif
