// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_MODEL_FORCES_HELD_NODE_H
#define DRILL_RIG_SIM_SRC_MODEL_FORCES_HELD_NODE_H

#include <algorithm>

#include "drill_rig_sim/model/forces/force.h"

namespace drill_rig_sim
{
/// Springs by which something holds a node where it gripped it: against displacement and against its turn about the string's
/// axis.
struct Grip
{
  double stiffness;  ///< [N/m]
  double torsion;    ///< [N m/rad]
  bool lets_up;      ///< it supports the node from below and lets it go upwards
  bool on_floor;     ///< it heaves with the rig
};

/// How far a node is from where it is held: what of its displacement is resisted, and its turn about the string's axis.
struct HeldOffset
{
  Eigen::Vector3d place;  ///< [m]
  double turn;            ///< [rad]
};

inline HeldOffset offset_of(const StageContext& at, const HeldNode& held, const Grip& grip) noexcept
{
  const NodeMotion& node = at.node(held.node);
  Eigen::Vector3d place = node.position - held.position;
  if (grip.on_floor) place.z() -= at.stage.hoist.floor.height;
  if (grip.lets_up) place.z() = std::min(0.0, place.z());
  return {place, at.start.nodes[held.node].spin_angle + node.spin - held.spin_angle};
}

inline Vector6d force_of(const StageContext& at, const HeldNode& held, const Grip& grip) noexcept
{
  const HeldOffset offset = offset_of(at, held, grip);
  Vector6d out;
  out.head<3>() = grip.stiffness * offset.place;
  out.tail<3>() = grip.torsion * offset.turn * at.node(held.node).axis;
  return out;
}

/// Force::add, store and sample of a node that is held, or of none.
inline void add_held(const StageContext& at, const HeldNode& held, const Grip& grip, const ForceRows& to) noexcept
{
  const int i = held.node;
  if (i < 0) return;
  to.force(i) += force_of(at, held, grip);
  if (!to.with_tangent()) return;
  const Eigen::Vector3d& n = at.node(i).axis;
  auto d = to.slope(i);
  d(0, 0) += grip.stiffness;
  d(1, 1) += grip.stiffness;
  if (!grip.lets_up || offset_of(at, held, grip).place.z() < 0.0) d(2, 2) += grip.stiffness;
  d.bottomRightCorner<3, 3>() += grip.torsion * n * n.transpose();
}

inline void store_held(const StageContext& at, const HeldNode& held, const Grip& grip, StoredEnergy& energy) noexcept
{
  if (held.node < 0) return;
  const HeldOffset offset = offset_of(at, held, grip);
  energy.stuck_point += 0.5 * (grip.stiffness * offset.place.squaredNorm() + grip.torsion * offset.turn * offset.turn);
}

inline void sample_held(const StageContext& at, const HeldNode& held, const Grip& grip, EnergySample& sample) noexcept
{
  if (held.node >= 0) at_node(sample, NodeForce::stuck_point, held.node) += force_of(at, held, grip);
}

}  // namespace drill_rig_sim

#endif
