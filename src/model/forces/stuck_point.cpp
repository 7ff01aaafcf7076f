#include "drill_rig_sim/model/forces/stuck_point.h"

namespace drill_rig_sim
{
namespace
{
/// How far the node is from where it is held: displacement, and turn about the string's axis.
struct Offset
{
  Eigen::Vector3d place;  // [m]
  double turn;            // [rad]
};

Offset offset_of(const StageContext& at) noexcept
{
  const HeldNode& held = at.start.stuck_point;
  const NodeMotion& node = at.work.nodes[held.node];
  return {node.position - held.position, at.start.nodes[held.node].spin_angle + node.spin - held.spin_angle};
}

Vector6d force_of(const StageContext& at) noexcept
{
  const Offset offset = offset_of(at);
  Vector6d out;
  out.head<3>() = stuck_point_stiffness * offset.place;
  out.tail<3>() = stuck_point_torsion * offset.turn * at.work.nodes[at.start.stuck_point.node].axis;
  return out;
}

void add(const StageContext& at, double* residual, BlockTridiagonal* tangent) noexcept
{
  const int i = at.start.stuck_point.node;
  if (i < 0) return;
  at_node(residual, i) += force_of(at);
  if (!tangent) return;
  const Eigen::Vector3d& n = at.work.nodes[i].axis;
  auto d = tangent->diagonal(i);
  d.topLeftCorner<3, 3>().diagonal().array() += stuck_point_stiffness;
  d.bottomRightCorner<3, 3>() += stuck_point_torsion * n * n.transpose();
}

void store(const StageContext& at, StoredEnergy& energy) noexcept
{
  if (at.start.stuck_point.node < 0) return;
  const Offset offset = offset_of(at);
  energy.stuck_point += 0.5 * (stuck_point_stiffness * offset.place.squaredNorm() + stuck_point_torsion * offset.turn * offset.turn);
}

void sample(const StageContext& at, EnergySample& sample) noexcept
{
  if (at.start.stuck_point.node >= 0) at_node(sample, NodeForce::stuck_point, at.start.stuck_point.node) += force_of(at);
}
}  // namespace

const Force stuck_point = {"stuck point", Cost::rig, add, store, sample};

}  // namespace drill_rig_sim
