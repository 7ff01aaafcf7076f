// SPDX-License-Identifier: BSD-3-Clause
// Text of the corotational beam (beam_element.h) for numbers of type V (math/vector_text.h); symbols as there. No include guard:
// it is another text for each V.

// mean of w'^2/2 of the cubic with end tilts a1, a2: (near/2)(|a1|^2 + |a2|^2) + far a1.a2
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

/// Gradient of the stretch, of its rate or of the tension times the length, with respect to d and the ends' spatial rotations.
struct Gradient
{
  V3 d, upper, lower;
};

/// What forces and tangent share. Of what damps the bending (BeamDamping), with m_i = c (k11 w_i + k12 w_j), s = c (k11 + k12):
///   M_i = P m_i - (s/l) e x v,   force (s/l) G,   G = e x (w_1 + w_2) + 2 P v/l.
struct Shape
{
  V inverse_l, tilt, c12, inverse_12;  // tilt: c1 + c2; inverse_12: 1/(1 + c12)
  V3 e, sum_across, binormal;          // chord's direction, n1 + n2 across it, d twist/d theta_2
  V3 by_n1, by_n2;                     // d stretch/d n1, d n2
  V3 turn_1, turn_2, crossed;          // n1 x e, n2 x e, n1 x n2
  Gradient stretch;
  V strain;                             // eps
  V tension, torque, chord, normals;    // chord P = -dU/dc1 = -dU/dc2, normals Q = dU/dc12
  V3 g1, g2;                            // dU/dn1, dU/dn2, load included
  V near, far, by_l, e_m1, e_m2;        // c k11, c k12, s/l, e.m_1, e.m_2
  V3 m_1, m_2, across, turned, sum, g;  // m_i, P v/l, e x v, w_1 + w_2, G
};

DRILL_LAW Shape shape_of(const Beam& b, double damping_time)
{
  const V one = all(1.0), time = all(damping_time), shortening = all(kShortening), shortening_far = all(kShorteningFar);
  Shape f;
  const V l = sqrt_of(dot(b.d, b.d));
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
  f.strain = mul_add(all(kShorteningNear), all(2.0) - f.tilt,
                     mul_add(shortening_far, f.c12 - f.tilt + one, (l - b.length) * inverse_length));
  const V stretching = dot(f.stretch.d, b.velocity) + dot(f.stretch.upper, b.turning_1) + dot(f.stretch.lower, b.turning_2);
  f.tension = b.axial * mul_add(time, stretching, f.strain - b.free_stretch);
  f.torque = b.torsion * mul_add(time, dot(f.binormal, b.turning_2 - b.turning_1), b.twist);

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

  f.chord = mul_add(f.tension * b.length, shortening, b.near + b.far);
  f.normals = mul_add(f.tension * b.length, shortening_far, b.far);
  const V3 end_load = (all(1.0 / 12.0) * b.length) * b.load;
  f.g1 = mul_add(f.normals, b.n2, mul_sub_from(f.chord, f.e, -end_load));
  f.g2 = mul_add(f.normals, b.n1, mul_sub_from(f.chord, f.e, end_load));
  return f;
}

struct Forces
{
  V3 force, moment_1, moment_2;
};

DRILL_LAW Forces forces_of(const Beam& b, const Shape& f)
{
  Forces out;
  out.force = mul_add(f.tension, f.e, mul_sub_from(f.chord * f.inverse_l, f.sum_across, f.by_l * f.g));
  out.moment_1 = cross(b.n1, f.g1) - mul_add(f.torque, f.binormal, mul_add(f.e_m1, f.e, mul_sub_from(f.by_l, -f.turned, -f.m_1)));
  out.moment_2 = mul_add(f.torque, f.binormal, cross(b.n2, f.g2)) - mul_add(f.e_m2, f.e, mul_sub_from(f.by_l, -f.turned, -f.m_2));
  return out;
}

/// Of the tension times the length; h: of the stretch's rate with respect to places, the rates held.
DRILL_LAW Gradient tension_gradient(const Beam& b, const Shape& f, double damping_time, double dv_du)
{
  const V3& v = b.velocity;
  const V v_along = dot(f.e, v);
  const V3 v_across = mul_sub_from(v_along, f.e, v);
  const V3 turning_1 = cross(b.turning_1, b.n1), turning_2 = cross(b.turning_2, b.n2), turning = turning_1 + turning_2;
  const V s_l = all(kShortening) * f.inverse_l, s_ll = s_l * f.inverse_l;
  Gradient h;
  h.d = mul_add(mul_add(s_ll, f.tilt, f.inverse_l / b.length), v_across,
                mul_add(mul_add(s_ll, dot(v, f.sum_across), s_l * dot(f.e, turning)), f.e,
                        mul_sub_from(s_l, turning, (s_ll * v_along) * f.sum_across)));
  const V3 away = s_l * v_across;
  h.upper = cross(b.n1, mul_add(all(kShorteningFar), turning_2, cross(f.by_n1, b.turning_1) - away));
  h.lower = cross(b.n2, mul_add(all(kShorteningFar), turning_1, cross(f.by_n2, b.turning_2) - away));
  const V axial = b.axial * b.length, by_place = axial * all(1.0 + damping_time * dv_du), by_rate = axial * all(damping_time);
  const Gradient& g = f.stretch;
  return {mul_add(by_place, g.d, by_rate * h.d), mul_add(by_place, g.upper, by_rate * (h.upper + cross(b.spin_1, g.upper))),
          mul_add(by_place, g.lower, by_rate * (h.lower + cross(b.spin_2, g.lower)))};
}

