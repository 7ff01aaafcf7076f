// Of mud and inertia the formulas are those of model/forces/inertia.cpp and mud_drag.cpp; symbols as there.
#include "drill_rig_sim/model/kernels/string_kernel.h"

#include "drill_rig_sim/model/kernels/string_columns.h"

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
#include "model/kernels/beam_lanes.h"

// --- mud and inertia -------------------------------------------------------------------------------------------------------------------

struct NodePart
{
  V3 force, moment;
  M3 force_place, moment_turn;  // their derivatives
};

template <bool kTangent>
HWY_INLINE NodePart node_part(const StringTask& task, int i)
{
  using namespace node_column;
  const NumberColumns& nodes = *task.nodes;
  const auto number = [&](int kind) { return load(nodes[kind] + i); };
  const V free = number(node_column::free), wet = number(immersed), added = number(added_mass);
  const V mass = free * number(node_column::mass), spin_moment = free * number(spin_inertia), tilt_moment = free * number(tilt_inertia);
  const V across = wet * number(mud_across), along = wet * number(mud_along), torsional = wet * number(mud_torsional);
  const V3 n = load3(nodes, axis, i), v = load3(nodes, velocity, i), w = load3(nodes, rotating, i);
  const V3 a = load3(nodes, acceleration, i), alpha = load3(nodes, acceleration + 3, i);
  const V spin = dot(w, n), v_along = dot(n, v);
  const V3 sideways = mul_sub_from(v_along, n, v), gyro = cross(w, n);
  const V speed = hn::Sqrt(dot(sideways, sideways)), quadratic = wet * number(mud_quadratic), drag = quadratic * speed;

  NodePart out;
  out.force = mul_add(mass + added, a, mul_sub_from(added * dot(n, a), n, mul_add(across, v, mul_add(along * v_along, n, drag * sideways))));
  const V by_n = hn::MulAdd(spin_moment - tilt_moment, dot(alpha, n), torsional * spin);
  out.moment = mul_add(tilt_moment, alpha, mul_add(by_n, n, (spin_moment * spin) * gyro));
  if constexpr (kTangent)
  {
    const V dv_du = all(task.dv_du), da_du = all(task.da_du);
    const V by_nn = hn::MulSub(dv_du, along - drag, da_du * added);
    const V by_speed = dv_du * quadratic / hn::Max(speed, all(1e-300));
    out.force_place = dyads(by_nn * n, n, by_speed * sideways, sideways);
    const V by_one = hn::MulAdd(da_du, mass + added, dv_du * (across + drag));
    const V3 none{all(0.0), all(0.0), all(0.0)};
    add_skew(none, by_one, out.force_place);
    const V turn_nn = hn::MulAdd(da_du, spin_moment - tilt_moment, dv_du * torsional), turned = dv_du * spin_moment;
    out.moment_turn = dyads(mul_add(turn_nn, n, turned * gyro), n, none, none);
    add_skew(hn::Neg(turned * spin) * n, da_du * tilt_moment, out.moment_turn);
  }
  return out;
}

// --- rows of the system ------------------------------------------------------------------------------------------------------------------

template <bool kAdd>
HWY_INLINE void store6(const V3& a, const V3& b, const Rows& to)
{
  store4<kAdd>(a.x, a.y, a.z, b.x, to, 0);
  const Tag tag;
  HWY_ALIGN double y[kLanes], z[kLanes];
  hn::Store(b.y, tag, y);
  hn::Store(b.z, tag, z);
  for (int k = 0; k < kLanes; ++k)
  {
    to.row[k][4] = kAdd ? to.row[k][4] + y[k] : y[k];
    to.row[k][5] = kAdd ? to.row[k][5] + z[k] : z[k];
  }
}

HWY_INLINE V with_sign(V v, bool minus)
{
  return minus ? hn::Neg(v) : v;
}

/// Blocks of 36, row by row, from quarters: `s`, which of them with the other sign.
template <bool kAdd>
HWY_INLINE void store_block(const M3& tl, const M3& tr, const M3& bl, const M3& br, bool s_tl, bool s_tr, bool s_bl, const Rows& to)
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

/// Where a batch's rows are: of its lower nodes, its upper ones, and the elements between.
struct SystemRows
{
  Rows lower_residual, upper_residual, lower_diagonal, upper_diagonal, upper, lower;
};

HWY_INLINE Rows block_rows(double* blocks, int i, int count, double* spare)
{
  return rows(blocks + 36 * static_cast<std::ptrdiff_t>(i), 36 * sizeof(double), count, spare);
}

