#ifndef DRILL_RIG_SIM_RIG_MUD_PUMP_H
#define DRILL_RIG_SIM_RIG_MUD_PUMP_H

#include <algorithm>

namespace drill_rig_sim
{
struct MudPumpSpec
{
  double max_flow = 0.06;             ///< [m3/s]
  double pressure_coefficient = 4e9;  ///< stand-pipe pressure / flow^2 [Pa s2/m6]
};

/// Flow that the pump delivers for a command: clamped to 0 .. max_flow [m3/s]. Follows at once: no ramp, no compressibility.
inline double pump_flow(const MudPumpSpec& spec, double commanded) noexcept
{
  return std::clamp(commanded, 0.0, spec.max_flow);
}

/// Stand-pipe pressure [Pa]: turbulent losses, pressure_coefficient flow^2, plus the motor's differential pressure [Pa].
inline double stand_pipe_pressure(const MudPumpSpec& spec, double flow, double differential_pressure) noexcept
{
  return spec.pressure_coefficient * flow * flow + differential_pressure;
}

}  // namespace drill_rig_sim

#endif
