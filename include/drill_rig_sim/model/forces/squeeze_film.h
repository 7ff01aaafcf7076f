#ifndef DRILL_RIG_SIM_MODEL_FORCES_SQUEEZE_FILM_H
#define DRILL_RIG_SIM_MODEL_FORCES_SQUEEZE_FILM_H

#include "drill_rig_sim/model/forces/force.h"

namespace drill_rig_sim
{
/// Mud squeezed between gauge or blades and the wall damps their motion across the hole; across the hole, not across the part: a tilted
/// bit that slides does not glide up on it. Linear, `squeeze_film_damping` [N s/m] of a part, below the rotary table.
extern const Force squeeze_film;

/// Node 0 alone.
void add_film_at_bit(const StageContext& at, const ForceRows& to) noexcept;

}  // namespace drill_rig_sim

#endif
