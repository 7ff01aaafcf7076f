// SPDX-License-Identifier: BSD-3-Clause
// Text of a body's inertia (rigid_body.h) for numbers of type V (math/vector_text.h); symbols as there. No include guard: it is
// another text for each V.

/// RigidBody.
struct Body
{
  V mass, added_mass, spin_inertia, tilt_inertia;
};

/// Force and moment that give the body the acceleration; `gyroscopic`: as of rigid_body.h.
DRILL_LAW V6 inertia_force(const Body& body, const V3& n, const V3& w, const V6& acceleration, V gyroscopic)
{
  const V3 &a = acceleration.head, &alpha = acceleration.tail;
  const V about = (body.spin_inertia - body.tilt_inertia) * dot(alpha, n);
  return {mul_sub_from(body.added_mass * dot(n, a), n, (body.mass + body.added_mass) * a),
          mul_add(body.tilt_inertia, alpha, mul_add(about, n, (gyroscopic * dot(w, n)) * cross(w, n)))};
}

/// The matrix nn n n^T + one 1.
struct AlongAndAcross
{
  V nn, one;
};

DRILL_LAW AlongAndAcross operator+(const AlongAndAcross& a, const AlongAndAcross& b)
{
  return {a.nn + b.nn, a.one + b.one};
}

// inertia_force() by the increment of a node (model/stage.h), its gyroscopic moment by J_s, in two parts.

DRILL_LAW AlongAndAcross inertia_slope(const Body& body, V da_du)
{
  return {minus(da_du * body.added_mass), da_du * (body.mass + body.added_mass)};
}

DRILL_LAW AlongAndAcross turning_slope(const Body& body, V da_du)
{
  return {da_du * (body.spin_inertia - body.tilt_inertia), da_du * body.tilt_inertia};
}

/// The whole of a moment's slope: `slope`, and by the gyroscopic moment, of which `turned` is J_s dv_du.
DRILL_LAW M3 moment_slope(const AlongAndAcross& slope, V turned, const V3& n, const V3& w)
{
  const V zero = all(0.0);
  const V3 none{zero, zero, zero};
  M3 out = dyads(mul_add(slope.nn, n, turned * cross(w, n)), n, none, none);
  add_skew(minus(turned * dot(w, n)) * n, slope.one, out);
  return out;
}
