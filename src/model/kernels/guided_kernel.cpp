// The formulas are those of evaluate.cpp, guides.cpp, forces/guided_string.cpp and contact/surface_friction.cpp; symbols as there.
#include "drill_rig_sim/model/kernels/guided_kernel.h"

#include <cmath>
#include <cstddef>

#include "drill_rig_sim/math/number_columns.h"
#include "drill_rig_sim/model/workspace.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "model/kernels/guided_kernel.cpp"
#include "math/simd.h"
#ifdef DRILL_RIG_SIM_HIGHWAY
#include <hwy/contrib/math/math-inl.h>  // in every pass
#endif

#if DRILL_RIG_SIM_WIDE
HWY_BEFORE_NAMESPACE();
namespace drill_rig_sim::HWY_NAMESPACE
{
namespace
{
#include "math/lanes.h"

using Mask = hn::Mask<Tag>;

constexpr double smooth = 1.0;  // of the load on the wall, where it changes sides [N]

/// A batch: nodes or elements from `i` on, `count` of them.
struct Rest
{
  int i, count;
  Rest next() const { return {i + 1, count}; }
};

/// One without lanes that nobody asks for: the compiler knows where all its rows are.
struct Whole
{
  int i;
  static constexpr int count = kLanes;
  Whole next() const { return {i + 1}; }
};

/// Calls visit(batch) for those of a run.
template <class Visit>
HWY_INLINE void each_batch(Runs::Run run, const Visit& visit)
{
  int i = run.first;
  for (; i + kLanes <= run.last; i += kLanes) visit(Whole{i});
  if (i < run.last) visit(Rest{i, run.last - i});
}

/// Rows that begin with this member of a vector's elements.
template <class Element, class Batch>
HWY_INLINE Rows rows_of(const std::vector<Element>& from, const double& member_of_first, Batch b)
{
  const char* first = reinterpret_cast<const char*>(&member_of_first) + b.i * static_cast<std::ptrdiff_t>(sizeof(Element));
  return rows(reinterpret_cast<const double*>(first), sizeof(Element), b.count);
}

template <class Element, class Batch>
HWY_INLINE Rows rows_to(std::vector<Element>& to, double& member_of_first, Batch b, double* spare)
{
  char* first = reinterpret_cast<char*>(&member_of_first) + b.i * static_cast<std::ptrdiff_t>(sizeof(Element));
  return rows(reinterpret_cast<double*>(first), sizeof(Element), b.count, spare);
}

template <class Batch>
HWY_INLINE Rows rows_to(double* first, int numbers, Batch b, double* spare)
{
  return rows(first + numbers * b.i, numbers * static_cast<std::ptrdiff_t>(sizeof(double)), b.count, spare);
}

template <class Batch>
HWY_INLINE Rows guides_of(const Stage& stage, Batch b)
{
  return rows_of(stage.guides, stage.guides[0].tangent.x(), b);
}

/// Where a guide's numbers are, counted from its tangent.
constexpr int above_at = 3, weight_at = 9, mass_at = 12, friction_at = 16, law_at = 23, turn_at = 29;
static_assert(sizeof(ContactLaw) == 3 * sizeof(double) && sizeof(Guide) == 36 * sizeof(double), "a guide's numbers");

HWY_INLINE V3 tangent_of(const Rows& guide)
{
  const V4 t = load4(guide, 0);
  return {t.a, t.b, t.c};
}

/// Two numbers a row.
HWY_INLINE void store2(V a, V b, const Rows& to)
{
  HWY_ALIGN double first[kLanes], second[kLanes];
  hn::Store(a, Tag(), first);
  hn::Store(b, Tag(), second);
  for (int k = 0; k < kLanes; ++k)
  {
    to.row[k][0] = first[k];
    to.row[k][1] = second[k];
  }
}

/// Rows of six, (a t, b t).
HWY_INLINE void store_along(V a, V b, const V3& t, const Rows& to)
{
  const V3 p = a * t, q = b * t;
  store4<false>(p.x, p.y, p.z, q.x, to, 0);
  store4<false>(p.z, q.x, q.y, q.z, to, 2);
}

HWY_INLINE void store6(const V3& p, const V3& q, const Rows& to, int at)
{
  store4<false>(p.x, p.y, p.z, q.x, to, at);
  store4<false>(p.z, q.x, q.y, q.z, to, at + 2);
}

/// Of `count` numbers in a row.
template <class Batch>
HWY_INLINE void put_down(V v, double* to, Batch b)
{
  if (b.count == kLanes) return hn::StoreU(v, Tag(), to + b.i);
  HWY_ALIGN double numbers[kLanes];
  hn::Store(v, Tag(), numbers);
  for (int k = 0; k < b.count; ++k) to[b.i + k] = numbers[k];
}

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
struct Load
{
  V3 push, direction;
  V normal, normal_by_size;
};

HWY_INLINE Load load_of(const Numbers& n, V above, V below)
{
  Load load;
  const V one = all(1.0), zero = all(0.0);
  const V3 sum = mul_add(above, n.above, mul_add(below, n.below, n.weight));
  load.push = mul_sub_from(dot(n.tangent, sum), n.tangent, sum);
  const V smoothed = hn::Sqrt(hn::MulAdd(all(smooth), all(smooth), dot(load.push, load.push)));
  const V size = smoothed - all(smooth);
  load.direction = (one / smoothed) * load.push;
  const V square = size * size, least = square / hn::MulAdd(n.friction, n.friction, one), left = hn::NegMulAdd(n.held, n.held, square);
  load.normal = hn::Sqrt(hn::Max(left, least));
  const Mask held = left > least;
  const V ratio = hn::IfThenElse(held, size, load.normal) / hn::IfThenElse(held, load.normal, size);
  load.normal_by_size = hn::IfThenElse(load.normal > zero, ratio, one);
  return load;
}

/// Along and around.
struct V2
{
  V x, y;
};

HWY_INLINE V2 choose(Mask mask, const V2& yes, const V2& no)
{
  return {hn::IfThenElse(mask, yes.x, no.x), hn::IfThenElse(mask, yes.y, no.y)};
}

HWY_INLINE V norm(const V2& v)
{
  return hn::Sqrt(hn::MulAdd(v.x, v.x, v.y * v.y));
}

/// At the rim, with its slopes by the rim's displacement, rows first, and by the load on the wall.
struct Friction
{
  V2 force, bristle, first_row, second_row, by_load;
  V rest;
};

struct Surface
{
  V2 bristle, displacement, velocity, trial;
  V stiffness, size;
};

HWY_INLINE Surface surface_of(const Numbers& n, const StageContext& at, const NumberColumns& columns, int i)
{
  using namespace guided_column;
  Surface s;
  s.bristle = {n.bristle_along, n.bristle_around};
  s.displacement = {load(columns[along] + i), n.lever * load(columns[about] + i)};
  s.velocity = {load(columns[along_rate] + i), n.lever * load(columns[about_rate] + i)};
  s.trial = {hn::MulAdd(n.stiffness, s.bristle.x + s.displacement.x, n.damping * s.velocity.x),
             hn::MulAdd(n.stiffness, s.bristle.y + s.displacement.y, n.damping * s.velocity.y)};
  s.size = norm(s.trial);
  s.stiffness = hn::MulAdd(all(at.stage.dv_du), n.damping, n.stiffness);
  return s;
}

/// Of what slips, by the Stribeck curve; returns which that is.
HWY_INLINE Mask slip(const Numbers& n, const StageContext& at, const Surface& s, V normal, Friction& f)
{
  const V one = all(1.0), zero = all(0.0);
  const V speed = norm(s.velocity), by_stribeck = one / n.stribeck_speed, x = speed * by_stribeck;
  const bool exponential = at.model.scene().contact.stribeck_curve == StribeckCurve::exponential;
  const V excess = n.friction * (n.static_ratio - one) * hn::Exp(Tag(), hn::Neg(exponential ? x : x * x));
  const V slope_by_speed = exponential ? hn::IfThenElseZero(speed > zero, hn::Neg(excess * by_stribeck) / speed)
                                       : all(-2.0) * by_stribeck * by_stribeck * excess;
  const V mu = n.friction + excess, limit = mu * normal;
  const Mask slips = s.size > limit;
  const V inverse = one / s.size;
  const V2 d{inverse * s.trial.x, inverse * s.trial.y};
  f.force = choose(slips, {hn::Neg(limit * d.x), hn::Neg(limit * d.y)}, f.force);
  const V time = all(at.stage.time), of_limit = limit / n.stiffness;
  const V elastic = time * n.stiffness, follows = hn::IfThenElse(n.damping > zero, elastic / (elastic + n.damping), one);
  f.bristle = choose(slips,
                     {hn::MulAdd(follows, hn::MulSub(of_limit, d.x, s.bristle.x), s.bristle.x),
                      hn::MulAdd(follows, hn::MulSub(of_limit, d.y, s.bristle.y), s.bristle.y)},
                     f.bristle);
  f.by_load = choose(slips, {hn::Neg(mu * d.x), hn::Neg(mu * d.y)}, f.by_load);
  const V across = limit * inverse * s.stiffness;
  const V by_speed = slope_by_speed * normal * all(at.stage.dv_du);
  const V off = across * d.x * d.y;
  f.first_row = choose(slips,
                       {hn::NegMulAdd(by_speed * d.x, s.velocity.x, hn::Neg(across * hn::NegMulAdd(d.x, d.x, one))),
                        hn::NegMulAdd(by_speed * d.x, s.velocity.y, off)},
                       f.first_row);
  f.second_row = choose(slips,
                        {hn::NegMulAdd(by_speed * d.y, s.velocity.x, off),
                         hn::NegMulAdd(by_speed * d.y, s.velocity.y, hn::Neg(across * hn::NegMulAdd(d.y, d.y, one)))},
                        f.second_row);
  return slips;
}

HWY_INLINE Friction friction_of(const Numbers& n, const StageContext& at, const Surface& s, const Load& load)
{
  const V zero = all(0.0);
  const V2 none{zero, zero};
  Friction f;
  f.force = {hn::Neg(s.trial.x), hn::Neg(s.trial.y)};
  f.bristle = {s.bristle.x + s.displacement.x, s.bristle.y + s.displacement.y};
  f.first_row = {hn::Neg(s.stiffness), zero};
  f.second_row = {zero, hn::Neg(s.stiffness)};
  f.by_load = none;
  Mask slips = zero > zero;
  if (!hn::AllTrue(Tag(), s.size <= n.friction * load.normal)) slips = slip(n, at, s, load.normal, f);
  const Mask there = hn::And(load.normal > zero, n.friction > zero);
  f.force = choose(there, f.force, none);
  f.bristle = choose(there, f.bristle, none);
  f.first_row = choose(there, f.first_row, none);
  f.second_row = choose(there, f.second_row, none);
  f.by_load = choose(there, {load.normal_by_size * f.by_load.x, load.normal_by_size * f.by_load.y}, none);
  f.rest = hn::IfThenElseZero(hn::And(there, hn::Not(slips)), n.rest + all(at.stage.time));
  return f;
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
  store_along(along_hole, about_hole, n.tangent, rows_to(residual, 6, b, spare));
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
  const Friction f = friction_of(n, at, surface_of(n, at, columns, b.i), on_wall);
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
  store4<false>(normal.x, normal.y, normal.z, tilt.x, to, 6);
  store4<false>(normal.z, tilt.x, tilt.y, tilt.z, to, 8);
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
/// Numbers in a row from `from` on; those behind the last are the last.
HWY_INLINE V take(const double* from, int count)
{
  if (count == kLanes) return load(from);
  HWY_ALIGN double numbers[kLanes];
  for (int k = 0; k < kLanes; ++k) numbers[k] = from[k < count ? k : count - 1];
  return hn::Load(Tag(), numbers);
}

HWY_INLINE V3 take3(const Eigen::Vector3d* from, int count)
{
  HWY_ALIGN double numbers[3][kLanes];
  for (int k = 0; k < kLanes; ++k)
    for (int j = 0; j < 3; ++j) numbers[j][k] = from[k < count ? k : count - 1][j];
  return {hn::Load(Tag(), numbers[0]), hn::Load(Tag(), numbers[1]), hn::Load(Tag(), numbers[2])};
}

template <class Batch>
HWY_INLINE Rows states_of(const State& state, const double& member_of_first, Batch b)
{
  return rows_of(state.nodes, member_of_first, b);
}

/// HoleSegment's numbers.
constexpr int segment_md_at = 15, segment_friction_at = 19;
static_assert(sizeof(HoleSegment) == 23 * sizeof(double), "a segment's numbers");

/// A node's numbers from the state: tangent and centre of the hole into columns, what its wall is like into the guide.
template <class Batch>
void find_node_batch(const Model& model, const State& state, Stage& stage, Batch b)
{
  using namespace guide_column;
  const V4 p = load4(states_of(state, state.nodes[0].position.x(), b), 0), q = load4(states_of(state, state.nodes[0].orientation.x(), b), 0);
  const V4 d = load4(states_of(state, state.nodes[0].md, b), 0), z = load4(states_of(state, state.nodes[0].bristle.x(), b), 0);
  NumberColumns& columns = stage.guided_columns;
  store(x_axis({q.a, q.b, q.c, q.d}), columns, tangent, b.i + 1);
  store(V3{p.a, p.b, p.c} - V3{d.b, d.c, d.d}, columns, centre, b.i + 1);
  Rows segments;
  for (int k = 0; k < kLanes; ++k)
  {
    const NodeState& node = state.nodes[static_cast<std::size_t>(b.i + (k < b.count ? k : 0))];
    int segment = node.segment;
    segments.row[k] = const_cast<double*>(state.well.segment_there(node.md, segment).c0.data());
  }
  const V4 m = load4(segments, segment_md_at), f = load4(segments, segment_friction_at);
  const V s = (d.a - m.a) / m.b, zero = all(0.0);
  const Mask in_hole = d.a > zero;
  if (model.contact_varies())
  {
    HWY_ALIGN double section[kLanes];
    hn::Store(hn::MulAdd(s, f.d, f.c), Tag(), section);
    for (int k = 0; k < b.count; ++k)
    {
      const std::size_t i = static_cast<std::size_t>(b.i + k);
      stage.guides[i].law = model.contact(b.i + k, section[k], state.nodes[i].rest);
    }
  }
  double spare[4];
  const Rows guide = rows_to(stage.guides, stage.guides[0].tangent.x(), b, spare);
  const Rows from = guides_of(stage, b);
  const V4 friction = load4(from, friction_at), law = load4(from, law_at);
  const V immersed = take(&stage.immersed[static_cast<std::size_t>(b.i)], b.count);
  const auto put = [&](V x, V y, V u, V v, int at)
  {
    Rows to = guide;
    for (int k = 0; k < b.count; ++k) to.row[k] += at;
    store4<false>(x, y, u, v, to, 0);
  };
  const V kinetic = hn::IfThenElseZero(in_hole, hn::MulAdd(s, f.b, f.a));
  const V room = hn::Max(zero, hn::MulAdd(s, m.d, m.c) - load(columns[bearing_radius] + b.i + 1));
  put(immersed * load(columns[mud_along] + b.i + 1), immersed * load(columns[mud_about] + b.i + 1), kinetic, friction.b, mass_at + 2);
  put(kinetic, friction.b, hn::IfThenElseZero(in_hole, room), law.c * z.b, friction_at);
}

/// An element's direction, turn and load into columns, its stretch and twist into the span.
template <class Batch>
void find_element_batch(const State& state, Stage& stage, Batch b)
{
  using namespace guide_column;
  NumberColumns& columns = stage.guided_columns;
  const int lower = b.i + 1, upper = b.i + 2;
  const V4 at_lower = load4(states_of(state, state.nodes[0].md, b), 0), at_upper = load4(states_of(state, state.nodes[0].md, b.next()), 0);
  const V3 way = load3(columns, centre, upper) - load3(columns, centre, lower);
  const V chord = hn::Sqrt(dot(way, way)), axis = at_lower.a - at_upper.a, one = all(1.0);
  const V3 line = way + V3{at_upper.b - at_lower.b, at_upper.c - at_lower.c, at_upper.d - at_lower.d};
  const V free = take(&stage.free_stretch[static_cast<std::size_t>(b.i)], b.count);
  const V stretch = axis + hn::Sqrt(dot(line, line)) - chord - load(columns[length] + lower) * (one + free);
  const V twist = load4(rows_of(state.spans, state.spans[0].twist, b), 0).a;
  double spare[2];
  store2(stretch, twist, rows_to(stage.guided_spans, stage.guided_spans[0].stretch, b, spare));
  store((one / chord) * way, columns, direction, lower);
  const V3 t = load3(columns, tangent, lower);
  store((one / axis) * cross(t, t - load3(columns, tangent, upper)), columns, turn, lower);
  store(all(0.5) * take3(&stage.load[static_cast<std::size_t>(b.i)], b.count), columns, half_load, lower);
}

/// Beside a run there are no guided elements.
void close_ends(NumberColumns& columns, Runs::Run nodes)
{
  using namespace guide_column;
  for (int k = 0; k < 3; ++k)
  {
    columns[direction + k][nodes.first] = columns[direction + k][nodes.last] = 0.0;
    columns[half_load + k][nodes.first] = columns[half_load + k][nodes.last] = 0.0;
    columns[turn + k][nodes.last] = nodes.last - nodes.first > 1 ? columns[turn + k][nodes.last - 1] : 0.0;
  }
}

/// What its elements are to a node.
template <class Batch>
void find_ends_batch(Stage& stage, Batch b)
{
  using namespace guide_column;
  const NumberColumns& columns = stage.guided_columns;
  const int i = b.i + 1;
  const V3 t = load3(columns, tangent, i), to_above = load3(columns, direction, i), to_below = load3(columns, direction, i - 1);
  const V3 above = mul_sub_from(dot(t, to_above), t, to_above), below = -mul_sub_from(dot(t, to_below), t, to_below);
  const V3 weight = load3(columns, half_load, i) + load3(columns, half_load, i - 1);
  double spare[36];
  const Rows guide = rows_to(stage.guides, stage.guides[0].tangent.x(), b, spare);
  store4<false>(t.x, t.y, t.z, above.x, guide, 0);
  store4<false>(above.y, above.z, below.x, below.y, guide, 4);
  store4<false>(below.z, weight.x, weight.y, weight.z, guide, 8);
  store6(load3(columns, turn, i), load3(columns, centre, i), guide, turn_at);
}

void find(const Model& model, const State& state, Stage& stage, Runs::Run nodes) noexcept
{
  each_batch(nodes, [&](auto b) { find_node_batch(model, state, stage, b); });
  each_batch({nodes.first, nodes.last - 1}, [&](auto b) { find_element_batch(state, stage, b); });
  close_ends(stage.guided_columns, nodes);
  each_batch(nodes, [&](auto b) { find_ends_batch(stage, b); });
}

/// sin(x)/x and cos(x); far from 0 one by one.
HWY_INLINE V2 sine_and_cosine(V x)
{
  constexpr double near = 0.5;
  const V one = all(1.0), y = x * x;
  if (hn::AllTrue(Tag(), y <= all(near * near)))
  {
    const auto series = [&](int first)
    {
      V sum = one;
      for (int n = first + 14; n > first; n -= 2) sum = hn::NegMulAdd(y * all(1.0 / (n * (n - 1))), sum, one);
      return sum;
    };
    return {series(1), series(0)};
  }
  HWY_ALIGN double angle[kLanes], sine[kLanes], cosine[kLanes];
  hn::Store(x, Tag(), angle);
  for (int k = 0; k < kLanes; ++k)
  {
    sine[k] = angle[k] != 0.0 ? std::sin(angle[k]) / angle[k] : 1.0;
    cosine[k] = std::cos(angle[k]);
  }
  return {hn::Load(Tag(), sine), hn::Load(Tag(), cosine)};
}

HWY_INLINE Quaternion normalized(const Quaternion& q)
{
  const V scale = all(1.0) / hn::Sqrt(hn::MulAdd(q.x, q.x, hn::MulAdd(q.y, q.y, hn::MulAdd(q.z, q.z, q.w * q.w))));
  return {scale * q.x, scale * q.y, scale * q.z, scale * q.w};
}

/// climbed() of the lean.
HWY_INLINE V3 climbed(const V3& t, const V3& push, V around)
{
  const V square = dot(push, push), left = hn::NegMulAdd(around, around, square);
  const V3 turned = (all(1.0) / hn::Sqrt(square)) * mul_add(hn::Sqrt(left), push, around * cross(t, push));
  const Mask climbs = left > all(0.0);
  return {hn::IfThenElse(climbs, turned.x, push.x), hn::IfThenElse(climbs, turned.y, push.y), hn::IfThenElse(climbs, turned.z, push.z)};
}

struct HolePlace
{
  V3 position, tangent;
};

/// The hole at these depths; the nodes' segments are brought up to date.
template <class Batch>
HWY_INLINE HolePlace place_of(State& state, V md, Batch b)
{
  HWY_ALIGN double depth[kLanes];
  hn::Store(md, Tag(), depth);
  Rows segments;
  for (int k = 0; k < kLanes; ++k)
  {
    const int lane = k < b.count ? k : 0;
    int& segment = state.nodes[static_cast<std::size_t>(b.i + lane)].segment;
    segments.row[k] = const_cast<double*>(state.well.segment_there(depth[lane], segment).c0.data());
  }
  const V4 p = load4(segments, 0), q = load4(segments, 4), r = load4(segments, 8), m = load4(segments, segment_md_at);
  const V3 c0{p.a, p.b, p.c}, c1{p.d, q.a, q.b}, c2{q.c, q.d, r.a}, c3{r.b, r.c, r.d};
  const V s = (md - m.a) / m.b, two = all(2.0);
  const V3 cubic = s * c3, slope = mul_add(s, mul_add(two, c2, all(3.0) * cubic), c1);
  return {mul_add(s, mul_add(s, c2 + cubic, c1), c0), (all(1.0) / hn::Sqrt(dot(slope, slope))) * slope};
}

template <class Batch>
void commit_batch(const Stage& stage, const Workspace& work, double follows, State& state, Batch b)
{
  const Rows guide = guides_of(stage, b), moved = rows_of(work.guided, work.guided[0].along, b);
  const V4 g = load4(guide, 0), w = load4(guide, turn_at), f = load4(guide, friction_at), m = load4(moved, 0), l = load4(moved, 9);
  const V4 d = load4(states_of(state, state.nodes[0].md, b), 0), o = load4(states_of(state, state.nodes[0].orientation.x(), b), 0);
  const V spin_angle = load4(states_of(state, state.nodes[0].orientation.x(), b), 1).d + m.b, one = all(1.0);
  const V3 t{g.a, g.b, g.c}, turn{w.a, w.b, w.c};
  const V3 on_wall = climbed(t, {l.a, l.b, l.c}, l.d);
  const V reach = f.c / (all(pressed) + hn::Sqrt(dot(on_wall, on_wall)));
  const V3 old_side{d.b, d.c, d.d}, aside = mul_add(all(follows), reach * on_wall - old_side, old_side);
  const V md = d.a + m.a;
  const HolePlace hole = place_of(state, md, b);
  const V3 side = mul_sub_from(dot(hole.tangent, aside), hole.tangent, aside), position = hole.position + side;
  const V half = all(0.5) * m.b;
  const V2 sc = sine_and_cosine(half);
  const V3 about = (half * sc.x) * t;
  const Quaternion turned = Quaternion{about.x, about.y, about.z, sc.y} * Quaternion{o.a, o.b, o.c, o.d};
  const V3 normal = x_axis(turned), tilt = cross(normal, hole.tangent), arm = all(0.5) * tilt;
  const Quaternion q = normalized(Quaternion{arm.x, arm.y, arm.z, one} * turned);
  double spare[16];
  store4<false>(position.x, position.y, position.z, q.x, rows_to(state.nodes, state.nodes[0].position.x(), b, spare), 0);  // x is written again
  const Rows to = rows_to(state.nodes, state.nodes[0].orientation.x(), b, spare);  // then spin_angle and rate
  store4<false>(q.x, q.y, q.z, q.w, to, 0);
  const V3 velocity = m.c * t, tilting = m.c * turn;
  store4<false>(spin_angle, velocity.x, velocity.y, velocity.z, to, 4);
  store4<false>(tilting.x, tilting.y, tilting.z, m.d, to, 8);
  store4<false>(md, side.x, side.y, side.z, rows_to(state.nodes, state.nodes[0].md, b, spare), 0);
  constexpr double small = 1e-3;  // [rad]; beyond, one by one
  if (hn::AllTrue(Tag(), hn::And(dot(tilt, tilt) <= all(small * small), dot(normal, hole.tangent) >= all(0.0)))) return;
  HWY_ALIGN double tangents[3][kLanes], quaternions[4][kLanes];
  hn::Store(hole.tangent.x, Tag(), tangents[0]);
  hn::Store(hole.tangent.y, Tag(), tangents[1]);
  hn::Store(hole.tangent.z, Tag(), tangents[2]);
  hn::Store(turned.x, Tag(), quaternions[0]);
  hn::Store(turned.y, Tag(), quaternions[1]);
  hn::Store(turned.z, Tag(), quaternions[2]);
  hn::Store(turned.w, Tag(), quaternions[3]);
  for (int k = 0; k < b.count; ++k)
    state.nodes[static_cast<std::size_t>(b.i + k)].orientation =
        turned_to({tangents[0][k], tangents[1][k], tangents[2][k]}, {quaternions[3][k], quaternions[0][k], quaternions[1][k], quaternions[2][k]});
}

void commit(const Stage& stage, const Workspace& work, double follows, Runs::Run nodes, State& state) noexcept
{
  each_batch(nodes, [&](auto b) { commit_batch(stage, work, follows, state, b); });
}
}  // namespace

constexpr GuidedKernel table = {find, commit, move, find_tensions, add, reduce, expand, expand_motions};
}  // namespace drill_rig_sim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif

#if DRILL_RIG_SIM_ONCE
namespace drill_rig_sim
{
const GuidedKernel* guided_kernel(Kernel kernel) noexcept
{
  constexpr const GuidedKernel* none = nullptr;
  return DRILL_RIG_SIM_TABLE(kernel, none, table);
}
}  // namespace drill_rig_sim
#endif
