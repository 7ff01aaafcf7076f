// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_HYDRAULICS_PRESSURE_WAVES_H
#define DRILL_RIG_SIM_HYDRAULICS_PRESSURE_WAVES_H

#include <cstddef>
#include <vector>

#include "drill_rig_sim/hydraulics/hydraulics.h"

/// Pressure waves in bore and annulus (`mud.pressure_waves`): the mud's inertia and the time that a change of pressure or flow
/// takes along the pipe, instead of the two volumes of hydraulics.h. p is the pressure above the hydrostatic one, Q the flow
/// towards bit and flow line, s the length in that direction.
///
///   dp/dt + (rho a^2/A) dQ/ds = 0,      (rho/A) dQ/dt + dp/ds + F(Q) = 0,      a = sqrt(beta/rho)                        (1)
///
/// a is the wave's speed, rho the mud's density, A the section's area, F the pressure gradient of friction. beta is
/// `mud.bulk_modulus`, in which the pipe's elasticity is already: for 5 in 19.5 lb/ft pipe 1/beta = 1/beta_mud + d/(E e)
/// (Korteweg; d bore, e wall, E steel's modulus) is 13 % more than a mud's own. So (1) stores as much mud as the two volumes do.
///
/// Method of characteristics at the Courant number 1 (Wylie and Streeter, Fluid Transients in Systems, 1993, ch. 3). Bore and
/// annulus are divided into cells of one length a h, h the tick; the waves
///   p + Z Q  (with the flow)    and    p - Z Q  (against it),    Z = rho a/A,                                            (2)
/// cross a cell unchanged in a tick. So fronts stay sharp: there is no numerical damping or dispersion. Friction acts at the
/// cells' ends, implicit, each by the loss law of its own section (section_losses.h): between waves f and b that arrive
///   f - b = (Z_1 + Z_2) Q + R(Q)                                                                                         (3)
/// gives Q. A tick stores exactly what flows into a cell less what flows out, friction only takes energy, and steady flow loses
/// what the section's law says.
///
/// Ends.
/// - Pump: each of its pistons delivers as its crank turns (pump_strokes.h). A gas dampener beside it takes the difference
///   to the string's flow, isothermal: V = V_0 p_0/p above its precharge p_0, pressures absolute, V_0 below. Relief valve as in
///   hydraulics.h. The pump's valves let mud in from the tanks where the pressure would fall below 0.
/// - Bit: nozzles, motor, float, cuttings and plug as in hydraulics.h. A pulser of the MWD loses P (Q/Q_n)^2 more while closed.
///   Where a wave takes the annulus's pressure below 0 it draws mud through the nozzles. A string that is pulled does not: of a
///   pressure below 0 the steady swab does not count (hydraulics.h).
/// - Flow line: p = 0.
/// String that moves at v: along each section it displaces A_o v, all at one speed, and clings as in section_losses.h. So surge
/// and swab have the mud's inertia, rho a A_o v/A at first.
/// Gel as in hydraulics.h, along the way; yield stress as the tables have it, a flow in the bore below their creep stands.
///
/// Cells. As many as make h 30 ms or the bore 50 cells, h at least 5 ms, two cells at least; what the pump delivers is its mean
/// over h, so that a ripple of 5 Hz is 4 % too low at 30 ms, one of 8 Hz 9 %; along the annulus the wave's way is
/// wrong by at most half a cell. A cell has the volume of its stretch of string and hole; sections shorter than it are averaged.
///
/// Limits: friction is that of steady flow (unsteady friction damps fast waves more); mud that boils or lets air in below its
/// vapour pressure is not modelled; the lift of the string's elements follows the pressure at the bit (mud_circuit.h); values are
/// held within a tick.
namespace drill_rig_sim
{
/// The file's mud.pressure_waves.
struct PressureWavesSpec
{
  int cylinders = 3;                 ///< of the pump, evenly spaced; 0: no ripple
  double dampener_volume = 0.0757;   ///< V_0; 0: no dampener [m3]
  double dampener_pressure = 4.5e6;  ///< p_0, gauge [Pa]
  double pulse_height = 0.0;         ///< P; 0: no pulses [Pa]
  double pulse_period = 2.0;         ///< of the pulses, closed for half of it [s]
};

/// A stretch of bore or annulus of one section, in the direction of the flow.
struct WaveStretch
{
  double length = 0.0;          ///< [m]
  double volume = 0.0;          ///< [m3]
  double outside = 0.0;         ///< A_o of the string in the annulus; 0 in the bore [m2]
  double gel = 0.0;             ///< that it holds after long rest [Pa]
  std::size_t section = 0;      ///< number of its loss law
  double section_length = 1.0;  ///< that the law is for [m]
};

/// Cells of bore or annulus.
struct WaveLine
{
  struct Share
  {
    std::size_t section = 0;
    double share = 0.0;  ///< of the section's loss
  };
  /// Between two cells, or an end.
  struct Node
  {
    std::size_t first = 0, last = 0;  ///< its entries of `shares`, [first, last)
    double gel = 0.0;                 ///< [Pa]
  };

