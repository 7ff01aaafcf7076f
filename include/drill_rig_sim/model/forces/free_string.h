// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_MODEL_FORCES_FREE_STRING_H
#define DRILL_RIG_SIM_MODEL_FORCES_FREE_STRING_H

#include "drill_rig_sim/model/forces/force.h"

namespace drill_rig_sim
{
/// The forces `beams`, `mud_drag` and `inertia` of all free nodes in one, several elements at a time: by the workspace's batch
/// kernel, at its columns; only moved_in_batches().
void add_free_string(const StageContext& at, const ForceRows& to) noexcept;
/// The part of find_string_forces() that is the free elements'.
void find_free_forces(const StageContext& at) noexcept;
/// The parts of `beams`.
void store_free_string(const StageContext& at, StoredEnergy& energy) noexcept;
void sample_free_string(const StageContext& at, EnergySample& sample) noexcept;
/// Whether these can be had: the kernel is there and has moved the nodes last.
inline bool moved_in_batches(const StageContext& at) noexcept
{
  return at.work.string && at.work.columns.moved;
}

}  // namespace drill_rig_sim

#endif
