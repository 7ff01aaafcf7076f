// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_MATH_SHOWN_UNITS_H
#define DRILL_RIG_SIM_MATH_SHOWN_UNITS_H

/// THE place that says in which unit, and with how many decimals, a number is shown: by the runner's commands and by rviz's
/// console. drill_rig_sim/units.py says the same for Python. Messages and files stay in SI.
namespace drill_rig_sim
{
enum class UnitSystem
{
  si,
  oilfield
};

/// What a number measures.
enum class Dimension
{
  force,
  torque,
  rotation,     // speed of rotation
  penetration,  // rate of penetration
  pressure,
  specific_energy,
  flow,
  length,
  diameter,
  area,
  speed,
  angle,
  density,
  strokes,  // of a pump, per time
  force_per_length,
  mass,
  volume,
  dogleg,  // change of direction per length
  torsional_damping,
  torsional_stiffness,
  temperature,
  shear_stress,  // of mud
  viscosity,
  share,
  number,
  count
};

/// How a dimension is shown: shown = SI value * per_si + zero.
struct Unit
{
  const char* name;   // "" for a mere number
  double per_si;      // shown units in one SI unit (N, N m, rad/s, m/s, Pa, m3/s, m, m2, rad, kg/m3, 1/s, N/m, kg, m3, rad/m, N m
                      // s/rad, N m/rad, degC, Pa, Pa s)
  int decimals;       // that are shown
  double zero = 0.0;  // shown at 0 of the SI unit: 32 of degF
};

/// The unit of a dimension. Factors: math/unit_table.h.
const Unit& unit_of(Dimension dimension, UnitSystem system);
/// Name of the SI unit itself, as in the messages: "N", "rad/s"; "1" for a number.
const char* si_name(Dimension dimension);
/// From SI to what is shown.
double to_shown(double si, Dimension dimension, UnitSystem system);
/// From what is shown to SI.
double to_si(double shown, Dimension dimension, UnitSystem system);

}  // namespace drill_rig_sim

#endif
