// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_MODEL_FORCES_INERTIA_H
#define DRILL_RIG_SIM_MODEL_FORCES_INERTIA_H

#include "drill_rig_sim/model/forces/force.h"
#include "drill_rig_sim/rig/rigid_body.h"

namespace drill_rig_sim
{
/// Inertia of the nodes as rigid sections (rig/rigid_body.h), the mud that moves sideways with them below the rotary table, and
/// the block on the top node. Rates are split by the section normal at the start of the step, in axes that tilt but do not spin.
extern const Force inertia;

/// A node as a body, with the share of its added mass that is in the mud.
RigidBody node_body(const Model& model, const Stage& stage, int i) noexcept;

/// Accelerations that balance the residual of an evaluation without accelerations, into work.nodes: explicit methods. What the
/// guide rail holds stays.
void accelerate(const Model& model, const Stage& stage, const double* residual, Workspace& work) noexcept;

/// y = M x with the mass matrix of accelerate(), 6 per node each, in the coordinates of u; 0 in the rows that the guide rail
/// holds.
void multiply_mass(const Model& model, const Stage& stage, const double* x, double* y) noexcept;

}  // namespace drill_rig_sim

#endif
