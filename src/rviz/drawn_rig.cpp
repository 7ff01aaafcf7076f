// SPDX-License-Identifier: BSD-3-Clause
#include "drawn_rig.h"

#include <cmath>

namespace drill_rig_sim
{
Eigen::Vector3d DrawnRig::bit_face() const
{
  const DrawnNode& bit = nodes.front();
  return bit.position + string->from_bit.front() * bit.axis.tangent;
}

bool DrawnRig::reach_bit()
{
  return axis && string && bit_md() > axis->depth() && axis->extend_to(std::ceil(100.0 * bit_md()) / 100.0);
}

std::string DrawnRig::prefix() const
{
  const std::string own = "rig_floor";
  const bool ends = floor.size() >= own.size() && floor.compare(floor.size() - own.size(), own.size(), own) == 0;
  return ends ? floor.substr(0, floor.size() - own.size()) : std::string();
}

}  // namespace drill_rig_sim
