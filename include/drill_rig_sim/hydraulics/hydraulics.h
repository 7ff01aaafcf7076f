// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_HYDRAULICS_HYDRAULICS_H
#define DRILL_RIG_SIM_HYDRAULICS_HYDRAULICS_H

#include "drill_rig_sim/hydraulics/mud_pump.h"
#include "drill_rig_sim/hydraulics/section_losses.h"

/// The mud's way from the pump through string, motor and bit, and up the annulus: two compressible volumes, the string's bore and
/// the annulus, each at one pressure above the hydrostatic one, and the resistances behind them.
///
///   C_p dp_p/dt = Q_pump - Q_relief - Q,    p_p - p_a = P_i (Q/Q_n)^m + D(Q) + G_p,      C = V/beta
///   C_a dp_a/dt = Q + Q_s - Q_out,          p_a       = P_a (Q_out/Q_n)^m + G_a,         the same both ways
///
/// p_p the stand pipe's pressure, p_a that of the annulus at the bit, Q the flow through motor and bit; P_i, P_a the losses in
/// string and bit and in the annulus at the pump's largest flow Q_n; D what the motor's torque needs (hydraulics/mud_motor.h); G
/// what the mud's gel holds, the most that it can while mud moves, and whatever is there below that. No flow backwards: a float
/// valve above the bit. Q_s is what the string sets in motion as it runs in, < 0 where it is pulled (hydraulics/mud_circuit.h):
/// surge and swab. Pulled, p_a may fall below the hydrostatic pressure; the bit's nozzles, too narrow to matter, then let no more
/// through than the pump sends: the string counts as closed both ways, as is usual (Lapeyrouse; Moore, Drilling Practices Manual,
/// 1974, takes swab as the opposite of surge). Two volumes without the mud's inertia: the model of Kaasa, Stamnes, Aamo and
/// Imsland, SPE Drilling & Completion 27 (2012) 127-138, whose annulus ends at a choke and ours in the open. Waves in the mud,
/// seconds in long wells, are an option (pressure_waves.h).
///
/// With a rheology of the mud (rheology.h) the losses are those of its law by section (section_losses.h) instead:
///   p_p - p_a = P_l(Q) + P_b(Q) + P_n(Q) + D(Q) + G_p,   p_a = sum of P(V) over the annulus's sections + G_a,
/// P_l, P_b, P_n of surface lines, bore and nozzles, V the mud's speed with the string's own motion in it, each section by
/// itself. Q_s is then what the string displaces, C_a dp_a/dt = Q - (Q_out - Q_s). G holds what the gel is stronger than the
/// yield stress, which the law has already.
///
/// Gel: mud that stands holds p = 4 tau L/d in a bore, 4 tau L/(D_h - D) in an annulus (gel L/(300 d) in psi, lb/100 ft2, ft, in:
/// Lapeyrouse, Formulas and Calculations for Drilling, Production and Workover, 2nd ed., p. 79), tau the strength after ten
/// minutes' rest. It grows with gel_time towards that, and breaks in each volume as mud leaves it, over gel_break_volume, by the
/// pump or the string; mud that would take longer than gel_time for that volume counts as standing.
///
/// A string that is not full (mud.fill): what the pump delivers fills it first, and nothing reaches the bit, without a pressure,
/// until it is full.
///
/// Cuttings in the annulus (model/hole_cleaning.h): p_a is larger by their weight W, whatever moves, and the losses of a law grow
/// by a factor where their bed narrows the annulus, p_a = W + f P(V) + G_a. Rotation of the string is a factor too
/// (flow_losses.h).
///
/// Temperature (`mud.temperature`, model/mud_temperature.h): the losses of the law are those of each section's mud
/// (loss_family.h). With H_b and H_a, by which bore and annulus weigh more than the reference at the bit,
///   p_p + H_b - p_a = losses,      p_a = H_a + P(V) + G_a.
/// A bore that is heavier than the annulus pulls the stand pipe's pressure down to 0 at most: that its mud would sink in the
/// string while the pump rests is left out.
///
/// Relief valve, by the pump: the stand pipe does not exceed relief_pressure, and what is too much goes back to the tanks.
///
/// Implicit Euler, volume by volume from the pump on, each a scalar equation with one root: stable at any step, though resistance
/// vanishes with flow, and no mud is lost. The annulus pushes back with its pressure before the step.
namespace drill_rig_sim
{
constexpr double gel_time = 200.0;          ///< of growth at rest: 95 % after ten minutes [s]
constexpr double full_bore = 1e6;           ///< longer than any string [m]
constexpr double gel_break_volume = 0.005;  ///< that passes while it falls to 1/e: some five diameters of a bore of 0.1 m [m3]

/// A volume and the resistance behind it.
struct HydraulicVolume
{
  double capacity = 0.0;  ///< V/beta [m3/Pa]
  double loss = 0.0;      ///< at nominal flow [Pa]
  double gel = 0.0;       ///< held by mud at rest that has stood for long [Pa]
};

/// What does not change in a run.
struct HydraulicCircuit
{
  HydraulicVolume bore, annulus;
  double nominal_flow = 0.06;  ///< Q_n > 0 [m3/s]
  double exponent = 2.0;       ///< m in [1, 2]
  SectionLosses law;           ///< instead of losses and exponent, where the scene gives a rheology
};

struct HydraulicState
{
  double pump_flow = 0.0;            ///< that the pump delivers, strokes times displacement [m3/s]
  double strokes = 0.0;              ///< of the pump since the start [-]
  double stand_pipe_pressure = 0.0;  ///< p_p [Pa]
  double annulus_pressure = 0.0;     ///< p_a, at the bit, above the hydrostatic one; < 0: swab [Pa]
  double return_flow = 0.0;          ///< Q_out, that the annulus's losses see: of mud along pipe and wall, < 0 down [m3/s]
  double bore_gel = 1.0;             ///< share of its strength; at the start the mud has stood for long
  double annulus_gel = 1.0;          ///< the same
  bool relief_open = false;
  double filled = 0.0;  ///< volume that the pump has put into a string that was not full, since the crew last filled it [m3]
  double bore_top =
      full_bore;  ///< there is mud in the string up to here above the bit's face, unstretched (model/bore_fill.h) [m]

