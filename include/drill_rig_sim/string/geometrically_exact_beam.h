// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_STRING_GEOMETRICALLY_EXACT_BEAM_H
#define DRILL_RIG_SIM_STRING_GEOMETRICALLY_EXACT_BEAM_H

#include "drill_rig_sim/string/beam_element.h"

namespace drill_rig_sim
{
/// A geometrically exact two-node beam (Reissner, Simo): the strains of the rigid-section beam without any smallness of rotation,
///   Gamma = R^T r' - e_x (stretch, two shears),  kappa = axial(R^T R') (twist, two curvatures),
/// integrated by one Gauss point, which keeps the linear interpolation from locking in shear.
///
/// Interpolation. r is linear. The rotation between the ends is interpolated by its own rotation vector phi = log(R1^T R2), as
/// Crisfield and Jelenic (1999) do: R(s) = R1 exp(s phi). So kappa = phi/L all along, the point in the middle has R_m = R1
/// exp(phi/2), and a rigid motion of both ends, of any number of turns, never enters. Energy.  U = L/2 Gamma.C Gamma + phi.D
/// phi/(2 L),  C = diag(EA, kappa G A, kappa G A),  D = diag(GJ, EI, EI) With a = R_m phi/2, alpha = |a|, Delta = dtheta2 -
/// dtheta1 (spatial rotations of the ends), t = R_m e_x, d = x2 - x1:
///   R_m dphi = B Delta,  B = b 1 + (1 - b) a a^T/alpha^2,  b = alpha/sin alpha
///   turn of the middle  w = (dtheta1 + dtheta2)/2 - c/2 a x Delta,  c = tan(alpha/2)/alpha
///   n = R_m C Gamma,  m = R_m D phi/L,  q = n x d,  p = B m - c/2 q x a
///   force on the lower end n, moments q/2 - p (upper) and q/2 + p (lower).
/// Forces and tangent are derivatives of U.
///
/// Valid for any rotation; the ends less than half a turn apart. Second order in the element's length, also in linear bending:
/// one element deflects a quarter less than the cubic under a tip load. A dead load goes to the ends in halves, without end
/// moments. The correction that would make it exact there (1/(kappa G A) + L^2/(12 EI) in place of 1/(kappa G A), MacNeal 1978)
/// is left out: with it any tension above 12 EI/L^2 buckles the element. Structural damping (BeamDamping) acts on the stretch
/// Gamma_x and on twist and bending, d/dt phi = R_m^T B (w_2 - w_1), w_i the ends' angular velocities; not on the shears, which
/// one Gauss point makes of bending. Reported tension and torque: EA Gamma_x and GJ phi_x/L, damping included.
BeamForces geometrically_exact_forces(const BeamSection& section, const BeamPose& pose, const BeamDamping& damping,
                                      const Eigen::Vector3d& load, BeamStrain& strain) noexcept;

/// The same with the tangent: exact, but for the change of the strain's rate with the place at given rates, which is left out
/// (relative to the axial stiffness `damping.time` |velocity|/length, to the bending stiffness `damping.time` |angular
/// velocity|).
BeamForces geometrically_exact_forces(const BeamSection& section, const BeamPose& pose, const BeamDamping& damping,
                                      const Eigen::Vector3d& load, BeamStrain& strain, BeamTangent& tangent) noexcept;

/// U [J].
double geometrically_exact_energy(const BeamSection& section, const BeamPose& pose) noexcept;

}  // namespace drill_rig_sim

#endif
