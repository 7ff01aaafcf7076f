#ifndef DRILL_RIG_SIM_STRING_MUD_H
#define DRILL_RIG_SIM_STRING_MUD_H

namespace drill_rig_sim
{
/// The drilling fluid around and inside the string.
struct MudSpec
{
  double density = 1150.0;          ///< [kg/m3]
  double axial_damping = 0.0;       ///< [N s/m per m]
  double lateral_damping = 20.0;    ///< [N s/m per m]
  double torsional_damping = 5e-4;  ///< [N m s/rad per m]
  double added_mass = 1.0;          ///< factor on the displaced mud's mass, lateral motion only [-]
};

}  // namespace drill_rig_sim

#endif
