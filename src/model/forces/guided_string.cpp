// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/model/forces/guided_string.h"

#include <algorithm>
#include <cmath>

#include "drill_rig_sim/contact/one_lane_friction.h"
#include "drill_rig_sim/model/clear_runs.h"
#include "drill_rig_sim/model/forces/beams.h"
#include "drill_rig_sim/model/forces/bit.h"
#include "drill_rig_sim/model/kernels/guided_kernel.h"

namespace drill_rig_sim::one_lane
{
#include "drill_rig_sim/model/forces/guided_text.h"
}  // namespace drill_rig_sim::one_lane

namespace drill_rig_sim
{
using Eigen::Matrix2d;
using Eigen::Vector2d;
using Eigen::Vector3d;
using TwoBySix = Eigen::Matrix<double, 2, 6>;
using SixByTwo = Eigen::Matrix<double, 6, 2>;

namespace
{
using one_lane::V2;
using one_lane::V3;

bool guided(const StageContext& at, int i) noexcept
{
  return at.stage.guides.guided[static_cast<std::size_t>(i)] != 0;
}

Guide guide_of(const StageContext& at, int i) noexcept
{
  return at.stage.guides[static_cast<std::size_t>(i)];
}

/// Whether element e is there, and between two guided nodes.
bool spans(const StageContext& at, int e) noexcept
{
  return e >= 0 && e < at.model.elements() && at.stage.guides.spans(static_cast<std::size_t>(e));
}

bool gauge(const StageContext& at, int i) noexcept
{
  return i < at.model.mesh().gauge_nodes;
}

/// Other forces have acted on a guided node, in six coordinates.
bool acted_on(const StageContext& at, int i) noexcept
{
  return at.work.rows_open[static_cast<std::size_t>(i)] != 0;
}

/// T: what a node's coordinates do to its six.
SixByTwo motions(const Guide& guide) noexcept
{
  SixByTwo t;
  t << guide.tangent, Vector3d::Zero(), guide.turn, guide.tangent;
  return t;
}

one_lane::GuidedElement element_of(const StageContext& at, int e) noexcept
{
  const GuidedSpan span = at.stage.guides.span(static_cast<std::size_t>(e));
  return {span.axial, span.torsion, span.stretch, span.twist};
}

V2 elastic(const StageContext& at, int e) noexcept
{
  const GuidedMotions& m = at.work.guided;
  return guided_elastic(element_of(at, e), V2{m.along[e] - m.along[e + 1], m.about[e] - m.about[e + 1]});
}

/// What structural damping adds.
V2 damping(const StageContext& at, int e) noexcept
{
  const GuidedMotions& m = at.work.guided;
  const V2 closing{m.along_rate[e] - m.along_rate[e + 1], m.about_rate[e] - m.about_rate[e + 1]};
  return guided_damping(element_of(at, e), at.stage.structural_damping, closing);
}

/// Of guided elements, into the workspace.
void find_tensions(const StageContext& at, Runs::Run run) noexcept
{
  if (at.stage.guided_kernel) return at.stage.guided_kernel->find_tensions(at, run);
  for (int e = run.first; e < run.last; ++e)
  {
    const V2 force = elastic(at, e) + damping(at, e);
    at.work.guided.tension[e] = force.x;
    at.work.guided.torque[e] = force.y;
  }
}

void find_tensions(const StageContext& at) noexcept
{
  for (const Runs::Run& run : at.stage.guided_elements) find_tensions(at, run);
}

/// Tension and torque of an element; none where there is no guided one.
V2 force_of(const StageContext& at, int e) noexcept
{
  return spans(at, e) ? V2{at.work.guided.tension[e], at.work.guided.torque[e]} : V2{0.0, 0.0};
}

/// EA/L and GJ/L, damping included.
V2 stiffness_of(const StageContext& at, int e) noexcept
{
  const double damped = 1.0 + at.stage.dv_du * at.stage.structural_damping;
  return spans(at, e) ? V2{damped * at.stage.guides.axial[e], damped * at.stage.guides.torsion[e]} : V2{0.0, 0.0};
}

V3 direction_of(const StageContext& at, int e) noexcept
{
  return one_lane::from(at.stage.guides.direction[e]);
}

Vector3d across(const Guide& guide, const Vector3d& v) noexcept
{
  return v - guide.tangent * guide.tangent.dot(v);
}

/// What guided neighbours, weight and the bit's weight push a node to its wall with.
Vector3d lean_of(const StageContext& at, int i) noexcept
{
  const Guide guide = guide_of(at, i);
  Vector3d weight = guide.weight;
  if (i == 0) weight.z() -= bit_weight(at);
  return to_eigen(guided_push(one_lane::from(guide.tangent), force_of(at, i).x, direction_of(at, i), force_of(at, i - 1).x,
                              direction_of(at, i - 1), one_lane::from(weight)));
}

using Load = one_lane::GuidedLoad;

Load load_of(const Guide& guide, const Vector3d& push) noexcept
{
  return one_lane::guided_load(one_lane::from(push), guide.friction, guide.held);
}

/// Friction at a node, at the rim.
struct NodeFriction
{
  V2 force, bristle;
  one_lane::GuidedSlopes slopes;
  double normal;  ///< [N]
  bool sticks;
};

constexpr V2 none{0.0, 0.0};

/// Of a gauge, which turns with the motor, too.
NodeFriction sticking_friction(const StageContext& at, int i, const Load& load) noexcept
{
  const Guide guide = guide_of(at, i);
  const GuidedMotions& m = at.work.guided;
  const bool turns = gauge(at, i);
  const double about = m.about[i] + (turns ? at.stage.bit.motor_turn : 0.0);
  const double about_rate = m.about_rate[i] + (turns ? at.stage.bit.motor_speed : 0.0);
  const bool exponential = at.model.scene().contact.stribeck_curve == StribeckCurve::exponential;
  const one_lane::Rubbing law{guide.friction,  guide.static_ratio, guide.stribeck_speed,
                              guide.stiffness, guide.damping,      exponential};
  const one_lane::GuidedFriction f =
      guided_friction(law, load.normal, one_lane::from(at.stage.guides.bristle[i]), V2{m.along[i], guide.lever * about},
                      V2{m.along_rate[i], guide.lever * about_rate}, at.stage.time);
  return {f.rubbed.force, f.rubbed.bristle, guided_slopes(law, load, f, at.stage.dv_du), load.normal, f.sticks};
}

NodeFriction sliding_friction(const StageContext& at, int i, const Load& load) noexcept
{
  const Guide guide = guide_of(at, i);
  const SlidingMotion& sliding = at.stage.sliding;
  const V2 motion{sliding.axial_speed, sliding.spin_speed * guide.lever};
  const double speed = norm(motion);
  if (!(speed > 0.0)) return {none, none, {none, none, none}, load.size, guide.friction > 0.0 && load.size > 0.0};
  const V2 mu = (sliding.share * guide.friction / speed) * motion;
  const double climbs = 1.0 / std::sqrt(1.0 + mu.y * mu.y);
  const V2 by_load = -climbs * mu;
  return {load.size * by_load, none, {none, none, by_load}, climbs * load.size, false};
}

using FrictionAtNode = NodeFriction (*)(const StageContext&, int, const Load&) noexcept;

/// The small blocks of row i but for what other forces gave in six coordinates. `by_load`: of the row by the load on the wall.
void write_small_rows(const StageContext& at, int i, const Load& load, const NodeFriction& friction, const V2& by_load,
                      BlockTridiagonal& tangent) noexcept
{
  const Guide guide = guide_of(at, i);
  const one_lane::GuidedNode node{guide.mass, guide.spin_inertia, guide.mud_along, guide.mud_about};
  const one_lane::GuidedBlocks k = guided_blocks(
      node, friction.slopes, guide.lever, stiffness_of(at, i), stiffness_of(at, i - 1), dot(load.direction, direction_of(at, i)),
      dot(load.direction, direction_of(at, i - 1)), by_load, at.stage.dv_du, at.stage.da_du);
  const auto put = [](const V2& first, const V2& second, BlockTridiagonal::SmallBlock to)
  { to << first.x, first.y, second.x, second.y; };
  put(k.own_first, k.own_second, tangent.small_diagonal(i));
  if (spans(at, i)) put(k.upper_first, k.upper_second, tangent.small_upper(i));
  if (spans(at, i - 1)) put(k.lower_first, k.lower_second, tangent.small_lower(i - 1));
}

/// What other forces gave in six coordinates, brought down to two. `by_load`: of the row by the load on the wall, which the six
/// coordinates' force across the hole makes.
void reduce_rows(const StageContext& at, int i, const Load& load, const V2& by_load, BlockTridiagonal& tangent) noexcept
{
  const SixByTwo t = motions(guide_of(at, i));
  TwoBySix rows = t.transpose();
  rows.leftCols<3>() -= to_eigen(by_load) * to_eigen(load.direction).transpose();
  tangent.small_diagonal(i) += rows * tangent.diagonal(i) * t;
  const auto reduce_off = [&](BlockTridiagonal::Block in_row, BlockTridiagonal::Block in_column)
  {
    const TwoBySix reduced = rows * in_row;
    const SixByTwo other = in_column * t;
    in_row.setZero();
    in_row.topRows<2>() = reduced;
    in_column.setZero();
    in_column.leftCols<2>() = other;
  };
  if (i < at.model.top() && !guided(at, i + 1)) reduce_off(tangent.upper(i), tangent.lower(i));
  if (i > 0 && !guided(at, i - 1)) reduce_off(tangent.lower(i - 1), tangent.upper(i - 1));
}

void write_results(const StageContext& at, int i, const NodeFriction& friction) noexcept
{
  StageResult& result = at.work.result;
  GuidedMotions& m = at.work.guided;
  result.bristle[i] << friction.bristle.x, friction.bristle.y, 0.0;
  result.rest[i] = friction.sticks ? at.stage.guides.rest[i] + at.stage.time : 0.0;
  result.forces.contact[i] = friction.normal;
  result.forces.wall[i] = friction.force.x * at.stage.guides.tangent[i] - m.push[i];
  m.around[i] = friction.force.y;
}

template <FrictionAtNode friction_at>
void add_at(const StageContext& at, int i, const ForceRows& to) noexcept
{
  const Guide guide = guide_of(at, i);
  GuidedMotions& m = at.work.guided;
  auto r = at_node(to.residual(), i);
  Vector3d push = lean_of(at, i);
  m.lean.set(i, push);
  const bool others_act = acted_on(at, i);
  const Vector2d others = others_act ? Vector2d(motions(guide).transpose() * r) : Vector2d(0.0, 0.0);
  // a gauge's friction loads the motor before all forces are there
  if (others_act && !gauge(at, i)) push -= across(guide, r.head<3>());
  m.push.set(i, push);
  const Load load = load_of(guide, push);
  const NodeFriction friction = friction_at(at, i, load);
  const one_lane::GuidedNode node{guide.mass, guide.spin_inertia, guide.mud_along, guide.mud_about};
  const V2 rate{m.along_rate[i], m.about_rate[i]}, acceleration{m.along_acceleration[i], m.about_acceleration[i]};
  const V2 row = one_lane::from(others) + guided_row(node, rate, acceleration, force_of(at, i), force_of(at, i - 1),
                                                     guide.tangent.dot(guide.weight), friction.force, guide.lever);
  r.head<3>() = row.x * guide.tangent;
  r.tail<3>() = row.y * guide.tangent;
  write_results(at, i, friction);
  if (!to.with_tangent()) return;
  const V2 by_load{-friction.slopes.by_load.x, -guide.lever * friction.slopes.by_load.y};
  write_small_rows(at, i, load, friction, by_load, *to.tangent());
  if (others_act) reduce_rows(at, i, load, gauge(at, i) ? none : by_load, *to.tangent());
}

template <FrictionAtNode friction_at>
void add_guided_string(const StageContext& at, const ForceRows& to) noexcept
{
  if (!at.stage.any_guided) return;
  find_tensions(at);
  for (const Runs::Run& run : at.stage.guided_nodes)
    for (int i = run.first; i < run.last; ++i) add_at<friction_at>(at, i, to);
}

/// Calls batch(run) for runs of inner nodes that no other force has acted on, and node(i) for all other guided nodes behind them.
template <class Batch, class Node>
void each_inner_run(const StageContext& at, const Batch& batch, const Node& node)
{
  each_clear_run(
      at.stage.inner_nodes, [&](int i) { return acted_on(at, i); }, batch);
  for (const Runs::Run& run : at.stage.inner_nodes)
    for (int i = run.first; i < run.last; ++i)
      if (acted_on(at, i)) node(i);
  each_outside(at.stage.inner_nodes, at.model.nodes(),
               [&](int i)
               {
                 if (guided(at, i)) node(i);
               });
}

/// Nodes that only the guided string acts on by the batch kernel, then the others: they are beside what it writes too much.
void add_sticking(const StageContext& at, const ForceRows& to) noexcept
{
  if (!at.stage.guided_kernel) return add_guided_string<sticking_friction>(at, to);
  if (!at.stage.any_guided) return;
  find_tensions(at);
  GuidedRows rows{to.residual(), nullptr, nullptr, nullptr};
  if (BlockTridiagonal* tangent = to.tangent())
    rows = {to.residual(), tangent->small_diagonal(0).data(), tangent->small_upper(0).data(), tangent->small_lower(0).data()};
  each_inner_run(
      at, [&](Runs::Run run) { at.stage.guided_kernel->add(at, run, rows); },
      [&](int i) { add_at<sticking_friction>(at, i, to); });
}

void store_guided_string(const StageContext& at, StoredEnergy& energy) noexcept
{
  if (!at.stage.any_guided) return;
  for (int e = 0; e < at.model.elements(); ++e)
  {
    if (!spans(at, e)) continue;
    const V2 force = elastic(at, e);
    energy.beams += 0.5 * (force.x * force.x / at.stage.guides.axial[e] + force.y * force.y / at.stage.guides.torsion[e]);
  }
  const GuidedMotions& m = at.work.guided;
  for (int i = 0; i < at.model.nodes(); ++i)
  {
    if (!guided(at, i)) continue;
    const Guide guide = guide_of(at, i);
    energy.kinetic += 0.5 * guide.mass * m.along_rate[i] * m.along_rate[i];
    energy.turning += 0.5 * guide.spin_inertia * m.about_rate[i] * m.about_rate[i];
    energy.bristles += 0.5 * guide.stiffness * at.work.result.bristle[i].squaredNorm();
    energy.weight -= guide.weight.dot(at.start.nodes[i].position + m.along[i] * guide.tangent);
  }
}

void add_to(EnergySample& sample, NodeForce kind, int i, const Guide& guide, const V2& force) noexcept
{
  auto at = at_node(sample, kind, i);
  at.head<3>() += force.x * guide.tangent;
  at.tail<3>() += force.y * guide.tangent;
}

void sample_guided_string(const StageContext& at, EnergySample& sample) noexcept
{
  if (!at.stage.any_guided) return;
  for (int e = 0; e < at.model.elements(); ++e)
  {
    if (!spans(at, e)) continue;
    const Guide lower = guide_of(at, e), upper = guide_of(at, e + 1);
    const V2 held = elastic(at, e), damped = damping(at, e);
    add_to(sample, NodeForce::beams, e, lower, held);
    add_to(sample, NodeForce::beams, e + 1, upper, -held);
    add_to(sample, NodeForce::structural, e, lower, damped);
    add_to(sample, NodeForce::structural, e + 1, upper, -damped);
  }
  const GuidedMotions& m = at.work.guided;
  for (int i = 0; i < at.model.nodes(); ++i)
  {
    if (!guided(at, i)) continue;
    const Guide guide = guide_of(at, i);
    const one_lane::GuidedNode node{guide.mass, guide.spin_inertia, guide.mud_along, guide.mud_about};
    // the friction of the wall as add() has left it: along the pipe what of the wall's force is not across it
    const V2 friction{guide.tangent.dot(at.work.result.forces.wall[i] + m.push[i]), guide.lever * m.around[i]};
    add_to(sample, NodeForce::inertia, i, guide, guided_inertia(node, V2{m.along_acceleration[i], m.about_acceleration[i]}));
    add_to(sample, NodeForce::mud, i, guide, guided_mud(node, V2{m.along_rate[i], m.about_rate[i]}));
    add_to(sample, NodeForce::friction, i, guide, -friction);
    if (gauge(at, i)) sample.gauge_torque -= friction.y;
  }
}

void add_gauge(const StageContext& at, const ForceRows&) noexcept
{
  if (!at.stage.any_guided || !guided(at, 0)) return;
  if (!at.stage.guided_elements.empty())
  {
    const Runs::Run run = *at.stage.guided_elements.begin();
    find_tensions(at, {run.first, std::min(run.last, at.model.mesh().gauge_nodes)});
  }
  for (int i = 0; gauge(at, i); ++i)
  {
    if (!guided(at, i)) continue;
    const Guide guide = guide_of(at, i);
    const NodeFriction friction = sticking_friction(at, i, load_of(guide, lean_of(at, i)));
    at.work.result.forces.bit_moment += (guide.lever * friction.force.y) * guide.tangent;
  }
}

}  // namespace

const Force guided_string = {
    "guided string", Cost::guided,        Sum::none,           add_sticking, add_guided_string<sliding_friction>,
    add_sticking,    store_guided_string, sample_guided_string};
const Force guided_gauge = {"guided gauge", Cost::guided, Sum::none, add_gauge, nullptr, add_gauge, nullptr, nullptr};

}  // namespace drill_rig_sim
