// SPDX-License-Identifier: BSD-3-Clause
// Guided nodes at the two ends of a step: formulas of model/guides.cpp.
#include "drill_rig_sim/model/kernels/guided_kernel.h"

#include <cmath>
#include <cstddef>

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
// behind them
#include "drill_rig_sim/well/locate_text.h"
#include "model/kernels/segment_lanes.h"

template <class Batch>
HWY_INLINE V load(const State& state, double NodeState::*number, Batch b)
{
  return load1(rows_of(state.nodes, b, [number](const NodeState& node) { return &(node.*number); }));
}

template <class Batch>
HWY_INLINE V3 load3(const State& state, Eigen::Vector3d NodeState::*vector, Batch b)
{
  return load3(rows_of(state.nodes, b, [vector](const NodeState& node) { return (node.*vector).data(); }));
}

template <class Batch>
HWY_INLINE Quaternion load_orientation(const State& state, Batch b)
{
  return load_quaternion(rows_of(state.nodes, b, [](const NodeState& node) { return node.orientation.coeffs().data(); }));
}

/// What the hole's wall is like where its depth says, into the columns of a batch's guides.
template <class Batch>
void find_wall(const Model& model, const State& state, Stage& stage, Batch b)
{
  GuideColumns& g = stage.guides;
  Segments segments;
  for (int k = 0; k < kLanes; ++k)
  {
    const NodeState& node = state.nodes[static_cast<std::size_t>(b.i + (k < b.count ? k : 0))];
    int segment = node.segment;
    segments.of[k] = &state.well.segment_there(node.md, segment);
  }
  const V md = load(state, &NodeState::md, b), s = place_at(segments, md), zero = all(0.0);
  const auto there = [&](double HoleSegment::*number, double HoleSegment::*change)
  { return mul_add(s, load(segments, change), load(segments, number)); };
  if (model.contact_varies())
  {
    HWY_ALIGN double section[kLanes];
    hn::Store(there(&HoleSegment::section, &HoleSegment::section_change), Tag(), section);
    for (int k = 0; k < b.count; ++k)
    {
      const std::size_t i = static_cast<std::size_t>(b.i + k);
      g.set_law(i, model.contact(b.i + k, section[k], state.nodes[i].rest));
    }
  }
  const Mask in_hole = md > zero;
  const V room = larger(zero, there(&HoleSegment::radius, &HoleSegment::radius_change) - load(g.bearing_radius, b.i));
  store(select_or_zero(in_hole, there(&HoleSegment::friction, &HoleSegment::friction_change)), g.friction, b.i);
  store(select_or_zero(in_hole, room), g.clearance, b.i);
}

/// A node's numbers from the state.
template <class Batch>
void find_node_batch(const Model& model, const State& state, Stage& stage, Batch b)
{
  GuideColumns& g = stage.guides;
  find_wall(model, state, stage, b);
  store(x_axis(load_orientation(state, b)), g.tangent, b.i);
  store(load3(state, &NodeState::position, b) - load3(state, &NodeState::side, b), g.centre, b.i);
  const V3 bristle = load3(state, &NodeState::bristle, b);
  store(bristle.x, g.bristle.part[0], b.i);
  store(bristle.y, g.bristle.part[1], b.i);
  store(load(g.stiffness, b.i) * bristle.y, g.held, b.i);
  store(load(state, &NodeState::rest, b), g.rest, b.i);
  const V immersed = load(stage.immersed, b.i);
  store(immersed * load(g.mud_along, b.i), g.wet_along, b.i);
  store(immersed * load(g.mud_about, b.i), g.wet_about, b.i);
  store(all(0.5) * (load3(stage.load, b.i) + load3(stage.load, b.i - 1)), g.weight, b.i);
}

/// Of the elements between nodes.
template <class Batch>
void find_element_batch(const State& state, Stage& stage, Batch b)
{
  GuideColumns& g = stage.guides;
  const auto next = [&](auto get) { return rows_of(state.nodes.data() + b.i + 1, b.count, get); };
  const V upper_md = load1(next([](const NodeState& node) { return &node.md; }));
  const V3 upper_side = load3(next([](const NodeState& node) { return node.side.data(); }));
  const V3 way = load3(g.centre, b.i + 1) - load3(g.centre, b.i), line = way + (upper_side - load3(state, &NodeState::side, b));
  const V chord = norm(way), axis = load(state, &NodeState::md, b) - upper_md, one = all(1.0);
  store(axis + norm(line) - chord - load(g.length, b.i) * (one + load(stage.free_stretch, b.i)), g.stretch, b.i);
  store(load1(rows_of(state.spans, b, [](const SpanState& span) { return &span.twist; })), g.twist, b.i);
  store((one / chord) * way, g.direction, b.i);
  const V3 t = load3(g.tangent, b.i);
  store((one / axis) * cross(t, t - load3(g.tangent, b.i + 1)), g.turn, b.i);
}

