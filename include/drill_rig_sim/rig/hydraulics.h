#ifndef DRILL_RIG_SIM_RIG_HYDRAULICS_H
#define DRILL_RIG_SIM_RIG_HYDRAULICS_H

#include "drill_rig_sim/rig/mud_pump.h"

/// The mud on its way from the pump through string, motor and bit.
///
/// Stand-pipe pressure: turbulent losses, pressure_coefficient Q^2, plus the motor's differential pressure, Q the flow through string and
/// motor. Beyond relief_pressure the relief valve by the pump opens: the stand pipe stays at it, and what the string does not take at that
/// pressure goes back to the tanks.
namespace drill_rig_sim
{
struct HydraulicState
{
  double pump_flow = 0.0;            ///< that the pump delivers, strokes times displacement [m3/s]
  double stand_pipe_pressure = 0.0;  ///< [Pa]
  bool relief_open = false;

  template <class V>
  void visit(V& v)
  {
    v("pump_flow", pump_flow);
    v("stand_pipe_pressure", stand_pipe_pressure);
    v("relief_open", relief_open);
  }
};

/// One step h [s]; returns the flow through string and motor at its end [m3/s].
/// @param commanded       of the pump [m3/s]
/// @param motor_pressure  that the mud motor's torque needs, >= 0 [Pa]
double advance_hydraulics(const MudPumpSpec& spec, double commanded, double motor_pressure, double step, HydraulicState& state) noexcept;

}  // namespace drill_rig_sim

#endif
