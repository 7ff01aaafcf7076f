// SPDX-License-Identifier: BSD-3-Clause
// Guided nodes at a stage: what guided_string.cpp, evaluate.cpp and guides.cpp do node by node.
#include "drill_rig_sim/model/kernels/guided_kernel.h"

#include <cstddef>

#include "drill_rig_sim/model/workspace.h"

#ifndef DRILL_RIG_SIM_KERNELS_TOGETHER
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "model/kernels/guided_kernel.cpp"
#endif
#include "math/simd.h"
#ifdef DRILL_RIG_SIM_HIGHWAY
#include <hwy/contrib/math/math-inl.h>  // in every pass
#endif

#if DRILL_RIG_SIM_WIDE
HWY_BEFORE_NAMESPACE();
namespace drill_rig_sim::HWY_NAMESPACE::of_guided
{
namespace
{
#include "math/lanes.h"
#include "math/lane_powers.h"
#include "drill_rig_sim/contact/friction_text.h"
#include "drill_rig_sim/model/forces/guided_text.h"
#include "model/kernels/guided_lanes.h"

template <class Batch>
void move_batch(const StageContext& at, const double* u, Batch b)
{
  const Stage& stage = at.stage;
  GuidedMotions& to = at.work.guided;
  const auto data = [](const Vector6d& six) { return six.data(); };
  const V3 t = load3(stage.guides.tangent, b.i);
  const V6 step = load6(rows(u + 6 * b.i, 6, b.count));
  const V6 rate = load6(rows_of(stage.rate, b, data)), acceleration = load6(rows_of(stage.acceleration, b, data));
  const V dv = all(stage.dv_du), da = all(stage.da_du);
  const V along = dot(t, step.head), about = dot(t, step.tail);
  store(along, to.along, b.i);
  store(about, to.about, b.i);
  store(mul_add(dv, along, dot(t, rate.head)), to.along_rate, b.i);
  store(mul_add(dv, about, dot(t, rate.tail)), to.about_rate, b.i);
  store(mul_add(da, along, dot(t, acceleration.head)), to.along_acceleration, b.i);
  store(mul_add(da, about, dot(t, acceleration.tail)), to.about_acceleration, b.i);
}

void move(const StageContext& at, const double* u, Runs::Run nodes) noexcept
{
  each_batch(nodes, [&](auto b) { move_batch(at, u, b); });
}

void find_tensions(const StageContext& at, Runs::Run elements) noexcept
{
  const GuideColumns& guides = at.stage.guides;
  GuidedMotions& motions = at.work.guided;
  const V damping = all(at.stage.structural_damping);
  each_batch(
      elements,
      [&](auto b)
      {
        const auto less_upper = [&](const Column& column) { return load(column, b.i) - load(column, b.i + 1); };
        const GuidedElement element{load(guides.axial, b.i), load(guides.torsion, b.i), load(guides.stretch, b.i),
                                    load(guides.twist, b.i)};
        const V2 held = guided_elastic(element, {less_upper(motions.along), less_upper(motions.about)});
        const V2 damped = guided_damping(element, damping, {less_upper(motions.along_rate), less_upper(motions.about_rate)});
        store(held.x + damped.x, motions.tension, b.i);
        store(held.y + damped.y, motions.torque, b.i);
      });
}

/// A node as its two rows want it.
struct Node
{
  V3 tangent, weight, above, below;  // above, below: directions of its elements
  GuidedNode body;
  Rubbing law;
  V lever, held;
  V2 tension_above, tension_below;  // and torque
};

HWY_INLINE Node load_node(const StageContext& at, int i)
{
  const GuideColumns& g = at.stage.guides;
  const GuidedMotions& m = at.work.guided;
  const bool exponential = at.model.scene().contact.stribeck_curve == StribeckCurve::exponential;
  return {load3(g.tangent, i),
          load3(g.weight, i),
          load3(g.direction, i),
          load3(g.direction, i - 1),
          {load(g.mass, i), load(g.spin_inertia, i), load(g.wet_along, i), load(g.wet_about, i)},
          {load(g.friction, i), load(g.static_ratio, i), load(g.stribeck_speed, i), load(g.stiffness, i), load(g.damping, i),
           exponential},
          load(g.lever, i),
          load(g.held, i),
          {load(m.tension, i), load(m.torque, i)},
          {load(m.tension, i - 1), load(m.torque, i - 1)}};
}

HWY_INLINE GuidedFriction friction_of(const StageContext& at, const Node& n, const GuidedLoad& on_wall, int i)
{
  const GuideColumns& g = at.stage.guides;
  const GuidedMotions& m = at.work.guided;
  return guided_friction(n.law, on_wall.normal, {load(g.bristle.part[0], i), load(g.bristle.part[1], i)},
                         {load(m.along, i), n.lever * load(m.about, i)}, {load(m.along_rate, i), n.lever * load(m.about_rate, i)},
                         all(at.stage.time));
}

template <class Batch>
HWY_INLINE void write_tangent(const StageContext& at, const Node& n, const GuidedLoad& on_wall, const GuidedFriction& f, Batch b,
                              const GuidedRows& to)
{
  const GuideColumns& g = at.stage.guides;
  const V dv = all(at.stage.dv_du), da = all(at.stage.da_du), damped = all(1.0 + at.stage.dv_du * at.stage.structural_damping);
  const auto stiffness = [&](int e) { return V2{damped * load(g.axial, e), damped * load(g.torsion, e)}; };
  const GuidedSlopes slopes = guided_slopes(n.law, on_wall, f, dv);
  const V2 by_load{minus(slopes.by_load.x), minus(n.lever * slopes.by_load.y)};
  const GuidedBlocks k = guided_blocks(n.body, slopes, n.lever, stiffness(b.i), stiffness(b.i - 1),
                                       dot(on_wall.direction, n.above), dot(on_wall.direction, n.below), by_load, dv, da);
  double spare[4];
  const auto put = [&](const V2& first, const V2& second, double* blocks)
  { store4<false>(first.x, first.y, second.x, second.y, rows(blocks + 4 * b.i, 4, b.count, spare), 0); };
  put(k.own_first, k.own_second, to.diagonal);
  put(k.upper_first, k.upper_second, to.upper);
  put(k.lower_first, k.lower_second, to.lower - 4);
}

template <class Batch>
HWY_INLINE void write_results(const StageContext& at, const Node& n, const GuidedLoad& on_wall, const V3& push,
                              const GuidedFriction& f, Batch b)
{
  StageResult& result = at.work.result;
  double spare[3];
  const auto data = [](Eigen::Vector3d& v) { return v.data(); };
  const Rubbed<V2>& r = f.rubbed;
  store3({r.bristle.x, r.bristle.y, all(0.0)}, rows_to(result.bristle, b, spare, data));
  store3(r.force.x * n.tangent - push, rows_to(result.forces.wall, b, spare, data));
  put_down(select_or_zero(f.sticks, load(at.stage.guides.rest, b.i) + all(at.stage.time)), result.rest, b.i, b.count);
  put_down(on_wall.normal, result.forces.contact, b.i, b.count);
  store(push, at.work.guided.push, b.i);
  store(push, at.work.guided.lean, b.i);
  store(r.force.y, at.work.guided.around, b.i);
}

template <bool kTangent, class Batch>
HWY_INLINE void add_batch(const StageContext& at, Batch b, const GuidedRows& to)
{
  const GuidedMotions& m = at.work.guided;
  const Node n = load_node(at, b.i);
  const V3 push = guided_push(n.tangent, n.tension_above.x, n.above, n.tension_below.x, n.below, n.weight);
  const GuidedLoad on_wall = guided_load(push, n.law.kinetic, n.held);
  const GuidedFriction f = friction_of(at, n, on_wall, b.i);
  const V2 rate{load(m.along_rate, b.i), load(m.about_rate, b.i)};
  const V2 acceleration{load(m.along_acceleration, b.i), load(m.about_acceleration, b.i)};
  const V2 row =
      guided_row(n.body, rate, acceleration, n.tension_above, n.tension_below, dot(n.tangent, n.weight), f.rubbed.force, n.lever);
  double spare[6];
  store6({row.x * n.tangent, row.y * n.tangent}, rows(to.residual + 6 * b.i, 6, b.count, spare));
  write_results(at, n, on_wall, push, f, b);
  if constexpr (kTangent) write_tangent(at, n, on_wall, f, b, to);
}

void add(const StageContext& at, Runs::Run nodes, const GuidedRows& to) noexcept
{
  if (to.diagonal)
    each_batch(nodes, [&](auto b) { add_batch<true>(at, b, to); });
  else
    each_batch(nodes, [&](auto b) { add_batch<false>(at, b, to); });
}

void reduce(const Stage& stage, Runs::Run nodes, double* b) noexcept
{
  double spare[6];
  each_batch(nodes,
             [&](auto batch)
             {
               const V3 t = load3(stage.guides.tangent, batch.i);
               double* first = b + 6 * batch.i;
               const V6 r = load6(rows(first, 6, batch.count));
               const V zero = all(0.0);
               store6({{dot(t, r.head), dot(t, r.tail), zero}, {zero, zero, zero}}, rows(first, 6, batch.count, spare));
             });
}

void expand(const Stage& stage, Runs::Run nodes, double* b) noexcept
{
  double spare[6];
  each_batch(nodes,
             [&](auto batch)
             {
               const V3 t = load3(stage.guides.tangent, batch.i), turn = load3(stage.guides.turn, batch.i);
               double* first = b + 6 * batch.i;
               const V4 x = load4(rows(first, 6, batch.count), 0);
               store6({x.a * t, mul_add(x.a, turn, x.b * t)}, rows(first, 6, batch.count, spare));
             });
}

template <class Batch>
void expand_batch(const Stage& stage, Workspace& work, Batch b)
{
  const V3 t = load3(stage.guides.tangent, b.i), turn = load3(stage.guides.turn, b.i);
  const GuidedMotions& m = work.guided;
  double spare[6];
  const auto to = [&](auto get) { return rows_to(work.nodes, b, spare, get); };
  const auto six = [&](const Column& along, const Column& about)
  {
    const V s = load(along, b.i);
    return V6{s * t, mul_add(s, turn, load(about, b.i) * t)};
  };
  const V3 tilt = load(m.along, b.i) * turn;
  store3(t, to([](NodeMotion& node) { return node.axis.data(); }));
  store3(tilt, to([](NodeMotion& node) { return node.tilt.data(); }));
  store3(t + cross(tilt, t), to([](NodeMotion& node) { return node.normal.data(); }));
  store1(load(m.about, b.i), to([](NodeMotion& node) { return &node.spin; }));
  store1(load(m.about_rate, b.i), to([](NodeMotion& node) { return &node.carried_spin; }));
  store6(six(m.along, m.about), to([](NodeMotion& node) { return node.increment.data(); }));
  store6(six(m.along_rate, m.about_rate), to([](NodeMotion& node) { return node.rate.data(); }));
  store6(six(m.along_acceleration, m.about_acceleration), to([](NodeMotion& node) { return node.acceleration.data(); }));
}

void expand_motions(const Stage& stage, Workspace& work, Runs::Run nodes) noexcept
{
  each_batch(nodes, [&](auto b) { expand_batch(stage, work, b); });
}
/// Of elements bent as the hole is.
void find_forces(const Stage& stage, Workspace& work, Runs::Run elements) noexcept
{
  const GuideColumns& g = stage.guides;
  RigForces& out = work.result.forces;
  each_batch(elements,
             [&](auto b)
             {
               put_down(load(work.guided.tension, b.i), out.tension, b.i, b.count);
               put_down(minus(load(work.guided.torque, b.i)), out.torque, b.i, b.count);
               put_down(load(g.bending, b.i) * norm(load3(g.turn, b.i + 1)), out.bending_moment, b.i + 1, b.count);
             });
}
}  // namespace

constexpr GuidedKernel table = {move, find_tensions, add, reduce, expand, expand_motions, find_forces};
}  // namespace drill_rig_sim::HWY_NAMESPACE::of_guided
HWY_AFTER_NAMESPACE();
#endif

#if DRILL_RIG_SIM_ONCE
namespace drill_rig_sim
{
const GuidedKernel* guided_kernel(Kernel kernel) noexcept
{
  constexpr const GuidedKernel* none = nullptr;
  return DRILL_RIG_SIM_TABLE(kernel, none, of_guided::table);
}
}  // namespace drill_rig_sim
#endif
