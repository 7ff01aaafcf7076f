// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_HYDRAULICS_RHEOLOGY_H
#define DRILL_RIG_SIM_HYDRAULICS_RHEOLOGY_H

#include <limits>
#include <string>
#include <vector>

/// Flow curves of muds: shear stress by shear rate.
///
///   tau = tau_y + K rate^n                                                                                              (1)
///
/// tau [Pa], rate [1/s], yield stress tau_y [Pa], consistency K [Pa s^n], flow behaviour index n [-]: Herschel and Bulkley,
/// Kolloid-Zeitschrift 39 (1926) 291-300. The other laws are cases of it: Newtonian tau_y = 0, n = 1; Bingham n = 1, with the
/// plastic viscosity K and the yield point tau_y; power law tau_y = 0. Valid for 0.1 <= n <= 1, the shear-thinning muds of API RP
/// 13D. Gel strength and time are not in it.
namespace drill_rig_sim
{
enum class RheologyLaw
{
  newtonian,
  bingham,
  power_law,
  herschel_bulkley
};

constexpr double least_flow_index = 0.1, most_flow_index = 1.0;

struct Rheology
{
  double yield_stress = 0.0;  ///< tau_y >= 0 [Pa]
  double consistency = 0.02;  ///< K > 0 [Pa s^n]
  double index = 1.0;         ///< n [-]
};

/// Stress (1) at a shear rate > 0 [1/s], [Pa].
double shear_stress(const Rheology& mud, double rate) noexcept;

/// Slope of (1) between 300 and 600 rpm of a viscometer [Pa s]: the viscosity of a Newtonian mud, the plastic viscosity of a
/// Bingham one. API RP 13B-1 defines the plastic viscosity of any mud so, as R600 - R300 in cP.
double plastic_viscosity(const Rheology& mud) noexcept;

/// A reading of a direct-indicating viscometer with rotor R1, bob B1 and spring F1 (Fann 35).
struct ViscometerReading
{
  double speed = 0.0;  ///< [rpm]
  double dial = 0.0;   ///< [deg]
};

/// Of that geometry, both from API RP 13D: a degree of the dial is 0.511 Pa (1.067 lbf/100 ft2; field formulas take 1), a
/// rpm 1.703 1/s.
constexpr double stress_per_dial_degree = 0.511, shear_rate_per_rpm = 1.703;

/// The flow curve of a law through readings.
/// - Herschel-Bulkley from R600, R300, R6 and R3, these four: tau_y = 2 R3 - R6, n = log2((R600 - tau_y)/(R300 - tau_y)), K =
/// (R300 - tau_y)/511^n,
///   the measurement method of API RP 13D.
/// - Otherwise by least squares of the stress, exact where there are as many readings as the law has parameters: Newtonian 1,
/// Bingham and power law 2,
///   Herschel-Bulkley 3.
/// @param readings  that readings_problem() finds nothing wrong with
Rheology fitted(RheologyLaw law, const std::vector<ViscometerReading>& readings);

/// What is wrong with readings for a law, or "".
std::string readings_problem(RheologyLaw law, const std::vector<ViscometerReading>& readings);

/// What a scene says of its mud: readings, or the numbers of its law, those not given NaN.
struct RheologySpec
{
  static constexpr double unset = std::numeric_limits<double>::quiet_NaN();
  RheologyLaw law = RheologyLaw::bingham;
  double plastic_viscosity = unset;  ///< Bingham [Pa s]
  double yield_point = unset;        ///< Bingham [Pa]
  double yield_stress = unset;       ///< Herschel-Bulkley [Pa]
  double consistency = unset;        ///< power law and Herschel-Bulkley [Pa s^n]
  double index = unset;              ///< the same [-]
  std::vector<ViscometerReading> readings;
  double eccentricity = 0.0;     ///< of the string in its hole, offset over clearance (flow_losses.h) [-]
  double rotation_factor = 1.0;  ///< on the annulus's losses at 120 rpm (flow_losses.h) [-]
};

/// Its flow curve.
/// @param viscosity  of a Newtonian mud without readings [Pa s]
Rheology curve_of(const RheologySpec& spec, double viscosity);

}  // namespace drill_rig_sim

#endif
