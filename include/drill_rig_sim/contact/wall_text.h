// SPDX-License-Identifier: BSD-3-Clause
// Text of wall_contact.h for numbers of type V (math/vector_text.h), behind normal_text.h and friction_text.h; symbols as there.
// No include guard: it is another text for each V.

/// Hole, section, its motion and its law: ClosestPoint, ContactMotion and WallLaw.
struct Contact
{
  V3 centre, slope, gradient;  // r_C, dr_C/ds, ds/dr_D
  V hole_radius, radius_slope, radius;
  V3 position, displacement, rotation, velocity, turning, bristle;
  V stiffness, exponent, damping;
  V lever;  // R_F
  Rubbing rubbing;
};

struct Wall
{
  V rho, penetration;
  V3 n, gradient, slope;  // n, d delta/dr_D, P dC/ds
  Pressed normal;
  V3 surface_velocity, pull;  // v_D + omega x R_F n; k_b (z_n + slip) + c_b times that: q = P pull
  Rubbed<V3> friction;
  V3 slip_direction;  // v_t/|v_t| of what slips, else 0
  Mask touches;
};

/// Geometry and normal force.
DRILL_LAW void press(const Contact& c, Wall& w)
{
  const V zero = all(0.0), smoothing = all(wall_contact_smoothing);
  const V3 d = c.position - c.centre;
  w.rho = sqrt_of(dot(d, d) + smoothing * smoothing);
  w.penetration = w.rho - (c.hole_radius - c.radius);
  w.touches = w.penetration > zero;
  w.n = (all(1.0) / w.rho) * d;
  w.gradient = mul_sub_from(c.radius_slope, c.gradient, w.n);
  w.slope = in_plane(w.n, c.slope);
  w.normal = pressed(c.stiffness, c.exponent, c.damping, larger(w.penetration, zero), dot(w.gradient, c.velocity));
}

/// Friction, behind press(). `time` [s]: since the start of the step.
DRILL_LAW void rub(const Contact& c, V time, Wall& w)
{
  const V zero = all(0.0);
  const V3 arm = c.lever * w.n, none{zero, zero, zero};
  w.surface_velocity = c.velocity + cross(c.turning, arm);
  const V3 moved = c.bristle + c.displacement + cross(c.rotation, arm);
  w.pull = mul_add(c.rubbing.stiffness, moved, c.rubbing.damping * w.surface_velocity);
  const auto velocity = [&] { return in_plane(w.n, w.surface_velocity); };
  w.friction = rubbed(
      c.rubbing, w.normal.value, in_plane(w.n, w.pull), in_plane(w.n, moved), velocity, [&] { return in_plane(w.n, c.bristle); },
      time);
  w.slip_direction = none;
  if (all_of(opposite(w.friction.slipping))) return;
  const V3 slip = velocity();
  const V speed = norm(slip);
  w.slip_direction = choose(both(w.friction.slipping, speed > zero), (all(1.0) / speed) * slip, none);
}

/// The columns of B = dn/dr_D = (1 - n n^T - P c' (ds/dr_D)^T)/rho.
DRILL_LAW void find_normal_derivative(const Wall& w, const V3& md_gradient, V3 (&b)[3])
{
  const V inverse_rho = all(1.0) / w.rho;
  const auto column = [&](V n_j, V gradient_j) { return inverse_rho * (-(n_j * w.n) - gradient_j * w.slope); };
  b[0] = column(w.n.x, md_gradient.x);
  b[1] = column(w.n.y, md_gradient.y);
  b[2] = column(w.n.z, md_gradient.z);
  b[0].x = b[0].x + inverse_rho;
  b[1].y = b[1].y + inverse_rho;
  b[2].z = b[2].z + inverse_rho;
}

/// d(force, moment)/d(x, r), by numbers row by row.
DRILL_LAW void find_wall_tangent(const Contact& c, const Wall& w, V rate, V (&out)[36])
{
  const V zero = all(0.0);
  const V3 n = w.n;
  V3 b[3];
  find_normal_derivative(w, c.gradient, b);
  const auto transposed = [&](const V3& v) { return V3{dot(b[0], v), dot(b[1], v), dot(b[2], v)}; };
  const V3 normal_gradient =
      mul_add(mul_add(rate, w.normal.damping, w.normal.stiffness), w.gradient, w.normal.damping * transposed(c.velocity));

  // of the friction's limit, where it slips: |f| = mu(|v_t|) F_n; d|v_t| = e . dv_s - (n . v_s) e . dn, with e = v_t/|v_t|
  const Rubbed<V3>& rub = w.friction;
  const V3 e = w.slip_direction;
  const V per_speed = rub.mu.slope * w.normal.value,
          share = select(rub.slipping, rub.mu.value * w.normal.value / rub.trial, all(1.0));
  const V3 through = c.lever * cross(e, c.turning) - dot(n, w.surface_velocity) * e;
  const V3 limit_x = mul_add(rub.mu.value, normal_gradient, per_speed * mul_add(rate, e, transposed(through)));
  const V3 limit_r = (per_speed * rate * c.lever) * cross(n, e);
  // sticking: -dq; slipping along m = q/|q|: -|f|/|q| (1 - m m^T) dq - m d|f|
  const auto friction = [&](V limit, const V3& trial)
  { return mul_sub_from(share, trial, mul_sub(share, dot(rub.direction, trial), limit) * rub.direction); };

  // q = P w, w = k (z_n + x + r x R_F n) + c_b (v + omega x R_F n), with s = k + c c_b and rho = k r + c_b omega:
  //   dq/dx = s + R_F skew(rho) B - (n . w) B - n (s n + B^T (R_F n x rho + w))^T,   dq/dr = -s R_F skew(n)
  const V s = mul_add(rate, c.rubbing.damping, c.rubbing.stiffness);
  const V3 turn = mul_add(c.rubbing.stiffness, c.rotation, c.rubbing.damping * c.turning);
  const V along = dot(n, w.pull);
  const V3 row = mul_add(s, n, transposed(mul_add(c.lever, cross(n, turn), w.pull)));
  const V of_row[3] = {row.x, row.y, row.z}, of_gradient[3] = {normal_gradient.x, normal_gradient.y, normal_gradient.z};
  const V of_limit_x[3] = {limit_x.x, limit_x.y, limit_x.z}, of_limit_r[3] = {limit_r.x, limit_r.y, limit_r.z};
  const V3 arm = c.lever * n;
  const V3 turned[3] = {
      {zero, minus(s * arm.z), s * arm.y}, {s * arm.z, zero, minus(s * arm.x)}, {minus(s * arm.y), s * arm.x, zero}};
  const auto write = [&out](int column, const V3& force, const V3& moment)
  {
    out[column] = force.x;
    out[6 + column] = force.y;
    out[12 + column] = force.z;
    out[18 + column] = moment.x;
    out[24 + column] = moment.y;
    out[30 + column] = moment.z;
  };
  for (int j = 0; j < 3; ++j)
  {
    V3 trial = mul_sub_from(of_row[j], n, mul_sub_from(along, b[j], c.lever * cross(turn, b[j])));
    (j == 0 ? trial.x : j == 1 ? trial.y : trial.z) = (j == 0 ? trial.x : j == 1 ? trial.y : trial.z) + s;
    const V3 f = friction(of_limit_x[j], trial);
    write(j, f - mul_add(of_gradient[j], n, w.normal.value * b[j]), c.lever * (cross(n, f) + cross(b[j], rub.force)));
    const V3 f_r = friction(of_limit_r[j], turned[j]);
    write(3 + j, f_r, cross(arm, f_r));
  }
}