void find(const Model& model, const State& state, Stage& stage, Runs::Run nodes) noexcept
{
  each_batch(nodes, [&](auto b) { find_node_batch(model, state, stage, b); });
  each_batch({nodes.first, nodes.last - 1}, [&](auto b) { find_element_batch(state, stage, b); });
  close_run(stage, nodes);
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
  Segments segments;
  for (int k = 0; k < kLanes; ++k)
  {
    const int lane = k < b.count ? k : 0;
    int& segment = state.nodes[static_cast<std::size_t>(b.i + lane)].segment;
    segments.of[k] = &state.well.segment_there(depth[lane], segment);
  }
  const Cubic curve = load_curve(segments);
  const V s = place_at(segments, md);
  const V3 slope = slope_of(curve, s);
  return {centre_of(curve, s), (all(1.0) / norm(slope)) * slope};
}

/// Those of a batch that are turned by more than small angles one by one: turned_to().
template <class Batch>
HWY_NOINLINE void turn_singly(const V3& tangent, const Quaternion& from, Batch b, State& state)
{
  HWY_ALIGN double t[3][kLanes], q[4][kLanes];
  hn::Store(tangent.x, Tag(), t[0]);
  hn::Store(tangent.y, Tag(), t[1]);
  hn::Store(tangent.z, Tag(), t[2]);
  hn::Store(from.x, Tag(), q[0]);
  hn::Store(from.y, Tag(), q[1]);
  hn::Store(from.z, Tag(), q[2]);
  hn::Store(from.w, Tag(), q[3]);
  for (int k = 0; k < b.count; ++k)
    state.nodes[static_cast<std::size_t>(b.i + k)].orientation =
        turned_to({t[0][k], t[1][k], t[2][k]}, {q[3][k], q[0][k], q[1][k], q[2][k]});
}

template <class Batch>
void commit_batch(const Stage& stage, const Workspace& work, double follows, State& state, Batch b)
{
  const GuideColumns& g = stage.guides;
  const GuidedMotions& m = work.guided;
  const V along = load(m.along, b.i), about = load(m.about, b.i), along_rate = load(m.along_rate, b.i), one = all(1.0);
  const V3 t = load3(g.tangent, b.i);
  const V3 on_wall = climbed(t, load3(m.lean, b.i), load(m.around, b.i)), old_side = load3(state, &NodeState::side, b);
  const V reach = load(g.clearance, b.i) / (all(pressed) + norm(on_wall));
  const V3 aside = mul_add(all(follows), reach * on_wall - old_side, old_side);
  const V md = load(state, &NodeState::md, b) + along;
  const HolePlace hole = place_of(state, md, b);
  const V3 side = in_plane(hole.tangent, aside);
  const V half = all(0.5) * about;
  const V2 sc = sine_and_cosine(half);
  const V3 axis = (half * sc.x) * t;
  const Quaternion turned = Quaternion{axis.x, axis.y, axis.z, sc.y} * load_orientation(state, b);
  const V3 normal = x_axis(turned), tilt = cross(normal, hole.tangent), arm = all(0.5) * tilt;
  const Quaternion q = normalized(Quaternion{arm.x, arm.y, arm.z, one} * turned);
  double spare[6];
  const auto to = [&](auto get) { return rows_to(state.nodes, b, spare, get); };
  store3(hole.position + side, to([](NodeState& node) { return node.position.data(); }));
  store4<false>(q.x, q.y, q.z, q.w, to([](NodeState& node) { return node.orientation.coeffs().data(); }), 0);
  store1(load(state, &NodeState::spin_angle, b) + about, to([](NodeState& node) { return &node.spin_angle; }));
  store3(along_rate * t, to([](NodeState& node) { return node.rate.velocity.data(); }));
  store3(along_rate * load3(g.turn, b.i), to([](NodeState& node) { return node.rate.tilt.data(); }));
  store1(load(m.about_rate, b.i), to([](NodeState& node) { return &node.rate.spin; }));
  store1(md, to([](NodeState& node) { return &node.md; }));
  store3(side, to([](NodeState& node) { return node.side.data(); }));
  constexpr double small = 1e-3;  // [rad]
  if (hn::AllTrue(Tag(), both(dot(tilt, tilt) <= all(small * small), dot(normal, hole.tangent) >= all(0.0)))) return;
  turn_singly(hole.tangent, turned, b, state);
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
