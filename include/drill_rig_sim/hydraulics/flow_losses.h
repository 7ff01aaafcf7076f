// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_HYDRAULICS_FLOW_LOSSES_H
#define DRILL_RIG_SIM_HYDRAULICS_FLOW_LOSSES_H

#include "drill_rig_sim/hydraulics/rheology.h"

/// What a mud of a rheology (rheology.h) loses on its way: in pipes, annuli and nozzles, and by a string that moves in it. SI
/// units throughout.
///
/// The gradient of a passage of hydraulic diameter d follows from the stress on its walls:
///   dp/ds = 4 tau_w/d,      d a bore's diameter, or D_h - D of an annulus.                                              (1)
///
/// Laminar. tau_w is the root of the mean speed of the exact profile, with a = tau_w - tau_y and m = 1/n,
///   bore:    V = d/(2 K^m) a^(1+m)/tau_w^3 (a^2/(3+m) + 2 tau_y a/(2+m) + tau_y^2/(1+m))                                (2)
///   annulus: V = d/(4 K^m) a^(1+m)/tau_w^2 (a/(2+m) + tau_y/(1+m))                                                      (3)
/// (Govier and Aziz, The Flow of Complex Mixtures in Pipes, 1972). n = 1 in (2) is Buckingham and Reiner's equation, tau_y = 0
/// the power law's, both Hagen and Poiseuille's. (3) takes the annulus as a slot: a Newtonian mud's is too high by 0.7 % at D/D_h
/// = 0.5, by 2.3 % at 0.3. API RP 13D writes the yield stress with the factor (4/3)^n in a bore and (3/2)^n in an annulus
/// instead, which is (2) and (3) where tau_w is much above tau_y, and up to a half too much at rest.
///
/// Reynolds number of Metzner and Reed (AIChE Journal 1 (1955) 434-440), as N_ReG of API RP 13D (5th ed., 2006, and later):
///   Re = 8 rho V^2/tau_w of laminar flow,      laminar up to Re_c = 3470 - 1370 n.                                      (4)
///
/// Turbulent, smooth walls (Dodge and Metzner as fitted by Schuh; API RP 13D):
///   f = a/Re'^b,  a = (log10 n' + 3.93)/50,  b = (1.75 - log10 n')/7,  tau_w = f rho V^2/2                              (5)
/// n' = d ln tau_w/d ln V is the slope of the laminar curve and Re' the number (4) of its tangent, as Metzner and Reed have it,
/// both at the stress of turbulent flow, for which that of the same mud without a yield stress stands (within 0.1 % of the one
/// that agrees with itself; at least the laminar stress). Of a power law n' = n. A yield stress counts little in it, as in
/// Bourgoyne's rule for Bingham muds (Re by the plastic viscosity: within 2 %). API RP 13D has n and (4) of the whole law in (5):
/// 2 to 5 % more for its usual muds, a third more for a Bingham mud of a high yield point. With the index of the 600 and 300 rpm
/// readings in (5), or with the power law through these, as before 2006, a bore loses less, for the shear rates on its walls are
/// larger: 3 % in the median of random muds, 13 % or more for one of 20.
///
/// Transitional: f = 16 Re/Re_c^2; all three joined by API RP 13D's
///   f_i = (f_transitional^-8 + f_turbulent^-8)^(-1/8),      f = (f_i^12 + f_laminar^12)^(1/12).                          (6)
///
/// Eccentric annulus, offset e of the pipe over the clearance: laminar and turbulent stresses times R (Haciislamoglu, PhD thesis,
/// Louisiana State University, 1989; Haciislamoglu and Cartalos, SPE 28304, 1994), r = D/D_h:
///   R_l = 1 - 0.072 e/n r^0.8454 - 1.5 e^2 sqrt(n) r^0.1852 + 0.96 e^3 sqrt(n) r^0.2527                                  (7)
///   R_t = 1 - 0.048 e/n r^0.8454 - 2/3 e^2 sqrt(n) r^0.1852 + 0.285 e^3 sqrt(n) r^0.2527                                 (8)
/// fitted for e up to 0.95, r from 0.3 to 0.9 and n from 0.4 to 1, in which n is held here.
///
/// Rotation of the string at N raises the losses of an eccentric annulus by inertia, and lowers those of a shear-thinning mud in
/// a concentric one, by some 10 to 30 %. No published fit covers both. The factor is measured instead, as on a rig before the
/// shoe is drilled: c at 120 rpm, assumed to be in proportion elsewhere,
///   1 + (c - 1) min(|N|, 240 rpm)/120 rpm.                                                                               (9)
///
/// Not in it: tool joints' own contractions, roughness.
namespace drill_rig_sim
{
/// The section that mud flows through: a bore of diameter `outer`, or between a hole of that diameter and a string.
struct Passage
{
  double outer = 0.0;         ///< d or D_h > 0 [m]
  double inner = 0.0;         ///< D; 0: a bore [m]
  double eccentricity = 0.0;  ///< e in [0, 1], 0: concentric

