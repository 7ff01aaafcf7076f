// Guided nodes at the two ends of a step: formulas of model/guides.cpp.
#include "drill_rig_sim/model/kernels/guided_kernel.h"

#include <cmath>
#include <cstddef>

#include "drill_rig_sim/math/number_columns.h"
#include "drill_rig_sim/model/workspace.h"

#ifndef DRILL_RIG_SIM_KERNELS_TOGETHER
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "model/kernels/guided_step_kernel.cpp"
#endif
#include "math/simd.h"

#if DRILL_RIG_SIM_WIDE
HWY_BEFORE_NAMESPACE();
namespace drill_rig_sim::HWY_NAMESPACE::of_guided_step
{
namespace
{
#include "math/lanes.h"
#include "model/kernels/guided_lanes.h"

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
  return choose(left > all(0.0), turned, push);
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

constexpr GuidedStepKernel table = {find, commit};
}  // namespace drill_rig_sim::HWY_NAMESPACE::of_guided_step
HWY_AFTER_NAMESPACE();
#endif

#if DRILL_RIG_SIM_ONCE
namespace drill_rig_sim
{
const GuidedStepKernel* guided_step_kernel(Kernel kernel) noexcept
{
  constexpr const GuidedStepKernel* none = nullptr;
  return DRILL_RIG_SIM_TABLE(kernel, none, of_guided_step::table);
}
}  // namespace drill_rig_sim
#endif
