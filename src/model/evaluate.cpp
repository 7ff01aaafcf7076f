// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/model/evaluate.h"

#include <algorithm>

#include "drill_rig_sim/math/rotation.h"
#include "drill_rig_sim/model/forces/free_string.h"
#include "drill_rig_sim/model/forces/lists.h"
#include "drill_rig_sim/model/kernels/guided_kernel.h"
#include "drill_rig_sim/model/places.h"
#include "drill_rig_sim/model/wall_faults.h"

namespace drill_rig_sim
{
using Eigen::Vector3d;

namespace
{
/// Adds forces by `use` of each, timed; neighbours of one account share a look at the clock.
void add_forces(const ForceList& forces, Force::Add Force::*use, const StageContext& at, const ForceRows& to) noexcept
{
  const Force* last = nullptr;
  for (const Force* force : forces)
  {
    if (!(force->*use)) continue;
    if (last && last->cost != force->cost) at.work.profiler.lap(last->cost);
    (force->*use)(at, to);
    last = force;
  }
  if (last) at.work.profiler.lap(last->cost);
}

void move_guided(const Stage& stage, std::size_t i, const double* u, Workspace& work) noexcept
{
  GuidedMotions& m = work.guided;
  const Vector3d tangent = stage.guides.tangent[i];
  const auto dot = [&tangent](const double* v) { return tangent.x() * v[0] + tangent.y() * v[1] + tangent.z() * v[2]; };
  const double *rate = stage.rate[i].data(), *acceleration = stage.acceleration[i].data();
  m.along[i] = dot(u + 6 * i);
  m.about[i] = dot(u + 6 * i + 3);
  m.along_rate[i] = stage.dv_du * m.along[i] + dot(rate);
  m.about_rate[i] = stage.dv_du * m.about[i] + dot(rate + 3);
  m.along_acceleration[i] = stage.da_du * m.along[i] + dot(acceleration);
  m.about_acceleration[i] = stage.da_du * m.about[i] + dot(acceleration + 3);
}

void move_guided_nodes(const StageContext& at, const double* u) noexcept
{
  const Stage& stage = at.stage;
  for (std::vector<unsigned char>* of_free : {&at.work.motion_known, &at.work.rows_open})
  {
    std::fill(of_free->begin(), of_free->end(), static_cast<unsigned char>(1));
    for (const Runs::Run& run : stage.guided_nodes)
      std::fill(of_free->begin() + run.first, of_free->begin() + run.last, static_cast<unsigned char>(0));
  }
  for (const Runs::Run& run : stage.guided_nodes)
  {
    if (stage.guided_kernel)
    {
      stage.guided_kernel->move(at, u, run);
      continue;
    }
    for (int i = run.first; i < run.last; ++i) move_guided(stage, static_cast<std::size_t>(i), u, at.work);
  }
  each_outside(stage.inner_nodes, at.model.nodes(),
               [&](int k)
               {
                 if (!stage.guides.guided[static_cast<std::size_t>(k)]) return;
                 const NodeMotion& node = at.node(k);
                 if (at.work.columns.moved) at.work.columns.take(node, k);
               });
}

/// move_free() by the batch kernel, which leaves the columns of all nodes of the free string.
void move_batches(const State& start, const Stage& stage, const double* u, Workspace& work) noexcept
{
  const int nodes = static_cast<int>(work.nodes.size());
  work.columns.moved = true;
  each_between(stage.guided_nodes, nodes, [&](int first, int last) { work.motion->move(start, stage, u, {first, last}, work); });
}

/// Places and rates of the free nodes at u.
void move_free(const State& start, const Stage& stage, const double* u, Workspace& work) noexcept
{
  for (std::size_t i = 0; i < work.nodes.size(); ++i)
  {
    if (stage.guides.guided[i]) continue;
    NodeMotion& node = work.nodes[i];
    const NodeState& before = start.nodes[i];
    node.axis = stage.normal[i];
    node.increment = Eigen::Map<const Vector6d>(u + 6 * i);
    node.position = before.position + node.increment.head<3>();
    node.spin = node.increment.tail<3>().dot(node.axis);
    node.tilt = node.increment.tail<3>() - node.spin * node.axis;
    node.orientation = rotation_from_vector(node.tilt) * rotation_from_vector(node.spin * node.axis) * before.orientation;
    node.normal = x_axis(node.orientation);
    node.rate = stage.dv_du * node.increment + stage.rate[i];
    node.carried_spin = node.rate.tail<3>().dot(node.axis);
    node.acceleration = stage.da_du * node.increment + stage.acceleration[i];
  }
}

/// The node at a position that another integrator gives.
void place(const GivenNode& given, NodeMotion& node) noexcept
{
  node.position = given.position;
  node.orientation = given.orientation;
  node.normal = x_axis(given.orientation);
  node.axis = node.normal;  // the rates are split by the present normal
  node.increment = given.increment;
  node.spin = given.increment.tail<3>().dot(node.axis);
  node.tilt = given.increment.tail<3>() - node.spin * node.axis;
  node.rate = given.rate;
  node.carried_spin = 0.0;
  node.acceleration.setZero();
}

/// The other kinds of element are evaluated one by one.
Kernel kernel_of(const Model& model) noexcept
{
  return model.beam().kind == ElementKind::corotational ? model.kernel() : Kernel::scalar;
}
}  // namespace

Workspace::Workspace(const Model& model)
    : nodes(model.mesh().nodes.size()),
      spans(model.mesh().elements.size()),
      guided(nodes.size()),
      motion_known(nodes.size(), 1),
      rows_open(nodes.size(), 1),
      columns(model),
      motion(motion_kernel(kernel_of(model))),
      string(string_kernel(kernel_of(model))),
      place(place_kernel(kernel_of(model))),
      wall(wall_kernel(kernel_of(model))),
      history(history_kernel(kernel_of(model))),
      unused(6 * nodes.size(), 0.0)
{
  result.bristle.assign(nodes.size(), Vector3d::Zero());
  result.span_bristle.assign(spans.size(), Vector3d::Zero());
  result.rest.assign(nodes.size(), 0.0);
  result.span_rest.assign(spans.size(), 0.0);
  RigForces& forces = result.forces;
  forces.tension.assign(model.mesh().elements.size(), 0.0);
  forces.torque = forces.tension;
  forces.bending_moment.assign(nodes.size(), 0.0);
  forces.contact = forces.bending_moment;
  forces.wall.assign(nodes.size(), Vector3d::Zero());
  forces.span_contact = forces.tension;
  forces.span_wall.assign(spans.size(), Vector3d::Zero());
}

void evaluate(const Model& model, const State& start, const Stage& stage, const double* u, Workspace& work, double* residual,
              BlockTridiagonal* tangent) noexcept
{
  evaluate_forces(all_forces, &Force::add, {model, start, stage, work}, u, residual, tangent);
}

void evaluate_forces(const ForceList& forces, Force::Add Force::*use, const StageContext& at, const double* u, double* residual,
                     BlockTridiagonal* tangent) noexcept
{
  const Model& model = at.model;
  const Stage& stage = at.stage;
  Workspace& work = at.work;
  work.profiler.lap(Cost::other);
  ++work.work.residuals;
  if (tangent) ++work.work.tangents;
  // ForceRows and the guided string see to the rows of guided nodes
  each_between(stage.guided_nodes, model.nodes(),
               [&](int first, int last) { std::fill(residual + 6 * first, residual + 6 * last, 0.0); });
  if (tangent)
  {
    each_outside(stage.guided_nodes, model.nodes(), [&](int i) { tangent->set_small(i, false); });
    for (const Runs::Run& run : stage.guided_nodes)
      for (int i = run.first; i < run.last; ++i) tangent->set_small(i, true);
  }
  if (work.motion)
    move_batches(at.start, stage, u, work);
  else
    move_free(at.start, stage, u, work);
  move_guided_nodes(at, u);
  work.profiler.lap(Cost::kinematics);
  find_in_hole(model, at.start, stage, work);
  put_faults_on_wall(model, at.start, stage, work);
  work.profiler.lap(Cost::contact);
  add_forces(forces, use, at, {work, residual, tangent});
}

void evaluate_static(const Model& model, const State& start, const Stage& stage, const double* u, Workspace& work,
                     double* residual, BlockTridiagonal* tangent) noexcept
{
  evaluate_forces(all_forces, &Force::add_static, {model, start, stage, work}, u, residual, tangent);
}

void update(const Model& model, const State& start, const Stage& stage, const double* u, Workspace& work) noexcept
{
  evaluate_forces(all_forces, &Force::find_results, {model, start, stage, work}, u, work.unused.data(), nullptr);
}

void move_as_free(const StageContext& at, int k) noexcept
{
  const std::size_t i = static_cast<std::size_t>(k);
  const NodeState& before = at.start.nodes[i];
  NodeMotion& node = at.work.nodes[i];
  expand_motion(at.stage, k, at.work);
  node.position = before.position + node.increment.head<3>();
  node.orientation = rotation_from_vector(node.tilt) * rotation_from_vector(node.spin * node.axis) * before.orientation;
  node.normal = x_axis(node.orientation);
  at.work.motion_known[i] = 1;
}

namespace
{
/// Bent as the hole is.
void find_guided_forces(const Stage& stage, Runs::Run run, Workspace& work) noexcept
{
  RigForces& out = work.result.forces;
  std::fill(out.span_contact.begin() + run.first, out.span_contact.begin() + run.last, 0.0);
  std::fill(out.span_wall.begin() + run.first, out.span_wall.begin() + run.last, Vector3d::Zero());
  if (stage.guided_kernel) return stage.guided_kernel->find_forces(stage, work, run);
  for (int e = run.first; e < run.last; ++e)
  {
    out.tension[e] = work.guided.tension[e];
    out.torque[e] = -work.guided.torque[e];
    out.bending_moment[e + 1] = stage.guides.bending[e] * stage.guides.turn[e + 1].norm();
  }
}
}  // namespace

void find_string_forces(const Model& model, const State& start, const Stage& stage, Workspace& work) noexcept
{
  const StageContext at{model, start, stage, work};
  for (const Runs::Run& run : stage.guided_elements) find_guided_forces(stage, run, work);
  if (moved_in_batches(at)) return find_free_forces(at);
  each_outside(stage.guided_elements, model.elements(), [&](int e) { find_beam_forces(at, e); });
}

namespace
{
/// Of the nodes at positions that another integrator gives: one by one.
void add_sum(Sum sum, const StageContext& at, const ForceRows& to) noexcept
{
  for (const Force* force : all_forces)
  {
    if (force->sum != sum) continue;
    force->add(at, to);
    at.work.profiler.lap(force->cost);
  }
}
}  // namespace

void evaluate_motion(const Model& model, const State& start, const Stage& stage, const GivenMotion& motion, Workspace& work,
                     double* string, double* contact, BlockTridiagonal* string_tangent,
                     BlockTridiagonal* contact_tangent) noexcept
{
  work.profiler.lap(Cost::other);
  ++work.work.residuals;
  if (string_tangent) ++work.work.tangents;
  std::fill(string, string + 6 * model.nodes(), 0.0);
  std::fill(contact, contact + 6 * model.nodes(), 0.0);
  for (std::size_t i = 0; i < work.nodes.size(); ++i) place(motion.nodes[i], work.nodes[i]);
  work.columns.moved = false;
  for (int e = 0; e < model.elements(); ++e) find_span(model, start, stage, e, work);
  work.profiler.lap(Cost::kinematics);
  const StageContext at{model, start, stage, work};
  add_sum(Sum::string, at, {work, string, string_tangent});
  if (contact_tangent) contact_tangent->set_zero();
  place(motion.bit, work.nodes[0]);  // from here on node 0 stands for the bit
  for (int i = 0; i < model.nodes(); ++i) find_closest(model, start, i, work.nodes[i]);
  add_sum(Sum::contact, at, {work, contact, contact_tangent});
}

Vector6d evaluate_bit_motion(const Model& model, const State& start, const Stage& stage, const GivenNode& bit,
                             Workspace& work) noexcept
{
  Vector6d out = Vector6d::Zero();
  const StageContext at{model, start, stage, work};
  place(bit, work.nodes[0]);
  find_closest(model, start, 0, work.nodes[0]);
  const ForceRows to(work, out.data(), nullptr);
  add_film_at_bit(at, to);
  add_wall_at_bit(at, to);
  bit_on_bottom.add(at, to);
  return out;
}

}  // namespace drill_rig_sim
