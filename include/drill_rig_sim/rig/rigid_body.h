#ifndef DRILL_RIG_SIM_RIG_RIGID_BODY_H
#define DRILL_RIG_SIM_RIG_RIGID_BODY_H

#include <Eigen/Core>
#include <Eigen/Geometry>

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

/// Force and moment, 6 numbers, that give the body the acceleration (v', w').
Eigen::Matrix<double, 6, 1> inertia_force(const RigidBody& body, const BodyMotion& motion,
                                          const Eigen::Matrix<double, 6, 1>& acceleration) noexcept;
/// Its derivative with respect to (v', w').
Eigen::Matrix<double, 6, 6> inertia_by_acceleration(const RigidBody& body, const BodyMotion& motion) noexcept;
/// Of the moment, with respect to w.
Eigen::Matrix3d inertia_by_angular_velocity(const RigidBody& body, const BodyMotion& motion) noexcept;
/// Of both, with respect to a small spatial rotation of the body, accelerations and velocities held in world axes.
Eigen::Matrix<double, 6, 3> inertia_by_rotation(const RigidBody& body, const BodyMotion& motion,
                                                const Eigen::Matrix<double, 6, 1>& acceleration) noexcept;

/// Kinetic energy of mass and added mass [J].
double kinetic_energy(const RigidBody& body, const BodyMotion& motion) noexcept;

}  // namespace drill_rig_sim

#endif
