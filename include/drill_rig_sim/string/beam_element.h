// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_STRING_BEAM_ELEMENT_H
#define DRILL_RIG_SIM_STRING_BEAM_ELEMENT_H

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace drill_rig_sim
{
/// A corotational two-node beam of circular section: cubic bending, axial-force (P-delta) terms, shear, torsion, stretch.
///
/// Kinematics. Node 1 is the upper end, node 2 the lower one; d = x2 - x1, l = |d|, e = d / l. The section normals n1, n2 (unit,
/// along the string towards the bit) leave the chord by a_i = n_i - e, which for small tilts is the end rotation relative to the
/// chord. A circular section bends alike in every direction, so only scalar products of e, n1, n2 enter:
///   c1 = n1.e, c2 = n2.e, c12 = n1.n2;   |a_i|^2 = 2 (1 - c_i),   a1.a2 = c12 - c1 - c2 + 1.
///   stretch   eps = (l - L)/L + g,  g = (2 |a1|^2 - a1.a2 + 2 |a2|^2)/30: mean of w'^2/2 over the cubic (Crisfield's shallow
///   arch) twist     tau = swing-twist angle between the end sections (math/rotation.h): spin of both ends together never enters
/// Energy.  U = EA L eps^2/2 + k11 (|a1|^2 + |a2|^2)/2 + k12 a1.a2 + GJ tau^2/(2 L)
///   k11 = (4 + Phi)/(1 + Phi) EI/L,  k12 = (2 - Phi)/(1 + Phi) EI/L,  Phi = 12 EI/(kappa G A L^2)   (Timoshenko)
/// Forces and tangent are its exact derivatives with respect to positions and spatial rotations.
///
/// Valid for small strain and end tilts below some 20 deg (the energy's error is |a|^2/12, relative); any rigid motion and any
/// number of turns. Not for sections whose bending stiffness depends on direction.
struct BeamSection
{
  double length = 0.0;        ///< unstretched L [m]
  double axial = 0.0;         ///< E A [N]
  double bending_near = 0.0;  ///< k11 [N m]
  double bending_far = 0.0;   ///< k12 [N m]
  double torsion = 0.0;       ///< G J / L [N m/rad]
  double bending = 0.0;       ///< E I [N m2]
  double shear = 0.0;         ///< kappa G A [N]
};

/// Section of a straight tube [m, m, m, Pa, -]; shear coefficient of a thick tube after Cowper (1966).
BeamSection tube_section(double length, double outer_diameter, double inner_diameter, double young_modulus, double poisson_ratio);

/// Section given by its stiffness [m, N, N m2, N m2]; its bore is `bore` of its outer diameter [-]. Circular and of one material,
/// hence J = 2 I, and EI/GJ = 1 + nu: that gives the shear stiffness, with Cowper's coefficient as for the tube.
BeamSection stiff_section(double length, double axial, double bending, double torsional, double bore);

/// Stress-like results.
struct BeamStrain
{
  double stretch = 0.0;  ///< eps [-]
  double twist = 0.0;    ///< tau, lower end relative to upper, + about e [rad]
};

/// Force on the lower end (minus it on the upper) and the moments on both ends that hold the element in its shape: the gradient
/// of U.
struct BeamForces
{
  Eigen::Vector3d force;         ///< dU/dx2 [N]
  Eigen::Vector3d moment_upper;  ///< [N m], spatial
  Eigen::Vector3d moment_lower;  ///< [N m], spatial
  double tension = 0.0;          ///< N = EA eps [N]
  double torque = 0.0;           ///< GJ/L tau [N m]
};

/// Derivatives of BeamForces: d = x2 - x1, rotations spatial. Rows: force, moment_upper, moment_lower.
struct BeamTangent
{
  Eigen::Matrix3d force_d, force_upper, force_lower;  ///< d force / d (d, theta1, theta2)
  Eigen::Matrix3d upper_d, upper_upper, upper_lower;  ///< d moment_upper / d (d, theta1, theta2)
  Eigen::Matrix3d lower_d, lower_upper, lower_lower;  ///< d moment_lower / d (d, theta1, theta2)
};

/// Structural damping: the material's own (Kelvin and Voigt), stress = E (strain + time * strain rate), of stretch, twist and
/// bending alike.
///
/// A strain's rate is its gradient times the rates of the ends. Bending is damped by how fast the curvature changes in the
/// material's axes, as in the viscoelastic rods of Lang, Linn and Arnold (Multibody Syst. Dyn. 25 (2011) 285-312): d/dt (R^T k) =
/// R^T w', w the sections' angular velocity along the pipe. Each end turns against the chord by
///   g_i = P w_i - (e x v)/l,   P = 1 - e e^T,   v the lower end's velocity less the upper one's,
/// which is the rate of a_i in axes that spin with the pipe, but for |a_i|^2 and for |a_i| times what the ends' spins differ by.
/// The cubic between makes of it
///   moments  M_1 = c (k11 g_1 + k12 g_2),  M_2 = c (k12 g_1 + k11 g_2),   force on the lower end  e x (M_1 + M_2)/l,   c = time.
/// A rigid motion costs nothing, with a bend in the pipe or without. A pipe that spins at W in a curved hole is bent anew with
/// every turn: that takes c EI k^2 W^2 [W/m] from the drive, a loss factor c W (at 1e-4 s and 180 rpm 0.2 %, as of steel; in a
/// hole of 10 deg/30 m a 5 in pipe then loses 0.08 N m per metre, its friction some 20), and above a critical speed feeds whirl
/// that nothing else damps: the internal damping of rotors (Genta, Dynamics of Rotating Systems, Springer 2005, chapters 4 and
/// 6).
struct BeamDamping
{
  double time = 0.0;                                        ///< [s]; 0: none, the rates below are not looked at
  double dv_du = 0.0;                                       ///< d rate / d move of the method in use, for the tangent [1/s]
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();       ///< of the lower end less that of the upper one [m/s]
  Eigen::Vector3d upper_turning = Eigen::Vector3d::Zero();  ///< angular velocity, spatial [rad/s]
  Eigen::Vector3d lower_turning = Eigen::Vector3d::Zero();
  Eigen::Vector3d upper_spin =
      Eigen::Vector3d::Zero();  ///< the part of the turning that tilts with the end, for the tangent [rad/s]
  Eigen::Vector3d lower_spin = Eigen::Vector3d::Zero();
};

/// Where the ends are.
struct BeamPose
{
  Eigen::Vector3d upper_position, lower_position;
  Eigen::Vector3d upper_normal, lower_normal;               ///< unit
  double twist = 0.0;                                       ///< tau
  Eigen::Quaterniond upper_orientation, lower_orientation;  ///< unit, end's axes to world; not read by the corotational element
  double free_stretch =
      0.0;  ///< eps_0, of the element without tension, as by pressure: eps - eps_0 takes the place of eps in energy and forces
};

/// `load`: dead load spread evenly over the element, in total [N]. Carried by the cubic shape functions it puts half on each end,
/// which is left to the caller, and moments L/12 n1 x load, -L/12 n2 x load on the ends, which are subtracted here.
BeamForces beam_forces(const BeamSection& section, const BeamPose& pose, const BeamDamping& damping, const Eigen::Vector3d& load,
                       BeamStrain& strain) noexcept;

/// The same with the exact tangent.
BeamForces beam_forces(const BeamSection& section, const BeamPose& pose, const BeamDamping& damping, const Eigen::Vector3d& load,
                       BeamStrain& strain, BeamTangent& tangent) noexcept;

/// U [J], the element's elastic energy.
double beam_energy(const BeamSection& section, const BeamPose& pose) noexcept;

}  // namespace drill_rig_sim

#endif
