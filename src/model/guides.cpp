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

/// The part across a guide's hole of the direction to another's, `way` from it.
Vector3d direction_across(const Guide& from, const Vector3d& way, double distance) noexcept
{
  return across(from.tangent, way / distance);
}

void find_guide(const Model& model, const State& state, const Stage& stage, std::size_t i, Guide& guide) noexcept
{
  const NodeState& node = state.nodes[i];
  const MeshNode& mesh = model.mesh().nodes[i];
  const HoleWall hole = state.well.wall_at(node.md, node.segment);
  guide.tangent = x_axis(node.orientation);
  guide.centre = node.position - node.side;
  guide.weight = guide.above = guide.below = guide.turn = Vector3d::Zero();
  guide.friction = node.md > 0.0 ? hole.friction : 0.0;
  guide.clearance = node.md > 0.0 ? std::max(0.0, hole.radius - mesh.bearing_radius) : 0.0;
  guide.law = model.contact(static_cast<int>(i), hole.section, node.rest);
  guide.held = guide.law.tangential_stiffness * node.bristle.y();
  guide.mud_along = stage.immersed[i] * mesh.mud_along;
  guide.mud_about = stage.immersed[i] * mesh.mud_about;
}

void find_span(const Model& model, const State& state, const Stage& stage, std::size_t e, Guide& lower, Guide& upper, GuidedSpan& span) noexcept
{
  const BeamSection& section = model.mesh().elements[e].section;
  const NodeState &below = state.nodes[e], &above = state.nodes[e + 1];
  const Vector3d way = upper.centre - lower.centre;
  const double chord = way.norm(), axis = below.md - above.md;
  span.stretch = axis + (way + above.side - below.side).norm() - chord - section.length * (1.0 + stage.free_stretch[e]);
  span.twist = state.spans[e].twist;
  upper.turn = lower.turn = lower.tangent.cross(lower.tangent - upper.tangent) / axis;
  lower.above = direction_across(lower, way, chord);
  upper.below = direction_across(upper, -way, chord);
  lower.weight += 0.5 * stage.load[e];
  upper.weight += 0.5 * stage.load[e];
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
  for (std::size_t i = first; i < last; ++i) find_guide(model, state, stage, i, stage.guides[i]);
  for (std::size_t e = first; e + 1 < last; ++e) find_span(model, state, stage, e, stage.guides[e], stage.guides[e + 1], stage.guided_spans[e]);
}

void reduce(const Stage& stage, double* b) noexcept
{
  each_guided(stage, [&](const GuidedKernel& by, Runs::Run run) { by.reduce(stage, run, b); }, [&](int i)
  {
    const Guide& guide = stage.guides[static_cast<std::size_t>(i)];
    double* at = b + 6 * i;
    const double along = guide.tangent.dot(Eigen::Map<const Vector3d>(at)), about = guide.tangent.dot(Eigen::Map<const Vector3d>(at + 3));
    at[0] = along;
    at[1] = about;
    at[2] = at[3] = at[4] = at[5] = 0.0;
  });
}

void expand(const Stage& stage, double* b) noexcept
{
  each_guided(stage, [&](const GuidedKernel& by, Runs::Run run) { by.expand(stage, run, b); }, [&](int i)
  {
    const Guide& guide = stage.guides[static_cast<std::size_t>(i)];
    double* at = b + 6 * i;
    const double along = at[0], about = at[1];
    Eigen::Map<Vector3d> place{at};
    place = along * guide.tangent;
    Eigen::Map<Vector3d>(at + 3) = along * guide.turn + about * guide.tangent;
  });
}

