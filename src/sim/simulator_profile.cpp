// What the simulator shows of the string: quantities along it, and the places of its parts.
#include <algorithm>
#include <cmath>

#include "drill_rig_sim/math/rotation.h"
#include "drill_rig_sim/sim/profile.h"
#include "simulator_impl.h"

namespace drill_rig_sim
{
using Eigen::Quaterniond;
using Eigen::Vector3d;

Between find_between(const Mesh& mesh, double from_bit) noexcept
{
  const auto& nodes = mesh.nodes;
  const auto above = std::upper_bound(nodes.begin(), nodes.end(), from_bit, [](double s, const MeshNode& n) { return s < n.from_bit; });
  const int upper = std::clamp(static_cast<int>(above - nodes.begin()), 1, static_cast<int>(nodes.size()) - 1);
  const double low = nodes[upper - 1].from_bit, high = nodes[upper].from_bit;
  return {upper - 1, (from_bit - low) / (high - low)};
}

void Simulator::profile(StringProfile& out) const
{
  fill_profile(*impl_->model, impl_->shown(), impl_->shown_forces(), out);
}

void Simulator::part_poses(int every, std::vector<PartPose>& out) const
{
  const Mesh& mesh = impl_->model->mesh();
  const std::vector<NodeState>& nodes = impl_->shown().nodes;
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
  for (std::size_t p = 0; p < impl_->scene.string.size(); ++p)
    if (impl_->scene.string[p].type != PartType::pipe) add(mesh.part_bottom[p]).name = impl_->scene.string[p].name;
  out.front().orientation = impl_->state.truth.bit_orientation;
  int joint = 0;
  double lower = mesh.part_top.front();  // of the joint that comes next
  for (std::size_t i = 1; i < mesh.nodes.size(); ++i)
  {
    if (!mesh.nodes[i].joint_end) continue;
    const bool pipe = impl_->scene.string[mesh.nodes[i].part].type == PartType::pipe;
    if (pipe && joint++ % std::max(every, 1) == 0) add(lower).name = "pipe_" + std::to_string(joint - 1);
    lower = mesh.nodes[i].from_bit;
  }
  out.resize(used);
}

}  // namespace drill_rig_sim
