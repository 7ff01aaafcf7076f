// The formulas are those of contact/wall_contact.cpp; symbols as there.
#include "drill_rig_sim/model/kernels/wall_kernel.h"

#include <cstddef>

#include "drill_rig_sim/math/number_columns.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "model/kernels/wall_kernel.cpp"
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

/// Where numbers are in NodeMoves (workspace.h).
constexpr int position_at = 7, increment_at = 18, rate_at = 24;

template <class Pointer>
HWY_INLINE Rows rows_of(const WallPlace* places, int count, Pointer WallPlace::*member)
{
  Rows out;
  for (int k = 0; k < kLanes; ++k) out.row[k] = const_cast<double*>(places[k < count ? k : 0].*member);
  return out;
}

/// To write to: those behind the last go nowhere.
HWY_INLINE Rows rows_to(const WallPlace* places, int count, double* WallPlace::*member, double* spare)
{
  Rows out;
  for (int k = 0; k < kLanes; ++k) out.row[k] = k < count ? places[k].*member : spare;
  return out;
}

/// ClosestPoint, ContactMotion, bristle and law.
struct Contact
{
  V3 centre, slope, gradient;
  V hole_radius, radius_slope, kinetic;
  V3 position, displacement, rotation, velocity, turning, bristle;
  V stiffness, damping, stribeck_speed, static_ratio, tangential_stiffness, tangential_damping, lever, radius;
};

HWY_INLINE Contact load_contact(const WallPlace* places, int count)
{
  Contact c;
  const Rows closest = rows_of(places, count, &WallPlace::closest), moves = rows_of(places, count, &WallPlace::moves);
  const Rows law = rows_of(places, count, &WallPlace::law);
  const V4 p = load4(closest, 0), q = load4(closest, 7), r = load4(closest, 9), s = load4(closest, 12);
  c.centre = {p.b, p.c, p.d};
  c.slope = {q.a, q.b, r.a};
  c.gradient = {r.b, r.c, s.a};
  c.hole_radius = s.b;
  c.radius_slope = s.c;
  c.kinetic = s.d;
  const V4 at = load4(moves, position_at);
  c.position = {at.a, at.b, at.c};
  const V4 u = load4(moves, increment_at), w = load4(moves, increment_at + 2), v = load4(moves, rate_at), t = load4(moves, rate_at + 2);
  c.displacement = {u.a, u.b, u.c};
  c.rotation = {u.d, w.c, w.d};
  c.velocity = {v.a, v.b, v.c};
  c.turning = {v.d, t.c, t.d};
  HWY_ALIGN double bristle[3][kLanes];
  for (int k = 0; k < kLanes; ++k)
    for (int j = 0; j < 3; ++j) bristle[j][k] = places[k < count ? k : 0].bristle[j];
  c.bristle = {hn::Load(Tag(), bristle[0]), hn::Load(Tag(), bristle[1]), hn::Load(Tag(), bristle[2])};
  const V4 k = load4(law, 0), l = load4(law, 4), m = load4(law, 8);
  c.stiffness = k.a;
  c.damping = k.c;
  c.stribeck_speed = k.d;
  c.static_ratio = l.a;
  c.tangential_stiffness = l.b;
  c.tangential_damping = l.c;
  c.lever = l.d;
  c.radius = m.a;
  return c;
}

/// Geometry, normal force and friction.
struct Wall
{
  V rho;
  V3 n, gradient, slope;
  V force, stiffness, damping;  // normal, and its derivatives
  V3 surface_velocity, pull, friction, bristle;
  V trial;
  V3 direction, slip_direction;  // of what slips, else zero
  V mu, mu_slope;
  Mask touches, slipping;
};

HWY_INLINE V3 in_plane(const V3& n, const V3& v)
{
  return mul_sub_from(dot(n, v), n, v);
}

HWY_INLINE V norm(const V3& v)
{
  return hn::Sqrt(dot(v, v));
}

HWY_INLINE void press(const Contact& c, Wall& w)
{
  const V one = all(1.0), zero = all(0.0);
  const V3 d = c.position - c.centre;
  w.rho = hn::Sqrt(dot(d, d) + all(1e-7 * 1e-7));  // wall_contact_smoothing
  const V penetration = hn::Max(w.rho - (c.hole_radius - c.radius), zero);
  w.touches = penetration > zero;
  w.n = (one / w.rho) * d;
  w.gradient = mul_sub_from(c.radius_slope, c.gradient, w.n);
  w.slope = in_plane(w.n, c.slope);
  const V factor = hn::Max(hn::MulAdd(c.damping, dot(w.gradient, c.velocity), one), zero);
  const V slope = hn::IfThenElseZero(factor > zero, c.stiffness * hn::Sqrt(penetration));
  w.force = slope * penetration * factor;
  w.stiffness = all(1.5) * slope * factor;
  w.damping = slope * penetration * c.damping;
}

