// SPDX-License-Identifier: BSD-3-Clause
#ifndef DRILL_RIG_SIM_SRC_TOOLS_DRILL_DOUBTS_H
#define DRILL_RIG_SIM_SRC_TOOLS_DRILL_DOUBTS_H

#include <vector>

#include "drill_rig_sim/sim/accuracy.h"

namespace drill_rig_sim
{
/// Why a run's numbers may be wrong: of each kind of warning its first time, its last time, and its largest value.
class Doubts
{
public:
  struct Entry
  {
    double since, until;    ///< simulated time [s]
    AccuracyReport report;  ///< the largest
  };

  /// `time`: simulated [s].
  void add(double time, const AccuracyReport& now)
  {
    if (now.doubt == AccuracyDoubt::none) return;
    for (Entry& entry : entries_)
      if (entry.report.doubt == now.doubt)
      {
        entry.until = time;
        if (now.measure > entry.report.measure) entry.report = now;
        return;
      }
    entries_.push_back({time, time, now});
  }

  /// In the order in which they came.
  const std::vector<Entry>& entries() const noexcept { return entries_; }

private:
  std::vector<Entry> entries_;
};

}  // namespace drill_rig_sim

#endif
