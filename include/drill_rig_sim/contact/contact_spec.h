#ifndef DRILL_RIG_SIM_CONTACT_CONTACT_SPEC_H
#define DRILL_RIG_SIM_CONTACT_CONTACT_SPEC_H

#include "drill_rig_sim/contact/normal_law.h"

namespace drill_rig_sim
{
/// Wall contact of the whole string unless a part sets its own law, and the friction law's shape.
struct ContactSpec
{
  ContactLaw law;
  double stribeck_speed = 0.05;       ///< slip speed over which friction falls from static to kinetic [m/s]
  double static_ratio = 1.2;          ///< static / kinetic friction [-], >= 1
  double tangential_stiffness = 5e6;  ///< of the bristle that carries sticking friction [N/m]
};

}  // namespace drill_rig_sim

#endif
