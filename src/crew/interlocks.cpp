// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/crew/interlocks.h"

namespace drill_rig_sim
{
namespace
{
bool raises(const Setpoints& set) noexcept
{
  return !set.winch.brake && set.winch.block_velocity > 0.0;
}

bool pumps(const Setpoints& set) noexcept
{
  return set.pump.flow > 0.0;
}
}  // namespace

void watch_interlocks(const RigSpec& rig, const RigSignals& readings, const Setpoints& asked, const Setpoints& passed,
                      InterlockState& interlocks) noexcept
{
  const double most = rig.hoisting.trip_hook_load, pressure = rig.mud_pump.trip_pressure;
  // set points that are still on their way would raise the block, or pump, after the trip is released
  const bool raised = raises(asked) || raises(passed), pumped = pumps(asked) || pumps(passed);
  interlocks.over_pull = raised && (interlocks.over_pull || (most > 0.0 && readings.hook_load >= most));
  interlocks.over_pressure = pumped && (interlocks.over_pressure || (pressure > 0.0 && readings.stand_pipe_pressure >= pressure));
}

Setpoints restrained(Setpoints asked, const InterlockState& interlocks, const FaultState& faults) noexcept
{
  if (interlocks.over_pull) asked.winch = WinchSetpoint();
  if (interlocks.over_pressure || faults.pump_tripped) asked.pump = PumpSetpoint();
  if (faults.drive_tripped)
  {
    const bool brake = asked.top_drive.brake;
    asked.top_drive = TopDriveSetpoint();
    asked.top_drive.mode = TopDriveMode::torque;
    asked.top_drive.brake = brake;
  }
  return asked;
}

}  // namespace drill_rig_sim
