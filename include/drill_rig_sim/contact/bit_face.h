// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_CONTACT_BIT_FACE_H
#define DRILL_RIG_SIM_CONTACT_BIT_FACE_H

#include <Eigen/Core>

/// What the bit's face resists to being moved across the bottom.
///
/// Every part of the face is resisted against its own motion, v + omega x r. On a disc of radius a under a uniform pressure that
/// resists with M in all, epsilon = v/(|omega| a), the sum across the bottom is
///   M (4/(3 pi)) ((1 + eps^2) E(eps) - (1 - eps^2) K(eps))/eps   for eps <= 1,
/// eps M for small eps (a damper that turning makes of friction) and M for large ones. Here M eps/(1 + eps^4)^(1/4), within 2 %
/// of it. Its torque for v = 0 is 2/3 a M: M = 3 T/(2 a) with T the largest torque on bit, cutting and rubbing alike. Source:
/// Farkas, Bartels, Unger, Wolf, Frictional coupling between sliding and spinning motion, Phys. Rev. Lett. 90 (2003) 248302.
///
/// Not modelled: sticking. A bit that neither turns nor slides creeps, by less than 1 cm/s below M. Nor what sliding takes of the
/// torque.
namespace drill_rig_sim
{
/// Resistance across the bottom and its derivatives.
struct BitFaceFriction
{
  Eigen::Vector3d value = Eigen::Vector3d::Zero();  ///< of the face on the rock, along its motion: the bit gets the opposite [N]
  Eigen::Matrix3d by_velocity = Eigen::Matrix3d::Zero();    ///< [N s/m]
  Eigen::Vector3d by_speed = Eigen::Vector3d::Zero();       ///< d/d(omega) at fixed M [N s/rad]
  Eigen::Vector3d by_resistance = Eigen::Vector3d::Zero();  ///< d/dM [-]
};

/// @param resistance  M >= 0 [N]
/// @param radius      a [m]
/// @param velocity    of the bit's centre, world axes; its part along `down` is left out [m/s]
/// @param speed       omega, of the bit about its axis [rad/s]
/// @param down        the bottom's normal, unit
BitFaceFriction bit_face_friction(double resistance, double radius, const Eigen::Vector3d& velocity, double speed,
                                  const Eigen::Vector3d& down) noexcept;

}  // namespace drill_rig_sim

#endif
