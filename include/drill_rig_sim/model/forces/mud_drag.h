// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_MODEL_FORCES_MUD_DRAG_H
#define DRILL_RIG_SIM_MODEL_FORCES_MUD_DRAG_H

#include "drill_rig_sim/model/forces/force.h"

namespace drill_rig_sim
{
/// Drag of the mud on the nodes below the rotary table. Linear in the rates, by the mud's viscosity or its `..._damping` keys
/// (mud_damping.h). Across the string also 1/2 rho C_d D L |v| v (Morison's drag), C_d `mud.drag_coefficient`, D the outer
/// diameter.
extern const Force mud_drag;

/// What it is on node i of a string that moves as the stage's `sliding` says, whatever rates the stage's nodes have: force and
/// moment [N, N m].
/// @param down  the string's direction, towards the bit
Eigen::Matrix<double, 6, 1> mud_drag_of_sliding(const Model& model, const Stage& stage, int i,
                                                const Eigen::Vector3d& down) noexcept;

}  // namespace drill_rig_sim

#endif
