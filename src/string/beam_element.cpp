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

/// Gradient of the stretch or of its rate.
struct StretchGradient
{
  Vector3d d, upper, lower;  // with respect to d = x2 - x1 and the ends' spatial rotations
};

/// What damps the bending (BeamDamping), with m_i = c (k11 w_i + k12 w_j) and s = c (k11 + k12):
///   M_i = P m_i - (s/l) e x v,   force (s/l) G,   G = e x (w_1 + w_2) + 2 P v/l.
struct BendingDamping
{
  double near = 0.0, far = 0.0, by_l = 0.0;  // c k11, c k12, s/l
  Vector3d m_upper = Vector3d::Zero(), m_lower = Vector3d::Zero();
  Vector3d across = Vector3d::Zero(), turned = Vector3d::Zero();  // P v/l, e x v
  Vector3d sum = Vector3d::Zero(), g = Vector3d::Zero();          // w_1 + w_2, G
};

/// What forces and tangent share.
struct Shape
{
  double l, inverse_l;
  Vector3d e, sum, sum_across;  // chord's direction, n1 + n2, its part across the chord
  double tilt, c12;             // c1 + c2
  Vector3d binormal;            // gradient of the twist with respect to the lower end's rotation
  Vector3d by_n1, by_n2;        // d stretch / d n1, d n2
  StretchGradient stretch;
  double tension, torque, chord, normals;  // chord P = -dU/dc1 = -dU/dc2, normals Q = dU/dc12
  Vector3d g1, g2;                         // dU/dn1, dU/dn2, load included
  BendingDamping bending;
};

BendingDamping bending_damping(const BeamSection& s, const Shape& f, const BeamDamping& damping)
{
  BendingDamping b;
  b.near = damping.time * s.bending_near;
  b.far = damping.time * s.bending_far;
  b.by_l = f.inverse_l * (b.near + b.far);
  b.m_upper = b.near * damping.upper_turning + b.far * damping.lower_turning;
  b.m_lower = b.far * damping.upper_turning + b.near * damping.lower_turning;
  b.across = f.inverse_l * (damping.velocity - f.e.dot(damping.velocity) * f.e);
  b.turned = f.e.cross(damping.velocity);
  b.sum = damping.upper_turning + damping.lower_turning;
  b.g = f.e.cross(b.sum) + 2.0 * b.across;
  return b;
}

void add_stretch_gradient(const BeamSection& s, const BeamPose& pose, Shape& f)
{
  f.by_n1 = kShorteningFar * pose.lower_normal - kShortening * f.e;
  f.by_n2 = kShorteningFar * pose.upper_normal - kShortening * f.e;
  f.stretch = {f.e / s.length - (kShortening * f.inverse_l) * f.sum_across, pose.upper_normal.cross(f.by_n1),
               pose.lower_normal.cross(f.by_n2)};
}

