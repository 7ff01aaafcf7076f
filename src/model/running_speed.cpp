// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/model/running_speed.h"

namespace drill_rig_sim
{
double running_speed(const MudCircuit& mud, const std::vector<NodeState>& nodes) noexcept
{
  double sum = 0.0, weight = 0.0;
  for (std::size_t e = 0; e < mud.lift.size(); ++e)
  {
    if (mud.lift[e] <= 0.0) continue;
    const Eigen::Vector3d up = (nodes[e + 1].position - nodes[e].position).normalized();
    sum -= 0.5 * mud.lift[e] * up.dot(nodes[e].rate.velocity + nodes[e + 1].rate.velocity);
    weight += mud.lift[e];
  }
  return weight > 0.0 ? sum / weight : 0.0;
}

}  // namespace drill_rig_sim
