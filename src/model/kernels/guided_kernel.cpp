// The formulas are those of evaluate.cpp, guides.cpp, forces/guided_string.cpp and contact/surface_friction.cpp; symbols as there.
#include "drill_rig_sim/model/kernels/guided_kernel.h"

#include <cstddef>

#include "drill_rig_sim/math/number_columns.h"
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
  using namespace guided_column;
  const Stage& stage = at.stage;
  const V3 t = tangent_of(guides_of(stage, b));
  const V6 step = load6(rows(u + 6 * b.i, 6 * sizeof(double), b.count));
  const V6 rate = load6(rows(stage.rate[static_cast<std::size_t>(b.i)].data(), sizeof(Vector6d), b.count));
  const V6 acceleration = load6(rows(stage.acceleration[static_cast<std::size_t>(b.i)].data(), sizeof(Vector6d), b.count));
  const V dv = all(stage.dv_du), da = all(stage.da_du);
  const V s = dot(t, step.head), phi = dot(t, step.tail);
  const V s_rate = hn::MulAdd(dv, s, dot(t, rate.head)), phi_rate = hn::MulAdd(dv, phi, dot(t, rate.tail));
  const V s_acceleration = hn::MulAdd(da, s, dot(t, acceleration.head)), phi_acceleration = hn::MulAdd(da, phi, dot(t, acceleration.tail));
  NumberColumns& columns = at.work.guided_columns;
  store(s, columns, along, b.i);
  store(phi, columns, about, b.i);
  store(s_rate, columns, along_rate, b.i);
  store(phi_rate, columns, about_rate, b.i);
  store(s_acceleration, columns, along_acceleration, b.i);
  store(phi_acceleration, columns, about_acceleration, b.i);
  double spare[6];
  const Rows to = rows_to(at.work.guided, at.work.guided[0].along, b, spare);
  store4<false>(s, phi, s_rate, phi_rate, to, 0);
  store4<false>(s_rate, phi_rate, s_acceleration, phi_acceleration, to, 2);
}

void move(const StageContext& at, const double* u, Runs::Run nodes) noexcept
{
  each_batch(nodes, [&](auto b) { move_batch(at, u, b); });
}

template <class Batch>
void tension_batch(const StageContext& at, Batch b)
{
  using namespace guided_column;
  NumberColumns& columns = at.work.guided_columns;
  const V4 span = load4(rows_of(at.stage.guided_spans, at.stage.guided_spans[0].axial, b), 0);  // axial, torsion, stretch, twist
  const V c = all(at.stage.structural_damping);
  const auto difference = [&](int kind) { return load(columns[kind] + b.i) - load(columns[kind] + b.i + 1); };
  const V force = span.a * hn::MulAdd(c, difference(along_rate), span.c + difference(along));
  const V moment = span.b * hn::MulAdd(c, difference(about_rate), span.d + difference(about));
  store(force, columns, tension, b.i);
  store(moment, columns, torque, b.i);
  const V damped = all(1.0 + at.stage.dv_du * at.stage.structural_damping);
  store(damped * span.a, columns, axial, b.i);
  store(damped * span.b, columns, torsion, b.i);
  double spare[2];
  store2(force, moment, rows_to(at.work.guided_forces, at.work.guided_forces[0].tension, b, spare));
}

void find_tensions(const StageContext& at, Runs::Run elements) noexcept
{
  each_batch(elements, [&](auto b) { tension_batch(at, b); });
}

/// A Guide's numbers that forces want, and what the node's friction was at the start of the step.
struct Numbers
{
  V3 tangent, above, below, weight;
  V mass, spin_inertia, mud_along, mud_about, friction, lever, held;
  V stribeck_speed, static_ratio, stiffness, damping;  // of the friction
  V bristle_along, bristle_around, rest;
};

template <class Batch>
HWY_INLINE Numbers load_numbers(const StageContext& at, Batch b)
{
  const Rows guide = guides_of(at.stage, b);
  const V4 p = load4(guide, 0), q = load4(guide, 4), r = load4(guide, 8), m = load4(guide, mass_at), f = load4(guide, friction_at);
  const V4 l = load4(guide, law_at), s = load4(rows_of(at.start.nodes, at.start.nodes[0].bristle.x(), b), 0);
  return {{p.a, p.b, p.c}, {p.d, q.a, q.b}, {q.c, q.d, r.a}, {r.b, r.c, r.d}, m.a, m.b, m.c, m.d, f.a, f.b, f.d, l.a, l.b, l.c, l.d, s.a, s.b, s.d};
}

/// Load on the wall and normal force.
struct Load : GuidedLoad
{
  V3 push;
};