Shape shape_of(const BeamSection& s, const BeamPose& pose, const BeamDamping& damping, const Vector3d& load, BeamStrain& strain)
{
  Shape f;
  const Vector3d d = pose.lower_position - pose.upper_position;
  f.l = d.norm();
  f.inverse_l = 1.0 / f.l;
  f.e = f.inverse_l * d;
  f.sum = pose.upper_normal + pose.lower_normal;
  f.tilt = f.e.dot(f.sum);
  f.sum_across = f.sum - f.e * f.tilt;
  f.c12 = pose.upper_normal.dot(pose.lower_normal);
  f.binormal = f.sum / (1.0 + f.c12);
  add_stretch_gradient(s, pose, f);
  strain.stretch = (f.l - s.length) / s.length + kShorteningNear * (2.0 - f.tilt) + kShorteningFar * (f.c12 - f.tilt + 1.0);
  strain.twist = pose.twist;
  f.tension = s.axial * (strain.stretch - pose.free_stretch);
  f.torque = s.torsion * strain.twist;
  if (damping.time > 0.0)
  {
    const StretchGradient& g = f.stretch;
    f.tension += s.axial * damping.time *
                 (g.d.dot(damping.velocity) + g.upper.dot(damping.upper_turning) + g.lower.dot(damping.lower_turning));
    f.torque += s.torsion * damping.time * f.binormal.dot(damping.lower_turning - damping.upper_turning);
    f.bending = bending_damping(s, f, damping);
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
  const double v_along = f.e.dot(v);
  const Vector3d v_across = v - v_along * f.e;
  const Vector3d turning_1 = damping.upper_turning.cross(pose.upper_normal);  // rates of the normals
  const Vector3d turning_2 = damping.lower_turning.cross(pose.lower_normal);
  const Vector3d turning = turning_1 + turning_2;
  const double s_l = kShortening * f.inverse_l, s_ll = s_l * f.inverse_l;
  StretchGradient h;
  h.d = (f.inverse_l / s.length + s_ll * f.tilt) * v_across + (s_ll * v.dot(f.sum_across) + s_l * f.e.dot(turning)) * f.e +
        (s_ll * v_along) * f.sum_across - s_l * turning;
  h.upper = pose.upper_normal.cross(kShorteningFar * turning_2 - s_l * v_across + f.by_n1.cross(damping.upper_turning));
  h.lower = pose.lower_normal.cross(kShorteningFar * turning_1 - s_l * v_across + f.by_n2.cross(damping.lower_turning));
  return h;
}

/// Gradient of the tension times the length.
StretchGradient tension_gradient(const BeamSection& s, const Shape& f, const BeamPose& pose, const BeamDamping& damping)
{
  const double axial = s.axial * s.length;
  const double by_place = axial * (1.0 + damping.time * damping.dv_du), by_rate = axial * damping.time;
  StretchGradient out{by_place * f.stretch.d, by_place * f.stretch.upper, by_place * f.stretch.lower};
  if (damping.time <= 0.0) return out;
  const StretchGradient h = stretch_rate_gradient(s, f, pose, damping);
  out.d += by_rate * h.d;
  out.upper += by_rate * (h.upper + damping.upper_spin.cross(f.stretch.upper));
  out.lower += by_rate * (h.lower + damping.lower_spin.cross(f.stretch.lower));
  return out;
}

BeamForces forces_of(const Shape& f, const BeamPose& pose)
{
  BeamForces out;
  out.force = f.tension * f.e - (f.chord * f.inverse_l) * f.sum_across;
  out.moment_upper = pose.upper_normal.cross(f.g1) - f.torque * f.binormal;
  out.moment_lower = pose.lower_normal.cross(f.g2) + f.torque * f.binormal;
  out.tension = f.tension;
  out.torque = f.torque;
  const BendingDamping& b = f.bending;
  if (b.by_l <= 0.0) return out;
  out.force += b.by_l * b.g;
  out.moment_upper += b.m_upper - f.e.dot(b.m_upper) * f.e - b.by_l * b.turned;
  out.moment_lower += b.m_lower - f.e.dot(b.m_lower) * f.e - b.by_l * b.turned;
  return out;
}

/// The gradients of the torque times the binormal are skew(w_i) + b r_i^T, since
///   d b / d theta_i = -(skew(n_i) + b (n_i x n_j)^T)/(1 + c12).
struct TwistGradient
{
  Vector3d w_upper, w_lower, r_upper, r_lower;
};

TwistGradient twist_gradient(const BeamSection& s, const Shape& f, const BeamPose& pose, const BeamDamping& damping)
{
  const Vector3d& n1 = pose.upper_normal;
  const Vector3d& n2 = pose.lower_normal;
  const double inverse = 1.0 / (1.0 + f.c12), by_place = s.torsion * (1.0 + damping.time * damping.dv_du);
  const Vector3d turned = inverse * n1.cross(n2);
  TwistGradient out;
  out.w_upper = (-f.torque * inverse) * n1;
  out.w_lower = (-f.torque * inverse) * n2;
  out.r_upper = -by_place * f.binormal - f.torque * turned;
  out.r_lower = by_place * f.binormal + f.torque * turned;
  if (damping.time <= 0.0) return out;
  // (d b / d theta_i)^T (k t_d) (turning of the lower end less that of the upper one)
  const Vector3d turning = (s.torsion * damping.time) * (damping.lower_turning - damping.upper_turning);
  const Vector3d along = f.binormal.dot(turning) * turned;
  const Vector3d scaled = inverse * turning, b = (s.torsion * damping.time) * f.binormal;
  out.r_upper += n1.cross(scaled) - along - damping.upper_spin.cross(b);
  out.r_lower += n2.cross(scaled) + along + damping.lower_spin.cross(b);
  return out;
}

// Sums of dyads, column by column, number by number: half of what Eigen's products on 3 x 3 cost. Factors are held by value:
// `out` could be one of them for all that the compiler knows.
inline void write_dyads(const Vector3d& a, const Vector3d& b, const Vector3d& c, const Vector3d& d, Matrix3d& out)
{
  const double a0 = a[0], a1 = a[1], a2 = a[2], c0 = c[0], c1 = c[1], c2 = c[2];
  double* column = out.data();
  for (int j = 0; j < 3; ++j, column += 3)
  {
    const double p = b[j], q = d[j];
    column[0] = a0 * p + c0 * q;
    column[1] = a1 * p + c1 * q;
    column[2] = a2 * p + c2 * q;
  }
}

inline void write_dyads(const Vector3d& a, const Vector3d& b, const Vector3d& c, const Vector3d& d, const Vector3d& e,
                        const Vector3d& f, Matrix3d& out)
{
  const double a0 = a[0], a1 = a[1], a2 = a[2], c0 = c[0], c1 = c[1], c2 = c[2], e0 = e[0], e1 = e[1], e2 = e[2];
  double* column = out.data();
  for (int j = 0; j < 3; ++j, column += 3)
  {
    const double p = b[j], q = d[j], r = f[j];
    column[0] = a0 * p + c0 * q + e0 * r;
    column[1] = a1 * p + c1 * q + e1 * r;
    column[2] = a2 * p + c2 * q + e2 * r;
  }
}

inline void write_dyads(const Vector3d& a, const Vector3d& b, const Vector3d& c, const Vector3d& d, const Vector3d& e,
                        const Vector3d& f, const Vector3d& g, const Vector3d& h, Matrix3d& out)
{
  const double a0 = a[0], a1 = a[1], a2 = a[2], c0 = c[0], c1 = c[1], c2 = c[2];
  const double e0 = e[0], e1 = e[1], e2 = e[2], g0 = g[0], g1 = g[1], g2 = g[2];
  double* column = out.data();
  for (int j = 0; j < 3; ++j, column += 3)
  {
    const double p = b[j], q = d[j], r = f[j], t = h[j];
    column[0] = a0 * p + c0 * q + e0 * r + g0 * t;
    column[1] = a1 * p + c1 * q + e1 * r + g1 * t;
    column[2] = a2 * p + c2 * q + e2 * r + g2 * t;
  }
}

/// Adds skew(v) + `diagonal` 1.
inline void add_skew(const Vector3d& v, double diagonal, Matrix3d& out)
{
  out(0, 0) += diagonal;
  out(1, 0) += v.z();
  out(2, 0) -= v.y();
  out(0, 1) -= v.z();
  out(1, 1) += diagonal;
  out(2, 1) += v.x();
  out(0, 2) += v.y();
  out(1, 2) -= v.x();
  out(2, 2) += diagonal;
}

/// Each block: at constant tension and torque, then twist, then tension, the last two as dyads; in the same sums what damps the bending,
/// with d w_i = dv_du d theta_i + d theta_i x spin_i and d v = dv_du d d.
void tangent_of(const BeamSection& s, const Shape& f, const BeamPose& pose, const BeamDamping& damping, BeamTangent& t)
{
  const Vector3d &n1 = pose.upper_normal, &n2 = pose.lower_normal, &b = f.binormal, &e = f.e;
  const BendingDamping& m = f.bending;
  const StretchGradient& g = f.stretch;
  const StretchGradient tension = tension_gradient(s, f, pose, damping);
  const TwistGradient twist = twist_gradient(s, f, pose, damping);
  const double p_l = f.chord * f.inverse_l, p_ll = p_l * f.inverse_l;
  const double rate = damping.dv_du, s_l = m.by_l, s_ll = 2.0 * s_l * f.inverse_l;
  const double across = f.tension * f.inverse_l + p_ll * f.tilt + s_ll * (rate - f.inverse_l * e.dot(damping.velocity));
  const Vector3d turn_1 = p_l * n1.cross(e), turn_2 = p_l * n2.cross(e);
  const Vector3d tilted = rate * s_l * e, by_chord = s_l * f.inverse_l * damping.velocity - tilted, turned = s_ll * m.turned;

  write_dyads(e, p_ll * f.sum_across - across * e - s_ll * m.across, p_ll * f.sum_across - s_ll * m.g, e, g.d, tension.d, t.force_d);
  add_skew(-0.5 * s_ll * m.sum, across, t.force_d);
  write_dyads(e, turn_1, g.d, tension.upper, damping.upper_spin, -s_l * e, t.force_upper);
  write_dyads(e, turn_2, g.d, tension.lower, damping.lower_spin, -s_l * e, t.force_lower);
  add_skew(p_l * n1 + tilted, s_l * e.dot(damping.upper_spin), t.force_upper);
  add_skew(p_l * n2 + tilted, s_l * e.dot(damping.lower_spin), t.force_lower);
  const double along_1 = f.inverse_l * e.dot(m.m_upper), along_2 = f.inverse_l * e.dot(m.m_lower);
  write_dyads(turn_1 + turned, e, g.upper, tension.d, e, 2.0 * along_1 * e - f.inverse_l * m.m_upper, t.upper_d);
  write_dyads(turn_2 + turned, e, g.lower, tension.d, e, 2.0 * along_2 * e - f.inverse_l * m.m_lower, t.lower_d);
  add_skew(by_chord - p_l * n1, -along_1, t.upper_d);
  add_skew(by_chord - p_l * n2, -along_2, t.lower_d);

  const Vector3d row_1 = e.cross(damping.upper_spin) - rate * e, row_2 = e.cross(damping.lower_spin) - rate * e;
  const double near = m.near * rate, far = m.far * rate + f.normals * f.c12;
  write_dyads(n1, f.g1, b, -twist.r_upper, g.upper, tension.upper, e, m.near * row_1, t.upper_upper);
  write_dyads(n2, -f.normals * n1, b, -twist.r_lower, g.upper, tension.lower, e, m.far * row_2, t.upper_lower);
  write_dyads(n1, -f.normals * n2, b, twist.r_upper, g.lower, tension.upper, e, m.far * row_1, t.lower_upper);
  write_dyads(n2, f.g2, b, twist.r_lower, g.lower, tension.lower, e, m.near * row_2, t.lower_lower);
  add_skew(-twist.w_upper - m.near * damping.upper_spin, near - f.g1.dot(n1), t.upper_upper);
  add_skew(-twist.w_lower - m.far * damping.lower_spin, far, t.upper_lower);
  add_skew(twist.w_upper - m.far * damping.upper_spin, far, t.lower_upper);
  add_skew(twist.w_lower - m.near * damping.lower_spin, near - f.g2.dot(n2), t.lower_lower);
}

/// Shear coefficient of a thick tube (Cowper 1966). `m2`: square of bore over outer diameter.
double cowper(double m2, double poisson_ratio)
{
  const double ring = (1.0 + m2) * (1.0 + m2);
  return 6.0 * (1.0 + poisson_ratio) * ring / ((7.0 + 6.0 * poisson_ratio) * ring + (20.0 + 12.0 * poisson_ratio) * m2);
}

BeamSection section_with(double length, double axial, double bending, double torsional, double shear)
{
  BeamSection s;
  s.length = length;
  s.axial = axial;
  s.bending = bending;
  s.shear = shear;
  const double phi = 12.0 * s.bending / (s.shear * length * length);
  s.bending_near = (4.0 + phi) / (1.0 + phi) * s.bending / length;
  s.bending_far = (2.0 - phi) / (1.0 + phi) * s.bending / length;
  s.torsion = torsional / length;
  return s;
}

}  // namespace

