// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_COMPARED_ROTATION_VECTOR_BEAM_H
#define DRILL_RIG_SIM_COMPARED_ROTATION_VECTOR_BEAM_H

#include "drill_rig_sim/string/beam_element.h"

namespace drill_rig_sim
{
/// The beam of drillstring models in absolute nodal coordinates: one total rotation vector per node, interpolated linearly. Kept
/// as a method under test: it is not objective, and it is singular at a full turn.
///
/// The attitude of a section is R = exp(psi) R_0, R_0 the ground's axes: x straight down, y north, z east. psi(s) is linear
/// between the ends' psi1, psi2, r(s) is linear, and one Gauss point integrates the strains Gamma = R^T r' - e_x, kappa =
/// axial(R^T R') of the geometrically exact beam (there: geometrically_exact_beam.h, with the energy and the sections'
/// stiffnesses). In the middle,
///   psi = (psi1 + psi2)/2,  eta = psi2 - psi1,  R kappa L = J(psi) eta,  J = 1 + (1 - cos psi)/psi^2 [psi]x + (psi - sin
///   psi)/psi^3 [psi]x^2.
/// Forces and tangent are the exact derivatives with respect to positions and spatial rotations; a node's dpsi = J(psi_i)^-1
/// dtheta_i.
///
/// What it cannot do.
/// - Interpolating psi is not invariant under a rigid rotation: a bent or twisted element that turns as a whole changes its
/// strain, by an
///   order of |eta|^2, the more the nearer psi is to a full turn. The error falls with the element's length, squared.
/// - J is singular at |psi| = 2 pi. psi is read from the quaternion with its sign, so it is continuous from 0 up to there, and
/// would then
///   jump to the opposite direction. Within full_turn_margin of it the condition number of J exceeds 30 and the element refuses:
///   its forces are NaN, a solver stops there. A vertical string, and any string's top, gets there at the first full turn.
/// Everything else as in the geometrically exact element: one element's bending, dead load, damping, reported tension and torque.
constexpr double full_turn_margin = 0.2;  ///< [rad]

/// R_0.
Eigen::Quaterniond ground_axes() noexcept;

BeamForces rotation_vector_forces(const BeamSection& section, const BeamPose& pose, const BeamDamping& damping,
                                  const Eigen::Vector3d& load, BeamStrain& strain) noexcept;

/// The same with the tangent: exact, but for the change of the strain's rate with the place at given rates, which is left out
/// (relative to the axial stiffness `damping.time` |velocity|/length, to the bending stiffness `damping.time` |angular
/// velocity|).
BeamForces rotation_vector_forces(const BeamSection& section, const BeamPose& pose, const BeamDamping& damping,
                                  const Eigen::Vector3d& load, BeamStrain& strain, BeamTangent& tangent) noexcept;

/// U [J], not a number where the element refuses.
double rotation_vector_energy(const BeamSection& section, const BeamPose& pose) noexcept;

}  // namespace drill_rig_sim

#endif
