// SPDX-License-Identifier: BSD-3-Clause
// Text of the Stribeck curve (friction_law.h) and of the sticking bristle (wall_contact.h, surface_friction.h) for numbers of
// type V (math/vector_text.h). No include guard: it is another text for each V.

/// Friction coefficient at a slip speed, its slope by the speed, and that over the speed [-, s/m, s2/m2].
struct Stribeck
{
  V value, slope, slope_over_speed;
};

/// mu(v) = mu_k (1 + (ratio - 1) exp(-(v/v_s)^2)); `exponential`: exp(-v/v_s).
DRILL_LAW Stribeck stribeck(V kinetic, V static_ratio, V stribeck_speed, V speed, bool exponential)
{
  const V zero = all(0.0), x = speed / stribeck_speed;
  const V excess = kinetic * (static_ratio - all(1.0)) * exp_of(minus(exponential ? x : x * x)),
          per_speed = excess / stribeck_speed;
  if (exponential) return {kinetic + excess, minus(per_speed), select_or_zero(speed > zero, minus(per_speed) / speed)};
  return {kinetic + excess, all(-2.0) * x * per_speed, all(-2.0) * per_speed / stribeck_speed};
}

/// What rubs: mu_k, static over kinetic friction, v_s; stiffness and damping of the bristle [-, -, m/s, N/m, N s/m].
struct Rubbing
{
  V kinetic, static_ratio, stribeck_speed, stiffness, damping;
  bool exponential;
};

/// Friction along one direction or in a plane; Vector: V2 or V3.
template <class Vector>
struct Rubbed
{
  Vector force;      // of the wall on the string [N]
  Vector bristle;    // at the stage [m]
  Vector direction;  // q/|q| of what slips, else 0
  V trial;           // |q| [N]
  Stribeck mu;       // of what slips
  Mask slipping;
};

/// How much of its way to its own limit a bristle that slips goes in a time [s], of stiffness k_b and damping c_b: over c_b/k_b.
DRILL_LAW V follows_by(V time, V stiffness, V damping)
{
  return select(damping > all(0.0), time / (time + damping / stiffness), all(1.0));
}

/// Return mapping of the bristle: f = -q while |q| <= mu(|v|) F_n, else -mu F_n q/|q|, and the bristle goes to its own limit over
/// c_b/k_b.
/// @param trial      q = k_b z_t + c_b v_t
/// @param stretched  z_t
/// @param velocity   gives v_t; called only where kinetic friction by itself does not hold q
/// @param before     gives z at the start of the step; as velocity
/// @param time       since then [s]
template <class Vector, class Velocity, class Before>
DRILL_LAW Rubbed<Vector> rubbed(const Rubbing& law, V normal_force, const Vector& trial, const Vector& stretched,
                                const Velocity& velocity, const Before& before, V time)
{
  const V zero = all(0.0), one = all(1.0);
  Rubbed<Vector> r{-trial, stretched, zero * trial, norm(trial), {zero, zero, zero}, zero > zero};
  if (all_of(r.trial <= law.kinetic * normal_force)) return r;  // friction is never below kinetic
  r.mu = stribeck(law.kinetic, law.static_ratio, law.stribeck_speed, norm(velocity()), law.exponential);
  const V limit = r.mu.value * normal_force;
  r.slipping = r.trial > limit;
  r.direction = choose(r.slipping, (one / r.trial) * trial, r.direction);
  r.force = choose(r.slipping, minus(limit) * r.direction, r.force);
  const V follows = follows_by(time, law.stiffness, law.damping);
  const Vector start = before();
  r.bristle = choose(r.slipping, mul_add(follows, (limit / law.stiffness) * r.direction - start, start), r.bristle);
  return r;
}

/// Slopes of rubbed() in two directions: of the force by the displacement (through the velocity too), row by row, and by the
/// normal force.
struct RubbedSlopes
{
  V2 first_row, second_row, by_normal_force;  // [N/m, N/m, -]
};

/// @param dv_du  of the velocity by the displacement [1/s]
DRILL_LAW RubbedSlopes slopes_of(const Rubbing& law, V normal_force, const Rubbed<V2>& r, const V2& velocity, V dv_du)
{
  const V one = all(1.0), sticking = mul_add(dv_du, law.damping, law.stiffness);
  const V across = select(r.slipping, r.mu.value * normal_force / r.trial * sticking, sticking);
  const V by_speed = r.mu.slope_over_speed * normal_force * dv_du;
  const V2& d = r.direction;
  const V off = across * d.x * d.y;
  const V xx = minus(across * neg_mul_add(d.x, d.x, one)), yy = minus(across * neg_mul_add(d.y, d.y, one));
  return {{neg_mul_add(by_speed * d.x, velocity.x, xx), neg_mul_add(by_speed * d.x, velocity.y, off)},
          {neg_mul_add(by_speed * d.y, velocity.x, off), neg_mul_add(by_speed * d.y, velocity.y, yy)},
          minus(r.mu.value) * d};
}
