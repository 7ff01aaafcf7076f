// The formulas are those of string/beam_element.cpp, model/forces/inertia.cpp and mud_drag.cpp; symbols as there.
#include "drill_rig_sim/model/kernels/string_kernel.h"

#include <cmath>

#include "drill_rig_sim/model/kernels/string_columns.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "model/kernels/string_kernel.cpp"
#include "math/simd.h"
#ifdef DRILL_RIG_SIM_HIGHWAY
#include <hwy/contrib/math/math-inl.h>  // in every pass
#endif

#if DRILL_RIG_SIM_WIDE
HWY_BEFORE_NAMESPACE();
namespace drill_rig_sim::HWY_NAMESPACE
{
namespace
{
#include "math/lanes.h"

// --- motion --------------------------------------------------------------------------------------------------------------------------

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
    const int count = task.last - i < kLanes ? task.last - i : kLanes;
    const Moves m = moved(task, i, count);
    char* to = reinterpret_cast<char*>(task.moves) + (i - task.first) * task.move_stride;
    store(m, rows(reinterpret_cast<double*>(to), task.move_stride, count, spare));
    store(m, *task.nodes, i);
  }
}

// --- mud and inertia -------------------------------------------------------------------------------------------------------------------

struct M3
{
  V m[3][3];
};

struct NodePart
{
  V3 force, moment;
  M3 force_place, moment_turn;  // their derivatives
};

/// a b^T + c d^T
HWY_INLINE M3 dyads(const V3& a, const V3& b, const V3& c, const V3& d)
{
  const auto row = [&](V p, V q, V* out)
  {
    out[0] = hn::MulAdd(p, b.x, q * d.x);
    out[1] = hn::MulAdd(p, b.y, q * d.y);
    out[2] = hn::MulAdd(p, b.z, q * d.z);
  };
  M3 out;
  row(a.x, c.x, out.m[0]);
  row(a.y, c.y, out.m[1]);
  row(a.z, c.z, out.m[2]);
  return out;
}

/// Adds a b^T.
HWY_INLINE void add_dyad(const V3& a, const V3& b, M3& out)
{
  const auto row = [&](V p, V* to)
  {
    to[0] = hn::MulAdd(p, b.x, to[0]);
    to[1] = hn::MulAdd(p, b.y, to[1]);
    to[2] = hn::MulAdd(p, b.z, to[2]);
  };
  row(a.x, out.m[0]);
  row(a.y, out.m[1]);
  row(a.z, out.m[2]);
}

/// Adds skew(v) + `diagonal` 1.
HWY_INLINE void add_skew(const V3& v, V diagonal, M3& out)
{
  out.m[0][0] = out.m[0][0] + diagonal;
  out.m[1][1] = out.m[1][1] + diagonal;
  out.m[2][2] = out.m[2][2] + diagonal;
  out.m[1][0] = out.m[1][0] + v.z;
  out.m[0][1] = out.m[0][1] - v.z;
  out.m[0][2] = out.m[0][2] + v.y;
  out.m[2][0] = out.m[2][0] - v.y;
  out.m[2][1] = out.m[2][1] + v.x;
  out.m[1][2] = out.m[1][2] - v.x;
}

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

// --- beams -----------------------------------------------------------------------------------------------------------------------------

constexpr double kShorteningNear = 4.0 / 30.0;
constexpr double kShorteningFar = -1.0 / 30.0;
constexpr double kShortening = kShorteningNear + kShorteningFar;

/// An element's ends: BeamPose, BeamSection and BeamDamping of beam_element.h.
struct Beam
{
  V length, axial, near, far, torsion, free_stretch;
  V3 load;
  V3 d;  // from the upper end to the lower one
  V3 n1, n2;
  V twist;
  V3 velocity, turning_1, turning_2, spin_1, spin_2;
};

/// Lower end relative to the upper one.
HWY_INLINE V twist_between(const Quaternion& from, const Quaternion& to)
{
  const V w = hn::MulAdd(from.w, to.w, hn::MulAdd(from.x, to.x, hn::MulAdd(from.y, to.y, from.z * to.z)));
  const V x = hn::MulAdd(from.w, to.x, hn::NegMulAdd(from.x, to.w, hn::MulSub(from.z, to.y, from.y * to.z)));
  const V t = x / w;  // a w below zero changes both their signs
  if (hn::AllTrue(Tag(), hn::Abs(t) < all(0.1)))
  {
    const V s = t * t;
    V sum = all(1.0 / 17.0);
    for (const double odd : {15.0, 13.0, 11.0, 9.0, 7.0, 5.0, 3.0, 1.0}) sum = hn::NegMulAdd(s, sum, all(1.0 / odd));
    return all(2.0) * t * sum;
  }
  return all(2.0) * hn::Atan(Tag(), t);
}

