// SPDX-License-Identifier: BSD-3-Clause
// What the simulator shows of the string: quantities along it, and the places of its parts.
#include <algorithm>
#include <cmath>

#include "between.h"
#include "drill_rig_sim/sim/profile.h"
#include "simulator_impl.h"

namespace drill_rig_sim
{
using Eigen::Quaterniond;
using Eigen::Vector3d;

void Simulator::profile(StringProfile& out) const
{
  const Motion& motion = impl_->rig.motion;
  fill_profile(*motion.model(), motion.shown(), motion.shown_forces(), out);
}

void Simulator::part_poses(int every, std::vector<PartPose>& out) const
{
  const SimulatedRig& rig = impl_->rig;
  const std::vector<PartSpec>& parts = rig.scene.string;
  const Mesh& mesh = rig.motion.model()->mesh();
  const std::vector<NodeState>& nodes = rig.motion.shown().nodes;
  std::size_t used = 0;
  auto add = [&](double from_bit) -> PartPose&
  {
    if (used == out.size()) out.emplace_back();
    PartPose& pose = out[used++];
    const Between at = find_between(mesh, from_bit);
    const NodeState& low = nodes[at.lower];
    const NodeState& high = nodes[at.lower + 1];
    pose.position = low.position + at.share * (high.position - low.position);
    pose.orientation = low.orientation.slerp(std::clamp(at.share, 0.0, 1.0), high.orientation).normalized();
    return pose;
  };
  for (std::size_t p = 0; p < parts.size(); ++p)
    if (parts[p].type != PartType::pipe) add(mesh.part_bottom[p]).name = parts[p].name;
  out.front().orientation = rig.state.truth.bit_orientation;
  int joint = 0;
  double lower = mesh.part_top.front();  // of the joint that comes next
  for (std::size_t i = 1; i < mesh.nodes.size(); ++i)
  {
    if (!mesh.nodes[i].joint_end) continue;
    const bool pipe = parts[mesh.nodes[i].part].type == PartType::pipe;
    if (pipe && joint++ % std::max(every, 1) == 0) add(lower).name = "pipe_" + std::to_string(joint - 1);
    lower = mesh.nodes[i].from_bit;
  }
  out.resize(used);
}

}  // namespace drill_rig_sim
