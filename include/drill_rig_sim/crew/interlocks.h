// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_CREW_INTERLOCKS_H
#define DRILL_RIG_SIM_CREW_INTERLOCKS_H

#include "drill_rig_sim/instruments/signals.h"
#include "drill_rig_sim/model/fault_state.h"
#include "drill_rig_sim/scene/scene.h"

/// What a rig does of itself, whatever is commanded. Limits that hold while they are reached are the winch's own (rig/hoisting.h:
/// stops, largest and least hook load), the top drive's (torque, speed, power) and the pump's relief valve; here are those that
/// trip and stay.
namespace drill_rig_sim
{
/// Trips by what the rig's gauges show, as its controls have nothing else; a gauge that is wrong trips too late, or for nothing.
struct InterlockState
{
  bool over_pull = false;      ///< trip_hook_load was reached: the brake is set until a command that does not raise
  bool over_pressure = false;  ///< trip_pressure was: the pump stands until it is commanded to

  template <class V>
  void visit(V& v)
  {
    v("over_pull", over_pull);
    v("over_pressure", over_pressure);
  }
};

/// Before a frame: what trips by the last readings, and what is released: where neither the set points `asked` for nor those that
/// have `passed` the dead times raise the block, or pump.
void watch_interlocks(const RigSpec& rig, const RigSignals& readings, const Setpoints& asked, const Setpoints& passed,
                      InterlockState& interlocks) noexcept;

/// What is left of the set points asked for by interlocks and faults: a tripped drive coasts, brake apart; a tripped pump stops.
Setpoints restrained(Setpoints asked, const InterlockState& interlocks, const FaultState& faults) noexcept;

}  // namespace drill_rig_sim

#endif
