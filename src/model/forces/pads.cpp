// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/model/forces/pads.h"

#include "drill_rig_sim/contact/surface_friction.h"
#include "drill_rig_sim/math/rotation.h"
#include "drill_rig_sim/model/pointing.h"
#include "drill_rig_sim/model/wall_faults.h"

namespace drill_rig_sim
{
using Eigen::Vector2d;
using Eigen::Vector3d;
using Rows = Eigen::Matrix<double, 2, 6>;

namespace
{
bool pushes(const StageContext& at) noexcept
{
  return at.stage.pads.normal_force > 0.0;
}

int node_of(const StageContext& at) noexcept
{
  return at.model.mesh().pad_node;
}

/// ds / d(x, r).
Rows motions(const StageContext& at) noexcept
{
  const Pads& pads = at.stage.pads;
  const Vector3d& along = at.stage.normal[static_cast<std::size_t>(node_of(at))];
  Rows out;
  out << along.transpose(), -pads.lever * pads.around.transpose(), pads.around.transpose(), pads.lever * along.transpose();
  return out;
}

SurfaceFriction friction_of(const StageContext& at, const Rows& by_node, SurfaceSlopes* slopes) noexcept
{
  const NodeMotion& node = at.node(node_of(at));
  const Pads& pads = at.stage.pads;
  const SurfaceMotion motion{by_node * node.increment, by_node * node.rate, at.stage.dv_du, at.stage.time};
  return surface_friction(pads.normal_force, pads.friction, motion, at.start.pads.bristle, pads.law, slopes);
}

void add_pads(const StageContext& at, const ForceRows& to) noexcept
{
  PadsState& next = at.work.result.pads;
  next = PadsState();
  if (!pushes(at)) return;
  const Rows by_node = motions(at);
  SurfaceSlopes slopes;
  const SurfaceFriction f = friction_of(at, by_node, to.with_tangent() ? &slopes : nullptr);
  auto r = to.force(node_of(at));
  r.head<3>() -= at.stage.pads.force;
  r -= by_node.transpose() * f.force;
  next.bristle = f.bristle;
  next.rest = f.slipping ? 0.0 : at.start.pads.rest + at.stage.time;
  if (to.with_tangent()) to.slope(node_of(at)) -= by_node.transpose() * slopes.by_displacement * by_node;
}

void store_pads(const StageContext& at, StoredEnergy& energy) noexcept
{
  if (pushes(at)) energy.bristles += 0.5 * at.stage.pads.law.tangential_stiffness * at.work.result.pads.bristle.squaredNorm();
}

void sample_pads(const StageContext& at, EnergySample& sample) noexcept
{
  if (!pushes(at)) return;
  const Rows by_node = motions(at);
  at_node(sample, NodeForce::pads, node_of(at)).head<3>() -= at.stage.pads.force;
  at_node(sample, NodeForce::friction, node_of(at)) -= by_node.transpose() * friction_of(at, by_node, nullptr).force;
}
}  // namespace

const Force pads = {"pads", Cost::rig, Sum::contact, add_pads, nullptr, add_pads, store_pads, sample_pads};

void find_pads(const Model& model, const State& state, const Setpoints& setpoints, Stage& stage) noexcept
{
  stage.pads = Pads();
  const int i = model.mesh().pad_node;
  if (i < 0) return;
  const NodeState& node = state.nodes[static_cast<std::size_t>(i)];
  const Vector3d axis = x_axis(node.orientation);
  Pads& pads = stage.pads;
  pads.force = steering(axis, setpoints, model.steerable()->pad_force);
  pads.normal_force = pads.force.norm();
  if (pads.normal_force == 0.0) return;
  const ClosestPoint hole = state.well.locate(node.position, node.segment);
  const double own_lever = model.mesh().nodes[static_cast<std::size_t>(i)].friction_radius;
  pads.around = axis.cross(-pads.force / pads.normal_force);
  pads.lever = own_lever > 0.0 ? own_lever : hole.radius + wash_out(state.faults, hole.md).radius;
  pads.friction = hole.friction * friction_factor(state, hole.md);
  pads.law = model.contact(i, hole.section, state.pads.rest);
}

}  // namespace drill_rig_sim
