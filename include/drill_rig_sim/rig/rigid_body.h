// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_RIG_RIGID_BODY_H
#define DRILL_RIG_SIM_RIG_RIGID_BODY_H

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "drill_rig_sim/math/one_lane.h"

namespace drill_rig_sim::one_lane
{
#include "drill_rig_sim/rig/rigid_body_text.h"
}  // namespace drill_rig_sim::one_lane

/// A rigid body that is alike in all directions across its x axis: travelling block, stator, rotor, bit, and the cross-section
/// that carries a string node's inertia. World axes throughout; symbols: n the body's x axis, w its angular velocity, v its
/// centre's velocity.
///
/// Balance of momentum and of moment of momentum about the centre, exact for any motion:
///   force  = (m + m_a) v' - m_a n (n . v')                      m_a added mass of mud, across the axis only
///   moment = J_t w' + (J_s - J_t) ((w' . n) n + (w . n) w x n)  from d/dt (J_t w + (J_s - J_t) (w . n) n), n' = w x n
namespace drill_rig_sim
{
struct RigidBody
{
  double mass = 0.0;          ///< m [kg]
  double added_mass = 0.0;    ///< m_a [kg]
  double spin_inertia = 0.0;  ///< J_s, about the x axis [kg m2]
  double tilt_inertia = 0.0;  ///< J_t, about any axis across it [kg m2]
};

/// Where a body is and how it moves.
struct BodyMotion
{
  Eigen::Vector3d position = Eigen::Vector3d::Zero();               ///< of its centre [m]
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();  ///< body to world
  Eigen::Vector3d normal = Eigen::Vector3d::UnitX();                ///< n, the x axis of `orientation`
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();               ///< v [m/s]
  Eigen::Vector3d angular_velocity = Eigen::Vector3d::Zero();       ///< w, world axes [rad/s]
};

/// Force and moment, 6 numbers, that give a body of axis n and angular velocity w the acceleration (v', w'). `gyroscopic` [kg
/// m2]: J_s - J_t where w' is the rate of w in world axes; J_s where it is the rate in axes that tilt with the body but do not
/// spin, tilt' + spin' n, which lacks the term spin w x n of the other.
inline Eigen::Matrix<double, 6, 1> inertia_force(const RigidBody& body, const Eigen::Vector3d& n, const Eigen::Vector3d& w,
                                                 const Eigen::Matrix<double, 6, 1>& acceleration, double gyroscopic) noexcept
{
  const one_lane::Body of{body.mass, body.added_mass, body.spin_inertia, body.tilt_inertia};
  return one_lane::to_eigen(
      one_lane::inertia_force(of, one_lane::from(n), one_lane::from(w), one_lane::from(acceleration), gyroscopic));
}
/// The same in world axes.
inline Eigen::Matrix<double, 6, 1> inertia_force(const RigidBody& body, const BodyMotion& motion,
                                                 const Eigen::Matrix<double, 6, 1>& acceleration) noexcept
{
  return inertia_force(body, motion.normal, motion.angular_velocity, acceleration, body.spin_inertia - body.tilt_inertia);
}
/// Its derivative with respect to (v', w').
Eigen::Matrix<double, 6, 6> inertia_by_acceleration(const RigidBody& body, const BodyMotion& motion) noexcept;
/// Of the moment, with respect to w.
Eigen::Matrix3d inertia_by_angular_velocity(const RigidBody& body, const BodyMotion& motion) noexcept;
/// Of both, with respect to a small spatial rotation of the body, accelerations and velocities held in world axes.
Eigen::Matrix<double, 6, 3> inertia_by_rotation(const RigidBody& body, const BodyMotion& motion,
                                                const Eigen::Matrix<double, 6, 1>& acceleration) noexcept;

/// Kinetic energy of translation, mass and added mass [J].
inline double kinetic_energy(const RigidBody& body, const Eigen::Vector3d& n, const Eigen::Vector3d& v) noexcept
{
  const double along = v.dot(n);
  return 0.5 * ((body.mass + body.added_mass) * v.squaredNorm() - body.added_mass * along * along);
}
/// And of rotation [J].
inline double turning_energy(const RigidBody& body, const Eigen::Vector3d& n, const Eigen::Vector3d& w) noexcept
{
  const double spin = w.dot(n);
  return 0.5 * (body.tilt_inertia * w.squaredNorm() + (body.spin_inertia - body.tilt_inertia) * spin * spin);
}
/// Both [J].
inline double kinetic_energy(const RigidBody& body, const BodyMotion& motion) noexcept
{
  return kinetic_energy(body, motion.normal, motion.velocity) + turning_energy(body, motion.normal, motion.angular_velocity);
}

}  // namespace drill_rig_sim

#endif
