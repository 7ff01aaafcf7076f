// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_CONTACT_FRICTION_LAW_H
#define DRILL_RIG_SIM_CONTACT_FRICTION_LAW_H

namespace drill_rig_sim
{
/// Friction coefficient at a slip speed, and its slope.
struct FrictionCoefficient
{
  double value = 0.0;  ///< mu [-]
  double slope = 0.0;  ///< dmu/dv [s/m]
};

/// How friction falls from static to kinetic.
enum class StribeckCurve
{
  gaussian,    ///< exp(-(v / v_s)^2): flat at rest, kinetic beyond some 2 v_s
  exponential  ///< exp(-v / v_s): falls from rest on, kinetic beyond some 4 v_s
};

/// Stribeck curve mu(v) = mu_k (1 + (ratio - 1) exp(-(v / v_s)^d)), d = 2 or 1 by `curve`: static at rest.
/// @param kinetic       mu_k >= 0 [-]
/// @param static_ratio  mu_s / mu_k >= 1 [-]
/// @param stribeck_speed  v_s > 0 [m/s]
/// @param speed         slip speed v >= 0 [m/s]
/// Source: Armstrong-Helouvry, Dupont, Canudas de Wit, A survey of models ... for the control of machines with friction,
/// Automatica 30 (1994), 1083-1138, eq. (4) with exponent 2 and no viscous term; exponent 1 is Tustin's (1947), which it cites.
FrictionCoefficient stribeck_friction(double kinetic, double static_ratio, double stribeck_speed, double speed,
                                      StribeckCurve curve = StribeckCurve::gaussian) noexcept;

}  // namespace drill_rig_sim

#endif
