// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/model/forces/place_drag.h"

#include <algorithm>
#include <cmath>

#include "drill_rig_sim/contact/filter_cake.h"
#include "drill_rig_sim/contact/surface_friction.h"
#include "drill_rig_sim/math/rotation.h"
#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/model/mud_temperature.h"
#include "drill_rig_sim/model/wall_faults.h"

namespace drill_rig_sim
{
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace
{
constexpr double narrowest = 1e-3;  // of an annulus [m]

const DragState& state_of(const State& state, std::size_t k) noexcept
{
  return k == 0 ? state.faults.pack_off : state.faults.sticking;
}

SurfaceMotion motion_of(const StageContext& at, const PlaceDrag& drag) noexcept
{
  const NodeMotion& node = at.node(drag.node);
  SurfaceMotion out;
  out.displacement << node.increment.head<3>().dot(node.axis), drag.lever * node.spin;
  out.velocity << node.rate.head<3>().dot(node.axis), drag.lever * node.rate.tail<3>().dot(node.axis);
  out.velocity_coefficient = at.stage.dv_du;
  out.time = at.stage.time;
  return out;
}

SurfaceFriction friction_of(const StageContext& at, std::size_t k, SurfaceSlopes* slopes) noexcept
{
  WallLaw law;
  law.tangential_stiffness = place_drag_stiffness;
  law.tangential_damping = place_drag_damping;
  law.stribeck_speed = 1.0;
  const PlaceDrag& drag = at.stage.drags[k];
  return surface_friction(drag.most, 1.0, motion_of(at, drag), state_of(at.start, k).bristle, law, slopes);
}

/// Calls visit(k) for the drags that act on a node.
template <class Visit>
void each_drag(const StageContext& at, Visit&& visit)
{
  for (std::size_t k = 0; k < at.stage.drags.size(); ++k)
    if (at.stage.drags[k].node >= 0) visit(k);
}

/// Six numbers of a force along and around a pipe: what resists.
Vector6d resistance(const Vector3d& axis, double lever, const Vector2d& force) noexcept
{
  Vector6d out;
  out << -force.x() * axis, -lever * force.y() * axis;
  return out;
}

void remember(const StageContext& at, std::size_t k, const SurfaceFriction& f) noexcept
{
  DragState& next = at.work.result.drags[k];
  next.bristle = f.bristle;
  const bool stands = motion_of(at, at.stage.drags[k]).velocity.norm() < standing_pipe;
  next.rest = stands ? state_of(at.start, k).rest + at.stage.time : 0.0;
}

void add_place_drag(const StageContext& at, const ForceRows& to) noexcept
{
  each_drag(at,
            [&](std::size_t k)
            {
              const PlaceDrag& drag = at.stage.drags[k];
              const Vector3d& n = at.node(drag.node).axis;
              SurfaceSlopes slopes;
              const SurfaceFriction f = friction_of(at, k, to.with_tangent() ? &slopes : nullptr);
              to.force(drag.node) += resistance(n, drag.lever, f.force);
              remember(at, k, f);
              if (!to.with_tangent()) return;
              const Eigen::Matrix3d along = n * n.transpose();
              const Eigen::Matrix2d& d = slopes.by_displacement;
              auto block = to.slope(drag.node);
              block.topLeftCorner<3, 3>() -= d(0, 0) * along;
              block.topRightCorner<3, 3>() -= drag.lever * d(0, 1) * along;
              block.bottomLeftCorner<3, 3>() -= drag.lever * d(1, 0) * along;
              block.bottomRightCorner<3, 3>() -= drag.lever * drag.lever * d(1, 1) * along;
            });
}

void store_place_drag(const StageContext& at, StoredEnergy& energy) noexcept
{
  each_drag(
      at, [&](std::size_t k) { energy.bristles += 0.5 * place_drag_stiffness * at.work.result.drags[k].bristle.squaredNorm(); });
}

void sample_place_drag(const StageContext& at, EnergySample& sample) noexcept
{
  each_drag(at,
            [&](std::size_t k)
            {
              const PlaceDrag& drag = at.stage.drags[k];
              const Vector3d& n = at.node(drag.node).axis;
              at_node(sample, NodeForce::friction, drag.node) += resistance(n, drag.lever, friction_of(at, k, nullptr).force);
            });
}

double plug_at(const Model& model, const State& state, int node) noexcept
{
  const DragState& plug = state.faults.pack_off;
  const std::size_t i = static_cast<std::size_t>(node);
  const double radius = state.well.wall_at(plug.md, state.nodes[i].segment).radius + wash_out(state.faults, plug.md).radius;
  return pack_off_pressure(plug.amount, 2.0 * radius, model.mesh().nodes[i].diameter);
}

PlaceDrag drag_at(const Model& model, const State& state, double bit_depth, std::size_t k) noexcept
{
  const DragState& drag = state_of(state, k);
  PlaceDrag out;
  if (drag.amount <= 0.0 || drag.md > bit_depth) return out;
  out.node = nearest_node(model, bit_depth, drag.md);
  out.lever = model.mesh().nodes[static_cast<std::size_t>(out.node)].contact_radius;
  out.most = drag.amount;
  if (k == 0)
  {
    out.pressure = std::clamp(state.hydraulics.annulus_pressure - annulus_load(state), 0.0, plug_at(model, state, out.node));
    return out;
  }
  const FaultState& faults = state.faults;
  const HoleWall wall = state.well.wall_at(drag.md, state.nodes[static_cast<std::size_t>(out.node)].segment);
  const double radius = wall.radius + wash_out(faults, drag.md).radius;
  out.most *=
      wall.friction * friction_factor(faults, drag.md) * sealed_width(out.lever, radius - out.lever) * sealed_share(drag.rest);
  return out;
}
}  // namespace

const Force place_drag = {"place drag", Cost::contact,  Sum::none,        add_place_drag,
                          nullptr,      add_place_drag, store_place_drag, sample_place_drag};

double depth_of_bit(const Model& model, const State& state) noexcept
{
  const NodeState& bit = state.nodes.front();
  return state.well.locate(bit.position + model.mesh().bit_radius * x_axis(bit.orientation), bit.segment).md;
}

int nearest_node(const Model& model, double bit_depth, double md) noexcept
{
  int nearest = 0;
  for (int i = 1; i < model.top(); ++i)
  {
    const double depth = bit_depth - model.mesh().nodes[static_cast<std::size_t>(i)].from_bit;
    const double of_nearest = bit_depth - model.mesh().nodes[static_cast<std::size_t>(nearest)].from_bit;
    if (depth > 0.0 && std::abs(depth - md) < std::abs(of_nearest - md)) nearest = i;
  }
  return nearest;
}

void find_drags(const Model& model, const State& state, Stage& stage) noexcept
{
  for (PlaceDrag& drag : stage.drags) drag = PlaceDrag();
  if (state.faults.pack_off.amount <= 0.0 && state.faults.sticking.amount <= 0.0) return;
  const double depth = depth_of_bit(model, state);
  for (std::size_t k = 0; k < stage.drags.size(); ++k) stage.drags[k] = drag_at(model, state, depth, k);
}

void advance_drags(const Stage& stage, const StageResult& result, FaultState& faults) noexcept
{
  for (std::size_t k = 0; k < stage.drags.size(); ++k)
  {
    const DragState now = stage.drags[k].node >= 0 ? result.drags[k] : DragState();
    DragState& drag = k == 0 ? faults.pack_off : faults.sticking;
    drag.bristle = now.bristle;
    drag.rest = now.rest;
  }
}

double pack_off_pressure(double force, double hole_diameter, double diameter) noexcept
{
  return 4.0 * force / (pi * diameter * std::max(hole_diameter - diameter, narrowest));
}

double plug_pressure(const Model& model, const State& state) noexcept
{
  const DragState& plug = state.faults.pack_off;
  if (plug.amount <= 0.0) return 0.0;
  const double bit = depth_of_bit(model, state);
  return plug.md <= bit ? plug_at(model, state, nearest_node(model, bit, plug.md)) : 0.0;
}

}  // namespace drill_rig_sim