BeamSection tube_section(double length, double outer_diameter, double inner_diameter, double young_modulus, double poisson_ratio)
{
  const double square_o = outer_diameter * outer_diameter;
  const double square_i = inner_diameter * inner_diameter;
  const double area = pi / 4.0 * (square_o - square_i);
  const double inertia = pi / 64.0 * (square_o * square_o - square_i * square_i);
  const double shear_modulus = young_modulus / (2.0 * (1.0 + poisson_ratio));
  return section_with(length, young_modulus * area, young_modulus * inertia, shear_modulus * 2.0 * inertia,
                      cowper(square_i / square_o, poisson_ratio) * shear_modulus * area);
}

BeamSection stiff_section(double length, double axial, double bending, double torsional, double bore)
{
  const double poisson_ratio = bending / torsional - 1.0;
  return section_with(length, axial, bending, torsional, cowper(bore * bore, poisson_ratio) * axial / (2.0 * (1.0 + poisson_ratio)));
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

double beam_energy(const BeamSection& section, const BeamPose& pose) noexcept
{
  const Vector3d d = pose.lower_position - pose.upper_position;
  const double length = d.norm();
  const Vector3d upper = pose.upper_normal - d / length, lower = pose.lower_normal - d / length;  // a1, a2
  const double squares = upper.squaredNorm() + lower.squaredNorm(), mixed = upper.dot(lower);
  const double stretch =
      (length - section.length) / section.length + 0.5 * kShorteningNear * squares + kShorteningFar * mixed - pose.free_stretch;
  return 0.5 * section.axial * section.length * stretch * stretch + 0.5 * section.bending_near * squares + section.bending_far * mixed +
         0.5 * section.torsion * pose.twist * pose.twist;
}

}  // namespace drill_rig_sim
