// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/string/beam_element.h"

#include "drill_rig_sim/math/one_lane.h"
#include "drill_rig_sim/math/units.h"

namespace drill_rig_sim
{
using Eigen::Vector3d;

namespace one_lane
{
namespace
{
#include "drill_rig_sim/string/beam_text.h"

/// Its rates are those that damp; without damping none, so that none is looked at.
Beam beam_of(const BeamSection& s, const BeamPose& pose, const BeamDamping& damping, const Vector3d& load)
{
  Beam b{};
  b.length = s.length;
  b.axial = s.axial;
  b.near = s.bending_near;
  b.far = s.bending_far;
  b.torsion = s.torsion;
  b.free_stretch = pose.free_stretch;
  b.load = from(load);
  b.d = from(pose.lower_position) - from(pose.upper_position);
  b.n1 = from(pose.upper_normal);
  b.n2 = from(pose.lower_normal);
  b.twist = pose.twist;
  if (damping.time <= 0.0) return b;
  b.velocity = from(damping.velocity);
  b.turning_1 = from(damping.upper_turning);
  b.turning_2 = from(damping.lower_turning);
  b.spin_1 = from(damping.upper_spin);
  b.spin_2 = from(damping.lower_spin);
  return b;
}

BeamForces take_forces(const Beam& b, const Shape& f, BeamStrain& strain)
{
  const Forces forces = forces_of(b, f);
  strain.stretch = f.strain;
  strain.twist = b.twist;
  return {to_eigen(forces.force), to_eigen(forces.moment_1), to_eigen(forces.moment_2), f.tension, f.torque};
}

void take_tangent(const Tangent& t, BeamTangent& to)
{
  to.force_d = to_eigen(t.force_d);
  to.force_upper = to_eigen(t.force_1);
  to.force_lower = to_eigen(t.force_2);
  to.upper_d = to_eigen(t.upper_d);
  to.upper_upper = to_eigen(t.upper_1);
  to.upper_lower = to_eigen(t.upper_2);
  to.lower_d = to_eigen(t.lower_d);
  to.lower_upper = to_eigen(t.lower_1);
  to.lower_lower = to_eigen(t.lower_2);
}
}  // namespace
}  // namespace one_lane

namespace
{
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
  return section_with(length, axial, bending, torsional,
                      cowper(bore * bore, poisson_ratio) * axial / (2.0 * (1.0 + poisson_ratio)));
}

BeamForces beam_forces(const BeamSection& section, const BeamPose& pose, const BeamDamping& damping, const Vector3d& load,
                       BeamStrain& strain) noexcept
{
  const one_lane::Beam beam = one_lane::beam_of(section, pose, damping, load);
  return one_lane::take_forces(beam, one_lane::shape_of(beam, damping.time), strain);
}

BeamForces beam_forces(const BeamSection& section, const BeamPose& pose, const BeamDamping& damping, const Vector3d& load,
                       BeamStrain& strain, BeamTangent& tangent) noexcept
{
  const one_lane::Beam beam = one_lane::beam_of(section, pose, damping, load);
  const one_lane::Shape shape = one_lane::shape_of(beam, damping.time);
  one_lane::Tangent t;
  one_lane::find_tangent(beam, shape, damping.time, damping.dv_du, t);
  one_lane::take_tangent(t, tangent);
  return one_lane::take_forces(beam, shape, strain);
}

double beam_energy(const BeamSection& section, const BeamPose& pose) noexcept
{
  return one_lane::energy_of(one_lane::beam_of(section, pose, {}, Vector3d::Zero()));
}

}  // namespace drill_rig_sim
