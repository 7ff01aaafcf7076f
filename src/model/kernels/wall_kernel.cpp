// SPDX-License-Identifier: BSD-3-Clause
// The law of contact/wall_contact.h for several nodes at a time.
#include "drill_rig_sim/model/kernels/wall_kernel.h"

#include "drill_rig_sim/contact/wall_contact.h"
#include "drill_rig_sim/model/workspace.h"

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

HWY_INLINE Contact load_contact(const WallPlace* places, int count, bool exponential)
{
  const auto number = [&](auto get) { return load1(rows_of(places, count, get)); };
  const auto vector = [&](auto get) { return load3(rows_of(places, count, get)); };
  const auto of_law = [&](double WallLaw::*member) { return number([member](const WallPlace& p) { return &(p.law->*member); }); };
  const auto of_normal = [&](double ContactLaw::*member)
  { return number([member](const WallPlace& p) { return &(p.law->law.*member); }); };
  const V6 moved = load6(rows_of(places, count, [](const WallPlace& p) { return p.node->increment.data(); }));
  const V6 rate = load6(rows_of(places, count, [](const WallPlace& p) { return p.node->rate.data(); }));
  Contact c;
  c.centre = vector([](const WallPlace& p) { return p.node->closest.centre.data(); });
  c.slope = vector([](const WallPlace& p) { return p.node->closest.centre_slope.data(); });
  c.gradient = vector([](const WallPlace& p) { return p.node->closest.md_gradient.data(); });
  c.hole_radius = number([](const WallPlace& p) { return &p.node->closest.radius; });
  c.radius_slope = number([](const WallPlace& p) { return &p.node->closest.radius_slope; });
  c.position = vector([](const WallPlace& p) { return p.node->position.data(); });
  c.displacement = moved.head;
  c.rotation = moved.tail;
  c.velocity = rate.head;
  c.turning = rate.tail;
  c.bristle = vector([](const WallPlace& p) { return p.bristle->data(); });
  c.stiffness = of_normal(&ContactLaw::stiffness);
  c.exponent = of_normal(&ContactLaw::exponent);
  c.damping = of_normal(&ContactLaw::damping);
  c.rubbing = {number([](const WallPlace& p) { return &p.node->closest.friction; }),
               of_law(&WallLaw::static_ratio),
               of_law(&WallLaw::stribeck_speed),
               of_law(&WallLaw::tangential_stiffness),
               of_law(&WallLaw::tangential_damping),
               exponential};
  c.lever = number([](const WallPlace& p) { return &p.lever; });
  c.radius = number([](const WallPlace& p) { return &p.radius; });
  return c;
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
  const Rows residual = rows_to(places, count, spare, [](const WallPlace& p) { return p.residual; });
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
  store3(force, rows_to(places, count, spare, [](const WallPlace& p) { return p.wall->data(); }));
  store3(touching(w.friction.bristle), rows_to(places, count, spare, [](const WallPlace& p) { return p.bristle_after->data(); }));
  if (!places[0].diagonal) return;
  V block[36];
  find_wall_tangent(c, w, all(task.dv_du), block);
  const Rows diagonal = rows_to(places, count, spare, [](const WallPlace& p) { return p.diagonal; });
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
