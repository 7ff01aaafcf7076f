// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/model/forces/wall.h"

#include <cmath>

#include "wall_parts.h"

namespace drill_rig_sim
{
using Eigen::Vector3d;
using Matrix6d = Eigen::Matrix<double, 6, 6>;

namespace
{
double radius_of(const StageContext& at, int i) noexcept
{
  return at.model.mesh().nodes[i].contact_radius;
}

WallForce sticking_force(const StageContext& at, int i, Matrix6d* block) noexcept
{
  const NodeMotion& node = at.work.nodes[i];
  ContactMotion motion;
  motion.position = node.position;
  motion.displacement = node.increment.head<3>();
  motion.rotation = node.increment.tail<3>();
  motion.velocity = node.rate.head<3>();
  motion.angular_velocity = node.rate.tail<3>();
  motion.velocity_coefficient = at.stage.dv_du;
  motion.time = at.stage.time;
  if (i < at.model.mesh().gauge_nodes)  // the bit turns with the motor
  {
    motion.rotation += at.stage.bit.motor_turn * node.axis;
    motion.angular_velocity += at.stage.bit.motor_speed * node.axis;
  }
  const Vector3d& bristle = at.start.nodes[i].bristle;
  const WallLaw law = at.model.contact(i, node.closest, at.start.nodes[i].rest);
  return block ? wall_contact(node.closest, radius_of(at, i), motion, bristle, law, *block)
               : wall_contact(node.closest, radius_of(at, i), motion, bristle, law);
}

WallForce sliding_force(const StageContext& at, int i, Matrix6d* block) noexcept
{
  const NodeMotion& node = at.work.nodes[i];
  Matrix6d unused;
  return sliding_wall_contact(node.closest, radius_of(at, i), node.position, at.stage.sliding, at.model.contact(i),
                              block ? *block : unused);
}

/// Rock on bit about its centre.
Vector3d moment_on_bit(const StageContext& at, int i, const WallForce& f) noexcept
{
  return f.moment + (at.work.nodes[i].position - at.work.nodes[0].position).cross(f.force);
}

using ForceAtNode = WallForce (*)(const StageContext&, int, Matrix6d*) noexcept;

template <ForceAtNode force_at>
void add_at(const StageContext& at, int i, const ForceRows& to) noexcept
{
  StageResult& result = at.work.result;
  WallForce f;
  if (at.work.nodes[i].touches)
  {
    Matrix6d block;
    f = force_at(at, i, to.with_tangent() ? &block : nullptr);
    auto r = to.force(i);
    r.head<3>() -= f.force;
    r.tail<3>() -= f.moment;
    if (to.with_tangent()) to.slope(i) -= block;
  }
  result.bristle[i] = f.bristle;
  result.rest[i] = rest_after(f, at.start.nodes[i].rest, at.stage.time);
  result.forces.contact[i] = f.normal_force;
  result.forces.wall[i] = f.force;
  if (i < at.model.mesh().gauge_nodes) result.forces.bit_moment += moment_on_bit(at, i, f);
}

template <ForceAtNode force_at>
void add_wall(const StageContext& at, const ForceRows& to) noexcept
{
  at.work.result.forces.bit_moment.setZero();
  each_outside(at.stage.guided_nodes, at.model.top(), [&](int i) { add_at<force_at>(at, i, to); });
}

/// For the batch kernel: node i, the k-th that touches.
void enter(const StageContext& at, int i, int k, const ForceRows& to) noexcept
{
  const NodeMotion& node = at.work.nodes[i];
  StageResult& result = at.work.result;
  const double before = at.start.nodes[i].rest;
  result.rest[i] = before;
  const double radius = radius_of(at, i);
  StringColumns& columns = at.work.columns;
  WallPlace& place = columns.wall_places[k];
  place.node = &node;
  place.bristle = &at.start.nodes[i].bristle;
  place.law = &at.model.contact(i);
  if (at.model.contact_varies()) place.law = &(columns.wall_laws[k] = at.model.contact(i, node.closest, before));
  place.lever = place.law->friction_radius > 0.0 ? place.law->friction_radius : radius;
  place.radius = radius;
  place.residual = to.force(i).data();
  place.diagonal = to.with_tangent() ? to.slope(i).data() : nullptr;
  place.wall = &result.forces.wall[i];
  place.bristle_after = &result.bristle[i];
  place.normal_force = &result.forces.contact[i];
  place.rest = &result.rest[i];
}

void leave_clear(StageResult& result, int i) noexcept
{
  result.bristle[i].setZero();
  result.rest[i] = 0.0;
  result.forces.contact[i] = 0.0;
  result.forces.wall[i].setZero();
}

/// The gauge, which turns with the motor, and unusual laws one by one.
void add_batches(const StageContext& at, const ForceRows& to) noexcept
{
  at.work.result.forces.bit_moment.setZero();
  int count = 0;
  each_outside(at.stage.guided_nodes, at.model.top(),
               [&](int i)
               {
                 if (i < at.model.mesh().gauge_nodes || (at.work.nodes[i].touches && at.model.contact(i).law.exponent != 1.5))
                   add_at<sticking_force>(at, i, to);
                 else if (at.work.nodes[i].touches)
                   enter(at, i, count++, to);
                 else
                   leave_clear(at.work.result, i);
               });
  const bool exponential = at.model.scene().contact.stribeck_curve == StribeckCurve::exponential;
  at.work.wall->add({at.work.columns.wall_places.data(), count, at.stage.dv_du, at.stage.time, exponential});
}

void add_sticking(const StageContext& at, const ForceRows& to) noexcept
{
  if (at.work.wall)
    add_batches(at, to);
  else
    add_wall<sticking_force>(at, to);
}

void store_wall(const StageContext& at, StoredEnergy& energy) noexcept
{
  each_outside(at.stage.guided_nodes, at.model.top(),
               [&](int i)
               {
                 const NodeMotion& node = at.work.nodes[i];
                 energy.bristles += 0.5 * at.model.contact(i).tangential_stiffness * at.work.result.bristle[i].squaredNorm();
                 if (node.touches)
                   energy.wall +=
                       elastic_energy(at.model.contact(i).law, -wall_gap(node.closest, node.position, radius_of(at, i)));
               });
}

/// The normal force apart: its elastic part is the gradient of the wall's energy, but for its share along a ledge.
void sample_at(const StageContext& at, int i, EnergySample& sample) noexcept
{
  const NodeMotion& node = at.work.nodes[i];
  const WallForce f = sticking_force(at, i, nullptr);
  const WallParts parts = parts_of(f, node.closest, at.model.contact(i).law);
  at_node(sample, NodeForce::wall, i).head<3>() += parts.elastic;
  at_node(sample, NodeForce::ledge, i).head<3>() += parts.ledge;
  at_node(sample, NodeForce::wall_damping, i).head<3>() += parts.damping;
  auto friction = at_node(sample, NodeForce::friction, i);
  friction.head<3>() += parts.friction;
  friction.tail<3>() += parts.friction_moment;
  if (i < at.model.mesh().gauge_nodes) sample.gauge_torque -= f.moment.dot(node.axis);
}

void sample_wall(const StageContext& at, EnergySample& sample) noexcept
{
  sample.gauge_torque = 0.0;
  each_outside(at.stage.guided_nodes, at.model.top(),
               [&](int i)
               {
                 if (at.work.nodes[i].touches) sample_at(at, i, sample);
               });
}
}  // namespace

const Force wall = {"wall",       Cost::contact, Sum::contact, add_sticking, add_wall<sliding_force>,
                    add_sticking, store_wall,    sample_wall};

void add_wall_at_bit(const StageContext& at, const ForceRows& to) noexcept
{
  at.work.result.forces.bit_moment.setZero();
  add_at<sticking_force>(at, 0, to);
}

}  // namespace drill_rig_sim
