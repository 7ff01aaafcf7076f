#ifndef DRILL_RIG_SIM_SRC_TOOLS_DRILL_LIMITS_H
#define DRILL_RIG_SIM_SRC_TOOLS_DRILL_LIMITS_H

#include <vector>

#include "drill_rig_sim/sim/signals.h"
#include "drill_rig_sim/sim/string_watch.h"

namespace drill_rig_sim
{
/// What went beyond its limits in a run, which goes on as if it had not: of each flag of the truth when it was first and last up, and the
/// largest load.
class Limits
{
public:
  struct Entry
  {
    const char* flag;     ///< of RigState
    const char* what;
    double since, until;  ///< simulated time [s]
    LoadShare load;       ///< share 0: the flag has no load
  };

  void add(const Truth& m, const StringLoads& loads)
  {
    add(m.over_stress, {"over_stress", "pipe beyond its yield strength", m.time, m.time, loads.stress});
    add(m.over_torque, {"over_torque", "connection beyond its make-up torque", m.time, m.time, loads.torque});
    add(m.buckled, {"buckled", "pipe beyond its buckling load", m.time, m.time, loads.buckling});
    add(m.slack_line, {"slack_line", "the lines carry nothing", m.time, m.time, LoadShare()});
    add(m.motor_stalled, {"motor_stalled", "the mud motor is at its stall torque", m.time, m.time, LoadShare()});
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
        entry.until = now.until;
        if (now.load.share > entry.load.share) entry.load = now.load;
        return;
      }
    entries_.push_back(now);
  }

  std::vector<Entry> entries_;
};

}  // namespace drill_rig_sim

#endif