HWY_INLINE Beam load_beam(const StringTask& task, int e)
{
  const NumberColumns &nodes = *task.nodes, &elements = *task.elements;
  const auto of_element = [&](int kind) { return load(elements[kind] + e); };
  Beam b;
  b.length = of_element(element_column::length);
  b.axial = of_element(element_column::axial);
  b.near = of_element(element_column::bending_near);
  b.far = of_element(element_column::bending_far);
  b.torsion = of_element(element_column::torsion);
  b.free_stretch = of_element(element_column::free_stretch);
  b.load = load3(elements, element_column::load, e);
  b.d = load3(nodes, node_column::position, e) - load3(nodes, node_column::position, e + 1);
  b.n1 = load3(nodes, node_column::normal, e + 1);
  b.n2 = load3(nodes, node_column::normal, e);
  b.velocity = load3(nodes, node_column::velocity, e) - load3(nodes, node_column::velocity, e + 1);
  b.turning_1 = load3(nodes, node_column::turning, e + 1);
  b.turning_2 = load3(nodes, node_column::turning, e);
  b.spin_1 = load(nodes[node_column::carried_spin] + e + 1) * b.n1;
  b.spin_2 = load(nodes[node_column::carried_spin] + e) * b.n2;
  Quaternion upper = load_quaternion(nodes, node_column::orientation, e + 1);
  if (!hn::AllTrue(Tag(), of_element(element_column::upper_end + 3) == all(1.0)))  // there is a bend
  {
    upper = upper * load_quaternion(elements, element_column::upper_end, e);
    b.n1 = x_axis(upper);
  }
  b.twist = twist_between(upper, load_quaternion(nodes, node_column::orientation, e));
  return b;
}

/// Gradient of the stretch, of its rate or of the tension times the length.
struct Gradient
{
  V3 d, upper, lower;
};

/// What forces and tangent share: Shape and BendingDamping of beam_element.cpp.
struct Shape
{
  V inverse_l, tilt, c12, inverse_12;
  V3 e, sum_across, binormal, by_n1, by_n2;
  V3 turn_1, turn_2, crossed;  // n1 x e, n2 x e, n1 x n2
  Gradient stretch;
  V tension, torque, chord, normals;
  V3 g1, g2;
  V near, far, by_l, e_m1, e_m2;  // c k11, c k12, s/l, e.m_1, e.m_2
  V3 m_1, m_2, across, turned, sum, g;
};

HWY_INLINE Shape shape_of(const Beam& b, double damping_time)
{
  const V one = all(1.0), time = all(damping_time), shortening = all(kShortening), shortening_far = all(kShorteningFar);
  Shape f;
  const V l = hn::Sqrt(dot(b.d, b.d));
  f.inverse_l = one / l;
  f.e = f.inverse_l * b.d;
  const V3 sum = b.n1 + b.n2;
  f.tilt = dot(f.e, sum);
  f.sum_across = mul_sub_from(f.tilt, f.e, sum);
  f.c12 = dot(b.n1, b.n2);
  f.inverse_12 = one / (one + f.c12);
  f.binormal = f.inverse_12 * sum;
  f.by_n1 = mul_sub_from(shortening, f.e, shortening_far * b.n2);
  f.by_n2 = mul_sub_from(shortening, f.e, shortening_far * b.n1);
  f.turn_1 = cross(b.n1, f.e);
  f.turn_2 = cross(b.n2, f.e);
  f.crossed = cross(b.n1, b.n2);
  const V inverse_length = one / b.length;
  const V3 far_crossed = shortening_far * f.crossed;
  f.stretch.d = mul_sub_from(shortening * f.inverse_l, f.sum_across, inverse_length * f.e);
  f.stretch.upper = mul_sub_from(shortening, f.turn_1, far_crossed);
  f.stretch.lower = mul_sub_from(shortening, f.turn_2, -far_crossed);
  const V stretch = hn::MulAdd(all(kShorteningNear), all(2.0) - f.tilt,
                               hn::MulAdd(shortening_far, f.c12 - f.tilt + one, (l - b.length) * inverse_length));
  const V stretching = dot(f.stretch.d, b.velocity) + dot(f.stretch.upper, b.turning_1) + dot(f.stretch.lower, b.turning_2);
  f.tension = b.axial * hn::MulAdd(time, stretching, stretch - b.free_stretch);
  f.torque = b.torsion * hn::MulAdd(time, dot(f.binormal, b.turning_2 - b.turning_1), b.twist);

  f.near = time * b.near;
  f.far = time * b.far;
  f.by_l = f.inverse_l * (f.near + f.far);
  f.m_1 = mul_add(f.near, b.turning_1, f.far * b.turning_2);
  f.m_2 = mul_add(f.far, b.turning_1, f.near * b.turning_2);
  f.e_m1 = dot(f.e, f.m_1);
  f.e_m2 = dot(f.e, f.m_2);
  f.across = f.inverse_l * mul_sub_from(dot(f.e, b.velocity), f.e, b.velocity);
  f.turned = cross(f.e, b.velocity);
  f.sum = b.turning_1 + b.turning_2;
  f.g = mul_add(all(2.0), f.across, cross(f.e, f.sum));

  f.chord = hn::MulAdd(f.tension * b.length, shortening, b.near + b.far);
  f.normals = hn::MulAdd(f.tension * b.length, shortening_far, b.far);
  const V3 end_load = (all(1.0 / 12.0) * b.length) * b.load;
  f.g1 = mul_add(f.normals, b.n2, mul_sub_from(f.chord, f.e, -end_load));
  f.g2 = mul_add(f.normals, b.n1, mul_sub_from(f.chord, f.e, end_load));
  return f;
}

