// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_MATH_TILT_SPIN_H
#define DRILL_RIG_SIM_MATH_TILT_SPIN_H

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace drill_rig_sim
{
/// Three coordinates r of a rotation that any integrator can add up: R = exp(tilt) exp(spin n0) R0 with
/// r = tilt + spin n0, tilt across n0. n0 is the x axis of the base R0.
///
/// Spin is a plain scalar: any number of turns. Tilt is the rotation that takes n0 to the x axis n by the shortest way; it must
/// stay well below a quarter turn (the rates below are exact up to there), so the base is renewed now and then.
///
/// With theta = |tilt|, w the angular velocity in world axes, w_0 = w . n0, w_a = w - w_0 n0:
///   tilt' = k w_a + m tilt (tilt . w) + w_0 n0 x tilt,   k = theta cot(theta),  m = (1 - k)/theta^2
///   spin' = w_0 - h n0 . (tilt x w),                     h = tan(theta/2)/theta
/// Derived from w = dexp(tilt) tilt' + n spin' in the axes along tilt, n0 x tilt and n0.
struct TiltSpin
{
  Eigen::Vector3d normal = Eigen::Vector3d::UnitX();         ///< n0
  Eigen::Quaterniond base = Eigen::Quaterniond::Identity();  ///< R0

  /// The chart about an orientation, r = 0 there.
  static TiltSpin about(const Eigen::Quaterniond& orientation) noexcept;

  double spin(const Eigen::Vector3d& r) const noexcept { return normal.dot(r); }
  Eigen::Vector3d tilt(const Eigen::Vector3d& r) const noexcept { return r - normal * normal.dot(r); }
  Eigen::Quaterniond orientation(const Eigen::Vector3d& r) const noexcept;

  /// r' at the angular velocity w (world axes) [rad/s].
  Eigen::Vector3d rate(const Eigen::Vector3d& r, const Eigen::Vector3d& w) const noexcept;
  /// dr'/dw, a function only of r: rate = rate_by_velocity w.
  Eigen::Matrix3d rate_by_velocity(const Eigen::Vector3d& r) const noexcept;
  /// Its inverse, w = velocity_by_rate r': takes a change of r to the small spatial rotation that it makes.
  Eigen::Matrix3d velocity_by_rate(const Eigen::Vector3d& r) const noexcept;
  /// dr'/dr at a fixed angular velocity.
  Eigen::Matrix3d rate_by_coordinates(const Eigen::Vector3d& r, const Eigen::Vector3d& w) const noexcept;
};

}  // namespace drill_rig_sim

#endif
