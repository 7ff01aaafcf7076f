// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_CONTACT_WALL_CONTACT_H
#define DRILL_RIG_SIM_CONTACT_WALL_CONTACT_H

#include <Eigen/Core>
#include <cmath>

#include "drill_rig_sim/contact/contact_spec.h"
#include "drill_rig_sim/well/wellbore.h"

/// A circular cross section of the string (tool joint, pipe body, stabiliser blade, bit gauge) against the wall of the hole.
///
/// Symbols, all vectors in world axes: D the section's centre, r_D; C the hole's centre beside it, r_C(s), s its measured depth;
/// R_D and R(s) the radii of section and hole; d = r_D - r_C; rho = |d|; n = d / rho, outward; P = 1 - n n^T. R_F: lever of the
/// friction about the axis: R_D, or less where a sleeve turns on the section (a protector's bearing), or what is worn off the
/// surface that rubs.
///
/// Normal:    delta = rho + R_D - R(s),  F_n by normal_force(), applied to the string as -F_n n.
/// Friction:  in the full tangent plane, so that its axial and circumferential parts compete; applied with the arm R_F n.
///            A bristle z (elasto-plastic, implicit return mapping) with a damper c_b beside it carries true sticking:
///              z_t = P (z_n + x + r x R_F n),  v_t = P (v_D + omega x R_F n)          trial; x and r the step's displacement,
///              rotation q   = k_b z_t + c_b v_t f   = -q                                 if |q| <= mu(|v_t|) F_n: sticks, z =
///              z_t f   = -mu F_n q/|q|                      otherwise: slips; the bristle goes to its own limit, z_l = f/-k_b,
///              over
///                                                       c_b/k_b: z = P z_n + (z_l - P z_n) t/(t + c_b/k_b), t the time since z_n
///            with mu(v) the Stribeck curve, its static ratio grown by the rest before the step (rest_growth.h). The bristle is
///            driven by the displacement, not by the velocity: under a constant load it does not creep, whatever the time scheme.
///            The damper sits inside the friction cone: the two together never pull harder than mu F_n, and never give energy
///            back that they did not take. mu = 0 is the frictionless mode.
///
/// rho is taken as sqrt(|d|^2 + 1e-14 m^2): with zero clearance (a bit's gauge in the hole it cut) contact is active down to rho
/// = 0, where n would be undefined; so it goes to zero smoothly within 0.1 micrometre, and all tangents stay exact and finite.
///
/// Not modelled: the normal force has no axial part, so a ledge (a step of the hole's radius) pushes sideways, never along; the
/// bristle's plane is carried along by projection, so rolling contact (whirl) holds no memory of the rolled arc.
namespace drill_rig_sim
{
/// Where the section is and how it moves, at one implicit stage.
/// Unknown of the stage: u = (x, r), 6 numbers, counted from the start of the step. Velocities are affine in it:
/// velocity = c x + const, angular_velocity = c r + const.
struct ContactMotion
{
  Eigen::Vector3d position = Eigen::Vector3d::Zero();          ///< r_D at the stage; the ClosestPoint must be located for it [m]
  Eigen::Vector3d displacement = Eigen::Vector3d::Zero();      ///< x since the start of the step [m]
  Eigen::Vector3d rotation = Eigen::Vector3d::Zero();          ///< r since the start of the step [rad]
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();          ///< v_D [m/s]
  Eigen::Vector3d angular_velocity = Eigen::Vector3d::Zero();  ///< omega [rad/s]
  double velocity_coefficient = 0.0;                           ///< c = dv/du [1/s]
  double time = 0.0;                                           ///< since the start of the step [s]
};

/// What the wall does to the string, about D.
struct WallForce
{
  Eigen::Vector3d force = Eigen::Vector3d::Zero();    ///< normal and friction [N]
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();   ///< of the friction about D [N m]
  Eigen::Vector3d bristle = Eigen::Vector3d::Zero();  ///< z at the stage: the next step's, once this one is accepted [m]
  double normal_force = 0.0;                          ///< F_n >= 0 [N]
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();   ///< n, across the hole, away from its axis [-]
  double penetration = 0.0;                           ///< delta; <= 0: clear of the wall, nothing else is set [m]
  double friction_power = 0.0;                        ///< friction . surface velocity [W]; < 0 where it takes energy out
  bool slipping = false;
};

/// Smooths the distance off centre near zero [m].
constexpr double wall_contact_smoothing = 1e-7;

/// Clearance left between section and wall, -delta [m]; <= 0 means contact. The cheap test before anything else.
/// @param closest      hole at the section
/// @param position  r_D [m]
/// @param radius    R_D [m]
inline double wall_gap(const ClosestPoint& closest, const Eigen::Vector3d& position, double radius) noexcept
{
  const one_lane::V3 d = one_lane::from(position) - one_lane::from(closest.centre);
  return closest.radius - radius - std::sqrt(dot(d, d) + wall_contact_smoothing * wall_contact_smoothing);
}

/// Wall on string with sticking friction, as described at the top of this file.
/// @param closest     hole at motion.position; closest.friction is the kinetic coefficient mu_k
/// @param radius   R_D [m]
/// @param motion   of the section
/// @param bristle  z_n, at the start of the step; zero where there was no contact [m]
/// @param law      normal law, Stribeck curve, bristle's stiffness k_b and damping c_b
/// @return zeros when clear of the wall
WallForce wall_contact(const ClosestPoint& closest, double radius, const ContactMotion& motion, const Eigen::Vector3d& bristle,
                       const WallLaw& law) noexcept;

/// The same with the consistent tangent d(force, moment)/d(x, r), overwritten; zero when clear of the wall. Not symmetric.
/// It holds the change of n along the curved hole, dn/dr_D = P (1 - dC/ds (ds/dr_D)^T) / rho; of the hole, only the change of
/// ds/dr_D and of dR/ds themselves is left out (second order in curvature and taper).
WallForce wall_contact(const ClosestPoint& closest, double radius, const ContactMotion& motion, const Eigen::Vector3d& bristle,
                       const WallLaw& law, Eigen::Ref<Eigen::Matrix<double, 6, 6>> tangent) noexcept;

/// Prescribed sliding of the section's surface, for quasi-static torque and drag. Only the ratio of the two speeds matters.
struct SlidingMotion
{
  double axial_speed = 0.0;  ///< along the hole, + down [m/s]: -1 pulls out, +1 runs in
  double spin_speed = 0.0;   ///< about the hole's tangent, + clockwise looking downhole [rad/s]
  double share = 1.0;        ///< of the friction that acts, 0 to 1: on the way to an equilibrium [-]

  bool still() const noexcept { return axial_speed == 0.0 && spin_speed == 0.0; }
};

constexpr SlidingMotion no_sliding{}, sliding_up{-1.0, 0.0}, sliding_down{1.0, 0.0}, sliding_around{0.0, 1.0};

/// Wall on string in steady sliding: full kinetic friction mu_k F_n, or that share of it, against the given motion, no damping,
/// no bristle. Slip direction m = (v_a t + w R_F t x n) / |...|; friction -mu_k F_n m, moment R_F n x friction. No sliding: no
/// friction.
/// @param tangent  d(force, moment)/d(x, r) at fixed sliding motion and hole tangent t, overwritten; columns of r are zero
WallForce sliding_wall_contact(const ClosestPoint& closest, double radius, const Eigen::Vector3d& position,
                               const SlidingMotion& sliding, const WallLaw& law,
                               Eigen::Ref<Eigen::Matrix<double, 6, 6>> tangent) noexcept;

}  // namespace drill_rig_sim

#endif
