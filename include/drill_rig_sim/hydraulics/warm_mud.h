// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_HYDRAULICS_WARM_MUD_H
#define DRILL_RIG_SIM_HYDRAULICS_WARM_MUD_H

#include <cmath>

/// What temperature and pressure make of a mud's density and flow curve (`mud.temperature`).
///
/// Density (Karstad and Aadnoy, IADC/SPE 47806, 1998, its linear terms), p above the atmosphere's, T_i that of the mud pumped in:
///   rho = rho_i exp(kappa p - alpha (T - T_i)),      rho_i: `mud.density`.                                                (1)
/// Flow curve: yield stress and consistency by one factor (Arrhenius; the index stays), T_r that of `mud.rheology`:
///   f = exp(B (1/(T + 273.15) - 1/(T_r + 273.15))).                                                                      (2)
///
/// Defaults. alpha and kappa are water's at 50 degC (CRC Handbook of Chemistry and Physics: 4.6e-4 1/K, 4.4e-10 1/Pa), alpha less
/// a tenth of solids; oil-based muds have 7e-4 1/K and 7e-10 1/Pa (assumptions). B = 1735 K is water's: 1.002 mPa s at 20 degC,
/// 0.282 at 100 degC (IAPWS); that the plastic viscosity of a water-based mud falls as water's does and that the yield stress
/// falls alike are assumptions. Bentonite that flocculates thickens from some 120 degC on instead.
namespace drill_rig_sim
{
/// The file's mud.temperature. Temperatures in degC.
struct MudTemperatureSpec
{
  double inlet = 30.0;                 ///< T_i, of the mud that is pumped in
  double surface = 15.0;               ///< of the ground, undisturbed
  double gradient = 0.03;              ///< of the ground by true vertical depth [K/m]
  double heat_capacity = 3500.0;       ///< c of the mud [J/(kg K)]
  double pipe_coefficient = 170.0;     ///< U_p between bore and annulus, by the string's outside [W/(m2 K)]
  double wall_coefficient = 170.0;     ///< U_w between annulus and rock, by the hole's wall [W/(m2 K)]
  double rock_conductivity = 2.25;     ///< k [W/(m K)]
  double rock_diffusivity = 1.0e-6;    ///< a [m2/s]
  double expansion = 4.0e-4;           ///< alpha [1/K]
  double compressibility = 4.4e-10;    ///< kappa [1/Pa]
  double activation = 1735.0;          ///< B [K]
  double rheology_temperature = 49.0;  ///< T_r
  double circulated = 0.0;             ///< how long mud was pumped before the start [s]
};

/// rho/rho_i of (1).
/// @param pressure  p [Pa]
inline double density_ratio(const MudTemperatureSpec& spec, double temperature, double pressure) noexcept
{
  return std::exp(spec.compressibility * pressure - spec.expansion * (temperature - spec.inlet));
}

/// f of (2).
inline double viscosity_factor(const MudTemperatureSpec& spec, double temperature) noexcept
{
  constexpr double zero = 273.15;
  return std::exp(spec.activation * (1.0 / (temperature + zero) - 1.0 / (spec.rheology_temperature + zero)));
}

/// Undisturbed temperature of the ground at a true vertical depth [m]; at its surface and above it that of the surface.
inline double ground_temperature(const MudTemperatureSpec& spec, double depth) noexcept
{
  return spec.surface + spec.gradient * (depth > 0.0 ? depth : 0.0);
}

}  // namespace drill_rig_sim

#endif
