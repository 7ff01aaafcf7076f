// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_RIG_DAMPED_BRISTLE_H
#define DRILL_RIG_SIM_RIG_DAMPED_BRISTLE_H

#include <cmath>

namespace drill_rig_sim
{
/// Friction on a coordinate, at a moment of a step.
struct BristleForce
{
  double force = 0.0;     ///< on what moves [N or N m]
  double by_move = 0.0;   ///< d force / d move, <= 0
  double by_speed = 0.0;  ///< d force / d speed, <= 0
  double next = 0.0;      ///< deflection if the step ends here [m or rad]
};

/// Coulomb friction in one coordinate, carried by a damped bristle as at the wall (contact/wall_contact.h): what it holds does
/// not creep, and does not ring. In a step from deflection z, after a move u at speed v,
///   q = k (z + u) + c v,   force = -q while |q| <= most, else -most sign(q).
/// Stuck, z moves along; slipping it goes to -force/k over the time c/k. Passive for any damping c >= 0.
struct DampedBristle
{
  double most = 0.0;        ///< [N or N m]
  double stiffness = 0.0;   ///< k > 0 [N/m or N m/rad]
  double damping = 0.0;     ///< c [N s/m or N m s/rad]
  double deflection = 0.0;  ///< z at the start of the step [m or rad]

  /// q
  double trial(double move, double speed) const noexcept { return stiffness * (deflection + move) + damping * speed; }
  /// @param force  that acts at the end of the step, `time` after its start [s]
  double next(double move, double force, bool slips, double time) const noexcept;
  BristleForce at(double move, double speed, double time) const noexcept
  {
    const double q = trial(move, speed);
    if (std::abs(q) <= most) return {-q, -stiffness, -damping, next(move, -q, false, time)};
    const double force = std::copysign(most, -q);
    return {force, 0.0, 0.0, next(move, force, true, time)};
  }
};

}  // namespace drill_rig_sim

#endif