HWY_INLINE Rows residual_rows(double* residual, int i, int count, double* spare)
{
  return rows(residual + 6 * static_cast<std::ptrdiff_t>(i), 6 * sizeof(double), count, spare);
}

/// The lowest node's own part.
template <bool kTangent>
void begin_run(const StringTask& task, double* spare)
{
  const NodePart node = node_part<kTangent>(task, task.first);
  store6<false>(node.force, node.moment, residual_rows(task.residual, task.first, 1, spare));
  if constexpr (kTangent)
  {
    M3 none;
    for (auto& row : none.m)
      for (V& number : row) number = all(0.0);
    store_block<false>(node.force_place, none, none, node.moment_turn, false, false, false, block_rows(task.diagonal, task.first, 1, spare));
  }
}

/// Elements from e on: each writes the rows of its upper node, and adds to those of its lower one.
template <bool kTangent>
HWY_INLINE void add_batch(const StringTask& task, int e, int count, double* spare)
{
  const Beam beam = load_beam(task, e);
  const Shape shape = shape_of(beam, task.structural_damping);
  const Forces f = forces_of(beam, shape);
  const NodePart node = node_part<kTangent>(task, e + 1);
  const V3 half_load = all(0.5) * beam.load;
  store6<false>(node.force - f.force - half_load, node.moment + f.moment_1, residual_rows(task.residual, e + 1, count, spare));
  store6<true>(f.force - half_load, f.moment_2, residual_rows(task.residual, e, count, spare));
  if constexpr (kTangent)
  {
    Tangent t;
    find_tangent(beam, shape, task.structural_damping, task.dv_du, t);
    store_block<false>(t.force_d, t.force_1, t.lower_d, t.lower_1, true, false, true, block_rows(task.upper, e, count, spare));
    store_block<false>(t.force_d, t.force_2, t.upper_d, t.upper_2, true, true, false, block_rows(task.lower, e, count, spare));
    const auto add = [](M3& to, const M3& more)
    {
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) to.m[i][j] = to.m[i][j] + more.m[i][j];
    };
    add(t.upper_1, node.moment_turn);
    M3 upper_force = node.force_place;
    add(upper_force, t.force_d);
    store_block<false>(upper_force, t.force_1, t.upper_d, t.upper_1, false, true, true, block_rows(task.diagonal, e + 1, count, spare));
    store_block<true>(t.force_d, t.force_2, t.lower_d, t.lower_2, false, false, false, block_rows(task.diagonal, e, count, spare));
  }
}

template <bool kTangent>
void add_run(const StringTask& task)
{
  double spare[36] = {};
  begin_run<kTangent>(task, spare);
  for (int e = task.first; e < task.last; e += kLanes)
    add_batch<kTangent>(task, e, lanes_from(e, task.last), spare);
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
    const Shape shape = shape_of(beam, task.structural_damping);
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
  store6<true>(-f.force, f.moment_1, residual_rows(forces, e + 1, count, spare));
  store6<true>(f.force, f.moment_2, residual_rows(forces, e, count, spare));
}

/// As the elastic element without damping and load, and what damping adds.
void sample(const StringTask& task, double* elastic, double* damping) noexcept
{
  for (int e = task.first; e < task.last; e += kLanes)
  {
    const int count = lanes_from(e, task.last);
    Beam beam = load_beam(task, e);
    const Forces with_load = forces_of(beam, shape_of(beam, 0.0)), damped = forces_of(beam, shape_of(beam, task.structural_damping));
    beam.load = {all(0.0), all(0.0), all(0.0)};
    add_to_ends(forces_of(beam, shape_of(beam, 0.0)), elastic, e, count);
    add_to_ends({damped.force - with_load.force, damped.moment_1 - with_load.moment_1, damped.moment_2 - with_load.moment_2}, damping, e, count);
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
    const V l = hn::Sqrt(dot(b.d, b.d));
    const V3 chord = (all(1.0) / l) * b.d, upper = b.n1 - chord, lower = b.n2 - chord;
    const V squares = dot(upper, upper) + dot(lower, lower), mixed = dot(upper, lower);
    const V stretch = (l - b.length) / b.length + all(0.5 * kShorteningNear) * squares + all(kShorteningFar) * mixed - b.free_stretch;
    const V energy = all(0.5) * (b.axial * b.length * stretch * stretch + b.near * squares + b.torsion * b.twist * b.twist) + b.far * mixed;
    const V3 ends = load3(*task.nodes, node_column::position, e) + load3(*task.nodes, node_column::position, e + 1);
    const V3 mean = mul_add(all(0.5), ends, (all(1.0 / 12.0) * b.length) * (b.n1 - b.n2));
    beams = beams + hn::IfThenElseZero(valid, energy);
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
