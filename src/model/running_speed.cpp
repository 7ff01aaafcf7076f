// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/model/running_speed.h"

namespace drill_rig_sim
{
double running_speed(const MudCircuit& mud, const std::vector<NodeState>& nodes) noexcept
{
  if (nodes.empty()) return 0.0;
  double sum = 0.0;
  Eigen::Vector3d place = nodes[0].position, velocity = nodes[0].rate.velocity;
  for (std::size_t e = 0; e < mud.speed_weight.size(); ++e)
  {
    const Eigen::Vector3d next_place = nodes[e + 1].position, next_velocity = nodes[e + 1].rate.velocity;
    sum -= mud.speed_weight[e] * (next_place - place).dot(velocity + next_velocity);
    place = next_place;
    velocity = next_velocity;
  }
  return sum;
}

}  // namespace drill_rig_sim
