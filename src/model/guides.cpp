// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/model/guides.h"

#include <algorithm>
#include <cmath>

#include "drill_rig_sim/math/rotation.h"
#include "drill_rig_sim/model/clear_runs.h"
#include "drill_rig_sim/model/forces/inertia.h"
#include "drill_rig_sim/model/kernels/guided_kernel.h"
#include "drill_rig_sim/model/stage.h"
#include "drill_rig_sim/model/wall_faults.h"
#include "drill_rig_sim/model/workspace.h"

namespace drill_rig_sim
{
using Eigen::Vector3d;

namespace
{
constexpr double kSettles = 0.5;  // over this time a guided node changes sides [s]
constexpr double kAtOnce = 0.5;   // and so much of it in each step of statics

bool guided_pair(const State& state, std::size_t lower) noexcept
{
  return state.nodes[lower].guided && state.nodes[lower + 1].guided;
}

Vector3d across(const Vector3d& tangent, const Vector3d& v) noexcept
{
  return v - tangent * tangent.dot(v);
}

void find_guide(const Model& model, const State& state, const Stage& stage, std::size_t i, GuideColumns& g) noexcept
{
  const NodeState& node = state.nodes[i];
  const HoleWall hole = state.well.wall_at(node.md, node.segment);
  g.set_law(i, model.contact(static_cast<int>(i), hole.section, node.rest));
  g.tangent.set(i, x_axis(node.orientation));
  g.centre.set(i, node.position - node.side);
  g.weight.set(i, 0.5 * (stage.load[i] + stage.load[i - 1]));
  g.friction[i] = node.md > 0.0 ? hole.friction : 0.0;
  g.clearance[i] = node.md > 0.0 ? std::max(0.0, hole.radius - g.bearing_radius[i]) : 0.0;
  g.bristle.set(i, node.bristle.head<2>());
  g.rest[i] = node.rest;
  g.held[i] = g.stiffness[i] * node.bristle.y();
  g.wet_along[i] = stage.immersed[i] * g.mud_along[i];
  g.wet_about[i] = stage.immersed[i] * g.mud_about[i];
}

void find_span(const State& state, const Stage& stage, std::size_t e, GuideColumns& g) noexcept
{
  const NodeState &below = state.nodes[e], &above = state.nodes[e + 1];
  const Vector3d way = g.centre[e + 1] - g.centre[e], tangent = g.tangent[e];
  const double chord = way.norm(), axis = below.md - above.md;
  g.stretch[e] = axis + (way + above.side - below.side).norm() - chord - g.length[e] * (1.0 + stage.free_stretch[e]);
  g.twist[e] = state.spans[e].twist;
  g.direction.set(e, way / chord);
  g.turn.set(e, tangent.cross(tangent - g.tangent[e + 1]) / axis);
}

/// Calls batch(kernel, run) for the runs of guided nodes if there is a batch kernel, else node(i) for each of them.
template <class Batch, class Node>
void each_guided(const Stage& stage, const Batch& batch, const Node& node)
{
  for (const Runs::Run& run : stage.guided_nodes)
  {
    if (stage.guided_kernel)
    {
      batch(*stage.guided_kernel, run);
      continue;
    }
    for (int i = run.first; i < run.last; ++i) node(i);
  }
}

void find_run(const Model& model, const State& state, Stage& stage, Runs::Run run) noexcept
{
  const std::size_t first = static_cast<std::size_t>(run.first), last = static_cast<std::size_t>(run.last);
  for (std::size_t i = first; i < last; ++i) find_guide(model, state, stage, i, stage.guides);
  for (std::size_t e = first; e + 1 < last; ++e) find_span(state, stage, e, stage.guides);
  close_run(stage, run);
}

void reduce(const Stage& stage, double* b) noexcept
{
  each_guided(
      stage, [&](const GuidedKernel& by, Runs::Run run) { by.reduce(stage, run, b); },
      [&](int i)
      {
        const Vector3d tangent = stage.guides.tangent[i];
        double* at = b + 6 * i;
        const double along = tangent.dot(Eigen::Map<const Vector3d>(at)), about = tangent.dot(Eigen::Map<const Vector3d>(at + 3));
        at[0] = along;
        at[1] = about;
        at[2] = at[3] = at[4] = at[5] = 0.0;
      });
}

void expand(const Stage& stage, double* b) noexcept
{
  each_guided(
      stage, [&](const GuidedKernel& by, Runs::Run run) { by.expand(stage, run, b); },
      [&](int i)
      {
        const Vector3d tangent = stage.guides.tangent[i];
        double* at = b + 6 * i;
        const double along = at[0], about = at[1];
        Eigen::Map<Vector3d> place{at};
        place = along * tangent;
        Eigen::Map<Vector3d>(at + 3) = along * stage.guides.turn[i] + about * tangent;
      });
}

/// The load turned by how far friction `around` the pipe [N] makes it climb: the wall's normal force N and F balance P on the
/// side n = (N P + F t x P)/Q^2.
Vector3d climbed(const Vector3d& tangent, const Vector3d& push, double around) noexcept
{
  const double square = push.squaredNorm();
  if (!(square > around * around)) return push;
  return (std::sqrt(square - around * around) * push + around * tangent.cross(push)) / std::sqrt(square);
}

}  // namespace

void GuideColumns::set_law(std::size_t i, const WallLaw& law) noexcept
{
  stribeck_speed[i] = law.stribeck_speed;
  static_ratio[i] = law.static_ratio;
  stiffness[i] = law.tangential_stiffness;
  damping[i] = law.tangential_damping;
}

void close_run(Stage& stage, Runs::Run nodes) noexcept
{
  GuideColumns& g = stage.guides;
  const int first = nodes.first, last = nodes.last - 1;
  const Vector3d none = Vector3d::Zero();
  const bool alone = first == last;
  g.direction.set(first - 1, none);
  g.direction.set(last, none);
  g.weight.set(first, alone ? none : Vector3d(0.5 * stage.load[first]));
  g.weight.set(last, alone ? none : Vector3d(0.5 * stage.load[last - 1]));
  g.turn.set(last, alone ? none : g.turn[last - 1]);
}

/// Of the angles of a step n x t says it to their cube.
Eigen::Quaterniond turned_to(const Vector3d& tangent, const Eigen::Quaterniond& q) noexcept
{
  constexpr double small = 1e-3;  // [rad]
  const Vector3d normal = x_axis(q), turn = normal.cross(tangent);
  if (turn.squaredNorm() > small * small || normal.dot(tangent) < 0.0) return pointed_along(q, tangent);
  const Vector3d half = 0.5 * turn;
  return (Eigen::Quaterniond(1.0, half.x(), half.y(), half.z()) * q).normalized();
}

namespace
{
/// Where a node at its md and side is, and how it is turned.
void place(State& state, NodeState& node) noexcept
{
  const WellNode hole = state.well.at(node.md, node.segment);
  node.side = across(hole.tangent, node.side);
  node.position = hole.position + node.side;
  node.orientation = turned_to(hole.tangent, node.orientation);
}
/// What holds a guided node goes with it across the hole: along it and about it the node is held.
void keep_beside(const NodeState& node, const Vector3d& tangent, HeldNode& held) noexcept
{
  held.position = node.position - tangent * tangent.dot(node.position - held.position);
}
}  // namespace

void settle_in_hole(State& state, std::size_t i) noexcept
{
  NodeState& node = state.nodes[i];
  const ClosestPoint closest = state.well.locate(node.position, node.segment);
  node.md = closest.md;
  node.segment = closest.segment;
  node.side = across(closest.tangent, node.position - closest.centre);
  place(state, node);
}

void settle_span(State& state, std::size_t e) noexcept
{
  state.spans[e].twist = twist_between(state.nodes[e + 1].orientation, state.nodes[e].orientation);
}

void settle_guided(State& state) noexcept
{
  for (std::size_t i = 0; i < state.nodes.size(); ++i)
    if (state.nodes[i].guided) settle_in_hole(state, i);
  for (std::size_t e = 0; e < state.spans.size(); ++e)
    if (guided_pair(state, e)) settle_span(state, e);
}

double guided_length(const State& state, std::size_t e) noexcept
{
  const NodeState &lower = state.nodes[e], &upper = state.nodes[e + 1];
  const Vector3d way = (upper.position - upper.side) - (lower.position - lower.side);
  return lower.md - upper.md + (way + upper.side - lower.side).norm() - way.norm();
}

void prepare_guides(const Model& model, Stage& stage)
{
  for (std::size_t i = 0; i < model.mesh().nodes.size(); ++i)
  {
    stage.free[i] = 1.0;
    const MeshNode& mesh = model.mesh().nodes[i];
    const RigidBody body = node_body(model, stage, static_cast<int>(i));
    GuideColumns& g = stage.guides;
    g.mass[i] = body.mass;
    g.spin_inertia[i] = body.spin_inertia;
    g.lever[i] = mesh.friction_radius > 0.0 ? mesh.friction_radius : mesh.bearing_radius;
    g.bearing_radius[i] = mesh.bearing_radius;
    g.mud_along[i] = mesh.mud_along;
    g.mud_about[i] = mesh.mud_about;
    g.set_law(i, model.contact(static_cast<int>(i)));
  }
  for (std::size_t e = 0; e < model.mesh().elements.size(); ++e)
  {
    const BeamSection& section = model.mesh().elements[e].section;
    stage.guides.length[e] = section.length;
    stage.guides.axial[e] = section.axial / section.length;
    stage.guides.torsion[e] = section.torsion;
    stage.guides.bending[e] = section.bending;
  }
}

namespace
{
bool guided_as_before(const State& state, const Stage& stage) noexcept
{
  std::size_t i = 0;
  while (i < state.nodes.size() && state.nodes[i].guided == (stage.guides.guided[i] != 0)) ++i;
  return i == state.nodes.size();
}

/// Which nodes are guided, and the runs of them.
void find_guided(const Model& model, const State& state, Stage& stage) noexcept
{
  const std::size_t n = state.nodes.size();
  for (Runs* runs : {&stage.guided_nodes, &stage.guided_elements, &stage.inner_nodes}) runs->clear();
  bool below = false, here = state.nodes[0].guided;
  for (std::size_t i = 0; i < n; ++i)
  {
    const bool above = i + 1 < n && state.nodes[i + 1].guided;
    const int node = static_cast<int>(i);
    stage.guides.guided[i] = here;
    stage.free[node] = here ? 0.0 : 1.0;
    if (here)
    {
      stage.guided_nodes.add(node);
      if (above) stage.guided_elements.add(node);
      if (below && above && node >= model.mesh().gauge_nodes) stage.inner_nodes.add(node);
    }
    below = here;
    here = above;
  }
  stage.any_guided = !stage.guided_nodes.empty();
}
}  // namespace

void find_guides(const Model& model, const State& state, Stage& stage) noexcept
{
  if (!guided_as_before(state, stage)) find_guided(model, state, stage);
  stage.sides_stay = model.scene().numerics.level == Level::rigid;
  for (const Runs::Run& run : stage.guided_nodes)
  {
    if (stage.guided_step_kernel)
      stage.guided_step_kernel->find(model, state, stage, run);
    else
      find_run(model, state, stage, run);
  }
  put_faults_on_guides(state, stage);
}

bool solve_increment(const Stage& stage, BlockTridiagonal& tangent, double* b) noexcept
{
  reduce(stage, b);
  if (!tangent.solve(b)) return false;
  expand(stage, b);
  return true;
}

void solve_increment_again(const Stage& stage, const BlockTridiagonal& tangent, double* b) noexcept
{
  reduce(stage, b);
  tangent.solve_again(b);
  expand(stage, b);
}

void expand_motion(const Stage& stage, int i, Workspace& work) noexcept
{
  const Vector3d tangent = stage.guides.tangent[i], turn = stage.guides.turn[i];
  const GuidedMotions& m = work.guided;
  NodeMotion& node = work.nodes[static_cast<std::size_t>(i)];
  const auto to_six = [&](double along, double about, Vector6d& out) { out << along * tangent, along * turn + about * tangent; };
  node.axis = tangent;
  node.spin = m.about[i];
  node.carried_spin = m.about_rate[i];
  node.tilt = m.along[i] * turn;
  node.normal = tangent + node.tilt.cross(tangent);
  to_six(m.along[i], m.about[i], node.increment);
  to_six(m.along_rate[i], m.about_rate[i], node.rate);
  to_six(m.along_acceleration[i], m.about_acceleration[i], node.acceleration);
}

void expand_motions(const Stage& stage, Workspace& work) noexcept
{
  if (!stage.any_guided) return;
  const auto expand_one = [&](std::size_t i)
  {
    if (stage.guides.guided[i] && !work.motion_known[i]) expand_motion(stage, static_cast<int>(i), work);
  };
  if (!stage.guided_kernel)
  {
    for (std::size_t i = 0; i < work.nodes.size(); ++i) expand_one(i);
    return;
  }
  each_clear_run(
      stage.inner_nodes, [&](int i) { return work.motion_known[static_cast<std::size_t>(i)] != 0; },
      [&](Runs::Run run) { stage.guided_kernel->expand_motions(stage, work, run); });
  each_outside(stage.inner_nodes, static_cast<int>(work.nodes.size()), [&](int i) { expand_one(static_cast<std::size_t>(i)); });
}

namespace
{
void commit_node(const Stage& stage, const Workspace& work, double follows, std::size_t i, State& state) noexcept
{
  const Guide guide = stage.guides[i];
  NodeState& node = state.nodes[i];
  const GuidedMotions& m = work.guided;
  const Vector3d load = climbed(guide.tangent, m.lean[i], m.around[i]);
  node.side += follows * ((guide.clearance / (pressed + load.norm())) * load - node.side);
  node.md += m.along[i];
  node.spin_angle += m.about[i];
  node.rate = {m.along_rate[i] * guide.tangent, m.along_rate[i] * guide.turn, m.about_rate[i]};
  node.orientation = rotation_from_vector(m.about[i] * guide.tangent) * node.orientation;
  place(state, node);
  for (HeldNode* held : {&state.stuck_point, &state.slips})
    if (static_cast<int>(i) == held->node) keep_beside(node, x_axis(node.orientation), *held);
}
}  // namespace

void commit_guided(const Stage& stage, const Workspace& work, State& state) noexcept
{
  if (!stage.any_guided) return;
  const double follows = stage.sides_stay ? 0.0 : stage.time > 0.0 ? -std::expm1(-stage.time / kSettles) : kAtOnce;
  const auto commit_one = [&](int i)
  {
    if (stage.guides.guided[static_cast<std::size_t>(i)]) commit_node(stage, work, follows, static_cast<std::size_t>(i), state);
  };
  if (stage.guided_step_kernel)
  {
    for (const Runs::Run& run : stage.inner_nodes) stage.guided_step_kernel->commit(stage, work, follows, run, state);
    each_outside(stage.inner_nodes, static_cast<int>(state.nodes.size()), commit_one);
  }
  else
    for (int i = 0; i < static_cast<int>(state.nodes.size()); ++i) commit_one(i);
  for (const Runs::Run& run : stage.guided_elements)
    for (std::size_t e = static_cast<std::size_t>(run.first); e < static_cast<std::size_t>(run.last); ++e)
      state.spans[e].twist += work.guided.about[e] - work.guided.about[e + 1];
}

}  // namespace drill_rig_sim