HWY_INLINE Load load_of(const Numbers& n, V above, V below)
{
  const V3 sum = mul_add(above, n.above, mul_add(below, n.below, n.weight)), push = mul_sub_from(dot(n.tangent, sum), n.tangent, sum);
  return {guided_load(push, n.friction, n.held), push};
}

/// At the rim, with its slopes by the rim's displacement, rows first, and by the load on the wall.
struct Friction
{
  V2 force, bristle, first_row, second_row, by_load;
  V rest;
};

HWY_INLINE Friction friction_of(const Numbers& n, const StageContext& at, const NumberColumns& columns, int i, const Load& on_wall)
{
  using namespace guided_column;
  const bool exponential = at.model.scene().contact.stribeck_curve == StribeckCurve::exponential;
  const Rubbing law{n.friction, n.static_ratio, n.stribeck_speed, n.stiffness, n.damping, exponential};
  const V2 before{n.bristle_along, n.bristle_around}, displacement{load(columns[along] + i), n.lever * load(columns[about] + i)};
  const V2 velocity{load(columns[along_rate] + i), n.lever * load(columns[about_rate] + i)}, stretched = before + displacement;
  const V zero = all(0.0), time = all(at.stage.time);
  const Rubbed<V2> r = rubbed(law, on_wall.normal, mul_add(n.stiffness, stretched, n.damping * velocity), stretched, [&] { return velocity; },
                              [&] { return before; }, time);
  const RubbedSlopes by = slopes_of(law, on_wall.normal, r, velocity, all(at.stage.dv_du));
  const V2 none{zero, zero};
  const Mask there = both(on_wall.normal > zero, n.friction > zero);
  return {choose(there, r.force, none),
          choose(there, r.bristle, none),
          choose(there, by.first_row, none),
          choose(there, by.second_row, none),
          choose(there, on_wall.normal_by_size * by.by_normal_force, none),
          select_or_zero(both(there, opposite(r.slipping)), n.rest + time)};
}

template <class Batch>
HWY_INLINE void write_residual(const StageContext& at, const Numbers& n, const Friction& f, Batch b, double* residual)
{
  using namespace guided_column;
  const NumberColumns& columns = at.work.guided_columns;
  const auto of = [&](int kind) { return load(columns[kind] + b.i); };
  const auto ends = [&](int kind) { return load(columns[kind] + b.i) - load(columns[kind] + b.i - 1); };
  const V along_hole = hn::MulAdd(n.mass, of(along_acceleration), hn::MulAdd(n.mud_along, of(along_rate), ends(tension))) - dot(n.tangent, n.weight) - f.force.x;
  const V about_hole = hn::NegMulAdd(n.lever, f.force.y, hn::MulAdd(n.spin_inertia, of(about_acceleration), hn::MulAdd(n.mud_about, of(about_rate), ends(torque))));
  double spare[6];
  store6(along_hole * n.tangent, about_hole * n.tangent, rows_to(residual, 6, b, spare), 0);
}

template <class Batch>
HWY_INLINE void write_tangent(const StageContext& at, const Numbers& n, const Load& load_on_wall, const Friction& f, Batch b, const GuidedRows& to)
{
  using namespace guided_column;
  const NumberColumns& columns = at.work.guided_columns;
  const V dv = all(at.stage.dv_du), da = all(at.stage.da_du), zero = all(0.0);
  const V2 by_load{hn::Neg(f.by_load.x), hn::Neg(n.lever * f.by_load.y)};
  const V axial_above = load(columns[axial] + b.i), axial_below = load(columns[axial] + b.i - 1);
  const V torsion_above = load(columns[torsion] + b.i), torsion_below = load(columns[torsion] + b.i - 1);
  const V of_above = dot(load_on_wall.direction, n.above) * axial_above, of_below = dot(load_on_wall.direction, n.below) * axial_below;
  const V2 above{of_above * by_load.x, of_above * by_load.y}, below{of_below * by_load.x, of_below * by_load.y};
  double spare[4];
  store4<false>(hn::MulAdd(da, n.mass, dv * n.mud_along) - f.first_row.x + axial_above + axial_below + above.x - below.x, hn::Neg(n.lever * f.first_row.y),
                above.y - below.y - n.lever * f.second_row.x,
                hn::MulAdd(da, n.spin_inertia, dv * n.mud_about) - n.lever * n.lever * f.second_row.y + torsion_above + torsion_below,
                rows_to(to.diagonal, 4, b, spare), 0);
  store4<false>(hn::Neg(axial_above) - above.x, zero, hn::Neg(above.y), hn::Neg(torsion_above), rows_to(to.upper, 4, b, spare), 0);
  store4<false>(below.x - axial_below, zero, below.y, hn::Neg(torsion_below), rows_to(to.lower - 4, 4, b, spare), 0);
}