struct Forces
{
  V3 force, moment_1, moment_2;
};

HWY_INLINE Forces forces_of(const Beam& b, const Shape& f)
{
  Forces out;
  out.force = mul_add(f.tension, f.e, mul_sub_from(f.chord * f.inverse_l, f.sum_across, f.by_l * f.g));
  out.moment_1 = cross(b.n1, f.g1) - mul_add(f.torque, f.binormal, mul_add(f.e_m1, f.e, mul_sub_from(f.by_l, -f.turned, -f.m_1)));
  out.moment_2 = mul_add(f.torque, f.binormal, cross(b.n2, f.g2)) - mul_add(f.e_m2, f.e, mul_sub_from(f.by_l, -f.turned, -f.m_2));
  return out;
}

HWY_INLINE Gradient tension_gradient(const Beam& b, const Shape& f, double damping_time, double dv_du)
{
  const V3& v = b.velocity;
  const V v_along = dot(f.e, v);
  const V3 v_across = mul_sub_from(v_along, f.e, v);
  const V3 turning_1 = cross(b.turning_1, b.n1), turning_2 = cross(b.turning_2, b.n2), turning = turning_1 + turning_2;
  const V s_l = all(kShortening) * f.inverse_l, s_ll = s_l * f.inverse_l;
  Gradient h;
  h.d = mul_add(hn::MulAdd(s_ll, f.tilt, f.inverse_l / b.length), v_across,
                mul_add(hn::MulAdd(s_ll, dot(v, f.sum_across), s_l * dot(f.e, turning)), f.e,
                        mul_sub_from(s_l, turning, (s_ll * v_along) * f.sum_across)));
  const V3 away = s_l * v_across;
  h.upper = cross(b.n1, mul_add(all(kShorteningFar), turning_2, cross(f.by_n1, b.turning_1) - away));
  h.lower = cross(b.n2, mul_add(all(kShorteningFar), turning_1, cross(f.by_n2, b.turning_2) - away));
  const V axial = b.axial * b.length, by_place = axial * all(1.0 + damping_time * dv_du), by_rate = axial * all(damping_time);
  const Gradient& g = f.stretch;
  return {mul_add(by_place, g.d, by_rate * h.d), mul_add(by_place, g.upper, by_rate * (h.upper + cross(b.spin_1, g.upper))),
          mul_add(by_place, g.lower, by_rate * (h.lower + cross(b.spin_2, g.lower)))};
}

/// Of the torque times the binormal: skew(w) + binormal r^T.
struct TwistGradient
{
  V3 w_upper, w_lower, r_upper, r_lower;
};

HWY_INLINE TwistGradient twist_gradient(const Beam& b, const Shape& f, double damping_time, double dv_du)
{
  const V by_place = b.torsion * all(1.0 + damping_time * dv_du), by_rate = b.torsion * all(damping_time);
  const V3 turned = f.inverse_12 * f.crossed;
  const V3 turning = by_rate * (b.turning_2 - b.turning_1), scaled = f.inverse_12 * turning, damped = by_rate * f.binormal;
  const V3 common = mul_add(by_place, f.binormal, (f.torque + dot(f.binormal, turning)) * turned);
  const V by_n = hn::Neg(f.torque * f.inverse_12);
  return {by_n * b.n1, by_n * b.n2, cross(b.n1, scaled) - cross(b.spin_1, damped) - common,
          cross(b.n2, scaled) + cross(b.spin_2, damped) + common};
}

/// BeamTangent.
struct Tangent
{
  M3 force_d, force_1, force_2, upper_d, upper_1, upper_2, lower_d, lower_1, lower_2;
};

