// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/compared/rotation_vector_beam.h"

#include <cmath>
#include <limits>

#include "drill_rig_sim/math/rotation.h"
#include "drill_rig_sim/math/units.h"
#include "drill_rig_sim/string/beam_table.h"

namespace drill_rig_sim
{
using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

namespace
{
/// J(psi) eta = eta + c1 psi x eta + c2 psi x (psi x eta). d: the derivative by |psi|, divided by |psi|.
struct Coefficients
{
  double c1, c2, c1d, c2d, c1dd, c2dd;
};

/// Sum of (-x)^k/(2 k + first)! and its first two derivatives by x.
void exponential_series(double x, int first, double& sum, double& slope, double& bend)
{
  constexpr int terms = 11;  // x <= 1: the rest is below 1e-22
  double factors[terms];
  factors[0] = first == 2 ? 0.5 : 1.0 / 6.0;
  for (int k = 1; k < terms; ++k) factors[k] = -factors[k - 1] / ((2 * k + first - 1) * (2 * k + first));
  sum = slope = bend = 0.0;
  for (int k = terms - 1; k >= 0; --k)
  {
    bend = bend * x + 2.0 * slope;
    slope = slope * x + sum;
    sum = sum * x + factors[k];
  }
}

Coefficients coefficients(double x)  // x = |psi|^2
{
  Coefficients c;
  if (x < 1.0)
  {
    exponential_series(x, 2, c.c1, c.c1d, c.c1dd);
    exponential_series(x, 3, c.c2, c.c2d, c.c2dd);
    c.c1d *= 2.0;
    c.c2d *= 2.0;
    c.c1dd *= 4.0;
    c.c2dd *= 4.0;
    return c;
  }
  const double angle = std::sqrt(x), cosine = std::cos(angle), sinc = std::sin(angle) / angle;
  const double sinc_ = (cosine - sinc) / x;
  c.c1 = (1.0 - cosine) / x;
  c.c2 = (1.0 - sinc) / x;
  c.c1d = (sinc - 2.0 * c.c1) / x;
  c.c2d = (-sinc_ - 2.0 * c.c2) / x;
  c.c1dd = (sinc_ - 4.0 * c.c1d) / x;
  c.c2dd = ((sinc + 3.0 * sinc_) / x - 4.0 * c.c2d) / x;
  return c;
}

Matrix3d jacobian(const Vector3d& psi, const Coefficients& c)
{
  Matrix3d j = skew(c.c1 * psi);
  j.noalias() += (c.c2 * psi) * psi.transpose();
  j.diagonal().array() += 1.0 - c.c2 * psi.squaredNorm();
  return j;
}

Matrix3d inverse_jacobian(const Vector3d& psi, const Coefficients& c)
{
  const double x = psi.squaredNorm();
  // (1 - |psi|/2 cot |psi|/2)/|psi|^2
  const double c3 =
      x < 0.01 ? 1.0 / 12.0 + x * (1.0 / 720.0 + x * (1.0 / 30240.0 + x / 1209600.0)) : (1.0 - 0.5 * (1.0 - x * c.c2) / c.c1) / x;
  Matrix3d t = skew(-0.5 * psi);
  t.noalias() += (c3 * psi) * psi.transpose();
  t.diagonal().array() += 1.0 - c3 * x;
  return t;
}

/// DJ(psi)[eta]: the matrix whose product with v is the derivative of J(psi) v along eta.
Matrix3d jacobian_derivative(const Vector3d& psi, const Vector3d& eta, const Coefficients& c)
{
  const double along = psi.dot(eta);
  Matrix3d out = skew(c.c1d * along * psi + c.c1 * eta);
  out.noalias() += (c.c2d * along * psi + c.c2 * eta) * psi.transpose();
  out.noalias() += (c.c2 * psi) * eta.transpose();
  out.diagonal().array() -= c.c2d * along * psi.squaredNorm() + 2.0 * c.c2 * along;
  return out;
}

/// The matrix whose product with x is DJ(psi)[x]^T v.
Matrix3d transposed_derivative(const Vector3d& psi, const Vector3d& v, const Coefficients& c)
{
  const Vector3d pv = psi.cross(v);
  Matrix3d out = (c.c2d * psi.cross(pv) - c.c1d * pv) * psi.transpose();
  out += skew(c.c1 * v - c.c2 * pv);
  out.noalias() -= (c.c2 * skew(psi)) * skew(v);
  return out;
}

/// The matrix whose product with x is the derivative of DJ(psi)[eta]^T v along x.
Matrix3d second_derivative(const Vector3d& psi, const Vector3d& eta, const Vector3d& v, const Coefficients& c)
{
  const double along = psi.dot(eta);
  const Vector3d pv = psi.cross(v), ppv = psi.cross(pv), ev = eta.cross(v);
  const Vector3d mixed = eta.cross(pv) + psi.cross(ev);
  Matrix3d out = (along * (c.c2dd * ppv - c.c1dd * pv) - c.c1d * ev + c.c2d * mixed) * psi.transpose();
  out.noalias() += (c.c2d * ppv - c.c1d * pv) * eta.transpose();
  const Matrix3d v_hat = skew(v);
  out += (c.c1d * along) * v_hat;
  out -= (c.c2d * along) * (skew(pv) + skew(psi) * v_hat);
  out -= c.c2 * (skew(eta) * v_hat + skew(ev));
  return out;
}

/// An end's rotation vector; empty within full_turn_margin of the full turn.
struct End
{
  Vector3d psi;
  Coefficients c;
  Matrix3d inverse;  // J^-1
  bool defined;
};

End end_of(const Quaterniond& orientation)
{
  const Quaterniond q = orientation * ground_axes().conjugate();
  const double sine = q.vec().norm();
  const double angle = 2.0 * std::atan2(sine, q.w());
  End e;
  e.defined = angle < 2.0 * pi - full_turn_margin;
  e.psi = (sine > 1e-12 ? angle / sine : 2.0) * q.vec();
  e.c = coefficients(e.psi.squaredNorm());
  e.inverse = inverse_jacobian(e.psi, e.c);
  return e;
}

/// What forces and tangent share; vectors in world axes.
struct Middle
{
  End upper, lower;
  Vector3d d, t, psi, eta;
  Coefficients c;
  Matrix3d j, dj;                         // J, DJ[eta]
  double excess, lack, torsion, bending;  // as in the geometrically exact element
  Vector3d n, m, q;
};

Middle middle_of(const BeamSection& s, const BeamPose& pose, const BeamDamping& damping, BeamStrain& strain)
{
  Middle k;
  const double inverse = 1.0 / s.length;
  k.upper = end_of(pose.upper_orientation);
  k.lower = end_of(pose.lower_orientation);
  k.d = pose.lower_position - pose.upper_position;
  k.psi = 0.5 * (k.upper.psi + k.lower.psi);
  k.eta = k.lower.psi - k.upper.psi;
  k.c = coefficients(k.psi.squaredNorm());
  k.j = jacobian(k.psi, k.c);
  k.dj = jacobian_derivative(k.psi, k.eta, k.c);
  k.t = x_axis(rotation_from_vector(k.psi) * ground_axes());
  const Vector3d turn = k.j * k.eta;  // L R kappa
  strain.stretch = inverse * k.t.dot(k.d) - 1.0;
  strain.twist = k.t.dot(turn);

  const Vector3d psi_upper = k.upper.inverse * damping.upper_turning, psi_lower = k.lower.inverse * damping.lower_turning;
  const Vector3d psi_rate = 0.5 * (psi_upper + psi_lower);
  const double stretch_rate = inverse * (k.t.dot(damping.velocity) + k.t.cross(k.d).dot(k.j * psi_rate));
  const Vector3d turn_rate =
      k.j * (psi_lower - psi_upper) + k.dj * psi_rate;  // L w', w = J psi' of the sections: in their axes the rate of turn
  const double twist_rate = k.t.dot(turn_rate);
  const double damped = 1.0 + damping.time * damping.dv_du;
  k.excess = inverse * (damped * s.axial - s.shear);
  k.torsion = damped * s.torsion;
  k.bending = damped * inverse * s.bending;
  k.lack = s.shear * (strain.stretch + 1.0) - s.axial * (strain.stretch - pose.free_stretch + damping.time * stretch_rate);
  k.n = (s.shear * inverse) * k.d - k.lack * k.t;
  k.m = (inverse * s.bending) * (turn - strain.twist * k.t + damping.time * (turn_rate - twist_rate * k.t)) +
        s.torsion * (strain.twist + damping.time * twist_rate) * k.t;
  k.q = k.n.cross(k.d);
  return k;
}

BeamForces forces_of(const Middle& k)
{
  BeamForces out;
  if (!k.upper.defined || !k.lower.defined)
  {
    const Vector3d nothing = Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
    out.force = out.moment_upper = out.moment_lower = nothing;
    out.tension = out.torque = nothing.x();
    return out;
  }
  const Vector3d by_psi = 0.5 * (k.j.transpose() * k.q + k.dj.transpose() * k.m), by_eta = k.j.transpose() * k.m;
  out.force = k.n;
  out.moment_upper = k.upper.inverse.transpose() * (by_psi - by_eta);
  out.moment_lower = k.lower.inverse.transpose() * (by_psi + by_eta);
  out.tension = k.t.dot(k.n);
  out.torque = k.t.dot(k.m);
  return out;
}

void tangent_of(const BeamSection& s, const Middle& k, const BeamForces& forces, BeamTangent& out)
{
  const Vector3d u = k.t.cross(k.d);
  Matrix3d n_w = skew(k.lack * k.t);
  n_w.noalias() += (k.excess * k.t) * u.transpose();
  Matrix3d q_w = (k.excess * u) * u.transpose();
  q_w.noalias() -= (k.lack * k.t) * k.d.transpose();
  q_w.diagonal().array() += k.lack * k.d.dot(k.t);
  Matrix3d stiffness = ((k.torsion - k.bending) * k.t) * k.t.transpose();
  stiffness.diagonal().array() += k.bending;

  // Hessian of the energy in d, psi, eta
  out.force_d = (k.excess * k.t) * k.t.transpose();
  out.force_d.diagonal().array() += s.shear / s.length;
  const Matrix3d d_psi = n_w * k.j;
  const Matrix3d m_psi = stiffness * k.dj - skew(k.m) * k.j;
  const Matrix3d eta_eta = k.j.transpose() * stiffness * k.j;
  const Matrix3d eta_psi = k.j.transpose() * m_psi + transposed_derivative(k.psi, k.m, k.c);
  const Matrix3d psi_psi = k.j.transpose() * q_w * k.j + transposed_derivative(k.psi, k.q, k.c) + k.dj.transpose() * m_psi +
                           second_derivative(k.psi, k.eta, k.m, k.c);
  // in the ends' rotation vectors
  const Matrix3d even = 0.25 * psi_psi + eta_eta, odd = 0.5 * (eta_psi + eta_psi.transpose());
  const Matrix3d lower_upper = 0.25 * psi_psi + 0.5 * (eta_psi - eta_psi.transpose()) - eta_eta;
  // in the ends' rotations
  const Matrix3d& upper = k.upper.inverse;
  const Matrix3d& lower = k.lower.inverse;
  out.force_upper = 0.5 * d_psi * upper;
  out.force_lower = 0.5 * d_psi * lower;
  out.upper_d = out.force_upper.transpose();
  out.lower_d = out.force_lower.transpose();
  out.upper_upper = upper.transpose() * (even - odd - transposed_derivative(k.upper.psi, forces.moment_upper, k.upper.c)) * upper;
  out.lower_lower = lower.transpose() * (even + odd - transposed_derivative(k.lower.psi, forces.moment_lower, k.lower.c)) * lower;
  out.lower_upper = lower.transpose() * lower_upper * upper;
  out.upper_lower = out.lower_upper.transpose();
}
}  // namespace

Quaterniond ground_axes() noexcept
{
  return Quaterniond(std::sqrt(0.5), 0.0, std::sqrt(0.5), 0.0);
}

BeamForces rotation_vector_forces(const BeamSection& section, const BeamPose& pose, const BeamDamping& damping, const Vector3d&,
                                  BeamStrain& strain) noexcept
{
  return forces_of(middle_of(section, pose, damping, strain));
}

BeamForces rotation_vector_forces(const BeamSection& section, const BeamPose& pose, const BeamDamping& damping, const Vector3d&,
                                  BeamStrain& strain, BeamTangent& tangent) noexcept
{
  const Middle k = middle_of(section, pose, damping, strain);
  BeamForces forces = forces_of(k);
  tangent_of(section, k, forces, tangent);
  return forces;
}

double rotation_vector_energy(const BeamSection& section, const BeamPose& pose) noexcept
{
  BeamStrain strain;
  const Middle k = middle_of(section, pose, BeamDamping(), strain);
  if (!k.upper.defined || !k.lower.defined) return std::numeric_limits<double>::quiet_NaN();
  const Vector3d turn = k.j * k.eta;
  const Vector3d bent = turn - k.t.dot(turn) * k.t;
  const double stretch = strain.stretch - pose.free_stretch;
  const double along = k.t.dot(k.d), shear_square = k.d.squaredNorm() - along * along;
  return 0.5 * section.axial * section.length * stretch * stretch + 0.5 * section.shear / section.length * shear_square +
         0.5 * section.bending / section.length * bent.squaredNorm() + 0.5 * section.torsion * strain.twist * strain.twist;
}

const BeamKind rotation_vector_beam = {ElementKind::rotation_vector,
                                       "rotation_vector",
                                       "rigid-section strains, total rotation vectors interpolated; fails at a full turn",
                                       rotation_vector_forces,
                                       rotation_vector_forces,
                                       rotation_vector_energy,
                                       false};

}  // namespace drill_rig_sim
