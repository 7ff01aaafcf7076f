// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/model/kernels/string_kernel.h"

#include "drill_rig_sim/model/kernels/string_columns.h"
#include "drill_rig_sim/model/stage.h"

#ifndef DRILL_RIG_SIM_KERNELS_TOGETHER
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "model/kernels/string_kernel.cpp"
#endif
#include "math/simd.h"
#ifdef DRILL_RIG_SIM_HIGHWAY
#include <hwy/contrib/math/math-inl.h>  // in every pass
#endif

#if DRILL_RIG_SIM_WIDE
HWY_BEFORE_NAMESPACE();
namespace drill_rig_sim::HWY_NAMESPACE::of_string
{
namespace
{
#include "math/lanes.h"
// behind it
#include "drill_rig_sim/rig/rigid_body_text.h"
#include "drill_rig_sim/string/mud_text.h"
#include "drill_rig_sim/string/beam_text.h"

/// atan(t) for |t| below 0.1, to rounding.
HWY_INLINE V atan_by_series(V t)
{
  const V s = t * t;
  V sum = all(1.0 / 17.0);
  for (const double odd : {15.0, 13.0, 11.0, 9.0, 7.0, 5.0, 3.0, 1.0}) sum = hn::NegMulAdd(s, sum, all(1.0 / odd));
  return t * sum;
}

/// Lower end relative to the upper one. An element's twist does not depend on those beside it: some of them are guided, and hold
/// what an earlier step has left.
HWY_INLINE V twist_between(const Quaternion& from, const Quaternion& to)
{
  const V w = hn::MulAdd(from.w, to.w, hn::MulAdd(from.x, to.x, hn::MulAdd(from.y, to.y, from.z * to.z)));
  const V x = hn::MulAdd(from.w, to.x, hn::NegMulAdd(from.x, to.w, hn::MulSub(from.z, to.y, from.y * to.z)));
  const V t = x / w;  // a w below zero changes both their signs
  const Mask small = hn::Abs(t) < all(0.1);
  const V series = atan_by_series(t);
  if (hn::AllTrue(Tag(), small)) return all(2.0) * series;
  return all(2.0) * hn::IfThenElse(small, series, hn::Atan(Tag(), t));
}

HWY_INLINE Beam load_beam(const StringTask& task, int e)
{
  const NodeColumns& nodes = task.nodes;
  const ElementColumns& elements = task.elements;
  Beam b;
  b.length = load(elements.length, e);
  b.axial = load(elements.axial, e);
  b.near = load(elements.bending_near, e);
  b.far = load(elements.bending_far, e);
  b.torsion = load(elements.torsion, e);
  b.free_stretch = load(task.stage.free_stretch, e);
  b.load = load3(task.stage.load, e);
  b.d = load3(nodes.position, e) - load3(nodes.position, e + 1);
  b.n1 = load3(nodes.normal, e + 1);
  b.n2 = load3(nodes.normal, e);
  b.velocity = load6(nodes.rate, e).head - load6(nodes.rate, e + 1).head;
  b.turning_1 = load3(nodes.turning, e + 1);
  b.turning_2 = load3(nodes.turning, e);
  b.spin_1 = load(nodes.carried_spin, e + 1) * b.n1;
  b.spin_2 = load(nodes.carried_spin, e) * b.n2;
  Quaternion upper = load_quaternion(nodes.orientation, e + 1);
  if (!hn::AllTrue(Tag(), load(elements.upper_end.part[3], e) == all(1.0)))  // there is a bend
  {
    upper = upper * load_quaternion(elements.upper_end, e);
    b.n1 = x_axis(upper);
  }
  b.twist = twist_between(upper, load_quaternion(nodes.orientation, e));
  return b;
}

/// Mud and inertia of a node, and their derivatives.
struct NodePart
{
  V6 force;
  M3 force_place, moment_turn;
};

template <bool kTangent>
HWY_INLINE NodePart node_part(const StringTask& task, int i)
{
  const NodeColumns& nodes = task.nodes;
  const Stage& stage = task.stage;
  const V free = load(stage.free, i), wet = free * load(stage.immersed, i);
  const Body body{free * load(nodes.mass, i), free * load(stage.added_mass, i), free * load(nodes.spin_inertia, i),
                  free * load(nodes.tilt_inertia, i)};
  const MudDrag drag{wet * load(nodes.mud_across, i), wet * load(nodes.mud_along, i), wet * load(nodes.mud_about, i),
                     wet * load(nodes.mud_quadratic, i)};
  const V3 n = load3(nodes.axis, i);
  const V6 rate = load6(nodes.rate, i);
  NodePart out;
  out.force = inertia_force(body, n, rate.tail, load6(nodes.acceleration, i), body.spin_inertia) + mud_force(drag, n, rate);
  if constexpr (kTangent)
  {
    const V dv_du = all(stage.dv_du), da_du = all(stage.da_du);
    const AlongAndAcross turning = turning_slope(body, da_du) + mud_turning_slope(drag, dv_du);
    out.force_place = mud_slope(drag, n, rate, dv_du, inertia_slope(body, da_du));
    out.moment_turn = moment_slope(turning, dv_du * body.spin_inertia, n, rate.tail);
  }
  return out;
}

// --- rows of the system
// ------------------------------------------------------------------------------------------------------------------

template <bool kAdd>
HWY_INLINE void put6(const V3& a, const V3& b, const Rows& to)
{
  store4<kAdd>(a.x, a.y, a.z, b.x, to, 0);
  HWY_ALIGN double y[kLanes], z[kLanes];
  hn::Store(b.y, Tag(), y);
  hn::Store(b.z, Tag(), z);
  for (int k = 0; k < kLanes; ++k)
  {
    to.row[k][4] = kAdd ? to.row[k][4] + y[k] : y[k];
    to.row[k][5] = kAdd ? to.row[k][5] + z[k] : z[k];
  }
}

HWY_INLINE void add_to(M3& to, const M3& more)
{
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) to.m[i][j] = to.m[i][j] + more.m[i][j];
}

HWY_INLINE V with_sign(V v, bool minus)
{
  return minus ? hn::Neg(v) : v;
}

/// Blocks of 36, row by row, from quarters: `s`, which of them with the other sign.
template <bool kAdd>
HWY_INLINE void store_block(const M3& tl, const M3& tr, const M3& bl, const M3& br, bool s_tl, bool s_tr, bool s_bl,
                            const Rows& to)
{
  V k[36];
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
    {
      k[6 * i + j] = with_sign(tl.m[i][j], s_tl);
      k[6 * i + 3 + j] = with_sign(tr.m[i][j], s_tr);
      k[18 + 6 * i + j] = with_sign(bl.m[i][j], s_bl);
      k[18 + 6 * i + 3 + j] = br.m[i][j];
    }
  for (int q = 0; q < 36; q += 4) store4<kAdd>(k[q], k[q + 1], k[q + 2], k[q + 3], to, q);
}

HWY_INLINE Rows block_rows(double* blocks, int i, int count, double* spare)
{
  return rows(blocks + 36 * static_cast<std::ptrdiff_t>(i), 36, count, spare);
}

HWY_INLINE Rows residual_rows(double* residual, int i, int count, double* spare)
{
  return rows(residual + 6 * static_cast<std::ptrdiff_t>(i), 6, count, spare);
}

/// The lowest node's own part.
template <bool kTangent>
void begin_run(const StringTask& task, double* spare)
{
  const NodePart node = node_part<kTangent>(task, task.first);
  put6<false>(node.force.head, node.force.tail, residual_rows(task.residual, task.first, 1, spare));
  if constexpr (kTangent)
  {
    M3 none;
    for (auto& row : none.m)
      for (V& number : row) number = all(0.0);
    store_block<false>(node.force_place, none, none, node.moment_turn, false, false, false,
                       block_rows(task.diagonal, task.first, 1, spare));
  }
}

/// Elements from e on: each writes the rows of its upper node, and adds to those of its lower one.
template <bool kTangent>
HWY_INLINE void add_batch(const StringTask& task, int e, int count, double* spare)
{
  const Beam beam = load_beam(task, e);
  const Shape shape = shape_of(beam, task.stage.structural_damping);
  const Forces f = forces_of(beam, shape);
  const NodePart node = node_part<kTangent>(task, e + 1);
  const V3 half_load = all(0.5) * beam.load;
  put6<false>(node.force.head - f.force - half_load, node.force.tail + f.moment_1,
              residual_rows(task.residual, e + 1, count, spare));
  put6<true>(f.force - half_load, f.moment_2, residual_rows(task.residual, e, count, spare));
  if constexpr (kTangent)
  {
    Tangent t;
    find_tangent(beam, shape, task.stage.structural_damping, task.stage.dv_du, t);
    store_block<false>(t.force_d, t.force_1, t.lower_d, t.lower_1, true, false, true, block_rows(task.upper, e, count, spare));
    store_block<false>(t.force_d, t.force_2, t.upper_d, t.upper_2, true, true, false, block_rows(task.lower, e, count, spare));
    M3 upper_force = node.force_place;
    add_to(upper_force, t.force_d);
    add_to(t.upper_1, node.moment_turn);
    store_block<false>(upper_force, t.force_1, t.upper_d, t.upper_1, false, true, true,
                       block_rows(task.diagonal, e + 1, count, spare));
    store_block<true>(t.force_d, t.force_2, t.lower_d, t.lower_2, false, false, false,
                      block_rows(task.diagonal, e, count, spare));
  }
}

template <bool kTangent>
void add_run(const StringTask& task)
{
  double spare[36] = {};
  begin_run<kTangent>(task, spare);
  for (int e = task.first; e < task.last; e += kLanes) add_batch<kTangent>(task, e, lanes_from(e, task.last), spare);
}

void add(const StringTask& task) noexcept
{
  if (task.diagonal)
    add_run<true>(task);
  else
    add_run<false>(task);
}

void find_forces(const StringTask& task, const StringForces& out) noexcept
{
  for (int e = task.first; e < task.last; e += kLanes)
  {
    const int count = lanes_from(e, task.last);
    const Beam beam = load_beam(task, e);
    const Shape shape = shape_of(beam, task.stage.structural_damping);
    const V3 moment = forces_of(beam, shape).moment_1;
    const V3 bending = mul_sub_from(dot(beam.n1, moment), beam.n1, moment);
    const V numbers[3] = {shape.tension, hn::Neg(shape.torque), hn::Sqrt(dot(bending, bending))};
    double* const to[3] = {out.tension + e, out.torque + e, out.bending_moment + e + 1};
    HWY_ALIGN double buffer[kLanes];
    for (int j = 0; j < 3; ++j)
    {
      hn::Store(numbers[j], Tag(), buffer);
      for (int k = 0; k < count; ++k) to[j][k] = buffer[k];
    }
  }
}

/// Adds the forces of element e and what follows it to those of their ends.
HWY_INLINE void add_to_ends(const Forces& f, double* forces, int e, int count)
{
  double spare[6] = {};
  put6<true>(-f.force, f.moment_1, residual_rows(forces, e + 1, count, spare));
  put6<true>(f.force, f.moment_2, residual_rows(forces, e, count, spare));
}

/// As the elastic element without damping and load, and what damping adds.
void sample(const StringTask& task, double* elastic, double* damping) noexcept
{
  for (int e = task.first; e < task.last; e += kLanes)
  {
    const int count = lanes_from(e, task.last);
    Beam beam = load_beam(task, e);
    const Forces with_load = forces_of(beam, shape_of(beam, 0.0)),
                 damped = forces_of(beam, shape_of(beam, task.stage.structural_damping));
    beam.load = {all(0.0), all(0.0), all(0.0)};
    add_to_ends(forces_of(beam, shape_of(beam, 0.0)), elastic, e, count);
    add_to_ends({damped.force - with_load.force, damped.moment_1 - with_load.moment_1, damped.moment_2 - with_load.moment_2},
                damping, e, count);
  }
}

/// beam_energy(), and the potential of a dead load on the cubic.
StringEnergy stored(const StringTask& task) noexcept
{
  const Tag tag;
  V beams = all(0.0), weight = all(0.0);
  for (int e = task.first; e < task.last; e += kLanes)
  {
    const auto valid = hn::FirstN(tag, static_cast<std::size_t>(task.last - e));
    const Beam b = load_beam(task, e);
    const V3 ends = load3(task.nodes.position, e) + load3(task.nodes.position, e + 1);
    const V3 mean = mul_add(all(0.5), ends, (all(1.0 / 12.0) * b.length) * (b.n1 - b.n2));
    beams = beams + hn::IfThenElseZero(valid, energy_of(b));
    weight = weight - hn::IfThenElseZero(valid, dot(b.load, mean));
  }
  return {hn::GetLane(hn::SumOfLanes(tag, beams)), hn::GetLane(hn::SumOfLanes(tag, weight))};
}
}  // namespace

constexpr StringKernel table = {add, find_forces, sample, stored};
}  // namespace drill_rig_sim::HWY_NAMESPACE::of_string
HWY_AFTER_NAMESPACE();
#endif

#if DRILL_RIG_SIM_ONCE
namespace drill_rig_sim
{
const StringKernel* string_kernel(Kernel kernel) noexcept
{
  constexpr const StringKernel* none = nullptr;
  return DRILL_RIG_SIM_TABLE(kernel, none, of_string::table);
}
}  // namespace drill_rig_sim
#endif
