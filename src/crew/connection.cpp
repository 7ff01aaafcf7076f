// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/crew/connection.h"

#include <algorithm>
#include <cmath>

#include "drill_rig_sim/math/rotation.h"
#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/model/guides.h"
#include "drill_rig_sim/model/mud_temperature.h"

namespace drill_rig_sim
{
using Eigen::Quaterniond;
using Eigen::Vector3d;

namespace
{
/// From 0 to 1 with a slope of 0 at both ends.
double smooth(double share) noexcept
{
  const double s = std::clamp(share, 0.0, 1.0);
  return s * s * (3.0 - 2.0 * s);
}

double running_time(const HoistingSpec& spec, double travel) noexcept
{
  const double way = std::abs(travel);
  return std::max({0.5 * spec.connection_time, 2.0 * way / spec.max_speed, std::sqrt(2.0 * pi * way / spec.max_acceleration)});
}

/// Weight of the pipe on node i above the slips, which is at height `z` with its neighbours at their unstretched distances [N].
double weight_on(const Model& model, int i, double z) noexcept
{
  const std::vector<MeshNode>& nodes = model.mesh().nodes;
  const auto height = [&](int k)
  { return z + nodes[static_cast<std::size_t>(k)].from_bit - nodes[static_cast<std::size_t>(i)].from_bit; };
  const auto half = [&](int e) { return 0.5 * model.element_weight(e, height(e), height(e + 1), full_bore); };
  return half(i - 1) + (i < model.top() ? half(i) : 0.0);
}

/// Stretched length of the element above node i under a tension.
double stretched(const Model& model, int i, double tension) noexcept
{
  const BeamSection& section = model.mesh().elements[static_cast<std::size_t>(i)].section;
  return section.length * (1.0 + tension / section.axial);
}

/// Puts a guided node onto its hole, `length` [m] above the one below it if that is guided too.
void settle_above(State& state, std::size_t i, const Vector3d& up, double length) noexcept
{
  settle_in_hole(state, i);
  if (!state.nodes[i - 1].guided) return;
  for (int round = 0; round < 3; ++round)  // the sides on which they lie change it by their squares
  {
    state.nodes[i].position -= (guided_length(state, i - 1) - length) * up;
    settle_in_hole(state, i);
  }
}

/// The place of a shaft `length` [m] of straight pipe above `foot`, on the block's rail.
Vector3d shaft_above(const Vector3d& foot, const Vector3d& rail, double length) noexcept
{
  const double aside = (rail - foot).head<2>().norm();
  return {rail.x(), rail.y(), foot.z() + std::sqrt(length * length - aside * aside)};
}
}  // namespace

double connection_duration(const HoistingSpec& spec, double travel) noexcept
{
  return 0.5 * spec.connection_time + running_time(spec, travel);
}

BlockRun block_run(const HoistingSpec& spec, const ConnectionState& connection) noexcept
{
  if (!connection.under_way) return {};
  const double time = running_time(spec, connection.travel);
  const double share = std::clamp((connection.elapsed - 0.25 * spec.connection_time) / time, 0.0, 1.0);
  const double turn = 2.0 * pi * share;
  return {connection.travel * (share - std::sin(turn) / (2.0 * pi)), connection.travel / time * (1.0 - std::cos(turn))};
}

double shown_while_broken_out(const HoistingSpec& spec, const ConnectionState& connection, double held, double between,
                              double after) noexcept
{
  const double quarter = 0.25 * spec.connection_time;
  const double broken = smooth(connection.elapsed / quarter);
  const double made = smooth((connection.elapsed - connection_duration(spec, connection.travel) + quarter) / quarter);
  return held + broken * (between - held) + made * (after - between);
}

int uppermost_joint(const Mesh& mesh) noexcept
{
  int i = static_cast<int>(mesh.nodes.size()) - 2;
  while (i >= 0 && !mesh.nodes[static_cast<std::size_t>(i)].joint_end) --i;
  return i;
}

int joints_below_stump(const Mesh& mesh, const Scene& scene) noexcept
{
  const int i = uppermost_joint(mesh);
  if (i < 0) return 0;
  const double length = mesh.nodes[static_cast<std::size_t>(i)].from_bit - mesh.part_bottom.back();
  return static_cast<int>(std::lround(length / scene.string.back().joint_length));
}

HangingPipe hanging_pipe(const Model& model, int held, double z) noexcept
{
  HangingPipe out{0.0, z};
  for (int i = held; i < model.top(); ++i)
  {
    out.height += stretched(model, i, out.weight);
    out.weight += weight_on(model, i + 1, out.height);
  }
  return out;
}

State made_up(const Model& model, const State& before, int held, double travel, double free_length)
{
  State state = before;
  const std::size_t nodes = model.mesh().nodes.size(), first = static_cast<std::size_t>(held) + 1;
  state.nodes.resize(nodes);
  state.spans.resize(nodes - 1);
  const NodeState& below = state.nodes[first - 1];
  const double foot = below.position.z();
  const Vector3d shaft = shaft_above(below.position, before.nodes.back().position, hanging_pipe(model, held, foot).height - foot);
  const Vector3d up = (shaft - below.position).normalized();
  double tension = 0.0;
  for (std::size_t i = first; i < nodes; ++i)
  {
    const double length = stretched(model, static_cast<int>(i) - 1, tension);
    NodeState node;
    node.spin_angle = below.spin_angle;
    node.rate.velocity.z() = state.hoist.floor.speed;
    node.orientation = pointed_along(below.orientation, i + 1 < nodes ? Vector3d(-up) : Vector3d(-Vector3d::UnitZ()));
    node.position = i + 1 < nodes ? Vector3d(state.nodes[i - 1].position + length * up) : shaft;
    node.segment = 0;
    node.guided = model.mesh().nodes[i].from_bit > free_length;
    state.nodes[i] = node;
    if (node.guided) settle_above(state, i, up, length);
    state.spans[i - 1] = SpanState();
    tension += weight_on(model, static_cast<int>(i), state.nodes[i].position.z());
  }
  const HoistingSpec& hoisting = model.scene().rig.hoisting;
  const double hook_load = tension + standard_gravity * hoisting.block_mass;
  state.hoist.line_length = line_length_for(hoisting, block_height(state), hook_load);
  state.hoist.sheave_slip = sheave_slip(before.hoist.sheave_slip, travel);
  state.hoist.winch_speed = state.hoist.rail_deflection = 0.0;
  state.hoist.limited = state.hoist.at_stop = false;
  state.drive.speed = state.drive.integral = state.drive.meter_twist = state.drive.gear_twist = state.drive.reference = 0.0;
  state.memory.last_step = 0.0;
  for (PastQuantity& past : state.memory.past) past.nodes.resize(nodes);
  state.step.wanted = 0.0;
  if (travel < 0.0 && state.faults.leak_from_bit > model.mesh().nodes[first - 1].from_bit)
    state.faults.leak_area = state.faults.leak_from_bit = 0.0;  // the leaking pipe is laid down
  renew_temperature(model, state);
  state.mud_waves = waves_at_rest(model.mud().waves, state.time, state.hydraulics.strokes);  // the open string has no pressure
  return state;
}

RigForces forces_of_made_up(const Model& model, const State& state, const RigForces& before, int held)
{
  RigForces forces = before;
  const std::size_t nodes = state.nodes.size(), first = static_cast<std::size_t>(held) + 1;
  const auto cut = [&](auto& along, std::size_t from, std::size_t size, const auto& zero)
  {
    along.resize(from);
    along.resize(size, zero);
  };
  for (auto* along : {&forces.tension, &forces.torque, &forces.span_contact}) cut(*along, first - 1, nodes - 1, 0.0);
  for (auto* along : {&forces.bending_moment, &forces.contact}) cut(*along, first, nodes, 0.0);
  cut(forces.wall, first, nodes, Vector3d(Vector3d::Zero()));
  cut(forces.span_wall, first - 1, nodes - 1, Vector3d(Vector3d::Zero()));
  double tension = 0.0;
  for (std::size_t i = first; i < nodes; ++i)
  {
    forces.tension[i - 1] = tension;
    tension += weight_on(model, static_cast<int>(i), state.nodes[i].position.z());
  }
  forces.hook_load = tension + standard_gravity * model.scene().rig.hoisting.block_mass;
  forces.meter_torque = forces.drive_torque = forces.gear_friction = forces.block_resistance = 0.0;
  return forces;
}

}  // namespace drill_rig_sim