  double gap() const noexcept { return outer - inner; }  ///< hydraulic diameter [m]
  double area() const noexcept;                          ///< [m2]
};

/// Mean speed of laminar flow, (2) or (3), with a stress on the wall [Pa]; 0 up to the yield stress [m/s].
double laminar_speed(const Rheology& mud, const Passage& passage, double wall_stress) noexcept;

/// Stress on the wall of laminar, concentric flow at a mean speed > 0 [m/s], [Pa].
double laminar_wall_stress(const Rheology& mud, const Passage& passage, double speed) noexcept;

/// Re of (4) at a mean speed > 0 [m/s].
double reynolds_number(const Rheology& mud, double density, const Passage& passage, double speed) noexcept;

/// Re_c of (4).
double critical_reynolds_number(const Rheology& mud) noexcept;

/// Mean speed at which laminar flow ends [m/s]; infinite for a mud without mass.
double critical_speed(const Rheology& mud, double density, const Passage& passage) noexcept;

/// Stress on the wall at a mean speed >= 0 [m/s] in any regime, (6), [Pa]: that of the yield stress at rest. Grows with the speed
/// and has no jump.
double wall_stress(const Rheology& mud, double density, const Passage& passage, double speed) noexcept;

/// dp/ds (1) at a mean speed >= 0 [m/s], [Pa/m].
double pressure_gradient(const Rheology& mud, double density, const Passage& passage, double speed) noexcept;

/// R_l and R_t of (7) and (8).
struct EccentricShare
{
  double laminar = 1.0, turbulent = 1.0;
};
EccentricShare eccentric_share(const Rheology& mud, const Passage& annulus) noexcept;

/// Factor (9) on the losses of an annulus.
/// @param at_120_rpm  c
/// @param speed       N, of any sign [rad/s]
double rotation_factor(double at_120_rpm, double speed) noexcept;

/// Pressure drop of a bit's nozzles, rho Q^2/(2 (C_d A)^2), C_d = 0.95 (Eckel and Bielstein, 1951; Bourgoyne, Applied Drilling
/// Engineering, eq. 4.34) [Pa].
/// @param flow  Q [m3/s]
/// @param area  of all of them, > 0 [m2]
double nozzle_loss(double density, double flow, double area) noexcept;

/// K of mud that clings to a moving string (Burkhardt, J. Pet. Tech. 13 (1961) 595-605, his chart as fitted by Guo and Liu,
/// Applied Drilling Circulation Systems, 2011, eq. 2.81 and 2.82): 0.25 + 0.275 r in laminar flow, 0.41 + 0.1 r in turbulent. The
/// first is a Newtonian mud's within 0.02. Lapeyrouse has 0.45 for both.
/// @param ratio       D/D_h
/// @param turbulence  from 0, laminar, to 1
double clinging(double ratio, double turbulence) noexcept;
/// K of turbulent flow.
double clinging_constant(double ratio) noexcept;

/// Share of turbulence for clinging() at a speed [m/s]: from 0 at the critical speed to 1 at twice that.
double turbulence_at(double speed, double critical_speed) noexcept;

}  // namespace drill_rig_sim

#endif
