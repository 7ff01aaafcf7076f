#ifndef DRILL_RIG_SIM_MODEL_FORCES_FREE_STRING_H
#define DRILL_RIG_SIM_MODEL_FORCES_FREE_STRING_H

#include "drill_rig_sim/model/forces/force.h"

namespace drill_rig_sim
{
/// The forces `beams`, `mud_drag` and `inertia` in one, several elements at a time: by the workspace's batch kernel, which must be there, at
/// its columns. Energy and its samples are left to those three.
extern const Force free_string;

/// The part of find_string_forces() that is the free elements'.
void find_free_forces(const StageContext& at) noexcept;

}  // namespace drill_rig_sim

#endif