HWY_INLINE void find_tangent(const Beam& b, const Shape& f, double damping_time, double dv_du, Tangent& t)
{
  const V3 &n1 = b.n1, &n2 = b.n2, &e = f.e;
  const Gradient& g = f.stretch;
  const Gradient tension = tension_gradient(b, f, damping_time, dv_du);
  const TwistGradient twist = twist_gradient(b, f, damping_time, dv_du);
  const V rate = all(dv_du), p_l = f.chord * f.inverse_l, p_ll = p_l * f.inverse_l, s_l = f.by_l, s_ll = all(2.0) * s_l * f.inverse_l;
  const V across = hn::MulAdd(f.tension, f.inverse_l, hn::MulAdd(p_ll, f.tilt, s_ll * hn::NegMulAdd(f.inverse_l, dot(e, b.velocity), rate)));
  const V3 turn_1 = p_l * f.turn_1, turn_2 = p_l * f.turn_2, tilted = (rate * s_l) * e;
  const V3 by_chord = (s_l * f.inverse_l) * b.velocity - tilted, turned = s_ll * f.turned, chord_n1 = p_l * n1, chord_n2 = p_l * n2;
  const V3 sideways = p_ll * f.sum_across, back = hn::Neg(s_l) * e;

  t.force_d = dyads(e, sideways - mul_add(across, e, s_ll * f.across), mul_sub_from(s_ll, f.g, sideways), e);
  add_dyad(g.d, tension.d, t.force_d);
  add_skew((all(-0.5) * s_ll) * f.sum, across, t.force_d);
  t.force_1 = dyads(e, turn_1, g.d, tension.upper);
  add_dyad(b.spin_1, back, t.force_1);
  add_skew(chord_n1 + tilted, s_l * dot(e, b.spin_1), t.force_1);
  t.force_2 = dyads(e, turn_2, g.d, tension.lower);
  add_dyad(b.spin_2, back, t.force_2);
  add_skew(chord_n2 + tilted, s_l * dot(e, b.spin_2), t.force_2);
  const V along_1 = f.inverse_l * f.e_m1, along_2 = f.inverse_l * f.e_m2;
  t.upper_d = dyads(turn_1 + turned, e, g.upper, tension.d);
  add_dyad(e, mul_sub_from(f.inverse_l, f.m_1, (along_1 + along_1) * e), t.upper_d);
  add_skew(by_chord - chord_n1, hn::Neg(along_1), t.upper_d);
  t.lower_d = dyads(turn_2 + turned, e, g.lower, tension.d);
  add_dyad(e, mul_sub_from(f.inverse_l, f.m_2, (along_2 + along_2) * e), t.lower_d);
  add_skew(by_chord - chord_n2, hn::Neg(along_2), t.lower_d);

  const V3 row_1 = mul_sub_from(rate, e, cross(e, b.spin_1)), row_2 = mul_sub_from(rate, e, cross(e, b.spin_2));
  const V near = f.near * rate, far = hn::MulAdd(f.far, rate, f.normals * f.c12);
  t.upper_1 = dyads(n1, f.g1, f.binormal, -twist.r_upper);
  add_dyad(g.upper, tension.upper, t.upper_1);
  add_dyad(e, f.near * row_1, t.upper_1);
  add_skew(-mul_add(f.near, b.spin_1, twist.w_upper), near - dot(f.g1, n1), t.upper_1);
  t.upper_2 = dyads(n2, hn::Neg(f.normals) * n1, f.binormal, -twist.r_lower);
  add_dyad(g.upper, tension.lower, t.upper_2);
  add_dyad(e, f.far * row_2, t.upper_2);
  add_skew(-mul_add(f.far, b.spin_2, twist.w_lower), far, t.upper_2);
  t.lower_1 = dyads(n1, hn::Neg(f.normals) * n2, f.binormal, twist.r_upper);
  add_dyad(g.lower, tension.upper, t.lower_1);
  add_dyad(e, f.far * row_1, t.lower_1);
  add_skew(mul_sub_from(f.far, b.spin_1, twist.w_upper), far, t.lower_1);
  t.lower_2 = dyads(n2, f.g2, f.binormal, twist.r_lower);
  add_dyad(g.lower, tension.lower, t.lower_2);
  add_dyad(e, f.near * row_2, t.lower_2);
  add_skew(mul_sub_from(f.near, b.spin_2, twist.w_lower), near - dot(f.g2, n2), t.lower_2);
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
    add_batch<kTangent>(task, e, task.last - e < kLanes ? task.last - e : kLanes, spare);
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
    const int count = task.last - e < kLanes ? task.last - e : kLanes;
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
}  // namespace

constexpr StringKernel table = {move, add, find_forces};
}  // namespace drill_rig_sim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif

#if DRILL_RIG_SIM_ONCE
namespace drill_rig_sim
{
const StringKernel* string_kernel(Kernel kernel) noexcept
{
  constexpr const StringKernel* none = nullptr;
  return DRILL_RIG_SIM_TABLE(kernel, none, table);
}
}  // namespace drill_rig_sim
#endif
