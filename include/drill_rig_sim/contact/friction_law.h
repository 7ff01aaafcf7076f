#ifndef DRILL_RIG_SIM_CONTACT_FRICTION_LAW_H
#define DRILL_RIG_SIM_CONTACT_FRICTION_LAW_H

#include <cmath>

namespace drill_rig_sim
{
/// Friction coefficient at a slip speed, and its slope.
struct FrictionCoefficient
{
  double value = 0.0;  ///< mu [-]
  double slope = 0.0;  ///< dmu/dv [s/m]
};

/// Stribeck curve mu(v) = mu_k (1 + (ratio - 1) exp(-(v / v_s)^2)): static at rest with zero slope, kinetic beyond some 2 v_s.
/// @param kinetic       mu_k >= 0 [-]
/// @param static_ratio  mu_s / mu_k >= 1 [-]
/// @param stribeck_speed  v_s > 0 [m/s]
/// @param speed         slip speed v >= 0 [m/s]
/// Source: Armstrong-Helouvry, Dupont, Canudas de Wit, A survey of models ... for the control of machines with friction,
/// Automatica 30 (1994), 1083-1138, eq. (4) with exponent 2 and no viscous term.
inline FrictionCoefficient stribeck_friction(double kinetic, double static_ratio, double stribeck_speed, double speed) noexcept
{
  const double x = speed / stribeck_speed;
  const double excess = kinetic * (static_ratio - 1.0) * std::exp(-x * x);
  return {kinetic + excess, -2.0 * x / stribeck_speed * excess};
}

}  // namespace drill_rig_sim

#endif
