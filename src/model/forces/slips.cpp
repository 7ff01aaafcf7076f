#include "drill_rig_sim/model/forces/slips.h"

#include <algorithm>

namespace drill_rig_sim
{
namespace
{
/// How far the node is from where it is held: what of its displacement the slips resist, and its turn about the string's axis.
struct Offset
{
  Eigen::Vector3d place;  // [m]
  double turn;            // [rad]
};

Offset offset_of(const StageContext& at) noexcept
{
  const HeldNode& held = at.start.slips;
  const NodeMotion& node = at.work.nodes[held.node];
  Eigen::Vector3d place = node.position - held.position;
  place.z() = std::min(0.0, place.z());
  return {place, at.start.nodes[held.node].spin_angle + node.spin - held.spin_angle};
}

Vector6d force_of(const StageContext& at) noexcept
{
  const Offset offset = offset_of(at);
  Vector6d out;
  out.head<3>() = slips_stiffness * offset.place;
  out.tail<3>() = slips_torsion * offset.turn * at.work.nodes[at.start.slips.node].axis;
  return out;
}

void add(const StageContext& at, double* residual, BlockTridiagonal* tangent) noexcept
{
  const int i = at.start.slips.node;
  if (i < 0) return;
  at_node(residual, i) += force_of(at);
  if (!tangent) return;
  const Eigen::Vector3d& n = at.work.nodes[i].axis;
  auto d = tangent->diagonal(i);
  d(0, 0) += slips_stiffness;
  d(1, 1) += slips_stiffness;
  if (offset_of(at).place.z() < 0.0) d(2, 2) += slips_stiffness;
  d.bottomRightCorner<3, 3>() += slips_torsion * n * n.transpose();
}

void store(const StageContext& at, StoredEnergy& energy) noexcept
{
  if (at.start.slips.node < 0) return;
  const Offset offset = offset_of(at);
  energy.stuck_point += 0.5 * (slips_stiffness * offset.place.squaredNorm() + slips_torsion * offset.turn * offset.turn);
}

void sample(const StageContext& at, EnergySample& sample) noexcept
{
  if (at.start.slips.node >= 0) at_node(sample, NodeForce::stuck_point, at.start.slips.node) += force_of(at);
}
}  // namespace

const Force slips = {"slips", Cost::rig, add, store, sample};

double slips_load(const State& state) noexcept
{
  if (state.slips.node < 0) return 0.0;
  return slips_stiffness * std::max(0.0, state.slips.position.z() - state.nodes[static_cast<std::size_t>(state.slips.node)].position.z());
}

}  // namespace drill_rig_sim
