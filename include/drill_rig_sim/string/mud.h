// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_STRING_MUD_H
#define DRILL_RIG_SIM_STRING_MUD_H

#include <limits>
#include <vector>

namespace drill_rig_sim
{
/// How far down a string is empty inside while its bit is at a depth.
struct FillLevel
{
  double bit_depth = 0.0;  ///< [m MD]
  double level =
      0.0;  ///< of the mud in the string, measured along it from the rotary table down; at the bit or deeper: it is empty [m]
};

/// The drilling fluid around and inside the string.
struct MudSpec
{
  static constexpr double by_viscosity = std::numeric_limits<double>::quiet_NaN();

  double density = 1150.0;  ///< [kg/m3]
  double viscosity =
      0.02;  ///< dynamic one; 0.02 Pa s (20 cP) is an assumption: plastic viscosities of muds are 5 to 60 mPa s [Pa s]
  double axial_damping = by_viscosity;      ///< instead of what the viscosity makes (mud_damping.h) [N s/m per m]
  double lateral_damping = by_viscosity;    ///< linear part, likewise [N s/m per m]
  double drag_coefficient = 1.0;            ///< C_d of the quadratic part, on the outer diameter [-]
  double torsional_damping = by_viscosity;  ///< likewise [N m s/rad per m]
  double bulk_modulus = 1.4e9;              ///< as a well shows it, with what pipe and hole give way [Pa]
  double gel_strength = 0.0;                ///< after ten minutes' rest [Pa]
  double added_mass = 1.0;                  ///< factor on the mass of the mud that moves sideways with the string [-]
  std::vector<FillLevel>
      fill;  ///< of a string run in on its float, by growing bit depths; linear between them, constant beyond; none: full
};

/// The level of the mud in the string as the crew leaves it with the bit at a depth [m]: 0 where it is full.
double fill_level(const MudSpec& mud, double bit_depth) noexcept;

/// How much more mud a round body moves sideways in a hole than its own volume of it: C_m = (D_h^2 + D^2)/(D_h^2 - D^2), the
/// ideal fluid between a cylinder and a hole about the same axis (Fritz, J. Eng. Industry 94 (1972) 167-173); near the wall it
/// would be 1.5 to 2 times that. Singular for close fits, where viscosity decides: at most 5.
/// @param diameter  D [m]
/// @param hole_diameter  D_h [m]
double confinement(double diameter, double hole_diameter) noexcept;

/// Drag across a round body per metre and (m/s)^2: half rho C_d D [N s2/m3].
inline double lateral_drag(const MudSpec& mud, double diameter) noexcept
{
  return 0.5 * mud.density * mud.drag_coefficient * diameter;
}

}  // namespace drill_rig_sim

#endif
