// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_CONTACT_NORMAL_LAW_H
#define DRILL_RIG_SIM_CONTACT_NORMAL_LAW_H

#include "drill_rig_sim/math/one_lane.h"

namespace drill_rig_sim::one_lane
{
#include "drill_rig_sim/contact/normal_text.h"
}  // namespace drill_rig_sim::one_lane

namespace drill_rig_sim
{
/// Hertz stiffness with Hunt-Crossley damping: F = stiffness delta^exponent (1 + damping delta').
struct ContactLaw
{
  double stiffness = 5e7;  ///< [N/m^exponent]
  double exponent = 1.5;   ///< [-], 1 .. 3
  double damping = 0.3;    ///< [s/m]
};

/// Normal contact force and its partial derivatives.
struct NormalForce
{
  double value = 0.0;      ///< F [N], >= 0
  double stiffness = 0.0;  ///< dF/d(penetration) [N/m]
  double damping = 0.0;    ///< dF/d(penetration rate) [N s/m]
};

/// Hunt-Crossley form of Hertz' law, F = max(0, k delta^e (1 + c_d delta')).
///
/// The damping is proportional to the elastic force, so that F rises from zero at first touch and never pulls. With c_d = 0 an
/// impact is elastic; for small impact speeds v the coefficient of restitution is about 1 - 2/3 c_d v for every exponent.
/// @param law          k [N/m^e], e >= 1, c_d [s/m]
/// @param penetration  delta [m]; <= 0 gives all zeros
/// @param rate         d delta/dt [m/s]
/// Source: Hunt and Crossley, Coefficient of restitution interpreted as damping in vibroimpact, J. Appl. Mech. 42 (1975),
/// 440-445.
inline NormalForce normal_force(const ContactLaw& law, double penetration, double rate) noexcept
{
  if (penetration <= 0.0) return {};
  const one_lane::Pressed f = one_lane::pressed(law.stiffness, law.exponent, law.damping, penetration, rate);
  return {f.value, f.stiffness, f.damping};
}

/// The elastic part of the force, k delta^e [N].
inline double elastic_force(const ContactLaw& law, double penetration) noexcept
{
  return normal_force({law.stiffness, law.exponent, 0.0}, penetration, 0.0).value;
}

/// Its energy, k delta^(e + 1)/(e + 1) [J].
inline double elastic_energy(const ContactLaw& law, double penetration) noexcept
{
  return penetration > 0.0 ? elastic_force(law, penetration) * penetration / (law.exponent + 1.0) : 0.0;
}

}  // namespace drill_rig_sim

#endif
