// SPDX-License-Identifier: BSD-3-Clause
#include "drill_rig_sim/crew/interlocks.h"

namespace drill_rig_sim
{
void watch_interlocks(const RigSpec& rig, const RigSignals& readings, const Setpoints& asked, InterlockState& interlocks) noexcept
{
  const double most = rig.hoisting.trip_hook_load, pressure = rig.mud_pump.trip_pressure;
  const bool raises = !asked.winch.brake && asked.winch.block_velocity > 0.0, pumps = asked.pump.flow > 0.0;
  interlocks.over_pull = raises && (interlocks.over_pull || (most > 0.0 && readings.hook_load >= most));
  interlocks.over_pressure = pumps && (interlocks.over_pressure || (pressure > 0.0 && readings.stand_pipe_pressure >= pressure));
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
