#include "drill_rig_sim/rig/hydraulics.h"

#include <algorithm>
#include <cmath>

namespace drill_rig_sim
{
double advance_hydraulics(const MudPumpSpec& spec, double commanded, double motor_pressure, double step, HydraulicState& state) noexcept
{
  state.pump_flow = advance_pump(spec, state.pump_flow, commanded, step);
  const double flow = state.pump_flow;
  const double wanted = flow > 0.0 ? spec.pressure_coefficient * flow * flow + motor_pressure : 0.0;
  state.relief_open = wanted > spec.relief_pressure;
  state.stand_pipe_pressure = std::min(wanted, spec.relief_pressure);
  if (!state.relief_open) return flow;
  const double left = std::max(0.0, spec.relief_pressure - motor_pressure);  // for the losses
  return spec.pressure_coefficient > 0.0 ? std::min(flow, std::sqrt(left / spec.pressure_coefficient)) : 0.0;
}

}  // namespace drill_rig_sim
