#include "drill_rig_sim/model/kernels/history_kernel.h"

#include <type_traits>

#include "drill_rig_sim/math/number_columns.h"

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

/// NodeRate: velocity, tilt, spin.
struct Rate
{
  V3 velocity, tilt;
  V spin;
};

template <class Number>
HWY_INLINE Number* row(const NumberRows<Number>& rows, int i)
{
  using Byte = std::conditional_t<std::is_const_v<Number>, const char, char>;
  return reinterpret_cast<Number*>(reinterpret_cast<Byte*>(rows.first) + i * rows.stride);
}

HWY_INLINE Rows rows_from(const NumberRows<const double>& from, int i, int count)
{
  return rows(row(from, i), from.stride, count);
}

HWY_INLINE Rate load_rate(const Rows& from)
{
  const V4 p = load4(from, 0), q = load4(from, 3);
  return {{p.a, p.b, p.c}, {p.d, q.b, q.c}, q.d};
}

HWY_INLINE void store(const Rate& r, const Rows& to)
{
  store4<false>(r.velocity.x, r.velocity.y, r.velocity.z, r.tilt.x, to, 0);
  store4<false>(r.tilt.x, r.tilt.y, r.tilt.z, r.spin, to, 3);
}

void find_rates(const RatesTask& task) noexcept
{
  double spare[6];
  for (int i = 0; i < task.count; i += kLanes)
  {
    const int count = lanes_from(i, task.count);
    const V4 q = load4(rows_from(task.orientation, i, count), 0);
    const V3 n = x_axis({q.a, q.b, q.c, q.d});
    const V zero = all(0.0);
    V6 rate{{zero, zero, zero}, {zero, zero, zero}}, acceleration = rate;
    for (int k = 0; k < 3; ++k)
    {
      const Rate past = load_rate(rows_from(task.past[k], i, count));
      const V6 six{past.velocity, mul_add(past.spin, n, past.tilt)};
      rate = mul_add(all(task.in_rate[k]), six, rate);
      acceleration = mul_add(all(task.in_acceleration[k]), six, acceleration);
    }
    store6(rate.head, rate.tail, rows(task.rate + 6 * i, 6 * sizeof(double), count, spare), 0);
    store6(acceleration.head, acceleration.tail, rows(task.acceleration + 6 * i, 6 * sizeof(double), count, spare), 0);
  }
}

/// What carries along: of NodeMoves.
struct Turn
{
  V3 axis, normal, tilt;
};

HWY_INLINE Turn load_turn(const Rows& moves)
{
  const V4 a = load4(moves, 4), n = load4(moves, 10), t = load4(moves, 12);
  return {{a.a, a.b, a.c}, {n.a, n.b, n.c}, {n.d, t.c, t.d}};
}

HWY_INLINE V3 carried(const Turn& turn, const V3& across)
{
  const V3 moved = across + cross(turn.tilt, across);
  return mul_sub_from(dot(turn.normal, moved), turn.normal, moved);
}

void split(int nodes, NumberRows<const double> moves, int at, NumberRows<double> out) noexcept
{
  double spare[7];
  for (int i = 0; i < nodes; i += kLanes)
  {
    const int count = lanes_from(i, nodes);
    const Rows from = rows_from(moves, i, count);
    const Turn turn = load_turn(from);
    const V4 p = load4(from, at), q = load4(from, at + 2);
    const V3 rotation{p.d, q.c, q.d};
    const V spin = dot(rotation, turn.axis);
    store(Rate{{p.a, p.b, p.c}, carried(turn, mul_sub_from(spin, turn.axis, rotation)), spin}, rows(row(out, i), out.stride, count, spare));
  }
}

void carry(int nodes, NumberRows<const double> moves, NumberRows<const double> rates, NumberRows<double> out) noexcept
{
  double spare[7];
  for (int i = 0; i < nodes; i += kLanes)
  {
    const int count = lanes_from(i, nodes);
    Rate rate = load_rate(rows_from(rates, i, count));
    rate.tilt = carried(load_turn(rows_from(moves, i, count)), rate.tilt);
    store(rate, rows(row(out, i), out.stride, count, spare));
  }
}
}  // namespace

constexpr HistoryKernel table = {find_rates, split, carry};
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
