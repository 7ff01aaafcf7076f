// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_CONTACT_CONTACT_SPEC_H
#define DRILL_RIG_SIM_CONTACT_CONTACT_SPEC_H

#include <cmath>

#include "drill_rig_sim/contact/friction_law.h"
#include "drill_rig_sim/contact/normal_law.h"
#include "drill_rig_sim/contact/rest_growth.h"

namespace drill_rig_sim
{
/// Wall contact of the whole string unless a part sets its own law, and the friction law's shape unless a hole section sets its
/// own.
struct ContactSpec
{
  ContactLaw law;
  /// Least k of the wall under bit gauge, stabiliser blades and motor sleeve, unless the part has a law of its own: their levers
  /// are short, and what they embed themselves is missing from the bit's side force [N/m^e]
  double assembly_stiffness = 2e10;
  /// Slip speed over which friction falls from static to kinetic: an assumption, within the 0.001 to 0.1 m/s of lubricated metal
  /// (Armstrong-Helouvry, Dupont, Canudas de Wit, Automatica 30 (1994) 1083-1138), at which ordinary pick-up and slack-off (0.1
  /// m/s) do not stick and slip [m/s]
  double stribeck_speed = 0.02;
  double static_ratio = 1.2;  ///< static / kinetic friction: an assumption [-], >= 1
  StribeckCurve stribeck_curve = StribeckCurve::gaussian;
  RestGrowth growth;
  double tangential_stiffness = 5e6;  ///< of the bristle that carries sticking friction [N/m]
  double tangential_damping =
      0.25;  ///< of that bristle, of what is critical for the mass at the contact: what sticks does not ring [-]
};

/// The law at one place of the string.
struct WallLaw
{
  ContactLaw law;
  double stribeck_speed = 0.0;        ///< [m/s]
  double static_ratio = 1.0;          ///< [-]
  double tangential_stiffness = 1.0;  ///< k_b [N/m]
  double tangential_damping = 0.0;    ///< c_b [N s/m]
  StribeckCurve stribeck_curve = StribeckCurve::gaussian;
  double friction_radius = 0.0;  ///< R_F [m]; 0: the section's radius
};

/// @param law   normal law of the part there
/// @param mass  that rests on the contact [kg]; c_b = 2 zeta sqrt(k_b m)
/// @param friction_radius  R_F [m]; 0: the section's radius
inline WallLaw wall_law(const ContactSpec& spec, const ContactLaw& law, double mass, double friction_radius)
{
  return {law,
          spec.stribeck_speed,
          spec.static_ratio,
          spec.tangential_stiffness,
          2.0 * spec.tangential_damping * std::sqrt(spec.tangential_stiffness * mass),
          spec.stribeck_curve,
          friction_radius};
}

}  // namespace drill_rig_sim

#endif
