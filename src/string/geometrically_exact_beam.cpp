// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/string/geometrically_exact_beam.h"

#include <cmath>

#include "drill_rig_sim/math/rotation.h"

namespace drill_rig_sim
{
using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

namespace
{
/// Functions of alpha, half the angle between the ends. A dash is the derivative by alpha, divided by alpha.
struct HalfAngle
{
  double b, h, c;  // alpha/sin alpha, (1 - b)/alpha^2, tan(alpha/2)/alpha
  double b_, h_, c_;
};

/// From sin and cos of alpha >= 0.
HalfAngle half_angle(double sine, double cosine)
{
  const double alpha = std::atan2(sine, cosine);
  const double x = alpha * alpha;
  HalfAngle f;
  if (x < 0.01)  // series: relative error below 1e-12 of the slowest
  {
    f.b = 1.0 + x * (1.0 / 6.0 + x * (7.0 / 360.0 + x * (31.0 / 15120.0 + x * (127.0 / 604800.0))));
    f.h = -(1.0 / 6.0 + x * (7.0 / 360.0 + x * (31.0 / 15120.0 + x * (127.0 / 604800.0 + x * 73.0 / 3421440.0))));
    f.c = 0.5 + x * (1.0 / 24.0 + x * (1.0 / 240.0 + x * (17.0 / 40320.0 + x * (31.0 / 725760.0))));
    f.b_ = 1.0 / 3.0 + x * (7.0 / 90.0 + x * (31.0 / 2520.0 + x * (127.0 / 75600.0 + x * 73.0 / 342144.0)));
    f.h_ = -(7.0 / 180.0 + x * (31.0 / 3780.0 + x * (127.0 / 100800.0 + x * 73.0 / 427680.0)));
    f.c_ = 1.0 / 12.0 + x * (1.0 / 60.0 + x * (17.0 / 6720.0 + x * 31.0 / 90720.0));
    return f;
  }
  f.b = alpha / sine;
  f.h = (1.0 - f.b) / x;
  f.c = sine / ((1.0 + cosine) * alpha);
  f.b_ = (1.0 - f.b * cosine) / (alpha * sine);
  f.h_ = -(f.b_ + 2.0 * f.h) / x;
  f.c_ = (0.5 * (1.0 + alpha * alpha * f.c * f.c) - f.c) / x;  // tan' = 1 + tan^2
  return f;
}

/// What forces and tangent share; vectors in world axes.
struct Middle
{
  Vector3d d, t, a, u;  // u = t x d
  HalfAngle f;
  double excess;            // d stress / d stretch less kappa G A, over L
  double lack;              // n = kappa G A d/L - lack t
  double torsion, bending;  // d torque / d twist, d moment / d curvature over L
  Vector3d n, m, q, bent;   // bent = B m
};

/// q2 on q1's side of the double cover.
Quaterniond beside(const Quaterniond& q1, const Quaterniond& q2)
{
  Quaterniond q = q2;
  if (q1.dot(q2) < 0.0) q.coeffs() = -q2.coeffs();
  return q;
}

Middle middle_of(const BeamSection& s, const BeamPose& pose, const BeamDamping& damping, BeamStrain& strain)
{
  Middle k;
  const double inverse = 1.0 / s.length;
  k.d = pose.lower_position - pose.upper_position;
  const Quaterniond& q1 = pose.upper_orientation;
  const Quaterniond q2 = beside(q1, pose.lower_orientation);
  const Quaterniond turn = q2 * q1.conjugate();  // (cos alpha, a sin alpha/alpha)
  Quaterniond middle;
  middle.coeffs() = (q1.coeffs() + q2.coeffs()).normalized();
  k.t = x_axis(middle);
  k.u = k.t.cross(k.d);
  k.f = half_angle(turn.vec().norm(), turn.w());
  k.a = k.f.b * turn.vec();
  const double ta = k.t.dot(k.a);
  strain.stretch = inverse * k.t.dot(k.d) - 1.0;
  strain.twist = 2.0 * ta;

  const Vector3d turning = damping.lower_turning - damping.upper_turning;
  const Vector3d middle_turning = 0.5 * (damping.lower_turning + damping.upper_turning) - (0.5 * k.f.c) * k.a.cross(turning);
  const double stretch_rate = inverse * (k.t.dot(damping.velocity) + k.u.dot(middle_turning));
  const Vector3d bend_rate = k.f.b * turning + (k.f.h * k.a.dot(turning)) * k.a;  // R_m phi' = B turning
  const double twist_rate = k.t.dot(bend_rate);
  const double damped = 1.0 + damping.time * damping.dv_du;
  k.excess = inverse * (damped * s.axial - s.shear);
  k.torsion = damped * s.torsion;
  k.bending = damped * inverse * s.bending;
  k.lack = s.shear * (strain.stretch + 1.0) - s.axial * (strain.stretch - pose.free_stretch + damping.time * stretch_rate);
  k.n = (s.shear * inverse) * k.d - k.lack * k.t;
  k.m = (inverse * s.bending) * (2.0 * (k.a - ta * k.t) + damping.time * (bend_rate - twist_rate * k.t)) +
        s.torsion * (strain.twist + damping.time * twist_rate) * k.t;
  k.q = k.n.cross(k.d);
  k.bent = k.f.b * k.m + (k.f.h * k.a.dot(k.m)) * k.a;
  return k;
}

BeamForces forces_of(const Middle& k)
{
  BeamForces out;
  const Vector3d p = k.bent - (0.5 * k.f.c) * k.q.cross(k.a);
  out.force = k.n;
  out.moment_upper = 0.5 * k.q - p;
  out.moment_lower = 0.5 * k.q + p;
  out.tension = k.t.dot(k.n);
  out.torque = k.t.dot(k.m);
  return out;
}

/// d p / d Delta at a fixed turn of the middle.
Matrix3d moment_by_relative_turn(const Middle& k)
{
  const HalfAngle& f = k.f;
  const double am = k.a.dot(k.m);
  const Vector3d bt = f.b * k.t + (f.h * k.a.dot(k.t)) * k.a;  // B t
  // B D B/L
  Matrix3d out = ((k.torsion - k.bending) * bt) * bt.transpose();
  out.noalias() += (k.bending * f.h * (1.0 + f.b)) * k.a * k.a.transpose();
  out.diagonal().array() += k.bending * f.b * f.b;
  // d(B m)/da at fixed m, less that of c/2 q x a, times da = B Delta/2
  Matrix3d by_a = (f.b_ * k.m + f.h_ * am * k.a - (0.5 * f.c_) * k.q.cross(k.a)) * k.a.transpose();
  by_a.noalias() += (f.h * k.a) * k.m.transpose();
  by_a -= skew((0.5 * f.c) * k.q);
  by_a.diagonal().array() += f.h * am;
  out += (0.5 * f.b) * by_a;
  out.noalias() += ((0.5 * f.h) * (by_a * k.a)) * k.a.transpose();
  return out;
}

void tangent_of(const BeamSection& s, const Middle& k, BeamTangent& out)
{
  const double half_c = 0.5 * k.f.c;
  // turn of the middle by those of the ends
  Matrix3d w_upper = skew(half_c * k.a);
  Matrix3d w_lower = -w_upper;
  w_upper.diagonal().array() += 0.5;
  w_lower.diagonal().array() += 0.5;
  // n, q, p by the turn of the middle
  Matrix3d n_w = skew(k.lack * k.t);
  n_w.noalias() += (k.excess * k.t) * k.u.transpose();
  Matrix3d q_w = (k.excess * k.u) * k.u.transpose();
  q_w.noalias() -= (k.lack * k.t) * k.d.transpose();
  q_w.diagonal().array() += k.lack * k.d.dot(k.t);
  const Matrix3d a_hat = skew(half_c * k.a);
  Matrix3d p_w = skew(k.q) * a_hat - skew(k.bent);
  p_w.noalias() += a_hat * q_w;
  const Matrix3d p_delta = moment_by_relative_turn(k);

  out.force_d = (k.excess * k.t) * k.t.transpose();
  out.force_d.diagonal().array() += s.shear / s.length;
  out.force_upper.noalias() = n_w * w_upper;
  out.force_lower.noalias() = n_w * w_lower;
  out.upper_d = out.force_upper.transpose();
  out.lower_d = out.force_lower.transpose();
  const Matrix3d m_upper = 0.5 * q_w - p_w, m_lower = 0.5 * q_w + p_w;
  out.upper_upper.noalias() = m_upper * w_upper;
  out.upper_upper += p_delta;
  out.lower_lower.noalias() = m_lower * w_lower;
  out.lower_lower += p_delta;
  out.lower_upper.noalias() = m_lower * w_upper;
  out.lower_upper -= p_delta;
  out.upper_lower = out.lower_upper.transpose();  // turns of different ends commute
}
}  // namespace

BeamForces geometrically_exact_forces(const BeamSection& section, const BeamPose& pose, const BeamDamping& damping,
                                      const Vector3d&, BeamStrain& strain) noexcept
{
  return forces_of(middle_of(section, pose, damping, strain));
}

BeamForces geometrically_exact_forces(const BeamSection& section, const BeamPose& pose, const BeamDamping& damping,
                                      const Vector3d&, BeamStrain& strain, BeamTangent& tangent) noexcept
{
  const Middle k = middle_of(section, pose, damping, strain);
  tangent_of(section, k, tangent);
  return forces_of(k);
}

double geometrically_exact_energy(const BeamSection& section, const BeamPose& pose) noexcept
{
  BeamStrain strain;
  const Middle k = middle_of(section, pose, BeamDamping(), strain);
  const Vector3d bent = 2.0 * (k.a - k.t.dot(k.a) * k.t);  // across the string
  const double stretch = strain.stretch - pose.free_stretch;
  const double along = k.t.dot(k.d), shear_square = k.d.squaredNorm() - along * along;
  return 0.5 * section.axial * section.length * stretch * stretch + 0.5 * section.shear / section.length * shear_square +
         0.5 * section.bending / section.length * bent.squaredNorm() + 0.5 * section.torsion * strain.twist * strain.twist;
}

}  // namespace drill_rig_sim
