// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_MODEL_RUNNING_SPEED_H
#define DRILL_RIG_SIM_MODEL_RUNNING_SPEED_H

#include <vector>

#include "drill_rig_sim/hydraulics/mud_circuit.h"
#include "drill_rig_sim/model/state.h"

namespace drill_rig_sim
{
/// Mean speed of the string along its annulus, + into the hole [m/s]; 0 without one.
double running_speed(const MudCircuit& mud, const std::vector<NodeState>& nodes) noexcept;

}  // namespace drill_rig_sim

#endif
