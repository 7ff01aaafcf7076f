// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/model/kernels/motion_kernel.h"

#include <cmath>

#include "drill_rig_sim/model/stage.h"
#include "drill_rig_sim/model/workspace.h"

#ifndef DRILL_RIG_SIM_KERNELS_TOGETHER
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "model/kernels/motion_kernel.cpp"
#endif
#include "math/simd.h"

#if DRILL_RIG_SIM_WIDE
HWY_BEFORE_NAMESPACE();
namespace drill_rig_sim::HWY_NAMESPACE::of_motion
{
namespace
{
#include "math/lanes.h"

/// cos(a/2) and sin(a/2)/a.
struct HalfTurn
{
  V cosine, sine;
};

/// Taylor's coefficients in y = (a/2)^2.
struct HalfTurnSeries
{
  static constexpr int terms = 12;
  double cosine[terms] = {}, sine[terms] = {};

  constexpr HalfTurnSeries()
  {
    double factor = 1.0;  // (-1)^k/(2 k)!
    for (int k = 0; k < terms; ++k)
    {
      cosine[k] = factor;
      sine[k] = 0.5 * factor / (2 * k + 1);
      factor /= -(2.0 * k + 1.0) * (2.0 * k + 2.0);
    }
  }
};
constexpr HalfTurnSeries series;

template <int kTerms>
HWY_INLINE HalfTurn half_turn_by_series(V y)
{
  HalfTurn out{all(series.cosine[kTerms - 1]), all(series.sine[kTerms - 1])};
  for (int k = kTerms - 2; k >= 0; --k)
  {
    out.cosine = hn::MulAdd(out.cosine, y, all(series.cosine[k]));
    out.sine = hn::MulAdd(out.sine, y, all(series.sine[k]));
  }
  return out;
}

HWY_NOINLINE HalfTurn half_turn_by_library(V y)
{
  HWY_ALIGN double half[kLanes], cosine[kLanes], sine[kLanes];
  hn::Store(hn::Sqrt(y), Tag(), half);
  for (int k = 0; k < kLanes; ++k)
  {
    cosine[k] = std::cos(half[k]);
    sine[k] = half[k] > 0.0 ? 0.5 * std::sin(half[k]) / half[k] : 0.5;
  }
  return {hn::Load(Tag(), cosine), hn::Load(Tag(), sine)};
}

/// To rounding: six terms up to a = 0.2, twelve up to half a turn.
HWY_INLINE HalfTurn half_turn(V y)
{
  if (hn::AllTrue(Tag(), y < all(0.01))) return half_turn_by_series<6>(y);
  if (hn::AllTrue(Tag(), y < all(2.46))) return half_turn_by_series<HalfTurnSeries::terms>(y);
  return half_turn_by_library(y);
}

HWY_INLINE Quaternion rotation_from_vector(const V3& r)
{
  const HalfTurn h = half_turn(all(0.25) * dot(r, r));
  return {h.sine * r.x, h.sine * r.y, h.sine * r.z, h.cosine};
}

/// NodeMotion of a batch, but for the hole.
struct Moves
{
  Quaternion orientation;
  V3 axis, position, normal, tilt;
  V spin, carried_spin;
  V6 increment, rate, acceleration;
};

HWY_INLINE void store(const Moves& m, std::vector<NodeMotion>& nodes, int i, int count)
{
  double spare[6];
  const auto to = [&](auto get) { return rows_to(nodes.data() + i, count, spare, get); };
  const Quaternion& q = m.orientation;
  store4<false>(q.x, q.y, q.z, q.w, to([](NodeMotion& node) { return node.orientation.coeffs().data(); }), 0);
  store3(m.axis, to([](NodeMotion& node) { return node.axis.data(); }));
  store3(m.position, to([](NodeMotion& node) { return node.position.data(); }));
  store3(m.normal, to([](NodeMotion& node) { return node.normal.data(); }));
  store3(m.tilt, to([](NodeMotion& node) { return node.tilt.data(); }));
  store1(m.spin, to([](NodeMotion& node) { return &node.spin; }));
  store1(m.carried_spin, to([](NodeMotion& node) { return &node.carried_spin; }));
  store6(m.increment, to([](NodeMotion& node) { return node.increment.data(); }));
  store6(m.rate, to([](NodeMotion& node) { return node.rate.data(); }));
  store6(m.acceleration, to([](NodeMotion& node) { return node.acceleration.data(); }));
}

HWY_INLINE void store(const Moves& m, NodeColumns& to, int i)
{
  store(m.position, to.position, i);
  store(m.normal, to.normal, i);
  store(mul_add(m.carried_spin, m.normal - m.axis, m.rate.tail), to.turning, i);
  store(m.axis, to.axis, i);
  store(m.orientation, to.orientation, i);
  store(m.carried_spin, to.carried_spin, i);
  store(m.increment, to.increment, i);
  store(m.rate, to.rate, i);
  store(m.acceleration, to.acceleration, i);
}

HWY_INLINE Moves moved(const State& start, const Stage& stage, const double* u, int i, int count)
{
  const NodeState* before = start.nodes.data() + i;
  const Quaternion orientation =
      load_quaternion(rows_of(before, count, [](const NodeState& node) { return node.orientation.coeffs().data(); }));
  const auto six = [&](const std::vector<Vector6d>& from)
  { return load6(rows_of(from.data() + i, count, [](const Vector6d& v) { return v.data(); })); };
  Moves m;
  m.axis = x_axis(orientation);
  m.increment = load6(rows(u + 6 * i, 6, count));
  m.position = load3(rows_of(before, count, [](const NodeState& node) { return node.position.data(); })) + m.increment.head;
  m.spin = dot(m.increment.tail, m.axis);
  m.tilt = mul_sub_from(m.spin, m.axis, m.increment.tail);
  const HalfTurn spun = half_turn(all(0.25) * m.spin * m.spin);
  const V s = spun.sine * m.spin;
  m.orientation =
      rotation_from_vector(m.tilt) * (Quaternion{s * m.axis.x, s * m.axis.y, s * m.axis.z, spun.cosine} * orientation);
  m.normal = x_axis(m.orientation);
  m.rate = mul_add(all(stage.dv_du), m.increment, six(stage.rate));
  m.carried_spin = dot(m.rate.tail, m.axis);
  m.acceleration = mul_add(all(stage.da_du), m.increment, six(stage.acceleration));
  return m;
}

void move(const State& start, const Stage& stage, const double* u, Runs::Run nodes, Workspace& work) noexcept
{
  for (int i = nodes.first; i < nodes.last; i += kLanes)
  {
    const int count = lanes_from(i, nodes.last);
    const Moves m = moved(start, stage, u, i, count);
    store(m, work.nodes, i, count);
    store(m, work.columns.nodes, i);
  }
}
}  // namespace

constexpr MotionKernel table = {move};
}  // namespace drill_rig_sim::HWY_NAMESPACE::of_motion
HWY_AFTER_NAMESPACE();
#endif

#if DRILL_RIG_SIM_ONCE
namespace drill_rig_sim
{
const MotionKernel* motion_kernel(Kernel kernel) noexcept
{
  constexpr const MotionKernel* none = nullptr;
  return DRILL_RIG_SIM_TABLE(kernel, none, of_motion::table);
}
}  // namespace drill_rig_sim
#endif