/// The gradients of the torque times the binormal b are skew(w_i) + b r_i^T, since
///   d b/d theta_i = -(skew(n_i) + b (n_i x n_j)^T)/(1 + c12).
struct TwistGradient
{
  V3 w_upper, w_lower, r_upper, r_lower;
};

DRILL_LAW TwistGradient twist_gradient(const Beam& b, const Shape& f, double damping_time, double dv_du)
{
  const V by_place = b.torsion * all(1.0 + damping_time * dv_du), by_rate = b.torsion * all(damping_time);
  const V3 turned = f.inverse_12 * f.crossed;
  const V3 turning = by_rate * (b.turning_2 - b.turning_1), scaled = f.inverse_12 * turning, damped = by_rate * f.binormal;
  const V3 common = mul_add(by_place, f.binormal, (f.torque + dot(f.binormal, turning)) * turned);
  const V by_n = minus(f.torque * f.inverse_12);
  return {by_n * b.n1, by_n * b.n2, cross(b.n1, scaled) - cross(b.spin_1, damped) - common,
          cross(b.n2, scaled) + cross(b.spin_2, damped) + common};
}

/// BeamTangent. Each block: at constant tension and torque, then twist, then tension, the last two as dyads; in the same sums
/// what damps the bending, with d w_i = dv_du d theta_i + d theta_i x spin_i and d v = dv_du d d.
struct Tangent
{
  M3 force_d, force_1, force_2, upper_d, upper_1, upper_2, lower_d, lower_1, lower_2;
};

DRILL_LAW void find_tangent(const Beam& b, const Shape& f, double damping_time, double dv_du, Tangent& t)
{
  const V3 &n1 = b.n1, &n2 = b.n2, &e = f.e;
  const Gradient& g = f.stretch;
  const Gradient tension = tension_gradient(b, f, damping_time, dv_du);
  const TwistGradient twist = twist_gradient(b, f, damping_time, dv_du);
  const V rate = all(dv_du), p_l = f.chord * f.inverse_l, p_ll = p_l * f.inverse_l;
  const V s_l = f.by_l, s_ll = all(2.0) * s_l * f.inverse_l;
  const V damped = s_ll * neg_mul_add(f.inverse_l, dot(e, b.velocity), rate);
  const V across = mul_add(f.tension, f.inverse_l, mul_add(p_ll, f.tilt, damped));
  const V3 turn_1 = p_l * f.turn_1, turn_2 = p_l * f.turn_2, tilted = (rate * s_l) * e;
  const V3 by_chord = (s_l * f.inverse_l) * b.velocity - tilted, turned = s_ll * f.turned;
  const V3 chord_n1 = p_l * n1, chord_n2 = p_l * n2;
  const V3 sideways = p_ll * f.sum_across, back = minus(s_l) * e;

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
  add_skew(by_chord - chord_n1, minus(along_1), t.upper_d);
  t.lower_d = dyads(turn_2 + turned, e, g.lower, tension.d);
  add_dyad(e, mul_sub_from(f.inverse_l, f.m_2, (along_2 + along_2) * e), t.lower_d);
  add_skew(by_chord - chord_n2, minus(along_2), t.lower_d);

  const V3 row_1 = mul_sub_from(rate, e, cross(e, b.spin_1)), row_2 = mul_sub_from(rate, e, cross(e, b.spin_2));
  const V near = f.near * rate, far = mul_add(f.far, rate, f.normals * f.c12);
  t.upper_1 = dyads(n1, f.g1, f.binormal, -twist.r_upper);
  add_dyad(g.upper, tension.upper, t.upper_1);
  add_dyad(e, f.near * row_1, t.upper_1);
  add_skew(-mul_add(f.near, b.spin_1, twist.w_upper), near - dot(f.g1, n1), t.upper_1);
  t.upper_2 = dyads(n2, minus(f.normals) * n1, f.binormal, -twist.r_lower);
  add_dyad(g.upper, tension.lower, t.upper_2);
  add_dyad(e, f.far * row_2, t.upper_2);
  add_skew(-mul_add(f.far, b.spin_2, twist.w_lower), far, t.upper_2);
  t.lower_1 = dyads(n1, minus(f.normals) * n2, f.binormal, twist.r_upper);
  add_dyad(g.lower, tension.upper, t.lower_1);
  add_dyad(e, f.far * row_1, t.lower_1);
  add_skew(mul_sub_from(f.far, b.spin_1, twist.w_upper), far, t.lower_1);
  t.lower_2 = dyads(n2, f.g2, f.binormal, twist.r_lower);
  add_dyad(g.lower, tension.lower, t.lower_2);
  add_dyad(e, f.near * row_2, t.lower_2);
  add_skew(mul_sub_from(f.near, b.spin_2, twist.w_lower), near - dot(f.g2, n2), t.lower_2);
}

/// Energy U.
DRILL_LAW V energy_of(const Beam& b)
{
  const V half = all(0.5), l = sqrt_of(dot(b.d, b.d));
  const V3 chord = (all(1.0) / l) * b.d, upper = b.n1 - chord, lower = b.n2 - chord;  // a1, a2
  const V squares = dot(upper, upper) + dot(lower, lower), mixed = dot(upper, lower);
  const V shortening = all(0.5 * kShorteningNear) * squares + all(kShorteningFar) * mixed;
  const V stretch = (l - b.length) / b.length + shortening - b.free_stretch;
  return half * (b.axial * b.length * stretch * stretch + b.near * squares + b.torsion * b.twist * b.twist) + b.far * mixed;
}
