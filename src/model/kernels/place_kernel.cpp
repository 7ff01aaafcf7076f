// Newton's method as in well/wellbore_locate.cpp, symbols as there.
#include "drill_rig_sim/model/kernels/place_kernel.h"

#include <cstdint>

#include "drill_rig_sim/model/kernels/string_columns.h"

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

constexpr int most_iterations = 4;  // one that takes more is searched singly
constexpr double step_tolerance = 1e-7;
constexpr double far_outside = 0.1;
constexpr double slack = 1e-9;

/// HoleSegments.
struct Segments
{
  V3 c0, c1, c2, c3, chord;
  V md, length, radius, radius_change, friction, friction_change, section, section_change;
};

HWY_INLINE Segments load_segments(const Rows& from)
{
  const V4 p = load4(from, 0), q = load4(from, 4), r = load4(from, 8), s = load4(from, 12), t = load4(from, 16), u = load4(from, 19);
  return {{p.a, p.b, p.c}, {p.d, q.a, q.b}, {q.c, q.d, r.a}, {r.b, r.c, r.d}, {s.a, s.b, s.c}, s.d, t.a, t.b, t.c, t.d, u.b, u.c, u.d};
}

struct Foot
{
  V s;
  V3 centre, first, second;
  V decline;
};

/// A step of Newton's method, at whose start the foot's curve is left.
HWY_INLINE V step_of(const Segments& g, const V3& point, Foot& foot)
{
  const V s = foot.s, two = all(2.0);
  const V3 cubic = s * g.c3;
  foot.second = mul_add(all(6.0), cubic, two * g.c2);
  foot.first = mul_add(s, mul_add(two, g.c2, all(3.0) * cubic), g.c1);
  foot.centre = mul_add(s, mul_add(s, g.c2 + cubic, g.c1), g.c0);
  const V3 offset = point - foot.centre;
  const V speed2 = dot(foot.first, foot.first);
  foot.decline = hn::Max(speed2 - dot(offset, foot.second), all(0.1) * speed2);
  return dot(offset, foot.first) / foot.decline;
}

/// Which of them end within their segment, near its axis. One that has arrived stays, however long its neighbours take: what is found does not
/// depend on who is searched beside it.
HWY_INLINE Mask refine(const Segments& g, const V3& point, Foot& foot)
{
  foot.s = dot(point - g.c0, g.chord);
  Mask good = hn::And(foot.s >= all(-far_outside), foot.s <= all(1.0 + far_outside));
  V step = step_of(g, point, foot);
  foot.s = foot.s + step;
  for (int k = 1; k < most_iterations; ++k)
  {
    const Mask under_way = hn::And(hn::Abs(step) > all(step_tolerance), good);
    if (hn::AllFalse(Tag(), under_way)) break;
    Foot next = foot;
    const V next_step = step_of(g, point, next);
    foot.s = hn::IfThenElse(under_way, foot.s + next_step, foot.s);
    foot.centre = choose(under_way, next.centre, foot.centre);
    foot.first = choose(under_way, next.first, foot.first);
    foot.second = choose(under_way, next.second, foot.second);
    foot.decline = hn::IfThenElse(under_way, next.decline, foot.decline);
    step = hn::IfThenElse(under_way, next_step, step);
  }
  foot.centre = mul_add(step, foot.first, foot.centre);
  foot.first = mul_add(step, foot.second, foot.first);
  const V3 away = point - foot.centre;
  good = hn::And(good, hn::Abs(step) <= all(step_tolerance));
  good = hn::And(good, hn::And(foot.s >= all(-slack), foot.s <= all(1.0 + slack)));
  return hn::And(good, dot(away, away) <= all(16.0) * g.radius * g.radius);
}

void write_closest(const Segments& g, const Foot& foot, V share, V radius, const Rows& to)
{
  const V inverse_length = all(1.0) / g.length;
  const V3 tangent = (all(1.0) / hn::Sqrt(dot(foot.first, foot.first))) * foot.first;
  const V3 slope = inverse_length * foot.first, gradient = (g.length / foot.decline) * foot.first;
  const V radius_slope = hn::IfThenElseZero(share == foot.s, g.radius_change * inverse_length);
  store4<false>(hn::MulAdd(foot.s, g.length, g.md), foot.centre.x, foot.centre.y, foot.centre.z, to, 0);
  store4<false>(tangent.x, tangent.y, tangent.z, slope.x, to, 4);
  store4<false>(slope.y, slope.z, gradient.x, gradient.y, to, 8);
  store4<false>(gradient.z, radius, radius_slope, hn::MulAdd(share, g.friction_change, g.friction), to, 12);
  HWY_ALIGN double section[kLanes];
  hn::Store(hn::MulAdd(share, g.section_change, g.section), Tag(), section);
  for (int k = 0; k < kLanes; ++k) to.row[k][16] = section[k];
}

