#include "drill_rig_sim/string/beam_element.h"

#include <cmath>

#include "drill_rig_sim/math/rotation.h"
#include "drill_rig_sim/math/units.h"

namespace drill_rig_sim
{
using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace
{
// mean of w'^2/2 of the cubic with end tilts a1, a2: (near/2)(|a1|^2 + |a2|^2) + far a1.a2
constexpr double kShorteningNear = 4.0 / 30.0;
constexpr double kShorteningFar = -1.0 / 30.0;
constexpr double kShortening = kShorteningNear + kShorteningFar;

/// What forces and tangent share.
struct Shape
{
  double l, inverse_l;
  Vector3d e, sum;  // chord's direction, n1 + n2
  double c12;
  Vector3d binormal;  // gradient of the twist with respect to the lower end's rotation
  double tension, torque, chord, normals;  // chord P = -dU/dc1 = -dU/dc2, normals Q = dU/dc12
  Vector3d g1, g2;  // dU/dn1, dU/dn2, load included
};

/// Gradient of the stretch.
struct StretchGradient
{
  Vector3d d, upper, lower;  // with respect to d = x2 - x1 and the ends' spatial rotations
};

StretchGradient stretch_gradient(const BeamSection& s, const Shape& f, const BeamPose& pose)
{
  const Vector3d across = f.sum - f.e * f.e.dot(f.sum);
  return {f.e / s.length - (kShortening * f.inverse_l) * across,
          pose.upper_normal.cross(kShorteningFar * pose.lower_normal - kShortening * f.e),
          pose.lower_normal.cross(kShorteningFar * pose.upper_normal - kShortening * f.e)};
}

Shape shape_of(const BeamSection& s, const BeamPose& pose, const BeamDamping& damping, const Vector3d& load, BeamStrain& strain)
{
  Shape f;
  const Vector3d d = pose.lower_position - pose.upper_position;
  f.l = d.norm();
  f.inverse_l = 1.0 / f.l;
  f.e = f.inverse_l * d;
  f.sum = pose.upper_normal + pose.lower_normal;
  f.c12 = pose.upper_normal.dot(pose.lower_normal);
  f.binormal = f.sum / (1.0 + f.c12);
  const double tilt = f.e.dot(f.sum);  // c1 + c2
  strain.stretch = (f.l - s.length) / s.length + kShorteningNear * (2.0 - tilt) + kShorteningFar * (f.c12 - tilt + 1.0);
  strain.twist = pose.twist;
  f.tension = s.axial * strain.stretch;
  f.torque = s.torsion * strain.twist;
  if (damping.time > 0.0)
  {
    const StretchGradient g = stretch_gradient(s, f, pose);
    f.tension += s.axial * damping.time *
                 (g.d.dot(damping.velocity) + g.upper.dot(damping.upper_turning) + g.lower.dot(damping.lower_turning));
    f.torque += s.torsion * damping.time * f.binormal.dot(damping.lower_turning - damping.upper_turning);
  }
  f.chord = s.bending_near + s.bending_far + f.tension * s.length * kShortening;
  f.normals = s.bending_far + f.tension * s.length * kShorteningFar;
  const Vector3d end_load = (s.length / 12.0) * load;
  f.g1 = -f.chord * f.e + f.normals * pose.lower_normal - end_load;
  f.g2 = -f.chord * f.e + f.normals * pose.upper_normal + end_load;
  return f;
}

/// Gradient of the stretch's rate with respect to places, the rates held.
StretchGradient stretch_rate_gradient(const BeamSection& s, const Shape& f, const BeamPose& pose, const BeamDamping& damping)
{
  const Vector3d& v = damping.velocity;
  const Vector3d v_across = v - f.e * f.e.dot(v);
  const Vector3d sum_across = f.sum - f.e * f.e.dot(f.sum);
  const Vector3d turning_1 = damping.upper_turning.cross(pose.upper_normal);  // rates of the normals
  const Vector3d turning_2 = damping.lower_turning.cross(pose.lower_normal);
  const Vector3d turning = turning_1 + turning_2;
  const double s_l = kShortening * f.inverse_l;
  StretchGradient h;
  h.d = (f.inverse_l / s.length + s_l * f.inverse_l * f.e.dot(f.sum)) * v_across +
        (s_l * f.inverse_l) * (f.e * v.dot(sum_across) + f.e.dot(v) * sum_across) - s_l * (turning - f.e * f.e.dot(turning));
  const Vector3d by_upper = kShorteningFar * pose.lower_normal - kShortening * f.e;  // d stretch / d n1
  const Vector3d by_lower = kShorteningFar * pose.upper_normal - kShortening * f.e;
  h.upper = pose.upper_normal.cross(kShorteningFar * turning_2 - s_l * v_across + by_upper.cross(damping.upper_turning));
  h.lower = pose.lower_normal.cross(kShorteningFar * turning_1 - s_l * v_across + by_lower.cross(damping.lower_turning));
  return h;
}

BeamForces forces_of(const Shape& f, const BeamPose& pose)
{
  BeamForces out;
  const Vector3d across = f.sum - f.e * f.e.dot(f.sum);
  out.force = f.tension * f.e - (f.chord * f.inverse_l) * across;
  out.moment_upper = pose.upper_normal.cross(f.g1) - f.torque * f.binormal;
  out.moment_lower = pose.lower_normal.cross(f.g2) + f.torque * f.binormal;
  out.tension = f.tension;
  out.torque = f.torque;
  return out;
}

/// d binormal / d theta_i for the normal n_i and the other end's n_j.
Matrix3d binormal_derivative(const Shape& f, const Vector3d& n_i, const Vector3d& n_j)
{
  const double inverse = 1.0 / (1.0 + f.c12);
  return (-inverse) * (skew(n_i) + f.binormal * n_i.cross(n_j).transpose());
}

void tangent_of(const BeamSection& s, const Shape& f, const BeamPose& pose, const BeamDamping& damping, BeamTangent& t)
{
  const Vector3d& n1 = pose.upper_normal;
  const Vector3d& n2 = pose.lower_normal;
  const Matrix3d across = Matrix3d::Identity() - f.e * f.e.transpose();
  const Vector3d sum_across = across * f.sum;
  const double p_l = f.chord * f.inverse_l;

  // at constant tension
  t.force_d = (f.tension * f.inverse_l + p_l * f.inverse_l * f.e.dot(f.sum)) * across +
              (p_l * f.inverse_l) * (sum_across * f.e.transpose() + f.e * sum_across.transpose());
  t.force_upper = p_l * (skew(n1) - f.e * f.e.cross(n1).transpose());
  t.force_lower = p_l * (skew(n2) - f.e * f.e.cross(n2).transpose());
  t.upper_upper = n1 * f.g1.transpose();
  t.upper_upper.diagonal().array() -= f.g1.dot(n1);
  t.lower_lower = n2 * f.g2.transpose();
  t.lower_lower.diagonal().array() -= f.g2.dot(n2);
  t.upper_lower = (-f.normals) * (n2 * n1.transpose());
  t.upper_lower.diagonal().array() += f.normals * f.c12;
  t.lower_upper = (-f.normals) * (n1 * n2.transpose());
  t.lower_upper.diagonal().array() += f.normals * f.c12;

  // twist: change of the binormal, change of the torque
  const double damped = 1.0 + damping.time * damping.rate_by_move;
  const Matrix3d binormal_upper = binormal_derivative(f, n1, n2), binormal_lower = binormal_derivative(f, n2, n1);
  Vector3d torque_upper = (-s.torsion * damped) * f.binormal, torque_lower = (s.torsion * damped) * f.binormal;
  if (damping.time > 0.0)
  {
    const Vector3d turning = (s.torsion * damping.time) * (damping.lower_turning - damping.upper_turning);
    torque_upper += binormal_upper.transpose() * turning;
    torque_lower += binormal_lower.transpose() * turning;
  }
  const Matrix3d by_upper = f.torque * binormal_upper + f.binormal * torque_upper.transpose();
  const Matrix3d by_lower = f.torque * binormal_lower + f.binormal * torque_lower.transpose();
  t.upper_upper -= by_upper;
  t.upper_lower -= by_lower;
  t.lower_upper += by_upper;
  t.lower_lower += by_lower;

  // change of tension
  t.upper_d = t.force_upper.transpose();
  t.lower_d = t.force_lower.transpose();
  const StretchGradient g = stretch_gradient(s, f, pose);
  const double axial = s.axial * s.length;
  StretchGradient tension{(axial * damped) * g.d, (axial * damped) * g.upper, (axial * damped) * g.lower};  // its gradient times L
  if (damping.time > 0.0)
  {
    const StretchGradient h = stretch_rate_gradient(s, f, pose, damping);
    tension.d += (axial * damping.time) * h.d;
    tension.upper += (axial * damping.time) * h.upper;
    tension.lower += (axial * damping.time) * h.lower;
  }
  t.force_d += g.d * tension.d.transpose();
  t.force_upper += g.d * tension.upper.transpose();
  t.force_lower += g.d * tension.lower.transpose();
  t.upper_d += g.upper * tension.d.transpose();
  t.upper_upper += g.upper * tension.upper.transpose();
  t.upper_lower += g.upper * tension.lower.transpose();
  t.lower_d += g.lower * tension.d.transpose();
  t.lower_upper += g.lower * tension.upper.transpose();
  t.lower_lower += g.lower * tension.lower.transpose();
}

}  // namespace

BeamSection tube_section(double length, double outer_diameter, double inner_diameter, double young_modulus, double poisson_ratio)
{
  const double square_o = outer_diameter * outer_diameter;
  const double square_i = inner_diameter * inner_diameter;
  const double area = pi / 4.0 * (square_o - square_i);
  const double inertia = pi / 64.0 * (square_o * square_o - square_i * square_i);
  const double shear_modulus = young_modulus / (2.0 * (1.0 + poisson_ratio));
  // Cowper (1966), thick tube
  const double m2 = square_i / square_o;
  const double ring = (1.0 + m2) * (1.0 + m2);
  const double kappa = 6.0 * (1.0 + poisson_ratio) * ring / ((7.0 + 6.0 * poisson_ratio) * ring + (20.0 + 12.0 * poisson_ratio) * m2);
  const double phi = 12.0 * young_modulus * inertia / (kappa * shear_modulus * area * length * length);
  BeamSection s;
  s.length = length;
  s.axial = young_modulus * area;
  s.bending_near = (4.0 + phi) / (1.0 + phi) * young_modulus * inertia / length;
  s.bending_far = (2.0 - phi) / (1.0 + phi) * young_modulus * inertia / length;
  s.torsion = shear_modulus * 2.0 * inertia / length;
  return s;
}

BeamForces beam_forces(const BeamSection& section, const BeamPose& pose, const BeamDamping& damping, const Vector3d& load,
                       BeamStrain& strain) noexcept
{
  return forces_of(shape_of(section, pose, damping, load, strain), pose);
}

BeamForces beam_forces(const BeamSection& section, const BeamPose& pose, const BeamDamping& damping, const Vector3d& load,
                       BeamStrain& strain, BeamTangent& tangent) noexcept
{
  const Shape f = shape_of(section, pose, damping, load, strain);
  tangent_of(section, f, pose, damping, tangent);
  return forces_of(f, pose);
}

}  // namespace drill_rig_sim
