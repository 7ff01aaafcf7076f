// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_MODEL_FORCES_WALL_H
#define DRILL_RIG_SIM_MODEL_FORCES_WALL_H

#include "drill_rig_sim/model/forces/force.h"

namespace drill_rig_sim
{
/// Wall of the hole, and of the mast above the rotary table, on the nodes, with sticking friction (contact/wall_contact.h); not
/// on the last node, the top drive's shaft. The bit's gauge turns with the motor. In statics at full slip, as Stage::sliding
/// says.
extern const Force wall;

/// Node 0 only.
void add_wall_at_bit(const StageContext& at, const ForceRows& to) noexcept;

}  // namespace drill_rig_sim

#endif
