// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_CONTACT_SURFACE_FRICTION_H
#define DRILL_RIG_SIM_CONTACT_SURFACE_FRICTION_H

#include <Eigen/Core>

#include "drill_rig_sim/contact/contact_spec.h"

namespace drill_rig_sim
{
/// A pipe's surface on the wall in its two directions, along the hole (+ down) and around it (+ clockwise looking downhole), at
/// one implicit stage. Unknown: the displacement x since the start of the step; velocity = velocity_coefficient x + const.
struct SurfaceMotion
{
  Eigen::Vector2d displacement = Eigen::Vector2d::Zero();  ///< [m]
  Eigen::Vector2d velocity = Eigen::Vector2d::Zero();      ///< [m/s]
  double velocity_coefficient = 0.0;                       ///< [1/s]
  double time = 0.0;                                       ///< since the start of the step [s]
};

struct SurfaceFriction
{
  Eigen::Vector2d force = Eigen::Vector2d::Zero();    ///< wall on string [N]
  Eigen::Vector2d bristle = Eigen::Vector2d::Zero();  ///< at the stage [m]
  bool slipping = false;
};

/// Derivatives of the force.
struct SurfaceSlopes
{
  Eigen::Matrix2d by_displacement = Eigen::Matrix2d::Zero();  ///< through the velocity too [N/m]
  Eigen::Vector2d by_normal_force = Eigen::Vector2d::Zero();  ///< [-]
};

/// Friction of pipe that is known to lie on the wall with `normal_force` [N], by the law of wall_contact.h with its sticking
/// bristle and Stribeck curve.
/// @param kinetic  mu_k [-]
/// @param bristle  at the start of the step [m]
/// @param slopes   overwritten; null: not computed
SurfaceFriction surface_friction(double normal_force, double kinetic, const SurfaceMotion& motion, const Eigen::Vector2d& bristle,
                                 const WallLaw& law, SurfaceSlopes* slopes) noexcept;

}  // namespace drill_rig_sim

#endif
