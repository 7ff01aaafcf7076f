// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_TOOLS_DRILL_LIMITS_H
#define DRILL_RIG_SIM_SRC_TOOLS_DRILL_LIMITS_H

#include <vector>

#include "drill_rig_sim/instruments/signals.h"
#include "drill_rig_sim/sim/string_watch.h"
#include "drill_times.h"

namespace drill_rig_sim
{
/// What went beyond its limits in a run, which goes on as if it had not: of each flag of the truth when it was up, and the
/// largest load.
class Limits
{
public:
  struct Entry
  {
    const char* flag;  ///< of RigState, or max_hook_load
    const char* what;
    Times times;
    LoadShare load;  ///< share 0: the flag has no load
  };

  /// With each frame. `max_hook_load`: of the rig [N].
  void add(const Truth& m, const StringLoads& loads, double max_hook_load)
  {
    add(m.over_stress, {"over_stress", "pipe beyond its yield strength", Times(m.time), loads.stress});
    add(m.over_torque, {"over_torque", "connection beyond its make-up torque", Times(m.time), loads.torque});
    add(m.buckled, {"buckled", "pipe beyond its buckling load", Times(m.time), loads.buckling});
    add(m.slack_line, {"slack_line", "the lines carry nothing", Times(m.time), LoadShare()});
    add(m.stop_reached, {"stop_reached", "the block is at its lowest or highest place", Times(m.time), LoadShare()});
    if (!m.top_drive_limited) top_drive_free_ = m.time;
    add(m.time - top_drive_free_ > 1.0,
        {"top_drive_limited", "the top drive is at its limit of torque, speed or power", Times(m.time), LoadShare()});
    add(m.relief_valve_open, {"relief_valve_open", "part of the pump's flow goes back to the tanks", Times(m.time), LoadShare()});
    add(m.hook_load >= max_hook_load,
        {"max_hook_load", "the winch does not raise beyond rig.hoisting.max_hook_load", Times(m.time), LoadShare()});
    add(m.motor_stalled, {"motor_stalled", "the mud motor is at its stall torque", Times(m.time), LoadShare()});
    time_ = m.time;
  }

  /// In the order in which they came.
  const std::vector<Entry>& entries() const noexcept { return entries_; }

private:
  void add(bool up, const Entry& now)
  {
    if (!up) return;
    for (Entry& entry : entries_)
      if (entry.flag == now.flag)
      {
        entry.times.add(now.times.until, time_);
        if (now.load.share > entry.load.share) entry.load = now.load;
        return;
      }
    entries_.push_back(now);
  }

  double top_drive_free_ =
      0.0;  // when it was last within its limits: on its way to a set point it may be at them for a moment [s]
  std::vector<Entry> entries_;
  double time_ = 0.0;  // of the frame before [s]
};

}  // namespace drill_rig_sim

#endif
