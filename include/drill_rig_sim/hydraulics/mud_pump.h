// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_HYDRAULICS_MUD_PUMP_H
#define DRILL_RIG_SIM_HYDRAULICS_MUD_PUMP_H

#include <algorithm>
#include <vector>

#include "drill_rig_sim/hydraulics/section_losses.h"

namespace drill_rig_sim
{
struct MudPumpSpec
{
  double max_flow = 0.06;   ///< [m3/s]
  double flow_ramp = 0.01;  ///< rate at which the pump's flow changes [m3/s2]
  double stroke_volume =
      0.0318;  ///< that a stroke delivers: of two triplexes side by side, 6 in liners and 12 in strokes, 95 % full [m3]
  double relief_pressure = 35e6;           ///< at which the relief valve opens [Pa]
  double trip_pressure = 0.0;              ///< at which the pump stops [Pa]; 0: none
  double pressure_coefficient = 4e9;       ///< losses from pump to flow line at max_flow / max_flow^2 [Pa s2/m6]
  double loss_exponent = 2.0;              ///< m of losses ~ Q^m [-]
  std::vector<SurfaceLine> surface_lines;  ///< between pump and string, of a mud with a rheology
};

/// Flow that the pump delivers after a step h [s]: it goes to the command, clamped to 0 .. max_flow, at flow_ramp [m3/s].
/// @param flow  at the start of the step [m3/s]
inline double advance_pump(const MudPumpSpec& spec, double flow, double commanded, double step) noexcept
{
  const double most = spec.flow_ramp * step;
  return flow + std::clamp(std::clamp(commanded, 0.0, spec.max_flow) - flow, -most, most);
}

}  // namespace drill_rig_sim

#endif