/// The load turned by how far friction `around` the pipe [N] makes it climb: the wall's normal force N and F balance P on the side n = (N P + F t x P)/Q^2.
Vector3d climbed(const Guide& guide, const Vector3d& push, double around) noexcept
{
  const double square = push.squaredNorm();
  if (!(square > around * around)) return push;
  return (std::sqrt(square - around * around) * push + around * guide.tangent.cross(push)) / std::sqrt(square);
}

}  // namespace

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
  for (std::size_t i = 0; i < stage.guides.size(); ++i)
  {
    const MeshNode& mesh = model.mesh().nodes[i];
    const RigidBody body = node_body(model, stage, static_cast<int>(i));
    Guide& guide = stage.guides[i];
    guide.mass = body.mass;
    guide.spin_inertia = body.spin_inertia;
    guide.lever = mesh.friction_radius > 0.0 ? mesh.friction_radius : mesh.bearing_radius;
    guide.law = model.contact(static_cast<int>(i));
    NumberColumns& columns = stage.guided_columns;
    columns[guide_column::bearing_radius][i + 1] = mesh.bearing_radius;
    columns[guide_column::mud_along][i + 1] = mesh.mud_along;
    columns[guide_column::mud_about][i + 1] = mesh.mud_about;
  }
  for (std::size_t e = 0; e < stage.guided_spans.size(); ++e)
  {
    const BeamSection& section = model.mesh().elements[e].section;
    stage.guided_spans[e].axial = section.axial / section.length;
    stage.guided_spans[e].torsion = section.torsion;
    stage.guided_columns[guide_column::length][e + 1] = section.length;
  }
}

void find_guides(const Model& model, const State& state, Stage& stage) noexcept
{
  const std::size_t n = state.nodes.size();
  for (Runs* runs : {&stage.guided_nodes, &stage.guided_elements, &stage.inner_nodes}) runs->clear();
  stage.sides_stay = model.scene().numerics.level == Level::rigid;
  bool below = false, here = state.nodes[0].guided;
  for (std::size_t i = 0; i < n; ++i)
  {
    const bool above = i + 1 < n && state.nodes[i + 1].guided;
    const int node = static_cast<int>(i);
    Guide& guide = stage.guides[i];
    guide.guided = here;
    if (i + 1 < n) stage.guided_spans[i].guided = here && above;
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

void expand_motions(const Stage& stage, Workspace& work) noexcept
{
  if (!stage.any_guided) return;
  const auto expand_one = [&](std::size_t i)
  {
    if (stage.guides[i].guided && !work.motion_known[i]) expand_motion(stage.guides[i], work.guided[i], work.nodes[i]);
  };
  if (!stage.guided_kernel)
  {
    for (std::size_t i = 0; i < stage.guides.size(); ++i) expand_one(i);
    return;
  }
  each_clear_run(stage.inner_nodes, [&](int i) { return work.motion_known[static_cast<std::size_t>(i)] != 0; },
                 [&](Runs::Run run) { stage.guided_kernel->expand_motions(stage, work, run); });
  each_outside(stage.inner_nodes, static_cast<int>(stage.guides.size()), [&](int i) { expand_one(static_cast<std::size_t>(i)); });
}

namespace
{
void commit_node(const Stage& stage, const Workspace& work, double follows, std::size_t i, State& state) noexcept
{
  const Guide& guide = stage.guides[i];
  NodeState& node = state.nodes[i];
  const GuidedMotion& motion = work.guided[i];
  const Vector3d load = climbed(guide, motion.lean, motion.around);
  node.side += follows * ((guide.clearance / (pressed + load.norm())) * load - node.side);
  node.md += motion.along;
  node.spin_angle += motion.about;
  node.rate = {motion.along_rate * guide.tangent, motion.along_rate * guide.turn, motion.about_rate};
  node.orientation = rotation_from_vector(motion.about * guide.tangent) * node.orientation;
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
    if (stage.guides[static_cast<std::size_t>(i)].guided) commit_node(stage, work, follows, static_cast<std::size_t>(i), state);
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
      state.spans[e].twist += work.guided[e].about - work.guided[e + 1].about;
}

}  // namespace drill_rig_sim