unsigned bits_of(Mask mask)
{
  std::uint8_t bits[8] = {};
  hn::StoreMaskBits(Tag(), mask, bits);
  return bits[0];
}

/// How far a point may go from here: not to the wall, nor to an end of its segment, nor anywhere where the hole's radius changes.
HWY_INLINE V room_of(const Segments& g, const Foot& foot, V gap)
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

HWY_INLINE void note(V value, Mask mask, double* to)
{
  hn::StoreU(hn::IfThenElse(mask, value, load(to)), Tag(), to);
}

void note_search(const PlaceTask& task, int i, const V3& point, V room, Mask mask)
{
  NumberColumns& columns = *task.columns;
  note(point.x, mask, columns[task.searched] + i);
  note(point.y, mask, columns[task.searched + 1] + i);
  note(point.z, mask, columns[task.searched + 2] + i);
  note(room, mask, columns[task.room] + i);
}

void find_batch(const PlaceTask& task, int i, int count, const double* any, double* spare)
{
  Rows from;
  unsigned there = 0;
  for (int k = 0; k < kLanes; ++k)
  {
    const double* segment = k < count ? task.segments[i + k] : nullptr;
    if (segment) there |= 1u << k;
    from.row[k] = const_cast<double*>(segment ? segment : any);
  }
  if (there == 0) return;
  const Segments g = load_segments(from);
  const V3 point = load3(*task.columns, task.position, i);
  Foot foot;
  const unsigned found = bits_of(refine(g, point, foot)) & there;
  const V share = hn::Min(hn::Max(foot.s, all(0.0)), all(1.0));
  const V radius = hn::MulAdd(share, g.radius_change, g.radius);
  const V3 away = point - foot.centre;
  constexpr double smoothing = 1e-7 * 1e-7;  // wall_contact_smoothing
  const V gap = radius - load((*task.columns)[task.radius] + i) - hn::Sqrt(dot(away, away) + all(smoothing));
  const unsigned touches = bits_of(gap < all(0.0)) & found;
  for (int k = 0; k < count; ++k)
    if (found >> k & 1u) task.places[i + k] = touches >> k & 1u ? Place::touches : Place::clear;
  note_search(task, i, point, room_of(g, foot, gap), mask_of(found));
  if (touches == 0) return;
  char* closest = reinterpret_cast<char*>(task.closest) + i * task.closest_stride;
  write_closest(g, foot, share, radius, rows(reinterpret_cast<double*>(closest), task.closest_stride, count, spare));
}

void look(const PlaceTask& task) noexcept
{
  const NumberColumns& columns = *task.columns;
  for (int i = task.first; i < task.last; i += kLanes)
  {
    const V3 gone = load3(columns, task.position, i) - load3(columns, task.searched, i);
    const V room = load(columns[task.room] + i);
    const unsigned clear = bits_of(dot(gone, gone) < room * room);
    for (int k = 0; k < kLanes; ++k) task.places[i + k] = clear >> k & 1u ? Place::clear : Place::search;
  }
}

void find(const PlaceTask& task) noexcept
{
  double spare[20];
  const double* any = nullptr;
  for (int i = task.first; i < task.last && !any; ++i) any = task.segments[i];
  if (!any) return;
  for (int i = task.first; i < task.last; i += kLanes) find_batch(task, i, lanes_from(i, task.last), any, spare);
}

void find_middles(const MiddleTask& task) noexcept
{
  const NumberColumns& nodes = *task.nodes;
  for (int e = task.first; e < task.last; e += kLanes)
  {
    const V arm = all(0.125) * load((*task.elements)[element_column::length] + e);
    const V3 sum = load3(nodes, node_column::position, e) + load3(nodes, node_column::position, e + 1);
    const V3 upper = arm * load3(nodes, node_column::axis, e + 1), lower = arm * load3(nodes, node_column::axis, e);
    const V3 turned = cross(load3(nodes, node_column::increment + 3, e + 1), upper) - cross(load3(nodes, node_column::increment + 3, e), lower);
    store(mul_add(all(0.5), sum, upper - lower + turned), *task.elements, element_column::middle, e);
  }
}
}  // namespace

constexpr PlaceKernel table = {look, find, find_middles};
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
