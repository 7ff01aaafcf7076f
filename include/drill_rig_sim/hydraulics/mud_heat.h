// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_HYDRAULICS_MUD_HEAT_H
#define DRILL_RIG_SIM_HYDRAULICS_MUD_HEAT_H

#include <array>
#include <cstddef>
#include <vector>

#include "drill_rig_sim/hydraulics/warm_mud.h"

/// Temperature of the mud along the hole: bore and annulus exchange heat with each other and with the rock, by cells of the hole.
///
///   C_b dT_b/dt = W (T_b,above - T_b) + H_p (M_a - M_b) + S_b                                                            (1)
///   C_a dT_a/dt = W (T_a,below - T_a) + H_p (M_b - M_a) + H_w (T_1 - M_a) + S_a                                          (2)
///   C_k dT_k/dt = H_k (T_k-1 - T_k) + H_k+1 (T_k+1 - T_k),    k = 1 ... rings of rock, T_0 = M_a                          (3)
///
/// T_b and T_a are the temperatures at a cell's outlets, its lower end in the bore, its upper end in the annulus, and M those
/// that exchange heat:
///   M = (1 - theta) T + theta T_inlet,    theta = 1/N - 1/(e^N - 1),    N = sum of H over W                              (4)
/// N is H_p/W in the bore and (H_p + H_w)/W in the annulus; at rest theta is 0. So steady profiles are of second order in the
/// cells' length, and no coefficient changes its sign at any flow (the exponential scheme, Patankar, Numerical Heat Transfer and
/// Fluid Flow, 1980, sec. 5.2).
///
/// W = rho c Q is the heat that the flow carries per kelvin; mud enters at T_i, and the annulus from the bore with what bit and
/// motor add. H_p = U_p times the string's outside. C_b has the pipe's steel in it. S is the power that friction of the mud
/// dissipates.
///
/// Rock: rings around the hole whose edges lie at radii r_w x_k; conduction along the hole is left out (Ramey, J. Pet. Tech. 14
/// (1962) 427-435). The wall is a film and the inner half of the first ring; the outermost edge has the ground's undisturbed
/// temperature. So any history of the flow is followed, where a time function holds for one that began once. Against the
/// exact solution of constant flux (Carslaw and Jaeger, Conduction of Heat in Solids, 1959, sec. 13.5), which Ramey's and Hasan
/// and Kabir's time functions are fitted to, the wall's temperature is within 3 % from t_D = a t/r_w^2 = 0.05 on (8 minutes in an
/// 8 1/2 in hole) and within 1.5 % from 0.4 to 1000 (4 months).
///
/// In steady flow with a constant T_1, (1) and (2) are those of Holmes and Swift (J. Pet. Tech. 22 (1970) 670-674), whose
/// solution is two exponentials.
///
/// Implicit Euler: stable at any step. Rock is eliminated ring by ring, bore and annulus cell by cell, so that a step is a walk
/// down and one up. What flows in, is dissipated and comes through the outermost edge is what is stored, to rounding.
///
/// Not in it: heat of the bit's cutting and of pipe that rubs (100 kW are 0.7 K at 30 L/s), heating by compression (up to 13 % of
/// the friction's), casing, cement, sea and riser, flow by the string's own motion, coefficients that depend on the flow.
namespace drill_rig_sim
{
constexpr std::size_t rock_rings = 12;
/// x_k, edges of the rings over the hole's radius: the first a 33rd of it wide, each 1.9 times as wide as the one before, to 75.
constexpr double first_ring = 0.03, ring_growth = 1.9;
constexpr double steel_heat = 470.0;  ///< of the pipe's steel [J/(kg K)]

/// Rock of one metre of hole.
struct RockGrid
{
  double wall = 0.0;                                ///< H between film and first ring [W/(m K)]
  std::array<double, rock_rings> conductance = {};  ///< between a ring and the one outside it, the last to its edge [W/(m K)]
  std::array<double, rock_rings> capacity = {};     ///< over r_w^2 [J/(m3 K)]
};
RockGrid rock_grid(const MudTemperatureSpec& spec);

/// A stretch of the hole.
struct HeatCell
{
  double length = 0.0;          ///< > 0 [m]
  double hole_radius = 0.0;     ///< r_w [m]
  double ground = 0.0;          ///< undisturbed temperature [degC]
  double bore_volume = 0.0;     ///< of mud in the string [m3]
  double annulus_volume = 0.0;  ///< of mud around it, and of the hole below the bit [m3]
  double steel = 0.0;           ///< mass of pipe [kg]
  double pipe_surface = 0.0;    ///< the string's outside [m2]
  double bore_power = 0.0;      ///< dissipated in the bore [W]
  double annulus_power = 0.0;   ///< and in the annulus [W]
};

/// What flows past the cells during a step.
struct HeatFlow
{
  double flow = 0.0;       ///< Q >= 0 [m3/s]
  double bit_power = 0.0;  ///< dissipated by bit and motor [W]
  double step = 0.0;       ///< [s]
};

/// Temperatures by cell, downwards [degC].
struct HeatState
{
  std::vector<double> bore, annulus;            ///< at the cells' outlets
  std::vector<double> bore_mean, annulus_mean;  ///< M of (4)
  std::vector<double> rock;                     ///< rings of one cell after those of another, from the wall outwards

  template <class V>
  void visit(V& v)
  {
    v("bore", bore);
    v("annulus", annulus);
    v("bore_mean", bore_mean);
    v("annulus_mean", annulus_mean);
    v("rock", rock);
  }
};

/// What a mud carries.
struct HeatMud
{
  MudTemperatureSpec spec;
  RockGrid rock;
  double density = 0.0;  ///< rho_i [kg/m3]

  double capacity() const noexcept { return density * spec.heat_capacity; }  ///< [J/(m3 K)]
};

constexpr std::size_t most_heat_cells = 512;

/// One step of cells from the flow line down. Does not allocate.
/// @param cells  at most most_heat_cells
/// @param count  of cells
/// @param flown  number of cells from the top whose mud flows, at least 1: down to the bit's; it rests below
void advance_heat(const HeatMud& mud, const HeatCell* cells, std::size_t count, std::size_t flown, const HeatFlow& flow,
                  HeatState& state) noexcept;

/// Heat in mud, steel and rock of the cells, above 0 degC [J].
double stored_heat(const HeatMud& mud, const HeatCell* cells, std::size_t count, const HeatState& state) noexcept;
/// Heat that comes from the ground through the outermost edges [W].
double heat_from_ground(const HeatMud& mud, const HeatCell* cells, std::size_t count, const HeatState& state) noexcept;

}  // namespace drill_rig_sim

#endif