/// What slips: the Stribeck curve.
HWY_INLINE void slip(const Contact& c, const WallTask& task, const V3& trial, Wall& w)
{
  const V zero = all(0.0);
  const V3 slipping = in_plane(w.n, w.surface_velocity);
  const V speed = norm(slipping), x = speed / c.stribeck_speed;
  const V excess = c.kinetic * (c.static_ratio - all(1.0)) * hn::Exp(Tag(), hn::Neg(task.exponential ? x : x * x));
  const V slope = task.exponential ? hn::Neg(excess / c.stribeck_speed) : all(-2.0) * x / c.stribeck_speed * excess;
  w.mu = c.kinetic + excess;
  w.mu_slope = slope;
  const V limit = w.mu * w.force;
  w.slipping = w.trial > limit;
  const V3 none{zero, zero, zero};
  w.direction = choose(w.slipping, (all(1.0) / w.trial) * trial, none);
  w.slip_direction = choose(hn::And(w.slipping, speed > zero), (all(1.0) / speed) * slipping, none);
  w.friction = choose(w.slipping, hn::Neg(limit) * w.direction, w.friction);
  const V time = all(task.time);
  const V follows = hn::IfThenElse(c.tangential_damping > zero, time / (time + c.tangential_damping / c.tangential_stiffness), all(1.0));
  const V3 before = in_plane(w.n, c.bristle);
  const V3 after = mul_add(follows, (limit / c.tangential_stiffness) * w.direction - before, before);
  w.bristle = choose(w.slipping, after, w.bristle);
}

HWY_INLINE void rub(const Contact& c, const WallTask& task, Wall& w)
{
  const V zero = all(0.0);
  const V3 arm = c.lever * w.n, none{zero, zero, zero};
  w.surface_velocity = c.velocity + cross(c.turning, arm);
  const V3 moved = c.bristle + c.displacement + cross(c.rotation, arm);
  w.pull = mul_add(c.tangential_stiffness, moved, c.tangential_damping * w.surface_velocity);
  const V3 trial = in_plane(w.n, w.pull);
  w.trial = norm(trial);
  w.friction = -trial;
  w.bristle = in_plane(w.n, moved);
  w.direction = w.slip_direction = none;
  w.mu = w.mu_slope = zero;
  w.slipping = zero > zero;
  if (!hn::AllTrue(Tag(), w.trial <= c.kinetic * w.force)) slip(c, task, trial, w);
}

/// d(force, moment)/d(x, r), by numbers row by row.
HWY_INLINE void find_tangent(const Contact& c, const Wall& w, double dv_du, V (&out)[36])
{
  const V rate = all(dv_du), zero = all(0.0), inverse_rho = all(1.0) / w.rho;
  const V3 n = w.n;
  // the columns of B
  const auto column_of_b = [&](V n_j, V gradient_j) { return inverse_rho * (-(n_j * n) - gradient_j * w.slope); };
  V3 b[3] = {column_of_b(n.x, c.gradient.x), column_of_b(n.y, c.gradient.y), column_of_b(n.z, c.gradient.z)};
  b[0].x = b[0].x + inverse_rho;
  b[1].y = b[1].y + inverse_rho;
  b[2].z = b[2].z + inverse_rho;
  const auto transposed = [&](const V3& v) { return V3{dot(b[0], v), dot(b[1], v), dot(b[2], v)}; };
  const V3 normal_gradient = mul_add(hn::MulAdd(rate, w.damping, w.stiffness), w.gradient, w.damping * transposed(c.velocity));

  // of the friction's limit, where it slips
  const V3 e = w.slip_direction;
  const V per_speed = w.mu_slope * w.force, share = hn::IfThenElse(w.slipping, w.mu * w.force / w.trial, all(1.0));
  const V3 through = c.lever * cross(e, c.turning) - dot(n, w.surface_velocity) * e;
  const V3 limit_x = mul_add(w.mu, normal_gradient, per_speed * mul_add(rate, e, transposed(through)));
  const V3 limit_r = (per_speed * rate * c.lever) * cross(n, e);
  const auto friction = [&](V limit, const V3& trial)
  { return mul_sub_from(share, trial, hn::MulSub(share, dot(w.direction, trial), limit) * w.direction); };

  const V s = hn::MulAdd(rate, c.tangential_damping, c.tangential_stiffness);
  const V3 turn = mul_add(c.tangential_stiffness, c.rotation, c.tangential_damping * c.turning);
  const V along = dot(n, w.pull);
  const V3 row = mul_add(s, n, transposed(mul_add(c.lever, cross(n, turn), w.pull)));
  const V of_row[3] = {row.x, row.y, row.z}, of_gradient[3] = {normal_gradient.x, normal_gradient.y, normal_gradient.z};
  const V of_limit_x[3] = {limit_x.x, limit_x.y, limit_x.z}, of_limit_r[3] = {limit_r.x, limit_r.y, limit_r.z};
  const V3 arm = c.lever * n;
  const V3 turned[3] = {{zero, hn::Neg(s * arm.z), s * arm.y}, {s * arm.z, zero, hn::Neg(s * arm.x)}, {hn::Neg(s * arm.y), s * arm.x, zero}};
  const auto write = [&out](int column, const V3& force, const V3& moment)
  {
    out[column] = force.x;
    out[6 + column] = force.y;
    out[12 + column] = force.z;
    out[18 + column] = moment.x;
    out[24 + column] = moment.y;
    out[30 + column] = moment.z;
  };
  for (int j = 0; j < 3; ++j)
  {
    V3 trial = mul_sub_from(of_row[j], n, mul_sub_from(along, b[j], c.lever * cross(turn, b[j])));
    (j == 0 ? trial.x : j == 1 ? trial.y : trial.z) = (j == 0 ? trial.x : j == 1 ? trial.y : trial.z) + s;
    const V3 f = friction(of_limit_x[j], trial);
    write(j, f - mul_add(of_gradient[j], n, w.force * b[j]), c.lever * (cross(n, f) + cross(b[j], w.friction)));
    const V3 f_r = friction(of_limit_r[j], turned[j]);
    write(3 + j, f_r, cross(arm, f_r));
  }
}

