// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_HYDRAULICS_CUTTINGS_H
#define DRILL_RIG_SIM_HYDRAULICS_CUTTINGS_H

#include "drill_rig_sim/hydraulics/flow_losses.h"
#include "drill_rig_sim/hydraulics/rheology.h"

/// How mud carries cuttings, and how they settle to a bed on the low side of an inclined hole. SI units throughout.
///
/// Slip. A cutting of diameter d and density rho_s falls in mud of density rho and apparent viscosity mu at (Moore, Drilling
/// Practices Manual, 1974; Bourgoyne, Applied Drilling Engineering, 1986, sec. 4.13), dr = rho_s - rho,
///   v_s = least of  g d^2 dr/(30 mu),  (g dr 4/66)^(2/3) d/(rho mu)^(1/3),  sqrt(8/9 g d dr/rho)                         (1)
/// the friction factors 40/Re, 22/sqrt(Re) and 1.5 of a cutting. mu is that of the mud that flows in the annulus,
///   mu = tau_w (D_h - D)/(12 V),   tau_w of laminar flow (flow_losses.h).                                               (2)
/// Lapeyrouse, Formulas and Calculations for Drilling, Production and Workover, has the second of (1) with (2): 22 lb/gal, 1/4
/// in, in 11 lb/gal mud (36 and 23 of a viscometer) at 102 ft/min in 12 1/4 by 5 in: 63 cP, 24.55 ft/min.
///
/// Inclination I, rotation and density (Rubiandini, SPE 57541, 1999). Cuttings move at u = V - F v_s along the hole,
///   F = 1 + min(I, 45 deg) (600 rpm - N) (3 lb/gal + rho)/202500        (deg, rpm, lb/gal; N at most 600 rpm).           (3)
///
/// Need. The flow carries a rate of penetration R at the speed (Larsen, Pilehvari and Azar, SPE 25872, in SPE Drilling &
/// Completion 12 (1997), in ft/s and ft/h)
///   u_R = (A_h/A) / (0.64 + 18.16/R),      critical speed V_R = u_R + F v_s,                                             (4)
/// A_h the hole's area, A that open to the flow. (4) says that at the speed u the flow holds the volume share of cuttings
///   c_e = 0.00505/(1 - 0.64 u A/A_h) (u in ft/s),  0 for u <= 0, here at most 5 %.                                       (5)
///
/// Bed. What is above c_e settles, and what is below it is taken up from the bed, with the speed v_s sin I across the hole, as of
/// sediments in rivers (deposition v_s c, erosion v_s c_e; Celik and Rodi, J. Hydraulic Eng. 114 (1988)):
///   d(suspended)/dt per length = -v_s sin I (D_h) (c - c_e).                                                             (6)
/// So a bed grows until the speed in the area that it leaves is the critical one, Larsen's equilibrium bed. A bed forms from an
/// inclination of 35 deg on (Tomren, Iyoho and Azar, SPE Drilling Eng. 1 (1986)); below that all stays in the flow.
///
/// Drag of a bed on a pipe of diameter D that lies on the low side: the bed's weight presses on what it covers like a fluid, and
/// rubs with the friction coefficient m, per length
///   F_b = m g dr (1 - porosity) sin I D ((h - D/2) a + D/2 sin a),   cos a = 1 - 2 h/D,  a = pi for h >= D,              (7)
/// h the bed's height above the hole's lowest line.
///
/// Uncertainty. Larsen's own slip for 55 to 90 deg, without rotation, gives critical speeds 1.7 to 2.3 times (4) with (3) in
/// holes of 6 to 8 1/2 in, 2 to 4 times in 12 1/4 in, and grows with the mud's viscosity where Moore's falls.
///
/// Not in it: sliding of a bed as a whole between 35 and 60 deg, cuttings that fall back while the pump rests, a gel that holds
/// them, sizes other than the mean one, wear of cuttings. Fitted: (4) for 55 to 90 deg, 50 to 90 ft/h, (3) to the same data.
namespace drill_rig_sim
{
constexpr double bed_inclination = 0.6108652381980153;  ///< 35 deg: from here on a bed forms [rad]
constexpr double most_carried = 0.05;                   ///< of (5) [-]

struct CuttingsSpec
{
  double density = 2600.0;  ///< rho_s [kg/m3]
  double size = 0.005;      ///< d [m]
  double porosity = 0.4;    ///< of a bed [-]
  double friction = 0.5;    ///< m, of a bed on pipe [-]
};

/// Mud with cuttings.
struct CuttingsFluid
{
  Rheology curve;
  double density = 0.0;  ///< of the mud, > 0 and below the cuttings' [kg/m3]
  CuttingsSpec cuttings;
};

/// mu of (2) at a mean speed > 0 [m/s], [Pa s].
double apparent_viscosity(const Rheology& mud, const Passage& annulus, double speed) noexcept;

/// v_s of (1) [m/s].
/// @param viscosity  mu > 0 [Pa s]
double slip_speed(const CuttingsFluid& fluid, double viscosity) noexcept;

/// F of (3).
/// @param inclination  I [rad]
/// @param rotation     of the string, of any sign [rad/s]
double slip_factor(double inclination, double rotation, double mud_density) noexcept;

/// c_e of (5).
/// @param speed  u [m/s]
/// @param open   A/A_h
double carried_share(double speed, double open) noexcept;

/// A stretch of annulus.
struct CuttingsCell
{
  Passage passage;           ///< concentric
  double length = 0.0;       ///< >= 0 [m]
  double inclination = 0.0;  ///< [rad]
};

/// Critical speed V_R of (4), v_s at that speed [m/s].
/// @param rop       R > 0 [m/s]
/// @param rotation  [rad/s]
double critical_cuttings_speed(const CuttingsFluid& fluid, const CuttingsCell& cell, double rop, double rotation) noexcept;

/// What flows through a cell during a step.
struct CuttingsFlow
{
  double flow = 0.0;      ///< of mud, >= 0, up [m3/s]
  double rotation = 0.0;  ///< [rad/s]
  double time = 0.0;      ///< > 0 [s]
};

/// Volumes of rock in a cell, without the mud between [m3].
struct CuttingsContent
{
  double suspended = 0.0, bed = 0.0;
};

/// One step of a cell by implicit Euler, first transport, then (6): stable at any step, no volume is lost. What the flow cannot
/// carry stays until it fills the cell as a bed would; then it is pushed on.
/// @param inflow  volume of rock that comes from below [m3]
/// @return volume that leaves at the upper end [m3]
double advance_cell(const CuttingsFluid& fluid, const CuttingsCell& cell, const CuttingsFlow& flow, double inflow,
                    CuttingsContent& content) noexcept;

/// Area that a bed leaves open to the flow [m2].
double open_area(const CuttingsFluid& fluid, const CuttingsCell& cell, double bed) noexcept;

/// Cross section of a bed of height h in a hole, pipe on the low side [m2].
double bed_section(const Passage& passage, double height) noexcept;
/// h of a bed of that cross section, at most the hole's diameter [m].
double bed_height(const Passage& passage, double section) noexcept;

/// F_b of (7) without its factor sin I [N/m].
double bed_drag(const CuttingsFluid& fluid, double diameter, double height) noexcept;

}  // namespace drill_rig_sim

#endif
