// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/crew/crew.h"

#include <algorithm>

#include "drill_rig_sim/rig/hoisting.h"

namespace drill_rig_sim
{
const char* text_of(CrewTask task) noexcept
{
  static constexpr const char* words[] = {"",           "stopping",   "lifting",    "quieting", "slacking",
                                          "connecting", "picking_up", "restarting", "lowering"};
  return words[static_cast<std::size_t>(task)];
}

double height_to_add(const HoistingSpec& spec, double stump, double stand) noexcept
{
  return std::max(spec.lowest_block_height, std::min(stump, spec.highest_block_height - room_for_stand(stand)));
}

}  // namespace drill_rig_sim
