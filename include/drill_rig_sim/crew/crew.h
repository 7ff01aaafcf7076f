// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_CREW_CREW_H
#define DRILL_RIG_SIM_CREW_CREW_H

#include "drill_rig_sim/crew/pressure_trend.h"
#include "drill_rig_sim/instruments/signals.h"
#include "drill_rig_sim/rig/hoisting.h"

namespace drill_rig_sim
{
/// The crew that makes connections by itself: with `connections: auto`, or while it is called (Simulator::call_crew()).
///
/// Going down, it begins where the block is at its lowest, or where the uppermost joint's end comes to the rotary table if that
/// is higher: it stops the block, lifts the bit by stick_up off bottom (and by lift_over_waves() where the rig heaves), brings
/// drive and pump to rest, sets the slips, slacks off, adds a stand, picks up, pulls the slips, takes drive and pump back to what
/// is asked of them, and lowers to a little above where the bit was. If the rig was tared, it waits for a steady stand-pipe
/// pressure before that, and tares on the last half metre: slower there, because pipe that rotates has more drag along the hole
/// the faster it goes. Going up, it begins where a stand is above the slips' joint at stick_up, or the block at its highest; it
/// stops, and takes the stand away without lifting and lowering. Meanwhile its own set points are in force; the last that were
/// asked act again afterwards. A connection that is refused for a minute fails the next frame, with the reason. What its machine
/// remembers:
struct CrewState
{
  CrewTask doing = CrewTask::none;
  bool adds = false;           ///< else it takes away
  double stopped_at = 0.0;     ///< height of the block, and what the pipe added since then makes of it [m]
  double broken_out_at = 0.0;  ///< [m]
  double waited = 0.0;         ///< in this task [s]
  PressureTrend pressure;      ///< of the stand pipe
  bool called = false;         ///< whatever `connections` says

  template <class V>
  void visit(V& v)
  {
    v("doing", doing);
    v("adds", adds);
    v("stopped_at", stopped_at);
    v("broken_out_at", broken_out_at);
    v("waited", waited);
    v("pressure", pressure);
    v("called", called);
  }
};

/// Height of the block at which the crew begins to add a stand: no lower than lowest_block_height, nor so high that the stand has
/// no room.
/// @param stump  length of what is above the uppermost joint's end [m]
double height_to_add(const HoistingSpec& spec, double stump, double stand) noexcept;

}  // namespace drill_rig_sim

#endif