/// Without a tail: numbers singly.
HWY_INLINE void put_singly(const V3& v, const WallPlace* places, int count, double* WallPlace::*member)
{
  HWY_ALIGN double numbers[3][kLanes];
  hn::Store(v.x, Tag(), numbers[0]);
  hn::Store(v.y, Tag(), numbers[1]);
  hn::Store(v.z, Tag(), numbers[2]);
  for (int k = 0; k < count; ++k)
    for (int j = 0; j < 3; ++j) (places[k].*member)[j] = numbers[j][k];
}

void add_batch(const WallTask& task, const WallPlace* places, int count)
{
  const Contact c = load_contact(places, count);
  Wall w;
  press(c, w);
  rub(c, task, w);
  double spare[36] = {};
  // a clear contact has neither friction nor a bristle
  const auto touching = [&](const V3& v) { return choose(w.touches, v, V3{all(0.0), all(0.0), all(0.0)}); };
  w.friction = touching(w.friction);
  const V3 force = mul_sub_from(w.force, w.n, w.friction), moment = c.lever * cross(w.n, w.friction);
  const Rows residual = rows_to(places, count, &WallPlace::residual, spare);
  store4<true>(hn::Neg(force.x), hn::Neg(force.y), hn::Neg(force.z), hn::Neg(moment.x), residual, 0);
  HWY_ALIGN double y[kLanes], z[kLanes], normal[kLanes], stuck[kLanes];
  hn::Store(moment.y, Tag(), y);
  hn::Store(moment.z, Tag(), z);
  hn::Store(w.force, Tag(), normal);
  hn::Store(hn::IfThenElse(hn::And(w.force > all(0.0), hn::Not(w.slipping)), all(1.0), all(0.0)), Tag(), stuck);
  for (int k = 0; k < count; ++k)
  {
    places[k].residual[4] -= y[k];
    places[k].residual[5] -= z[k];
    *places[k].normal_force = normal[k];
    *places[k].rest = stuck[k] > 0.0 ? *places[k].rest + task.time : 0.0;
  }
  put_singly(force, places, count, &WallPlace::wall);
  put_singly(touching(w.bristle), places, count, &WallPlace::bristle_after);
  if (!places[0].diagonal) return;
  V block[36];
  find_tangent(c, w, task.dv_du, block);
  const Rows diagonal = rows_to(places, count, &WallPlace::diagonal, spare);
  const auto minus = [&](int q) { return hn::IfThenElseZero(w.touches, hn::Neg(block[q])); };
  for (int q = 0; q < 36; q += 4) store4<true>(minus(q), minus(q + 1), minus(q + 2), minus(q + 3), diagonal, q);
}

void add(const WallTask& task) noexcept
{
  for (int i = 0; i < task.count; i += kLanes) add_batch(task, task.places + i, lanes_from(i, task.count));
}
}  // namespace

constexpr WallKernel table = {add};
}  // namespace drill_rig_sim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif

#if DRILL_RIG_SIM_ONCE
namespace drill_rig_sim
{
const WallKernel* wall_kernel(Kernel kernel) noexcept
{
  constexpr const WallKernel* none = nullptr;
  return DRILL_RIG_SIM_TABLE(kernel, none, table);
}
}  // namespace drill_rig_sim
#endif
