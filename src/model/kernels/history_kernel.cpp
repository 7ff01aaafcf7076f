// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/model/kernels/history_kernel.h"

#include "drill_rig_sim/model/stage.h"
#include "drill_rig_sim/model/workspace.h"

#ifndef DRILL_RIG_SIM_KERNELS_TOGETHER
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "model/kernels/history_kernel.cpp"
#endif
#include "math/simd.h"

#if DRILL_RIG_SIM_WIDE
HWY_BEFORE_NAMESPACE();
namespace drill_rig_sim::HWY_NAMESPACE::of_history
{
namespace
{
#include "math/lanes.h"

/// NodeRate.
struct Rate
{
  V3 velocity, tilt;
  V spin;
};

/// `get`: of an element to its NodeRate.
template <class T, class Get>
HWY_INLINE Rate load_rate(const T* first, int count, Get get)
{
  return {load3(rows_of(first, count, [&](const T& from) { return get(from).velocity.data(); })),
          load3(rows_of(first, count, [&](const T& from) { return get(from).tilt.data(); })),
          load1(rows_of(first, count, [&](const T& from) { return &get(from).spin; }))};
}

template <class T, class Get>
HWY_INLINE void store_rate(const Rate& r, T* first, int count, Get get)
{
  double spare[3];
  store3(r.velocity, rows_to(first, count, spare, [&](T& to) { return get(to).velocity.data(); }));
  store3(r.tilt, rows_to(first, count, spare, [&](T& to) { return get(to).tilt.data(); }));
  store1(r.spin, rows_to(first, count, spare, [&](T& to) { return &get(to).spin; }));
}

constexpr auto of_state = [](auto& node) -> auto&
{
  return node.rate;
};
constexpr auto of_itself = [](auto& rate) -> auto&
{
  return rate;
};

HWY_INLINE V6 in_axes(const Rate& rate, const V3& n)
{
  return {rate.velocity, mul_add(rate.spin, n, rate.tilt)};
}

HWY_INLINE V3 normal_of(const State& state, int i, int count)
{
  const auto orientation = [](const NodeState& node) { return node.orientation.coeffs().data(); };
  return x_axis(load_quaternion(rows_of(state.nodes.data() + i, count, orientation)));
}

HWY_INLINE V6 scaled(double factor, const V6& six)
{
  const V f = all(factor);
  return {f * six.head, f * six.tail};
}

void extrapolate(const State& state, double of_now, double of_last, double* u) noexcept
{
  const int nodes = static_cast<int>(state.nodes.size());
  const NodeRate* last = state.memory.past[0].nodes.data();
  double spare[6];
  for (int i = 0; i < nodes; i += kLanes)
  {
    const int count = lanes_from(i, nodes);
    const V3 n = normal_of(state, i, count);
    const V6 now = scaled(of_now, in_axes(load_rate(state.nodes.data() + i, count, of_state), n));
    store6(mul_add(all(of_last), in_axes(load_rate(last + i, count, of_itself), n), now), rows(u + 6 * i, 6, count, spare));
  }
}

void find_rates(const State& state, const RateFactors& in_rate, const RateFactors& in_acceleration, Stage& stage) noexcept
{
  const int nodes = static_cast<int>(state.nodes.size());
  const NodeRate *last = state.memory.past[0].nodes.data(), *second = state.memory.past[1].nodes.data();
  double spare[6];
  for (int i = 0; i < nodes; i += kLanes)
  {
    const int count = lanes_from(i, nodes);
    const V3 n = normal_of(state, i, count);
    const V6 of_now = in_axes(load_rate(state.nodes.data() + i, count, of_state), n);
    const V6 of_last = in_axes(load_rate(last + i, count, of_itself), n),
             of_second = in_axes(load_rate(second + i, count, of_itself), n);
    const auto put = [&](const RateFactors& by, std::vector<Vector6d>& to)
    {
      const V6 sum = mul_add(all(by.now), of_now, mul_add(all(by.last), of_last, scaled(by.second, of_second)));
      store6(sum, rows_to(to.data() + i, count, spare, [](Vector6d& v) { return v.data(); }));
    };
    put(in_rate, stage.rate);
    put(in_acceleration, stage.acceleration);
  }
}

/// What carries along: of NodeMotion.
struct Turn
{
  V3 axis, normal, tilt;
};

HWY_INLINE Turn load_turn(const NodeMotion* first, int count)
{
  return {load3(rows_of(first, count, [](const NodeMotion& node) { return node.axis.data(); })),
          load3(rows_of(first, count, [](const NodeMotion& node) { return node.normal.data(); })),
          load3(rows_of(first, count, [](const NodeMotion& node) { return node.tilt.data(); }))};
}

HWY_INLINE Turn load_turn(const Stage& stage, const Workspace& work, int i)
{
  const V3 t = load3(stage.guides.tangent, i), tilt = load(work.guided.along, i) * load3(stage.guides.turn, i);
  return {t, t + cross(tilt, t), tilt};
}

HWY_INLINE V3 carried(const Turn& turn, const V3& across)
{
  return in_plane(turn.normal, across + cross(turn.tilt, across));
}

HWY_INLINE Rate split_batch(const Workspace& work, Vector6d NodeMotion::*vector, int i, int count)
{
  const NodeMotion* from = work.nodes.data() + i;
  const Turn turn = load_turn(from, count);
  const V6 six = load6(rows_of(from, count, [vector](const NodeMotion& node) { return (node.*vector).data(); }));
  const V spin = dot(six.tail, turn.axis);
  return {six.head, carried(turn, mul_sub_from(spin, turn.axis, six.tail)), spin};
}

void split(const Workspace& work, Vector6d NodeMotion::*vector, Runs::Run nodes, std::vector<NodeRate>& out) noexcept
{
  for (int i = nodes.first; i < nodes.last; i += kLanes)
  {
    const int count = lanes_from(i, nodes.last);
    store_rate(split_batch(work, vector, i, count), out.data() + i, count, of_itself);
  }
}

void split_rates(const Workspace& work, Runs::Run nodes, State& state) noexcept
{
  for (int i = nodes.first; i < nodes.last; i += kLanes)
  {
    const int count = lanes_from(i, nodes.last);
    store_rate(split_batch(work, &NodeMotion::rate, i, count), state.nodes.data() + i, count, of_state);
  }
}

/// `turn_of(i, count)`
template <class TurnOf>
HWY_INLINE void carry_run(const State& state, Runs::Run nodes, TurnOf turn_of, std::vector<NodeRate>& out)
{
  for (int i = nodes.first; i < nodes.last; i += kLanes)
  {
    const int count = lanes_from(i, nodes.last);
    Rate rate = load_rate(state.nodes.data() + i, count, of_state);
    rate.tilt = carried(turn_of(i, count), rate.tilt);
    store_rate(rate, out.data() + i, count, of_itself);
  }
}

void carry(const Workspace& work, const State& state, Runs::Run nodes, std::vector<NodeRate>& out) noexcept
{
  carry_run(
      state, nodes, [&](int i, int count) { return load_turn(work.nodes.data() + i, count); }, out);
}

void split_guided(const Stage& stage, const Column& along, const Column& about, Runs::Run nodes,
                  std::vector<NodeRate>& out) noexcept
{
  for (int i = nodes.first; i < nodes.last; i += kLanes)
  {
    const V s = load(along, i);
    const Rate rate{s * load3(stage.guides.tangent, i), s * load3(stage.guides.turn, i), load(about, i)};
    store_rate(rate, out.data() + i, lanes_from(i, nodes.last), of_itself);
  }
}

void carry_guided(const Stage& stage, const Workspace& work, const State& state, Runs::Run nodes,
                  std::vector<NodeRate>& out) noexcept
{
  carry_run(
      state, nodes, [&](int i, int) { return load_turn(stage, work, i); }, out);
}
}  // namespace

constexpr HistoryKernel table = {extrapolate, find_rates, split, split_rates, carry, split_guided, carry_guided};
}  // namespace drill_rig_sim::HWY_NAMESPACE::of_history
HWY_AFTER_NAMESPACE();
#endif

#if DRILL_RIG_SIM_ONCE
namespace drill_rig_sim
{
const HistoryKernel* history_kernel(Kernel kernel) noexcept
{
  constexpr const HistoryKernel* none = nullptr;
  return DRILL_RIG_SIM_TABLE(kernel, none, of_history::table);
}
}  // namespace drill_rig_sim
#endif
