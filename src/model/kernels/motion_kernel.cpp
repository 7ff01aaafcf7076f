#include "drill_rig_sim/model/kernels/motion_kernel.h"

#include <cmath>

#include "drill_rig_sim/model/kernels/string_columns.h"

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

/// NodeMoves of a batch, in its order.
struct Moves
{
  Quaternion orientation;
  V3 axis, position, normal, tilt;
  V spin, carried_spin;
  V6 increment, rate, acceleration;
};

HWY_INLINE void store(const Moves& m, const Rows& to)
{
  const Quaternion& q = m.orientation;
  const V6 &u = m.increment, &r = m.rate, &a = m.acceleration;
  store4<false>(q.x, q.y, q.z, q.w, to, 0);
  store4<false>(m.axis.x, m.axis.y, m.axis.z, m.position.x, to, 4);
  store4<false>(m.position.y, m.position.z, m.normal.x, m.normal.y, to, 8);
  store4<false>(m.normal.z, m.tilt.x, m.tilt.y, m.tilt.z, to, 12);
  store4<false>(m.spin, m.carried_spin, u.head.x, u.head.y, to, 16);
  store4<false>(u.head.z, u.tail.x, u.tail.y, u.tail.z, to, 20);
  store4<false>(r.head.x, r.head.y, r.head.z, r.tail.x, to, 24);
  store4<false>(r.tail.y, r.tail.z, a.head.x, a.head.y, to, 28);
  store4<false>(a.head.z, a.tail.x, a.tail.y, a.tail.z, to, 32);
}

HWY_INLINE void store(const Moves& m, NumberColumns& to, int i)
{
  store(m.position, to, node_column::position, i);
  store(m.normal, to, node_column::normal, i);
  store(mul_add(m.carried_spin, m.normal - m.axis, m.rate.tail), to, node_column::turning, i);
  store(m.rate.head, to, node_column::velocity, i);
  store(m.rate.tail, to, node_column::rotating, i);
  store(m.axis, to, node_column::axis, i);
  store(m.acceleration.head, to, node_column::acceleration, i);
  store(m.acceleration.tail, to, node_column::acceleration + 3, i);
  store({m.orientation.x, m.orientation.y, m.orientation.z}, to, node_column::orientation, i);
  store(m.orientation.w, to, node_column::orientation + 3, i);
  store(m.carried_spin, to, node_column::carried_spin, i);
  store(m.increment.head, to, node_column::increment, i);
  store(m.increment.tail, to, node_column::increment + 3, i);
}

/// Places and orientations at the start of the step.
struct Before
{
  V3 position;
  Quaternion orientation;
};

HWY_INLINE Before load_before(const MoveTask& task, int i, int count)
{
  const std::ptrdiff_t from = (i - task.first) * task.state_stride;
  const auto at = [from](const double* first) { return reinterpret_cast<const double*>(reinterpret_cast<const char*>(first) + from); };
  const V4 p = load4(rows(at(task.position), task.state_stride, count), 0);
  const V4 q = load4(rows(at(task.orientation), task.state_stride, count), 0);
  return {{p.a, p.b, p.c}, {q.a, q.b, q.c, q.d}};
}

HWY_INLINE V6 load_six(const double* first, int i, int count)
{
  return load6(rows(first + 6 * i, 6 * sizeof(double), count));
}

HWY_INLINE Moves moved(const MoveTask& task, int i, int count)
{
  const Before before = load_before(task, i, count);
  Moves m;
  m.axis = x_axis(before.orientation);
  m.increment = load_six(task.u, i - task.first, count);
  m.position = before.position + m.increment.head;
  m.spin = dot(m.increment.tail, m.axis);
  m.tilt = mul_sub_from(m.spin, m.axis, m.increment.tail);
  const HalfTurn spun = half_turn(all(0.25) * m.spin * m.spin);
  const V s = spun.sine * m.spin;
  m.orientation = rotation_from_vector(m.tilt) * (Quaternion{s * m.axis.x, s * m.axis.y, s * m.axis.z, spun.cosine} * before.orientation);
  m.normal = x_axis(m.orientation);
  m.rate = mul_add(all(task.dv_du), m.increment, load_six(task.rate, i - task.first, count));
  m.carried_spin = dot(m.rate.tail, m.axis);
  m.acceleration = mul_add(all(task.da_du), m.increment, load_six(task.acceleration, i - task.first, count));
  return m;
}

void move(const MoveTask& task) noexcept
{
  double spare[36];
  for (int i = task.first; i < task.last; i += kLanes)
  {
    const int count = lanes_from(i, task.last);
    const Moves m = moved(task, i, count);
    char* to = reinterpret_cast<char*>(task.moves) + (i - task.first) * task.move_stride;
    store(m, rows(reinterpret_cast<double*>(to), task.move_stride, count, spare));
    store(m, *task.nodes, i);
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