/// Rows of three are written with a number too many each, which the next row puts right; behind a run there is always a node that is evaluated later.
template <class Batch>
HWY_INLINE void write_results(const StageContext& at, const Numbers& n, const Load& load_on_wall, const Friction& f, Batch b)
{
  StageResult& result = at.work.result;
  double spare[8];
  const V zero = all(0.0);
  store4<false>(f.bristle.x, f.bristle.y, zero, zero, rows_to(result.bristle, result.bristle[0].x(), b, spare), 0);
  const V3 wall = f.force.x * n.tangent - load_on_wall.push;
  store4<false>(wall.x, wall.y, wall.z, zero, rows_to(result.forces.wall, result.forces.wall[0].x(), b, spare), 0);
  put_down(f.rest, result.rest.data(), b);
  put_down(load_on_wall.normal, result.forces.contact.data(), b);
  const V3& p = load_on_wall.push;
  const Rows motion = rows_to(at.work.guided, at.work.guided[0].push.x(), b, spare);
  store6(p, p, motion, 0);
  store4<false>(p.x, p.y, p.z, f.force.y, motion, 3);
}

template <class Batch>
void add_batch(const StageContext& at, Batch b, const GuidedRows& to)
{
  const NumberColumns& columns = at.work.guided_columns;
  const Numbers n = load_numbers(at, b);
  const Load on_wall = load_of(n, load(columns[guided_column::tension] + b.i), load(columns[guided_column::tension] + b.i - 1));
  const Friction f = friction_of(n, at, columns, b.i, on_wall);
  write_residual(at, n, f, b, to.residual);
  write_results(at, n, on_wall, f, b);
  if (to.diagonal) write_tangent(at, n, on_wall, f, b, to);
}

void add(const StageContext& at, Runs::Run nodes, const GuidedRows& to) noexcept
{
  each_batch(nodes, [&](auto b) { add_batch(at, b, to); });
}

void reduce(const Stage& stage, Runs::Run nodes, double* b) noexcept
{
  double spare[6];
  each_batch(nodes,
             [&](auto batch)
             {
               const V3 t = tangent_of(guides_of(stage, batch));
               const V6 r = load6(rows(b + 6 * batch.i, 6 * sizeof(double), batch.count));
               const V zero = all(0.0);
               const Rows to = rows_to(b, 6, batch, spare);
               store4<false>(dot(t, r.head), dot(t, r.tail), zero, zero, to, 0);
               store4<false>(zero, zero, zero, zero, to, 2);
             });
}

void expand(const Stage& stage, Runs::Run nodes, double* b) noexcept
{
  double spare[6];
  each_batch(nodes,
             [&](auto batch)
             {
               const Rows guide = guides_of(stage, batch);
               const V4 t = load4(guide, 0), w = load4(guide, turn_at), x = load4(rows(b + 6 * batch.i, 6 * sizeof(double), batch.count), 0);
               const V3 tangent{t.a, t.b, t.c}, turn{w.a, w.b, w.c};
               store6(x.a * tangent, mul_add(x.a, turn, x.b * tangent), rows_to(b, 6, batch, spare), 0);
             });
}

template <class Batch>
void expand_batch(const Stage& stage, Workspace& work, Batch b)
{
  const Rows guide = guides_of(stage, b);
  const V4 p = load4(guide, 0), q = load4(guide, turn_at);
  const V3 t{p.a, p.b, p.c}, w{q.a, q.b, q.c};
  const Rows from = rows_of(work.guided, work.guided[0].along, b);
  const V4 m = load4(from, 0), a = load4(from, 2);
  double spare[36];
  const Rows to = rows_to(work.nodes, work.nodes[0].axis.x(), b, spare);  // axis, position, normal, tilt, spin, carried_spin, increment, rate, acceleration
  store4<false>(t.x, t.y, t.z, all(0.0), to, 0);  // the place is not looked at
  const V3 tilt = m.a * w, normal = t + cross(tilt, t);
  store6(normal, tilt, to, 6);
  const auto six = [&](V along, V about, int column) { store6(along * t, mul_add(along, w, about * t), to, column); };
  store2(m.b, m.d, rows_to(work.nodes, work.nodes[0].spin, b, spare));
  six(m.a, m.b, 14);
  six(m.c, m.d, 20);
  six(a.c, a.d, 26);
}

void expand_motions(const Stage& stage, Workspace& work, Runs::Run nodes) noexcept
{
  each_batch(nodes, [&](auto b) { expand_batch(stage, work, b); });
}
}  // namespace

constexpr GuidedKernel table = {move, find_tensions, add, reduce, expand, expand_motions};
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
