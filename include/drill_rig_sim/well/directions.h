// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_WELL_DIRECTIONS_H
#define DRILL_RIG_SIM_WELL_DIRECTIONS_H

#include <Eigen/Core>

/// Directions along and around a hole, in the world frame `rig_floor`: x east, y north, z up.
/// A tangent t is a unit vector that points down the hole.
namespace drill_rig_sim
{
/// Unit tangent t = (sin I sin A, sin I cos A, -cos I). Inclination I from vertical down and azimuth A clockwise from north
/// [rad].
Eigen::Vector3d tangent_from(double inclination, double azimuth) noexcept;

/// Inclination of a tangent [rad], 0 .. pi. The tangent need not be a unit vector.
double inclination_of(const Eigen::Vector3d& tangent) noexcept;

/// Azimuth of a tangent [rad], 0 <= A < 2 pi; 0 where the tangent is vertical and the azimuth has no meaning.
double azimuth_of(const Eigen::Vector3d& tangent) noexcept;

/// Unit vector perpendicular to t that points up: z - (z.t) t, normalised. North where t is vertical.
Eigen::Vector3d high_side(const Eigen::Vector3d& tangent) noexcept;

/// Unit vector perpendicular to t that points north: y - (y.t) t, normalised. Up where t points north or south.
Eigen::Vector3d north_side(const Eigen::Vector3d& tangent) noexcept;

/// Angle of `vector`'s projection about t from `reference`, clockwise looking downhole (right-handed about t) [rad], -pi .. pi.
/// `reference` is perpendicular to t; 0 where `vector` is along t.
double angle_about(const Eigen::Vector3d& tangent, const Eigen::Vector3d& reference, const Eigen::Vector3d& vector) noexcept;

/// Angle between two unit vectors [rad], 0 .. pi: 2 atan2(|b - a|, |b + a|), exact near 0 and pi too.
double angle_between(const Eigen::Vector3d& a, const Eigen::Vector3d& b) noexcept;

/// sin(x)/x, by its series near 0.
double sinc(double x) noexcept;

/// From one end of a circular arc of this length to the other [m], by the unit tangents t1, t2 at its ends (minimum curvature):
/// D sinc(alpha/2) (t1 + t2)/|t1 + t2|, alpha the angle between them, less than pi.
Eigen::Vector3d chord_of_arc(const Eigen::Vector3d& t1, const Eigen::Vector3d& t2, double length) noexcept;

/// What a toolface is measured from.
struct ToolfaceReference
{
  Eigen::Vector3d direction = Eigen::Vector3d::UnitY();  ///< unit, perpendicular to the tangent
  bool magnetic = true;                                  ///< true: north, false: the high side
};

/// North below 5 deg of inclination, the high side above.
ToolfaceReference toolface_reference(const Eigen::Vector3d& tangent) noexcept;

/// The same with hysteresis: what was north stays north up to 6 deg, what was the high side stays so down to 4 deg.
ToolfaceReference toolface_reference(const Eigen::Vector3d& tangent, bool was_magnetic) noexcept;

/// What the toolface of a tool with this axis is measured from, in a hole along `hole`: it is the hole's inclination that
/// decides, for the axis of a bent tool swings from one reference to the other as it turns.
Eigen::Vector3d toolface_side(const Eigen::Vector3d& axis, const Eigen::Vector3d& hole) noexcept;

}  // namespace drill_rig_sim

#endif