  template <class V>
  void visit(V& v)
  {
    v("pump_flow", pump_flow);
    v("strokes", strokes);
    v("stand_pipe_pressure", stand_pipe_pressure);
    v("annulus_pressure", annulus_pressure);
    v("return_flow", return_flow);
    v("bore_gel", bore_gel);
    v("annulus_gel", annulus_gel);
    v("relief_open", relief_open);
    v("filled", filled);
    v("bore_top", bore_top);
  }
};

/// What leaves a volume, and what is left in it, after a step.
struct Outflow
{
  double flow = 0.0;      ///< [m3/s]
  double pressure = 0.0;  ///< [Pa]
};

/// What holds the mud back behind a volume.
struct HydraulicResistance
{
  double back = 0.0;   ///< pressure there [Pa]
  double loss = 0.0;   ///< at nominal flow [Pa]
  double gel = 0.0;    ///< [Pa]
  double motor = 0.0;  ///< >= 0, D above the motor's leakage [Pa]
  double nominal_flow = 0.06;
  double exponent = 2.0;
  const SectionLosses* law = nullptr;  ///< instead of loss and exponent
  const LossPlaces* warm = nullptr;    ///< of the mud in it by temperature

  /// Pressure that a flow > 0 needs [Pa], and its derivative [Pa s/m3].
  double pressure(double flow) const noexcept;
  double slope(double flow) const noexcept;
};

/// One step of a volume: p + (step/capacity) (inflow - Q) = r.pressure(Q), Q >= 0, or Q = 0 where that cannot be. Volumes of
/// capacity 0 let everything through.
/// @param pressure  p, at the start of the step [Pa]
/// @param step      > 0 [s]
/// @param guess     near Q [m3/s]; where it is Q to the last digits, it is the answer
Outflow outflow(double capacity, double pressure, double inflow, double step, const HydraulicResistance& r,
                double guess) noexcept;
/// The same from a volume whose pressure is held.
double outflow_at(double pressure, const HydraulicResistance& r, double guess) noexcept;

/// What temperature and pressure make of the weight of the mud down to the bit, over that of the reference [Pa].
struct WarmHeads
{
  double bore = 0.0, annulus = 0.0;

  template <class V>
  void visit(V& v)
  {
    v("bore", bore);
    v("annulus", annulus);
  }
};

/// Ways that the mud should not have, and those that are closed to it.
struct MudWays
{
  double plug =
      0.0;  ///< what packed cuttings hold back in the annulus while mud is pumped; what the string displaces seeps through [Pa]
  double leak = 0.0;  ///< through a hole in the string, past motor and bit into the annulus [m3/s]
  double air = 0.0;   ///< volume in the string that the pump fills first [m3]
  double load =
      0.0;  ///< by which cuttings and temperature change the annulus's weight on the bit's depth, moving or at rest [Pa]
  double narrowing = 1.0;            ///< factor of a bed of cuttings and of rotation on the annulus's losses by law [-]
  const LossPlaces* warm = nullptr;  ///< mud by temperature; null: none
  WarmHeads heads = {};              ///< of it; that of the annulus is part of load
};

/// Flow through a hole of an area [m2] by a pressure [Pa]: 0.61 A sqrt(2 p/rho), Torricelli's with a sharp edge's contraction,
/// pi/(pi + 2) (Kirchhoff) [m3/s]; none backwards, and none of a mud without mass.
double orifice_flow(double area, double pressure, double density) noexcept;

/// One step h [s] of the circuit.
/// @param commanded       of the pump [m3/s]
/// @param motor_pressure  that the mud motor's torque needs, >= 0 [Pa]
/// @param displaced       Q_s [m3/s]
/// @param flow            through motor and bit; in and out [m3/s]
/// @param ways            the leak at most what the bore holds
void advance_hydraulics(const MudPumpSpec& spec, const HydraulicCircuit& circuit, double commanded, double motor_pressure,
                        double displaced, double step, double& flow, HydraulicState& state, const MudWays& ways = {}) noexcept;

/// Share of a gel's strength after a step [s] in which mud moved past it at a rate [m3/s].
double advance_gel(double gel, double flow, double step) noexcept;

/// Density of a mud at rest with the same pressure at the bit: density + p_a/(g depth) [kg/m3]; the mud's own within a metre of
/// the rotary table, where it would mean nothing.
/// @param depth  of the bit below the rotary table [m]
double equivalent_circulating_density(double density, double annulus_pressure, double depth) noexcept;

}  // namespace drill_rig_sim

#endif
