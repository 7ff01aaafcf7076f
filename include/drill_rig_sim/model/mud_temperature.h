// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_MODEL_MUD_TEMPERATURE_H
#define DRILL_RIG_SIM_MODEL_MUD_TEMPERATURE_H

#include "drill_rig_sim/model/model.h"
#include "drill_rig_sim/model/state.h"

/// Temperature of the mud between pump and flow line, where the scene has mud.temperature: the balance of heat of
/// hydraulics/mud_heat.h in some hundred cells of one length along the hole, once a second.
///
/// - Flow is the mean through the bit over the second. The string lies in the cells as its unstretched lengths do; the cells
///   keep their temperature when it moves. Below the bit mud rests.
/// - Friction of the mud heats it where it loses pressure: bore and annulus by element, nozzles and motor at the bit.
/// - Losses: each section of bore and annulus has the means of its factor on the flow curve and of its density along its length
///   (warm_mud.h, loss_family.h). So laminar losses are exact, turbulent ones, which go with the fifth root of the factor, within
///   1 % where it ranges over a factor of 3 in a section.
/// - Weight: rho of warm_mud.h at the hydrostatic pressure, integrated over the true vertical depth down to the bit. ECD and
///   stand-pipe pressure follow (hydraulics.h).
///
/// The temperature at the bit is that of the annulus's cells around it, by the difference from the ground: mud from the bore
/// reaches it as it replaces that of the lowest cell, in some 10 s to a minute.
///
/// At the start all has the ground's undisturbed temperature; with `circulated`, mud has been pumped at the pump's largest flow
/// for that time since. Cells are a two-hundredth of the hole long, at least 10 m. There is room for 1 km of new hole; beyond it
/// the last cell grows.
///
/// Not in it: buoyancy by the density's change, 0.2 % of the string's weight in air for each per cent of it; damping of the
/// string, gel, slip of cuttings by the warm mud's flow curve.
namespace drill_rig_sim
{
constexpr double temperature_period = 1.0;  ///< [s]

/// Gives a state without temperatures its cells, and pressures at rest; nothing without mud.temperature.
void begin_temperature(const Model& model, State& state);
/// After an accepted step [s]: collects, and once a second advances the cells. Does not allocate.
void advance_temperature(const Model& model, double step, State& state) noexcept;
/// After the string was changed: the losses of the new one. Allocates.
void renew_temperature(const Model& model, State& state);
/// Pumps at a flow [m3/s] for a time [s], with the string where it is.
void circulate(const Model& model, double flow, double time, State& state) noexcept;
/// Whether a state's temperatures are of this model's hole and string.
bool fits_temperature(const Model& model, const TemperatureState& temperature) noexcept;

/// Over what the reference's density weighs, of all that is not friction in the annulus at the bit: cuttings and temperature
/// [Pa].
inline double annulus_load(const State& state) noexcept
{
  return state.cuttings.load + state.temperature.heads.annulus;
}

}  // namespace drill_rig_sim

#endif
