// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_MODEL_FORCES_SQUEEZE_FILM_H
#define DRILL_RIG_SIM_MODEL_FORCES_SQUEEZE_FILM_H

#include "drill_rig_sim/model/forces/force.h"

namespace drill_rig_sim
{
/// Mud squeezed between gauge or blades and the wall damps their motion across the hole. It acts across the hole, not across the
/// part, so that a tilted bit does not glide up on it. Linear: F = -c v, c = `squeeze_film_damping` of the part [N s/m]; only
/// below the rotary table.
extern const Force squeeze_film;

/// The same, only for node 0 (the bit).
void add_film_at_bit(const StageContext& at, const ForceRows& to) noexcept;

}  // namespace drill_rig_sim

#endif
