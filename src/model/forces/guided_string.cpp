#include "drill_rig_sim/model/forces/guided_string.h"

#include <algorithm>
#include <cmath>

#include "drill_rig_sim/contact/surface_friction.h"
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
using Rows = Eigen::Matrix<double, 2, 6>;
using Columns = Eigen::Matrix<double, 6, 2>;

namespace
{
const Guide& guide_of(const StageContext& at, int i) noexcept
{
  return at.stage.guides[static_cast<std::size_t>(i)];
}

const GuidedSpan& span_of(const StageContext& at, int e) noexcept
{
  return at.stage.guided_spans[static_cast<std::size_t>(e)];
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
Columns motions(const Guide& guide) noexcept
{
  Columns t;
  t << guide.tangent, Vector3d::Zero(), guide.turn, guide.tangent;
  return t;
}

/// Elastic part, and what structural damping adds.
GuidedForce elastic(const StageContext& at, int e) noexcept
{
  const GuidedSpan& span = span_of(at, e);
  const GuidedMotion &lower = at.work.guided[e], &upper = at.work.guided[e + 1];
  return {span.axial * (span.stretch + lower.along - upper.along), span.torsion * (span.twist + lower.about - upper.about)};
}

GuidedForce damping(const StageContext& at, int e) noexcept
{
  const GuidedSpan& span = span_of(at, e);
  const GuidedMotion &lower = at.work.guided[e], &upper = at.work.guided[e + 1];
  const double c = at.stage.structural_damping;
  return {c * span.axial * (lower.along_rate - upper.along_rate), c * span.torsion * (lower.about_rate - upper.about_rate)};
}

/// Of guided elements, into the workspace.
void find_tensions(const StageContext& at, Runs::Run run) noexcept
{
  if (at.stage.guided_kernel) return at.stage.guided_kernel->find_tensions(at, run);
  for (int e = run.first; e < run.last; ++e)
  {
    const GuidedForce held = elastic(at, e), damped = damping(at, e);
    at.work.guided_forces[static_cast<std::size_t>(e)] = {held.tension + damped.tension, held.torque + damped.torque};
  }
}

void find_tensions(const StageContext& at) noexcept
{
  for (const Runs::Run& run : at.stage.guided_elements) find_tensions(at, run);
}

/// Of the elements that end in a node.
struct Ends
{
  GuidedForce above, below;
};

Ends ends_of(const StageContext& at, int i) noexcept
{
  Ends ends;
  if (i < at.model.top() && span_of(at, i).guided) ends.above = at.work.guided_forces[static_cast<std::size_t>(i)];
  if (i > 0 && span_of(at, i - 1).guided) ends.below = at.work.guided_forces[static_cast<std::size_t>(i - 1)];
  return ends;
}

Vector3d across(const Guide& guide, const Vector3d& v) noexcept
{
  return v - guide.tangent * guide.tangent.dot(v);
}

/// What guided neighbours, weight and the bit's weight push a node to its wall with.
Vector3d lean_of(const StageContext& at, int i, const Ends& ends) noexcept
{
  const Guide& guide = guide_of(at, i);
  Vector3d push = ends.above.tension * guide.above + ends.below.tension * guide.below + guide.weight;
  if (i == 0) push.z() -= bit_weight(at);
  return across(guide, push);
}

using Load = one_lane::GuidedLoad;

Load load_of(const Guide& guide, const Vector3d& push) noexcept
{
  return one_lane::guided_load(one_lane::from(push), guide.friction, guide.held);
}

/// Friction at a node, at the rim, with its slopes by the rim's displacement and by Q.
struct NodeFriction
{
  Vector2d force = Vector2d::Zero();  ///< wall on string [N]
  Vector2d bristle = Vector2d::Zero();
  Matrix2d by_displacement = Matrix2d::Zero();
  Vector2d by_load = Vector2d::Zero();
  double normal = 0.0;  ///< [N]
  bool slipping = false;
};

SurfaceMotion surface_motion(const StageContext& at, int i) noexcept
{
  const GuidedMotion& motion = at.work.guided[i];
  const double lever = guide_of(at, i).lever;
  const bool turns = gauge(at, i);  // with the motor
  const double about = motion.about + (turns ? at.stage.bit.motor_turn : 0.0), about_rate = motion.about_rate + (turns ? at.stage.bit.motor_speed : 0.0);
  return {Vector2d(motion.along, lever * about), Vector2d(motion.along_rate, lever * about_rate), at.stage.dv_du, at.stage.time};
}

NodeFriction sticking_friction(const StageContext& at, int i, const Load& load, bool slopes) noexcept
{
  NodeFriction out;
  out.normal = load.normal;
  const Guide& guide = guide_of(at, i);
  if (!(load.normal > 0.0) || !(guide.friction > 0.0)) return out;
  SurfaceSlopes slope;
  const SurfaceFriction f = surface_friction(load.normal, guide.friction, surface_motion(at, i), at.start.nodes[i].bristle.head<2>(), guide.law, slopes ? &slope : nullptr);
  out.force = f.force;
  out.bristle = f.bristle;
  out.slipping = f.slipping;
  if (!slopes) return out;
  out.by_displacement = slope.by_displacement;
  out.by_load = load.normal_by_size * slope.by_normal_force;
  return out;
}

NodeFriction sliding_friction(const StageContext& at, int i, const Load& load, bool) noexcept
{
  NodeFriction out;
  out.normal = load.size;
  const Guide& guide = guide_of(at, i);
  const SlidingMotion& sliding = at.stage.sliding;
  const Vector2d motion(sliding.axial_speed, sliding.spin_speed * guide.lever);
  const double speed = motion.norm();
  if (!(speed > 0.0)) return out;
  const Vector2d mu = sliding.share * guide.friction / speed * motion;
  const double climbs = 1.0 / std::sqrt(1.0 + mu.y() * mu.y());
  out.normal = climbs * load.size;
  out.by_load = -climbs * mu;
  out.force = load.size * out.by_load;
  out.slipping = true;
  return out;
}

using FrictionAtNode = NodeFriction (*)(const StageContext&, int, const Load&, bool slopes) noexcept;

/// The small blocks of row i but for what other forces gave in six coordinates. `by_load`: of the row by the load on the wall.
void write_small_rows(const StageContext& at, int i, const Load& load, const NodeFriction& friction, const Vector2d& by_load, BlockTridiagonal& tangent) noexcept
{
  const Guide& guide = guide_of(at, i);
  const double c = at.stage.dv_du, damped = 1.0 + c * at.stage.structural_damping, lever = guide.lever;
  const Matrix2d& f = friction.by_displacement;
  const Vector3d direction = one_lane::to_eigen(load.direction);
  Matrix2d diagonal;
  diagonal << at.stage.da_du * guide.mass + c * guide.mud_along - f(0, 0), -lever * f(0, 1),  //
      -lever * f(1, 0), at.stage.da_du * guide.spin_inertia + c * guide.mud_about - lever * lever * f(1, 1);
  if (i < at.model.top() && span_of(at, i).guided)
  {
    const double axial = damped * span_of(at, i).axial, torsion = damped * span_of(at, i).torsion;
    const Vector2d by_stretch = (direction.dot(guide.above) * axial) * by_load;
    diagonal(0, 0) += axial + by_stretch.x();
    diagonal(1, 0) += by_stretch.y();
    diagonal(1, 1) += torsion;
    tangent.small_upper(i) << -axial - by_stretch.x(), 0.0, -by_stretch.y(), -torsion;
  }
  if (i > 0 && span_of(at, i - 1).guided)
  {
    const double axial = damped * span_of(at, i - 1).axial, torsion = damped * span_of(at, i - 1).torsion;
    const Vector2d by_stretch = (direction.dot(guide.below) * axial) * by_load;
    diagonal(0, 0) += axial - by_stretch.x();
    diagonal(1, 0) -= by_stretch.y();
    diagonal(1, 1) += torsion;
    tangent.small_lower(i - 1) << -axial + by_stretch.x(), 0.0, by_stretch.y(), -torsion;
  }
  tangent.small_diagonal(i) = diagonal;
}

/// What other forces gave in six coordinates, brought down to two. `by_load`: of the row by the load on the wall, which the six coordinates' force across
/// the hole makes.
void reduce_rows(const StageContext& at, int i, const Load& load, const Vector2d& by_load, BlockTridiagonal& tangent) noexcept
{
  const Columns t = motions(guide_of(at, i));
  Rows rows = t.transpose();
  rows.leftCols<3>() -= by_load * one_lane::to_eigen(load.direction).transpose();
  tangent.small_diagonal(i) += rows * tangent.diagonal(i) * t;
  const auto reduce_off = [&](BlockTridiagonal::Block in_row, BlockTridiagonal::Block in_column)
  {
    const Rows reduced = rows * in_row;
    const Columns other = in_column * t;
    in_row.setZero();
    in_row.topRows<2>() = reduced;
    in_column.setZero();
    in_column.leftCols<2>() = other;
  };
  if (i < at.model.top() && !guide_of(at, i + 1).guided) reduce_off(tangent.upper(i), tangent.lower(i));
  if (i > 0 && !guide_of(at, i - 1).guided) reduce_off(tangent.lower(i - 1), tangent.upper(i - 1));
}

void write_results(const StageContext& at, int i, const NodeFriction& friction) noexcept
{
  const Guide& guide = guide_of(at, i);
  StageResult& result = at.work.result;
  GuidedMotion& motion = at.work.guided[i];
  result.bristle[i] << friction.bristle, 0.0;
  result.rest[i] = friction.normal > 0.0 && guide.friction > 0.0 && !friction.slipping ? at.start.nodes[i].rest + at.stage.time : 0.0;
  result.forces.contact[i] = friction.normal;
  result.forces.wall[i] = friction.force.x() * guide.tangent - motion.push;
  motion.around = friction.force.y();
}

template <FrictionAtNode friction_at>
void add_at(const StageContext& at, int i, const ForceRows& to) noexcept
{
  const Guide& guide = guide_of(at, i);
  GuidedMotion& motion = at.work.guided[i];
  auto r = at_node(to.residual(), i);
  const Ends ends = ends_of(at, i);
  double along = ends.above.tension - ends.below.tension + guide.mass * motion.along_acceleration + guide.mud_along * motion.along_rate -
                 guide.tangent.dot(guide.weight);
  double about = ends.above.torque - ends.below.torque + guide.spin_inertia * motion.about_acceleration + guide.mud_about * motion.about_rate;
  motion.push = motion.lean = lean_of(at, i, ends);
  const bool others_act = acted_on(at, i);
  if (others_act)
  {
    const Vector2d others = motions(guide).transpose() * r;
    along += others.x();
    about += others.y();
    if (!gauge(at, i)) motion.push -= across(guide, r.head<3>());  // its friction loads the motor before all forces are there
  }
  const Load load = load_of(guide, motion.push);
  const NodeFriction friction = friction_at(at, i, load, to.with_tangent());
  along -= friction.force.x();
  about -= guide.lever * friction.force.y();
  r.head<3>() = along * guide.tangent;
  r.tail<3>() = about * guide.tangent;
  write_results(at, i, friction);
  if (!to.with_tangent()) return;
  const Vector2d by_load(-friction.by_load.x(), -guide.lever * friction.by_load.y());
  write_small_rows(at, i, load, friction, by_load, *to.tangent());
  if (others_act) reduce_rows(at, i, load, gauge(at, i) ? Vector2d(0.0, 0.0) : by_load, *to.tangent());
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
  each_clear_run(at.stage.inner_nodes, [&](int i) { return acted_on(at, i); }, batch);
  for (const Runs::Run& run : at.stage.inner_nodes)
    for (int i = run.first; i < run.last; ++i)
      if (acted_on(at, i)) node(i);
  each_outside(at.stage.inner_nodes, at.model.nodes(),
               [&](int i)
               {
                 if (guide_of(at, i).guided) node(i);
               });
}

/// Nodes that only the guided string acts on by the batch kernel, then the others: they are beside what it writes too much.
void add_sticking(const StageContext& at, const ForceRows& to) noexcept
{
  if (!at.stage.guided_kernel) return add_guided_string<sticking_friction>(at, to);
  if (!at.stage.any_guided) return;
  find_tensions(at);
  GuidedRows rows{to.residual(), nullptr, nullptr, nullptr};
  if (BlockTridiagonal* tangent = to.tangent()) rows = {to.residual(), tangent->small_diagonal(0).data(), tangent->small_upper(0).data(), tangent->small_lower(0).data()};
  each_inner_run(at, [&](Runs::Run run) { at.stage.guided_kernel->add(at, run, rows); }, [&](int i) { add_at<sticking_friction>(at, i, to); });
}

void store_guided_string(const StageContext& at, StoredEnergy& energy) noexcept
{
  if (!at.stage.any_guided) return;
  for (int e = 0; e < at.model.elements(); ++e)
  {
    const GuidedSpan& span = span_of(at, e);
    if (!span.guided) continue;
    const GuidedForce force = elastic(at, e);
    energy.beams += 0.5 * (force.tension * force.tension / span.axial + force.torque * force.torque / span.torsion);
  }
  for (int i = 0; i < at.model.nodes(); ++i)
  {
    const Guide& guide = guide_of(at, i);
    if (!guide.guided) continue;
    const GuidedMotion& motion = at.work.guided[i];
    energy.kinetic += 0.5 * guide.mass * motion.along_rate * motion.along_rate;
    energy.turning += 0.5 * guide.spin_inertia * motion.about_rate * motion.about_rate;
    energy.bristles += 0.5 * guide.law.tangential_stiffness * at.work.result.bristle[i].squaredNorm();
    energy.weight -= guide.weight.dot(at.start.nodes[i].position + motion.along * guide.tangent);
  }
}

void add_to(EnergySample& sample, NodeForce kind, int i, const Guide& guide, double along, double about) noexcept
{
  auto at = at_node(sample, kind, i);
  at.head<3>() += along * guide.tangent;
  at.tail<3>() += about * guide.tangent;
}

void sample_guided_string(const StageContext& at, EnergySample& sample) noexcept
{
  if (!at.stage.any_guided) return;
  for (int e = 0; e < at.model.elements(); ++e)
  {
    if (!span_of(at, e).guided) continue;
    const Guide &lower = guide_of(at, e), &upper = guide_of(at, e + 1);
    const GuidedForce held = elastic(at, e), damped = damping(at, e);
    add_to(sample, NodeForce::beams, e, lower, held.tension, held.torque);
    add_to(sample, NodeForce::beams, e + 1, upper, -held.tension, -held.torque);
    add_to(sample, NodeForce::structural, e, lower, damped.tension, damped.torque);
    add_to(sample, NodeForce::structural, e + 1, upper, -damped.tension, -damped.torque);
  }
  for (int i = 0; i < at.model.nodes(); ++i)
  {
    const Guide& guide = guide_of(at, i);
    if (!guide.guided) continue;
    const GuidedMotion& motion = at.work.guided[i];
    // the friction of the wall as add() has left it: along the pipe what of the wall's force is not across it
    const double friction = guide.tangent.dot(at.work.result.forces.wall[i] + motion.push), torque = guide.lever * motion.around;
    add_to(sample, NodeForce::inertia, i, guide, guide.mass * motion.along_acceleration, guide.spin_inertia * motion.about_acceleration);
    add_to(sample, NodeForce::mud, i, guide, guide.mud_along * motion.along_rate, guide.mud_about * motion.about_rate);
    add_to(sample, NodeForce::friction, i, guide, -friction, -torque);
    if (gauge(at, i)) sample.gauge_torque -= torque;
  }
}

void add_gauge(const StageContext& at, const ForceRows&) noexcept
{
  if (!at.stage.any_guided || !guide_of(at, 0).guided) return;
  if (!at.stage.guided_elements.empty())
  {
    const Runs::Run run = *at.stage.guided_elements.begin();
    find_tensions(at, {run.first, std::min(run.last, at.model.mesh().gauge_nodes)});
  }
  for (int i = 0; gauge(at, i); ++i)
  {
    const Guide& guide = guide_of(at, i);
    if (!guide.guided) continue;
    const NodeFriction friction = sticking_friction(at, i, load_of(guide, lean_of(at, i, ends_of(at, i))), false);
    at.work.result.forces.bit_moment += (guide.lever * friction.force.y()) * guide.tangent;
  }
}

}  // namespace

const Force guided_string = {"guided string", Cost::guided, Sum::none, add_sticking, add_guided_string<sliding_friction>, add_sticking, store_guided_string, sample_guided_string};
const Force guided_gauge = {"guided gauge", Cost::guided, Sum::none, add_gauge, nullptr, add_gauge, nullptr, nullptr};

}  // namespace drill_rig_sim