  std::vector<double> impedance;  ///< Z, by cell: tick over capacity [Pa s/m3]
  std::vector<double> outside;    ///< A_o, by cell [m2]
  std::vector<Node> nodes;        ///< one more than cells
  std::vector<Share> shares;

  std::size_t cells() const noexcept { return impedance.size(); }
};

/// What does not change in a run. Empty without mud.pressure_waves.
struct PressureWaves
{
  PressureWavesSpec spec;
  double tick = 0.0;                                 ///< h [s]
  WaveLine bore;                                     ///< from the top drive to the bit
  WaveLine annulus;                                  ///< from the bit to the flow line
  double density = 0.0;                              ///< [kg/m3]
  std::vector<LossTable> bore_losses;                ///< by section
  std::vector<std::size_t> bore_cell, annulus_cell;  ///< of the elements' middles, bit first; no_cell above the rotary table

  static constexpr std::size_t no_cell = static_cast<std::size_t>(-1);
  bool any() const noexcept { return tick > 0.0; }
};

struct PressureWaveState
{
  double time = 0.0;           ///< that the waves have reached [s]
  double strokes = 0.0;        ///< of the pump, then
  double gas = 0.0;            ///< volume in the dampener [m3]
  double pump_pressure = 0.0;  ///< [Pa]
  double bit_flow = 0.0;       ///< [m3/s]
  double bit_pressure = 0.0;   ///< in the annulus at the bit [Pa]
  double return_flow = 0.0;    ///< [m3/s]
  bool relief_open = false;
  // by cell, at the end that it enters by: p + Z Q with the flow, p - Z Q against it [Pa]
  std::vector<double> bore_with, bore_against, annulus_with, annulus_against;

  template <class V>
  void visit(V& v)
  {
    v("time", time);
    v("strokes", strokes);
    v("gas", gas);
    v("pump_pressure", pump_pressure);
    v("bit_flow", bit_flow);
    v("bit_pressure", bit_pressure);
    v("return_flow", return_flow);
    v("relief_open", relief_open);
    v("bore_with", bore_with);
    v("bore_against", bore_against);
    v("annulus_with", annulus_with);
    v("annulus_against", annulus_against);
  }

  /// Means of a cell [Pa].
  double in_bore(std::size_t cell) const noexcept { return 0.5 * (bore_with[cell] + bore_against[cell]); }
  double in_annulus(std::size_t cell) const noexcept { return 0.5 * (annulus_with[cell] + annulus_against[cell]); }
};

/// h for a bore of a length [m] and a wave speed [m/s], [s].
double wave_tick(double length, double wave_speed) noexcept;

/// @param stretches  in the direction of the flow, at least one
/// @param cells      at least 2
WaveLine wave_line(const std::vector<WaveStretch>& stretches, std::size_t cells, double tick, double bulk_modulus);

/// State of mud at rest at a time [s]; of no waves an empty one.
PressureWaveState waves_at_rest(const PressureWaves& waves, double time, double strokes);

/// Mud in bore and annulus above what they hold at rest [m3].
double stored_mud(const PressureWaves& waves, const PressureWaveState& state) noexcept;

/// What acts on the waves in a step.
struct WaveLoads
{
  double motor_pressure = 0.0;   ///< as in advance_hydraulics [Pa]
  double displaced = 0.0;        ///< A_m v of section_losses.h [m3/s]
  double string_speed = 0.0;     ///< v, + down [m/s]
  MudWays ways;                  ///< without leak and air
  double leak_area = 0.0;        ///< of a hole in the string [m2]
  std::size_t leak_element = 0;  ///< where it is
};

/// advance_hydraulics() with pressure waves: pump, waves and gel go on by a step [s] from a time [s]. Waves that a rejected step
/// has taken on wait for the time to follow.
void advance_pressure_waves(const MudPumpSpec& pump, const HydraulicCircuit& circuit, const PressureWaves& waves,
                            double commanded, const WaveLoads& loads, double time, double step, double& flow,
                            HydraulicState& state, PressureWaveState& wave_state) noexcept;

}  // namespace drill_rig_sim

#endif
