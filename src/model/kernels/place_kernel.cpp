// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/model/kernels/place_kernel.h"

#include <cstdint>

#include "drill_rig_sim/contact/wall_contact.h"
#include "drill_rig_sim/model/workspace.h"

#ifndef DRILL_RIG_SIM_KERNELS_TOGETHER
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "model/kernels/place_kernel.cpp"
#endif
#include "math/simd.h"

#if DRILL_RIG_SIM_WIDE
HWY_BEFORE_NAMESPACE();
namespace drill_rig_sim::HWY_NAMESPACE::of_place
{
namespace
{
#include "math/lanes.h"
// behind it
#include "drill_rig_sim/well/locate_text.h"

constexpr int most_iterations = 4;  // one that takes more is searched singly
constexpr double step_tolerance = 1e-7;
constexpr double far_outside = 0.1;
constexpr double slack = 1e-9;

/// A hole's numbers.
struct Hole
{
  Cubic curve;
  V3 chord;
  HoleNumbers numbers;
};

HWY_INLINE Hole load_hole(const HoleColumns& from, int i)
{
  return {{load3(from.c0, i), load3(from.c1, i), load3(from.c2, i), load3(from.c3, i)},
          load3(from.chord, i),
          {load(from.md, i), load(from.length, i), load(from.radius, i), load(from.radius_change, i), load(from.friction, i),
           load(from.friction_change, i), load(from.section, i), load(from.section_change, i)}};
}

/// Which of them end within their segment, near its axis. One that has arrived stays, however long its neighbours take: what is
/// found does not depend on who is searched beside it.
HWY_INLINE Mask refine(const Hole& g, const V3& point, Foot& foot)
{
  foot.s = dot(point - g.curve.c0, g.chord);
  Mask good = hn::And(foot.s >= all(-far_outside), foot.s <= all(1.0 + far_outside));
  V step = newton_step(g.curve, point, foot);
  foot.s = foot.s + step;
  for (int k = 1; k < most_iterations; ++k)
  {
    const Mask under_way = hn::And(hn::Abs(step) > all(step_tolerance), good);
    if (hn::AllFalse(Tag(), under_way)) break;
    Foot next = foot;
    const V next_step = newton_step(g.curve, point, next);
    foot.s = hn::IfThenElse(under_way, foot.s + next_step, foot.s);
    foot.centre = choose(under_way, next.centre, foot.centre);
    foot.first = choose(under_way, next.first, foot.first);
    foot.second = choose(under_way, next.second, foot.second);
    foot.decline = hn::IfThenElse(under_way, next.decline, foot.decline);
    step = hn::IfThenElse(under_way, next_step, step);
  }
  take_along(step, foot);
  const V3 away = point - foot.centre;
  good = hn::And(good, hn::Abs(step) <= all(step_tolerance));
  good = hn::And(good, hn::And(foot.s >= all(-slack), foot.s <= all(1.0 + slack)));
  return hn::And(good, dot(away, away) <= all(16.0) * g.numbers.radius * g.numbers.radius);
}

template <class Motion>
HWY_INLINE void write_closest(const Closest& c, const V3& centre, Motion* motions, int count)
{
  double spare[3];
  const auto vector = [&](const V3& v, Eigen::Vector3d ClosestPoint::*member)
  { store3(v, rows_to(motions, count, spare, [member](Motion& motion) { return (motion.closest.*member).data(); })); };
  const auto number = [&](V v, double ClosestPoint::*member)
  { store1(v, rows_to(motions, count, spare, [member](Motion& motion) { return &(motion.closest.*member); })); };
  number(c.md, &ClosestPoint::md);
  vector(centre, &ClosestPoint::centre);
  vector(c.tangent, &ClosestPoint::tangent);
  vector(c.slope, &ClosestPoint::centre_slope);
  vector(c.gradient, &ClosestPoint::md_gradient);
  number(c.radius, &ClosestPoint::radius);
  number(c.radius_slope, &ClosestPoint::radius_slope);
  number(c.friction, &ClosestPoint::friction);
  number(c.section, &ClosestPoint::section);
}

unsigned bits_of(Mask mask)
{
  std::uint8_t bits[8] = {};
  hn::StoreMaskBits(Tag(), mask, bits);
  return bits[0];
}

/// How far a point may go from here: not to the wall, nor to an end of its segment, nor anywhere where the hole's radius changes.
HWY_INLINE V room_of(const HoleNumbers& g, const Foot& foot, V gap)
{
  constexpr double share = 0.99, rounding = 1e-6;  // the hole's curvature, and [m]
  const V zero = all(0.0), to_end = g.length * hn::Min(foot.s, all(1.0) - foot.s);
  const V room = hn::MulSub(all(share), hn::Min(gap, to_end), all(rounding));
  return hn::IfThenElseZero(g.radius_change == zero, hn::Max(room, zero));
}

Mask mask_of(unsigned bits)
{
  HWY_ALIGN double lane[kLanes];
  for (int k = 0; k < kLanes; ++k) lane[k] = bits >> k & 1u;
  return hn::Load(Tag(), lane) > all(0.0);
}

HWY_INLINE void note(V value, Mask mask, Column& to, int i)
{
  store(hn::IfThenElse(mask, value, load(to, i)), to, i);
}

void note_search(const PlaceTask& task, int i, const V3& point, V room, Mask mask)
{
  note(point.x, mask, task.searched.part[0], i);
  note(point.y, mask, task.searched.part[1], i);
  note(point.z, mask, task.searched.part[2], i);
  note(room, mask, task.room, i);
}

template <class Motion>
void find_batch(const PlaceTask& task, int i, int count, Motion* motions)
{
  unsigned there = 0;
  for (int k = 0; k < count; ++k) there |= static_cast<unsigned>(task.beside[i + k]) << k;
  if (there == 0) return;
  const Hole g = load_hole(task.hole, i);
  const V3 point = load3(task.position, i);
  Foot foot;
  const unsigned found = bits_of(refine(g, point, foot)) & there;
  const Closest closest = closest_of(g.numbers, foot);
  const V3 away = point - foot.centre;
  const V off_centre = hn::Sqrt(dot(away, away) + all(wall_contact_smoothing * wall_contact_smoothing));
  const V gap = closest.radius - load(task.radius, i) - off_centre;
  const unsigned touches = bits_of(gap < all(0.0)) & found;
  for (int k = 0; k < count; ++k)
    if (found >> k & 1u) task.places[i + k] = touches >> k & 1u ? Place::touches : Place::clear;
  note_search(task, i, point, room_of(g.numbers, foot, gap), mask_of(found));
  if (touches != 0) write_closest(closest, foot.centre, motions + i, count);
}

void look(const PlaceTask& task) noexcept
{
  for (int i = task.first; i < task.last; i += kLanes)
  {
    const V3 gone = load3(task.position, i) - load3(task.searched, i);
    const V room = load(task.room, i);
    const unsigned clear = bits_of(dot(gone, gone) < room * room);
    for (int k = 0; k < kLanes; ++k) task.places[i + k] = clear >> k & 1u ? Place::clear : Place::search;
  }
}

template <class Motion>
void find(const PlaceTask& task, Motion* motions) noexcept
{
  for (int i = task.first; i < task.last; i += kLanes) find_batch(task, i, lanes_from(i, task.last), motions);
}

void find_middles(int first, int last, const NodeColumns& nodes, ElementColumns& elements) noexcept
{
  for (int e = first; e < last; e += kLanes)
  {
    const V arm = all(0.125) * load(elements.length, e);
    const V3 sum = load3(nodes.position, e) + load3(nodes.position, e + 1);
    const V3 upper = arm * load3(nodes.axis, e + 1), lower = arm * load3(nodes.axis, e);
    const V3 turned = cross(load6(nodes.increment, e + 1).tail, upper) - cross(load6(nodes.increment, e).tail, lower);
    store(mul_add(all(0.5), sum, upper - lower + turned), elements.middle, e);
  }
}
}  // namespace

constexpr PlaceKernel table = {look, find<NodeMotion>, find<SpanMotion>, find_middles};
}  // namespace drill_rig_sim::HWY_NAMESPACE::of_place
HWY_AFTER_NAMESPACE();
#endif

#if DRILL_RIG_SIM_ONCE
namespace drill_rig_sim
{
const PlaceKernel* place_kernel(Kernel kernel) noexcept
{
  constexpr const PlaceKernel* none = nullptr;
  return DRILL_RIG_SIM_TABLE(kernel, none, of_place::table);
}
}  // namespace drill_rig_sim
#endif
