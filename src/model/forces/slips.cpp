// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/model/forces/slips.h"

#include <algorithm>

#include "held_node.h"

namespace drill_rig_sim
{
namespace
{
constexpr Grip slips_grip{slips_stiffness, slips_torsion, true, true};

void add_slips(const StageContext& at, const ForceRows& to) noexcept
{
  add_held(at, at.start.slips, slips_grip, to);
}

void store_slips(const StageContext& at, StoredEnergy& energy) noexcept
{
  store_held(at, at.start.slips, slips_grip, energy);
}

void sample_slips(const StageContext& at, EnergySample& sample) noexcept
{
  sample_held(at, at.start.slips, slips_grip, sample);
  sample.slips_force = at.start.slips.node < 0 ? 0.0 : -force_of(at, at.start.slips, slips_grip)[2];
}
}  // namespace

const Force slips = {"slips", Cost::rig, Sum::none, add_slips, nullptr, nullptr, store_slips, sample_slips};

double slips_load(const State& state) noexcept
{
  if (state.slips.node < 0) return 0.0;
  const double pipe = state.nodes[static_cast<std::size_t>(state.slips.node)].position.z();
  return slips_stiffness * std::max(0.0, state.slips.position.z() + state.hoist.floor.height - pipe);
}

}  // namespace drill_rig_sim
