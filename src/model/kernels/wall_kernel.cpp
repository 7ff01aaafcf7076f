// The law of contact/wall_contact.h for several nodes at a time.
#include "drill_rig_sim/model/kernels/wall_kernel.h"

#include <cstddef>

#include "drill_rig_sim/contact/wall_contact.h"
#include "drill_rig_sim/math/number_columns.h"

#ifndef DRILL_RIG_SIM_KERNELS_TOGETHER
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "model/kernels/wall_kernel.cpp"
#endif
#include "math/simd.h"
#ifdef DRILL_RIG_SIM_HIGHWAY
#include <hwy/contrib/math/math-inl.h>  // in every pass
#endif

#if DRILL_RIG_SIM_WIDE
HWY_BEFORE_NAMESPACE();
namespace drill_rig_sim::HWY_NAMESPACE::of_wall
{
namespace
{
#include "math/lanes.h"
#include "math/lane_powers.h"
#include "drill_rig_sim/contact/normal_text.h"
#include "drill_rig_sim/contact/friction_text.h"
#include "drill_rig_sim/contact/wall_text.h"

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

HWY_INLINE Contact load_contact(const WallPlace* places, int count, bool exponential)
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
  c.exponent = k.b;
  c.damping = k.c;
  c.rubbing = {s.d, l.a, k.d, l.b, l.c, exponential};
  c.lever = l.d;
  c.radius = m.a;
  return c;
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
  const Contact c = load_contact(places, count, task.exponential);
  Wall w;
  press(c, w);
  rub(c, all(task.time), w);
  double spare[36] = {};
  // a clear contact has neither friction nor a bristle
  const auto touching = [&](const V3& v) { return choose(w.touches, v, V3{all(0.0), all(0.0), all(0.0)}); };
  w.friction.force = touching(w.friction.force);
  const V3 force = mul_sub_from(w.normal.value, w.n, w.friction.force), moment = c.lever * cross(w.n, w.friction.force);
  const Rows residual = rows_to(places, count, &WallPlace::residual, spare);
  store4<true>(hn::Neg(force.x), hn::Neg(force.y), hn::Neg(force.z), hn::Neg(moment.x), residual, 0);
  HWY_ALIGN double y[kLanes], z[kLanes], normal[kLanes], stuck[kLanes];
  hn::Store(moment.y, Tag(), y);
  hn::Store(moment.z, Tag(), z);
  hn::Store(w.normal.value, Tag(), normal);
  hn::Store(hn::IfThenElse(hn::And(w.normal.value > all(0.0), hn::Not(w.friction.slipping)), all(1.0), all(0.0)), Tag(), stuck);
  for (int k = 0; k < count; ++k)
  {
    places[k].residual[4] -= y[k];
    places[k].residual[5] -= z[k];
    *places[k].normal_force = normal[k];
    *places[k].rest = stuck[k] > 0.0 ? *places[k].rest + task.time : 0.0;
  }
  put_singly(force, places, count, &WallPlace::wall);
  put_singly(touching(w.friction.bristle), places, count, &WallPlace::bristle_after);
  if (!places[0].diagonal) return;
  V block[36];
  find_wall_tangent(c, w, all(task.dv_du), block);
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
}  // namespace drill_rig_sim::HWY_NAMESPACE::of_wall
HWY_AFTER_NAMESPACE();
#endif

#if DRILL_RIG_SIM_ONCE
namespace drill_rig_sim
{
const WallKernel* wall_kernel(Kernel kernel) noexcept
{
  constexpr const WallKernel* none = nullptr;
  return DRILL_RIG_SIM_TABLE(kernel, none, of_wall::table);
}
}  // namespace drill_rig_sim
#endif
