// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/model/forces/inertia.h"

#include "drill_rig_sim/model/forces/free_string.h"
#include "drill_rig_sim/model/forces/guide_rail.h"

namespace drill_rig_sim
{
using Eigen::Map;
using Eigen::Vector3d;

namespace
{
void add_inertia_of_nodes(const StageContext& at, const ForceRows& to) noexcept
{
  const double dv_du = at.stage.dv_du, da_du = at.stage.da_du;
  for (int i = 0; i < at.model.nodes(); ++i)
  {
    if (at.stage.guides.guided[static_cast<std::size_t>(i)]) continue;
    const RigidBody body = node_body(at.model, at.stage, i);
    const NodeMotion& node = at.work.nodes[i];
    const Vector3d& n = node.axis;
    const Vector3d w = node.rate.tail<3>();
    to.force(i) += inertia_force(body, n, w, node.acceleration, body.spin_inertia);
    if (!to.with_tangent()) continue;

    const one_lane::Body b{body.mass, body.added_mass, body.spin_inertia, body.tilt_inertia};
    const one_lane::AlongAndAcross slope = inertia_slope(b, da_du);
    auto d = to.slope(i);
    d.topLeftCorner<3, 3>() += slope.nn * n * n.transpose();
    d.topLeftCorner<3, 3>().diagonal().array() += slope.one;
    const double turned = dv_du * body.spin_inertia;
    d.bottomRightCorner<3, 3>() += to_eigen(moment_slope(turning_slope(b, da_du), turned, one_lane::from(n), one_lane::from(w)));
  }
}

void add_inertia(const StageContext& at, const ForceRows& to) noexcept
{
  if (!moved_in_batches(at)) add_inertia_of_nodes(at, to);  // else the batch kernel of the beams has it
}

void store_inertia(const StageContext& at, StoredEnergy& energy) noexcept
{
  for (int i = 0; i < at.model.nodes(); ++i)
  {
    if (at.stage.guides.guided[static_cast<std::size_t>(i)]) continue;
    const RigidBody body = node_body(at.model, at.stage, i);
    const NodeMotion& node = at.work.nodes[i];
    energy.kinetic += kinetic_energy(body, node.axis, node.rate.head<3>());
    energy.turning += turning_energy(body, node.axis, node.rate.tail<3>());
  }
}

void sample_inertia(const StageContext& at, EnergySample& sample) noexcept
{
  for (int i = 0; i < at.model.nodes(); ++i)
  {
    if (at.stage.guides.guided[static_cast<std::size_t>(i)]) continue;
    const RigidBody body = node_body(at.model, at.stage, i);
    const NodeMotion& node = at.work.nodes[i];
    // the gyroscopic moment does no work
    at_node(sample, NodeForce::inertia, i) += inertia_force(body, node.axis, node.rate.tail<3>(), node.acceleration, 0.0);
  }
}
}  // namespace

const Force inertia = {"inertia", Cost::inertia, Sum::none,     add_inertia, add_inertia_of_nodes,
                       nullptr,   store_inertia, sample_inertia};

RigidBody node_body(const Model& model, const Stage& stage, int i) noexcept
{
  const MeshNode& node = model.mesh().nodes[i];
  const double block = i == model.top() ? model.scene().rig.hoisting.block_mass : 0.0;
  return {node.mass + block, stage.added_mass[static_cast<std::size_t>(i)], node.spin_inertia, node.tilt_inertia};
}

void accelerate(const Model& model, const Stage& stage, const double* residual, Workspace& work) noexcept
{
  for (int i = 0; i < model.nodes(); ++i)
  {
    const RigidBody body = node_body(model, stage, i);
    NodeMotion& node = work.nodes[i];
    const Vector3d& n = node.axis;
    const Vector3d force = -Map<const Vector3d>(residual + 6 * i), moment = -Map<const Vector3d>(residual + 6 * i + 3);
    const double along = body.mass, across = body.mass + body.added_mass;
    node.acceleration.head<3>() = force / across + (n.dot(force) * (1.0 / along - 1.0 / across)) * n;
    node.acceleration.tail<3>() =
        moment / body.tilt_inertia + (n.dot(moment) * (1.0 / body.spin_inertia - 1.0 / body.tilt_inertia)) * n;
  }
  for (int k : held_by_rail) work.nodes.back().acceleration[k] = 0.0;
}

void multiply_mass(const Model& model, const Stage& stage, const double* x, double* y) noexcept
{
  for (int i = 0; i < model.nodes(); ++i)
  {
    const Vector6d acceleration = Map<const Vector6d>(x + 6 * i);
    at_node(y, i) = inertia_force(node_body(model, stage, i), stage.normal[i], Vector3d::Zero(), acceleration, 0.0);
  }
  for (int k : held_by_rail) y[6 * model.top() + k] = 0.0;
}

}  // namespace drill_rig_sim
