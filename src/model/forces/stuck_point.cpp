// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/model/forces/stuck_point.h"

#include "held_node.h"

namespace drill_rig_sim
{
namespace
{
constexpr Grip stuck_grip{stuck_point_stiffness, stuck_point_torsion, false, false};

void add_stuck_point(const StageContext& at, const ForceRows& to) noexcept
{
  add_held(at, at.start.stuck_point, stuck_grip, to);
}

void store_stuck_point(const StageContext& at, StoredEnergy& energy) noexcept
{
  store_held(at, at.start.stuck_point, stuck_grip, energy);
}

void sample_stuck_point(const StageContext& at, EnergySample& sample) noexcept
{
  sample_held(at, at.start.stuck_point, stuck_grip, sample);
}
}  // namespace

const Force stuck_point = {"stuck point",   Cost::rig, Sum::contact,      add_stuck_point,
                           add_stuck_point, nullptr,   store_stuck_point, sample_stuck_point};

}  // namespace drill_rig_sim
